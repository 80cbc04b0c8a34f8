"""How much of a solid is in doubt whose measures the sheet tells in numbers.

What numbers say is known but for their rounding, a quarter of the last digit in the mean; the
number of one face, whichever it may be, may have been misread, by no more than what was drawn
differs from it.  Other faces are as much in doubt as without any numbers.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import Axis
from gaussiancad_core.reasoning.told_places import ToldPlaces
from gaussiancad_core.solid.known_faces import Known, Points, areas

_ROUNDED = 0.25
"""Mean error of rounded numbers, in their last digit."""


@dataclass(frozen=True)
class ToldMeasures:
    """What numbers on the sheet tell of a part.

    Attributes:
        places: that follow from them, mm.
        near: mm within which a coordinate is a told one.
    """

    places: ToldPlaces
    near: float

    def coordinates(self, axis: int, numbers: Points) -> Known:
        """Those that numbers tell."""
        return self._told(self.places.values[Axis(axis)], numbers)

    def radii(self, numbers: Points) -> Known:
        """Those that numbers tell."""
        return self._told(self.places.radii, numbers)

    def _told(self, told: Sequence[float], numbers: Points) -> Known:
        apart = np.abs(numbers[:, None] - np.array(told)[None, :])
        return apart.min(axis=1, initial=np.inf) <= self.near

    def volume_in_doubt(self, shape: TopoDS_Shape, unsure: float) -> float:
        """mm3 by which a solid may be wrong.

        Args:
            shape: mm; its bounding box starts at the origin.
            unsure: mm by which faces may be off, in the mean, that nothing tells.
        """
        unknown, known, largest = areas(shape, self)
        rounded = _ROUNDED * self.places.digit * known
        misread = max(self.places.beside, unsure) * largest
        return unsure * unknown + rounded + misread
