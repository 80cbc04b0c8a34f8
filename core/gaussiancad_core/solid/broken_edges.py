"""Chamfers put on the edges of a solid that was found without them."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer
from OCP.BRepTools import BRepTools
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape
from scipy.spatial import cKDTree

from gaussiancad_core.drawing.brep import bounding_box, faces_of, subshapes
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.reasoning.edge_breaks import EdgeBreak
from gaussiancad_core.reasoning.planes import IN_PLANE

_REACH, _FLOOR = 3.0, 1e-3
"""Distance of an edge from the contour at most, in tolerances and in mm at least."""

_PLACES = 9
"""Places along an edge at which it has to lie on the contour."""


def with_broken_edges(
    shape: TopoDS_Shape, breaks: Sequence[EdgeBreak], near: float
) -> TopoDS_Shape | None:
    """A solid with chamfers around its faces.

    Args:
        shape: with sharp edges, mm.
        breaks: the chamfers.
        near: mm, the tolerance of the views.

    Returns:
        None where no edges are there to be chamfered, or the kernel cannot do it.
    """
    near = max(_REACH * near, _FLOOR)
    maker = BRepFilletAPI_MakeChamfer(shape)
    found = [(own, *each) for own in breaks for each in _edges(shape, own, near)]
    if not found:
        return None
    try:
        for own, edge, face in found:
            maker.Add(own.width, abs(own.height), edge, face)
        maker.Build()
        return maker.Shape() if maker.IsDone() else None
    except KERNEL_FAILURES:
        return None


def _edges(
    shape: TopoDS_Shape, own: EdgeBreak, near: float
) -> list[tuple[TopoDS_Edge, TopoDS_Face]]:
    """Edges of a face at the depth of a chamfer that lie on its contour, with the face; all around
    it where that is not known."""
    contour = cKDTree(_chained(own, near)) if own.contour else None
    found = []
    for face in faces_of(shape):
        if not _is_across(face, own, near):
            continue
        if contour is None and not _spans(face, own, near):
            continue
        outline = face if contour is not None else BRepTools.OuterWire_s(face)
        for edge in map(TopoDS.Edge, subshapes(outline, TopAbs_ShapeEnum.TopAbs_EDGE)):
            if contour is None or _lies_on(edge, contour, own, near):
                found.append((edge, face))
    return found


def _lies_on(edge: TopoDS_Edge, contour: cKDTree, own: EdgeBreak, near: float) -> bool:
    curve = BRepAdaptor_Curve(edge)
    at = np.linspace(curve.FirstParameter(), curve.LastParameter(), _PLACES)
    points = np.array([(p.X(), p.Y(), p.Z()) for p in map(curve.Value, at.tolist())])
    return float(contour.query(points[:, list(IN_PLANE[own.normal])])[0].max()) <= 2.0 * near


def _spans(face: TopoDS_Face, own: EdgeBreak, near: float) -> bool:
    """Whether a face reaches as far as the one that is chamfered."""
    low, high = bounding_box(face)
    return all(
        abs(low[axis.value] - span[0]) <= near and abs(high[axis.value] - span[1]) <= near
        for axis, span in own.spans.items()
    )


def _chained(own: EdgeBreak, near: float) -> np.ndarray:
    """(n, 2) points along the contour, close together."""
    found = []
    for points in own.contour:
        for start, end in pairwise(points):
            count = max(2, int(np.hypot(*(end - start)) / near) + 1)
            found.append(np.linspace(start, end, min(count, 20_000)))
    return np.concatenate(found)


def _is_across(face: TopoDS_Face, own: EdgeBreak, near: float) -> bool:
    """Whether a face lies across the chamfer's axis, at its depth."""
    surface = BRepAdaptor_Surface(face)
    if surface.GetType() != GeomAbs_SurfaceType.GeomAbs_Plane:
        return False
    plane = surface.Plane()
    way, at = plane.Axis().Direction(), plane.Location()
    across = abs((way.X(), way.Y(), way.Z())[own.normal.value]) > 1.0 - 1e-6
    return across and abs((at.X(), at.Y(), at.Z())[own.normal.value] - own.depth) <= near
