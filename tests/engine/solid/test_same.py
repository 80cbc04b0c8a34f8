"""Whether solids are the same."""

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.solid.same import same_solid


def _box(x: float, y: float, z: float, *size: float) -> TopoDS_Shape:
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), *size).Solid()


def _bored(x: float, y: float) -> TopoDS_Shape:
    axis = gp_Ax2(gp_Pnt(x, y, -1.0), gp_Dir(0.0, 0.0, 1.0))
    return BRepAlgoAPI_Cut(
        _box(0, 0, 0, 40, 30, 20), BRepPrimAPI_MakeCylinder(axis, 4.0, 22.0).Solid()
    ).Shape()


def test_one_solid_made_in_two_ways_is_the_same() -> None:
    halves = BRepAlgoAPI_Fuse(_box(0, 0, 0, 15, 30, 20), _box(15, 0, 0, 25, 30, 20)).Shape()
    assert same_solid(halves, _box(0, 0, 0, 40, 30, 20))
    assert same_solid(_bored(10, 10), _bored(10, 10))


def test_another_volume_or_place_is_another_solid() -> None:
    block = _box(0, 0, 0, 40, 30, 20)
    assert not same_solid(block, _bored(10, 10))
    assert not same_solid(block, _box(0.1, 0, 0, 40, 30, 20))
    assert not same_solid(_bored(10, 10), _bored(30, 10))


@pytest.mark.parametrize("at", [(20, 30, 10), (1, 2, 20)])
def test_a_small_body_makes_another_solid_but_a_layer_that_is_thin_does_not(
    at: tuple[float, float, float],
) -> None:
    block = _box(0, 0, 0, 40, 30, 20)
    for thickness, same in ((0.02, False), (0.1, False), (0.0005, True)):
        size = [3.0, 3.0, 3.0]
        size[1 if at[1] == 30 else 2] = thickness
        other = BRepAlgoAPI_Fuse(block, _box(*at, *size)).Shape()
        assert same_solid(block, other) is same_solid(other, block) is same
        assert same_solid(block, other, apart=0.2)


def test_same_volume_and_centre_is_not_enough() -> None:
    # Turned by a quarter about their common centre.
    assert not same_solid(_box(0, 5, 0, 40, 30, 20), _box(5, 0, 0, 30, 40, 20))
