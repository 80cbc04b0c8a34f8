"""Slanted lines that touch circles: what was read nearly tangent becomes exactly so."""

from collections.abc import Sequence
from math import acos, atan2, cos, hypot, sin

from gaussiancad_core.reasoning.curves import CircleCurve, LineCurve, Point, line_through

_NEAR_END = 6.0
"""Reaches within which a circle's touching point lies from the line's end, at least."""


def tangent_line(
    rough: LineCurve, ends: tuple[Point, Point], circles: Sequence[CircleCurve], reach: float
) -> LineCurve | None:
    """The line that touches the circles at one or both ends, or None where none is touched.

    Args:
        rough: the line as read.
        ends: its ends; an end that touches no circle is kept.
        circles: of the same plane.
        reach: how far the line may miss a circle that it touches.
    """
    touched = [_touched(rough, end, circles, reach) for end in ends]
    if touched[0] and touched[1] and touched[0] is not touched[1]:
        return _common_tangent(rough, touched[0], touched[1])
    if touched[0] and not touched[1]:
        return _tangent_through(rough, ends[1], touched[0])
    if touched[1] and not touched[0]:
        return _tangent_through(rough, ends[0], touched[1])
    return None


def _touched(
    rough: LineCurve, end: Point, circles: Sequence[CircleCurve], reach: float
) -> CircleCurve | None:
    best: tuple[float, CircleCurve] | None = None
    for circle in circles:
        miss = abs(rough.distance(circle.centre) - circle.radius)
        x, y = rough.at(rough.parameter(circle.centre))
        # An error of the line moves the touching point much more than it moves the line.
        room = max(_NEAR_END * reach, 0.2 * circle.radius)
        near = hypot(x - end[0], y - end[1]) <= room
        if miss <= reach and near and (best is None or miss < best[0]):
            best = miss, circle
    return best[1] if best else None


def _side(rough: LineCurve, circle: CircleCurve) -> float:
    """+1 where the circle's centre lies on the side of the line's normal, else -1."""
    normal = rough.normal(0.0)
    dx, dy = circle.centre[0] - rough.point[0], circle.centre[1] - rough.point[1]
    return 1.0 if dx * normal[0] + dy * normal[1] > 0.0 else -1.0


def _common_tangent(rough: LineCurve, one: CircleCurve, other: CircleCurve) -> LineCurve | None:
    """The tangent of two circles nearest to a line.

    With unit normal n and offset d, ``n . c = d + s r`` holds for both circles, s being the side
    on which the centre lies; the difference of the two equations gives the angle of n.
    """
    first, second = _side(rough, one) * one.radius, _side(rough, other) * other.radius
    dx, dy = other.centre[0] - one.centre[0], other.centre[1] - one.centre[1]
    away = hypot(dx, dy)
    if away <= abs(second - first):
        return None
    middle, half = atan2(dy, dx), acos((second - first) / away)
    normals = [(cos(angle), sin(angle)) for angle in (middle + half, middle - half)]
    wanted = rough.normal(0.0)
    normal = max(normals, key=lambda n: n[0] * wanted[0] + n[1] * wanted[1])
    start = one.centre[0] - first * normal[0], one.centre[1] - first * normal[1]
    end = other.centre[0] - second * normal[0], other.centre[1] - second * normal[1]
    if hypot(end[0] - start[0], end[1] - start[1]) < 1e-6:
        return None
    return line_through(start, end)


def _tangent_through(rough: LineCurve, point: Point, circle: CircleCurve) -> LineCurve | None:
    """The tangent of a circle through a point outside of it, on the rough line's side."""
    return _common_tangent(rough, CircleCurve(point, 0.0), circle)
