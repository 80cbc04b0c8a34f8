import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.files.file_curves import affine_arc, placed, polygon_curves
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve

TURN = 2 * np.pi
NUMBER = st.floats(-100, 100)


def _along(curve: Curve, count: int) -> np.ndarray:
    """(n, 2) points at equal parameters."""
    if isinstance(curve, CircularArc):
        t = curve.start_angle + np.linspace(0, curve.sweep, count)
        return curve.centre + curve.radius * np.stack([np.cos(t), np.sin(t)], 1)
    return curve.spread(count)


@settings(max_examples=60, deadline=None)
@given(
    u=st.tuples(NUMBER, NUMBER),
    v=st.tuples(NUMBER, NUMBER),
    start=st.floats(-7, 7),
    sweep=st.floats(-6.2, 6.2),
)
def test_affine_arcs_keep_their_points(u: tuple, v: tuple, start: float, sweep: float) -> None:
    u, v = np.array(u), np.array(v)
    if abs(u[0] * v[1] - u[1] * v[0]) < 1.0 or abs(sweep) < 0.1:
        return
    centre = np.array([3.0, 4.0])
    curve = affine_arc(centre, u, v, start, sweep)
    assert isinstance(curve, CircularArc | EllipticArc)
    assert 0 < curve.sweep <= TURN
    t = start + np.linspace(0, sweep, 9)[:, None]
    exact = centre + np.cos(t) * u + np.sin(t) * v
    found = _along(curve, 9)
    # A curve may be run through the other way round.
    same = min(np.abs(found - exact).max(), np.abs(found[::-1] - exact).max())
    assert same < 1e-6 * (np.abs(exact).max() + 1)


def test_circles_stay_circles() -> None:
    turned = np.array([3.0, 4.0]), np.array([-4.0, 3.0])
    curve = affine_arc(np.zeros(2), *turned, 0.0, TURN)
    assert isinstance(curve, CircularArc)
    assert curve.radius == pytest.approx(5.0)
    assert curve.is_closed
    mirrored = affine_arc(np.zeros(2), turned[0], -turned[1], 0.0, 1.0)
    assert isinstance(mirrored, CircularArc)
    assert _along(mirrored, 3)[-1] == pytest.approx([3.0, 4.0])


def test_circles_seen_edge_on_are_lines() -> None:
    u = np.array([3.0, 4.0])
    assert affine_arc(np.zeros(2), u, 0 * u, 0.0, TURN).length == pytest.approx(10.0)
    quarter = affine_arc(np.zeros(2), u, 0 * u, 0.0, np.pi / 2)
    assert isinstance(quarter, LineSegment)
    assert quarter.length == pytest.approx(5.0)


@pytest.mark.parametrize(
    "curve",
    [
        LineSegment((1, 2), (30, 40)),
        CircularArc((5, 5), 10, 1.0, 2.0),
        EllipticArc((5, 5), 10.0, 3.0, 0.9, 1.0, 2.0),
        Chain(((0, 0), (3, 4), (3, 14))),
    ],
)
def test_placed_curves_are_scaled_and_turned_over(curve: Curve) -> None:
    moved = placed(curve, 2.0, left=-1.0, top=50.0)
    expected = (curve.sample(0.01) - (-1.0, 50.0)) * (2.0, -2.0)
    points = moved.sample(0.02)
    for one, other in ((points[::7], expected), (expected[::97], points)):
        gaps = np.sqrt(((one[:, None] - other[None]) ** 2).sum(axis=2)).min(axis=1)
        assert gaps.max() < 0.02


def test_polygons_lose_pieces_of_no_length() -> None:
    lines = polygon_curves(np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (1.0, 2.0)]))
    assert lines == [LineSegment((0.0, 0.0), (1.0, 0.0)), LineSegment((1.0, 0.0), (1.0, 2.0))]
