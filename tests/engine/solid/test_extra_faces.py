"""Faces of bodies of revolution."""

from math import pi

import pytest
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepGProp import BRepGProp
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.GProp import GProp_GProps
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Face

from gaussiancad_core.cells.surfaces_of_revolution import (
    ArcProfile,
    LineProfile,
    Profile,
    SurfaceOfRevolution,
)
from gaussiancad_core.kernel.brep import subshapes
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.solid.extra_faces import revolved_face

_CENTRE = (20.0, 30.0)


def _face(profile: Profile, axis: Axis, sector: tuple[float, float] | None = None) -> TopoDS_Face:
    return revolved_face(SurfaceOfRevolution(axis, _CENTRE, profile, sector))


def _area(face: TopoDS_Face) -> float:
    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(face, properties)
    return float(properties.Mass())


def _rims(face: TopoDS_Face) -> int:
    """Edges along circles about the axis that are no points."""
    edges = subshapes(face, TopAbs_ShapeEnum.TopAbs_EDGE)
    seams = [e for e in edges if BRep_Tool.IsClosed_s(TopoDS.Edge(e), TopoDS.Face(face))]
    points = [e for e in edges if BRep_Tool.Degenerated_s(TopoDS.Edge(e))]
    return len(edges) - len(seams) - len(points)


@pytest.mark.parametrize("axis", list(Axis))
@pytest.mark.parametrize("off", [0.0, 1e-9, 5e-8])
def test_a_sphere_whose_top_is_read_nearly_so_ends_in_a_point(axis: Axis, off: float) -> None:
    face = _face(ArcProfile(40.0, 50.0 - off, 40.0, 0.0, 10.0, 1), axis)
    assert BRepAdaptor_Surface(face).GetType() == GeomAbs_SurfaceType.GeomAbs_Sphere
    assert _area(face) == pytest.approx(2.0 * pi * 100.0)
    assert _rims(face) == 1


def test_a_cone_whose_tip_is_read_nearly_so_ends_in_a_point() -> None:
    face = _face(LineProfile(0.0, 4.0, 3.0, 1e-6), Axis.Z)
    assert BRepAdaptor_Surface(face).GetType() == GeomAbs_SurfaceType.GeomAbs_Cone
    assert _area(face) == pytest.approx(pi * 3.0 * 5.0)
    assert _rims(face) == 1


@pytest.mark.parametrize("side", [1, -1])
def test_a_torus_turns_the_part_of_its_circle_on_its_side(side: int) -> None:
    face = _face(ArcProfile(40.0, 44.0, 40.0, 12.0, 4.0, side), Axis.Y)
    assert BRepAdaptor_Surface(face).GetType() == GeomAbs_SurfaceType.GeomAbs_Torus
    # Pappus: the quarter circle's length times the way of its centre of mass.
    assert _area(face) == pytest.approx(2.0 * pi * (12.0 * 2.0 * pi + side * 16.0))
    assert _rims(face) == 2


def test_a_sector_turns_through_its_angle_only() -> None:
    whole = _face(ArcProfile(1.0, 3.0, 0.0, 0.0, 5.0, 1), Axis.X)
    part = _face(ArcProfile(1.0, 3.0, 0.0, 0.0, 5.0, 1), Axis.X, (0.5, pi / 3.0))
    assert _area(part) == pytest.approx(_area(whole) / 6.0)
