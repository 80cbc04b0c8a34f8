import numpy as np
import pytest

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.lines.coverage import StrokeIndex, uncovered
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.views import Linetype, Segment

V, H = Linetype.VISIBLE, Linetype.HIDDEN
PRECISION = Precision(1e-4, 5e-4, 1e-2, 2e-2)


def _ellipse(count: int, turn: float = 0.0, kind: Linetype = H) -> Polyline:
    angles = turn + np.linspace(0.0, 2.0 * np.pi, count + 1)
    points = np.stack([30.0 * np.cos(angles), 18.0 * np.sin(angles)], axis=1)
    return Polyline((*map(tuple, points[:-1].tolist()), tuple(points[0].tolist())), kind)


def test_the_same_curve_sampled_otherwise_covers_all_of_it() -> None:
    assert uncovered(_ellipse(400), [_ellipse(530, 0.3, V)], PRECISION) == []


def test_half_a_curve_leaves_the_other_half() -> None:
    whole = _ellipse(400)
    half = _ellipse(530).part(0.0, _ellipse(530).length / 2.0)
    (left,) = uncovered(whole, [half], PRECISION)
    assert left.length == pytest.approx(whole.length / 2.0, abs=0.05)
    assert min(y for _, y in left.points) == pytest.approx(-18.0, abs=1e-3)
    assert max(y for _, y in left.points) < 0.02


def test_a_tangent_does_not_cut_a_curve() -> None:
    tangents = [
        Segment((-30.0, 18.0), (30.0, 18.0), V),
        Segment((0.0, -18.0), (30.0, -18.0), V),
    ]
    whole = _ellipse(400)
    assert uncovered(whole, tangents, PRECISION) == [whole]


def test_a_crossing_line_does_not_cut_a_curve() -> None:
    whole = _ellipse(400)
    assert uncovered(whole, [Segment((-40.0, 3.0), (40.0, 5.0), V)], PRECISION) == [whole]


def test_a_straight_chain_over_a_line_loses_what_they_share() -> None:
    chain = Polyline(((0.0, 0.0), (4.0, 0.001), (9.0, 0.0), (10.0, 0.0)), H)
    (left,) = uncovered(chain, [Segment((-1.0, 0.0), (6.0, 0.0), V)], PRECISION)
    assert left.points[0] == pytest.approx((6.0, 0.0), abs=0.02)
    assert left.points[-1] == (10.0, 0.0)


def test_an_index_finds_what_is_near_and_grows() -> None:
    strokes = [Segment((float(k), 0.0), (float(k), 1.0), V) for k in range(40)]
    index = StrokeIndex(strokes[:20])
    for stroke in strokes[20:]:
        index.add(stroke)
    probe = Segment((29.5, 0.5), (31.2, 0.5), V)
    assert index.near(probe, 0.0) == strokes[30:32]
    assert index.near(probe, 0.6) == strokes[29:32]
