"""Slanted lines, and circles, that touch circles."""

from collections.abc import Iterator, Sequence
from itertools import permutations
from math import hypot

from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle, Line

_NEAR_END = 6.0
"""Reaches within which a circle's touching point lies from the line's end, at least."""


def touched_circles(
    rough: Line, ends: tuple[Point, Point], circles: Sequence[Circle], reach: float
) -> tuple[Circle | None, Circle | None]:
    """The circle that a line touches at each of its ends, None where there is none.

    Args:
        rough: the line as read.
        ends: of its strokes.
        circles: of the same plane.
        reach: how far the line may miss a circle that it touches.
    """
    one, other = (_touched(rough, end, circles, reach) for end in ends)
    return one, None if other is one else other


def _touched(rough: Line, end: Point, circles: Sequence[Circle], reach: float) -> Circle | None:
    best: tuple[float, Circle] | None = None
    for circle in circles:
        miss = abs(rough.distance(circle.centre) - circle.radius)
        x, y = rough.at(rough.parameter(circle.centre))
        # An error of the line moves the touching point much more than it moves the line.
        room = max(_NEAR_END * reach, 0.2 * circle.radius)
        near = hypot(x - end[0], y - end[1]) <= room
        if miss <= reach and near and (best is None or miss < best[0]):
            best = miss, circle
    return best[1] if best else None


def touching_circles(
    circles: Sequence[Circle], ends: Sequence[Point], reach: float
) -> Iterator[tuple[Circle, Circle, bool]]:
    """Pairs of circles that pass smoothly into each other where strokes end.

    Args:
        circles: of one plane.
        ends: of its strokes.
        reach: how far a circle may miss another one that it touches.

    Yields:
        The larger circle, the other one, and whether that lies inside.
    """
    for one, other in permutations(circles, 2):
        if (one.radius, one.centre) < (other.radius, other.centre):
            continue
        dx, dy = other.centre[0] - one.centre[0], other.centre[1] - one.centre[1]
        away = hypot(dx, dy)
        if away <= _NEAR_END * reach:
            continue
        inside = away < one.radius
        miss = away - one.radius - (-other.radius if inside else other.radius)
        if abs(miss) > reach:
            continue
        share = one.radius / away
        x, y = one.centre[0] + share * dx, one.centre[1] + share * dy
        # An error of the circles moves the touching point much more than it moves them.
        room = max(_NEAR_END * reach, 0.2 * other.radius)
        if any(
            hypot(x - end[0], y - end[1]) <= room
            and max(one.distance(end), other.distance(end)) <= reach
            for end in ends
        ):
            yield one, other, inside
