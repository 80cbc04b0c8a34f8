"""Points, boxes and angles of a plane."""

from math import pi

import numpy as np
import numpy.typing as npt

Point = tuple[float, float]

Points = npt.NDArray[np.float64]
"""(n, 2), or one number for each of n points."""

Box = tuple[float, float, float, float]
"""x0, y0, x1, y1."""

FULL_TURN = 2.0 * pi
"""Radians."""


def to_point(values: Points) -> Point:
    """(2,) numbers as plain ones."""
    return float(values[0]), float(values[1])


def box_around(points: Points) -> Box:
    """The smallest box that holds (n, 2) points."""
    (x0, y0), (x1, y1) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return x0, y0, x1, y1


def wrapped(angle: float) -> float:
    """An angle in [0, 2 pi); what rounding leaves just below a turn is 0."""
    turned = float(angle) % FULL_TURN
    return turned if FULL_TURN - turned > 1e-12 else 0.0
