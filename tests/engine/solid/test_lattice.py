"""Which faces follow from multiples of a step."""

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCone,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakePrism,
    BRepPrimAPI_MakeSphere,
    BRepPrimAPI_MakeTorus,
)
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt, gp_Vec
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.brep import area
from gaussiancad_core.solid.lattice import area_in_doubt

_PLACE = gp_Ax2(gp_Pnt(20.0, 30.0, 5.0), gp_Dir(0.0, 0.0, 1.0))


def _prism(*corners: tuple[float, float]) -> TopoDS_Shape:
    polygon = BRepBuilderAPI_MakePolygon()
    for x, y in corners:
        polygon.Add(gp_Pnt(x, y, 0.0))
    polygon.Close()
    return BRepPrimAPI_MakePrism(
        BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0.0, 0.0, 10.0)
    ).Shape()


def test_the_sides_of_a_box_are_known_one_by_one() -> None:
    assert area_in_doubt(BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Solid(), 1.0) == 0.0
    box = BRepPrimAPI_MakeBox(40.0, 30.0, 20.3).Solid()
    assert area_in_doubt(box, 1.0) == pytest.approx(40.0 * 30.0)
    assert area_in_doubt(box, 0.1) == 0.0


@pytest.mark.parametrize(
    ("made", "step", "doubtful"),
    [
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.0, 10.0), 1.0, 0.0),
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.2, 10.0), 1.0, 2.0 * np.pi * 42.0),
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.0, 10.0), 3.0, 2.0 * np.pi * 40.0 + 16.0 * np.pi),
        (BRepPrimAPI_MakeCone(_PLACE, 8.0, 4.0, 3.0), 1.0, 0.0),
        (BRepPrimAPI_MakeCone(_PLACE, 8.0, 4.5, 3.5), 1.0, None),
        (BRepPrimAPI_MakeCone(_PLACE, 6.0, 0.0, 3.0), 1.0, 0.0),
        (BRepPrimAPI_MakeSphere(_PLACE, 6.0), 1.0, 0.0),
        (BRepPrimAPI_MakeSphere(_PLACE, 6.3), 1.0, 4.0 * np.pi * 6.3**2),
        (BRepPrimAPI_MakeTorus(_PLACE, 12.0, 3.0), 1.0, 0.0),
        (BRepPrimAPI_MakeTorus(_PLACE, 12.4, 3.0), 1.0, 4.0 * np.pi**2 * 12.4 * 3.0),
    ],
)
def test_round_faces_by_their_axis_and_radii(
    made: object, step: float, doubtful: float | None
) -> None:
    shape = made.Shape()
    found = area_in_doubt(shape, step)
    if doubtful is None:
        # The slanted face and the lid, whose height is none either.
        doubtful = area(shape) - np.pi * 8.0**2
    assert found == pytest.approx(doubtful)


def test_a_slanted_side_is_known_by_two_of_its_edges() -> None:
    known = (0.0, 0.0), (30.0, 0.0), (22.0, 20.0), (0.0, 20.0)
    assert area_in_doubt(_prism(*known), 1.0) == 0.0
    # Cut off where no number is round, it still goes through one round edge alone.
    cut = (0.0, 0.0), (30.0, 0.0), (25.2, 12.0), (20.7, 20.0), (0.0, 20.0)
    slants = [np.hypot(4.8, 12.0), np.hypot(4.5, 8.0)]
    assert area_in_doubt(_prism(*cut), 1.0) == pytest.approx(10.0 * sum(slants))


def test_an_oblique_face_is_known_by_three_corners() -> None:
    def corner(x: float, y: float, z: float) -> TopoDS_Shape:
        block = BRepPrimAPI_MakeBox(40.0, 40.0, 40.0).Solid()
        a, b, c = gp_Pnt(x, 40.0, 40.0), gp_Pnt(40.0, y, 40.0), gp_Pnt(40.0, 40.0, z)
        face = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakePolygon(a, b, c, True).Wire()).Face()
        tool = BRepPrimAPI_MakePrism(face, gp_Vec(40.0, 40.0, 40.0)).Shape()
        return BRepAlgoAPI_Cut(block, tool).Shape()

    assert area_in_doubt(corner(20.0, 25.0, 30.0), 1.0) == 0.0
    legs = np.array([40.0 - 20.4, 15.0, 10.0])
    sides = np.array([[legs[0], -legs[1], 0.0], [legs[0], 0.0, -legs[2]]])
    oblique = float(np.linalg.norm(np.cross(*sides))) / 2.0
    assert area_in_doubt(corner(20.4, 25.0, 30.0), 1.0) == pytest.approx(oblique)
