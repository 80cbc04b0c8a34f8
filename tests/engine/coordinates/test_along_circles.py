"""Chains that are parts of circles."""

from math import cos, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.along_circles import arc_along
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle

_NEAR = 0.05


def _points(circle: Circle, start: float, sweep: float, off: float) -> tuple[tuple, ...]:
    """Points of an arc, every second one off the circle."""
    (x, y), r = circle.centre, circle.radius
    angles = [start + sweep * k / 40.0 for k in range(41)]
    return tuple(
        (x + (r + off * (k % 2)) * cos(t), y + (r + off * (k % 2)) * sin(t))
        for k, t in enumerate(angles)
    )


@given(
    st.tuples(st.floats(0.0, 100.0), st.floats(0.0, 100.0)),
    st.floats(5.0, 50.0),
    st.floats(0.0, 6.0),
    st.floats(1.0, 5.0),
    st.sampled_from([(1, -0.9), (1, 0.0), (-1, 0.5), (-1, 0.9)]),
)
def test_points_along_an_arc_tell_it_whichever_way_they_run(
    centre: tuple[float, float],
    radius: float,
    start: float,
    sweep: float,
    run: tuple[int, float],
) -> None:
    way, off = run
    circle = Circle(centre, radius)
    points = _points(circle, start, sweep, off * _NEAR)
    found = arc_along(points[::way], circle, _NEAR)
    assert found is not None
    low, turned = found
    assert turned == pytest.approx(sweep, abs=1e-9)
    assert (low - start + pi) % FULL_TURN - pi == pytest.approx(0.0, abs=1e-9)


def test_points_beside_the_circle_are_none_of_it() -> None:
    circle = Circle((10.0, 20.0), 30.0)
    assert arc_along(_points(circle, 0.0, 1.0, 2.0 * _NEAR), circle, _NEAR) is None


def test_a_way_back_is_no_arc() -> None:
    circle = Circle((10.0, 20.0), 30.0)
    points = _points(circle, 0.0, 1.0, 0.0)
    assert arc_along((*points, points[-3]), circle, _NEAR) is None


def test_what_is_nearly_straight_is_left_alone() -> None:
    circle = Circle((0.0, 0.0), 50.0)
    assert arc_along(_points(circle, 0.0, 0.1, 0.0), circle, _NEAR) is None
