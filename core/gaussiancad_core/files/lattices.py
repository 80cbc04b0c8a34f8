"""The longest step that numbers are multiples of, each axis counted from a beginning of its own."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

_SINGLE = 1.2e-7
"""Share of a number by which it may be off as PDF's readers have it, in single precision: two
units in the last place, as matrices may have been applied before."""

_SUBDIVIDED, _BETTER = (2, 3, 5), 0.1
"""Parts of a step on which numbers lie who miss the step, and share of all that do, from which the
parts are the step: 97 of 100 are on the grid of most files."""

_AT_ONCE = 120
"""Numbers of an axis that are asked for how long the step is exactly, all along it."""

_FIRST, _LIKELY = 24, 0.45
"""Numbers of an axis, neighbours, that are asked before all others, and share of those wanted that
has to be on the grid among them: it is told sooner, as they are close together."""

_CANDIDATES, _PARTNERS = 32, 6
"""Steps that are tried, and neighbours by length with which each distance is compared."""

_GUESSED = 5e-3
"""Share by which common measures of distances miss the step, and by which they are one guess."""

_REMAINDER = 1e-4
"""Share of a distance under which what is left of it is nothing."""

_FITS = 0.5
"""Share of distances that are multiples of a guess, at least: distances have two ends."""

_SHORT = 15
"""Steps up to which a distance tells it though the guess is rough."""

_PER_TURN = 6.0
"""Frequencies that are tried for each at which the farthest number is a turn ahead."""

_MOST_STEPS = 1e6
"""Finest steps from the median of numbers to the farthest that are asked: half a sheet of 20,000 px
has no more.  Those off the sheet would ask for any number of frequencies."""

_TOLD = 0.5
"""Turns that the farthest of the first numbers may be off when the step is told by them."""

_CLOSER = 3
"""Times that the frequency is looked for twenty times as closely, to a ten-thousandth of a turn."""

_DECIMALS = range(-3, 7)
"""Of numbers in files: thousands to millionths of a unit."""


@dataclass(frozen=True)
class Fit:
    """How well numbers lie on a grid.

    Attributes:
        near: steps that a number may be off.
        least: share of the numbers that are not.
        within: what a number may be off, however long the step is.
    """

    near: float
    least: float
    within: float

    def share(self, places: Sequence[Floats], step: float) -> float:
        """Share of numbers that are multiples of a step, each axis from where most of its own are.

        Args:
            places: for each axis numbers in order.
            step: of the grid.
        """
        near = min(self.near, self.within / step)
        on = total = 0
        for place in places:
            if not len(place):
                continue
            turns = place / step
            off = _off_turns(turns - np.angle(np.exp(2j * np.pi * turns).sum()) / (2.0 * np.pi))
            # Those that are on no grid moved the mean.
            off = _off_turns(off - _median(off))
            on += int((np.abs(off) <= near + _SINGLE * np.abs(turns)).sum())
            total += len(place)
        return on / total if total else 0.0


def common_step(places: Sequence[Floats], finest: float, fit: Fit) -> float:
    """The longest step that most of some numbers are multiples of; 0 where there is none.

    Args:
        places: for each axis numbers in order, no two the same.
        finest: step that is looked for.
        fit: of the numbers.
    """
    near = [
        place[np.abs(place - place[len(place) // 2]) <= _MOST_STEPS * finest]
        for place in places
        if place.size
    ]
    stated = [item for item in near if len(item) > 1]
    some = [item[:: -(-len(item) // _AT_ONCE)] for item in stated]
    first = [item[:_FIRST] for item in stated]
    for guess in _guesses(stated, finest):
        rough = _refined(first, guess, _GUESSED)
        if fit.share(first, rough) < _LIKELY * fit.least:
            continue
        step = _refined(some, rough, min(_GUESSED, _TOLD * rough / _widest(first)))
        share = fit.share(places, step)
        if share >= fit.least and all(
            fit.share(places, step / parts) - share < _BETTER for parts in _SUBDIVIDED
        ):
            return step
    return 0.0


def _off_turns(turns: Floats) -> Floats:
    """(n,) turns from the nearest whole one."""
    return turns - np.round(turns)


def decimal_step(numbers: Floats) -> float:
    """The unit of the last decimal that any of some numbers has; 0 where that is finer than files
    write, and of no numbers."""
    for decimals in _DECIMALS if len(numbers) else ():
        step = 10.0**-decimals
        turns = numbers / step
        if (np.abs(turns - np.round(turns)) <= 1e-6 + _SINGLE * np.abs(turns)).all():
            return step
    return 0.0


def _guesses(places: Sequence[Floats], finest: float) -> list[float]:
    """Steps that may be it, about, longest first: what distances have in common."""
    apart = np.sort(np.concatenate([np.empty(0), *(np.diff(place) for place in places)]))
    apart = apart[apart >= finest]
    if not len(apart):
        return []
    pairs = [apart]
    for ahead in range(1, min(_PARTNERS, len(apart) - 1) + 1):
        pairs.append(_common_measures(apart[ahead:], apart[:-ahead], finest))
    found = np.concatenate(pairs)
    found = found[found >= finest]
    bins, counts = np.unique(np.round(np.log(found) / _GUESSED), return_counts=True)
    often = np.sort(bins[np.argsort(-counts, kind="stable")[:_CANDIDATES]])[::-1]
    return [step for step in np.exp(often * _GUESSED).tolist() if _may_be(apart, step)]


def _common_measures(longer: Floats, shorter: Floats, finest: float) -> Floats:
    """(n,) the greatest common measure of pairs of distances (Euclid), 0 where it is too small."""
    nothing = np.maximum(0.5 * finest, _REMAINDER * longer)
    a, b = longer.copy(), shorter.copy()
    while (b > nothing).any():
        going = b > nothing
        rest = np.where(going, a - np.round(a / np.where(going, b, 1.0)) * b, 0.0)
        a, b = np.where(going, b, a), np.where(going, np.abs(rest), b)
    return np.where(a > nothing, a, 0.0)


def _may_be(apart: Floats, step: float) -> bool:
    """Whether those distances that tell are multiples of a guess."""
    turns = apart / step
    turns = turns[turns <= _SHORT + 0.5]
    near = np.abs(turns - np.round(turns)) <= 0.1
    return not len(turns) or bool(near.mean() >= _FITS)


def _widest(places: Sequence[Floats]) -> float:
    """How far apart the numbers of an axis are, at most."""
    return max(float(np.ptp(place)) for place in places)


def _refined(places: Sequence[Floats], guess: float, off: float) -> float:
    """The step near a guess on which the numbers lie best.

    Args:
        places: for each axis numbers in order.
        guess: at the step.
        off: share of it by which it may be off.
    """
    count = int(np.ceil(2.0 * off * _widest(places) / guess * _PER_TURN)) + 3
    tried = np.linspace(1.0 - off, 1.0 + off, count) / guess
    best = _best(places, tried)
    half = float(tried[1] - tried[0])
    for _ in range(_CLOSER):
        best = _best(places, np.linspace(best - half, best + half, 41))
        half /= 20.0
    return 1.0 / best


def _best(places: Sequence[Floats], frequencies: Floats) -> float:
    """The one of even frequencies at which the unit vectors of all numbers add up to the longest.

    A frequency is a coarse step and a fine one: of as many as there are, twice the root are turned.
    """
    fine = int(np.ceil(np.sqrt(len(frequencies))))
    coarse = frequencies[::fine]
    steps = frequencies[:fine] - frequencies[0]
    length = np.zeros((len(coarse), fine))
    for place in places:
        away = 2j * np.pi * (place - place[0])
        turned = np.exp(np.outer(steps, away)).T
        length += np.abs(np.exp(np.outer(coarse, away)) @ turned)
    return float(frequencies[int(length.ravel()[: len(frequencies)].argmax())])


def _median(numbers: Floats) -> float:
    """That of numpy loads more than there is to a lattice."""
    ordered = np.sort(numbers)
    return float(ordered[(len(ordered) - 1) // 2] + ordered[len(ordered) // 2]) / 2.0
