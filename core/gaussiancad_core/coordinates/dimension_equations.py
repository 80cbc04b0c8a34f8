"""Dimensions as equations between the coordinates that lines show.

A number that is nearly what its lines show is what they were meant to be; one that differs by more
was misread, rounded, or belongs to other lines, and adds no equation.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from gaussiancad_core.coordinates.linear_constraints import Linear, Numbers, solved
from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
)
from gaussiancad_core.geometry.tolerances import SAME_READ
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

_OWN = 0.1
"""How much it counts how near that is, against how well it fits the number."""

_FIRMLY = 1e3
"""Factor of the weight of a coordinate or radius that a number tells."""


def dimension_relations(
    observed: Sequence[float],
    values: Mapping[Axis, Sequence[int]],
    circles: Sequence[tuple[Axis, int, int, int]],
    stated: DimensionConstraints,
    tolerance: float,
) -> list[Linear]:
    """Equations between values, centres and radii that numbers tell.

    Args:
        observed: numbers as read, units.
        values: places of each axis' values among them.
        circles: normal, and places of both coordinates of the centre and of the radius.
        stated: by the sheet, units.
        tolerance: units by which a reading may be off.
    """
    found: list[Linear] = []
    for length in stated.lengths:
        if isinstance(length, RadiusDimension):
            found += _radii(observed, circles, length, stated.reach, tolerance)
            continue
        places = list(_places(observed, values, circles, length.axis))
        near = [
            [(at, terms) for at, terms in places if abs(at - end) <= SAME_READ * tolerance]
            for end in (length.low, length.high)
        ]
        pairs = [
            (_misfit(length, low[0], high[0]), (*high[1], *_negative(low[1])))
            for low, high in product(*near)
            if abs(high[0] - low[0] - length.value) <= stated.reach
        ]
        if pairs:
            found.append(Linear(min(pairs, key=lambda pair: pair[0])[1], -length.value))
    return found


Terms = tuple[tuple[int, float], ...]


@dataclass(frozen=True, eq=False)
class WithDimensions:
    """Numbers as the sheet says, as far as it says them.

    Attributes:
        numbers: units.
        drawn: the same without what the sheet says.
        factors: (n,) of their weights: what is told stays.
        kept: equations of what the sheet says that contradict nothing.
        begins: units by which the end that an axis is counted from was drawn beside its place: all
            that was read moves by as much towards it.
    """

    numbers: list[float]
    drawn: Numbers
    factors: Numbers
    kept: list[Linear]
    begins: dict[Axis, float]


def with_dimensions(
    observed: Sequence[float],
    of: tuple[Mapping[Axis, Sequence[int]], Sequence[tuple[Axis, int, int, int]]],
    equations: tuple[Sequence[Linear], Sequence[Linear]],
    far: float,
) -> WithDimensions:
    """Move numbers to what the sheet says.

    A line is drawn as far beside its place as any other, be it short or long, and so is the end of
    the part that all are counted from: where lines disagree with their numbers alike, it is the end
    that is off, for the others, too.  Numbers on the sheet are rounded: chains of them need not add
    up, and none may undo what the lines show to be one.

    Args:
        observed: as read, units.
        of: places of each axis' values among the numbers, and of circles' centres and radii.
        equations: between the numbers, as the lines and as the sheet's dimensions have them.
        far: units by which a number may move at most.
    """
    (values, circles), (relations, said) = of, equations
    even = [1.0] * len(observed)
    drawn = numbers = solved(observed, even, relations, far)
    sure = [relation for relation in relations if relation.holds(drawn)]
    kept: list[Linear] = []
    together = solved(observed, even, [*sure, *said], far)
    if all(linear.holds(together) for linear in (*sure, *said)):
        numbers, kept = together, list(said)
    else:
        for this_linear in said:
            tried = solved(observed, even, [*sure, *kept, this_linear], far)
            if all(other.holds(tried) for other in (*sure, *kept, this_linear)):
                numbers = tried
                kept.append(this_linear)
    begins = {
        axis: float(numbers[first]) - observed[first]
        for axis, places in values.items()
        if places
        for first in [min(places, key=lambda at: observed[at])]
    }
    numbers = _from_their_ends(numbers, values, circles, begins)
    factors = np.ones(len(numbers))
    factors[list({column for item in kept for column, _ in item.terms})] = _FIRMLY
    return WithDimensions(numbers.tolist(), drawn, factors, kept, begins)


def _from_their_ends(
    numbers: Numbers,
    values: Mapping[Axis, Sequence[int]],
    circles: Sequence[tuple[Axis, int, int, int]],
    begins: Mapping[Axis, float],
) -> Numbers:
    """The numbers with each axis beginning where it was read to begin."""
    moved = numbers.copy()
    for axis, places in values.items():
        moved[list(places)] -= begins.get(axis, 0.0)
    for normal, x, y, _ in circles:
        moved[[x, y]] -= [begins.get(Axis(index), 0.0) for index in IN_PLANE[normal]]
    return moved


def _places(
    observed: Sequence[float],
    values: Mapping[Axis, Sequence[int]],
    circles: Sequence[tuple[Axis, int, int, int]],
    axis: Axis,
) -> Iterator[tuple[float, Terms]]:
    """What a dimension along an axis may begin or end at: values first, circles' centres, sides."""
    for column in values[axis]:
        yield observed[column], ((column, 1.0),)
    for normal, x, y, radius in circles:
        for index, centre in zip(IN_PLANE[normal], (x, y), strict=True):
            if index == axis.value:
                yield observed[centre], ((centre, 1.0),)
                for side in (-1.0, 1.0):
                    at = observed[centre] + side * observed[radius]
                    yield at, ((centre, 1.0), (radius, side))


def _misfit(length: LengthDimension, low: float, high: float) -> float:
    away = abs(low - length.low) + abs(high - length.high)
    return abs(high - low - length.value) + _OWN * away


def _negative(terms: Terms) -> Terms:
    return tuple((column, -factor) for column, factor in terms)


def _radii(
    observed: Sequence[float],
    circles: Sequence[tuple[Axis, int, int, int]],
    this_radius: RadiusDimension,
    reach: float,
    tolerance: float,
) -> Iterator[Linear]:
    """Of a circle, and of all that are drawn as large as it: one of them has the number."""
    radii = [
        observed[radius]
        for normal, x, y, radius in circles
        if normal is this_radius.normal
        and max(
            abs(observed[x] - this_radius.centre[0]),
            abs(observed[y] - this_radius.centre[1]),
            abs(observed[radius] - this_radius.radius),
        )
        <= SAME_READ * tolerance
        and abs(observed[radius] - this_radius.value) <= reach
    ]
    if not radii:
        return
    drawn = min(radii, key=lambda radius: abs(radius - this_radius.radius))
    for normal, *_, radius in circles:
        alike = abs(observed[radius] - drawn) <= reach / 2.0
        if (
            normal is this_radius.normal
            and alike
            and abs(observed[radius] - this_radius.value) <= reach
        ):
            yield Linear(((radius, 1.0),), -this_radius.value)
