"""Infinite lines and circles."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.infinite_curves import Circle, Line

COORDINATE = st.floats(-1e4, 1e4)
ANGLE = st.floats(-np.pi, np.pi)


def _line(x: float, y: float, angle: float) -> Line:
    return Line((x, y), (float(np.cos(angle)), float(np.sin(angle))))


@given(COORDINATE, COORDINATE, ANGLE, st.lists(COORDINATE, min_size=1, max_size=5))
def test_points_at_a_position_have_that_position(
    x: float, y: float, angle: float, positions: list[float]
) -> None:
    line = _line(x, y, angle)
    points = np.array([line.at(position) for position in positions])
    along, across = line.coordinates(points)
    assert along == pytest.approx(np.array(positions), abs=1e-8)
    assert across == pytest.approx(0.0, abs=1e-8)


@given(COORDINATE, COORDINATE, ANGLE, COORDINATE, COORDINATE)
def test_coordinates_are_those_of_a_turned_frame(
    x: float, y: float, angle: float, px: float, py: float
) -> None:
    line = _line(x, y, angle)
    along, across = line.coordinates(np.array([[px, py]]))
    dx, dy = line.direction
    back = np.array(line.at(float(along[0]))) + float(across[0]) * np.array([-dy, dx])
    assert back == pytest.approx(np.array([px, py]), abs=1e-8)
    assert line.distances(np.array([[px, py]])) == pytest.approx(abs(across))


def test_the_side_to_which_y_points_is_positive() -> None:
    along, across = Line((2.0, 3.0), (1.0, 0.0)).coordinates(np.array([[7.0, 5.0], [1.0, 2.0]]))
    assert along.tolist() == [5.0, -1.0]
    assert across.tolist() == [2.0, -1.0]


@given(COORDINATE, COORDINATE, st.floats(0.5, 1e4), ANGLE, st.floats(-0.4, 1e4))
def test_distance_from_a_circle(
    x: float, y: float, radius: float, angle: float, beyond: float
) -> None:
    reach = radius + beyond
    point = np.array([[x + reach * np.cos(angle), y + reach * np.sin(angle)]])
    assert Circle((x, y), radius).distances(point) == pytest.approx(abs(beyond), abs=1e-7)
    assert Circle((x, y), radius).distances(np.array([[x, y]])) == pytest.approx(radius)


def test_no_points_have_no_distances() -> None:
    none = np.zeros((0, 2))
    assert Line((0.0, 0.0), (1.0, 0.0)).distances(none).shape == (0,)
    assert Circle((0.0, 0.0), 3.0).distances(none).shape == (0,)
