"""Points in and around a solid, each of which stands for a piece of space."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Samples:
    """Points, and whether they are within the solid.

    Attributes:
        points: (n, 3) mm.
        is_inside: (n,) bool.
    """

    points: Points
    is_inside: npt.NDArray[np.bool_]

    def with_others(self, points: Points, is_inside: npt.NDArray[np.bool_]) -> "Samples":
        """These and some more."""
        return Samples(
            np.concatenate([self.points, points]), np.concatenate([self.is_inside, is_inside])
        )


def joined(parts: Iterable[Samples]) -> Samples:
    """All samples as one."""
    found = list(parts)
    return Samples(
        np.concatenate([part.points for part in found]),
        np.concatenate([part.is_inside for part in found]),
    )
