"""Faces of the extra bodies: of revolution, and half spaces."""

from math import asin, copysign, cos, pi, sin

import numpy as np
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakePolygon,
)
from OCP.BRepPrimAPI import BRepPrimAPI_MakeRevol
from OCP.gp import gp_Ax1, gp_Ax2, gp_Circ, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Face

from gaussiancad_core.cells.cell_complex import Body
from gaussiancad_core.cells.half_spaces import HalfSpace
from gaussiancad_core.cells.surfaces_of_revolution import (
    ArcProfile,
    LineProfile,
    SurfaceOfRevolution,
)
from gaussiancad_core.geometry.tolerances import SHORTEST
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.model.axes import Vector
from gaussiancad_core.model.projection_planes import IN_PLANE, lifted


def body_faces(body: Body) -> list[TopoDS_Face]:
    """Faces in units that hold all of the part's surface that a body gives it."""
    if isinstance(body, HalfSpace):
        return [_plane_face(hull) for hull in body.hulls]
    return [revolved_face(body)] if isinstance(body, SurfaceOfRevolution) else []


def _plane_face(hull: tuple[Vector, ...]) -> TopoDS_Face:
    outline = BRepBuilderAPI_MakePolygon()
    for corner in hull:
        outline.Add(gp_Pnt(*corner))
    outline.Close()
    return BRepBuilderAPI_MakeFace(outline.Wire(), True).Face()


def _angle(profile: ArcProfile, z: float) -> float:
    """Of an arc's end about its centre, from the direction that leaves the axis.

    What ends on the axis is to end there exactly: a rim that is nearly a point stays open.
    """
    rise = min(1.0, max(-1.0, (z - profile.z) / profile.radius_of_arc))
    if profile.r == 0.0 and profile.radius(z) < SHORTEST:
        rise = copysign(1.0, rise)
    return asin(rise) if profile.side > 0 else pi - asin(rise)


def revolved_face(body: SurfaceOfRevolution) -> TopoDS_Face:
    """The face that a body's profile sweeps, in units."""
    profile, (a, b) = body.profile, body.centre
    start_angle, sweep = body.sector or (0.0, 2.0 * pi)
    right, up = cos(start_angle), sin(start_angle)

    def point(z: float) -> gp_Pnt:
        radius = profile.radius(z) if profile.radius(z) > SHORTEST else 0.0
        return gp_Pnt(*lifted(body.axis, a + radius * right, b + radius * up, z))

    if isinstance(profile, LineProfile):
        edge = BRepBuilderAPI_MakeEdge(point(profile.low), point(profile.high)).Edge()
    else:
        centre = lifted(body.axis, a + profile.r * right, b + profile.r * up, profile.z)
        out = np.array(lifted(body.axis, right, up, 0.0))
        along = np.array(lifted(body.axis, 0.0, 0.0, 1.0))
        normal = gp_Dir(*map(float, np.cross(out, along)))
        frame = gp_Ax2(gp_Pnt(*centre), normal, gp_Dir(*map(float, out)))
        low, high = sorted((_angle(profile, profile.low), _angle(profile, profile.high)))
        edge = BRepBuilderAPI_MakeEdge(gp_Circ(frame, profile.radius_of_arc), low, high).Edge()
    # From the plane's first axis towards its second: against y where those are x and z.
    first, second = IN_PLANE[body.axis]
    direction = gp_Dir(*map(float, np.cross(np.eye(3)[first], np.eye(3)[second])))
    axis = gp_Ax1(gp_Pnt(*lifted(body.axis, a, b, 0.0)), direction)
    (face,) = faces_of(BRepPrimAPI_MakeRevol(edge, axis, float(sweep)).Shape())
    return face
