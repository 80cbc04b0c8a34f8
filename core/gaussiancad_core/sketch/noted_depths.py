"""What notes say of holes along the slabs' axis: they go through, or how deep they are."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import shapely

from gaussiancad_core.coordinates.grid_tolerances import STEP
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.hole_depths import NotedHole
from gaussiancad_core.model.projection_planes import role_plane

_MOST = 6
"""Floors at most that no line draws."""


@dataclass(frozen=True)
class NotedStep:
    """A cylinder of a hole, in regions.

    Attributes:
        regions: their numbers.
        rim: those of them that reach to the circle.
        depth: mm from the face that the hole is drawn on; None where it goes through.
        looks_up: whether it is seen towards larger coordinates.
    """

    regions: tuple[int, ...]
    rim: tuple[int, ...]
    depth: float | None
    looks_up: bool


def floors(
    holes: Iterable[NotedHole], axis: Axis, levels: Sequence[float], grid: float
) -> list[float]:
    """mm along an axis at which holes may end that notes speak of, beside its levels.

    Args:
        holes: of all views.
        axis: of the slabs.
        levels: mm, from the first to the last.
        grid: mm of a step of the sheet's coordinates.
    """
    found: list[float] = []
    for depth, looks_up in sorted(_depths(holes, axis)):
        # A hole mostly begins at the face that is nearest to who looks at it.
        for face in levels if looks_up else reversed(levels):
            at = face + depth if looks_up else face - depth
            known = min(abs(at - level) for level in (*levels, *found))
            if levels[0] < at < levels[-1] and known > STEP * grid and len(found) < _MOST:
                found.append(at)
    return found


def noted_steps(
    holes: Iterable[NotedHole], axis: Axis, polygons: Sequence[shapely.Polygon], grid: float
) -> Iterator[NotedStep]:
    """The cylinders of which notes speak that have regions.

    Args:
        holes: of all views.
        axis: of the slabs.
        polygons: mm, the regions.
        grid: mm of a step of the sheet's coordinates.
    """
    for hole in holes:
        plane = role_plane(hole.role)
        if plane.normal is not axis:
            continue
        centre = shapely.Point(
            *(value * s for value, s in zip(hole.centre, plane.signs, strict=True))
        )
        within: set[int] = set()
        for step in hole.steps:
            disc = centre.buffer(step.diameter / 2.0 + STEP * grid)
            inside = {k for k, polygon in enumerate(polygons) if disc.covers(polygon)}
            items = tuple(sorted(inside - within))
            least = step.diameter / 2.0 - 2.0 * STEP * grid
            rim = tuple(k for k in items if polygons[k].hausdorff_distance(centre) >= least)
            if items:
                yield NotedStep(items, rim, step.depth, plane.looks_up)
            within |= inside


def _depths(holes: Iterable[NotedHole], axis: Axis) -> set[tuple[float, bool]]:
    return {
        (step.depth, role_plane(hole.role).looks_up)
        for hole in holes
        for step in hole.steps
        if role_plane(hole.role).normal is axis and step.depth is not None
    }
