"""The plan of a turned part that no view looks along: circles about its axis.

What runs along the axis in a view from beside is the side of a cylinder, or of a bore.
"""

from collections.abc import Iterable, Iterator, Sequence

from gaussiancad_core.coordinates.grid_tolerances import LEAN, NEAR, SHORTEST_LEVEL
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.hole_depths import NotedHole
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.sketch.plane_lines import PlaneLine, whole_circle

Point = tuple[float, float]


def middle_of(axis: Axis, size: Sequence[float]) -> Point:
    """mm in the plane across an axis, of the part's middle.

    Args:
        axis: that the part is turned about.
        size: (3,) mm of the part.
    """
    first, second = (size[k] / 2.0 for k in IN_PLANE[axis])
    return first, second


def circles_about(
    axis: Axis,
    neighbours: Iterable[tuple[int, int, Sequence[PlaneLine]]],
    holes: Iterable[NotedHole],
    size: Sequence[float],
    grid: float,
) -> list[PlaneLine]:
    """The circles of a turned part in the plane across its axis, the largest as wide as the part.

    Args:
        axis: that it is turned about.
        neighbours: of each view from beside, which coordinate of the plan and of its plane it has
            in common with the plan, and its lines.
        holes: of which notes speak.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
    """
    middle = middle_of(axis, size)
    widest = min(middle)
    radii = [
        step.diameter / 2.0
        for hole in holes
        if role_plane(hole.role).normal is axis
        for step in hole.steps
    ]
    for column, across, lines in neighbours:
        radii += [abs(at - middle[column]) for at in _sides(lines, across, grid)]
    near = NEAR * grid
    kept = [widest]
    for radius in radii:
        if near < radius < widest and all(abs(radius - value) > near for value in kept):
            kept.append(radius)
    return [whole_circle(Circle(middle, value), False) for value in kept]


def _sides(lines: Sequence[PlaneLine], across: int, grid: float) -> Iterator[float]:
    """Where lines run along the axis, the longest first."""
    for plane_line in sorted(lines, key=lambda line: -line.length):
        if plane_line.constant(LEAN * grid) == across and plane_line.length > SHORTEST_LEVEL * grid:
            yield float(plane_line.points[:, across].mean())
