"""Holes along other axes than the slabs', and what notes say of holes."""

from dataclasses import replace

import pytest
from OCP.TopoDS import TopoDS_Shape
from sketch_checks import GRID, ROLES, check, drawn

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.report.construction_sentences import construction_in_words
from gaussiancad_core.sketch.constructing import construction_of
from gaussiancad_core.sketch.sketching import sketch
from sample_parts.modelling import box, cut, cylinder, fuse


def lug() -> TopoDS_Shape:
    """A disc with two bores and a block on it, slabs along z."""
    plate = cylinder(Axis.Z, (30, 30), 30, 0, 8)
    for x in (8, 52):
        plate = cut(plate, cylinder(Axis.Z, (x, 30), 3, -1, 9))
    return fuse(plate, box((20, 20, 8), (40, 40, 30)))


@pytest.mark.parametrize("hidden", [False, True])
def test_a_hole_across_the_slabs_is_cut_last(hidden: bool) -> None:
    truth = cut(lug(), cylinder(Axis.Y, (30, 20), 5, -1, 61))
    found = sketch(drawn(truth, hidden=hidden), GRID)
    assert found.axis is Axis.Z
    assert len(found.choice.plan.levels) == 3
    (hole,) = found.choice.plan.cross_holes
    assert (hole.axis, hole.role) == (Axis.Y, Role.FRONT)
    check(found, truth)
    (item,) = construction_of(found, None).cross_holes
    assert (item.axis, item.diameter) == ("y", pytest.approx(10.0, rel=1e-3))
    words = construction_in_words(construction_of(found, None).as_json())
    way = "from 20 to 40 mm" if hidden else "from the outside to 40.1 mm"
    assert f"- a hole of 10 mm along y at (30, 20), {way}" in words


def test_hidden_lines_tell_how_deep_the_steps_of_a_hole_across_are() -> None:
    truth = cut(lug(), cylinder(Axis.Y, (30, 20), 3, -1, 35))
    truth = cut(truth, cylinder(Axis.Y, (30, 20), 6, -1, 26))
    found = sketch(drawn(truth, hidden=True), GRID)
    assert len(found.choice.plan.cross_holes) == 2
    check(found, truth)


@pytest.mark.parametrize("axis", [Axis.Y, Axis.Z])
def test_a_note_tells_how_deep_a_hole_is_that_no_line_does(axis: Axis) -> None:
    across = axis is Axis.Y
    # From the front one looks towards larger y, from above towards smaller z.
    hole = cylinder(Axis.Y, (30, 20), 5, -1, 35) if across else cylinder(axis, (30, 30), 5, 18, 31)
    truth = cut(lug(), hole)
    views = drawn(truth, hidden=False)
    role, at, depth = (Role.FRONT, 20.0, 15.0) if across else (Role.TOP, 30.0, 12.0)
    noted = NotedHole(role, (30.0, at), (HoleStep(10.0, depth),))
    check(sketch(replace(views, holes=(noted,)), GRID), truth)
    untold = sketch(views, GRID)
    through = cylinder(axis, (30, at), 5, -1, 61)
    check(untold, cut(lug(), through))


def test_a_note_tells_that_a_hole_goes_on_beyond_the_next_void() -> None:
    ears = fuse(cylinder(Axis.Z, (30, 30), 30, 0, 8), box((20, 15, 8), (40, 22, 30)))
    ears = fuse(ears, box((20, 38, 8), (40, 45, 30)))
    truth = cut(ears, cylinder(Axis.Y, (30, 20), 4, -1, 61))
    views = drawn(truth, hidden=False)
    noted = NotedHole(Role.FRONT, (30.0, 20.0), (HoleStep(8.0),))
    check(sketch(replace(views, holes=(noted,)), GRID), truth)
    check(sketch(views, GRID), cut(ears, cylinder(Axis.Y, (30, 20), 4, -1, 30)))


def test_a_ring_around_a_hole_across_of_which_nothing_tells_a_depth_is_left_out() -> None:
    bored = cut(lug(), cylinder(Axis.Y, (30, 20), 3, -1, 61))
    stepped = cut(bored, cylinder(Axis.Y, (30, 20), 6, -1, 26))
    check(sketch(drawn(stepped, hidden=False), GRID), bored)


def test_holes_behind_each_other_have_walls_in_common() -> None:
    truth = lug()
    for x in (25, 35):
        for z in (14, 24):
            truth = cut(truth, cylinder(Axis.Y, (x, z), 3, -1, 61))
    found = sketch(drawn(truth, hidden=True), GRID)
    assert len(found.bores) == 4
    check(found, truth)
    both = sketch(drawn(truth, (*ROLES, Role.REAR), hidden=True), GRID)
    assert len(both.bores) == 4
    check(both, truth)


def test_a_slender_hole_whose_walls_are_drawn_goes_through() -> None:
    truth = cut(lug(), cylinder(Axis.Y, (30, 20), 0.6, -1, 61))
    check(sketch(drawn(truth, hidden=True), GRID), truth)
    untold = sketch(drawn(truth, hidden=False), GRID)
    assert not untold.bores and not construction_of(untold, None).cross_holes


def test_a_pin_across_is_no_hole() -> None:
    truth = fuse(lug(), cylinder(Axis.Y, (30, 20), 4, 10, 20))
    found = sketch(drawn(truth, hidden=False), GRID)
    assert not found.choice.plan.cross_holes


def test_a_hole_across_a_round_part_is_open_at_both_ends() -> None:
    truth = cut(cylinder(Axis.Z, (30, 30), 30, 0, 40), cylinder(Axis.Y, (22, 20), 5, -1, 61))
    check(sketch(drawn(truth, hidden=True), GRID), truth)
