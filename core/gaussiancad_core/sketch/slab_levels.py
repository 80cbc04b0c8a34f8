"""The levels between which slabs lie: where views from beside draw lines across an axis."""

from collections.abc import Iterable

from gaussiancad_core.coordinates.grid_tolerances import LEAN, SHORTEST_LEVEL
from gaussiancad_core.sketch.plane_lines import PlaneLine

MOST = 20
"""Levels at most: those with the longest lines."""

_ONE = 0.9
"""Grid steps between lines of one level at most."""


def find_levels(
    neighbours: Iterable[tuple[int, list[PlaneLine]]], size: float, grid: float
) -> tuple[float, ...]:
    """Coordinates along an axis, in mm, the first 0 and the last the part's extent.

    Args:
        neighbours: of each view from beside, which of its plane's coordinates runs along the axis,
            and its lines.
        size: mm of the part along the axis.
        grid: mm of a step of the sheet's coordinates.
    """
    stated = [(0.0, 1.0), (size, 1.0)]
    for along, lines in neighbours:
        stated += [
            (float(line.points[:, along].mean()), line.length)
            for line in lines
            if line.constant(LEAN * grid) == along and line.length > SHORTEST_LEVEL * grid
        ]
    stated.sort()
    groups = [[stated[0]]]
    for pair in stated[1:]:
        if pair[0] - groups[-1][-1][0] <= _ONE * grid:
            groups[-1].append(pair)
        else:
            groups.append([pair])
    if len(groups) > MOST:
        by_length = sorted(groups[1:-1], key=lambda g: -sum(weight for _, weight in g))
        kept = {id(g) for g in by_length[: MOST - 2]}
        groups = [g for k, g in enumerate(groups) if k in (0, len(groups) - 1) or id(g) in kept]
    means = [sum(at * weight for at, weight in g) / sum(weight for _, weight in g) for g in groups]
    # What is within a step of the part's ends is these.
    return (0.0, *means[1:-1], size)
