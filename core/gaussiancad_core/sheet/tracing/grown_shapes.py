"""What is grown along ridge points: a line, circle or ellipse with the points that it explains."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line, WholeCurve

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Grown:
    """A line, circle or ellipse with the ridge points that it explains.

    Attributes:
        geometry: in px, centres of pixels at integers.
        members: (k,) rows of the ridge points.
    """

    geometry: WholeCurve
    members: npt.NDArray[np.int64]

    @property
    def line(self) -> Line:
        """Its geometry, of a straight one."""
        if not isinstance(self.geometry, Line):
            raise ValueError("the shape is not straight")
        return self.geometry

    @property
    def circle(self) -> Circle:
        """Its geometry, of a circle."""
        if not isinstance(self.geometry, Circle):
            raise ValueError("the shape is no circle")
        return self.geometry


def grown_lines(shapes: Sequence[Grown]) -> tuple[Floats, Floats]:
    """(n, 2) directions and (n,) lengths in px of the straight ones of shapes found in pixels."""
    lines = [shape for shape in shapes if isinstance(shape.geometry, Line)]
    directions = np.array([line.line.direction for line in lines]).reshape(-1, 2)
    return directions, np.array([len(line.members) for line in lines], dtype=np.float64)
