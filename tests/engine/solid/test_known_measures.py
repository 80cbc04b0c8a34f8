"""Which faces of a solid follow from what is known of its measures."""

from math import pi

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

from gaussiancad_core.kernel.brep import area, faces_of
from gaussiancad_core.solid.known_faces import is_known
from gaussiancad_core.solid.known_measures import RoundMeasures

_PLACE = gp_Ax2(gp_Pnt(20.0, 30.0, 5.0), gp_Dir(0.0, 0.0, 1.0))
_REACH = 0.02


def _odd(shape: TopoDS_Shape, step: float = 1.0) -> float:
    """mm2 of the faces that do not follow from multiples of a step."""
    measures = RoundMeasures(step, _REACH, 1)
    return sum(area(face) for face in faces_of(shape) if not is_known(face, measures))


def _prism(*corners: tuple[float, float]) -> TopoDS_Shape:
    polygon = BRepBuilderAPI_MakePolygon()
    for x, y in corners:
        polygon.Add(gp_Pnt(x, y, 0.0))
    polygon.Close()
    face = BRepBuilderAPI_MakeFace(polygon.Wire()).Face()
    return BRepPrimAPI_MakePrism(face, gp_Vec(0.0, 0.0, 10.0)).Shape()


def test_sides_of_a_box_are_known_by_their_place() -> None:
    assert _odd(BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Solid()) == 0.0
    box = BRepPrimAPI_MakeBox(40.0, 30.0, 20.3).Solid()
    assert _odd(box) == pytest.approx(1200.0)
    assert _odd(box, 0.1) == 0.0


def test_where_two_may_be_round_by_chance_nothing_is_known() -> None:
    # One in twenty-five numbers is as near as that to a multiple.
    assert not RoundMeasures(1.0, _REACH, 2).is_chance
    assert RoundMeasures(1.0, _REACH, 3).is_chance
    assert RoundMeasures(0.1, _REACH, 1).is_chance
    assert not RoundMeasures(0.01, _REACH, 0).is_chance


@pytest.mark.parametrize(
    ("made", "step", "odd"),
    [
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.0, 10.0).Shape(), 1.0, 0.0),
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.2, 10.0).Shape(), 1.0, 84.0 * pi),
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.0, 10.0).Shape(), 3.0, 96.0 * pi),
        (BRepPrimAPI_MakeCone(_PLACE, 8.0, 4.0, 3.0).Shape(), 1.0, 0.0),
        (
            BRepPrimAPI_MakeCone(_PLACE, 8.0, 4.5, 3.5).Shape(),
            1.0,
            (12.5 * 3.5 * np.sqrt(2.0) + 4.5**2) * pi,
        ),
        (BRepPrimAPI_MakeCone(_PLACE, 6.0, 0.0, 3.0).Shape(), 1.0, 0.0),
        (BRepPrimAPI_MakeSphere(_PLACE, 6.0).Shape(), 1.0, 0.0),
        (BRepPrimAPI_MakeSphere(_PLACE, 6.3).Shape(), 1.0, 4.0 * pi * 6.3**2),
        (BRepPrimAPI_MakeTorus(_PLACE, 12.0, 3.0).Shape(), 1.0, 0.0),
        (BRepPrimAPI_MakeTorus(_PLACE, 12.4, 3.0).Shape(), 1.0, 4.0 * pi**2 * 12.4 * 3.0),
    ],
)
def test_round_faces_by_their_axis_and_radii(made: TopoDS_Shape, step: float, odd: float) -> None:
    assert _odd(made, step) == pytest.approx(odd)


def test_a_slanted_side_is_known_by_two_of_its_edges() -> None:
    known = (0.0, 0.0), (30.0, 0.0), (22.0, 20.0), (0.0, 20.0)
    assert _odd(_prism(*known)) == 0.0
    # Cut off where no number is round, it still goes through one round edge alone.
    cut = (0.0, 0.0), (30.0, 0.0), (25.2, 12.0), (20.7, 20.0), (0.0, 20.0)
    slants = [np.hypot(4.8, 12.0), np.hypot(4.5, 8.0)]
    assert _odd(_prism(*cut)) == pytest.approx(10.0 * sum(slants))


def test_an_oblique_face_is_known_by_three_corners() -> None:
    def corner(x: float) -> TopoDS_Shape:
        block = BRepPrimAPI_MakeBox(40.0, 40.0, 40.0).Solid()
        a, b, c = gp_Pnt(x, 40.0, 40.0), gp_Pnt(40.0, 25.0, 40.0), gp_Pnt(40.0, 40.0, 30.0)
        face = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakePolygon(a, b, c, True).Wire()).Face()
        return BRepAlgoAPI_Cut(
            block, BRepPrimAPI_MakePrism(face, gp_Vec(40.0, 40.0, 40.0)).Shape()
        ).Shape()

    assert _odd(corner(20.0)) == 0.0
    legs = np.array([40.0 - 20.4, 15.0, 10.0])
    sides = np.array([[legs[0], -legs[1], 0.0], [legs[0], 0.0, -legs[2]]])
    oblique = float(np.linalg.norm(np.cross(*sides))) / 2.0
    assert _odd(corner(20.4)) == pytest.approx(oblique)


def test_a_flat_on_a_round_bar_is_round_though_its_edges_are_not() -> None:
    bar = BRepPrimAPI_MakeCylinder(_PLACE, 10.0, 30.0).Shape()
    flat = BRepPrimAPI_MakeBox(gp_Pnt(28.0, 0.0, 0.0), 10.0, 60.0, 50.0).Solid()
    milled = BRepAlgoAPI_Cut(bar, flat).Shape()
    assert _odd(milled) == 0.0
    assert _odd(milled, 3.0) > 0.0
    odd = BRepPrimAPI_MakeBox(gp_Pnt(28.3, 0.0, 0.0), 10.0, 60.0, 50.0).Solid()
    assert _odd(BRepAlgoAPI_Cut(bar, odd).Shape()) > 0.0


@pytest.mark.parametrize(
    ("step", "usual"), [(0.5, True), (1.0 + 1e-9, True), (98.36 / 295.0, False), (1.0003, False)]
)
def test_steps_that_parts_are_designed_in_are_usual(step: float, usual: bool) -> None:
    assert RoundMeasures(step, _REACH, 0).is_usual == usual
