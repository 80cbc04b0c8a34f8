"""Faces of a solid that follow from what is known of its measures.

A plane across an axis lies at a known coordinate, a slanted one goes through two edges or three
corners whose coordinates are known, a cylinder has such an axis and radius; a cone has such an axis
and goes through known corners at two heights.
"""

from typing import Protocol

import numpy as np
import numpy.typing as npt
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Ax1, gp_Pnt
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Face

from gaussiancad_core.geometry.tolerances import COMPUTED, SHORTEST
from gaussiancad_core.kernel.brep import subshapes

Points = npt.NDArray[np.float64]
Known = npt.NDArray[np.bool_]


class KnownMeasures(Protocol):
    """What is known of a part's measures, mm; its bounding box starts at the origin."""

    def coordinates(self, axis: int, numbers: Points) -> Known:
        """(n,) which coordinates along an axis are known."""

    def radii(self, numbers: Points) -> Known:
        """(n,) which radii are known."""


def is_known(face: TopoDS_Face, measures: KnownMeasures) -> bool:
    """Whether a face follows from what is known."""
    surface = BRepAdaptor_Surface(face)
    kind = surface.GetType()
    if kind == GeomAbs_SurfaceType.GeomAbs_Plane:
        return _is_plane_known(_corners(face), _direction(surface.Plane().Axis()), measures)
    if kind == GeomAbs_SurfaceType.GeomAbs_Cylinder:
        cylinder = surface.Cylinder()
        return _is_axis_known(cylinder.Axis(), measures) and _are_radii(measures, cylinder.Radius())
    if kind == GeomAbs_SurfaceType.GeomAbs_Sphere:
        sphere = surface.Sphere()
        return _is_point(measures, sphere.Location()) and _are_radii(measures, sphere.Radius())
    if kind == GeomAbs_SurfaceType.GeomAbs_Torus:
        torus = surface.Torus()
        return (
            _along_axis(torus.Axis()) is not None
            and _is_point(measures, torus.Location())
            and _are_radii(measures, torus.MajorRadius(), torus.MinorRadius())
        )
    if kind == GeomAbs_SurfaceType.GeomAbs_Cone:
        return _is_cone_known(face, surface.Cone().Axis(), measures)
    return False


def axes_of(face: TopoDS_Face) -> tuple[bool, bool, bool]:
    """Along which of x, y and z a coordinate tells where a face is."""
    surface = BRepAdaptor_Surface(face)
    kind = surface.GetType()
    if kind == GeomAbs_SurfaceType.GeomAbs_Plane:
        x, y, z = (bool(abs(value) > COMPUTED) for value in _direction(surface.Plane().Axis()))
        return x, y, z
    if kind in (GeomAbs_SurfaceType.GeomAbs_Cylinder, GeomAbs_SurfaceType.GeomAbs_Cone):
        cylinder = kind == GeomAbs_SurfaceType.GeomAbs_Cylinder
        axis = (surface.Cylinder() if cylinder else surface.Cone()).Axis()
        along = _along_axis(axis)
        return along != 0, along != 1, along != 2
    return True, True, True


def _is_plane_known(corners: Points, normal: Points, measures: KnownMeasures) -> bool:
    """Whether a plane goes through enough corners that are known."""
    across = [k for k in range(3) if abs(normal[k]) > COMPUTED]
    # In the coordinates that tell where the plane is, known corners have to span it.
    each = [measures.coordinates(k, corners[:, k]) for k in across]
    known = corners[np.logical_and.reduce(each)][:, across]
    return (
        len(known) > 0 and np.linalg.matrix_rank(known - known[0], tol=SHORTEST) >= len(across) - 1
    )


def _is_cone_known(face: TopoDS_Face, axis: gp_Ax1, measures: KnownMeasures) -> bool:
    """Whether a cone has a known axis, and known corners at two heights."""
    along = _along_axis(axis)
    if along is None or not _is_axis_known(axis, measures):
        return False
    place = np.delete(_coordinates(axis.Location()), along)
    corners = _corners(face)
    away = np.hypot(*(np.delete(corners, along, axis=1) - place).T)
    heights = corners[:, along]
    # Its tip has no radius to know.
    radii = measures.radii(away) | (away <= SHORTEST)
    known = heights[radii & measures.coordinates(along, heights)]
    return len(known) > 0 and bool(np.ptp(known) > SHORTEST)


def _is_axis_known(axis: gp_Ax1, measures: KnownMeasures) -> bool:
    along = _along_axis(axis)
    place = _coordinates(axis.Location())
    return along is not None and all(
        measures.coordinates(k, place[[k]])[0] for k in range(3) if k != along
    )


def _is_point(measures: KnownMeasures, point: gp_Pnt) -> bool:
    place = _coordinates(point)
    return all(measures.coordinates(k, place[[k]])[0] for k in range(3))


def _are_radii(measures: KnownMeasures, *radii: float) -> bool:
    return bool(measures.radii(np.array(radii)).all())


def _along_axis(axis: gp_Ax1) -> int | None:
    """Along which axis of the model something runs, or None."""
    direction = np.abs(_direction(axis))
    return int(direction.argmax()) if np.sort(direction)[1] <= COMPUTED else None


def _direction(axis: gp_Ax1) -> Points:
    way = axis.Direction()
    return np.array([way.X(), way.Y(), way.Z()])


def _coordinates(point: gp_Pnt) -> Points:
    return np.array([point.X(), point.Y(), point.Z()])


def _corners(face: TopoDS_Face) -> Points:
    """(n, 3) mm of a face's corners; of a whole circle one point counts."""
    vertices = subshapes(face, TopAbs_ShapeEnum.TopAbs_VERTEX)
    found = [_coordinates(BRep_Tool.Pnt_s(TopoDS.Vertex(vertex))) for vertex in vertices]
    return np.array(found).reshape(-1, 3)
