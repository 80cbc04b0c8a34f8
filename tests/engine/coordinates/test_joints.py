"""Where strokes of two curves end together."""

from math import pi

import pytest

from gaussiancad_core.coordinates.joints import joints_of
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, axis_line

_SMALL, _LARGE = Circle((30.0, 20.0), 4.0), Circle((20.0, 20.0), 6.0)
"""They touch at (26, 20)."""

_REACH = 0.03


def test_two_arcs_that_end_at_one_place_end_where_they_touch() -> None:
    strokes = [(0, (pi / 2.0, pi + 0.002)), (1, (-0.001, pi / 2.0))]
    (_, small), (large, other) = joints_of([_SMALL, _LARGE], strokes, _REACH)
    assert (small, large) == pytest.approx((pi, 0.0))
    assert other is None


def test_the_parameter_of_a_joint_is_of_the_turn_in_which_the_arc_ends() -> None:
    strokes = [(0, (pi / 2.0, pi)), (1, (1.5 * pi, FULL_TURN + 0.001))]
    _, (_, large) = joints_of([_SMALL, _LARGE], strokes, _REACH)
    assert large == pytest.approx(FULL_TURN)


def test_strokes_that_end_apart_have_no_joint() -> None:
    strokes = [(0, (pi / 2.0, pi + 0.02)), (1, (0.0, pi / 2.0))]
    assert joints_of([_SMALL, _LARGE], strokes, _REACH) == [(None, None), (None, None)]


def test_pieces_of_one_line_have_no_joint() -> None:
    strokes = [(0, (0.0, 10.0)), (0, (10.0, 20.0))]
    assert joints_of([axis_line(0, 5.0)], strokes, _REACH) == [(None, None), (None, None)]


def test_curves_that_miss_each_other_have_no_joint() -> None:
    apart = Circle((20.0, 20.0), 5.99)
    strokes = [(0, (pi / 2.0, pi)), (1, (0.0, pi / 2.0))]
    assert joints_of([_SMALL, apart], strokes, _REACH) == [(None, None), (None, None)]
