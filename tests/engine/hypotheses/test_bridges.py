"""Gaps between ends and curves."""

from math import pi

import numpy as np
import pytest

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.coordinates.point_chains import chain_distances
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, axis_line
from gaussiancad_core.hypotheses.bridges import bridges
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype


def _support(curve: LineOrCircle, *stretches: tuple[float, float]) -> Carrier:
    intervals = tuple(Interval(low, high, Linetype.VISIBLE, 1.0) for low, high in stretches)
    return Carrier(curve, {Role.FRONT: intervals})


def _open_square(gap: float) -> list[Carrier]:
    """A square of 10 whose upper side ends ``gap`` before the right one."""
    return [
        _support(axis_line(0, 0.0), (0.0, 10.0)),
        _support(axis_line(0, 10.0), (0.0, 10.0)),
        _support(axis_line(1, 0.0), (0.0, 10.0)),
        _support(axis_line(1, 10.0), (0.0, 10.0 - gap)),
    ]


def test_a_closed_outline_needs_no_bridge() -> None:
    assert bridges(Arrangement(_open_square(0.0)), [], 1.0) == []


@pytest.mark.parametrize("gap", [1e-3, 0.04])
def test_a_gap_within_reach_is_closed(gap: float) -> None:
    carriers = _open_square(gap)
    plain = Arrangement(carriers)
    assert plain.regions == 1 and plain.locate(5.0, 5.0) == OUTSIDE
    found = bridges(plain, [], 0.05)
    ends = {frozenset((round(a, 9), round(b, 9)) for a, b in link) for link in found}
    assert ends == {frozenset({(10.0 - gap, 10.0), (10.0, 10.0)})}
    closed = Arrangement(carriers, found)
    assert closed.regions == 2 and closed.locate(5.0, 5.0) != OUTSIDE


def test_a_gap_beyond_reach_is_left_open() -> None:
    assert bridges(Arrangement(_open_square(0.2)), [], 0.05) == []


def test_a_chain_is_led_to_the_curves_that_it_ends_before() -> None:
    carriers = _open_square(0.0)[:3]
    chain = ((0.01, 9.0), (5.0, 11.0), (9.98, 9.0))
    plain = Arrangement(carriers)
    found = bridges(plain, [chain], 0.05)
    assert sorted(found) == [
        ((0.01, 9.0), (0.0, 9.0)),
        ((9.98, 9.0), (10.0, 9.0)),
    ]
    # The ends of the upright lines stand free over the chain and are let be.
    assert Arrangement(carriers, [chain]).regions == 1
    assert Arrangement(carriers, [chain, *found]).regions == 2


def test_chains_are_led_to_each_other() -> None:
    one, other = ((0.0, 0.0), (5.0, 1.0)), ((5.0, 1.03), (9.0, 4.0))
    found = bridges(Arrangement([]), [one, other], 0.05)
    assert found == [((5.0, 1.0), (5.0, 1.03))]
    ((_, end),) = found
    assert chain_distances(np.array(other), np.array([end]))[0] < 1e-12


def test_whole_circles_have_no_ends_and_arcs_reach_across_the_start_of_angles() -> None:
    circle = Circle((0.0, 0.0), 5.0)
    assert bridges(Arrangement([_support(circle, (0.0, FULL_TURN))]), [], 1.0) == []
    arc = _support(circle, (0.002, pi / 2))
    wall = _support(axis_line(0, 0.0), (0.0, 5.0))
    floor = _support(axis_line(1, 0.0), (0.0, 5.0))
    plain = Arrangement([arc, wall, floor])
    found = bridges(plain, [], 0.05)
    assert plain.regions == 1 and found
    assert Arrangement([arc, wall, floor], found).locate(2.0, 2.0) != OUTSIDE
