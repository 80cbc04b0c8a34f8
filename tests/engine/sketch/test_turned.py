"""Turned parts whose outlines slope."""

import pytest
from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Shape
from sketch_checks import GRID, check, drawn

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.report.construction_sentences import construction_in_words
from gaussiancad_core.sketch.constructing import construction_of
from gaussiancad_core.sketch.sketching import sketch
from sample_parts.modelling import box, cut, cylinder, fuse, revolved


def handle() -> TopoDS_Shape:
    """A shaft that narrows, wider in the middle."""
    profile = [(0, 0), (0, 8), (30, 14), (30, 20), (50, 20), (60, 16), (90, 16), (90, 0)]
    return revolved(profile, Axis.X, (20, 20))


@pytest.mark.parametrize("hidden", [False, True])
def test_a_slope_is_turned_down_last(hidden: bool) -> None:
    truth = handle()
    found = sketch(drawn(truth, hidden=hidden), GRID)
    assert found.axis is Axis.X
    check(found, truth)
    construction = construction_of(found, None)
    corners = [
        {tuple(round(x, 2) for x in edge.start) for edge in item.edges}
        for item in construction.turned
    ]
    assert sorted(map(sorted, corners)) == [
        [(0, 8), (0, 14), (30, 14)],
        [(50, 20), (60, 16), (60, 20)],
    ]
    words = construction_in_words(construction.as_json())
    assert "- a slope turned about the axis at (20, 20), from 0 to 30 mm" in words


def test_what_is_milled_into_a_turned_part_stays() -> None:
    truth = cut(handle(), cylinder(Axis.X, (20, 20), 5, -1, 91))
    truth = cut(truth, box((62, -1, 30), (91, 41, 41)))
    check(sketch(drawn(truth, hidden=True), GRID), truth)


def test_a_plain_shaft_has_no_envelope() -> None:
    plain = fuse(cylinder(Axis.X, (20, 20), 20, 0, 10), cylinder(Axis.X, (20, 20), 12, 10, 60))
    found = sketch(drawn(plain, hidden=True), GRID)
    assert not found.choice.plan.slopes
    check(found, plain)


def test_a_groove_of_two_slopes_is_turned_into_a_drum() -> None:
    profile = [(0, 0), (0, 32), (7, 32), (11, 28), (15, 32), (22, 32), (22, 18), (38, 14), (38, 0)]
    truth = cut(revolved(profile, Axis.X, (32, 32)), cylinder(Axis.Y, (11, 32), 5, -1, 65))
    found = sketch(drawn(truth, hidden=True), GRID)
    assert [slab.high for slab in found.slabs] == pytest.approx([22, 38])
    check(found, truth)


def test_what_is_not_turned_stays_beside_a_slope() -> None:
    block = fuse(cylinder(Axis.Z, (30, 30), 30, 0, 10), box((10, 10, 10), (50, 50, 20)))
    cone = revolved([(20, 0), (20, 15), (40, 8), (40, 0)], Axis.Z, (30, 30))
    truth = fuse(block, cone)
    check(sketch(drawn(truth, hidden=True), GRID), truth)


@pytest.mark.parametrize("tip", ["cone", "dome"])
def test_a_tip_on_the_axis_is_turned(tip: str) -> None:
    truth = cylinder(Axis.X, (20, 20), 20, 0, 30)
    if tip == "cone":
        truth = fuse(truth, revolved([(30, 0), (30, 20), (50, 0)], Axis.X, (20, 20)))
    else:
        ball = BRepPrimAPI_MakeSphere(gp_Pnt(30, 20, 20), 20).Shape()
        truth = fuse(truth, cut(ball, box((0, 0, 0), (30, 40, 40))))
    found = sketch(drawn(truth, hidden=True), GRID)
    check(found, truth)


def test_an_outline_that_crosses_the_axis_is_no_profile() -> None:
    base = revolved([(0, 0), (0, 30), (8, 24), (8, 0)], Axis.Z, (30, 30))
    zigzag = fuse(box((5, 28, 8), (25, 32, 20)), box((35, 28, 8), (55, 32, 14)))
    assert sketch(drawn(fuse(base, zigzag), hidden=True), GRID) is not None


def test_a_barrel_slopes_to_both_sides() -> None:
    ball = BRepPrimAPI_MakeSphere(gp_Pnt(30, 25, 25), 25).Shape()
    truth = fuse(
        cut(ball, box((0, 0, 0), (15, 50, 50)), box((45, 0, 0), (60, 50, 50))),
        cylinder(Axis.X, (25, 25), 10, 0, 60),
    )
    check(sketch(drawn(truth, hidden=True), GRID), truth)
