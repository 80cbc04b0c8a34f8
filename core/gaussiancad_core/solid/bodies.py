"""Faces of the extra bodies: of revolution, and half spaces."""

from math import cos, pi, sin

import numpy as np
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakePolygon,
)
from OCP.BRepPrimAPI import BRepPrimAPI_MakeRevol
from OCP.GC import GC_MakeArcOfCircle
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Face

from gaussiancad_core.drawing.brep import faces_of
from gaussiancad_core.reasoning.bodies import LineProfile, RevolvedBody
from gaussiancad_core.reasoning.columns import Body, Vector
from gaussiancad_core.reasoning.half_spaces import HalfSpace
from gaussiancad_core.reasoning.planes import IN_PLANE, lifted


def body_faces(body: Body) -> list[TopoDS_Face]:
    """Faces in units that hold all of the part's surface that a body gives it."""
    if isinstance(body, HalfSpace):
        return [_plane_face(hull) for hull in body.hulls]
    return [revolved_face(body)] if isinstance(body, RevolvedBody) else []


def _plane_face(hull: tuple[Vector, ...]) -> TopoDS_Face:
    outline = BRepBuilderAPI_MakePolygon()
    for corner in hull:
        outline.Add(gp_Pnt(*corner))
    outline.Close()
    return BRepBuilderAPI_MakeFace(outline.Wire(), True).Face()


def revolved_face(body: RevolvedBody) -> TopoDS_Face:
    """The face that a body's profile sweeps, in units."""
    profile, (a, b) = body.profile, body.centre
    start_angle, sweep = body.sector or (0.0, 2.0 * pi)
    right, up = cos(start_angle), sin(start_angle)

    def point(z: float) -> gp_Pnt:
        radius = profile.radius(z)
        return gp_Pnt(*lifted(body.axis, a + radius * right, b + radius * up, z))

    start, end = point(profile.low), point(profile.high)
    if isinstance(profile, LineProfile):
        edge = BRepBuilderAPI_MakeEdge(start, end).Edge()
    else:
        middle = point((profile.low + profile.high) / 2.0)
        edge = BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(start, middle, end).Value()).Edge()
    # From the plane's first axis towards its second: against y where those are x and z.
    first, second = IN_PLANE[body.axis]
    direction = gp_Dir(*map(float, np.cross(np.eye(3)[first], np.eye(3)[second])))
    axis = gp_Ax1(gp_Pnt(*lifted(body.axis, a, b, 0.0)), direction)
    (face,) = faces_of(BRepPrimAPI_MakeRevol(edge, axis, float(sweep)).Shape())
    return face
