"""Chamfers put on the edges of a solid that was found without them."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape
from scipy.spatial import cKDTree

from gaussiancad_core.drawing.brep import faces_of, subshapes
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.reasoning.edge_breaks import EdgeBreak
from gaussiancad_core.reasoning.planes import IN_PLANE

_PLACES = 9
"""Places along an edge at which it has to lie on the contour."""


def with_broken_edges(
    shape: TopoDS_Shape, breaks: Sequence[EdgeBreak], near: float
) -> TopoDS_Shape | None:
    """A solid with chamfers around its faces.

    Args:
        shape: with sharp edges, mm.
        breaks: the chamfers.
        near: mm within which an edge lies on a contour.

    Returns:
        None where no edges are there to be chamfered, or the kernel cannot do it.
    """
    maker = BRepFilletAPI_MakeChamfer(shape)
    count = 0
    for own in breaks:
        for edge, face in _edges(shape, own, near):
            maker.Add(own.width, abs(own.height), edge, face)
            count += 1
    if not count:
        return None
    try:
        maker.Build()
        return maker.Shape() if maker.IsDone() else None
    except KERNEL_FAILURES:
        return None


def _edges(
    shape: TopoDS_Shape, own: EdgeBreak, near: float
) -> list[tuple[TopoDS_Edge, TopoDS_Face]]:
    """Edges of a face at the depth of a chamfer that lie on its contour, with the face."""
    contour = cKDTree(_chained(own, near))
    found = []
    for face in faces_of(shape):
        if not _is_flat(face, own):
            continue
        for edge in subshapes(face, TopAbs_ShapeEnum.TopAbs_EDGE):
            curve = BRepAdaptor_Curve(TopoDS.Edge(edge))
            at = np.linspace(curve.FirstParameter(), curve.LastParameter(), _PLACES)
            points = np.array([(p.X(), p.Y(), p.Z()) for p in map(curve.Value, at.tolist())])
            level = np.abs(points[:, own.normal.value] - own.depth).max() <= near
            flat = points[:, list(IN_PLANE[own.normal])]
            if level and contour.query(flat)[0].max() <= 2.0 * near:
                found.append((TopoDS.Edge(edge), face))
    return found


def _chained(own: EdgeBreak, near: float) -> np.ndarray:
    """(n, 2) points along the contour, close together."""
    found = []
    for points in own.contour:
        for start, end in pairwise(points):
            count = max(2, int(np.hypot(*(end - start)) / near) + 1)
            found.append(np.linspace(start, end, min(count, 20_000)))
    return np.concatenate(found)


def _is_flat(face: TopoDS_Face, own: EdgeBreak) -> bool:
    """Whether a face lies across the chamfer's axis."""
    surface = BRepAdaptor_Surface(face)
    if surface.GetType() != GeomAbs_SurfaceType.GeomAbs_Plane:
        return False
    way = surface.Plane().Axis().Direction()
    return abs((way.X(), way.Y(), way.Z())[own.normal.value]) > 1.0 - 1e-6
