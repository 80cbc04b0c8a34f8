"""The lattice on which most measures of a part lie, where a picture tells them only roughly.

Designers choose round numbers, though not all of a part's are: some follow from others, and the
longest extent need not be one.  Programs place lines on quarters of a pixel, alike in two views,
so that no view tells where they belong.  Where more measures are multiples of one step than chance
would have it, these are taken to be.  The others stay as they were read, and what is near a
multiple by chance moves by no more than it was unknown.  Such a lattice makes measures better, and
certifies none: only :mod:`gaussiancad_core.coordinates.design_step` does that.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.special import bdtrc

from gaussiancad_core.coordinates.design_step import ROUND_MM
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE, UNITS

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]

_REACHES, _FARTHEST = (1.5, 3.0, 5.0), 0.25
"""Times the noise by which a number may miss a multiple, and tolerances at most: lines on quarters
of a pixel miss by an eighth, and the end of the part that they are counted from by another."""

_ROUGHEST = 0.6
"""The same in tolerances where the noise is large: lines on whole pixels miss by half of one."""

_FEWEST_STEPS, _MOST_STEPS, _HALVES = 4.0, 600.0, 0.5
"""Steps along the longest extent, and by how many candidates differ."""

_DENSEST = 0.5
"""Share of all numbers that lie within reach of a multiple, at most."""

_CHANCE = 1e-4
"""Probability at which so many numbers fit by chance, over all steps and reaches tried."""

_TRIED, _ROUNDS = 8, 6
"""Likeliest steps that are fitted to the numbers, and times that each is."""

_WIDEST = 0.2
"""Share of a step within which numbers tell it exactly, at most."""

_NEARBY = 1.0 / 12.0
"""Share of a step within which a number is a multiple at most, once the lattice is told."""

_FEWEST = 7
"""Numbers that tell a lattice, at least: fewer are round by chance too easily."""

_AT_END = 0.5
"""How firmly an axis begins at a multiple, against one number that is one."""

_EXACT = 1e-3
"""Shares of the tolerance up to which numbers are multiples already."""

LIKELY = 100.0
"""Factor of the weight of a number that most likely is a multiple: equations may still move it."""


@dataclass(frozen=True)
class Roughness:
    """How roughly numbers are known.

    Attributes:
        tolerance: units by which one may be off.
        noise: units by which they are, at the mean; 0 where that is not known.
        millimetre: units, as far as the scale is known; 0 where it is not.
    """

    tolerance: float
    noise: float
    millimetre: float = 0.0

    @property
    def farthest(self) -> float:
        """Units by which a number may miss a multiple, at most."""
        most = min(_REACHES[-1] * self.noise, _ROUGHEST * self.tolerance)
        return max(_FARTHEST * self.tolerance, most)


@dataclass(frozen=True)
class Lattice:
    """Multiples of a step, on each axis counted from a beginning of its own.

    Attributes:
        step: units.
        begins: (4,) units, of each axis and of the radii.
        reach: units by which a number may miss a multiple.
    """

    step: float
    begins: tuple[float, ...]
    reach: float


@dataclass(frozen=True)
class LikelyNumbers:
    """Numbers as they most likely were meant.

    Attributes:
        numbers: units.
        factors: (n,) of their weights.
        moved: root mean square of how far those moved that are multiples now, units.
    """

    numbers: list[float]
    factors: Floats
    moved: float


def likely_numbers(
    numbers: Floats,
    values: Mapping[Axis, Sequence[int]],
    circles: Sequence[tuple[Axis, int, int, int]],
    rough: Roughness,
) -> LikelyNumbers | None:
    """What numbers were meant to be, if most of them lie on a lattice, and not exactly so.

    Args:
        numbers: (n,) coordinates from 0 and radii, units.
        values: places of each axis' values among the numbers.
        circles: normal, and places of both coordinates of the centre and of the radius.
        rough: how roughly they are known.
    """
    lattice = fitted_lattice(independent(numbers, values, circles, rough.tolerance), rough)
    if lattice is None:
        return None
    group = np.zeros(len(numbers), dtype=np.int64)
    for axis, places in values.items():
        group[list(places)] = axis.value
    for normal, x, y, radius in circles:
        group[[x, y]] = IN_PLANE[normal]
        group[radius] = len(Axis)
    neighbour = numbers - np.array(lattice.begins)[group]
    multiples = lattice.step * np.round(neighbour / lattice.step)
    far = min(_REACHES[-1] * rough.noise, rough.farthest, _NEARBY * lattice.step)
    fits = np.abs(neighbour - multiples) <= max(lattice.reach, far)
    moved = float(np.sqrt(np.mean((neighbour - multiples)[fits] ** 2))) if fits.any() else 0.0
    if moved <= _EXACT * rough.tolerance:
        return None
    likely = np.where(fits, multiples, neighbour)
    return LikelyNumbers(likely.tolist(), np.where(fits, LIKELY, 1.0), moved)


def fitted_lattice(groups: Sequence[Sequence[float]], rough: Roughness) -> Lattice | None:
    """The lattice that numbers lie on, or None where none is told.

    Args:
        groups: coordinates of each axis that do not follow from each other, and at last radii;
            units, the longest extent is ``UNITS``.
        rough: how roughly they are known.
    """
    numbers = np.array([number for this_groups in groups for number in this_groups])
    of = np.array(
        [index for index, this_groups in enumerate(groups) for _ in this_groups], dtype=np.int64
    )
    # The ends of the longest extent fit every step.
    stated = (numbers > rough.tolerance) & (numbers < UNITS - rough.tolerance)
    numbers, of = numbers[stated], of[stated]
    if len(numbers) < _FEWEST or not rough.noise:
        return None
    any_step = UNITS / np.arange(_FEWEST_STEPS, _MOST_STEPS + _HALVES, _HALVES)
    # Most parts are designed in these: they are tried by themselves, against less of a chance.
    round_steps = np.array(ROUND_MM) * rough.millimetre
    tried = (
        _likeliest(numbers, of, len(groups), values, rough) for values in (any_step, round_steps)
    )
    return min(tried, key=lambda pair: pair[0])[1]


def _likeliest(
    numbers: Floats, of: Ints, groups: int, steps: Floats, rough: Roughness
) -> tuple[float, Lattice | None]:
    """The lattice of one of the steps that numbers are least likely to lie on by chance, and how
    likely that is, over all steps and reaches tried."""
    best: tuple[float, Lattice | None] = (_CHANCE, None)
    if not steps.all():
        return best
    farthest = rough.farthest
    for share in _REACHES:
        reach = min(share * rough.noise, farthest)
        this_step = steps[2.0 * reach / steps <= _DENSEST]
        chances = _by_chance(numbers[None, :], this_step, reach)
        for index in np.argsort(chances, kind="stable")[:_TRIED]:
            step = float(this_step[index])
            wide = max(reach, min(_REACHES[-1] * rough.noise, farthest, _WIDEST * step))
            fitted = _fitted(numbers, of, groups, step, wide)
            if fitted is None:
                continue
            step, begins = fitted
            lattice = Lattice(_dividing(step, reach), begins, reach)
            neighbour = numbers - np.array(lattice.begins)[of]
            (chance,) = _by_chance(neighbour[None, :], np.array([lattice.step]), reach)
            chance *= len(this_step) * len(_REACHES)
            if chance < best[0]:
                best = float(chance), lattice
    return best


def independent(
    numbers: Floats,
    values: Mapping[Axis, Sequence[int]],
    circles: Sequence[tuple[Axis, int, int, int]],
    tolerance: float,
) -> list[list[float]]:
    """Coordinates of each axis, and radii, that do not follow from others.

    What is shown twice is no further evidence, nor are the sides of circles, nor what lies as far
    from one end of the part as another measure does from the other.
    """
    near = tolerance / 2.0
    known: list[float] = []

    def distinct(candidates: Sequence[float], extent: float) -> list[float]:
        found = []
        for number in sorted(candidates):
            if all(min(abs(number - k), abs(extent - number - k)) > near for k in known):
                found.append(number)
                known.append(number)
        return found

    groups = []
    for axis, places in values.items():
        items = [
            (float(numbers[centre]), float(numbers[radius]))
            for normal, *both, radius in circles
            for index, centre in zip(IN_PLANE[normal], both, strict=True)
            if index == axis.value
        ]
        sides = [centre + side * radius for centre, radius in items for side in (-1.0, 1.0)]
        levels = [float(numbers[place]) for place in places]
        extent = max(levels, default=0.0)
        free = [level for level in levels if all(abs(level - side) > near for side in sides)]
        groups.append(distinct([*free, extent, *(centre for centre, _ in items)], extent))
    groups.append(distinct([float(numbers[radius]) for *_, radius in circles], np.inf))
    return groups


def _by_chance(numbers: Floats, steps: Floats, reach: float) -> Floats:
    """(n,) probability that at least as many random numbers fit each step.

    Args:
        numbers: (1, m) units.
        steps: (n,) units.
        reach: units.
    """
    steps = steps[:, None]
    fits = (np.abs(numbers - steps * np.round(numbers / steps)) <= reach).sum(axis=1)
    share = np.minimum(2.0 * reach / steps[:, 0], 1.0)
    return np.where(fits > 0, bdtrc(fits - 1.0, numbers.shape[1], share), 1.0)


def _fitted(
    numbers: Floats, of: Ints, groups: int, step: float, reach: float
) -> tuple[float, tuple[float, ...]] | None:
    """The step and the beginnings that the numbers near multiples tell by least squares."""
    begins = np.zeros(groups)
    for _ in range(_ROUNDS):
        adjacent = numbers - begins[of]
        multiples = np.round(adjacent / step)
        near = np.abs(adjacent - step * multiples) <= reach
        count = int(near.sum())
        if count < groups:
            return None
        columns = np.zeros((count + groups - 1, groups))
        columns[:count, 0] = multiples[near]
        # Radii are counted from nought.
        rows = np.flatnonzero(of[near] < groups - 1)
        columns[rows, 1 + of[near][rows]] = 1.0
        columns[count:, 1:] = _AT_END * np.eye(groups - 1)
        wanted = np.append(numbers[near], np.zeros(groups - 1))
        solution = np.linalg.lstsq(columns, wanted, rcond=None)[0]
        step = float(solution[0])
        begins[:-1] = np.clip(solution[1:], -reach, reach)
    return step, tuple(begins.tolist())


def _dividing(step: float, reach: float) -> float:
    """The step that the longest extent is a multiple of, or half of one more, if it is as near."""
    count = round(2.0 * UNITS / step) / 2.0
    return UNITS / count if abs(UNITS - count * step) <= reach else step
