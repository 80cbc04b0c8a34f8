"""A part as slabs of regions: what there is to choose from, along one axis."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.planes import IN_PLANE, role_plane
from gaussiancad_core.sketch.about_axis import circles_about, middle_of
from gaussiancad_core.sketch.breaks import EdgeBreak, without_breaks
from gaussiancad_core.sketch.cross_holes import CrossHole, without_cross_holes
from gaussiancad_core.sketch.levels import find_levels
from gaussiancad_core.sketch.noted import NotedStep, floors, noted_steps
from gaussiancad_core.sketch.places import Places
from gaussiancad_core.sketch.plane_lines import PlaneLine, plane_lines
from gaussiancad_core.sketch.regions import Regions, find_regions
from gaussiancad_core.sketch.sights import Sights, sights_of
from gaussiancad_core.sketch.turned import without_slopes
from gaussiancad_core.sketch.turned_bores import without_bore_slopes
from gaussiancad_core.sketch.turned_views import Slope, turning_centre
from gaussiancad_core.sketch.undrawn import undrawn_divisions

_MOST_CELLS = 200
"""Regions of slabs from which nothing is chosen: of more nothing good was ever found in time."""


@dataclass(frozen=True, eq=False)
class Plan:
    """What slabs along an axis may be made of.

    Attributes:
        axis: across the slabs.
        regions: of the plane across the axis.
        levels: mm along the axis; slab k lies between the levels k and k + 1.
        lines: of each view, mm in its plane, where they belong.
        sights: views from beside.
        is_seen: from above, and from below: whether a view that is not cut looks so.
        draws_hidden: whether the sheet has hidden lines.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
        breaks: of edges across the axis, which the lines are without.
        cross_holes: holes along other axes, which the lines are without.
        noted: cylinders of holes along the axis of which notes speak.
        slopes: of the outline and the bores of a turned part, in place of which the lines have
            steps.
    """

    axis: Axis
    regions: Regions
    levels: tuple[float, ...]
    lines: Mapping[Role, Sequence[PlaneLine]]
    sights: tuple[Sights, ...]
    is_seen: tuple[bool, bool]
    draws_hidden: bool
    size: tuple[float, float, float]
    grid: float
    breaks: tuple[EdgeBreak, ...]
    cross_holes: tuple[CrossHole, ...]
    noted: tuple[NotedStep, ...]
    slopes: tuple[Slope, ...]

    @property
    def slabs(self) -> range:
        """Numbers of the slabs."""
        return range(len(self.levels) - 1)

    @property
    def alien(self) -> float:
        """mm of line that nothing made of slabs explains."""
        return self.regions.alien + sum(own.alien for own in self.sights)


def plans_of(views: DrawnViews, places: Places) -> Iterator[Plan]:
    """The part's slabs along each axis along which a view that is not cut looks, or along the one
    that it is turned about.

    Args:
        views: of the part.
        places: where their lines belong.
    """
    lines = {
        role: [places.settled(own, role_plane(role).normal) for own in plane_lines(strokes, role)]
        for role, strokes in views.strokes.items()
    }
    draws_hidden = any(not own.is_visible for drawn in lines.values() for own in drawn)
    for axis in Axis:
        plan = _plan(axis, lines, views, places, draws_hidden=draws_hidden)
        if plan is not None:
            yield plan


def _plan(
    axis: Axis,
    lines: Mapping[Role, Sequence[PlaneLine]],
    views: DrawnViews,
    places: Places,
    *,
    draws_hidden: bool,
) -> Plan | None:
    size, grid, cuts = places.size, places.grid, views.cuts
    planes = {role: role_plane(role) for role in lines}
    facing = [r for r in lines if planes[r].normal is axis and r not in cuts]
    beside = [r for r in lines if planes[r].normal is not axis]
    # What is said to be turned is no plate as thick as it is wide.
    is_alone = len(lines) == 1 and (bool(facing) if views.about is None else views.about is axis)
    if not is_alone and not (facing and beside):
        return None
    middle = middle_of(axis, size) if views.about is axis else None
    lines, holes = without_cross_holes(lines, axis, size, grid, views)
    centre = middle or turning_centre(lines, axis, size, grid)
    slopes: tuple[Slope, ...] = ()
    if centre is not None:
        lines, outer = without_slopes(lines, axis, centre, grid)
        lines, inner = without_bore_slopes(lines, axis, centre, grid, cuts)
        slopes = (*outer, *inner)
    lines, breaks = without_breaks(lines, axis, max(size), grid)
    above, below = (
        [line for role in facing if planes[role].looks_up is up for line in lines[role]]
        for up in (False, True)
    )
    widths = {own.width for own in breaks}
    across = [(IN_PLANE[planes[r].normal].index(axis.value), list(lines[r])) for r in beside]
    common = [
        (IN_PLANE[axis].index(IN_PLANE[planes[r].normal][1 - along]), 1 - along, drawn)
        for r, (along, drawn) in zip(beside, across, strict=True)
    ]
    circles = circles_about(axis, common, views.holes, size, grid) if middle is not None else ()
    regions = find_regions(above, below, grid, widths, circles)
    levels = find_levels(across, size[axis.value], grid)
    levels = tuple(sorted((*levels, *floors(views.holes, axis, levels, grid))))
    if not draws_hidden and middle is None:
        first, second = (size[k] for k in IN_PLANE[axis])
        undrawn = undrawn_divisions([*above, *below], common, (first, second), grid)
        divided = find_regions(above, below, grid, widths, undrawn) if undrawn else regions
        if len(divided.polygons) * (len(levels) - 1) <= _MOST_CELLS:
            regions = divided
    if not 0 < len(regions.polygons) * (len(levels) - 1) <= _MOST_CELLS:
        return None
    sights = tuple(
        sights_of(
            (role, lines[role], cuts.get(role)),
            axis,
            (regions.polygons, levels),
            size,
            grid,
            draws_hidden=draws_hidden,
        )
        for role in beside
    )
    seen = bool(above), bool(below)
    noted = tuple(noted_steps(views.holes, axis, regions.polygons, grid))
    told = seen, draws_hidden, size, grid
    return Plan(axis, regions, levels, lines, sights, *told, breaks, holes, noted, slopes)
