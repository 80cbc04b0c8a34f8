"""Edge breaks put on the edges of a solid that was made without them."""

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby

import numpy as np
import shapely
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer, BRepFilletAPI_MakeFillet
from OCP.BRepTools import BRepTools
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.kernel.brep import bounding_box, faces_of, soundness, subshapes
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.broken_corners import EdgeBreak
from gaussiancad_core.proposing.face_breaks import EdgeBreaks

Cost = Callable[[TopoDS_Shape], float]
Edges = list[tuple[TopoDS_Edge, TopoDS_Face]]

_NEAR = 3.0
"""Tolerances within which a face is that of a break."""


def with_breaks(
    shape: TopoDS_Shape, breaks: EdgeBreaks, tolerance: float, cost: Cost
) -> tuple[TopoDS_Shape, tuple[EdgeBreak, ...]]:
    """A solid with those edges broken with which it explains more, and the breaks that these are.

    Args:
        shape: with sharp edges, mm.
        breaks: around faces and holes of it.
        tolerance: mm by which these may miss where they belong.
        cost: what a solid leaves unexplained.
    """
    best, made = cost(shape), []
    near = _NEAR * tolerance
    for alike in _alike(breaks.each, near):
        rims = breaks.rims.get(alike[0].axis, ())
        loops = list(_loops(shape, alike, rims, near))
        whole = edges_broken(shape, alike[0], [edge for loop in loops for edge in loop])
        if whole is not None and cost(whole) < best:
            shape, best = whole, cost(whole)
            made.append(alike[0])
            continue
        # Where one loop cannot be broken, the others may be.
        for number in range(len(loops) if len(loops) > 1 else 0):
            # What was broken before has made other edges of them.
            left = list(_loops(shape, alike, rims, near))
            broken = edges_broken(shape, alike[0], left[number]) if number < len(left) else None
            if broken is not None and cost(broken) < best:
                shape, best = broken, cost(broken)
                made.append(alike[0])
    return shape, tuple(made)


def _alike(breaks: Sequence[EdgeBreak], near: float) -> Iterator[list[EdgeBreak]]:
    """Breaks of one face, of one size."""

    def key(edge_break: EdgeBreak) -> tuple[int, int, int, bool]:
        at, height = round(edge_break.at / near), round(edge_break.height / near)
        return edge_break.axis.value, at, height, edge_break.is_round

    for _, group in groupby(sorted(breaks, key=key), key=key):
        yield list(group)


def _loops(
    shape: TopoDS_Shape, breaks: Sequence[EdgeBreak], rims: Sequence[shapely.Polygon], near: float
) -> Iterator[Edges]:
    """Outlines of the faces that the breaks are of, and of holes in them with a rim: their edges,
    each with its face."""
    axis, at = breaks[0].axis, breaks[0].at
    for face in faces_of(shape):
        if not is_level(face, axis, at, near):
            continue
        low, high = bounding_box(face)
        reaches = any(
            min(abs(low[each.across.value] - each.place), abs(high[each.across.value] - each.place))
            <= near
            for each in breaks
        )
        outer = BRepTools.OuterWire_s(face)
        for wire in subshapes(face, TopAbs_ShapeEnum.TopAbs_WIRE):
            edges = subshapes(wire, TopAbs_ShapeEnum.TopAbs_EDGE)
            if reaches if wire.IsSame(outer) else _is_rim(wire, axis, rims, near):
                yield [(TopoDS.Edge(each), face) for each in edges]


def _is_rim(wire: TopoDS_Shape, axis: Axis, rims: Sequence[shapely.Polygon], near: float) -> bool:
    """Whether a wire is the outline of a hole with a rim."""
    low, high = (corner[list(IN_PLANE[axis])] for corner in bounding_box(wire))
    sides = np.concatenate([low, high])
    return any(np.abs(sides - rim.bounds).max() <= near for rim in rims)


def is_level(face: TopoDS_Face, axis: Axis, at: float, near: float) -> bool:
    """Whether a face is the plane across an axis at a place, within so many mm."""
    surface = BRepAdaptor_Surface(face)
    if surface.GetType() != GeomAbs_SurfaceType.GeomAbs_Plane:
        return False
    way, place = surface.Plane().Axis().Direction(), surface.Plane().Location()
    along = abs((way.X(), way.Y(), way.Z())[axis.value])
    return (
        along > 1.0 - COMPUTED and abs((place.X(), place.Y(), place.Z())[axis.value] - at) <= near
    )


def edges_broken(
    shape: TopoDS_Shape, edge_break: EdgeBreak, edges: Sequence[tuple[TopoDS_Edge, TopoDS_Face]]
) -> TopoDS_Shape | None:
    """A solid with edges broken; None where the kernel makes no sound one."""
    if not edges:
        return None
    try:
        if edge_break.is_round:
            maker = BRepFilletAPI_MakeFillet(shape)
            for edge, _ in edges:
                maker.Add(float(np.mean([edge_break.width, abs(edge_break.height)])), edge)
        else:
            maker = BRepFilletAPI_MakeChamfer(shape)
            for edge, face in edges:
                maker.Add(edge_break.width, abs(edge_break.height), edge, face)
        maker.Build()
        if not maker.IsDone():
            return None
        facts = soundness(maker.Shape())
    except KERNEL_FAILURES:
        return None
    is_sound = facts.valid and facts.closed and facts.solids == soundness(shape).solids
    return maker.Shape() if is_sound else None
