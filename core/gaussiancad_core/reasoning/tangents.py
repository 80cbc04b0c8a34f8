"""Slanted lines that touch circles."""

from collections.abc import Sequence
from math import hypot

from gaussiancad_core.reasoning.curves import CircleCurve, LineCurve, Point

_NEAR_END = 6.0
"""Reaches within which a circle's touching point lies from the line's end, at least."""


def touched_circles(
    rough: LineCurve, ends: tuple[Point, Point], circles: Sequence[CircleCurve], reach: float
) -> tuple[CircleCurve | None, CircleCurve | None]:
    """The circle that a line touches at each of its ends, None where there is none.

    Args:
        rough: the line as read.
        ends: of its strokes.
        circles: of the same plane.
        reach: how far the line may miss a circle that it touches.
    """
    one, other = (_touched(rough, end, circles, reach) for end in ends)
    return one, None if other is one else other


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
