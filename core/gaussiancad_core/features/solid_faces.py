"""What the faces of a solid are: planes, cylinders, cones, and on which side the material is."""

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepTools import BRepTools
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Ax1
from OCP.TopAbs import TopAbs_Orientation
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.surface_crossings import normal_at

Vector = npt.NDArray[np.float64]


class Kind(Enum):
    """The surface that a face lies on."""

    PLANE = "plane"
    CYLINDER = "cylinder"
    CONE = "cone"
    SPHERE = "sphere"
    TORUS = "torus"
    OTHER = "other"


_KINDS = {
    GeomAbs_SurfaceType.GeomAbs_Plane: Kind.PLANE,
    GeomAbs_SurfaceType.GeomAbs_Cylinder: Kind.CYLINDER,
    GeomAbs_SurfaceType.GeomAbs_Cone: Kind.CONE,
    GeomAbs_SurfaceType.GeomAbs_Sphere: Kind.SPHERE,
    GeomAbs_SurfaceType.GeomAbs_Torus: Kind.TORUS,
}


@dataclass(frozen=True, eq=False)
class SolidFace:
    """A face of a solid, and the surface that it lies on.

    Attributes:
        face: as the kernel has it.
        kind: of its surface.
        point, direction: of the surface's axis, or of a plane and its normal, which points out of
            the material; mm. (0, 0, 0) twice where there is no axis.
        radius: mm, of a cylinder or sphere; the larger one of a torus; 0 of others.
        minor: mm, of a torus.
        is_concave: whether the material lies around its axis or centre, as in a bore.
        turn: radians of a turn around its axis that the face's parameters cover.
        place: a point of the surface, in the middle of the face's parameters.
    """

    face: TopoDS_Face
    kind: Kind
    point: Vector
    direction: Vector
    place: Vector
    radius: float = 0.0
    minor: float = 0.0
    is_concave: bool = False
    turn: float = 0.0


def solid_faces(shape: TopoDS_Shape) -> tuple[SolidFace, ...]:
    """All faces of a solid in mm."""
    return tuple(_described(face) for face in faces_of(shape))


def _described(face: TopoDS_Face) -> SolidFace:
    surface = BRepAdaptor_Surface(face)
    kind = _KINDS.get(surface.GetType(), Kind.OTHER)
    low, high, bottom, top = BRepTools.UVBounds_s(face)
    outward = normal_at(surface, (low + high) / 2.0, (bottom + top) / 2.0)
    if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
        outward = -outward
    place = surface.Value((low + high) / 2.0, (bottom + top) / 2.0)
    at = np.array([place.X(), place.Y(), place.Z()])
    if kind is Kind.PLANE:
        return SolidFace(face, kind, at, outward, at)
    if kind is Kind.OTHER:
        return SolidFace(face, kind, np.zeros(3), np.zeros(3), at)
    point, direction = _axis_of(surface, kind)
    inward = point + direction * float((at - point) @ direction) - at
    if kind is Kind.SPHERE:
        inward = point - at
        return SolidFace(
            face, kind, point, direction, at, surface.Sphere().Radius(), 0.0, inward @ outward > 0.0
        )
    if kind is Kind.TORUS:
        torus = surface.Torus()
        # The nearest point of the circle in its middle.
        flat = at - point - direction * float((at - point) @ direction)
        middle = point + flat * (torus.MajorRadius() / float(np.linalg.norm(flat)))
        concave = bool((middle - at) @ outward > 0.0)
        radii = torus.MajorRadius(), torus.MinorRadius()
        return SolidFace(face, kind, point, direction, at, *radii, concave, high - low)
    radius = surface.Cylinder().Radius() if kind is Kind.CYLINDER else 0.0
    return SolidFace(
        face, kind, point, direction, at, radius, 0.0, bool(inward @ outward > 0.0), high - low
    )


def _axis_of(surface: BRepAdaptor_Surface, kind: Kind) -> tuple[Vector, Vector]:
    if kind is Kind.SPHERE:
        place = surface.Sphere().Position()
        axis = place.Axis()
    elif kind is Kind.TORUS:
        axis = surface.Torus().Axis()
    else:
        axis = (surface.Cylinder() if kind is Kind.CYLINDER else surface.Cone()).Axis()
    return line_of(axis)


def line_of(axis: gp_Ax1) -> tuple[Vector, Vector]:
    """(3,) point and (3,) unit direction of an axis."""
    point, direction = axis.Location(), axis.Direction()
    return (
        np.array([point.X(), point.Y(), point.Z()]),
        np.array([direction.X(), direction.Y(), direction.Z()]),
    )


def cone_of(face: SolidFace, heights: tuple[float, float]) -> tuple[tuple[Vector, float], ...]:
    """(point on the axis in mm, radius in mm) of a cone at two of its parameters along it."""
    cone = BRepAdaptor_Surface(face.face).Cone()
    half = cone.SemiAngle()
    return tuple(
        (
            face.point + at * np.cos(half) * face.direction,
            float(abs(cone.RefRadius() + at * np.sin(half))),
        )
        for at in heights
    )


def v_range(face: SolidFace) -> tuple[float, float]:
    """The face's parameters along the axis of its surface."""
    _, _, bottom, top = BRepTools.UVBounds_s(face.face)
    return float(bottom), float(top)


def u_range(face: SolidFace) -> tuple[float, float]:
    """The face's parameters around the axis of its surface, radians."""
    low, high, _, _ = BRepTools.UVBounds_s(face.face)
    return float(low), float(high)
