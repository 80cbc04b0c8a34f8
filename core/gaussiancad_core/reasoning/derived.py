"""Values that follow from others.

Where a plane cuts a cylinder, the edge between them shows as a line in another view.  Its
coordinate is no plane of its own: it is where the plane's line meets the circle.  Read by itself it
differs from that by an error, and a sliver of space would lie between the two.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot

from gaussiancad_core.axes import Axis
from gaussiancad_core.reasoning.curves import CircleCurve, PlaneCurve, Point, axis_line, meetings
from gaussiancad_core.reasoning.planes import IN_PLANE
from gaussiancad_core.reasoning.snapping import Snapped


@dataclass(frozen=True)
class Vertices:
    """Where strokes end in a plane.

    Attributes:
        normal: of the plane.
        curves: its circles and slanted lines.
        points: ends of strokes.
    """

    normal: Axis
    curves: tuple[PlaneCurve, ...]
    points: tuple[Point, ...]


def with_derived_values(snap: Snapped, planes: Sequence[Vertices], tolerance: float) -> Snapped:
    """The values, those replaced that follow from a curve and a weightier value.

    Args:
        snap: values and circles.
        planes: where strokes end.
        tolerance: units by which a value may miss what it follows from.
    """
    values = {axis: dict(zip(own, own, strict=True)) for axis, own in snap.values.items()}
    for axis, own in snap.values.items():
        for value in own:
            found = _derived(snap, planes, axis, value, tolerance)
            if found is not None:
                values[axis][value] = found
    moved = {axis: tuple(sorted(set(own.values()))) for axis, own in values.items()}
    weights = {
        (axis, values[axis][value]): weight for (axis, value), weight in snap.weights.items()
    }
    return replace(snap, values=moved, weights=weights)


def _derived(
    snap: Snapped, planes: Sequence[Vertices], axis: Axis, value: float, tolerance: float
) -> float | None:
    """What a value follows from, nearest first; None if it stands by itself."""
    best: tuple[float, float] | None = None
    for plane in planes:
        axes = IN_PLANE[plane.normal]
        if axis.value not in axes or not plane.curves:
            continue
        place = axes.index(axis.value)
        near = [p for p in plane.points if abs(p[place] - value) <= 3.0 * tolerance]
        for point in near:
            lines = _weightier(snap, plane.normal, (axis, value), point, tolerance)
            for meeting in _meetings_at(plane, lines, point, place, tolerance):
                off = abs(meeting - value)
                if off <= tolerance and (best is None or off < best[0]):
                    best = off, meeting
    return None if best is None or best[0] == 0.0 else best[1]


def _weightier(
    snap: Snapped, normal: Axis, own: tuple[Axis, float], point: Point, tolerance: float
) -> list[PlaneCurve]:
    """Lines near a point of a plane at values of its other axis that count more than one's own."""
    axes = IN_PLANE[normal]
    place = 1 - axes.index(own[0].value)
    axis = Axis(axes[place])
    return [
        axis_line(place, value)
        for value in snap.values[axis]
        if abs(value - point[place]) <= 3.0 * tolerance
        and snap.weights.get((axis, value), 0.0) > snap.weights.get(own, 0.0)
    ]


def _meetings_at(
    plane: Vertices, lines: list[PlaneCurve], point: Point, place: int, tolerance: float
) -> list[float]:
    """Coordinates of where a curve through a point meets other curves and lines."""
    through = [curve for curve in plane.curves if curve.distance(point) <= 3.0 * tolerance]
    found = []
    for number, curve in enumerate(through):
        for other in [*lines, *through[:number]]:
            for meeting in meetings(curve, other):
                away = hypot(meeting[0] - point[0], meeting[1] - point[1])
                if away <= 6.0 * tolerance and not _touches(curve, meeting, place):
                    found.append(meeting[place])
    return found


def _touches(curve: PlaneCurve, point: Point, place: int) -> bool:
    """Whether a circle runs along the coordinate there, so that the value is its extreme."""
    if not isinstance(curve, CircleCurve):
        return False
    return abs(curve.normal(curve.parameter(point))[1 - place]) < 0.02
