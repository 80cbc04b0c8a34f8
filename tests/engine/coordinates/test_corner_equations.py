"""Equations of corners: zero where they should be, with the gradients that they tell."""

from math import cos, hypot, sin

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.corner_equations import (
    OnCircle,
    OnFacet,
    OnSlant,
    Slant,
    Touches,
    TouchesCircle,
    crossings,
)
from gaussiancad_core.coordinates.linear_constraints import Relation

_SLANT = Slant((3.0, -2.0), (43.0, 28.0), 50.0)
_FRAME = np.linalg.qr(np.array([[1.0, 0.2, -0.4], [0.3, 1.0, 0.5], [-0.2, 0.1, 1.0]]))[0]
_RELATIONS: list[tuple[Relation, int]] = [
    (OnSlant(0, 1, 2, _SLANT), 4),
    (OnCircle(0, 1, 2), 5),
    (Touches(0, 3, _SLANT, 1.0), 5),
    (Touches(0, 3, _SLANT, -1.0), 5),
    (TouchesCircle(0, 3, inside=False), 6),
    (TouchesCircle(0, 3, inside=True), 6),
    (OnFacet((0, 1, 2), 3, _FRAME, np.array([5.0, 6.0, 7.0])), 6),
]
_SMALL = st.floats(-2.0, 2.0)


@pytest.mark.parametrize(("relation", "count"), _RELATIONS)
@given(st.lists(st.floats(1.0, 30.0), min_size=6, max_size=6))
def test_gradients_are_those_of_the_equation(
    relation: Relation, count: int, values: list[float]
) -> None:
    numbers = np.array(values[:count])
    _, terms = relation.at(numbers)
    stated = np.zeros(count)
    for place, factor in terms:
        stated[place] += factor
    step = 1e-5
    steps = step * np.eye(count)
    found = [
        (relation.at(numbers + d)[0] - relation.at(numbers - d)[0]) / (2 * step) for d in steps
    ]
    # Near a circle's centre its gradient turns fast.
    assert stated == pytest.approx(np.array(found), abs=1e-5) or _is_at_centre(relation, numbers)


def _is_at_centre(relation: Relation, numbers: np.ndarray) -> bool:
    if isinstance(relation, TouchesCircle):
        return hypot(*(numbers[:2] - numbers[3:5])) < 0.1
    return isinstance(relation, OnCircle) and hypot(*(numbers[:2] - numbers[2:4])) < 0.1


@given(_SMALL, _SMALL, st.floats(-0.5, 1.5))
def test_points_of_a_line_that_moved_lie_on_it(low: float, high: float, share: float) -> None:
    # The line runs along (.8, .6); its offsets are to the left.
    left = np.array([-0.6, 0.8])
    start, end = np.array(_SLANT.start) + low * left, np.array(_SLANT.end) + high * left
    point = start + share * (end - start)
    value, _ = OnSlant(0, 1, 2, _SLANT).at(np.array([*point, low, high]))
    assert value == pytest.approx(0.0, abs=1e-9)


@given(_SMALL, _SMALL, st.floats(1.0, 20.0), st.floats(0.0, 1.0), st.sampled_from([1.0, -1.0]))
def test_circles_that_a_line_touches_are_touched(
    low: float, high: float, radius: float, share: float, side: float
) -> None:
    left = np.array([-0.6, 0.8])
    start, end = np.array(_SLANT.start) + low * left, np.array(_SLANT.end) + high * left
    along = (end - start) / np.linalg.norm(end - start)
    centre = start + share * (end - start) + side * radius * np.array([-along[1], along[0]])
    value, _ = Touches(0, 3, _SLANT, side).at(np.array([*centre, radius, low, high]))
    assert value == pytest.approx(0.0, abs=1e-9)


@given(st.floats(0.0, 6.28), st.floats(0.5, 20.0))
def test_points_of_a_circle_lie_on_it(angle: float, radius: float) -> None:
    point = 4.0 + radius * cos(angle), 5.0 + radius * sin(angle)
    value, _ = OnCircle(0, 1, 2).at(np.array([*point, 4.0, 5.0, radius]))
    assert value == pytest.approx(0.0, abs=1e-9)


@given(st.floats(0.0, 6.28), st.floats(0.5, 20.0), st.floats(0.5, 20.0), st.booleans())
def test_circles_touch_where_they_share_a_point_and_a_tangent(
    angle: float, one: float, other: float, inside: bool
) -> None:
    assume(not inside or one > other)
    away = one - other if inside else one + other
    centre = 4.0 + away * cos(angle), 5.0 + away * sin(angle)
    value, _ = TouchesCircle(0, 3, inside).at(np.array([4.0, 5.0, one, *centre, other]))
    assert value == pytest.approx(0.0, abs=1e-9)


def test_lines_cross_where_both_are_drawn() -> None:
    one = Slant((0.0, 0.0), (10.0, 10.0), 1.0)
    across = Slant((0.0, 8.0), (8.0, 0.0), 1.0)
    before, neighbour = Slant((0.0, 30.0), (30.0, 0.0), 1.0), Slant((0.0, 1.0), (9.0, 10.0), 1.0)
    assert list(crossings([one, across])) == [pytest.approx((4.0, 4.0))]
    assert list(crossings([one, before])) == list(crossings([one, neighbour])) == []
