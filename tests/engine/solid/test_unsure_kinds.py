"""Strokes of which nothing tells whether they are visible or hidden."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.ambiguous_linetypes import as_drawn, is_unsure, with_unsure_kinds
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.lines.line_points import lines_of_strokes
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_protocol.modes import Status

V, H = Linetype.VISIBLE, Linetype.HIDDEN

Told = list[tuple[tuple[float, float], tuple[float, float], bool]]


def _told(*strokes: Segment | Arc, dash: float | None = 4.0) -> Told:
    """Ends of the parts of a front view's first stroke along y = 5, and whether they are unsure."""
    views = DrawnViews({Role.FRONT: strokes}, (40.0, 20.0, 20.0), 0.1, 0.05, dash=dash)
    found = with_unsure_kinds(views)
    assert found is not None
    return [
        (stroke.start, stroke.end, is_unsure(stroke))
        for stroke in found.strokes[Role.FRONT]
        if isinstance(stroke, Segment) and stroke.start[1] == stroke.end[1] == 5.0
    ]


def _upright(x: float) -> Segment:
    return Segment((x, 0.0), (x, 20.0), V)


def test_strokes_no_longer_than_a_dash_may_be_of_either_kind() -> None:
    assert _told(Segment((5.0, 5.0), (8.0, 5.0), V)) == [((5.0, 5.0), (8.0, 5.0), True)]
    views = DrawnViews(
        {Role.FRONT: (Segment((5.0, 5.0), (11.0, 5.0), V), _upright(5.0))}, (40.0, 20.0, 20.0), 0.1
    )
    assert with_unsure_kinds(replace(views, dash=4.0)) is None
    assert with_unsure_kinds(replace(views, dash=None)) is None


@pytest.mark.parametrize("met", [_upright(37.0), Segment((37.0, 5.2), (37.0, 20.0), V)])
def test_the_short_end_of_a_long_line_may_be_of_either_kind(met: Segment) -> None:
    parts = _told(Segment((5.0, 5.0), (40.0, 5.0), V), met)
    assert [unsure for *_, unsure in parts] == [False, True]
    assert parts[0][:2] == ((5.0, 5.0), (pytest.approx(37.0, abs=0.06), 5.0))
    assert parts[1][1] == (40.0, 5.0)


def test_within_a_dashed_line_gaps_tell_but_not_at_its_ends() -> None:
    lines = (_upright(20.0), _upright(23.0), _upright(37.0))
    visible = _told(Segment((5.0, 5.0), (40.0, 5.0), V), *lines)
    assert [unsure for *_, unsure in visible] == [False, True, False, True]
    hidden = _told(Segment((5.0, 5.0), (40.0, 5.0), H), *lines)
    assert [unsure for *_, unsure in hidden] == [False, True]


def test_strokes_are_of_the_kind_that_a_solid_draws() -> None:
    unsure = Segment((0.0, 0.0), (3.0, 0.0), V, 0.4)
    sure = replace(unsure, confidence=1.0)
    hidden = lines_of_strokes([replace(sure, linetype=H)], 0.05)
    visible = lines_of_strokes([sure], 0.05)
    assert as_drawn([unsure, sure], hidden, 0.1) == (replace(unsure, linetype=H), sure)
    assert as_drawn([unsure], visible, 0.1) == (unsure,)


@pytest.fixture
def pocketed() -> TopoDS_Shape:
    """A block with a blind pocket as deep as a dash is long."""
    block = BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape()
    pocket = BRepPrimAPI_MakeBox(gp_Pnt(10.0, 8.0, 17.0), 18.0, 14.0, 3.0).Shape()
    return BRepAlgoAPI_Cut(block, pocket).Shape()


def test_a_pocket_whose_sides_look_visible_is_found(
    pocketed: TopoDS_Shape,
    drawn: Callable[[TopoDS_Shape], DrawnViews],
    iou: Callable[[TopoDS_Shape, TopoDS_Shape], float],
) -> None:
    views = drawn(pocketed)
    looks = {
        role: tuple(replace(s, linetype=V) if s.length <= 4.0 else s for s in strokes)
        for role, strokes in views.strokes.items()
    }
    read = replace(views, strokes=looks)
    assert read.strokes != views.strokes
    assert "lines-unexplained" in [code for code, _ in exact_solid(read).reasons]
    result = exact_solid(replace(read, dash=4.0))
    assert result.status is Status.APPROXIMATE
    assert [code for code, _ in result.reasons] == ["linetypes-retold"]
    assert iou(result.shape, pocketed) > 0.9999
    assert np.isclose(volume(result.shape), volume(pocketed))
