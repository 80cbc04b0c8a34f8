"""Which surfaces of a part the cells of the exact solver cannot express."""

from collections import Counter

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Dir
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import faces_of

_ALONG = 1e-6
"""Sine of the angle up to which an axis is parallel to one of the part's."""

_FREE = "free-form"


def unsupported(shape: TopoDS_Shape) -> dict[str, int]:
    """Numbers of the faces that no cells express, by kind, in order of their number.

    Planes and spheres are expressed however they lie; cylinders, cones and tori if their axis is
    parallel to one of the part's.
    """
    kinds = Counter(kind for face in faces_of(shape) if (kind := _unsupported(face)))
    return dict(kinds.most_common())


def _unsupported(face: TopoDS_Face) -> str:
    surface = BRepAdaptor_Surface(face)
    kind = surface.GetType()
    if kind in (GeomAbs_SurfaceType.GeomAbs_Plane, GeomAbs_SurfaceType.GeomAbs_Sphere):
        return ""
    if kind == GeomAbs_SurfaceType.GeomAbs_Cylinder:
        return _leaning("cylinder", surface.Cylinder().Axis().Direction())
    if kind == GeomAbs_SurfaceType.GeomAbs_Cone:
        return _leaning("cone", surface.Cone().Axis().Direction())
    if kind == GeomAbs_SurfaceType.GeomAbs_Torus:
        return _leaning("torus", surface.Torus().Axis().Direction())
    return _FREE


def _leaning(name: str, axis: gp_Dir) -> str:
    across = np.sort(np.abs([axis.X(), axis.Y(), axis.Z()]))[:2]
    return "" if float(np.hypot(*across)) < _ALONG else f"leaning {name}"
