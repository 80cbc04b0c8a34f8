"""Centre lines of circles, axes of holes and shafts, and centre marks (ISO 128)."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Rhythm
from gaussiancad_core.drawing.annotation_pen import Direction, Pen
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.geometry.intervals import Interval
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Arc, Linetype, Segment

SAME_PX = 0.6
"""px within which lines of two views are the same feature's."""

_ON = 1.5
"""px within which a centre line would hide in a line of the part: it is left out there."""

_HALF = 0.96 * np.pi
"""Arcs from here on have centre lines, as the ends of slots do; fillets have none."""


@dataclass(frozen=True)
class Round:
    """A circle, or an arc of half a circle at least.

    Attributes:
        centre: (2,) sheet px.
        radius: px.
        whole: it is seen as a full circle.
        visible: some of it is.
    """

    centre: tuple[float, float]
    radius: float
    whole: bool
    visible: bool


def draw_centre_lines(views: tuple[DrawnView, ...], pen: Pen, group: int) -> list[Annotation]:
    """Centre lines and marks of views whose sheet axes are the part's, in sheet px.

    Args:
        views: not turned.
        pen: of the lines.
        group: number of the first note; each centre line counts one up.
    """
    found: list[tuple[AnnotationKind, tuple[Segment, ...]]] = []
    for view in views:
        for circle in outermost(rounds(view)):
            found.append(_cross(view, circle, pen))
        for direction, at, span in _axes(view, views):
            reach = span[0] - pen.overshoot, span[1] + pen.overshoot
            pieces = tuple(
                direction.segment((low, at), (high, at))
                for low, high in _uncovered(view, direction, at, reach)
                if high - low > 2.0 * pen.height
            )
            found.append((AnnotationKind.CENTRE_LINE, pieces))
    rhythms = {
        AnnotationKind.CENTRE_LINE: Rhythm.LONG_SHORT,
        AnnotationKind.CENTRE_MARK: Rhythm.CONTINUOUS,
    }
    drawn = [(kind, strokes) for kind, strokes in found if strokes]
    return [
        Annotation(kind, group + index, strokes, pen.width, rhythms[kind])
        for index, (kind, strokes) in enumerate(drawn)
    ]


def rounds(view: DrawnView) -> list[Round]:
    """The circles of a view, visible or hidden; arcs of one circle count together."""
    arcs: dict[tuple[float, ...], list[Arc]] = {}
    for stroke in view.strokes:
        if isinstance(stroke, Arc):
            key = tuple(round(value, 2) for value in (*stroke.centre, stroke.radius))
            arcs.setdefault(key, []).append(stroke)
    found = []
    for same in arcs.values():
        sweep = sum(arc.sweep for arc in same)
        if sweep >= _HALF:
            whole = sweep > 0.99 * 2.0 * np.pi
            visible = any(arc.linetype is Linetype.VISIBLE for arc in same)
            found.append(Round(same[0].centre, same[0].radius, whole, visible))
    return found


def outermost(circles: Iterable[Round]) -> list[Round]:
    """The largest of each set of concentric circles."""
    largest: dict[tuple[float, float], Round] = {}
    for circle in circles:
        key = (round(circle.centre[0], 1), round(circle.centre[1], 1))
        if key not in largest or circle.radius > largest[key].radius:
            largest[key] = circle
    return list(largest.values())


def _cross(view: DrawnView, circle: Round, pen: Pen) -> tuple[AnnotationKind, tuple[Segment, ...]]:
    """Two crossing lines; small circles have continuous ones."""
    reach = circle.radius + pen.overshoot
    small = circle.radius < 0.75 * pen.height
    strokes = []
    for direction in Direction:
        along, across = circle.centre[direction.value], circle.centre[direction.other.value]
        for low, high in _uncovered(view, direction, across, (along - reach, along + reach)):
            if high - low > 0.5 * pen.height:
                strokes.append(direction.segment((low, across), (high, across)))
    kind = AnnotationKind.CENTRE_MARK if small else AnnotationKind.CENTRE_LINE
    return kind, tuple(strokes)


def model_axis(view: DrawnView, direction: Direction) -> tuple[Axis, int]:
    """The model's axis along a direction of the sheet, and its sign from left or bottom up."""
    frame = view.role.frame
    return frame.right_axis if direction is Direction.HORIZONTAL else frame.up_axis


def to_model(view: DrawnView, direction: Direction, at: float) -> float:
    """px from the part's least coordinate along the model's axis."""
    low, high = direction.span(view.box)
    sign = model_axis(view, direction)[1] * (1 if direction is Direction.HORIZONTAL else -1)
    return at - low if sign > 0 else high - at


def from_model(view: DrawnView, direction: Direction, distance: float) -> float:
    """The sheet coordinate of :func:`to_model`'s distance."""
    low, high = direction.span(view.box)
    sign = model_axis(view, direction)[1] * (1 if direction is Direction.HORIZONTAL else -1)
    return low + distance if sign > 0 else high - distance


def _axes(
    view: DrawnView, views: tuple[DrawnView, ...]
) -> Iterator[tuple[Direction, float, Interval]]:
    """Axes, in one view, of what other views show as circles: direction, place and span."""
    found: dict[tuple[Direction, float], tuple[float, Interval]] = {}
    for other in views:
        look = other.role.frame.look_axis[0]
        for direction in Direction:
            if model_axis(view, direction)[0] is not look:
                continue
            across = model_axis(view, direction.other)[0]
            seen = next(d for d in Direction if model_axis(other, d)[0] is across)
            for circle in rounds(other):
                distance = to_model(other, seen, circle.centre[seen.value])
                at = from_model(view, direction.other, distance)
                span = flanks(view, direction, at, circle.radius)
                if span is None or not circle.whole:
                    continue
                key = direction, round(at, 1)
                at, (low, high) = found.get(key, (at, span))
                found[key] = at, (min(low, span[0]), max(high, span[1]))
    for (direction, _), (at, span) in found.items():
        yield direction, at, span


def flanks(view: DrawnView, direction: Direction, at: float, radius: float) -> Interval | None:
    """Where lines along a direction run at a radius on both sides of an axis."""
    spans = []
    for side in (at - radius, at + radius):
        ends = [
            end
            for stroke in view.strokes
            if isinstance(stroke, Segment) and runs_at(stroke, direction, side, SAME_PX)
            for end in (stroke.start[direction.value], stroke.end[direction.value])
        ]
        if not ends:
            return None
        spans.append((min(ends), max(ends)))
    return min(low for low, _ in spans), max(high for _, high in spans)


def runs_at(stroke: Segment, direction: Direction, at: float, tolerance: float) -> bool:
    """Whether a stroke runs along a direction at a coordinate across it."""
    across = direction.other.value
    return abs(stroke.start[across] - at) < tolerance and abs(stroke.end[across] - at) < tolerance


def _uncovered(view: DrawnView, direction: Direction, at: float, span: Interval) -> list[Interval]:
    """The parts of a centre line that no line of the part runs along (ISO 128: those win)."""
    covers = sorted(
        tuple(sorted((stroke.start[direction.value], stroke.end[direction.value])))
        for stroke in view.strokes
        if isinstance(stroke, Segment) and runs_at(stroke, direction, at, _ON)
    )
    pieces = []
    start = span[0]
    for low, high in covers:
        if low > start:
            pieces.append((start, min(low, span[1])))
        start = max(start, high)
    if start < span[1]:
        pieces.append((start, span[1]))
    return [(low, high) for low, high in pieces if high > low]
