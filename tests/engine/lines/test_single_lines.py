import numpy as np
import pytest

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.lines.single_lines import clean_strokes, distinct_strokes
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.views import Arc, Linetype, Segment

V, H = Linetype.VISIBLE, Linetype.HIDDEN
PRECISION = Precision(1e-4, 5e-4, 1e-2, 2e-2)
TURN = 2.0 * np.pi


def _segments(strokes: tuple) -> list[tuple]:
    return [
        (
            *sorted(tuple(np.round(end, 6).tolist()) for end in (stroke.start, stroke.end)),
            stroke.linetype,
        )
        for stroke in strokes
    ]


def test_pieces_of_one_line_become_one_whatever_their_direction() -> None:
    pieces = [
        Segment((0.0, 0.0), (3.0, 3.0), V),
        Segment((5.0, 5.0), (2.0, 2.0), V),
        Segment((5.0, 5.0), (9.0, 9.0), V),
        Segment((4.0, 4.0), (4.5, 4.5), V),
    ]
    assert _segments(clean_strokes(pieces, PRECISION)) == [((0.0, 0.0), (9.0, 9.0), V)]


def test_hidden_pieces_lose_what_is_visible() -> None:
    pieces = [
        Segment((0.0, 0.0), (10.0, 0.0), H),
        Segment((7.0, 0.0), (3.0, 0.0), V),
        Segment((2.0, 0.0), (8.0, 0.0), H),
    ]
    assert _segments(clean_strokes(pieces, PRECISION)) == [
        ((3.0, 0.0), (7.0, 0.0), V),
        ((0.0, 0.0), (3.0, 0.0), H),
        ((7.0, 0.0), (10.0, 0.0), H),
    ]


def test_parallel_lines_stay_apart() -> None:
    pieces = [Segment((0.0, 0.01 * k), (10.0, 0.01 * k), V) for k in range(4)]
    assert len(clean_strokes(pieces, PRECISION)) == 4


def test_crumbs_vanish_and_hairline_gaps_close() -> None:
    pieces = [
        Segment((0.0, 0.0), (5.0, 0.0), V),
        Segment((5.015, 0.0), (9.0, 0.0), V),
        Segment((3.0, 1.0), (3.01, 1.0), V),
        Arc((0.0, 0.0), 4.0, 0.0, 0.004, H),
    ]
    assert _segments(clean_strokes(pieces, PRECISION)) == [((0.0, 0.0), (9.0, 0.0), V)]


def test_a_circle_in_pieces_is_whole_again_and_hides_what_is_under_it() -> None:
    pieces = [
        Arc((1.0, 2.0), 5.0, 0.5, 3.0, V),
        Arc((1.0, 2.0), 5.0, 3.4, TURN - 2.8, V),
        Arc((1.0, 2.0), 5.0, 0.0, TURN, H),
    ]
    (circle,) = clean_strokes(pieces, PRECISION)
    assert (circle.linetype, circle.sweep) == (V, TURN)


def test_a_circle_that_is_half_visible_is_half_hidden() -> None:
    pieces = [
        Arc((0.0, 0.0), 5.0, 0.0, TURN, H),
        Arc((0.0, 0.0), 5.0, 1.5 * np.pi, np.pi, V),
    ]
    visible, hidden = clean_strokes(pieces, PRECISION)
    assert (visible.linetype, hidden.linetype) == (V, H)
    assert visible.start_angle == pytest.approx(1.5 * np.pi)
    assert (hidden.start_angle, hidden.sweep) == pytest.approx((0.5 * np.pi, np.pi))


def test_concentric_circles_stay_apart() -> None:
    pieces = [Arc((0.0, 0.0), 5.0 + 0.01 * k, 0.0, TURN, V) for k in range(3)]
    assert len(clean_strokes(pieces, PRECISION)) == 3


def test_chains_give_way_to_lines_and_circles() -> None:
    angles = np.linspace(0.3, 2.0, 200)
    chain = Polyline(tuple((5.0 * float(np.cos(a)), 5.0 * float(np.sin(a))) for a in angles), V)
    circle = Arc((0.0, 0.0), 5.0, 0.0, TURN, V)
    assert clean_strokes([chain, circle], PRECISION) == (circle,)
    hidden = Arc((0.0, 0.0), 5.0, 0.0, TURN, H)
    seen, rest = clean_strokes([chain, hidden], PRECISION)
    assert seen == chain
    assert rest.linetype is H
    assert rest.length == pytest.approx(5.0 * (TURN - 1.7), abs=0.1)


def test_distinct_strokes_are_not_cut() -> None:
    whole = Polyline(tuple((float(x), 0.02 * float(x) ** 2) for x in range(20)), V)
    half = Polyline(whole.points[:10], V)
    other = Polyline(tuple((x, y + 3.0) for x, y in whole.points), V)
    assert distinct_strokes([half, whole, other], PRECISION) == (whole, other)
    assert distinct_strokes([half, other], PRECISION) == (other, half)
