"""Lines across a thread at its depth, in views from the side (ISO 6410-1): they are no edges.

Such a line ends at the thread's major diameter, where its thin lines end and the sides of what is
threaded run on.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from gaussiancad_core.model.views import Segment, Stroke
from gaussiancad_core.sheet.picture_noise import ONE_PLACE


@dataclass(frozen=True)
class ThreadSide:
    """A thread as a view from the side shows it.

    Attributes:
        upright: whether its axis is.
        thins, rims: px, where its thin lines lie, and the sides of what is threaded.
        lines: its thin lines.
    """

    upright: bool
    thins: tuple[float, float]
    rims: tuple[float, float]
    lines: tuple[Segment, ...]


def without_ends(strokes: Sequence[Stroke], sides: Sequence[ThreadSide]) -> tuple[Stroke, ...]:
    """The strokes of a view without the lines at the depths of threads.

    Where a bore ends with its thread, its floor stays.

    Args:
        strokes: without the threads' thin lines.
        sides: threads in the view.
    """
    left = list(strokes)
    for side in sides:
        for at in _ends(side):
            goes_on = all(_passes(left, side, rim, at) for rim in side.rims)
            left = [
                kept for stroke in left if (kept := _kept(stroke, side, at, goes_on)) is not None
            ]
    return tuple(left)


def _ends(side: ThreadSide) -> Iterator[float]:
    """Places along a thread at which its thin lines end, each once."""
    spans = [_span(line, along_upright=side.upright) for line in side.lines]
    seen: list[float] = []
    for low, high in spans:
        for at, inward in ((low, 1.0), (high, -1.0)):
            beyond = at - 2.0 * inward * ONE_PLACE
            if any(first <= beyond <= last for first, last in spans):
                continue
            if all(abs(at - other) > ONE_PLACE for other in seen):
                seen.append(at)
                yield at


def _kept(stroke: Stroke, side: ThreadSide, at: float, goes_on: bool) -> Stroke | None:
    """What is left of a stroke, as it lies at a thread's end or not."""
    if not isinstance(stroke, Segment) or not _lies_at(stroke, not side.upright, at):
        return stroke
    low, high = _span(stroke, along_upright=not side.upright)
    outer = min(*side.thins, *side.rims), max(*side.thins, *side.rims)
    if low < outer[0] - ONE_PLACE or high > outer[1] + ONE_PLACE:
        return stroke
    first, last = max(low, min(side.rims)), min(high, max(side.rims))
    if goes_on or last - first <= ONE_PLACE:
        return None
    if side.upright:
        return replace(stroke, start=(first, at), end=(last, at))
    return replace(stroke, start=(at, first), end=(at, last))


def _passes(strokes: Sequence[Stroke], side: ThreadSide, rim: float, at: float) -> bool:
    """Whether a side of what is threaded runs on at both sides of a place."""
    spans = [
        _span(stroke, along_upright=side.upright)
        for stroke in strokes
        if isinstance(stroke, Segment) and _lies_at(stroke, side.upright, rim)
    ]
    return all(
        any(low <= place <= high for low, high in spans)
        for place in (at - 3.0 * ONE_PLACE, at + 3.0 * ONE_PLACE)
    )


def _lies_at(line: Segment, upright: bool, at: float) -> bool:
    across = 0 if upright else 1
    return max(abs(end[across] - at) for end in (line.start, line.end)) <= ONE_PLACE


def _span(line: Segment, *, along_upright: bool) -> tuple[float, float]:
    along = 1 if along_upright else 0
    low, high = sorted((line.start[along], line.end[along]))
    return low, high
