"""A part as slabs of regions: what there is to choose from, along one axis."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gaussiancad_core.coordinates.agreed_places import Places
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.proposing.broken_corners import EdgeBreak
from gaussiancad_core.sketch.about_axis import circles_about, middle_of
from gaussiancad_core.sketch.cross_holes import CrossHole, without_cross_holes
from gaussiancad_core.sketch.edge_breaks import without_breaks
from gaussiancad_core.sketch.noted_depths import NotedStep, floors, noted_steps
from gaussiancad_core.sketch.plan_regions import MOST_CELLS, Regions, find_regions
from gaussiancad_core.sketch.plane_lines import PlaneLine, plane_lines
from gaussiancad_core.sketch.settled_lines import settled
from gaussiancad_core.sketch.slab_levels import find_levels
from gaussiancad_core.sketch.slab_sights import Sights, sights_of
from gaussiancad_core.sketch.turned import without_slopes
from gaussiancad_core.sketch.turned_bores import without_bore_slopes
from gaussiancad_core.sketch.turned_views import Slope, turning_centre
from gaussiancad_core.sketch.undrawn_divisions import undrawn_divisions


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
        return self.regions.alien + sum(sight.alien for sight in self.sights)


def plans_of(views: DrawnViews, places: Places) -> Iterator[Plan]:
    """The part's slabs along each axis along which a view that is not cut looks, or along the one
    that it is turned about.

    Args:
        views: of the part.
        places: where their lines belong.
    """
    lines = {
        role: [
            settled(line, places, role_plane(role).normal) for line in plane_lines(strokes, role)
        ]
        for role, strokes in views.strokes.items()
    }
    draws_hidden = any(not line.is_visible for drawn in lines.values() for line in drawn)
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
    """The slabs along an axis; None where no view faces it, or there are too many of them."""
    size, cuts = places.size, views.cuts
    faces = {role: role_plane(role).normal is axis for role in lines}
    # What is said to be turned is no plate as thick as it is wide.
    facing = any(face and role not in cuts for role, face in faces.items())
    is_alone = len(lines) == 1 and (facing if views.about is None else views.about is axis)
    if not is_alone and not (facing and not all(faces.values())):
        return None
    ready = _made_ready(axis, lines, views, places)
    grid = places.grid
    divided = _divided(ready, views, (size, grid), draws_hidden=draws_hidden)
    if divided is None or not 0 < _cells(*divided) <= MOST_CELLS:
        return None
    regions, levels = divided
    sights = tuple(
        sights_of(
            (role, ready.lines[role], cuts.get(role)),
            axis,
            (regions.polygons, levels),
            size,
            grid,
            draws_hidden=draws_hidden,
        )
        for role, is_facing in faces.items()
        if not is_facing
    )
    return Plan(
        axis=axis,
        regions=regions,
        levels=levels,
        lines=ready.lines,
        sights=sights,
        is_seen=(bool(ready.facing(looks_up=False)), bool(ready.facing(looks_up=True))),
        draws_hidden=draws_hidden,
        size=size,
        grid=grid,
        breaks=ready.breaks,
        cross_holes=ready.holes,
        noted=tuple(noted_steps(views.holes, axis, regions.polygons, grid)),
        slopes=ready.slopes,
    )


@dataclass(frozen=True, eq=False)
class _Ready:
    """The lines of a part's views, without what is no slab.

    Attributes:
        axis: across the slabs.
        lines: of each view, cut or not.
        whole: roles of the views that are not cut.
        middle: of what is turned about the axis.
        holes, breaks, slopes: what the lines are without, as of :class:`Plan`.
    """

    axis: Axis
    lines: Mapping[Role, Sequence[PlaneLine]]
    whole: frozenset[Role]
    middle: tuple[float, float] | None
    holes: tuple[CrossHole, ...]
    breaks: tuple[EdgeBreak, ...]
    slopes: tuple[Slope, ...]

    def facing(self, *, looks_up: bool) -> list[PlaneLine]:
        """Lines of the views that look along the axis, towards larger coordinates or smaller."""
        return [
            line
            for role, drawn in self.lines.items()
            if role in self.whole and role_plane(role).normal is self.axis
            if role_plane(role).looks_up is looks_up
            for line in drawn
        ]

    def side_views(self) -> list[tuple[Role, int]]:
        """The views that look across the axis, and which coordinate of each runs along it."""
        normals = {role: role_plane(role).normal for role in self.lines}
        return [
            (role, IN_PLANE[normal].index(self.axis.value))
            for role, normal in normals.items()
            if normal is not self.axis
        ]


def _made_ready(
    axis: Axis, lines: Mapping[Role, Sequence[PlaneLine]], views: DrawnViews, places: Places
) -> _Ready:
    size, grid, cuts = places.size, places.grid, views.cuts
    middle = middle_of(axis, size) if views.about is axis else None
    lines, holes = without_cross_holes(lines, axis, size, grid, views)
    centre = middle or turning_centre(lines, axis, size, grid)
    slopes: tuple[Slope, ...] = ()
    if centre is not None:
        lines, outer = without_slopes(lines, axis, centre, grid)
        lines, inner = without_bore_slopes(lines, axis, centre, grid, cuts)
        slopes = (*outer, *inner)
    lines, breaks = without_breaks(lines, axis, max(size), grid)
    whole = frozenset(role for role in lines if role not in cuts)
    return _Ready(axis, lines, whole, middle, holes, breaks, slopes)


def _divided(
    ready: _Ready,
    views: DrawnViews,
    measures: tuple[tuple[float, float, float], float],
    *,
    draws_hidden: bool,
) -> tuple[Regions, tuple[float, ...]] | None:
    """Regions across an axis, and levels along it; None where there are too many.

    Args:
        ready: the lines.
        views: of the part.
        measures: mm of the part, and within which lines are one.
        draws_hidden: whether the sheet has hidden lines.
    """
    axis = ready.axis
    size, grid = measures
    above, below = (ready.facing(looks_up=up) for up in (False, True))
    widths = {edge_break.width for edge_break in ready.breaks}
    side_views = ready.side_views()
    common = [
        (
            IN_PLANE[axis].index(IN_PLANE[role_plane(role).normal][1 - along]),
            1 - along,
            ready.lines[role],
        )
        for role, along in side_views
    ]
    circles = (
        circles_about(axis, common, views.holes, size, grid) if ready.middle is not None else ()
    )
    regions = find_regions(above, below, grid, widths, circles)
    if regions is None:
        return None
    across = [(along, list(ready.lines[role])) for role, along in side_views]
    levels = find_levels(across, size[axis.value], grid)
    levels = tuple(sorted((*levels, *floors(views.holes, axis, levels, grid))))
    if not draws_hidden and ready.middle is None:
        first, second = (size[k] for k in IN_PLANE[axis])
        undrawn = undrawn_divisions([*above, *below], common, (first, second), grid)
        divided = find_regions(above, below, grid, widths, undrawn) if undrawn else regions
        if divided is not None and _cells(divided, levels) <= MOST_CELLS:
            regions = divided
    return regions, levels


def _cells(regions: Regions, levels: Sequence[float]) -> int:
    return len(regions.polygons) * (len(levels) - 1)
