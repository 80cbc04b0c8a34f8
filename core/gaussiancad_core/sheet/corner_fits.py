"""Arcs that are corners: two straight lines follow their points more closely.

Where a short line meets another at a small angle, a flat arc lies within half a pixel of both.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.geometry import Circle

Floats = npt.NDArray[np.float64]

_BETTER = 0.6
"""Share of the arc's residuals that the two lines leave at most."""

_ROUGH = 0.1
"""px root mean square from which an arc is doubted: better ones are arcs."""

_LEAST = 6
"""Points of each line."""

_WIDEST = 2.0
"""Radians that a doubtful arc sweeps at most: no single corner looks like more."""


def is_corner(circle: Circle, points: Floats) -> bool:
    """Whether (n, 2) px along an arc lie on two lines rather than on it."""
    if len(points) < 2 * _LEAST:
        return False
    offsets = points - np.array(circle.centre)
    rms = float(np.sqrt(np.mean((np.hypot(*offsets.T) - circle.radius) ** 2)))
    if rms < _ROUGH:
        return False
    middle = offsets.mean(0)
    angles = np.arctan2(*(offsets @ _turned(middle)).T)
    if np.ptp(angles) > _WIDEST:
        return False
    ordered = points[np.argsort(angles)]
    return _two_lines_rms(ordered) < _BETTER * rms


def _turned(vector: Floats) -> Floats:
    """(2, 2) matrix to coordinates (across, along) a vector."""
    along = vector / max(float(np.hypot(*vector)), 1e-9)
    return np.array([[-along[1], along[0]], [along[0], along[1]]]).T


def _two_lines_rms(points: Floats) -> float:
    """Of total least squares lines through the first and the last points, at the best break."""
    count = len(points)
    left = _residuals(points)
    right = _residuals(points[::-1])[::-1]
    breaks = np.arange(_LEAST, count - _LEAST + 1)
    return float(np.sqrt((left[breaks - 1] + right[breaks]).min() / count))


def _residuals(points: Floats) -> Floats:
    """(n,) least sums of squared distances of the first 1, 2, ... n points from a line."""
    shifted = points - points.mean(0)
    count = np.arange(1, len(points) + 1)
    x, y = np.cumsum(shifted, axis=0).T
    xx = np.cumsum(shifted[:, 0] ** 2) - x * x / count
    yy = np.cumsum(shifted[:, 1] ** 2) - y * y / count
    xy = np.cumsum(shifted[:, 0] * shifted[:, 1]) - x * y / count
    least = (xx + yy - np.hypot(xx - yy, 2.0 * xy)) / 2.0
    return np.maximum(least, 0.0)
