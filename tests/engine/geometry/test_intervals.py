import itertools

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.intervals import subtract, unite, unite_on_circle

TURN = 2.0 * np.pi
edge = st.integers(0, 40).map(lambda value: value / 4.0)
interval = st.tuples(edge, edge).map(lambda pair: (min(pair), max(pair)))
intervals = st.lists(interval, max_size=8)


def _holds(found: list[tuple[float, float]], at: float) -> bool:
    return any(low <= at <= high for low, high in found)


@given(intervals)
def test_union_holds_the_same_points_and_is_disjoint(given_ones: list) -> None:
    united = unite(given_ones, 0.0)
    for at in np.arange(0.0, 10.0, 0.125) + 0.05:
        assert _holds(united, at) == _holds(given_ones, at)
    for (_, high), (low, _) in itertools.pairwise(united):
        assert high < low


@given(intervals, intervals)
def test_difference_holds_what_is_in_the_first_only(first: list, second: list) -> None:
    left = subtract(unite(first, 0.0), second)
    for at in np.arange(0.0, 10.0, 0.125) + 0.05:
        assert _holds(left, at) == (_holds(first, at) and not _holds(second, at))


def test_small_gaps_close() -> None:
    assert unite([(0.0, 1.0), (1.05, 2.0), (2.2, 3.0)], 0.1) == [(0.0, 2.0), (2.2, 3.0)]


def test_a_circle_in_pieces_is_whole_again() -> None:
    third = TURN / 3.0
    pieces = [(1.0 + k * third, 1.0 + (k + 1) * third) for k in range(3)]
    assert unite_on_circle(pieces, 1e-6) == [(0.0, TURN)]


def test_an_arc_over_zero_stays_one() -> None:
    assert unite_on_circle([(TURN - 0.5, TURN + 0.25), (0.2, 0.75)], 1e-9) == [
        (TURN - 0.5, TURN + 0.75)
    ]
    assert unite_on_circle([], 0.1) == []
    assert subtract([(0.0, 1.0)], [(0.0, 1.0)]) == []
