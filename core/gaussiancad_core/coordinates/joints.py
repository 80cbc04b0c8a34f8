"""Joints: where the curves of two strokes meet that end at one place.

Other views may have a value there that misses the joint by less than can be seen.  Led to that,
both strokes would end beside each other, and what they bound would be open.
"""

from collections.abc import Sequence
from math import hypot

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, meetings


def joints_of(
    curves: Sequence[LineOrCircle], strokes: Sequence[tuple[int, tuple[float, float]]], reach: float
) -> list[tuple[float | None, float | None]]:
    """Of each stroke the parameters of the joints at its low and its high end.

    Args:
        curves: of one plane.
        strokes: the number of each one's curve, and the parameters of its ends as read.
        reach: units within which ends are at one place, and their joint is there.

    Returns:
        None for ends at which no stroke of another curve ends, or whose curves do not meet there.
    """
    if not strokes:
        return []
    ends = [(index, end) for index, pair in strokes for end in pair]
    points = np.array([curves[index].at(end) for index, end in ends])
    joints: list[float | None] = [None] * len(ends)
    least = [reach] * len(ends)
    for one, other in cKDTree(points).query_pairs(reach):
        first, second = curves[ends[one][0]], curves[ends[other][0]]
        if first == second:
            continue
        for meeting in meetings(first, second):
            for place, curve in ((one, first), (other, second)):
                away = hypot(meeting[0] - points[place][0], meeting[1] - points[place][1])
                if away < least[place]:
                    least[place] = away
                    joints[place] = _parameter_near(curve, meeting, ends[place][1])
    return list(zip(joints[::2], joints[1::2], strict=True))


def _parameter_near(curve: LineOrCircle, point: tuple[float, float], near: float) -> float:
    """A point's parameter on a curve, on circles the one nearest to another parameter."""
    at = curve.parameter(point)
    if not isinstance(curve, Circle):
        return at
    return min((at - FULL_TURN, at, at + FULL_TURN), key=lambda turned: abs(turned - near))
