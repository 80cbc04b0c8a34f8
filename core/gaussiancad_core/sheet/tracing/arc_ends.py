"""Ends of a line along which arcs that touch it leave it.

Where an arc passes into its tangent, their ink is one for some px on the arc's side, and a line is
followed into it.  With wide arcs that is far enough, above all where two of them leave to different
sides, to turn the line by a fraction of a degree; so only what lies between them tells its course.
"""

from collections.abc import Iterable

import numpy as np

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.picture_noise import TOUCHING
from gaussiancad_core.sheet.votes import HALF

_WIDE_PX = 40.0
"""Radius of such arcs at least: others leave a line within a few px."""

_LEAVING_PX = 3.0
"""px across by which an arc has left its tangent where no ink of it is the line's any more."""


def without_arc_ends(
    line: Line, spans: list[tuple[float, float]], circles: Iterable[Circle]
) -> list[tuple[float, float]]:
    """Where along a line its ink is its own: not beyond where a circle touches it near an end.

    Args:
        line: px.
        spans: where along the line there is ink, in order.
        circles: px; narrow ones, and those that do not touch the line, do not matter.
    """
    start, end = spans[0][0], spans[-1][1]
    low, high = start, end
    for circle in circles:
        if circle.radius < _WIDE_PX:
            continue
        foot = float(line.positions(np.array([circle.centre]))[0])
        away = float(line.distances(np.array([circle.centre]))[0])
        if abs(away - circle.radius) > TOUCHING:
            continue
        leaving = float(np.sqrt(2.0 * circle.radius * _LEAVING_PX))
        if 0.0 < foot - start <= leaving:
            low = max(low, foot)
        elif 0.0 < end - foot <= leaving:
            high = min(high, foot)
    cut = [(max(a, low), min(b, high)) for a, b in spans if a < high and b > low]
    return cut if _length(cut) >= HALF * _length(spans) else spans


def _length(spans: list[tuple[float, float]]) -> float:
    return sum(end - start for start, end in spans)
