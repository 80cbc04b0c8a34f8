"""What one solid has and another has not."""

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse

from gaussiancad_core.features.difference import difference
from gaussiancad_core.kernel.booleans import common
from gaussiancad_core.kernel.brep import compound_of, exact_volume
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder, fuse, prism

_BLOCK = box((0, 0, 0), (20, 10, 10))


def test_a_solid_that_is_moved_differs_on_both_sides() -> None:
    found = difference(_BLOCK, box((1, 0, 0), (21, 10, 10)))
    assert not found.is_none
    assert found.share == pytest.approx(0.1)
    assert found.faces == 0
    sides = dict(zip(found.is_inside.tolist(), found.points[:, 0].tolist(), strict=True))
    assert 0.0 < sides[True] < 1.0 and 20.0 < sides[False] < 21.0


@pytest.mark.parametrize("depth", [0.5, 0.001])
def test_a_missing_pocket_is_seen(depth: float) -> None:
    part = cut(_BLOCK, box((5, 2, 10 - depth), (15, 8, 10)))
    found = difference(part, _BLOCK)
    assert not found.is_none
    assert found.share == pytest.approx(60.0 * depth / (2000.0 - 60.0 * depth), rel=1e-3)
    assert found.faces == -5
    np.testing.assert_array_equal(found.is_inside, [False])


def test_two_solids_are_no_solid() -> None:
    apart = compound_of([box((0, 0, 0), (9, 10, 10)), box((11, 0, 0), (20, 10, 10))])
    assert difference(_BLOCK, apart).share == np.inf


def test_faces_that_are_split_count_once() -> None:
    halves = BRepAlgoAPI_Fuse(box((0, 0, 0), (8, 10, 10)), box((8, 0, 0), (20, 10, 10))).Shape()
    assert difference(_BLOCK, halves).is_none


def test_walls_that_differ_by_the_last_digits_are_one() -> None:
    """As those of two features whose outlines are rounded; a step of 0.001 mm is one."""
    for off, faces in ((4e-9, 0), (1e-3, 2)):
        leaning = [(8, 0), (20, 0), (20, 10 + off), (8, 10 + off / 2.0)]
        halves = BRepAlgoAPI_Fuse(
            box((0, 0, 0), (8, 10, 10)), prism(Axis.Z, leaning, 0.0, 10.0)
        ).Shape()
        assert difference(_BLOCK, halves).faces == faces


def test_a_bore_moved_by_a_hair_is_seen() -> None:
    one, other = (cut(_BLOCK, cylinder(Axis.Z, (x, 5.0), 3.0, 0.0, 10.0)) for x in (10.0, 10.001))
    assert not difference(one, other).is_none
    assert difference(one, fuse(one, cylinder(Axis.Z, (10, 5), 3.0, 0.0, 10.0))).faces == -1


@pytest.mark.parametrize("radius", [2.0, 4.9, 4.99])
def test_a_volume_is_measured_where_faces_end_at_curves_of_the_fourth_order(radius: float) -> None:
    """The plain integral misses up to a thousandth of such a pin; of what is cut and what is left
    together the volume is known."""
    pin = cylinder(Axis.Z, (0.0, 0.0), 5.0, -10.0, 10.0)
    bore = cylinder(Axis.X, (0.0, 0.0), radius, -10.0, 10.0)
    found = exact_volume(cut(pin, bore)) + exact_volume(common(pin, bore))
    assert found == pytest.approx(np.pi * 25.0 * 20.0, rel=1e-9)
