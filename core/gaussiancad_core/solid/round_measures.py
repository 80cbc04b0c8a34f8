"""How much of a solid is in doubt whose measures are round but for a few.

What a picture tells to a tenth of a pixel is known exactly where it was rounded to the step that
the part was designed in.  Faces that do not follow from such multiples may lie as far from where
they were read as numbers were rounded at most.

Where a measure is odd, another one may be near a round one by chance, and odd as well.  How likely
that is follows from how many odd ones were seen: where more than one is unlikely, the largest face
is in doubt, too, whichever it may be.  Where all faces are round, odd coordinates are none of
these: an edge in which faces meet, as that of a flat on a cylinder, is where they have it.
"""

from dataclasses import dataclass

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.brep import faces_of
from gaussiancad_core.reasoning.nominal import ROUND_MM
from gaussiancad_core.solid.known_faces import Known, Points, areas, is_known

_ON = 1e-4
"""Share of the step within which a number is a multiple of it: what was rounded is exact but for
rounding errors, what was not is one to this by chance in one of five thousand."""

_USUAL = 1e-6
"""Share of a step by which it may miss a round number of mm."""

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
        return any(abs(self.step - usual) <= _USUAL * usual for usual in ROUND_MM)

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
        return np.abs(numbers - self.step * np.round(numbers / self.step)) <= _ON * self.step

    def volume_in_doubt(self, shape: TopoDS_Shape, unsure: float) -> float:
        """mm3 by which a solid may be wrong, or infinity where too much may be round by chance.

        Args:
            shape: mm; its bounding box starts at the origin.
            unsure: by how much a face may be off if nothing tells it: no multiple lies as far off.
        """
        if self.by_chance > _MOST_BY_CHANCE:
            return np.inf
        unknown, _, largest = areas(shape, self)
        return self.reach * (unknown + largest)


def is_round(shape: TopoDS_Shape, step: float) -> bool:
    """Whether all faces of a solid follow from multiples of a step in mm."""
    measures = RoundMeasures(step, 0.0, 0)
    return all(is_known(face, measures) for face in faces_of(shape))
