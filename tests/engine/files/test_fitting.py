import numpy as np
import pytest

from gaussiancad_core.files.fitting import circle_through, circles_through, curve_along, thinned
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment


def _ellipse(a: float, b: float, tilt: float, t: np.ndarray) -> np.ndarray:
    local = np.stack([a * np.cos(t), b * np.sin(t)], 1)
    c, s = np.cos(tilt), np.sin(tilt)
    return local @ np.array([[c, s], [-s, c]]) + (500, 400)


@pytest.mark.parametrize("sweep", [0.2, -1.0, 3.0, 2 * np.pi])
def test_points_on_a_circle(sweep: float) -> None:
    t = np.linspace(0.5, 0.5 + sweep, 60)
    curve = curve_along(_ellipse(300, 300, 0, t))
    assert isinstance(curve, CircularArc)
    assert np.allclose(curve.centre, (500, 400), atol=1e-6)
    assert curve.radius == pytest.approx(300)
    assert curve.sweep == pytest.approx(abs(sweep))


def test_points_on_an_ellipse() -> None:
    curve = curve_along(_ellipse(300, 120, 0.4, np.linspace(0.2, 2.8, 80)))
    assert isinstance(curve, EllipticArc)
    assert np.allclose(curve.centre, (500, 400), atol=1e-5)
    assert curve.semi_major == pytest.approx(300)
    assert curve.semi_minor == pytest.approx(120)
    assert curve.sweep == pytest.approx(2.6)


def test_points_on_a_line() -> None:
    t = np.linspace(0, 1, 20)[:, None]
    assert curve_along(t * (300.0, 100.0)) == LineSegment((0.0, 0.0), (300.0, 100.0))
    assert curve_along(np.array([(0.0, 0.0), (1.0, 2.0)])) == LineSegment((0.0, 0.0), (1.0, 2.0))


def test_polygons_and_waves_are_neither() -> None:
    hexagon = _ellipse(100, 100, 0, np.linspace(0, 2 * np.pi, 7))
    assert isinstance(curve_along(hexagon), Chain)
    x = np.linspace(0, 500, 100)
    assert isinstance(curve_along(np.stack([x, 30 * np.sin(x / 50)], 1)), Chain)
    hyperbola = np.stack([x + 10, 1000 / (x + 10)], 1)
    assert isinstance(curve_along(hyperbola), Chain)


def test_chains_have_no_more_corners_than_their_flatness_needs() -> None:
    x = np.linspace(0, 40, 2000)
    chain = curve_along(np.stack([x, 5 * np.sin(x / 5)], 1))
    assert isinstance(chain, Chain)
    few = thinned(chain)
    assert isinstance(few, Chain)
    assert len(few.points) < 100
    assert few.distances(np.array(chain.points)).max() < 0.02
    assert (few.points[0], few.points[-1]) == (chain.points[0], chain.points[-1])
    assert thinned(few) == few


def test_circles_through_many_points_at_once_are_those_one_by_one() -> None:
    rng = np.random.default_rng(3)
    points = rng.normal(0.0, 30.0, (40, 7, 2))
    points[0] = np.linspace((0, 0), (70, 30), 7)
    points[1] = (5.0, 6.0)
    centres, radii = circles_through(points)
    one_by_one = [circle_through(item) for item in points]
    assert np.allclose(centres, [centre for centre, _ in one_by_one])
    assert np.allclose(radii, [radius for _, radius in one_by_one])
