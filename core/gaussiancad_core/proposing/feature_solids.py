"""The exact solid of features in order; what the kernel gets wrong is built alone, or left out."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import pairwise

import numpy as np
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_Copy,
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakeWire,
)
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism, BRepPrimAPI_MakeRevol
from OCP.collections import Array1_gp_Pnt
from OCP.GC import GC_MakeArcOfCircle
from OCP.GeomAbs import GeomAbs_Shape
from OCP.GeomAPI import GeomAPI_PointsToBSpline
from OCP.gp import gp_Ax1, gp_Ax2, gp_Circ, gp_Dir, gp_Pnt, gp_Vec
from OCP.ShapeFix import ShapeFix_Face
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Shape, TopoDS_Wire

from gaussiancad_core.kernel.booleans import common, fused, unified, without
from gaussiancad_core.kernel.brep import faces_of, soundness, volume
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE, lifted
from gaussiancad_core.proposing.edge_runs import EdgeRun, RunKind, prism_rings, profile_runs
from gaussiancad_core.proposing.feature_kernels import Operation
from gaussiancad_core.proposing.lines_by_plane import Floats, PlaneSheet
from gaussiancad_core.proposing.part_features import Feature, Prism, Turned, single_features

_TOUCHING = 0.0, 0.1, 1.0
"""Tolerances within which faces touch, where the kernel makes no sound body of them as they are: it
fails where they all but do."""

_PIECE = 0.05
"""Share of the lines that another body counts."""

_MOST_FACES = 2500
"""Faces of all bodies in between, after which no more features are put on one by one."""

_OTHER = 0.1
"""Share by which the volume of a prism with arcs may differ from that with their chords."""

_ADDS_UP = 1e-4
"""Share of a body's volume by which what two make of each other may miss."""

_WORSE = 0.01
"""Share of the lines that a solid may explain less than what was planned."""

Features = Sequence[tuple[Operation, Feature]]
Cost = Callable[[TopoDS_Shape], float]
Place = Callable[[Floats], gp_Pnt]


def solid_of(
    features: Features, sheet: PlaneSheet, planned: float, cost: Cost
) -> TopoDS_Shape | None:
    """The exact solid of features.

    Args:
        features: in order.
        sheet: whose surfaces they have.
        planned: share of the lines that they leave unexplained as planned.
        cost: the same of a solid.

    Returns:
        None where the kernel makes none.
    """
    made: list[tuple[float, TopoDS_Shape]] = []
    for build in (_built, _one_by_one):
        with suppress(*KERNEL_FAILURES):
            shape = build(features, sheet)
            facts = soundness(shape) if shape is not None else None
            if shape is None or facts is None or not (facts.valid and facts.closed):
                continue
            made.append((cost(shape) + _PIECE * (facts.solids - 1), shape))
            if made[-1][0] <= planned + _WORSE:
                break
    return min(made, key=_first)[1] if made else None


def _first(pair: tuple[float, TopoDS_Shape]) -> float:
    return pair[0]


def _built(features: Features, sheet: PlaneSheet) -> TopoDS_Shape | None:
    """Features one after another, those of one kind at once."""
    shape: TopoDS_Shape | None = None
    for operation, tools in _runs(features, sheet):
        shape = fused(tools) if shape is None else _after(shape, operation, tools, 0.0)
    return None if shape is None else _unified(shape)


def _runs(features: Features, sheet: PlaneSheet) -> Iterator[tuple[Operation, list[TopoDS_Shape]]]:
    run: list[TopoDS_Shape] = []
    before: Operation | None = None
    for operation, feature in features:
        tools = [_tool(single, sheet) for single in single_features(feature)]
        if before is not None and (operation is not before or operation is Operation.MEET):
            yield before, run
            run = []
        run = [*run, *tools]
        before = operation
    if before is not None:
        yield before, run


def _one_by_one(features: Features, sheet: PlaneSheet) -> TopoDS_Shape | None:
    """Features alone, each in the first way in which the kernel makes a sound body with it; without
    those of which it makes none."""
    shape: TopoDS_Shape | None = None
    left = _MOST_FACES
    for operation, feature in features:
        for single in single_features(feature):
            with suppress(*KERNEL_FAILURES):
                tool = _tool(single, sheet)
                made = tool if shape is None else _in_one_way(shape, operation, tool, sheet)
                if made is not None:
                    shape = made
                    left -= len(faces_of(made))
            if left < 0:
                return shape
    return None if shape is None else _unified(shape)


def _in_one_way(
    shape: TopoDS_Shape, operation: Operation, tool: TopoDS_Shape, sheet: PlaneSheet
) -> TopoDS_Shape | None:
    """A body after one more feature, the first sound one whose volume adds up with what both have
    in common: the kernel may be wrong about bodies that all but touch, and say nothing."""
    for near in (share * sheet.tolerance for share in _TOUCHING):
        with suppress(*KERNEL_FAILURES):
            made = _after(shape, operation, [tool], near)
            facts = soundness(made)
            if not (facts.valid and facts.closed and facts.volume_mm3 > 0.0):
                continue
            one, other = volume(shape), volume(tool)
            if operation is Operation.MEET:
                known = one - volume(without(shape, [tool], near))
            else:
                shared = volume(common(shape, tool, near))
                known = one + other - shared if operation is Operation.ADD else one - shared
            if abs(facts.volume_mm3 - known) <= _ADDS_UP * max(one, other):
                return made
    return None


def _unified(shape: TopoDS_Shape) -> TopoDS_Shape:
    """With faces that continue each other as one, where the kernel makes a sound body of that."""
    with suppress(*KERNEL_FAILURES):
        # Where the kernel fails at this it has changed what it was given.
        made = unified(BRepBuilderAPI_Copy(shape).Shape())
        facts = soundness(made)
        if facts.valid and facts.closed:
            return made
    return shape


def _after(
    shape: TopoDS_Shape, operation: Operation, tools: Sequence[TopoDS_Shape], near: float
) -> TopoDS_Shape:
    if operation is Operation.ADD:
        return fused([shape, *tools], near)
    if operation is Operation.CUT:
        return without(shape, tools, near)
    return common(shape, tools[0], near)


def _tool(feature: Prism | Turned, sheet: PlaneSheet) -> TopoDS_Shape:
    """A feature with arcs for the chords of circles; with chords where these make another of it."""
    if isinstance(feature, Turned):
        return _turned(feature, sheet)
    with suppress(*KERNEL_FAILURES):
        made = _prism(feature, sheet, with_arcs=True)
        if abs(volume(made) - feature.volume) <= _OTHER * feature.volume:
            return made
    return _prism(feature, sheet, with_arcs=False)


def _prism(feature: Prism, sheet: PlaneSheet, *, with_arcs: bool) -> TopoDS_Shape:
    axis = feature.axis

    def place(point: Floats) -> gp_Pnt:
        return gp_Pnt(*lifted(axis, float(point[0]), float(point[1]), feature.low))

    rings = prism_rings(feature, sheet, with_arcs=with_arcs)
    wires = [_wire(runs, place, axis, sheet.tolerance) for runs in rings]
    face = BRepBuilderAPI_MakeFace(wires[0], True)
    for wire in wires[1:]:
        face.Add(wire)
    way = [0.0, 0.0, 0.0]
    way[axis.value] = feature.high - feature.low
    return BRepPrimAPI_MakePrism(_fixed(face.Face()), gp_Vec(*way)).Shape()


def _turned(feature: Turned, sheet: PlaneSheet) -> TopoDS_Shape:
    """The profile in the plane of the axis and the first one across it, turned."""
    first, second = IN_PLANE[feature.axis]

    def place(point: Floats) -> gp_Pnt:
        found = np.zeros(3)
        found[first], found[second] = feature.centre
        found[first] += point[0]
        found[feature.axis.value] = point[1]
        return gp_Pnt(*found.tolist())

    runs = profile_runs(feature, sheet.tolerance)
    wire = _wire(runs, place, Axis(second), sheet.tolerance)
    face = BRepBuilderAPI_MakeFace(wire, True).Face()
    origin, way = np.zeros(3), np.zeros(3)
    origin[first], origin[second] = feature.centre
    way[feature.axis.value] = 1.0
    about = gp_Ax1(gp_Pnt(*origin.tolist()), gp_Dir(*way.tolist()))
    return BRepPrimAPI_MakeRevol(face, about).Shape()


def _wire(runs: Iterable[EdgeRun], place: Place, normal: Axis, tolerance: float) -> TopoDS_Wire:
    """A closed wire of runs.

    Args:
        runs: around, in the wire's plane.
        place: (a, b) -> place in space.
        normal: the axis across the plane.
        tolerance: mm within which a curve passes its corners.
    """
    made = BRepBuilderAPI_MakeWire()
    for run in runs:
        for edge in _edges(run, place, normal, tolerance):
            made.Add(edge)
    return made.Wire()


def _edges(run: EdgeRun, place: Place, normal: Axis, tolerance: float) -> Iterator[TopoDS_Edge]:
    corners = run.corners
    if run.kind is RunKind.CIRCLE and run.circle is not None:
        x, y, radius = run.circle
        way = [0.0, 0.0, 0.0]
        way[normal.value] = 1.0
        about = gp_Ax2(place(np.array([x, y])), gp_Dir(*way))
        yield BRepBuilderAPI_MakeEdge(gp_Circ(about, radius)).Edge()
        return
    if run.kind is RunKind.CURVE:
        yield _curve(corners, place, tolerance)
        return
    if run.kind is RunKind.ARC:
        arc = GC_MakeArcOfCircle(place(corners[0]), place(run.middle), place(corners[-1]))
        if arc.IsDone():
            yield BRepBuilderAPI_MakeEdge(arc.Value()).Edge()
            return
    # An arc whose ends are one, all but, stays its chords.
    for start, end in pairwise(corners):
        yield BRepBuilderAPI_MakeEdge(place(start), place(end)).Edge()


def _curve(corners: Floats, place: Place, tolerance: float) -> TopoDS_Edge:
    """A free curve through corners, from the first to the last."""
    points = Array1_gp_Pnt(1, len(corners))
    for number, corner in enumerate(corners, 1):
        points.SetValue(number, place(corner))
    curve = GeomAPI_PointsToBSpline(points, 3, 8, GeomAbs_Shape.GeomAbs_C2, tolerance).Curve()
    return BRepBuilderAPI_MakeEdge(curve).Edge()


def _fixed(face: TopoDS_Face) -> TopoDS_Face:
    fix = ShapeFix_Face(face)
    fix.FixOrientation()
    return fix.Face()
