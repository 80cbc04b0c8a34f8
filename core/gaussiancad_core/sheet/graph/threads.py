"""Thread symbols among the strokes of a file (ISO 6410-1), in all views.

Along its axis a thread is a whole circle and three quarters of another one about it; from the side
the second one shows as two more lines.  These are no edges: what is left is the plain cylinder.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.sheet.reading import ReadView
from gaussiancad_core.sheet.special_views.kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.special_views.threads import (
    DRAWN,
    RATIO,
    across_of,
    places_of,
    shared_axes_of,
)
from gaussiancad_core.views import Arc, Segment, Stroke

_CONCENTRIC_PX = 1.5
"""px between the centres of a thread's circles, and between its lines and where they belong."""

_WHOLE = 0.98
"""Share of a circle from which it is drawn whole."""

_SHORTEST_PX = 3.0
"""px of a line that shows a thread from the side at least."""

_ALONG = 0.7
"""Share of such a line beside which the rim runs at least: at the end of a blind hole the
drill went farther."""


@dataclass(frozen=True)
class ThreadSymbol:
    """A thread seen along its axis.

    Attributes:
        role: of the view.
        thin: the circle that is drawn in part, px of the upright sheet.
        rim: the whole one.
    """

    role: Role
    thin: Arc
    rim: Arc

    @property
    def special(self) -> SpecialView:
        """How it is told."""
        (x, y), r = self.thin.centre, self.thin.radius
        return SpecialView(SpecialKind.THREAD, (x - r, y - r, x + r, y + r))


def without_threads(
    drawn: Sequence[ReadView], beside: Sequence[Arc]
) -> tuple[tuple[ReadView, ...], tuple[SpecialView, ...]]:
    """Views without the lines of thread symbols, and the symbols.

    Args:
        drawn: the views.
        beside: arcs in other pens than the part's.
    """
    found = [symbol for view in drawn for symbol in _symbols(view, beside)]
    views = tuple(
        replace(
            view,
            strokes=tuple(
                stroke
                for stroke in view.strokes
                if not any(_is_of(stroke, symbol, view, drawn) for symbol in found)
            ),
        )
        for view in drawn
    )
    return views, tuple(symbol.special for symbol in found)


def _symbols(view: ReadView, beside: Sequence[Arc]) -> Iterator[ThreadSymbol]:
    own = [stroke for stroke in view.strokes if isinstance(stroke, Arc)]
    rims = [arc for arc in own if _share(arc) >= _WHOLE]
    seen: list[Arc] = []
    for arc in (*beside, *own):
        if not DRAWN[0] < _share(arc) < DRAWN[1] or any(_same(arc, other) for other in seen):
            continue
        rim = next((rim for rim in rims if _about(arc, rim)), None)
        if rim is not None:
            seen.append(arc)
            yield ThreadSymbol(view.role, arc, rim)


def _share(arc: Arc) -> float:
    return arc.sweep / (2.0 * np.pi)


def _same(arc: Arc, other: Arc) -> bool:
    near = np.hypot(*np.subtract(arc.centre, other.centre)) <= _CONCENTRIC_PX
    return bool(near) and abs(arc.radius - other.radius) <= _CONCENTRIC_PX


def _about(arc: Arc, rim: Arc) -> bool:
    small, large = sorted((arc.radius, rim.radius))
    near = np.hypot(*np.subtract(arc.centre, rim.centre)) <= _CONCENTRIC_PX
    return bool(near) and RATIO[0] < small / large < RATIO[1]


def _is_of(stroke: Stroke, symbol: ThreadSymbol, view: ReadView, drawn: Sequence[ReadView]) -> bool:
    """Whether a stroke of a view is one of a thread's that are no edges."""
    if isinstance(stroke, Arc):
        if view.role is symbol.role:
            return _same(stroke, symbol.thin)
        return any(_same(stroke, own) for own in _seen_along(symbol, view, drawn))
    if not isinstance(stroke, Segment) or view.role is symbol.role:
        return False
    return any(
        _runs_at(stroke, upright, thin) and _is_beside(stroke, upright, rim, view.strokes)
        for upright, thins, rims in _sides(symbol, view, drawn)
        for thin, rim in zip(thins, rims, strict=True)
    )


def _is_beside(stroke: Segment, upright: bool, at: float, strokes: Sequence[Stroke]) -> bool:
    """Whether the rim's line runs along most of a line."""
    along = 1 if upright else 0
    low, high = sorted((stroke.start[along], stroke.end[along]))
    covered = 0.0
    for own in strokes:
        if isinstance(own, Segment) and _runs_at(own, upright, at):
            first, last = sorted((own.start[along], own.end[along]))
            covered += max(0.0, min(last, high) - max(first, low))
    return covered >= _ALONG * (high - low)


def _sides(
    symbol: ThreadSymbol, view: ReadView, drawn: Sequence[ReadView]
) -> Iterator[tuple[bool, tuple[float, ...], tuple[float, ...]]]:
    """Whether lines along the axis run upright in a view, and where those of the thin circle and
    those of the rim are, in the same order."""
    source = _box(symbol.role, drawn)
    for axis in shared_axes_of(symbol.role, view.role):
        upright = view.role.frame.right_axis[0] is axis
        thins, rims = (
            tuple(
                across_of(view.role, view.box, axis, place)
                for place in places_of(symbol.role, source, axis, circle)
            )
            for circle in (symbol.thin, symbol.rim)
        )
        yield upright, thins, rims


def _seen_along(symbol: ThreadSymbol, view: ReadView, drawn: Sequence[ReadView]) -> Iterator[Arc]:
    """The thin circle where a view along the same axis, from the other side, has it."""
    frame, own = view.role.frame, symbol.role.frame
    if frame.look_axis[0] is not own.look_axis[0]:
        return
    source = _box(symbol.role, drawn)
    middle: dict[Axis, float] = {}
    for axis in (own.right_axis[0], own.up_axis[0]):
        low, high = places_of(symbol.role, source, axis, symbol.thin)
        middle[axis] = (low + high) / 2.0
    x = across_of(view.role, view.box, frame.right_axis[0], middle[frame.right_axis[0]])
    y = across_of(view.role, view.box, frame.up_axis[0], middle[frame.up_axis[0]])
    yield replace(symbol.thin, centre=(x, y))


def _box(role: Role, drawn: Sequence[ReadView]) -> tuple[float, float, float, float]:
    return next(view.box for view in drawn if view.role is role)


def _runs_at(stroke: Segment, upright: bool, at: float) -> bool:
    along, across = (1, 0) if upright else (0, 1)
    ends = stroke.start, stroke.end
    beside = max(abs(end[across] - at) for end in ends)
    return beside <= _CONCENTRIC_PX and abs(ends[0][along] - ends[1][along]) >= _SHORTEST_PX
