"""Chains that run along a circle that is drawn elsewhere in their view.

Where a fillet ends on a cylinder that is seen edge-on, the curve of intersection is a part of the
cylinder's circle, but files give it as a spline, which misses the circle by its own tolerance.
"""

import numpy as np

from gaussiancad_core.coordinates.point_chains import Chain
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import TELLING
from gaussiancad_core.geometry.whole_curves import Circle


def arc_along(chain: Chain, circle: Circle, near: float) -> tuple[float, float] | None:
    """The (start, sweep) in radians of the part of a circle that a chain is.

    Args:
        chain: points.
        circle: that may carry it.
        near: units within which the points lie on it.

    Returns:
        None if a point lies off the circle, the chain turns back, or is too flat to tell.
    """
    points = np.array(chain) - np.array(circle.centre)
    if np.abs(np.hypot(*points.T) - circle.radius).max() > near:
        return None
    angles = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    steps = np.diff(angles)
    if not ((steps >= 0.0).all() or (steps <= 0.0).all()):
        return None
    low, high = sorted((float(angles[0]), float(angles[-1])))
    sweep = min(high - low, FULL_TURN)
    if circle.radius * (1.0 - np.cos(min(sweep, np.pi) / 2.0)) < TELLING * near:
        return None
    return low % FULL_TURN, sweep
