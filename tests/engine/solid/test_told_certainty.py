"""How much of a solid is in doubt whose measures the sheet tells in numbers."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import Axis
from gaussiancad_core.drawing.brep import volume
from gaussiancad_core.modes import Status
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.told import ToldLength, ToldNumbers
from gaussiancad_core.reasoning.told_places import ToldPlaces
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.told_certainty import ToldMeasures
from gaussiancad_core.solid.verify import verify

_UNSURE, _BESIDE, _DIGIT = 0.03, 0.05, 0.01


def _doubt(
    shape: TopoDS_Shape,
    x: tuple[float, ...],
    y: tuple[float, ...],
    z: tuple[float, ...],
    *radii: float,
) -> float:
    places = ToldPlaces(dict(zip(Axis, (x, y, z), strict=True)), radii, _BESIDE, _DIGIT)
    return ToldMeasures(places, 1e-3).volume_in_doubt(shape, _UNSURE)


def test_told_faces_are_rounded_and_one_of_them_misread() -> None:
    box = BRepPrimAPI_MakeBox(40.31, 30.17, 20.0).Solid()
    top, front, side = 40.31 * 30.17, 40.31 * 20.0, 30.17 * 20.0
    rounded, misread = 0.25 * _DIGIT, _BESIDE * top
    whole = 2.0 * (top + front + side)
    told = _doubt(box, (0.0, 40.31), (0.0, 30.17), (0.0, 20.0))
    assert told == pytest.approx(rounded * whole + misread)
    # One that no number tells is off as without any.
    told = _doubt(box, (0.0, 40.31), (0.0,), (0.0, 20.0))
    assert told == pytest.approx(rounded * (whole - front) + _UNSURE * front + misread)
    nothing = _doubt(box, (), (), ())
    assert nothing == pytest.approx(_UNSURE * whole)


def test_a_bore_is_told_by_its_axis_and_radius() -> None:
    axis = gp_Ax2(gp_Pnt(20.3, 11.7, -1.0), gp_Dir(0.0, 0.0, 1.0))
    block = BRepPrimAPI_MakeBox(60.0, 40.0, 30.0).Solid()
    bored = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(axis, 4.1, 50.0).Shape()).Shape()
    ends = (0.0, 60.0), (0.0, 40.0), (0.0, 30.0)
    wall = _UNSURE - 0.25 * _DIGIT

    def doubt(x: float, y: float, radius: float) -> float:
        return _doubt(bored, (*ends[0], x), (*ends[1], y), ends[2], radius)

    told = doubt(20.3, 11.7, 4.1)
    for other in ((20.4, 11.7, 4.1), (20.3, 11.8, 4.1), (20.3, 11.7, 4.2)):
        assert doubt(*other) - told == pytest.approx(wall * 2.0 * 3.14159265 * 4.1 * 30.0)


@pytest.mark.parametrize(("beside", "close"), [(0.002, True), (0.05, False)])
def test_a_part_whose_numbers_are_drawn_as_they_say_is_known(
    beside: float, close: bool, drawn: Callable[..., DrawnViews]
) -> None:
    solid = BRepPrimAPI_MakeBox(60.41, 40.0, 24.17).Solid()
    noisy = replace(drawn(solid), noise=0.004)
    assert not verify(solid, noisy).close
    values = {Axis.X: (0.0, 60.41), Axis.Y: (0.0, 40.0), Axis.Z: (0.0, 24.17)}
    told = ToldMeasures(ToldPlaces(values, (), beside, 0.001), 1e-3)
    assert verify(solid, noisy, [told]).close == close


@pytest.mark.parametrize("numbered", [True, False])
def test_a_part_with_all_its_numbers_is_verified_and_has_them(
    numbered: bool, drawn: Callable[..., DrawnViews]
) -> None:
    block = BRepPrimAPI_MakeBox(60.41, 40.17, 24.17).Solid()
    step = BRepPrimAPI_MakeBox(gp_Pnt(33.73, -1.0, 11.09), 60.0, 60.0, 60.0).Solid()
    solid = BRepAlgoAPI_Cut(block, step).Shape()
    # A picture's lines: off by hundredths, for which the numbers make up.
    told = [
        ToldLength(axis, 0.01, value - 0.01, value)
        for axis, value in (
            (Axis.X, 33.73),
            (Axis.X, 60.41),
            (Axis.Y, 40.17),
            (Axis.Z, 11.09),
            (Axis.Z, 24.17),
        )
    ]
    views = replace(
        drawn(solid),
        tolerance=0.2,
        apart=0.3,
        noise=0.005,
        told=ToldNumbers(tuple(told if numbered else told[1:3]), 0.05, 0.001),
    )
    result = exact_solid(views)
    assert volume(result.shape) == pytest.approx(volume(solid), rel=1e-9)
    assert (result.status is Status.VERIFIED) == numbered
    assert {code for code, _ in result.reasons} == (set() if numbered else {"lines-inexact"})
