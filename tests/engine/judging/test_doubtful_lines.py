"""Lines that may be edges cost by their odds, whichever way they were taken."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews, DroppedLine
from gaussiancad_core.judging.misfits import solid_misfit
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment
from sample_parts.modelling import box, cut

_BLOCK = box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0))
_STEPPED = cut(_BLOCK, box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0)))

Draw = Callable[[TopoDS_Shape], DrawnViews]


def _stepped(views: DrawnViews, odds: float) -> DrawnViews:
    """Views of the block with the step's line in the top view, which may be annotation."""
    line = DroppedLine(np.array([[40.0, 0.0], [40.0, 40.0]]), Linetype.VISIBLE, odds)
    return replace(views, dropped={Role.TOP: (line,)})


def test_a_dropped_line_costs_by_its_odds_where_the_solid_has_none(drawn: Draw) -> None:
    views = drawn(_BLOCK)
    assert solid_misfit(_BLOCK, views).cost == pytest.approx(0.0, abs=1e-9)
    for odds in (0.1, 0.4):
        found = solid_misfit(_BLOCK, _stepped(views, odds))
        assert found.cost == pytest.approx(odds * 40.0, rel=0.05)


def test_an_edge_on_a_dropped_line_is_none_that_the_sheet_lacks(drawn: Draw) -> None:
    whole = drawn(_STEPPED)
    top = tuple(
        stroke
        for stroke in whole.strokes[Role.TOP]
        if not (isinstance(stroke, Segment) and abs(stroke.start[0] - stroke.end[0]) < 1.0)
        or abs(stroke.start[0] - 40.0) > 1.0
    )
    lost = replace(whole, strokes={**whole.strokes, Role.TOP: top})
    assert len(top) == len(whole.strokes[Role.TOP]) - 1
    assert solid_misfit(_STEPPED, lost).cost > 30.0
    assert solid_misfit(_STEPPED, _stepped(lost, 0.3)).cost == pytest.approx(0.0, abs=1e-9)


def test_a_stroke_in_doubt_costs_by_its_odds(drawn: Draw) -> None:
    views = drawn(_STEPPED)
    doubtful = tuple(replace(stroke, confidence=0.5) for stroke in views.strokes[Role.TOP])
    poor = replace(views, strokes={**views.strokes, Role.TOP: doubtful})
    found, sure = solid_misfit(_BLOCK, poor), solid_misfit(_BLOCK, views)
    of_top, surely = (
        next(view for view in each.views if view.view.role is Role.TOP) for each in (found, sure)
    )
    assert of_top.cost == pytest.approx(0.5 * surely.cost)


def test_what_is_hardly_an_edge_is_in_no_strokes_way(drawn: Draw) -> None:
    views = drawn(_STEPPED)
    along = np.array([[40.02, 0.0], [40.02, 40.0]])
    doubted = replace(
        views, dropped={Role.TOP: (DroppedLine(along, Linetype.VISIBLE, 0.2),)}, tolerance=0.05
    )
    sure = solid_misfit(_BLOCK, replace(views, tolerance=0.05))
    assert solid_misfit(_BLOCK, doubted).cost >= 0.95 * sure.cost
