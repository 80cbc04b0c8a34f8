"""Lines where faces meet smoothly, and edges that stand where they could be."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.tangent_edges import without_tangent_edges

VISIBLE = Linetype.VISIBLE


def _line(x0: float, y0: float, x1: float, y1: float) -> Segment:
    return Segment((x0, y0), (x1, y1), VISIBLE)


def _rounded(x0: float, y0: float, width: float, height: float, radius: float) -> list[Stroke]:
    """A rectangle with one round corner, the upper right one."""
    x1, y1 = x0 + width, y0 + height
    return [
        _line(x0, y0, x1 - radius, y0),
        Arc((x1 - radius, y0 + radius), radius, 1.5 * np.pi, 0.5 * np.pi, VISIBLE),
        _line(x1, y0 + radius, x1, y1),
        _line(x1, y1, x0, y1),
        _line(x0, y1, x0, y0),
    ]


def _box(x0: float, y0: float, width: float, height: float) -> list[Stroke]:
    x1, y1 = x0 + width, y0 + height
    return [
        _line(x0, y0, x1, y0),
        _line(x1, y0, x1, y1),
        _line(x1, y1, x0, y1),
        _line(x0, y1, x0, y0),
    ]


def _views(top: list[Stroke], front: list[Stroke], width: float) -> list[ReadView]:
    """From above 100 px high, from the front 40."""
    return [
        ReadView(Role.FRONT, (50.0, 300.0, 50.0 + width, 340.0), tuple(front), None, VECTOR),
        ReadView(Role.TOP, (50.0, 100.0, 50.0 + width, 200.0), tuple(top), None, VECTOR),
    ]


VECTOR = StrokesSource.VECTOR


def _taken_off(views: list[ReadView]) -> tuple[tuple[ReadView, ...], tuple[Stroke, ...]]:
    """The views, and all lines that were taken off them."""
    found = without_tangent_edges(views).views
    return found, tuple(line for view in found for line in view.tangents)


@given(width=st.floats(120.0, 400.0), radius=st.floats(5.0, 90.0))
def test_the_line_at_a_round_corner_is_no_edge(width: float, radius: float) -> None:
    seam = _line(50.0 + width - radius, 300.0, 50.0 + width - radius, 340.0)
    edge = _line(50.0 + width - radius - 9.0, 300.0, 50.0 + width - radius - 9.0, 340.0)
    top = _rounded(50.0, 100.0, width, 100.0, radius)
    front = [*_box(50.0, 300.0, width, 40.0), seam, edge]
    (found, above), gone = _taken_off(_views(top, front, width))
    assert gone == (seam,)
    assert edge in found.strokes and len(found.strokes) == 5 and len(above.strokes) == len(top)


def test_it_is_one_where_the_other_view_has_a_corner_too() -> None:
    seam = _line(230.0, 300.0, 230.0, 340.0)
    step = [_line(230.0, 150.0, 230.0, 170.0), _line(230.0, 170.0, 240.0, 170.0)]
    top = [*_rounded(50.0, 100.0, 200.0, 100.0, 20.0), *step]
    views = _views(top, [*_box(50.0, 300.0, 200.0, 40.0), seam], 200.0)
    found, gone = _taken_off(views)
    assert gone == () and list(found) == views


def test_outlines_and_slanted_lines_stay() -> None:
    top = _rounded(50.0, 100.0, 200.0, 100.0, 20.0)
    slanted = _line(230.0, 300.0, 236.0, 340.0)
    views = _views(top, [*_box(50.0, 300.0, 200.0, 40.0), slanted], 200.0)
    assert _taken_off(views)[1] == ()


def test_lines_across_a_chamfer_from_one_rounding_to_the_next_are_none() -> None:
    # A round corner with a chamfer: two outlines, and lines where its cone meets its planes.
    outer = _rounded(50.0, 100.0, 200.0, 100.0, 20.0)
    inner = _rounded(54.0, 104.0, 192.0, 92.0, 16.0)
    across = [_line(230.0, 100.0, 230.0, 104.0), _line(246.0, 120.0, 250.0, 120.0)]
    ridge = _line(50.0, 100.0, 54.0, 104.0)
    views = _views([*outer, *inner, *across, ridge], _box(50.0, 300.0, 200.0, 40.0), 200.0)
    (_, above), gone = _taken_off(views)
    assert sorted(item.start for item in gone) == sorted(item.start for item in across)
    assert ridge in above.strokes


@pytest.mark.parametrize("source", list(StrokesSource))
def test_whole_circles_are_no_corners(source: StrokesSource) -> None:
    seam = _line(230.0, 300.0, 230.0, 340.0)
    hole = Arc((230.0, 150.0), 12.0, 0.0, 2.0 * np.pi, VISIBLE)
    top = [*_rounded(50.0, 100.0, 200.0, 100.0, 20.0), hole]
    views = _views(top, [*_box(50.0, 300.0, 200.0, 40.0), seam], 200.0)
    assert _taken_off(views)[1] == (seam,)


def test_a_line_that_goes_on_is_an_edge_though_an_arc_leaves_it_smoothly() -> None:
    # Two pieces of one line along a side, and arcs that leave it between them and at its ends.
    side = [_line(80.0, 200.0, 80.0, 160.0), _line(80.0, 160.0, 80.0, 120.0)]
    arcs = [
        Arc((100.0, 160.0), 20.0, np.pi, 0.5 * np.pi, VISIBLE),
        Arc((60.0, 120.0), 20.0, 1.5 * np.pi, 0.5 * np.pi, VISIBLE),
        Arc((60.0, 200.0), 20.0, 0.0, 0.5 * np.pi, VISIBLE),
    ]
    views = _views([*side, *arcs], _box(50.0, 300.0, 200.0, 40.0), 200.0)
    assert _taken_off(views)[1] == ()


def test_where_a_sheet_draws_no_such_lines_one_of_them_is_an_edge() -> None:
    # The lower left corner of the outline is round, too, and has no line below.
    top = [
        _line(50.0, 100.0, 230.0, 100.0),
        Arc((230.0, 120.0), 20.0, 1.5 * np.pi, 0.5 * np.pi, VISIBLE),
        _line(250.0, 120.0, 250.0, 200.0),
        _line(250.0, 200.0, 70.0, 200.0),
        Arc((70.0, 180.0), 20.0, 0.5 * np.pi, 0.5 * np.pi, VISIBLE),
        _line(50.0, 180.0, 50.0, 100.0),
    ]
    seam = _line(230.0, 300.0, 230.0, 340.0)
    views = _views(top, [*_box(50.0, 300.0, 200.0, 40.0), seam], 200.0)
    assert _taken_off(views)[1] == ()


def test_round_corners_within_an_outline_are_hidden_from_the_side() -> None:
    top = _rounded(50.0, 100.0, 200.0, 100.0, 20.0)
    pocket = _rounded(100.0, 130.0, 60.0, 40.0, 10.0)
    seam = _line(230.0, 300.0, 230.0, 340.0)
    views = _views([*top, *pocket], [*_box(50.0, 300.0, 200.0, 40.0), seam], 200.0)
    assert _taken_off(views)[1] == (seam,)


def test_an_outline_that_turns_away_is_drawn() -> None:
    # The end of a slot, seen from its side: there is a line where the wall turns away.
    slot = [
        _line(250.0, 130.0, 200.0, 130.0),
        Arc((200.0, 150.0), 20.0, 0.5 * np.pi, np.pi, VISIBLE),
        _line(200.0, 170.0, 250.0, 170.0),
    ]
    turn = _line(180.0, 300.0, 180.0, 340.0)
    seam = _line(200.0, 300.0, 200.0, 340.0)
    front = [*_box(50.0, 300.0, 200.0, 40.0), turn, seam]
    found, gone = _taken_off(_views(slot, front, 200.0))
    assert gone == (seam,) and turn in found[0].strokes
