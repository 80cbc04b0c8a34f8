"""Places to which gestures snap."""

from math import hypot

import pytest
from hypothesis import given
from hypothesis import strategies as st

from freecad.gaussiancad.canvas.handles import box_between, corners_of, with_corner, with_handle
from freecad.gaussiancad.canvas.sheet import Sheet, Stroke
from freecad.gaussiancad.canvas.snapping import snapped

_LEVEL = Stroke("s1", "front", "visible", ("line", ((0.0, 50.0), (40.0, 50.0))))
_UPRIGHT = Stroke("s2", "front", "hidden", ("line", ((60.0, 0.0), (60.0, 30.0))))
_CIRCLE = Stroke("s3", "front", "visible", ("arc", (200.0, 200.0, 30.0, 0.0, 6.283185)))
_CENTRE = Stroke("s4", "front", "centre", ("line", ((111.0, 0.0), (111.0, 99.0))))
_SHEET = Sheet((_LEVEL, _UPRIGHT, _CIRCLE, _CENTRE), (), (), "", None)


def test_ends_and_centres_go_before_rows_and_columns() -> None:
    assert snapped(_SHEET, (39.0, 52.0), 5.0) == (40.0, 50.0)
    assert snapped(_SHEET, (203.0, 198.0), 5.0) == (200.0, 200.0)
    assert snapped(_SHEET, (41.0, 130.0), 5.0) == (40.0, 130.0)
    assert snapped(_SHEET, (130.0, 130.0), 5.0) == (130.0, 130.0)


def test_hidden_lines_of_a_hole_are_in_the_columns_of_its_circle() -> None:
    assert snapped(_SHEET, (172.0, 90.0), 5.0) == (170.0, 90.0)
    assert snapped(_SHEET, (228.0, 90.0), 5.0) == (230.0, 90.0)
    assert snapped(_SHEET, (90.0, 167.0), 5.0) == (90.0, 170.0)
    assert snapped(_SHEET, (201.0, 229.0), 5.0) == (200.0, 230.0)


def test_lines_meet_where_they_would_go_on() -> None:
    assert snapped(_SHEET, (61.0, 48.0), 5.0) == (60.0, 50.0)


def test_other_lines_than_the_parts_do_not_snap() -> None:
    assert snapped(_SHEET, (112.0, 98.0), 5.0) == (112.0, 98.0)


def test_a_line_ends_where_it_touches_a_circle() -> None:
    start = (200.0, 100.0)
    x, y = snapped(_SHEET, (172.5, 189.0), 5.0, start)
    assert hypot(x - 200.0, y - 200.0) == pytest.approx(30.0)
    along = (x - start[0]) * (x - 200.0) + (y - start[1]) * (y - 200.0)
    assert along == pytest.approx(0.0, abs=1e-9)


_places = st.tuples(st.floats(-1e3, 1e3), st.floats(-1e3, 1e3))


@given(_places, _places, st.integers(0, 3), _places)
def test_the_corner_opposite_to_one_that_moves_stays(
    one: tuple[float, float], other: tuple[float, float], index: int, to: tuple[float, float]
) -> None:
    box = box_between(one, other)
    stays = corners_of(box)[(index + 2) % 4]
    moved = with_corner(box, index, to)
    assert moved[0] <= moved[2] and moved[1] <= moved[3]
    assert {to, stays} <= set(corners_of(moved))


def test_handles_of_a_circle_move_it_or_make_it_larger() -> None:
    shape = _CIRCLE.shape
    assert with_handle(shape, 0, (10.0, 20.0))[1][:3] == (10.0, 20.0, 30.0)
    assert with_handle(shape, 1, (200.0, 260.0))[1][:3] == (200.0, 200.0, 60.0)
