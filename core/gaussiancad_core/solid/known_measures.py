"""What makes some measures of a solid known: the step that it was designed in, the sheet's numbers.

What a picture tells to a tenth of a pixel is known exactly where it was rounded to the step of the
design.  Where a measure is odd, another one may be near a round one by chance, and odd as well; how
likely that is follows from how many odd ones were seen.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.coordinates.constrained_places import ConstrainedPlaces
from gaussiancad_core.coordinates.design_step import ODD, ROUND_MM
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.solid.known_faces import Known, Points

_MOST_BY_CHANCE = 0.1
"""Odd measures that are taken for round ones by chance, on average, up to which two are not to be
expected."""


@dataclass(frozen=True)
class RoundMeasures:
    """What is known of a part most of whose measures are multiples of a step.

    Attributes:
        step: mm.
        reach: mm by which measures were moved to become multiples, at most.
        odd: how many are none.
    """

    step: float
    reach: float
    odd: int

    @property
    def is_usual(self) -> bool:
        """Whether the step is one that most parts are designed in.

        Others are parts of the longest extent.  Where that is odd itself, what is round otherwise
        may be near multiples of such a part, at a scale that is a little wrong.
        """
        return any(abs(self.step - usual) <= COMPUTED * usual for usual in ROUND_MM)

    @property
    def by_chance(self) -> float:
        """How many odd ones were taken for multiples, on average."""
        share = min(2.0 * self.reach / self.step, 0.99)
        return self.odd * share / (1.0 - share)

    def coordinates(self, axis: int, numbers: Points) -> Known:
        """Multiples of the step."""
        return self.radii(numbers)

    def radii(self, numbers: Points) -> Known:
        """Multiples of the step."""
        return np.abs(numbers - self.step * np.round(numbers / self.step)) <= ODD * self.step

    @property
    def is_chance(self) -> bool:
        """Whether too much may be round by chance for any of it to be known."""
        return self.by_chance > _MOST_BY_CHANCE


@dataclass(frozen=True)
class DimensionEvidence:
    """What numbers on the sheet tell of a part.

    Attributes:
        places: that follow from them, mm.
        near: mm within which a coordinate is a told one.
    """

    places: ConstrainedPlaces
    near: float

    def coordinates(self, axis: int, numbers: Points) -> Known:
        """Those that numbers tell."""
        return self._known_by_numbers(self.places.values[Axis(axis)], numbers)

    def radii(self, numbers: Points) -> Known:
        """Those that numbers tell."""
        return self._known_by_numbers(self.places.radii, numbers)

    def _known_by_numbers(self, stated: Sequence[float], numbers: Points) -> Known:
        apart = np.abs(numbers[:, None] - np.array(stated)[None, :])
        return apart.min(axis=1, initial=np.inf) <= self.near
