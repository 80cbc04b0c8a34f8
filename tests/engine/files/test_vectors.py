import numpy as np
import pytest

from gaussiancad_core.files.vectors import (
    Chain,
    CircularArc,
    EllipticArc,
    Line,
    bounds,
)

TURN = 2 * np.pi


@pytest.mark.parametrize(
    ("curve", "length"),
    [
        (Line((0, 0), (30, 40)), 50.0),
        (CircularArc((5, 5), 10, 1.0, 2.0), 20.0),
        (EllipticArc((5, 5), (6, 8), 1.0, 1.0, 2.0), 20.0),
        (Chain(((0, 0), (3, 4), (3, 14))), 15.0),
    ],
)
def test_samples_follow_the_curve(curve: object, length: float) -> None:
    assert curve.length == pytest.approx(length, rel=1e-3)
    points = curve.sample(0.5)
    steps = np.hypot(*np.diff(points, axis=0).T)
    assert steps.max() <= 0.5 + 1e-9
    assert steps.sum() == pytest.approx(length, rel=1e-3)


def test_bounds_hold_the_extremes_of_arcs() -> None:
    assert bounds([]) is None
    assert bounds([CircularArc((10, 20), 5, 0, TURN)]) == pytest.approx((5, 15, 15, 25))
    assert bounds([CircularArc((0, 0), 10, -0.3, 0.6)]) == pytest.approx(
        (10 * np.cos(0.3), -10 * np.sin(0.3), 10, 10 * np.sin(0.3))
    )
    ellipse = EllipticArc((0, 0), (3, 4), 0.5, 0, TURN)
    sampled = ellipse.sample(1e-3)
    expected = (*sampled.min(axis=0), *sampled.max(axis=0))
    assert bounds([ellipse, Line((0, 0), (1, 1))]) == pytest.approx(expected, abs=1e-6)


def test_full_turns_are_known() -> None:
    assert CircularArc((0, 0), 1, 2.0, TURN).is_full
    assert not CircularArc((0, 0), 1, 2.0, 6.0).is_full
    assert EllipticArc((0, 0), (1, 0), 0.5, 2.0, TURN).is_full


EDGE = Line((0.0, 0.0), (50.0, 0.0))
