"""A solid's lines against the views."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Compound, TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.solid.verify import matching_tolerance, verify

Draw = Callable[..., DrawnViews]


def _box(x: float, y: float, z: float, *size: float) -> TopoDS_Shape:
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), *size).Solid()


def _slotted(width: float) -> TopoDS_Shape:
    return BRepAlgoAPI_Cut(_box(0, 0, 0, 40, 30, 20), _box(15, 0, 12, width, 30, 8)).Shape()


def test_a_solid_shows_its_own_lines(drawn: Draw) -> None:
    solid = _slotted(10)
    found = verify(solid, drawn(solid))
    assert found.neat and found.flaws == ()
    assert set(found.matched) == {Role.FRONT, Role.TOP, Role.RIGHT}
    assert all(match.agreement.worst == 1.0 for match in found.matched.values())


def test_missing_and_surplus_lines_are_told_by_place_and_length(drawn: Draw) -> None:
    views = drawn(_slotted(10))
    found = verify(_box(0, 0, 0, 40, 30, 20), views)
    assert found.sound and not found.explains
    front = [flaw for flaw in found.flaws if flaw.role is Role.FRONT]
    surplus = [flaw for flaw in front if not flaw.missing]
    assert sum(flaw.length for flaw in surplus) == pytest.approx(10.0, rel=0.05)
    missing = [flaw for flaw in front if flaw.missing]
    assert sum(flaw.length for flaw in missing) == pytest.approx(26.0, rel=0.05)
    for flaw in missing:
        assert 14.9 < flaw.place[0] < 25.1 and 11.9 < flaw.place[1] < 20.1
    # The surplus edge is straight and has ends; the slot's outline goes round corners.
    (edge,) = surplus
    assert sorted(edge.ends)[0] == pytest.approx((15.0, 20.0), abs=0.2)
    assert sorted(edge.ends)[1] == pytest.approx((25.0, 20.0), abs=0.2)
    assert [flaw.ends for flaw in missing] == [None]
    top = [flaw for flaw in found.flaws if flaw.role is Role.TOP]
    assert all(flaw.missing for flaw in top)
    assert sum(flaw.length for flaw in top) == pytest.approx(60.0, rel=0.05)
    lengths = [flaw.length for flaw in found.flaws]
    assert lengths == sorted(lengths, reverse=True)


def test_flaws_swap_their_sense_with_solid_and_views(drawn: Draw) -> None:
    block, slotted = _box(0, 0, 0, 40, 30, 20), _slotted(10)
    one, other = verify(block, drawn(slotted)), verify(slotted, drawn(block))
    stated = [sorted((f.role.value, round(f.length, 1)) for f in o.flaws) for o in (one, other)]
    assert stated[0] == stated[1]
    assert all(a.missing != b.missing for a in one.flaws for b in other.flaws if a.place == b.place)


def test_a_difference_beyond_the_tolerance_is_a_flaw(drawn: Draw) -> None:
    views = drawn(_slotted(10))
    off = 2.0 * matching_tolerance(views)
    assert not verify(_slotted(10 + off), views).explains
    loose = replace(views, tolerance=off)
    assert matching_tolerance(loose) > off
    found = verify(_slotted(10 + off), loose)
    assert found.explains and found.spread == pytest.approx(off, rel=0.03)
    exact = verify(_slotted(10), loose)
    assert exact.neat and exact.spread == pytest.approx(0.0, abs=1e-6)


def test_two_solids_are_not_one_sound_body(drawn: Draw) -> None:
    solids = TopoDS_Compound()
    builder = BRep_Builder()
    builder.MakeCompound(solids)
    for x in (0, 25):
        builder.Add(solids, _box(x, 0, 0, 15, 30, 20))
    found = verify(solids, drawn(solids))
    assert not found.sound and not found.explains
    assert found.flaws == ()


def _pocketed(depth: float) -> TopoDS_Shape:
    pocket = _box(15, 10, 20 - depth, 10, 10, depth)
    return BRepAlgoAPI_Cut(_box(0, 0, 0, 40, 30, 20), pocket).Shape()


@pytest.mark.parametrize(("depth", "is_given"), [(6.0, False), (7.5, True)])
def test_a_hidden_line_of_a_dash_may_be_missing_in_a_picture(
    depth: float, is_given: bool, drawn: Draw
) -> None:
    solid = _pocketed(depth)
    exact = drawn(solid)
    strokes = {
        role: tuple(
            s for s in stroke if s.linetype is Linetype.VISIBLE or abs(s.length - depth) > 1e-6
        )
        for role, stroke in exact.strokes.items()
    }
    found = verify(solid, replace(exact, strokes=strokes, tolerance=0.5))
    assert bool(found.flaws) == is_given
    assert not any(flaw.missing for flaw in found.flaws)


def test_what_little_was_read_of_a_rounding_is_not_overlooked(drawn: Draw) -> None:
    """Half an arc in a corner lies beside its lines by four pixels, at its end alone."""
    solid = _box(0, 0, 0, 40, 30, 20)
    views = replace(drawn(solid), tolerance=0.5)
    radius = 17.0 * views.tolerance
    arc = Arc((radius, radius), radius, np.pi, 0.25 * np.pi, Linetype.VISIBLE)
    front = (*views.strokes[Role.FRONT], arc)
    found = verify(solid, replace(views, strokes={**views.strokes, Role.FRONT: front}))
    assert [(flaw.role, flaw.missing) for flaw in found.flaws] == [(Role.FRONT, True)]


@pytest.mark.parametrize(("degrees", "askew"), [(0.0, False), (15.0, False), (45.0, True)])
def test_a_stroke_across_a_corner_is_a_rounding_that_the_solid_lacks(
    degrees: float, askew: bool, drawn: Draw
) -> None:
    views = drawn(_pocketed(8.0))
    corner = np.array((15.0, 10.0))
    item = 1.1 * np.array((np.cos(np.radians(degrees)), np.sin(np.radians(degrees))))
    across = Segment(tuple(corner - item), tuple(corner + item), Linetype.VISIBLE)
    strokes = {**views.strokes, Role.TOP: (*views.strokes[Role.TOP], across)}
    found = verify(_pocketed(8.0), replace(views, strokes=strokes, tolerance=0.4, noise=0.01))
    assert (found.explains, found.askew, found.apart) == (True, askew, False)


@pytest.mark.parametrize(("length", "apart"), [(6.0, False), (38.0, True)])
def test_a_short_line_may_be_read_less_exactly(length: float, apart: bool, drawn: Draw) -> None:
    solid = BRepAlgoAPI_Cut(_box(0, 0, 0, 40, 30, 20), _box(0, 0, 10, length, 30, 10)).Shape()
    exact = drawn(solid)
    off = 0.1
    front = tuple(
        replace(s, start=(s.start[0], 10.0 + off), end=(s.end[0], 10.0 + off))
        if s.start[1] == s.end[1] == pytest.approx(10.0)
        else s
        for s in exact.strokes[Role.FRONT]
    )
    views = replace(exact, strokes={**exact.strokes, Role.FRONT: front}, tolerance=0.2)
    found = verify(solid, views)
    assert found.explains
    assert found.apart == apart


@pytest.mark.parametrize(
    ("beyond", "noise", "apart"),
    [(0.3, 0.0, False), (0.4, 0.0, True), (0.9, 0.01, False), (1.1, 0.01, True)],
)
def test_a_solid_that_does_not_fill_the_views_has_other_measures(
    beyond: float, noise: float, apart: bool, drawn: Draw
) -> None:
    # As if an edge reached over a corner: the box is too long, and all lines are where they were.
    solid = _slotted(10)
    exact = drawn(solid)
    pixel = 0.1
    views = replace(exact, size=(40.0, 30.0 + beyond * pixel, 20.0), tolerance=pixel, noise=noise)
    found = verify(solid, views)
    assert found.explains
    assert found.spread == pytest.approx(0.0, abs=1e-6)
    assert found.misfit == pytest.approx(beyond * pixel, abs=1e-6)
    assert found.apart == apart


@pytest.mark.parametrize(("width", "thin"), [(0.3, 2), (1.5, 0)])
def test_faces_narrower_than_pixels_can_tell_are_slivers(
    width: float, thin: int, drawn: Draw
) -> None:
    """A step all along an edge: both its faces are narrow, and none of a block's others is."""
    solid = BRepAlgoAPI_Cut(_box(0, 0, 0, 40, 30, 20), _box(0, 0, 0, 40, width, width)).Shape()
    found = verify(solid, replace(drawn(solid), tolerance=0.25))
    assert found.explains and found.thin == thin
    assert found.neat == (not thin)
    assert verify(solid, drawn(solid)).neat
