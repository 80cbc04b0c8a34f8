"""Dashes of centre lines beyond dots that other strokes swallowed.

Where a dot lies on an edge, only a gap is left, as wide as the dot with the gaps on both of its
sides.  The dash behind it is the centre line's, though it lies farther away than dashes of one line
do: it would stay as an edge that ends in the open.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun

_SHORT = 0.45
"""Length of dots as a share of the longest dash, at most."""

_OFF_PX, _OFF = 2.0, 0.15
"""px, and share of the room for a dot and its gaps, by which a gap may differ from it."""

_WHOLE, _CUT = (0.75, 1.25), 0.3
"""Length of dashes, in the usual ones of the line; of the last one, which may be cut, at least."""

_WIDER = 1.3
"""Width of a dash, in those of the others, at most."""


@dataclass(frozen=True)
class _Rhythm:
    """Of a centre line: px of its long dashes, of the room that a dot and its gaps take, and of
    the dashes' width, 0 where it is not known."""

    dash: float
    room: float
    width: float


def mark_beyond_swallowed_dots(
    runs: Sequence[InkedRun], kinds: list[AnnotationKind | None]
) -> None:
    """Tell such dashes, in place.

    Args:
        runs: of a line, in their order.
        kinds: what each is.
    """
    for way in (1, -1):
        places = range(len(runs)) if way > 0 else range(len(runs) - 1, -1, -1)
        for k in places:
            beyond = k + way
            if kinds[k] is not AnnotationKind.CENTRE_LINE or not 0 <= beyond < len(runs):
                continue
            if kinds[beyond] is not None:
                continue
            rhythm = _rhythm(runs, kinds, k, way)
            is_last = not 0 <= beyond + way < len(runs)
            if rhythm is not None and _is_next(runs[k], runs[beyond], rhythm, is_last=is_last):
                kinds[beyond] = AnnotationKind.CENTRE_LINE


def _rhythm(
    runs: Sequence[InkedRun], kinds: Sequence[AnnotationKind | None], k: int, way: int
) -> _Rhythm | None:
    """That of the centre line that ends with a long dash; None where no dot of it is left."""
    first = k
    while 0 <= first - way < len(runs) and kinds[first - way] is AnnotationKind.CENTRE_LINE:
        first -= way
    own = [runs[at] for at in range(min(first, k), max(first, k) + 1)]
    lengths = np.array([each.run.length for each in own])
    short = lengths < _SHORT * lengths.max()
    if not short.any() or runs[k].run.length < _SHORT * lengths.max():
        return None
    gaps = [after.run.start - before.run.end for before, after in pairwise(own)]
    widths = [each.width for each in own if each.width is not None]
    room = 2.0 * float(np.median(gaps)) + float(np.median(lengths[short]))
    width = float(np.median(widths)) if widths else 0.0
    return _Rhythm(float(np.median(lengths[~short])), room, width)


def _is_next(dash: InkedRun, other: InkedRun, rhythm: _Rhythm, *, is_last: bool) -> bool:
    """Whether a run is the dash behind a dot that is not seen."""
    apart = max(other.run.start - dash.run.end, dash.run.start - other.run.end)
    if abs(apart - rhythm.room) > max(_OFF_PX, _OFF * rhythm.room):
        return False
    if rhythm.width and other.width is not None and other.width > _WIDER * rhythm.width:
        return False
    least = _CUT if is_last else _WHOLE[0]
    return least * rhythm.dash <= other.run.length <= _WHOLE[1] * rhythm.dash
