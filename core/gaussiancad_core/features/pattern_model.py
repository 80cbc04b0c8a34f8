"""How features repeat."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.features.frames import Frame, Vector
from gaussiancad_core.features.instances import Member

Points = npt.NDArray[np.float64]

FEWEST = 3
"""Members of a row or circle at least: any two features are in line."""

DIGITS = 6
"""Decimal places of lengths and degrees: what is sure of numbers that follow from places with
eight."""


@dataclass(frozen=True)
class Step:
    """A row of a pattern.

    Attributes:
        direction: unit vector.
        count: members along it, the first one included.
        distance: mm from one to the next.
    """

    direction: Vector
    count: int
    distance: float


@dataclass(frozen=True)
class Row:
    """Members at equal distances along a line, or along two on a grid.

    Attributes:
        members: the first one is the one that repeats; along the first step, then the second.
        steps: one of a line, two of a grid.
    """

    members: tuple[Member, ...]
    steps: tuple[Step, ...]


@dataclass(frozen=True)
class Circle:
    """Members at equal angles around an axis.

    Attributes:
        members: the first one is the one that repeats; counter-clockwise, seen against the axis.
        point: mm, of the axis, in the plane of the members' middles.
        direction: unit vector of the axis.
        angle: degrees from one member to the next.
        diameter: mm of the circle that their middles lie on.
    """

    members: tuple[Member, ...]
    point: Vector
    direction: Vector
    angle: float
    diameter: float


@dataclass(frozen=True)
class Mirror:
    """Two members that are each other's image.

    Attributes:
        members: the one that repeats, and its image.
        frame: directions of the plane.
        height: mm of the plane along the frame's normal.
    """

    members: tuple[Member, ...]
    frame: Frame
    height: float


Pattern = Row | Circle | Mirror


def positive(way: Points) -> Points:
    """A direction, or the opposite one, towards larger coordinates."""
    return way * (1.0 if way[int(np.argmax(np.abs(np.round(way, 9))))] > 0.0 else -1.0)


def rounded_vector(vector: Points) -> Vector:
    """A point or direction without the last digits that computing leaves."""
    x, y, z = (round(float(value), 9) + 0.0 for value in vector)
    return x, y, z
