"""The step that a part was designed in, where its coordinates tell one.

Designers choose round numbers.  If nearly all coordinates and radii of a part are multiples of one
step, by far more closely than chance would have it, they are taken to be: what a picture tells to a
tenth of a pixel is then known exactly.  The scale need not be known: the step divides the part's
longest extent.
"""

from collections.abc import Sequence
from math import comb

import numpy as np

from gaussiancad_core.reasoning.planes import UNITS

_MOST_STEPS = 400
"""Steps along the longest extent, at most."""

_FEWEST_STEPS = 4

_NEAR = 0.12
"""Share of a step by which a number may miss a multiple of it, at most."""

_PRECISE = 0.3
"""The same in tolerances of the views."""

_SHARE = 0.85
"""Share of the numbers that fit, at least; those of intersections need not."""

_CHANCE = 1e-7
"""Probability at which so many numbers fit by chance, over all steps that are tried."""


def nominal_step(numbers: Sequence[float], tolerance: float) -> float | None:
    """The longest step that the numbers are multiples of, in units; None where none is told.

    Args:
        numbers: distinct coordinates and radii, units; the longest extent is ``UNITS``.
        tolerance: units by which a number may be off.
    """
    told = np.array([number for number in numbers if _is_told(number, tolerance)])
    if not len(told):
        return None
    for count in range(_FEWEST_STEPS, _MOST_STEPS + 1):
        step = UNITS / count
        reach = min(_NEAR * step, _PRECISE * tolerance)
        fits = int((np.abs(told - step * np.round(told / step)) <= reach).sum())
        if fits >= _SHARE * len(told) and _by_chance(fits, len(told), 2.0 * reach / step) < _CHANCE:
            return step
    return None


def on_step(number: float, step: float, tolerance: float) -> float | None:
    """The multiple of a step that a number stands for, or None if it is none."""
    multiple = step * round(number / step)
    return multiple if abs(number - multiple) <= min(_NEAR * step, _PRECISE * tolerance) else None


def _is_told(number: float, tolerance: float) -> bool:
    """Whether a number tells anything: the ends of the longest extent fit every step."""
    return tolerance < number < UNITS - tolerance


def _by_chance(fits: int, count: int, share: float) -> float:
    """Probability that at least so many of a count of random numbers fit one of all steps."""
    tail = sum(
        comb(count, k) * share**k * (1.0 - share) ** (count - k) for k in range(fits, count + 1)
    )
    return tail * _MOST_STEPS
