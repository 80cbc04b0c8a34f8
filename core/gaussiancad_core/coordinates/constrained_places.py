"""What a sheet's numbers make known: coordinates and radii that follow from them.

A coordinate is known if numbers lead to it from the end that its axis is counted from: one at a
time, as a chain, or by the sides of circles.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import null_space

from gaussiancad_core.coordinates.linear_constraints import Linear, Numbers
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE


@dataclass(frozen=True)
class ConstrainedPlaces:
    """Coordinates and radii that follow from numbers on the sheet.

    Attributes:
        values: coordinates along each axis, of planes and of circles' centres, in the unit of
            whoever holds them.
        radii: of circles.
        offset: by how much what numbers say was drawn otherwise, at most.
        digit: the last one that numbers have.
    """

    values: Mapping[Axis, tuple[float, ...]]
    radii: tuple[float, ...]
    offset: float
    digit: float

    def scaled(self, factor: float) -> "ConstrainedPlaces":
        """The same in another unit."""
        return ConstrainedPlaces(
            {axis: tuple(factor * at for at in values) for axis, values in self.values.items()},
            tuple(factor * radius for radius in self.radii),
            factor * self.offset,
            factor * self.digit,
        )


def constrained_places(
    numbers: tuple[Numbers, Numbers],
    of: tuple[Mapping[Axis, Sequence[int]], Sequence[tuple[Axis, int, int, int]]],
    equations: tuple[Sequence[Linear], Sequence[Linear]],
    digit: float,
) -> ConstrainedPlaces:
    """Which coordinates and radii follow from numbers on the sheet.

    Args:
        numbers: as they are taken to be, and as they were drawn.
        of: places of each axis' values among the numbers, and of circles' centres and radii.
        equations: between the numbers, as the lines and as the sheet's dimensions have them; those
            that do not hold are left out.
        digit: the last one that the sheet's numbers have, units.
    """
    (taken, drawn), (values, circles) = numbers, of
    relations, said = ([linear for linear in group if linear.holds(taken)] for group in equations)
    offset = max((abs(linear.at(drawn)[0]) for linear in said), default=0.0)
    rows = np.zeros((len(relations) + len(said), len(taken)))
    for row, relation in enumerate((*relations, *said)):
        for column, factor in relation.terms:
            rows[row, column] += factor
    left_open = null_space(rows) if len(rows) else np.eye(len(taken))
    radii = {float(taken[number]) for *_, number in circles if _is_still(left_open[number])}
    found = {}
    for axis in Axis:
        columns = [*values.get(axis, ()), *_centres(circles, axis)]
        begin = min(values.get(axis, ()), key=lambda column: drawn[column], default=None)
        found[axis] = tuple(
            sorted(
                {
                    float(taken[column])
                    for column in columns
                    if begin is not None and _is_still(left_open[column] - left_open[begin])
                }
            )
        )
    return ConstrainedPlaces(found, tuple(sorted(radii)), offset, digit)


def _is_still(component: Numbers) -> bool:
    return bool(np.abs(component).max(initial=0.0) <= COMPUTED)


def _centres(circles: Sequence[tuple[Axis, int, int, int]], axis: Axis) -> list[int]:
    """Columns of the coordinates that circles' centres have along an axis."""
    return [
        centre
        for normal, x, y, _ in circles
        for index, centre in zip(IN_PLANE[normal], (x, y), strict=True)
        if Axis(index) is axis
    ]
