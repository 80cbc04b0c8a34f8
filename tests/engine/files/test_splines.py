from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from gaussiancad_core.files.splines import Spline, spline_curves
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import Chain, LineSegment

KAPPA = 0.5522847498307936


def _of_beziers(beziers: list[np.ndarray]) -> Spline:
    """The cubic spline of Bézier curves that join, as exporters write it: knots three at a time."""
    control = np.concatenate([beziers[0][:1], *(bezier[1:] for bezier in beziers)])
    knots = np.repeat(np.arange(len(beziers) + 1.0), 3)
    return Spline(control, np.concatenate([knots[:1], knots, knots[-1:]]), 3)


def _line(*ends: tuple[float, float]) -> np.ndarray:
    start, end = np.array(ends)
    return start + np.linspace(0.0, 1.0, 4)[:, None] * (end - start)


def _arc(centre: tuple[float, float], radius: float, start: float, sweep: float) -> np.ndarray:
    handle = 4.0 / 3.0 * np.tan(sweep / 4.0) * radius
    angles = np.array([start, start + sweep])
    out = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    across = np.stack([-out[:, 1], out[:, 0]], axis=1)
    ends = np.array(centre) + radius * out
    return np.array([ends[0], ends[0] + handle * across[0], ends[1] - handle * across[1], ends[1]])


def _slot(radius: float, half: float, quarters: int, begins: int) -> list[np.ndarray]:
    """The pieces of a slot about the origin, from a straight or a round one on."""
    step = np.pi / quarters
    right = [_arc((half, 0), radius, -np.pi / 2 + n * step, step) for n in range(quarters)]
    left = [_arc((-half, 0), radius, np.pi / 2 + n * step, step) for n in range(quarters)]
    above, below = ((half, radius), (-half, radius)), ((-half, -radius), (half, -radius))
    pieces = [*right, _line(*above), *left, _line(*below)]
    return pieces[begins:] + pieces[:begins]


@pytest.mark.parametrize("quarters", [2, 3, 4])
@pytest.mark.parametrize("begins", [0, 1, 2])
def test_a_slot_is_two_lines_and_two_half_circles(quarters: int, begins: int) -> None:
    curves = spline_curves(_of_beziers(_slot(7.0, 15.0, quarters, begins)))
    arcs = [curve for curve in curves if isinstance(curve, CircularArc)]
    lines = [curve for curve in curves if isinstance(curve, LineSegment)]
    assert len(curves) == 4
    assert {round(arc.centre[0], 9) for arc in arcs} == {-15.0, 15.0}
    for arc in arcs:
        assert arc.radius == pytest.approx(7.0, abs=1e-9)
        assert arc.sweep == pytest.approx(np.pi)
    assert sorted(line.length for line in lines) == pytest.approx([30.0, 30.0])


def test_a_straight_piece_in_which_a_spline_begins_is_one() -> None:
    pieces = _slot(7.0, 15.0, 2, 0)
    halves = [_line((-0.0, -7.0), (15.0, -7.0)), _line((-15.0, -7.0), (0.0, -7.0))]
    curves = spline_curves(_of_beziers([halves[0], *pieces[:-1], halves[1]]))
    assert len(curves) == 4


def test_corners_are_kept() -> None:
    corners = [(0.0, 0.0), (40.0, 0.0), (40.0, 20.0), (0.0, 0.0)]
    curves = spline_curves(_of_beziers([_line(*ends) for ends in pairwise(corners)]))
    assert [type(curve) for curve in curves] == [LineSegment] * 3
    polyline = Spline(np.array(corners), np.array([0.0, 0, 1, 2, 3, 3]), 1)
    assert spline_curves(polyline) == curves


def test_a_rational_circle_is_exact() -> None:
    half = np.sqrt(0.5)
    control = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)])
    circle = Spline(
        30.0 * np.concatenate([control, control[:1]]),
        np.array([0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], float),
        2,
        np.array([1, half, 1, half, 1, half, 1, half, 1]),
    )
    (curve,) = spline_curves(circle)
    assert isinstance(curve, CircularArc)
    assert curve.is_closed
    assert curve.radius == pytest.approx(30.0, abs=1e-9)


@pytest.mark.parametrize("count", [12, 40, 100])
def test_a_free_curve_is_one_chain(count: int) -> None:
    """However many polynomials it is written in, and though each is nearly an arc."""
    turns = np.linspace(0.0, 2.0 * np.pi, count + 1)
    radii = 30.0 + 4.0 * np.sin(3.0 * turns)
    points = np.stack([radii * np.cos(turns), radii * np.sin(turns)], axis=1)
    slopes = 12.0 * np.cos(3.0 * turns)
    ways = np.stack(
        [
            slopes * np.cos(turns) - radii * np.sin(turns),
            slopes * np.sin(turns) + radii * np.cos(turns),
        ],
        axis=1,
    )
    third = ways * (turns[1] / 3.0)
    beziers = [
        np.array([points[n], points[n] + third[n], points[n + 1] - third[n + 1], points[n + 1]])
        for n in range(count)
    ]
    (curve,) = spline_curves(_of_beziers(beziers))
    assert isinstance(curve, Chain)
    assert curve.is_closed
    assert np.hypot(*np.diff(curve.points, axis=0).T).sum() == pytest.approx(
        np.hypot(*ways.T)[:-1].mean() * 2.0 * np.pi, rel=1e-2
    )


def test_the_chain_lies_on_the_curve() -> None:
    bezier = np.array([(0.0, 0.0), (10.0, 30.0), (30.0, -20.0), (40.0, 10.0)])
    (curve,) = spline_curves(_of_beziers([bezier]))
    assert isinstance(curve, Chain)
    t = np.linspace(0.0, 1.0, 1001)[:, None]
    powers = [(1, 0), (3, 1), (3, 2), (1, 3)]
    shares = np.hstack([count * (1.0 - t) ** (3 - k) * t**k for count, k in powers])
    exact = shares @ bezier
    assert curve.distances(exact).max() < 40.0 * 1e-5


def test_what_is_no_spline_is_refused() -> None:
    good = _of_beziers([_line((0.0, 0.0), (1.0, 0.0))])
    assert len(spline_curves(good)) == 1
    assert spline_curves(replace(good, control=np.zeros((4, 2)))) == []
    bad_point = good.control.copy()
    bad_point[1, 0] = np.nan
    for broken in (
        replace(good, control=bad_point),
        replace(good, knots=good.knots[::-1]),
        replace(good, knots=good.knots[:-1]),
        replace(good, knots=np.zeros(8)),
        replace(good, degree=0),
        replace(good, weights=np.array([1.0, -1.0, 1.0, 1.0])),
    ):
        with pytest.raises(ValueError, match="spline"):
            spline_curves(broken)
