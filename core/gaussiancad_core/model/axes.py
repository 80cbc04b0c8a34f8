"""Axes of the model, roles of the views, and where a view stands on a sheet.

Model axes are FreeCAD's own, in millimetres: the front view looks along +Y with X to its right and
Z up.  The model's bounding box starts at the origin.  A view's plane has two coordinates,
``right`` and ``up``, which are the dot products of a model point with the view's ``right`` and
``up`` vectors; they may be negative (the left view's right is -Y).

The placement of views follows ISO 5456-2 (first angle, third angle).
"""

from dataclasses import dataclass
from enum import Enum
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

Vector = tuple[float, float, float]
"""(x, y, z): a point or a direction in the model's axes, in the unit of whoever holds it."""


class Axis(Enum):
    """An axis of the model; the value is its index in coordinates."""

    X = 0
    Y = 1
    Z = 2


class Projection(Enum):
    """First- or third-angle projection (ISO 5456-2)."""

    FIRST = "first"
    THIRD = "third"

    @property
    def other(self) -> "Projection":
        """The projection that this one can be confused with."""
        return Projection.THIRD if self is Projection.FIRST else Projection.FIRST


@dataclass(frozen=True)
class ViewFrame:
    """Orientation of a view as rows of integers in model axes.

    Attributes:
        right: (3,) the model direction that runs to the right on the sheet.
        up: (3,) the model direction that runs up the sheet.
        look: (3,) the direction in which the viewer looks; ``look = up x right``.
    """

    right: tuple[float, float, float]
    up: tuple[float, float, float]
    look: tuple[float, float, float]

    @property
    def right_axis(self) -> tuple[Axis, int]:
        """The axis along the view's right, and its sign (+1 or -1)."""
        return _axis_of(self.right)

    @property
    def up_axis(self) -> tuple[Axis, int]:
        """The axis along the view's up, and its sign (+1 or -1)."""
        return _axis_of(self.up)

    @property
    def look_axis(self) -> tuple[Axis, int]:
        """The axis along which the view looks, and its sign (+1 or -1)."""
        return _axis_of(self.look)

    def world_to_camera(self) -> "npt.NDArray[np.float64]":
        """(3, 3) rotation whose rows are right, down and look: the camera axes of COLMAP."""
        import numpy as np

        return np.array([self.right, -np.array(self.up), self.look], dtype=np.float64)


@cache
def _axis_of(vector: tuple[float, float, float]) -> tuple[Axis, int]:
    index = next(i for i, component in enumerate(vector) if component)
    return Axis(index), int(vector[index])


class Role(Enum):
    """What a view shows.  The value is the name used in files and options."""

    FRONT = "front"
    TOP = "top"
    RIGHT = "right"
    LEFT = "left"
    BOTTOM = "bottom"
    REAR = "rear"

    @property
    def frame(self) -> ViewFrame:
        """The orientation of the view in model axes."""
        return _FRAMES[self]

    def slot(self, projection: Projection) -> tuple[int, int]:
        """Column and row of the view on the sheet relative to the front view; rows count up.

        The rear view stands at the outer side of the right view in third angle (column 2) and of
        the left view in first angle (column 2, as the left view stands right of the front there).
        """
        column, row = _THIRD_ANGLE_SLOTS[self]
        if projection is Projection.FIRST and self is not Role.REAR:
            return -column, -row
        return column, row


_FRAMES = {
    Role.FRONT: ViewFrame((1, 0, 0), (0, 0, 1), (0, 1, 0)),
    Role.TOP: ViewFrame((1, 0, 0), (0, 1, 0), (0, 0, -1)),
    Role.RIGHT: ViewFrame((0, 1, 0), (0, 0, 1), (-1, 0, 0)),
    Role.LEFT: ViewFrame((0, -1, 0), (0, 0, 1), (1, 0, 0)),
    Role.BOTTOM: ViewFrame((1, 0, 0), (0, -1, 0), (0, 0, 1)),
    Role.REAR: ViewFrame((-1, 0, 0), (0, 0, 1), (0, -1, 0)),
}

_THIRD_ANGLE_SLOTS = {
    Role.FRONT: (0, 0),
    Role.TOP: (0, 1),
    Role.RIGHT: (1, 0),
    Role.LEFT: (-1, 0),
    Role.BOTTOM: (0, -1),
    Role.REAR: (2, 0),
}


def mutually_orthogonal(roles: tuple[Role, ...]) -> bool:
    """Whether the roles look along three different axes between them."""
    return len({role.frame.look_axis[0] for role in roles}) == 3
