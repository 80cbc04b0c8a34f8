"""Circles and their sides, found together."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.registration.circle_ties import Estimates, Tie, tied

LEFT, CENTRE, RIGHT, RADIUS = range(4)
TIES = (Tie(LEFT, CENTRE, RADIUS, -1), Tie(RIGHT, CENTRE, RADIUS, 1))
OFF = st.floats(-0.2, 0.2)


def known(start: list[float], weights: list[float], limit: float = 1.0) -> Estimates:
    """Independent observations of (left, centre, right, radius)."""
    chain = np.array([LEFT, CENTRE, RIGHT])
    return Estimates(np.diag(weights), np.array(start), np.full(4, limit), (chain,))


@given(OFF, OFF, OFF, OFF, st.lists(st.floats(0.5, 50.0), min_size=4, max_size=4))
def test_ties_hold_and_the_values_are_the_most_likely(
    a: float, b: float, c: float, d: float, weights: list[float]
) -> None:
    start = np.array([10.0 + a, 30.0 + b, 50.0 + c, 20.0 + d])
    item = known(start.tolist(), weights)
    found = tied(item, np.array(weights) * start, TIES)
    assert found[LEFT] == pytest.approx(found[CENTRE] - found[RADIUS], abs=1e-10)
    assert found[RIGHT] == pytest.approx(found[CENTRE] + found[RADIUS], abs=1e-10)

    def misfit(values: np.ndarray) -> float:
        return float(np.array(weights) @ (values - start) ** 2)

    for step in (np.array([1.0, 1.0, 1.0, 0.0]), np.array([-1.0, 0.0, 1.0, 1.0])):
        for size in (1e-3, -1e-3):
            assert misfit(found + size * step) >= misfit(found) - 1e-9


def test_a_side_that_is_none_of_the_circle_s_is_let_go() -> None:
    # The right side lies 5 px from where it would have to.
    start = np.array([10.0, 30.0, 55.0, 20.0])
    item = known(start.tolist(), [1.0] * 4)
    found = tied(item, start, TIES)
    assert found[RIGHT] == 55.0
    assert found[LEFT] == pytest.approx(found[CENTRE] - found[RADIUS], abs=1e-10)


def test_order_is_kept_rather_than_a_tie() -> None:
    # A sure radius would push the left side behind its neighbour.
    start = np.array([10.0, 30.0, 50.0, 19.0, 10.5])
    weights = np.array([0.01, 100.0, 1.0, 100.0, 100.0])
    chain = np.array([0, 4, 1, 2])
    estimates = Estimates(np.diag(weights), start, np.full(5, 2.0), (chain,))
    found = tied(estimates, weights * start, (TIES[0],))
    assert found.tolist() == start.tolist()


def test_nothing_is_moved_without_ties() -> None:
    start = np.array([10.0, 31.0, 50.0, 19.0])
    assert tied(known(start.tolist(), [1.0] * 4), start, ()).tolist() == start.tolist()
