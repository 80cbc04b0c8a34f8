"""Round holes: what a drill, a counterbore and a countersink leave."""

from math import radians, tan

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.defeaturing import without_holes
from gaussiancad_core.features.feature_model import Holes
from gaussiancad_core.kernel.brep import faces_of, volume
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cone, cut, cylinder, fuse, leaning_cylinder, slot

_BLOCK = box((0, 0, 0), (60, 40, 20))
_AT = (30.0, 20.0)


def _holes(*tools: TopoDS_Shape) -> tuple[Holes, ...]:
    """The holes of a block that is cut; without them it is the block."""
    filled, holes = without_holes(cut(_BLOCK, *tools), 500.0)
    if holes:
        assert volume(filled) == pytest.approx(volume(_BLOCK))
        assert len(faces_of(filled)) == 6
    return holes


def test_a_blind_hole_ends_flat_or_in_a_tip() -> None:
    drill = cylinder(Axis.Z, _AT, 4.0, 8.0, 20.0)
    (flat,) = _holes(drill)
    assert flat.is_downward and flat.height == pytest.approx(20.0)
    assert (flat.depth, flat.tip) == pytest.approx((12.0, 0.0))
    long = 4.0 / tan(radians(59.0))
    (tipped,) = _holes(fuse(drill, cone(Axis.Z, _AT, (0.0, 4.0), 8.0 - long, 8.0)))
    assert (tipped.depth, tipped.tip) == pytest.approx((12.0, 118.0))


@pytest.mark.parametrize("is_up", [False, True])
def test_a_sink_is_at_either_end(is_up: bool) -> None:
    bore = cylinder(Axis.Z, _AT, 3.0, 0.0, 20.0)
    wide = cylinder(Axis.Z, _AT, 6.0, *((0.0, 5.0) if is_up else (15.0, 20.0)))
    (hole,) = _holes(bore, wide)
    assert hole.sink is not None and hole.is_downward is not is_up
    assert hole.height == pytest.approx(0.0 if is_up else 20.0)
    assert (hole.sink.diameter, hole.sink.depth, hole.sink.angle) == pytest.approx((12, 5, 0))
    slope = (6.0, 3.0), 0.0, 3.0
    if not is_up:
        slope = (3.0, 6.0), 17.0, 20.0
    (hole,) = _holes(bore, cone(Axis.Z, _AT, *slope))
    assert hole.centres == (pytest.approx(_AT),)
    assert hole.sink is not None and hole.is_downward is not is_up
    assert (hole.sink.diameter, hole.sink.angle) == pytest.approx((12.0, 90.0))
    assert (hole.diameter, hole.depth) == (pytest.approx(6.0), None)


def test_a_hole_with_sinks_at_both_ends_is_drilled_from_both() -> None:
    holes = _holes(
        cylinder(Axis.Z, _AT, 3.0, 0.0, 20.0),
        cylinder(Axis.Z, _AT, 6.0, 15.0, 20.0),
        cone(Axis.Z, _AT, (5.0, 3.0), 0.0, 2.0),
    )
    assert sorted(hole.is_downward for hole in holes) == [False, True]
    assert all(hole.sink is not None for hole in holes)


def test_cross_bores_that_meet_are_closed_one_after_the_other() -> None:
    holes = _holes(
        cylinder(Axis.Z, _AT, 5.0, 0.0, 20.0), cylinder(Axis.X, (20.0, 10.0), 3.0, 0.0, 60.0)
    )
    assert sorted(hole.diameter for hole in holes) == pytest.approx([6.0, 10.0])
    assert all(hole.depth is None for hole in holes)


def test_a_hole_on_a_slanted_axis_is_found() -> None:
    tool = leaning_cylinder((30, 20, 10), (1.0, 0.0, 2.0), 3.0, 80.0)
    (hole,) = _holes(tool)
    assert hole.diameter == pytest.approx(6.0)
    assert hole.frame.name not in ("XY", "XZ", "YZ")


def test_the_end_of_a_slot_a_bore_wider_inside_and_a_round_outside_are_no_holes() -> None:
    assert _holes(slot(Axis.Z, ((20.0, 20.0), (40.0, 20.0)), 5.0, 0.0, 20.0)) == ()
    narrow = cylinder(Axis.Z, _AT, 3.0, 0.0, 20.0)
    assert _holes(narrow, cylinder(Axis.Z, _AT, 6.0, 6.0, 14.0)) == ()
    pin = cylinder(Axis.Z, _AT, 8.0, 0.0, 30.0)
    assert without_holes(fuse(_BLOCK, pin), 500.0)[1] == ()


def test_a_hole_in_the_side_of_a_cylinder_is_one() -> None:
    pin = cylinder(Axis.Z, (0.0, 0.0), 10.0, 0.0, 60.0)
    filled, (hole,) = without_holes(
        cut(pin, cylinder(Axis.X, (0.0, 30.0), 3.0, -20.0, 20.0)), 500.0
    )
    assert hole.diameter == pytest.approx(6.0) and hole.depth is None
    assert volume(filled) == pytest.approx(volume(pin))
