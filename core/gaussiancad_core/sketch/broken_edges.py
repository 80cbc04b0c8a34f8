"""Edge breaks put on the edges of a body that was made without them."""

from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer, BRepFilletAPI_MakeFillet
from OCP.BRepTools import BRepTools
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.axes import Axis
from gaussiancad_core.drawing.brep import bounding_box, faces_of, soundness, subshapes
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.sketch.breaks import EdgeBreak

_NEAR = 1.2
"""Grid steps between an edge and where a view shows it at most."""

_ACROSS = 1e-6
"""By how much less than 1 the normal of a face is along the axis at most."""


def with_breaks(
    shape: TopoDS_Shape, breaks: Sequence[EdgeBreak], axis: Axis, grid: float
) -> tuple[TopoDS_Shape, tuple[EdgeBreak, ...]]:
    """A body with broken edges, and the breaks that the kernel did not make.

    Args:
        shape: with sharp edges, mm.
        breaks: of edges across the axis.
        axis: of the slabs.
        grid: mm of a step of the sheet's coordinates.
    """
    refused: list[EdgeBreak] = []
    for own in _alike(breaks, grid):
        edges = list(_edges(shape, own, axis, grid))
        broken = _broken(shape, own[0], edges) if edges else None
        if broken is None:
            refused += own
        else:
            shape = broken
    return shape, tuple(refused)


def _alike(breaks: Sequence[EdgeBreak], grid: float) -> Iterator[list[EdgeBreak]]:
    """Breaks of one face, of one size."""

    def key(own: EdgeBreak) -> tuple[int, int, int, bool]:
        return (*(round(x / grid) for x in (own.at, own.width, own.height)), own.is_round)

    for _, group in groupby(sorted(breaks, key=key), key=key):
        yield list(group)


def _edges(
    shape: TopoDS_Shape, breaks: Sequence[EdgeBreak], axis: Axis, grid: float
) -> Iterator[tuple[TopoDS_Edge, TopoDS_Face]]:
    """Outer edges of the faces that the breaks are of."""
    near = _NEAR * grid
    own = breaks[0]
    for face in faces_of(shape):
        if not _is_level(face, axis, own.at, near):
            continue
        low, high = bounding_box(face)
        reaches = any(
            min(abs(low[each.across.value] - each.place), abs(high[each.across.value] - each.place))
            <= near
            for each in breaks
        )
        if reaches:
            for edge in subshapes(BRepTools.OuterWire_s(face), TopAbs_ShapeEnum.TopAbs_EDGE):
                yield TopoDS.Edge(edge), face


def _is_level(face: TopoDS_Face, axis: Axis, at: float, near: float) -> bool:
    surface = BRepAdaptor_Surface(face)
    if surface.GetType() != GeomAbs_SurfaceType.GeomAbs_Plane:
        return False
    way, place = surface.Plane().Axis().Direction(), surface.Plane().Location()
    along = abs((way.X(), way.Y(), way.Z())[axis.value])
    return along > 1.0 - _ACROSS and abs((place.X(), place.Y(), place.Z())[axis.value] - at) <= near


def _broken(
    shape: TopoDS_Shape, own: EdgeBreak, edges: Sequence[tuple[TopoDS_Edge, TopoDS_Face]]
) -> TopoDS_Shape | None:
    try:
        if own.is_round:
            maker = BRepFilletAPI_MakeFillet(shape)
            for edge, _ in edges:
                maker.Add(float(np.mean([own.width, abs(own.height)])), edge)
        else:
            maker = BRepFilletAPI_MakeChamfer(shape)
            for edge, face in edges:
                maker.Add(own.width, abs(own.height), edge, face)
        maker.Build()
        if not maker.IsDone():
            return None
        facts = soundness(maker.Shape())
    except KERNEL_FAILURES:
        return None
    return maker.Shape() if facts.valid and facts.closed and facts.solids == 1 else None
