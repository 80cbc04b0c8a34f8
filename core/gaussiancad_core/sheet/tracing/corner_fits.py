"""Arcs that are corners: two or three straight lines follow their points more closely.

Where a short line meets another at a small angle, a flat arc lies within half a pixel of both; and
so does a rounder one where it is the flank of a groove between two others.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sheet.picture_noise import CLOSER, FEWEST_PLACES

Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.intp]

_ROUGH = 0.1
"""px root mean square from which an arc is doubted: better ones are arcs."""

_ROUGH_OF_THREE = 0.2
"""The same where there are three lines, which follow anything more closely."""

_MOST = 200
"""Points up to which three lines are looked for: larger corners are found as lines."""

_WIDEST, _WIDEST_OF_THREE = 2.0, 2.8
"""Radians that a doubtful arc sweeps at most: no single corner looks like more, nor two."""


def is_corner(circle: Circle, points: Floats) -> bool:
    """Whether (n, 2) px along an arc lie on two or three lines rather than on it."""
    if len(points) < 2 * FEWEST_PLACES:
        return False
    offsets = points - np.array(circle.centre)
    rms = float(np.sqrt(np.mean((np.hypot(*offsets.T) - circle.radius) ** 2)))
    if rms < _ROUGH:
        return False
    middle = offsets.mean(0)
    angles = np.arctan2(*(offsets @ _turned(middle)).T)
    if np.ptp(angles) > _WIDEST_OF_THREE:
        return False
    ordered = points[np.argsort(angles)]
    if np.ptp(angles) <= _WIDEST and _two_lines_rms(ordered) < CLOSER * rms:
        return True
    if rms < _ROUGH_OF_THREE or not 3 * FEWEST_PLACES <= len(points) <= _MOST:
        return False
    return _three_lines_rms(ordered) < CLOSER * rms


def _turned(vector: Floats) -> Floats:
    """(2, 2) matrix to coordinates (across, along) a vector."""
    along = vector / max(float(np.hypot(*vector)), 1e-9)
    return np.array([[-along[1], along[0]], [along[0], along[1]]]).T


def _two_lines_rms(points: Floats) -> float:
    """Of total least squares lines through the first and the last points, at the best break."""
    count = len(points)
    left = _residuals(points)
    right = _residuals(points[::-1])[::-1]
    breaks = np.arange(FEWEST_PLACES, count - FEWEST_PLACES + 1)
    return float(np.sqrt((left[breaks - 1] + right[breaks]).min() / count))


def _three_lines_rms(points: Floats) -> float:
    """The same of three lines, at the best two breaks."""
    count = len(points)
    left, right = _residuals(points), _residuals(points[::-1])[::-1]
    first = np.arange(FEWEST_PLACES, count - 2 * FEWEST_PLACES + 1)[:, None]
    second = np.arange(2 * FEWEST_PLACES, count - FEWEST_PLACES + 1)
    middle = np.where(
        second - first >= FEWEST_PLACES, _residuals_between(points, first, second), np.inf
    )
    return float(np.sqrt((left[first - 1] + middle + right[second]).min() / count))


def _residuals(points: Floats) -> Floats:
    """(n,) least sums of squared distances of the first 1, 2, ... n points from a line."""
    return _residuals_between(points, np.zeros(1, np.intp), np.arange(1, len(points) + 1))


def _residuals_between(points: Floats, first: Indices, end: Indices) -> Floats:
    """Least sums of squared distances from a line of the points from ``first`` up to before
    ``end``, indices that are broadcast together; what they give where ``end`` is not larger says
    nothing."""
    x, y = (points - points.mean(0)).T
    sums = np.zeros((5, len(points) + 1))
    np.cumsum([x, y, x * x, y * y, x * y], axis=1, out=sums[:, 1:])
    first, end = np.broadcast_arrays(first, end)
    count = np.maximum(end - first, 1)
    x, y, xx, yy, xy = sums[:, end] - sums[:, first]
    xx, yy, xy = xx - x * x / count, yy - y * y / count, xy - x * y / count
    least = (xx + yy - np.hypot(xx - yy, 2.0 * xy)) / 2.0
    return np.maximum(least, 0.0)
