"""From a sketch to how it is put together, with the numbers and strokes that fix each piece."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import isfinite

import numpy as np
import shapely

from gaussiancad_core.coordinates.grid_tolerances import NEAR
from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
)
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.sketch.construction import (
    DIGITS,
    Break,
    Construction,
    Countersink,
    Hole,
    Level,
    Loop,
    Point,
    SideHole,
    SlabLoops,
    Source,
    Turning,
)
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine
from gaussiancad_core.sketch.sketching import Sketch
from gaussiancad_core.sketch.slab_plan import Plan
from gaussiancad_core.sketch.slab_solids import Bore, Slab, cones_of, profiles_of
from gaussiancad_core.solid.profiles import Profile, edges_of


def construction_of(sketch: Sketch, stated: DimensionConstraints | None) -> Construction:
    """How a sketched part is put together.

    Args:
        sketch: with a part.
        stated: what the sheet's numbers say, mm.
    """
    plan, near = sketch.choice.plan, NEAR * sketch.choice.plan.grid
    numbers = stated.lengths if stated is not None else ()
    lengths = [number for number in numbers if isinstance(number, LengthDimension)]
    radii = [number for number in numbers if isinstance(number, RadiusDimension)]
    levels = tuple(
        Level(_rounded(at), _reaching(lengths, plan.axis, at, near), tuple(_at(plan, at, near)))
        for at in plan.levels
        if any(near > abs(at - end) for slab in sketch.slabs for end in (slab.low, slab.high))
    )
    slabs = tuple(_loops_of(slab, plan, (lengths, radii), near) for slab in sketch.slabs)
    holes = tuple(
        replace(hole, is_through=not any(slab.area.covers(at) for slab in sketch.slabs))
        for hole in _holes(slabs, near)
        for at in [shapely.Point(hole.centre)]
    )
    energy = _rounded(sketch.energy)
    sunk = tuple(
        Countersink(
            _point(ring.centre),
            _rounded(2.0 * ring.outer),
            _rounded(2.0 * ring.inner),
            _rounded(cone.at),
            cone.rim.is_top,
        )
        for cone in cones_of(sketch.choice)
        for ring in [cone.rim.ring]
    )
    broken = dict.fromkeys(
        Break(
            round(edge_break.at, 3),
            round(edge_break.width, 3),
            round(edge_break.height, 3),
            edge_break.is_round,
        )
        for edge_break in sketch.breaks
    )
    name = plan.axis.name.lower()
    turned = tuple(_turned(sketch))
    across = tuple(_cross_holes(sketch.bores, radii, near))
    return Construction(name, energy, levels, slabs, holes, sunk, tuple(broken), turned, across)


def _reaching(
    lengths: Sequence[LengthDimension], axis: Axis, at: float, near: float
) -> tuple[float, ...]:
    found = {
        length.value
        for length in lengths
        if length.axis is axis and min(abs(length.low - at), abs(length.high - at)) <= near
    }
    return tuple(sorted(found))


def _at(plan: Plan, at: float, near: float) -> Iterator[Source]:
    """Strokes of views from beside at a level."""
    for role, lines in plan.lines.items():
        axes = IN_PLANE[role_plane(role).normal]
        if plan.axis.value not in axes:
            continue
        along = axes.index(plan.axis.value)
        for line in lines:
            if line.constant(near) == along and abs(line.points[:, along].mean() - at) <= near:
                yield _source(line, role)


def _source(line: PlaneLine, role: Role) -> Source:
    (a, b), (c, d) = (line.points[[0, -1]] * np.array(role_plane(role).signs)).tolist()
    return Source(role.value, (_rounded(a), _rounded(b)), (_rounded(c), _rounded(d)))


def _loops_of(
    slab: Slab,
    plan: Plan,
    stated: tuple[Sequence[LengthDimension], Sequence[RadiusDimension]],
    near: float,
) -> SlabLoops:
    loops = [
        Loop(
            edges, is_hole, _along(edges, plan.axis, stated, near), tuple(_under(ring, plan, near))
        )
        for profile in profiles_of(slab.area, plan.regions, plan.grid)
        for ring, is_hole in _rings(profile)
        for edges in [tuple(_edges(ring, profile))]
    ]
    return SlabLoops(_rounded(slab.low), _rounded(slab.high), tuple(loops))


def _rings(profile: Profile) -> Iterator[tuple[Floats, bool]]:
    yield np.array(profile.area.exterior.coords)[:-1], False
    for interior in profile.area.interiors:
        yield np.array(interior.coords)[:-1], True


def _edges(ring: Floats, profile: Profile) -> Iterator[OutlineEdge]:
    for edge in edges_of(ring, profile):
        start, end = _point(edge.start), _point(edge.end)
        circle = edge.circle and Circle(_point(edge.circle.centre), _rounded(edge.circle.radius))
        yield replace(edge, start=start, end=end, circle=circle)


def _along(
    edges: Sequence[OutlineEdge],
    axis: Axis,
    stated: tuple[Sequence[LengthDimension], Sequence[RadiusDimension]],
    near: float,
) -> tuple[float, ...]:
    """Numbers that lie between two straight edges of an outline, or are the radius of an arc."""
    lengths, radii = stated
    found = set()
    for column, index in enumerate(IN_PLANE[axis]):
        places = np.array(
            [
                edge.start[column]
                for edge in edges
                if edge.circle is None and abs(edge.start[column] - edge.end[column]) <= near
            ]
        )
        for length in lengths:
            if length.axis.value == index and all(
                len(places) and np.abs(places - end).min() <= near
                for end in (length.low, length.high)
            ):
                found.add(length.value)
    arcs = [edge.circle for edge in edges if edge.circle is not None]
    for radius in radii:
        if radius.normal is axis and any(
            np.hypot(*np.subtract(arc.centre, radius.centre)) <= near
            and abs(arc.radius - radius.radius) <= near
            for arc in arcs
        ):
            found.add(radius.value)
    return tuple(sorted(found))


def _under(ring: Floats, plan: Plan, near: float) -> Iterator[Source]:
    """Strokes of views along the axis that lie along a ring."""
    band = shapely.LineString([*ring, ring[0]]).buffer(near)
    for role, lines in plan.lines.items():
        if role_plane(role).normal is plan.axis:
            for line in lines:
                if shapely.LineString(line.points).within(band):
                    yield _source(line, role)


def _holes(loops: Sequence[SlabLoops], near: float) -> Iterator[Hole]:
    """Round holes, each through all slabs on each other that have it."""
    open_ones: list[Hole] = []
    for slab_loops in loops:
        going_on = []
        for loop in slab_loops.loops:
            circle = loop.edges[0].circle
            centres = {edge.circle and edge.circle.centre for edge in loop.edges}
            if circle is None or len(centres) > 1 or not loop.is_hole:
                continue
            below = next((h for h in open_ones if _is_same(h, circle, slab_loops.low, near)), None)
            low = below.low if below is not None else slab_loops.low
            numbers = tuple(2.0 * value for value in loop.numbers)
            going_on.append(
                Hole(circle.centre, 2.0 * circle.radius, low, slab_loops.high, False, numbers)
            )
            if below is not None:
                open_ones.remove(below)
        yield from open_ones
        open_ones = going_on
    yield from open_ones


def _turned(sketch: Sketch) -> Iterator[Turning]:
    for slope in sketch.slopes:
        profile = slope.beyond(sketch.choice.plan.grid)
        ring, _ = next(_rings(profile))
        yield Turning(_point(slope.centre), tuple(_edges(ring, profile)))


def _cross_holes(
    bores: Sequence[Bore], radii: Sequence[RadiusDimension], near: float
) -> Iterator[SideHole]:
    for bore in bores:
        hole, circle = bore.hole, bore.hole.circle
        numbers = {
            2.0 * each.value
            for each in radii
            if each.normal is hole.axis
            and np.hypot(*np.subtract(each.centre, circle.centre)) <= near
            and abs(each.radius - circle.radius) <= near
        }
        at = _point([a * sign for a, sign in zip(circle.centre, hole.plane.signs, strict=True)])
        low, high = (_rounded(end) if isfinite(end) else None for end in (bore.low, bore.high))
        is_noted = hole.depth is not None and isfinite(hole.depth)
        yield SideHole(
            hole.axis.name.lower(),
            _point(circle.centre),
            _rounded(2.0 * circle.radius),
            low,
            high,
            hole.depth if is_noted else None,
            tuple(sorted(numbers)),
            Source(hole.role.value, at, at),
        )


def _is_same(hole: Hole, circle: Circle, low: float, near: float) -> bool:
    off = np.hypot(*np.subtract(hole.centre, circle.centre))
    across = abs(hole.diameter - 2.0 * circle.radius)
    return bool(off <= near and across <= near and hole.high >= low - near)


def _point(point: Sequence[float]) -> Point:
    x, y = np.asarray(point, dtype=float).tolist()
    return _rounded(x), _rounded(y)


def _rounded(value: float) -> float:
    return round(float(value), DIGITS)
