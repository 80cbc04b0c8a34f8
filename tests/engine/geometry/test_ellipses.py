"""Ellipses through points, and distances from them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.ellipses import WholeEllipse, ellipse_through, refined

ellipses = st.builds(
    lambda x, y, major, ratio, rotation: WholeEllipse((x, y), major, ratio * major, rotation),
    *[st.floats(-300.0, 300.0)] * 2,
    st.floats(2.0, 200.0),
    st.floats(0.1, 0.95),
    st.floats(0.0, 3.1),
)


def _points(ellipse: WholeEllipse, at: np.ndarray, beyond: float = 0.0) -> np.ndarray:
    """Points at parameters, moved outwards along the normals."""
    a, b = ellipse.semi_major, ellipse.semi_minor
    local = np.stack([a * np.cos(at), b * np.sin(at)], 1)
    normals = np.stack([b * np.cos(at), a * np.sin(at)], 1)
    local += beyond * normals / np.hypot(*normals.T)[:, None]
    cosine, sine = np.cos(ellipse.rotation), np.sin(ellipse.rotation)
    return np.array(ellipse.centre) + local @ np.array([[cosine, sine], [-sine, cosine]])


@given(ellipses, st.floats(-3.0, 3.0), st.floats(2.0, 6.2))
def test_points_give_their_ellipse_back(ellipse: WholeEllipse, start: float, sweep: float) -> None:
    found = ellipse_through(_points(ellipse, start + np.linspace(0.0, sweep, 40)))
    assert found is not None
    tolerance = 1e-5 * ellipse.semi_major
    assert found.centre == pytest.approx(ellipse.centre, abs=tolerance)
    assert found.semi_major == pytest.approx(ellipse.semi_major, abs=tolerance)
    assert found.semi_minor == pytest.approx(ellipse.semi_minor, abs=tolerance)
    assert abs(np.sin(found.rotation - ellipse.rotation)) < 1e-4


@given(ellipses, st.floats(-0.4, 1.0))
def test_points_beside_an_ellipse_know_how_far(ellipse: WholeEllipse, share: float) -> None:
    # Inside, up to less than the smallest radius of curvature.
    beyond = share * ellipse.semi_minor**2 / ellipse.semi_major
    at = np.linspace(-3.0, 3.0, 50)
    away, parameters = ellipse.away(_points(ellipse, at, beyond))
    assert away == pytest.approx(beyond, abs=1e-6 * ellipse.semi_major)
    assert parameters == pytest.approx(at, abs=1e-4)


def test_other_curves_are_no_ellipses() -> None:
    x = np.linspace(-3.0, 3.0, 30)
    assert ellipse_through(np.stack([x, 0.5 * x**2], 1)) is None
    assert ellipse_through(np.stack([np.sinh(x), np.cosh(x)], 1)) is None
    assert ellipse_through(np.stack([x, 2.0 * x], 1)) is None
    assert ellipse_through(np.zeros((9, 2))) is None
    assert ellipse_through(np.eye(5, 2)) is None


@given(ellipses, st.floats(-3.0, 3.0), st.floats(2.0, 6.2))
def test_steps_lead_to_the_nearest_ellipse(
    ellipse: WholeEllipse, start: float, sweep: float
) -> None:
    """Points that lie beside an ellipse, now outside and now inside, and a start that is off."""
    at = start + np.linspace(0.0, sweep, 80)
    neighbour = 0.002 * ellipse.semi_minor * np.cos(40.0 * (at - start))
    points = np.concatenate(
        [_points(ellipse, np.array([t]), d) for t, d in zip(at, neighbour, strict=True)]
    )
    shift = 0.02 * ellipse.semi_minor
    found = WholeEllipse(
        (ellipse.centre[0] + shift, ellipse.centre[1] - shift),
        1.02 * ellipse.semi_major,
        0.99 * ellipse.semi_minor,
        ellipse.rotation + 0.01,
    )
    for _ in range(8):
        found = refined(found, points)
    assert found.distances(points).max() < 0.004 * ellipse.semi_minor


@given(ellipses, st.floats(0.0, 1.0))
def test_lengths_and_parameters_are_each_others(ellipse: WholeEllipse, share: float) -> None:
    along = share * ellipse.around
    parameter = ellipse.parameters(np.array([along]))
    assert ellipse.lengths(parameter) == pytest.approx(along, abs=1e-6 * ellipse.semi_major)
    point = ellipse.points_at(np.array([along]))
    assert np.mod(ellipse.positions(point) - along + 1.0, ellipse.around) == pytest.approx(
        1.0, abs=1e-5 * ellipse.semi_major
    )
    ahead = ellipse.points_at(np.array([along + 1e-6 * ellipse.around])) - point
    way = ahead / np.hypot(*ahead.T)
    assert (way * ellipse.tangents_at(np.array([along]))).sum() == pytest.approx(1.0, abs=1e-6)
