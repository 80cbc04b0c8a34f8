"""Round faces of a solid by the axes that they have, and what lies around an axis."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from math import tau

import numpy as np
import numpy.typing as npt

from gaussiancad_core.features.solid_faces import Kind, SolidFace
from gaussiancad_core.geometry.tolerances import COMPUTED, UNIT_VECTOR

Vector = npt.NDArray[np.float64]

SAME = 1e-4
"""Units within which places are one."""


@dataclass(frozen=True, eq=False)
class RoundAxis:
    """An axis of a solid.

    Attributes:
        point: (3,) units, the one of it that is nearest to the origin.
        direction: (3,) unit vector towards larger coordinates.
        faces: that are round about it.
    """

    point: Vector
    direction: Vector
    faces: list[SolidFace] = field(default_factory=list)

    def is_as(self, other: "RoundAxis") -> bool:
        """Whether two are one line."""
        apart = float(np.linalg.norm(np.cross(self.direction, other.direction)))
        return apart < COMPUTED and float(np.linalg.norm(self.point - other.point)) < SAME

    def off(self, place: Vector) -> float:
        """Units between a place and the axis."""
        away = place - self.point
        return float(np.linalg.norm(away - self.direction * float(away @ self.direction)))


def axis_through(place: Vector, direction: Vector) -> RoundAxis:
    """An axis without faces, through a place along a unit vector."""
    largest = int(np.argmax(np.abs(direction)))
    way = direction * np.sign(direction[largest])
    return RoundAxis(place - way * float(place @ way), way)


def by_axis(faces: Iterable[SolidFace]) -> list[RoundAxis]:
    """The axes of faces that have one, with the faces of each."""
    found: list[RoundAxis] = []
    for face in faces:
        axis = axis_through(face.point, face.direction)
        known = next((other for other in found if other.is_as(axis)), None)
        if known is None:
            found.append(axis)
        (known or axis).faces.append(face)
    return found


def levels_along(faces: Sequence[SolidFace], point: Vector, direction: Vector) -> list[float]:
    """Units from a point along a direction at which plane faces lie across it."""
    return [
        float((face.point - point) @ direction)
        for face in faces
        if face.kind is Kind.PLANE and abs(float(face.direction @ direction)) > 1.0 - UNIT_VECTOR
    ]


def around(
    point: Vector, direction: Vector, radius: float, count: int, first: float
) -> Iterator[Vector]:
    """(3,) points around an axis.

    Args:
        point: of the axis.
        direction: unit vector.
        radius: units from it.
        count: how many.
        first: radians at which they begin; one that makes none level with another.
    """
    level = np.eye(3)[int(np.argmin(np.abs(direction)))]
    right = np.cross(level, direction)
    right /= np.linalg.norm(right)
    up = np.cross(direction, right)
    for angle in first + tau * np.arange(count) / count:
        yield point + radius * (np.cos(angle) * right + np.sin(angle) * up)
