"""Turned parts whose outlines slope."""

import pytest
from OCP.TopoDS import TopoDS_Shape
from sketch_checks import GRID, check, drawn

from gaussiancad_core.axes import Axis
from gaussiancad_core.samples.modelling import box, cut, cylinder, fuse, revolved
from gaussiancad_core.sketch.construction import construction_of
from gaussiancad_core.sketch.construction_sentences import construction_in_words
from gaussiancad_core.sketch.sketching import sketch


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
    corners = {tuple(round(x, 2) for x in own.start) for own in construction.turning.edges}
    assert corners == {(0, 0), (0, 8), (30, 14), (30, 20), (50, 20), (60, 16), (90, 16), (90, 0)}
    words = construction_in_words(construction.as_json())
    assert "- turned about the axis at (20, 20) to a profile of 8 edges" in words


def test_what_is_milled_into_a_turned_part_stays() -> None:
    truth = cut(handle(), cylinder(Axis.X, (20, 20), 5, -1, 91))
    truth = cut(truth, box((62, -1, 30), (91, 41, 41)))
    check(sketch(drawn(truth, hidden=True), GRID), truth)


def test_a_plain_shaft_has_no_envelope() -> None:
    plain = fuse(cylinder(Axis.X, (20, 20), 20, 0, 10), cylinder(Axis.X, (20, 20), 12, 10, 60))
    found = sketch(drawn(plain, hidden=True), GRID)
    assert found.choice.plan.envelope is None
    check(found, plain)


def test_a_groove_of_two_slopes_is_turned_into_a_drum() -> None:
    profile = [(0, 0), (0, 32), (7, 32), (11, 28), (15, 32), (22, 32), (22, 18), (38, 14), (38, 0)]
    truth = cut(revolved(profile, Axis.X, (32, 32)), cylinder(Axis.Y, (11, 32), 5, -1, 65))
    found = sketch(drawn(truth, hidden=True), GRID)
    assert [own.high for own in found.slabs] == pytest.approx([22, 38])
    check(found, truth)
