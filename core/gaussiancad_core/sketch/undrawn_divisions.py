"""Divisions of the plan that no view along the axis draws, as they lie behind what it shows.

Where hidden lines are left out, a step on the far side is seen from beside only: the ends of its
outline are upright lines there.  About the centre of a circle of the plan two such places are a
circle, else each is a straight line.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from gaussiancad_core.coordinates.grid_tolerances import LEAN, NEAR, SHORTEST_LEVEL
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sketch.plane_lines import PlaneLine, whole_circle

_MOST = 8
"""Places along a coordinate at most: with more no division is told."""


def undrawn_divisions(
    plan: Sequence[PlaneLine],
    neighbours: Sequence[tuple[int, int, Sequence[PlaneLine]]],
    size: tuple[float, float],
    grid: float,
) -> list[PlaneLine]:
    """Lines of the plan that it does not draw.

    Args:
        plan: the lines that it draws, mm.
        neighbours: of each view from beside, which coordinate of the plan and of its plane it has
            in common with the plan, and its lines.
        size: (2,) mm of the plan.
        grid: mm of a step of the sheet's coordinates.
    """
    near = NEAR * grid
    untold: list[list[float]] = [[], []]
    for column, across, lines in neighbours:
        untold[column] += _uprights(lines, across, grid)
    for column, places in enumerate(untold):
        known = [0.0, size[column], *_line_ends(plan, column)]
        untold[column] = [
            at for at in _distinct(places, near) if min(abs(at - value) for value in known) > near
        ]
    if not any(untold) or max(map(len, untold)) > _MOST:
        return []
    circles = list(_circles(plan, untold, near))
    for column in (0, 1):
        ends = [
            circle.centre[column] + side
            for circle in circles
            for side in (-circle.radius, circle.radius)
        ]
        untold[column] = [at for at in untold[column] if all(abs(at - e) > near for e in ends)]
    found = [whole_circle(circle, False) for circle in circles]
    for column, places in enumerate(untold):
        for at in places:
            points = np.array([[at, 0.0], [at, size[1 - column]]])
            found.append(PlaneLine(points if column == 0 else points[:, ::-1].copy(), False))
    return found


def _uprights(lines: Sequence[PlaneLine], across: int, grid: float) -> Iterator[float]:
    for line in lines:
        upright = line.is_visible and line.constant(LEAN * grid) == across
        if upright and line.length > SHORTEST_LEVEL * grid:
            yield float(line.points[:, across].mean())


def _line_ends(plan: Sequence[PlaneLine], column: int) -> Iterator[float]:
    """Where lines of the plan begin, end, or turn back along a coordinate."""
    for line in plan:
        yield from line.points[[0, -1], column].tolist()
        yield float(line.points[:, column].min())
        yield float(line.points[:, column].max())


def _distinct(places: Sequence[float], near: float) -> Iterator[float]:
    last = -np.inf
    for at in sorted(places):
        if at - last > near:
            yield at
            last = at


def _circles(
    plan: Sequence[PlaneLine], untold: Sequence[Sequence[float]], near: float
) -> Iterator[Circle]:
    """Circles about centres of the plan."""
    centres: list[tuple[float, float]] = []
    for line in plan:
        if line.circle is not None and all(
            np.hypot(*np.subtract(line.circle.centre, other)) > near for other in centres
        ):
            centres.append(line.circle.centre)
    for centre in centres:
        radii = [
            [
                at - centre[column]
                for at in untold[column]
                if at > centre[column]
                and min(abs(2.0 * centre[column] - at - value) for value in untold[column]) <= near
            ]
            for column in (0, 1)
        ]
        first, second = radii
        if first and second:
            # What is not as wide one way as the other is not round.
            first = [
                value for value in first if min(abs(value - other) for other in second) <= near
            ]
            second = []
        yield from (Circle(centre, value) for value in _distinct([*first, *second], near))
