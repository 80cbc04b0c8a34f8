"""Equations between the coordinates that lines show and the circles that lie at them."""

from collections.abc import Sequence

from gaussiancad_core.coordinates.linear_constraints import Linear
from gaussiancad_core.geometry.tolerances import TELLING
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE


def circle_relations(
    observed: Sequence[float],
    values: dict[Axis, list[int]],
    circles: Sequence[tuple[Axis, int, int, int]],
    tolerance: float,
) -> list[Linear]:
    """Equations between values and circles that lie together.

    Args:
        observed: numbers, units.
        values: places of each axis' values among the numbers.
        circles: normal, and places of both coordinates of the centre and of the radius.
        tolerance: units within which numbers are taken to be equal.
    """
    relations: list[Linear] = []
    centres: dict[Axis, list[int]] = {axis: [] for axis in Axis}
    for normal, x, y, radius in circles:
        for index, centre in zip(IN_PLANE[normal], (x, y), strict=True):
            axis = Axis(index)
            candidates: list[list[tuple[int, float]]] = [[(centre, 1.0)]]
            if observed[radius] > TELLING * tolerance:
                candidates.append([(centre, 1.0), (radius, -1.0)])
                candidates.append([(centre, 1.0), (radius, 1.0)])
            for terms in candidates:
                at = sum(factor * observed[column] for column, factor in terms)
                for value in values[axis]:
                    if abs(observed[value] - at) <= tolerance:
                        relations.append(Linear((*terms, (value, -1.0))))
            for other in centres[axis]:
                if abs(observed[other] - observed[centre]) <= tolerance:
                    relations.append(Linear(((centre, 1.0), (other, -1.0))))
                    break
            else:
                centres[axis].append(centre)
    return relations
