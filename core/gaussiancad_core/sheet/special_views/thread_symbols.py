"""Thread symbols among strokes (ISO 6410-1), in all views.

Along its axis a thread is a whole circle and three quarters of another one about it; from the side
the second one shows as two more lines, and one across them at the thread's depth.  These are no
edges: what is left is the plain cylinder.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.annotations.erase import Told
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.thread_ends import ThreadSide, without_ends
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.votes import MOST, NEARLY_ALL

_DRAWN = (0.6, 0.9)
"""Share of the thin circle that is drawn: about three quarters."""

_BROKEN = 0.08
"""Share of it that gaps besides the one large take at most: it is no dashed circle."""

_RATIO = (0.7, 0.95)
"""The smaller radius in larger ones: minor diameters are 0.8 to 0.9 of major ones."""

_SHORTEST_PX = 3.0
"""px of a line that shows a thread from the side at least."""


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
    drawn: Sequence[ReadView], arcs: Sequence[Arc]
) -> tuple[tuple[ReadView, ...], tuple[SpecialView, ...]]:
    """Views without the lines of thread symbols, and the symbols.

    Args:
        drawn: the views.
        arcs: arcs in other pens than the part's, or of which nobody knows.
    """
    found = [symbol for view in drawn for symbol in _symbols(view, arcs)]
    views = tuple(_without(view, found, drawn) for view in drawn)
    return views, tuple(symbol.special for symbol in found)


def _without(
    view: ReadView, symbols: Sequence[ThreadSymbol], drawn: Sequence[ReadView]
) -> ReadView:
    """A view without the lines of thread symbols."""
    left, sides = list(view.strokes), []
    for symbol in symbols:
        lines = [stroke for stroke in view.strokes if _is_of(stroke, symbol, view, drawn)]
        left = [stroke for stroke in left if stroke not in lines]
        for upright, thins, rims in _sides(symbol, view, drawn):
            thin_lines = tuple(
                line
                for line in lines
                if isinstance(line, Segment) and any(_runs_at(line, upright, at) for at in thins)
            )
            sides.append(ThreadSide(upright, thins, rims, thin_lines))
    return replace(view, strokes=without_ends(left, sides))


def arcs_of(stated: Told) -> list[Arc]:
    """The circles of a picture that are no edges and of which one piece is missing, px of the
    upright sheet.

    Args:
        stated: the sheet's lines and circles, and what each is.
    """
    found = []
    for shape, kinds in zip(stated.shapes, stated.kinds, strict=True):
        runs = [run.run for run in shape.runs]
        if not isinstance(shape.geometry, Circle) or not runs or None in kinds:
            continue
        around = shape.geometry.around
        gaps = [after.start - before.end for before, after in pairwise(runs)]
        gaps.append(runs[0].start + around - runs[-1].end)
        missing = int(np.argmax(gaps))
        if sum(gaps) - gaps[missing] <= _BROKEN * around:
            start = runs[(missing + 1) % len(runs)].start
            (x, y), radius = shape.geometry.centre, shape.geometry.radius
            sweep = (around - gaps[missing]) / radius
            found.append(Arc((x + 0.5, y + 0.5), radius, start / radius, sweep, Linetype.VISIBLE))
    return found


def _symbols(view: ReadView, arcs: Sequence[Arc]) -> Iterator[ThreadSymbol]:
    strokes = [stroke for stroke in view.strokes if isinstance(stroke, Arc)]
    rims = [arc for arc in strokes if _share(arc) >= NEARLY_ALL]
    seen: list[Arc] = []
    for arc in (*arcs, *strokes):
        if not _DRAWN[0] < _share(arc) < _DRAWN[1] or any(_same(arc, other) for other in seen):
            continue
        if sum(_same(arc, other) for other in strokes) > 1:
            continue  # A circle in pieces.
        if _goes_on(arc, view.strokes):
            continue
        rim = next((rim for rim in rims if _about(arc, rim)), None)
        if rim is not None:
            seen.append(arc)
            yield ThreadSymbol(view.role, arc, rim)


def _goes_on(arc: Arc, strokes: Sequence[Stroke]) -> bool:
    """Whether both ends of an arc are at other strokes: then it is an edge around a rim."""
    ends = arc.sample(np.inf)[[0, -1]]
    others = [s for s in strokes if not (isinstance(s, Arc) and _same(arc, s))]
    away = [stroke.distances(ends) for stroke in others]
    return bool(away) and bool((np.min(away, axis=0) <= ONE_PLACE).all())


def _share(arc: Arc) -> float:
    return arc.sweep / (2.0 * np.pi)


def _same(arc: Arc, other: Arc) -> bool:
    near = np.hypot(*np.subtract(arc.centre, other.centre)) <= ONE_PLACE
    return bool(near) and abs(arc.radius - other.radius) <= ONE_PLACE


def _about(arc: Arc, rim: Arc) -> bool:
    small, large = sorted((arc.radius, rim.radius))
    near = np.hypot(*np.subtract(arc.centre, rim.centre)) <= ONE_PLACE
    return bool(near) and _RATIO[0] < small / large < _RATIO[1]


def _is_of(stroke: Stroke, symbol: ThreadSymbol, view: ReadView, drawn: Sequence[ReadView]) -> bool:
    """Whether a stroke of a view is one of a thread's that are no edges."""
    if isinstance(stroke, Arc):
        if view.role is symbol.role:
            return _same(stroke, symbol.thin)
        return any(_same(stroke, arc) for arc in _seen_along(symbol, view, drawn))
    if not isinstance(stroke, Segment) or view.role is symbol.role:
        return False
    return any(
        _runs_at(stroke, upright, thin) and _has_rim_line(stroke, upright, rim, view.strokes)
        for upright, thins, rims in _sides(symbol, view, drawn)
        for thin, rim in zip(thins, rims, strict=True)
    )


def _has_rim_line(stroke: Segment, upright: bool, at: float, strokes: Sequence[Stroke]) -> bool:
    """Whether the rim's line runs along most of a line."""
    along = 1 if upright else 0
    low, high = sorted((stroke.start[along], stroke.end[along]))
    covered = 0.0
    for segment in strokes:
        if isinstance(segment, Segment) and _runs_at(segment, upright, at):
            first, last = sorted((segment.start[along], segment.end[along]))
            covered += max(0.0, min(last, high) - max(first, low))
    return covered >= MOST * (high - low)


def _sides(
    symbol: ThreadSymbol, view: ReadView, drawn: Sequence[ReadView]
) -> Iterator[tuple[bool, tuple[float, float], tuple[float, float]]]:
    """Whether lines along the axis run upright in a view, and where those of the thin circle and
    those of the rim are, in the same order."""
    source = _box(symbol.role, drawn)
    for axis in _shared_axes_of(symbol.role, view.role):
        upright = view.role.frame.right_axis[0] is axis
        places = [
            _across_of(view.role, view.box, axis, place)
            for circle in (symbol.thin, symbol.rim)
            for place in _places_of(symbol.role, source, axis, circle)
        ]
        yield upright, (places[0], places[1]), (places[2], places[3])


def _seen_along(symbol: ThreadSymbol, view: ReadView, drawn: Sequence[ReadView]) -> Iterator[Arc]:
    """The thin circle where a view along the same axis, from the other side, has it."""
    frame, view_frame = view.role.frame, symbol.role.frame
    if frame.look_axis[0] is not view_frame.look_axis[0]:
        return
    source = _box(symbol.role, drawn)
    middle: dict[Axis, float] = {}
    for axis in (view_frame.right_axis[0], view_frame.up_axis[0]):
        low, high = _places_of(symbol.role, source, axis, symbol.thin)
        middle[axis] = (low + high) / 2.0
    x = _across_of(view.role, view.box, frame.right_axis[0], middle[frame.right_axis[0]])
    y = _across_of(view.role, view.box, frame.up_axis[0], middle[frame.up_axis[0]])
    yield replace(symbol.thin, centre=(x, y))


def _box(role: Role, drawn: Sequence[ReadView]) -> tuple[float, float, float, float]:
    return next(view.box for view in drawn if view.role is role)


def _runs_at(stroke: Segment, upright: bool, at: float) -> bool:
    along, across = (1, 0) if upright else (0, 1)
    ends = stroke.start, stroke.end
    offset = max(abs(end[across] - at) for end in ends)
    return offset <= ONE_PLACE and abs(ends[0][along] - ends[1][along]) >= _SHORTEST_PX


def _shared_axes_of(one: Role, other: Role) -> list[Axis]:
    """Axes that two views with different directions both show."""
    if one.frame.look_axis[0] is other.frame.look_axis[0]:
        return []
    axes = [(role.frame.right_axis[0], role.frame.up_axis[0]) for role in (one, other)]
    return [axis for axis in axes[0] if axis in axes[1]]


def _places_of(role: Role, box: Box, axis: Axis, circle: Circle | Arc) -> tuple[float, float]:
    """px along an axis of the part, from its lower end, of both sides of a circle."""
    frame = role.frame
    if frame.right_axis[0] is axis:
        middle = circle.centre[0] - box[0]
        middle = middle if frame.right_axis[1] > 0 else box[2] - box[0] - middle
    else:
        middle = box[3] - circle.centre[1]
        middle = middle if frame.up_axis[1] > 0 else box[3] - box[1] - middle
    return middle - circle.radius, middle + circle.radius


def _across_of(role: Role, box: Box, axis: Axis, place: float) -> float:
    """The sheet's coordinate of a place along an axis of the part."""
    frame = role.frame
    if frame.right_axis[0] is axis:
        return box[0] + place if frame.right_axis[1] > 0 else box[2] - place
    return box[3] - place if frame.up_axis[1] > 0 else box[1] + place
