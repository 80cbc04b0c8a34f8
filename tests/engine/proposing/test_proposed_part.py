"""Parts found among features from the lines of their views, and built."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.booleans import common
from gaussiancad_core.kernel.brep import soundness, volume
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.proposing.proposed_part import ProposedPart, proposed_part
from sample_parts.modelling import box, cone, cut, cylinder, fuse

Draw = Callable[[TopoDS_Shape], DrawnViews]

_WORK = 1e8


def _iou(one: TopoDS_Shape, other: TopoDS_Shape) -> float:
    both = volume(common(one, other))
    return both / (volume(one) + volume(other) - both)


def _flange() -> TopoDS_Shape:
    """A turned body with a groove, a bore and a ring of holes."""
    body = fuse(
        cylinder(Axis.Z, (30.0, 30.0), 30.0, 0.0, 8.0),
        cylinder(Axis.Z, (30.0, 30.0), 15.0, 8.0, 30.0),
    )
    holes = [
        cylinder(Axis.Z, at, 3.0, -1.0, 9.0)
        for at in ((8.0, 30.0), (52.0, 30.0), (30.0, 8.0), (30.0, 52.0))
    ]
    bore = cylinder(Axis.Z, (30.0, 30.0), 7.0, -1.0, 31.0)
    sink = cone(Axis.Z, (30.0, 30.0), (7.0, 11.0), 26.0, 30.0)
    return cut(body, *holes, bore, sink)


def _bracket() -> TopoDS_Shape:
    """Two plates at an angle, each with a hole, and a pocket behind."""
    body = fuse(
        box((0.0, 0.0, 0.0), (60.0, 40.0, 8.0)),
        box((0.0, 32.0, 8.0), (60.0, 40.0, 45.0)),
    )
    return cut(
        body,
        cylinder(Axis.Z, (15.0, 15.0), 5.0, -1.0, 9.0),
        cylinder(Axis.Y, (40.0, 28.0), 6.0, 31.0, 41.0),
        box((10.0, 36.0, 15.0), (25.0, 41.0, 40.0)),
    )


def _proposed(views: DrawnViews) -> ProposedPart | None:
    return proposed_part(views, views.tolerance, _WORK)


@pytest.mark.parametrize("made", [_flange, _bracket])
def test_a_part_is_found_from_its_three_views(
    made: Callable[[], TopoDS_Shape], drawn: Draw
) -> None:
    part = made()
    found = _proposed(drawn(part))
    assert found is not None
    assert found.shape is not None
    assert soundness(found.shape).valid
    assert found.planned == pytest.approx(0.0, abs=2e-3)
    assert _iou(found.shape, part) > 0.999
    assert soundness(found.shape).faces == soundness(part).faces


def test_a_lost_piece_of_the_outline_costs_nothing_else(drawn: Draw) -> None:
    part = _bracket()
    views = drawn(part)
    front = views.strokes[Role.FRONT]
    top = max(
        (each for each in front if isinstance(each, Segment) and each.start[1] > 44.0),
        key=lambda each: each.length,
    )
    kept = tuple(each for each in front if each is not top)
    found = _proposed(replace(views, strokes={**views.strokes, Role.FRONT: kept}))
    assert found is not None
    assert found.shape is not None
    assert _iou(found.shape, part) > 0.98


def _plate(*tools: TopoDS_Shape) -> TopoDS_Shape:
    return cut(box((0.0, 0.0, 0.0), (80.0, 50.0, 8.0)), *tools)


def _bore(x: float, radius: float) -> TopoDS_Shape:
    return cylinder(Axis.Z, (x, 25.0), radius, -1.0, 9.0)


def _sunk(x: float) -> TopoDS_Shape:
    return cone(Axis.Z, (x, 25.0), (4.0, 7.0), 5.0, 8.0)


@pytest.mark.parametrize("sunk", [False, True])
def test_without_hidden_lines_holes_go_through_and_leave_one_piece(sunk: bool, drawn: Draw) -> None:
    tools = [_bore(x, 4.0) for x in (20.0, 60.0)]
    part = _plate(*tools, *([_sunk(20.0), _sunk(60.0)] if sunk else []))
    views = drawn(part)
    visible = {
        role: tuple(each for each in strokes if each.linetype is Linetype.VISIBLE)
        for role, strokes in views.strokes.items()
    }
    found = _proposed(replace(views, strokes=visible, undrawn=tuple(visible)))
    assert found is not None
    assert found.shape is not None
    assert soundness(found.shape).solids == 1
    assert soundness(found.shape).faces == soundness(part).faces
    # Which side is sunk no line tells.
    assert volume(found.shape) == pytest.approx(volume(part), rel=1e-4)


def test_an_arc_between_corners_that_are_one_is_none(drawn: Draw) -> None:
    # A bore that all but touches the edge: what is left beside it is a sliver of two arcs.
    part = _plate(cylinder(Axis.Z, (80.0 - 5.001, 25.0), 5.0, -1.0, 9.0))
    found = _proposed(drawn(part))
    assert found is not None
    assert found.shape is not None
    assert volume(found.shape) == pytest.approx(volume(part), rel=1e-3)


def test_where_nothing_is_enclosed_nothing_is_proposed() -> None:
    line = Segment((0.0, 0.0), (40.0, 0.0), Linetype.VISIBLE)
    views = DrawnViews({Role.FRONT: (line,)}, (40.0, 1.0, 1.0), 0.01)
    assert _proposed(views) is None
