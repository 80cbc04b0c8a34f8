"""Faces of the bodies of revolution."""

from math import cos, pi, sin

import numpy as np
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
from OCP.BRepPrimAPI import BRepPrimAPI_MakeRevol
from OCP.GC import GC_MakeArcOfCircle
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Face

from gaussiancad_core.drawing.brep import faces_of
from gaussiancad_core.reasoning.bodies import LineProfile, RevolvedBody
from gaussiancad_core.reasoning.planes import IN_PLANE, lifted


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
