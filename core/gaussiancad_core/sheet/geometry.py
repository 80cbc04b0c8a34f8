"""Infinite lines and circles on a sheet."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """An infinite line with unit direction, in px of the image (centres of pixels at integers)."""

    point: tuple[float, float]
    direction: tuple[float, float]

    def coordinates(self, points: Points) -> tuple[Points, Points]:
        """(n, 2) points -> position along the line and signed distance from it, (n,) each."""
        offset = points - np.array(self.point)
        along = offset @ np.array(self.direction)
        across = offset @ np.array([-self.direction[1], self.direction[0]])
        return along, across

    def distances(self, points: Points) -> Points:
        """(n, 2) points -> (n,) distances from the line."""
        return np.abs(self.coordinates(points)[1])

    def at(self, along: float) -> tuple[float, float]:
        """The point at a position along the line."""
        return (
            self.point[0] + along * self.direction[0],
            self.point[1] + along * self.direction[1],
        )


@dataclass(frozen=True)
class Circle:
    """A circle in px of the image (centres of pixels at integers)."""

    centre: tuple[float, float]
    radius: float

    def distances(self, points: Points) -> Points:
        """(n, 2) points -> (n,) distances from the circle."""
        offset = points - np.array(self.centre)
        return np.abs(np.hypot(offset[:, 0], offset[:, 1]) - self.radius)
