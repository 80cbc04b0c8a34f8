"""The step that a part was designed in, where its coordinates tell one.

Designers choose round numbers.  If nearly all coordinates and radii of a part are multiples of one
step, by far more closely than chance would have it, they are taken to be: what a picture tells to a
tenth of a pixel is then known exactly.  The scale need not be known: the step divides the part's
longest extent.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import comb

import numpy as np

from gaussiancad_core.model.projection_planes import UNITS

_MOST_STEPS = 400
"""Steps along the longest extent, at most."""

_FEWEST_STEPS = 4

_NEAR = 0.12
"""Share of a step by which a number may miss a multiple of it, at most."""

_PRECISE = (0.3, 0.6)
"""The same in tolerances of the views; the larger one where the smaller tells no step: there are
programs that place lines on whole pixels."""

_SHARE = 0.85
"""Share of the numbers that fit, at least; those of intersections need not."""

_CHANCE = 1e-7
"""Probability at which so many numbers fit by chance, over all steps that are tried."""

ODD = 1e-4
"""Share of the step from which a number is no multiple of it."""

ROUND_MM, _ROUND_CHANCE = (10.0, 5.0, 2.0, 1.0, 0.5), 1e-5
"""Steps that most parts are designed in, and the same probability for these alone."""


@dataclass(frozen=True)
class NominalStep:
    """The step of a design.

    Attributes:
        length: units.
        reach: units by which a number may miss a multiple of it.
        moved: units by which numbers missed theirs, at most, as far as it was asked.
    """

    length: float
    reach: float
    moved: float = 0.0

    def multiple(self, number: float) -> float | None:
        """The multiple that a number stands for, or None if it is none."""
        multiple = self.length * round(number / self.length)
        return multiple if abs(number - multiple) <= self.reach else None

    def odd(self, numbers: Iterable[float], extent: float) -> int:
        """How many numbers are no multiples; those that are one, or mirror images, count once."""
        found: list[float] = []
        for number in numbers:
            if abs(number - self.length * round(number / self.length)) > ODD * self.length:
                images = (number, extent - number) if extent else (number,)
                apart = (abs(image - other) for image in images for other in found)
                if min(apart, default=self.length) > self.reach:
                    found.append(number)
        return len(found)

    def moving(self, numbers: Iterable[float]) -> "NominalStep":
        """The step, knowing by how much further numbers moved to become its multiples."""
        stated = [(float(number), self.multiple(float(number))) for number in numbers]
        moved = [abs(number - value) for number, value in stated if value is not None]
        return replace(self, moved=max([*moved, self.moved]))


def designed_scale(step: NominalStep | None, stated: tuple[float, float], scale: float) -> float:
    """Units per mm at which an extent that was told is what it was told, in steps.

    The step divides the longest extent, by which units are counted.  Where another one was told,
    the longest one was read a fraction of a pixel beside: all measures would be off by as much.

    Args:
        step: of the design; None where none is told.
        stated: the extent in units as it was read, and in mm.
        scale: units per mm, by the longest extent.
    """
    units, length = stated
    meant = step.multiple(units) if step is not None else None
    return scale if meant is None else meant / length


def nominal_step(
    numbers: Sequence[float], tolerance: float, millimetre: float
) -> NominalStep | None:
    """The longest step that the numbers are multiples of; None where none is told.

    Args:
        numbers: distinct coordinates and radii, units; the longest extent is ``UNITS``.
        tolerance: units by which a number may be off.
        millimetre: units, as far as the scale is known: a round step needs fewer numbers to tell. 0
            where it is not.
    """
    stated = np.array([number for number in numbers if _is_informative(number, tolerance)])
    if not len(stated):
        return None
    any_step = [UNITS / count for count in range(_FEWEST_STEPS, _MOST_STEPS + 1)]
    round_steps = [length * millimetre for length in ROUND_MM] if millimetre else []
    for precise in _PRECISE:
        for lengths, chance in (
            (any_step, _CHANCE),
            (round_steps, _ROUND_CHANCE),
        ):
            for length in lengths:
                reach = min(_NEAR * length, precise * tolerance)
                off = np.abs(stated - length * np.round(stated / length))
                fits = int((off <= reach).sum())
                share = 2.0 * reach / length
                if fits >= _SHARE * len(stated) and (
                    _by_chance(fits, len(stated), share) * len(lengths) < chance
                ):
                    return NominalStep(length, reach)
    return None


def _is_informative(number: float, tolerance: float) -> bool:
    """Whether a number tells anything: the ends of the longest extent fit every step."""
    return tolerance < number < UNITS - tolerance


def _by_chance(fits: int, count: int, share: float) -> float:
    """Probability that at least so many of a count of random numbers fit a step."""
    return sum(
        comb(count, k) * share**k * (1.0 - share) ** (count - k) for k in range(fits, count + 1)
    )
