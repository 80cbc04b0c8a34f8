"""How much of a solid is in doubt whose measures are round but for a few."""

from collections.abc import Callable
from dataclasses import replace
from math import inf, pi

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

from gaussiancad_core.drawing.brep import volume
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.solid.round_measures import RoundMeasures, is_round
from gaussiancad_core.solid.verify import verify

_PLACE = gp_Ax2(gp_Pnt(20.0, 30.0, 5.0), gp_Dir(0.0, 0.0, 1.0))
_REACH = 0.02


def _doubtful(shape: TopoDS_Shape, step: float = 1.0, odd: int = 1) -> float:
    """mm2 that may be off by the reach."""
    return RoundMeasures(step, _REACH, odd).volume_in_doubt(shape, 1.0) / _REACH


def _prism(*corners: tuple[float, float]) -> TopoDS_Shape:
    polygon = BRepBuilderAPI_MakePolygon()
    for x, y in corners:
        polygon.Add(gp_Pnt(x, y, 0.0))
    polygon.Close()
    face = BRepBuilderAPI_MakeFace(polygon.Wire()).Face()
    return BRepPrimAPI_MakePrism(face, gp_Vec(0.0, 0.0, 10.0)).Shape()


def test_odd_sides_are_in_doubt_and_the_largest_round_one() -> None:
    assert _doubtful(BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Solid()) == pytest.approx(1200.0)
    box = BRepPrimAPI_MakeBox(40.0, 30.0, 20.3).Solid()
    assert _doubtful(box) == pytest.approx(1200.0 + 1200.0)
    assert _doubtful(box, 0.1, odd=0) == pytest.approx(1200.0)


def test_faces_of_one_plane_are_off_together() -> None:
    block = BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Solid()
    slot = BRepPrimAPI_MakeBox(gp_Pnt(10.0, -1.0, 10.0), 20.0, 32.0, 11.0).Solid()
    slotted = BRepAlgoAPI_Cut(block, slot).Shape()
    assert _doubtful(slotted) == pytest.approx(1200.0)
    # What is left of the base is smaller than both halves of the top together.
    bore = BRepPrimAPI_MakeBox(gp_Pnt(10.0, 2.0, -1.0), 20.0, 27.0, 30.0).Solid()
    framed = BRepAlgoAPI_Cut(slotted, bore).Shape()
    assert _doubtful(framed) == pytest.approx(1200.0 - 540.0)


def test_where_two_may_be_round_by_chance_all_is_in_doubt() -> None:
    box = BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Solid()
    # One in twenty-five numbers is as near as that to a multiple.
    assert _doubtful(box, odd=2) < inf
    assert _doubtful(box, odd=3) == inf
    assert _doubtful(box, step=0.1) == inf
    assert _doubtful(box, step=0.01, odd=0) == pytest.approx(1200.0)


@pytest.mark.parametrize(
    ("made", "step", "odd", "largest"),
    [
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.0, 10.0).Shape(), 1.0, 0.0, 80.0 * pi),
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.2, 10.0).Shape(), 1.0, 84.0 * pi, 4.2**2 * pi),
        (BRepPrimAPI_MakeCylinder(_PLACE, 4.0, 10.0).Shape(), 3.0, 96.0 * pi, 16.0 * pi),
        (BRepPrimAPI_MakeCone(_PLACE, 8.0, 4.0, 3.0).Shape(), 1.0, 0.0, 64.0 * pi),
        (
            BRepPrimAPI_MakeCone(_PLACE, 8.0, 4.5, 3.5).Shape(),
            1.0,
            (12.5 * 3.5 * np.sqrt(2.0) + 4.5**2) * pi,
            64.0 * pi,
        ),
        (BRepPrimAPI_MakeCone(_PLACE, 6.0, 0.0, 3.0).Shape(), 1.0, 0.0, 18.0 * np.sqrt(5.0) * pi),
        (BRepPrimAPI_MakeSphere(_PLACE, 6.0).Shape(), 1.0, 0.0, 144.0 * pi),
        (BRepPrimAPI_MakeSphere(_PLACE, 6.3).Shape(), 1.0, 4.0 * pi * 6.3**2, 0.0),
        (BRepPrimAPI_MakeTorus(_PLACE, 12.0, 3.0).Shape(), 1.0, 0.0, 144.0 * pi**2),
        (BRepPrimAPI_MakeTorus(_PLACE, 12.4, 3.0).Shape(), 1.0, 4.0 * pi**2 * 12.4 * 3.0, 0.0),
    ],
)
def test_round_faces_by_their_axis_and_radii(
    made: TopoDS_Shape, step: float, odd: float, largest: float
) -> None:
    assert _doubtful(made, step) == pytest.approx(odd + largest)


def test_a_slanted_side_is_known_by_two_of_its_edges() -> None:
    lid = 520.0
    known = (0.0, 0.0), (30.0, 0.0), (22.0, 20.0), (0.0, 20.0)
    assert _doubtful(_prism(*known)) == pytest.approx(lid)
    # Cut off where no number is round, it still goes through one round edge alone.
    cut = (0.0, 0.0), (30.0, 0.0), (25.2, 12.0), (20.7, 20.0), (0.0, 20.0)
    slants = [np.hypot(4.8, 12.0), np.hypot(4.5, 8.0)]
    lid = volume(_prism(*cut)) / 10.0
    assert _doubtful(_prism(*cut)) == pytest.approx(lid + 10.0 * sum(slants))


def test_an_oblique_face_is_known_by_three_corners() -> None:
    def corner(x: float) -> TopoDS_Shape:
        block = BRepPrimAPI_MakeBox(40.0, 40.0, 40.0).Solid()
        a, b, c = gp_Pnt(x, 40.0, 40.0), gp_Pnt(40.0, 25.0, 40.0), gp_Pnt(40.0, 40.0, 30.0)
        face = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakePolygon(a, b, c, True).Wire()).Face()
        return BRepAlgoAPI_Cut(
            block, BRepPrimAPI_MakePrism(face, gp_Vec(40.0, 40.0, 40.0)).Shape()
        ).Shape()

    assert _doubtful(corner(20.0)) == pytest.approx(1600.0)
    legs = np.array([40.0 - 20.4, 15.0, 10.0])
    sides = np.array([[legs[0], -legs[1], 0.0], [legs[0], 0.0, -legs[2]]])
    oblique = float(np.linalg.norm(np.cross(*sides))) / 2.0
    assert _doubtful(corner(20.4)) == pytest.approx(1600.0 + oblique)


@pytest.mark.parametrize(("reach", "close"), [(0.004, True), (0.03, False)])
def test_a_part_with_one_odd_face_is_known_if_that_is_small(
    reach: float, close: bool, drawn: Callable[..., DrawnViews]
) -> None:
    block = BRepPrimAPI_MakeBox(60.0, 40.0, 24.0).Solid()
    notch = BRepPrimAPI_MakeBox(gp_Pnt(50.0, -1.0, 16.31), 11.0, 42.0, 9.0).Solid()
    solid = BRepAlgoAPI_Cut(block, notch).Shape()
    views = drawn(solid)
    noisy = replace(views, noise=0.02)
    assert not verify(solid, noisy).close
    found = verify(solid, noisy, [RoundMeasures(2.0, reach, 1)])
    assert found.close == close
    assert found.doubt <= verify(solid, noisy).doubt


def test_a_flat_on_a_round_bar_is_round_though_its_edges_are_not() -> None:
    bar = BRepPrimAPI_MakeCylinder(_PLACE, 10.0, 30.0).Shape()
    flat = BRepPrimAPI_MakeBox(gp_Pnt(28.0, 0.0, 0.0), 10.0, 60.0, 50.0).Solid()
    milled = BRepAlgoAPI_Cut(bar, flat).Shape()
    assert is_round(milled, 1.0)
    assert not is_round(milled, 3.0)
    odd = BRepPrimAPI_MakeBox(gp_Pnt(28.3, 0.0, 0.0), 10.0, 60.0, 50.0).Solid()
    assert not is_round(BRepAlgoAPI_Cut(bar, odd).Shape(), 1.0)


@pytest.mark.parametrize(
    ("step", "usual"), [(0.5, True), (1.0 + 1e-9, True), (98.36 / 295.0, False), (1.0003, False)]
)
def test_steps_that_parts_are_designed_in_are_usual(step: float, usual: bool) -> None:
    assert RoundMeasures(step, _REACH, 0).is_usual == usual
