"""Circles and their sides, found together."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.registration.circle_ties import Estimates, Tie, tied

LEFT, CENTRE, RIGHT, RADIUS = range(4)
TIES = (Tie(LEFT, CENTRE, RADIUS, -1), Tie(RIGHT, CENTRE, RADIUS, 1))
WEIGHTS = st.lists(st.floats(0.5, 50.0), min_size=4, max_size=4)


@given(st.lists(st.floats(-0.2, 0.2), min_size=4, max_size=4), WEIGHTS)
def test_ties_hold_and_the_values_are_the_most_likely(
    off: list[float], weights: list[float]
) -> None:
    start, weight = np.array([10.0, 30.0, 50.0, 20.0]) + off, np.array(weights)
    chain = np.array([LEFT, CENTRE, RIGHT])
    found = tied(Estimates(np.diag(weight), start, np.ones(4), (chain,)), weight * start, TIES)
    assert found[LEFT] == pytest.approx(found[CENTRE] - found[RADIUS], abs=1e-10)
    assert found[RIGHT] == pytest.approx(found[CENTRE] + found[RADIUS], abs=1e-10)
    for step in (np.array([1.0, 1.0, 1.0, 0.0]), np.array([-1.0, 0.0, 1.0, 1.0])):
        for moved in (found + 1e-3 * step, found - 1e-3 * step):
            assert weight @ (moved - start) ** 2 >= weight @ (found - start) ** 2 - 1e-9


def test_a_side_that_is_none_of_the_circle_s_is_let_go() -> None:
    start = np.array([10.0, 30.0, 55.0, 20.0])
    chain = np.array([LEFT, CENTRE, RIGHT])
    found = tied(Estimates(np.eye(4), start, np.ones(4), (chain,)), start, TIES)
    assert found[RIGHT] == 55.0
    assert found[LEFT] == pytest.approx(found[CENTRE] - found[RADIUS], abs=1e-10)


def test_order_is_kept_rather_than_a_tie() -> None:
    # A sure radius would push the left side behind its neighbour.
    start, weights = np.array([10.0, 30, 50, 19, 10.5]), np.array([0.01, 100, 1, 100, 100])
    estimates = Estimates(np.diag(weights), start, np.full(5, 2.0), (np.array([0, 4, 1, 2]),))
    assert tied(estimates, weights * start, (TIES[0],)).tolist() == start.tolist()
