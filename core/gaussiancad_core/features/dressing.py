"""Fillets and chamfers put on a solid again, along edges that are told by a point on each."""

from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer, BRepFilletAPI_MakeFillet
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape

from gaussiancad_core.features.blends import Blend
from gaussiancad_core.features.feature_model import EdgeBreak
from gaussiancad_core.kernel.booleans import unified
from gaussiancad_core.kernel.brep import edges_of, is_valid
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

Vector = npt.NDArray[np.float64]

_SAME = 1e-4
"""Units within which sizes are one."""

_FARTHEST = 1.6
"""Sizes of a blend between it and the edge that it breaks, at most."""


def breaks_of(blends: Iterable[Blend], undressed: TopoDS_Shape) -> tuple[EdgeBreak, ...]:
    """What is to be broken of a solid for it to have blends again; the largest first.

    Args:
        blends: that it has no more; units.
        undressed: the solid without them.
    """
    edges = edges_of(undressed)
    places: dict[tuple[bool, float], list[tuple[float, float, float]]] = {}
    taken: dict[tuple[bool, float], set[int]] = {}
    for blend in blends:
        if blend.is_corner:
            continue
        number, place = _nearest(edges, blend.place)
        if float(np.linalg.norm(place - blend.place)) > _FARTHEST * blend.size:
            continue
        key = blend.is_round, _like(blend.size, places, blend.is_round)
        if number not in taken.setdefault(key, set()):
            taken[key].add(number)
            places.setdefault(key, []).append((float(place[0]), float(place[1]), float(place[2])))
    return tuple(
        EdgeBreak(tuple(found), size, is_round)
        for (is_round, size), found in sorted(places.items(), key=lambda entry: -entry[0][1])
    )


def dressed(shape: TopoDS_Shape, breaks: Sequence[EdgeBreak]) -> TopoDS_Shape | None:
    """A solid with broken edges; None where the kernel cannot break them."""
    body = unified(shape)
    for feature in breaks:
        try:
            edges = edges_of(body)
            chosen = {_nearest(edges, np.array(place))[0] for place in feature.places}
            if feature.is_round:
                maker = BRepFilletAPI_MakeFillet(body)
            else:
                maker = BRepFilletAPI_MakeChamfer(body)
            for number in sorted(chosen):
                maker.Add(feature.size, edges[number])
            maker.Build()
            if not maker.IsDone() or not is_valid(maker.Shape()):
                return None
            body = maker.Shape()
        except KERNEL_FAILURES:
            return None
    return body


def _like(
    size: float, places: dict[tuple[bool, float], list[tuple[float, float, float]]], is_round: bool
) -> float:
    """A size that is known already, where one is like this."""
    known = [other for kind, other in places if kind == is_round and abs(other - size) < _SAME]
    return known[0] if known else size


def _nearest(edges: Sequence[TopoDS_Edge], place: Vector) -> tuple[int, Vector]:
    """The number of the edge that is nearest to a place, and its nearest point."""
    vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*place.tolist())).Vertex()
    best, number, point = np.inf, 0, place
    for k, edge in enumerate(edges):
        apart = BRepExtrema_DistShapeShape(vertex, edge)
        if apart.IsDone() and apart.Value() < best:
            found = apart.PointOnShape2(1)
            best, number = apart.Value(), k
            point = np.array([found.X(), found.Y(), found.Z()])
    return number, point
