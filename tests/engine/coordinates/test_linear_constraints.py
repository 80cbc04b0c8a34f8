"""Numbers move as little as possible until what is known of them holds."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.linear_constraints import Linear, Numbers, Terms, solved

_NUMBER = st.floats(-50.0, 50.0)
_WEIGHT = st.floats(0.1, 100.0)


def _equal(one: int, other: int) -> Linear:
    return Linear(((one, 1.0), (other, -1.0)))


@given(st.lists(st.tuples(_NUMBER, _WEIGHT), min_size=2, max_size=6))
def test_equal_numbers_become_their_weighted_mean(readings: list[tuple[float, float]]) -> None:
    observed, weights = (list(item) for item in zip(*readings, strict=True))
    chain = [_equal(k, k + 1) for k in range(len(observed) - 1)]
    # The last says what the others do already.
    found = solved(observed, weights, [*chain, _equal(0, len(observed) - 1)], 1e3)
    assert found == pytest.approx([np.average(observed, weights=weights)] * len(observed), abs=1e-6)


@given(st.lists(_NUMBER, min_size=1, max_size=6))
def test_without_relations_all_stay(observed: list[float]) -> None:
    assert solved(observed, [1.0] * len(observed), [], 1.0).tolist() == observed


def test_what_asks_for_too_much_is_dropped() -> None:
    found = solved([0.0, 0.2, 5.0], [1.0, 1.0, 1.0], [_equal(0, 1), _equal(1, 2)], 1.0)
    assert found == pytest.approx([0.1, 0.1, 5.0])


def test_each_number_has_its_own_reach() -> None:
    relation = [_equal(0, 1)]
    assert solved([0.0, 1.0], [1.0, 1e-6], relation, [0.1, 2.0]) == pytest.approx([0, 0], abs=1e-5)
    assert solved([0.0, 1.0], [1e-6, 1.0], relation, [0.1, 2.0]).tolist() == [0.0, 1.0]


def test_of_relations_that_contradict_each_other_one_is_dropped() -> None:
    shifted = _Circle(1.0), _Circle(1.2)
    x, y = solved([0.8, 0.7], [1.0, 1.0], shifted, 1.0)
    assert np.hypot(x, y) in (pytest.approx(1.0), pytest.approx(1.2))


class _Circle:
    """Two numbers are a point on a circle about the origin."""

    def __init__(self, radius: float) -> None:
        self._radius = radius

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        away = float(np.hypot(*numbers))
        return away - self._radius, [(0, numbers[0] / away), (1, numbers[1] / away)]


@given(st.floats(0.2, 3.0), st.floats(0.0, 6.28))
def test_a_curved_relation_is_met_at_the_nearest_point(away: float, angle: float) -> None:
    point = away * np.cos(angle), away * np.sin(angle)
    found = solved(point, [1.0, 1.0], [_Circle(1.0)], 10.0)
    assert found == pytest.approx([np.cos(angle), np.sin(angle)], abs=1e-6)
