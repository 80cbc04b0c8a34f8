"""The three projection planes in the model's own coordinates.

Each view looks along an axis; opposite views share a plane.  A plane's coordinates (a, b) are the
model's two other coordinates in the order x, y, z, in units of a hundredth of the part's longest
extent.  In these units the solver's tolerances are plain numbers.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Axis, Role

UNITS = 100.0
"""Units along the part's longest extent."""

IN_PLANE = {Axis.X: (1, 2), Axis.Y: (0, 2), Axis.Z: (0, 1)}
"""Indices of the model axes that a plane's coordinates run along, by the plane's normal."""


@dataclass(frozen=True)
class RolePlane:
    """How a view lies in its projection plane.

    Attributes:
        normal: axis that the view looks along.
        looks_up: whether it looks towards larger coordinates.
        signs: (2,) of a plane's coordinates in terms of the view's (right, up).
    """

    normal: Axis
    looks_up: bool
    signs: tuple[int, int]


@cache
def role_plane(role: Role) -> RolePlane:
    """The plane of a view and how the view lies in it."""
    frame = role.frame
    normal, look_sign = frame.look_axis
    (_, right_sign), (_, up_sign) = frame.right_axis, frame.up_axis
    # Every role has its right along the first of the plane's axes, and its up along the second.
    return RolePlane(normal, look_sign > 0, (right_sign, up_sign))


def plane_points(
    points: npt.NDArray[np.float64], role: Role, scale: float
) -> npt.NDArray[np.float64]:
    """(n, 2) view mm (right, up) -> (n, 2) plane units; ``scale`` is units per mm."""
    return points * np.array(role_plane(role).signs) * scale


def lifted(normal: Axis, a: float, b: float, depth: float) -> tuple[float, float, float]:
    """The (3,) model point with coordinates (a, b) in a plane and ``depth`` along its normal."""
    point = [0.0, 0.0, 0.0]
    first, second = IN_PLANE[normal]
    point[first], point[second], point[normal.value] = a, b, depth
    return point[0], point[1], point[2]
