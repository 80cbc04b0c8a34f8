"""What a solid's edges are: sharp, smooth, or a silhouette in a given direction.

A smooth edge (a fillet's border, a cylinder's seam) is no line of a drawing, unless the surface
turns away from the viewer exactly there.  Which it is follows from the outward normals at both
sides and the look direction, not from the flags of a hidden-line algorithm.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve2d, BRepAdaptor_Surface
from OCP.Geom import Geom_Curve
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS, TopoDS_Edge, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import ShapeTable, explore, faces_of
from gaussiancad_core.kernel.surface_crossings import normal_at

SMOOTH_ANGLE = 0.01745
"""Radians between the normals of both sides under which an edge is smooth: one degree."""

GRAZING = SMOOTH_ANGLE
"""Largest |normal . look| along a smooth edge that may be a silhouette."""

_SAMPLES = np.array([0.07, 0.29, 0.5, 0.71, 0.93])


@dataclass(frozen=True)
class EdgeFacts:
    """One edge of a solid.

    Attributes:
        edge: the edge.
        faces: on its sides.
        normals: (sides, k, 3) outward unit normals of the faces along the edge; NaN where a
            surface has none (a cone's apex).
        smooth: the normals of both sides agree all along.
        curved: at least one side is no plane.
        seam: both sides are the same face.
    """

    edge: TopoDS_Edge
    faces: tuple[TopoDS_Face, ...]
    normals: npt.NDArray[np.float64]
    smooth: bool
    curved: bool
    seam: bool

    def silhouette(self, look: npt.NDArray[np.float64]) -> bool:
        """Whether a smooth edge is where the surface turns away from the viewer."""
        grazing = bool(np.nanmax(np.abs(self.normals @ look)) < GRAZING)
        return self.smooth and self.curved and grazing


def edge_facts(shape: TopoDS_Shape) -> list[EdgeFacts]:
    """The facts of every edge that has a length."""
    table = ShapeTable()
    sides: list[list[TopoDS_Face]] = []
    for face in faces_of(shape):
        for edge in explore(face, TopAbs_ShapeEnum.TopAbs_EDGE):
            number = table.number(edge)
            if number == len(sides):
                sides.append([])
            sides[number].append(face)
    facts = []
    for shape_edge, faces in zip(table.shapes, sides, strict=True):
        edge = TopoDS.Edge(shape_edge)
        if not BRep_Tool.Degenerated_s(edge):
            facts.append(_facts(edge, faces))
    return facts


def _facts(edge: TopoDS_Edge, faces: list[TopoDS_Face]) -> EdgeFacts:
    normals = np.array([_normals_along(edge, face) for face in faces])
    planes = [
        BRepAdaptor_Surface(face).GetType() == GeomAbs_SurfaceType.GeomAbs_Plane for face in faces
    ]
    smooth = len(faces) == 2 and _parallel(normals[0], normals[1])
    seam = len(faces) == 2 and faces[0].IsSame(faces[1])
    return EdgeFacts(edge, tuple(faces), normals, smooth, not all(planes), seam)


def raw_curve(edge: TopoDS_Edge) -> Geom_Curve:
    """The edge's 3D curve before its location: the same Python object for every copy of it."""
    return BRep_Tool.Curve_s(edge, TopLoc_Location(), 0.0, 0.0)


def _parallel(one: npt.NDArray[np.float64], other: npt.NDArray[np.float64]) -> bool:
    cosines = np.einsum("ij,ij->i", one, other)
    return bool(np.nanmin(cosines) > np.cos(SMOOTH_ANGLE))


def _normals_along(edge: TopoDS_Edge, face: TopoDS_Face) -> npt.NDArray[np.float64]:
    """(k, 3) outward unit normals of a face along one of its edges."""
    flat = BRepAdaptor_Curve2d(edge, face)
    surface = BRepAdaptor_Surface(face)
    sign = -1.0 if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED else 1.0
    first, last = flat.FirstParameter(), flat.LastParameter()
    normals = []
    for share in _SAMPLES:
        at = flat.Value(float(first + share * (last - first)))
        normals.append(sign * normal_at(surface, at.X(), at.Y()))
    return np.array(normals)
