"""The solid of slabs: prisms with true arcs, made one."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from math import inf, isfinite

import numpy as np
import shapely
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.booleans import common, fused, unified, without
from gaussiancad_core.kernel.brep import bounding_box, is_valid, subshapes
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.sketch.choosing import Choice
from gaussiancad_core.sketch.cross_holes import CrossHole
from gaussiancad_core.sketch.plan_regions import Regions
from gaussiancad_core.sketch.plane_lines import profile_along
from gaussiancad_core.sketch.slab_plan import Plan
from gaussiancad_core.sketch.sloping_rims import SunkRim
from gaussiancad_core.solid.profiles import Profile, prism, turned

_BEYOND = 0.05
"""Of a cone's height by which it reaches beyond its face."""

_LONGEST = 12.0
"""Diameters that a hole is deep at most, unless lines or a note tell (DIN 338: jobber drills)."""

_LEAST_AREA = 1e-6
"""mm2 of a piece at least."""


@dataclass(frozen=True, eq=False)
class Slab:
    """A layer of the part.

    Attributes:
        low, high: mm along the axis.
        area: mm, what is filled of the plane across it.
    """

    low: float
    high: float
    area: shapely.Geometry


def slabs_of(choice: Choice) -> tuple[Slab, ...]:
    """The filled layers of a choice, from the lowest; equal ones on each other are one."""
    plan = choice.plan
    found: list[tuple[int, int, tuple[int, ...]]] = []
    for k in plan.slabs:
        chosen = tuple(np.flatnonzero(choice.filled[:, k]).tolist())
        if found and found[-1][2] == chosen:
            found[-1] = (found[-1][0], k + 1, chosen)
        else:
            found.append((k, k + 1, chosen))
    return tuple(
        Slab(plan.levels[low], plan.levels[high], _united(plan.regions, chosen))
        for low, high, chosen in found
        if chosen
    )


@dataclass(frozen=True, eq=False)
class Cone:
    """What a sunk rim takes away, at 45 degrees.

    Attributes:
        rim: where.
        at: mm along the axis of its outer circle.
    """

    rim: SunkRim
    at: float


def cones_of(choice: Choice) -> tuple[Cone, ...]:
    """What the sunk rims of a choice take away."""
    levels = choice.plan.levels
    found = []
    for rim in choice.sunk:
        slabs = np.flatnonzero(choice.filled[rim.ring.region])
        if len(slabs):
            found.append(Cone(rim, levels[slabs[-1] + 1] if rim.is_top else levels[slabs[0]]))
    return tuple(found)


def body_of(choice: Choice, slabs: Sequence[Slab], cones: Sequence[Cone]) -> TopoDS_Shape:
    """The slabs as one shape, less the cones of sunk rims.

    Args:
        choice: of which they are.
        slabs: one at least.
        cones: of it.

    Raises:
        RuntimeError: the kernel fails.
    """
    plan = choice.plan
    prisms = [
        _prism(profile, plan.axis, (slab.low, slab.high))
        for slab in slabs
        for profile in profiles_of(slab.area, plan.regions, plan.grid)
    ]
    body = fused(prisms)
    if cones:
        body = without(body, [_cone(cone, plan.axis) for cone in cones])
    return unified(body)


def _prism(profile: Profile, axis: Axis, between: tuple[float, float]) -> TopoDS_Shape:
    """A profile as a prism; with chords for arcs, where these cross each other."""
    with suppress(*KERNEL_FAILURES):
        made = prism(profile, axis, between)
        if is_valid(made):
            return made
    return prism(replace(profile, arcs=()), axis, between)


def _cone(cone: Cone, axis: Axis) -> TopoDS_Shape:
    """A cone that reaches a little beyond the face into which it is sunk, and into the hole."""
    ring, way = cone.rim.ring, -1.0 if cone.rim.is_top else 1.0
    height = ring.outer - ring.inner
    beyond = _BEYOND * height
    at, direction = [0.0] * 3, [0.0] * 3
    first, second = IN_PLANE[axis]
    at[first], at[second] = ring.centre
    at[axis.value], direction[axis.value] = cone.at - way * beyond, way
    place = gp_Ax2(gp_Pnt(*at), gp_Dir(*direction))
    ends = ring.outer + beyond, max(0.0, ring.inner - beyond)
    maker = BRepPrimAPI_MakeCone(place, *ends, ends[0] - ends[1])
    return maker.Shape()


def turned_down(shape: TopoDS_Shape, plan: Plan) -> TopoDS_Shape:
    """A body less what lies beyond the slopes of a turned part.

    Args:
        shape: mm.
        plan: with the slopes, or without any.

    Raises:
        RuntimeError: the kernel fails.
    """
    slopes = plan.slopes
    tools = [turned(slope.beyond(plan.grid), plan.axis, slope.centre) for slope in slopes]
    return unified(without(shape, tools)) if tools else shape


@dataclass(frozen=True)
class Bore:
    """A hole across the slabs as it was cut.

    Attributes:
        hole: of the plan.
        low, high: mm along it; infinite where it is open.
    """

    hole: CrossHole
    low: float
    high: float


def with_holes(shape: TopoDS_Shape, plan: Plan) -> tuple[TopoDS_Shape, tuple[Bore, ...]]:
    """A body with the holes across its slabs, and these as they were cut.

    Args:
        shape: mm.
        plan: with the holes.

    Raises:
        RuntimeError: the kernel fails.
    """
    bores = tuple(bore for hole in plan.cross_holes for bore in _bores(shape, hole, plan))
    if not bores:
        return shape, ()
    return unified(without(shape, [_cylinder(bore, plan) for bore in bores])), bores


def _bores(shape: TopoDS_Shape, hole: CrossHole, plan: Plan) -> Iterator[Bore]:
    """What a hole takes away: between its walls, as deep as a note says, or, of which nothing
    tells how deep it is, to the next void."""
    size = plan.size[hole.axis.value]
    for low, high in hole.intervals:
        bore = Bore(
            hole,
            -inf if low <= plan.grid else low,
            inf if high >= size - plan.grid else high,
        )
        if isfinite(low) or isfinite(high) or hole.depth == inf:
            yield bore
        elif (found := _reaching(shape, bore, plan)) is not None:
            yield found


def _reaching(shape: TopoDS_Shape, bore: Bore, plan: Plan) -> Bore | None:
    """A hole from where it enters the material; None where no drill is as long."""
    hole = bore.hole
    runs = [
        bounding_box(subshape)[:, hole.axis.value].tolist()
        for subshape in subshapes(
            common(shape, _cylinder(bore, plan)), TopAbs_ShapeEnum.TopAbs_SOLID
        )
    ]
    if not runs:
        return None
    low, high = min(runs) if hole.plane.looks_up else max(runs)
    depth = hole.depth
    if depth is None:
        if high - low > _LONGEST * 2.0 * hole.circle.radius:
            return None
        depth = high - low + plan.grid
    if hole.plane.looks_up:
        return replace(bore, high=low + depth)
    return replace(bore, low=high - depth)


def _cylinder(bore: Bore, plan: Plan) -> TopoDS_Shape:
    hole, size = bore.hole, plan.size[bore.hole.axis.value]
    low, high = max(bore.low, -size), min(bore.high, 2.0 * size)
    at, direction = [0.0] * 3, [0.0] * 3
    for index, place in zip(IN_PLANE[hole.axis], hole.circle.centre, strict=True):
        at[index] = place
    at[hole.axis.value], direction[hole.axis.value] = low, 1.0
    place = gp_Ax2(gp_Pnt(*at), gp_Dir(*direction))
    return BRepPrimAPI_MakeCylinder(place, hole.circle.radius, high - low).Shape()


def profiles_of(area: shapely.Geometry, regions: Regions, grid: float) -> list[Profile]:
    """The pieces of a slab's area with the arcs along which their outlines run.

    Args:
        area: mm.
        regions: of which it is.
        grid: mm of a step of the sheet's coordinates.
    """
    return [
        profile_along(piece, regions.lines, grid)
        for piece in shapely.get_parts(area)
        if piece.geom_type == "Polygon" and piece.area > _LEAST_AREA
    ]


def _united(regions: Regions, chosen: Sequence[int]) -> shapely.Geometry:
    return shapely.union_all([regions.polygons[k] for k in chosen])
