"""Which surfaces a part has, as far as its class goes."""

from enum import Enum

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Dir
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import faces_of

_ALONG = 1e-9
"""Components of a direction below this are zero."""


class SurfaceKind(Enum):
    """A surface and how it lies to the axes."""

    PLANE = "plane across an axis"
    SLANT = "plane seen edge-on in one view"
    OBLIQUE = "plane seen edge-on in no view"
    CYLINDER = "cylinder along an axis"
    CONE = "cone about an axis"
    SPHERE = "sphere"
    TORUS = "torus about an axis"
    OTHER = "anything else"


_ROUND = {
    GeomAbs_SurfaceType.GeomAbs_Cylinder: (SurfaceKind.CYLINDER, "Cylinder"),
    GeomAbs_SurfaceType.GeomAbs_Cone: (SurfaceKind.CONE, "Cone"),
    GeomAbs_SurfaceType.GeomAbs_Torus: (SurfaceKind.TORUS, "Torus"),
}


def surface_kinds(shape: TopoDS_Shape) -> frozenset[SurfaceKind]:
    """All kinds of surfaces that a shape has."""
    return frozenset(_kind(face) for face in faces_of(shape))


def _kind(face: TopoDS_Face) -> SurfaceKind:
    surface = BRepAdaptor_Surface(face)
    form = surface.GetType()
    if form == GeomAbs_SurfaceType.GeomAbs_Sphere:
        return SurfaceKind.SPHERE
    if form == GeomAbs_SurfaceType.GeomAbs_Plane:
        axes = int((np.abs(_vector(surface.Plane().Axis().Direction())) > _ALONG).sum())
        return (SurfaceKind.PLANE, SurfaceKind.SLANT, SurfaceKind.OBLIQUE)[axes - 1]
    if form not in _ROUND:
        return SurfaceKind.OTHER
    kind, name = _ROUND[form]
    way = _vector(getattr(surface, name)().Axis().Direction())
    return kind if np.abs(way).max() > 1.0 - _ALONG else SurfaceKind.OTHER


def _vector(direction: gp_Dir) -> npt.NDArray[np.float64]:
    return np.array([direction.X(), direction.Y(), direction.Z()])
