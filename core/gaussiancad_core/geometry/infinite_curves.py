"""Infinite lines, circles and ellipses on a sheet.

A position along a shape is a length in px: from the point of a line, from angle 0 of a circle, from
the end of an ellipse's major axis.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse

Points = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """An infinite line with unit direction, in px of the image (centres of pixels at integers)."""

    point: tuple[float, float]
    direction: tuple[float, float]

    @property
    def around(self) -> float:
        """Endless."""
        return float("inf")

    def coordinates(self, points: Points) -> tuple[Points, Points]:
        """(n, 2) points -> position along the line and signed distance from it, (n,) each."""
        offset = points - np.array(self.point)
        along = offset @ np.array(self.direction)
        across = offset @ np.array([-self.direction[1], self.direction[0]])
        return along, across

    def distances(self, points: Points) -> Points:
        """(n, 2) points -> (n,) distances from the line."""
        return np.abs(self.coordinates(points)[1])

    def positions(self, points: Points) -> Points:
        """(n, 2) points -> (n,) positions of the nearest points of the line."""
        return self.coordinates(points)[0]

    def points_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) points."""
        return np.array(self.point) + along[:, None] * np.array(self.direction)

    def tangents_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) unit tangents."""
        return np.broadcast_to(np.array(self.direction), (len(along), 2))

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

    @property
    def around(self) -> float:
        """Its circumference in px."""
        return 2 * np.pi * self.radius

    def distances(self, points: Points) -> Points:
        """(n, 2) points -> (n,) distances from the circle."""
        offset = points - np.array(self.centre)
        return np.abs(np.hypot(offset[:, 0], offset[:, 1]) - self.radius)

    def positions(self, points: Points) -> Points:
        """(n, 2) points -> (n,) positions of the nearest points, -half to half around."""
        offset = points - np.array(self.centre)
        return np.arctan2(offset[:, 1], offset[:, 0]) * self.radius

    def points_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) points."""
        return np.array(self.centre) + self.radius * self._radial(along)

    def tangents_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) unit tangents, the way that positions grow."""
        radial = self._radial(along)
        return np.stack([-radial[:, 1], radial[:, 0]], 1)

    def _radial(self, along: Points) -> Points:
        angles = along / self.radius
        return np.stack([np.cos(angles), np.sin(angles)], 1)


Curve = Circle | WholeEllipse
"""What closes on itself."""

Geometry = Line | Circle | WholeEllipse
"""Whatever strokes are pieces of."""
