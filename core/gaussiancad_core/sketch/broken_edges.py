"""Edge breaks put on the edges of a body that was made without them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

import shapely
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepTools import BRepTools
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.coordinates.grid_tolerances import NEAR
from gaussiancad_core.kernel.brep import bounding_box, faces_of, subshapes
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.breaking_edges import edges_broken, is_level
from gaussiancad_core.proposing.broken_corners import EdgeBreak
from gaussiancad_core.sketch.slab_plan import Plan


def with_breaks(shape: TopoDS_Shape, plan: Plan) -> tuple[TopoDS_Shape, tuple[EdgeBreak, ...]]:
    """A body with broken edges, and the breaks that the kernel did not make.

    Args:
        shape: with sharp edges, mm.
        plan: with the breaks of edges across its axis.
    """
    refused: list[EdgeBreak] = []
    for edge_breaks in _alike(plan.breaks, plan.grid):
        loops = list(_loops(shape, edge_breaks, plan))
        whole = edges_broken(shape, edge_breaks[0], [edge for loop in loops for edge in loop.edges])
        if whole is not None:
            shape = whole
            continue
        # Where one loop cannot be broken, the others may be.
        count = 0
        for place in [loop.place for loop in loops]:
            # What was broken before has made other edges of them.
            left = _loops(shape, edge_breaks, plan)
            near = min(left, key=lambda loop: loop.place.distance(place), default=None)
            broken = edges_broken(shape, edge_breaks[0], near.edges) if near is not None else None
            if broken is not None:
                shape, count = broken, count + 1
        if not count:
            refused += edge_breaks
    return shape, tuple(refused)


@dataclass(frozen=True, eq=False)
class _Loop:
    """Edges around a face, each with that, and a place that tells the loop from others."""

    edges: tuple[tuple[TopoDS_Edge, TopoDS_Face], ...]
    place: shapely.Point


def _alike(breaks: Sequence[EdgeBreak], grid: float) -> Iterator[list[EdgeBreak]]:
    """Breaks of one face, of one size."""

    def key(edge_break: EdgeBreak) -> tuple[int, int, int, bool]:
        at, width = round(edge_break.at / grid), round(edge_break.width / grid)
        return at, width, round(edge_break.height / grid), edge_break.is_round

    for _, group in groupby(sorted(breaks, key=key), key=key):
        yield list(group)


def _loops(shape: TopoDS_Shape, breaks: Sequence[EdgeBreak], plan: Plan) -> Iterator[_Loop]:
    """Outlines of the faces that the breaks are of, and of their holes along bands of the plan."""
    near = NEAR * plan.grid
    edge_break = breaks[0]
    bands = shapely.union_all([plan.regions.polygons[band].boundary for band in plan.regions.bands])
    for face in faces_of(shape):
        if not is_level(face, plan.axis, edge_break.at, near):
            continue
        low, high = bounding_box(face)
        reaches = any(
            min(abs(low[each.across.value] - each.place), abs(high[each.across.value] - each.place))
            <= near
            for each in breaks
        )
        if not reaches:
            continue
        outer = BRepTools.OuterWire_s(face)
        for wire in subshapes(face, TopAbs_ShapeEnum.TopAbs_WIRE):
            edges = [
                TopoDS.Edge(subshape) for subshape in subshapes(wire, TopAbs_ShapeEnum.TopAbs_EDGE)
            ]
            middles = [_middle(edge, plan.axis) for edge in edges]
            if wire.IsSame(outer) or all(at.distance(bands) <= near for at in middles):
                place = shapely.MultiPoint(middles).centroid
                yield _Loop(tuple((edge, face) for edge in edges), place)


def _middle(edge: TopoDS_Edge, axis: Axis) -> shapely.Point:
    """A place in the middle of an edge, in the plane across an axis."""
    curve = BRepAdaptor_Curve(edge)
    found = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2.0)
    place = found.X(), found.Y(), found.Z()
    return shapely.Point(*(place[index] for index in IN_PLANE[axis]))
