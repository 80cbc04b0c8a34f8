"""Measures that most likely are round numbers of millimetres, where too few tell a step.

A rod with one flat has four measures: too few for :mod:`.grid_fitting` to tell what step they are
multiples of.  Where the scale is known and a measure lies within a quarter of a pixel of a round
number that is many pixels from the next one, it was most likely meant to be that: designers choose
round numbers.  It moves by less than it was unknown, and nothing becomes certain by it.
"""

from collections.abc import Mapping, Sequence

import numpy as np

from gaussiancad_core.coordinates.design_step import ROUND_MM
from gaussiancad_core.coordinates.grid_fitting import (
    LIKELY,
    Floats,
    LikelyNumbers,
    Roughness,
    independent,
)
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import UNITS
from gaussiancad_core.sheet.votes import HALF

_REACH = 0.25
"""Tolerances by which a number may miss a round one."""

_BY_CHANCE = 0.12
"""Share of all numbers that lie that near to a multiple of the step, at most."""


def round_numbers(
    numbers: Floats,
    values: Mapping[Axis, Sequence[int]],
    circles: Sequence[tuple[Axis, int, int, int]],
    rough: Roughness,
) -> LikelyNumbers | None:
    """Numbers as they were most likely meant, or None if none is nearly round.

    Args:
        numbers: (n,) coordinates from 0 and radii, units.
        values: places of each axis' values among the numbers.
        circles: normal, and places of both coordinates of the centre and of the radius.
        rough: how roughly they are known.
    """
    reach = _REACH * rough.tolerance
    steps = [length * rough.millimetre for length in ROUND_MM]
    steps = [step for step in steps if 2.0 * reach <= _BY_CHANCE * step]
    if not steps:
        return None

    def rounded(number: float) -> float | None:
        # The longest extent is what the scale is known by.
        if not rough.tolerance < number < UNITS - rough.tolerance:
            return None
        multiples = (step * round(number / step) for step in steps)
        return next((multiple for multiple in multiples if abs(multiple - number) <= reach), None)

    stated_numbers = [
        number
        for items in independent(numbers, values, circles, rough.tolerance)
        for number in items
        if rough.tolerance < number < UNITS - rough.tolerance
    ]
    fits = sum(rounded(number) is not None for number in stated_numbers)
    if not fits or fits < HALF * len(stated_numbers):
        return None
    found = [rounded(float(number)) for number in numbers]
    meant = [
        float(number) if value is None else value
        for number, value in zip(numbers, found, strict=True)
    ]
    moved = float(np.sqrt(np.mean([(a - b) ** 2 for a, b in zip(meant, numbers, strict=True)])))
    factors = np.array([1.0 if value is None else LIKELY for value in found])
    return LikelyNumbers(meant, factors, moved) if moved else None
