"""Whether the lengths that a person told agree with each other."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot

from gaussiancad_core.readings.correction_operations import Operation, ScaleOperation
from gaussiancad_core.readings.reading_schema import Point, ReadScale

CLICK_PX = 3.0
"""px within which a person hits a point of the sheet."""


@dataclass(frozen=True)
class GivenLength:
    """A length between two points of the sheet.

    Attributes:
        points: px of the sheet.
        length_mm: between them, in the part.
    """

    points: tuple[Point, Point]
    length_mm: float

    @property
    def apart(self) -> float:
        """px between the points."""
        (x0, y0), (x1, y1) = self.points
        return hypot(x1 - x0, y1 - y0)

    def is_of(self, other: "GivenLength") -> bool:
        """Whether both are told of the same two points, in any order."""
        return any(
            all(
                hypot(a[0] - b[0], a[1] - b[1]) <= CLICK_PX
                for a, b in zip(self.points, pair, strict=True)
            )
            for pair in (other.points, other.points[::-1])
        )

    def agrees(self, other: "GivenLength") -> bool:
        """Whether one scale gives both, up to what the clicks may miss."""
        mine, its = self.length_mm / self.apart, other.length_mm / other.apart
        return abs(mine - its) <= 2.0 * CLICK_PX * (mine / self.apart + its / other.apart)


def contradicting_lengths(
    scale: ReadScale, operations: Iterable[Operation]
) -> tuple[GivenLength, GivenLength] | None:
    """The last length that was told, and an earlier one that no common scale gives.

    A length that is told again of the same points takes the place of the one before; a scale that
    is told otherwise takes the place of all.

    Args:
        scale: of the reading before the operations, which may have been told.
        operations: a person's.
    """
    lengths: list[GivenLength] = []
    if scale.points is not None and scale.length_mm is not None:
        lengths = [GivenLength(scale.points, scale.length_mm)]
    for operation in operations:
        if not isinstance(operation, ScaleOperation):
            continue
        if operation.points is None or operation.length_mm is None:
            lengths = []
            continue
        new = GivenLength(operation.points, operation.length_mm)
        if new.apart > CLICK_PX:
            lengths = [*(one for one in lengths if not one.is_of(new)), new]
    if not lengths:
        return None
    *earlier, last = lengths
    return next(((one, last) for one in earlier if not one.agrees(last)), None)
