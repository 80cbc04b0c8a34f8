"""Arrowheads among the strokes of a file."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull

from gaussiancad_core.files.vectors import StrokeKind, VectorStroke
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.structure import arrowheads as module
from gaussiancad_core.structure.arrowheads import arrowheads

_PLACE = st.tuples(st.floats(100.0, 900.0), st.floats(100.0, 900.0))
_ANGLE = st.floats(0.0, 6.28)


def _corners(tip: tuple[float, float], angle: float, length: float, width: float) -> np.ndarray:
    way = np.array([np.cos(angle), np.sin(angle)])
    base = np.array(tip) - length * way
    across = width / 2.0 * np.array([-way[1], way[0]])
    return np.array([tip, base + across, base - across])


def _filled(corners: np.ndarray) -> list[VectorStroke]:
    points = tuple(map(tuple, [*corners, corners[0]]))
    return [VectorStroke(Chain(points), None, kind=StrokeKind.FILL)]


def _outlined(corners: np.ndarray) -> list[VectorStroke]:
    pairs = zip(corners, np.roll(corners, -1, axis=0), strict=True)
    return [VectorStroke(LineSegment(tuple(one), tuple(two)), 1.0) for one, two in pairs]


def _drawn(corners: np.ndarray) -> list[VectorStroke]:
    """As a printer's driver has it: sides twice, and a stroke along the middle."""
    middle = (corners[1] + corners[2]) / 2.0
    extra = VectorStroke(LineSegment(tuple(middle), tuple(corners[0])), 1.0)
    return [*_outlined(corners), extra, *_outlined(corners)]


@pytest.mark.parametrize("draw", [_filled, _outlined, _drawn])
@given(tip=_PLACE, angle=_ANGLE, length=st.floats(8.0, 60.0), slim=st.floats(0.15, 0.6))
def test_a_slim_triangle_is_a_head_that_points_where_its_sides_meet(
    draw: object, tip: tuple[float, float], angle: float, length: float, slim: float
) -> None:
    (head,) = arrowheads(draw(_corners(tip, angle, length, slim * length)))
    assert head.tip == pytest.approx(tip, abs=1e-6)
    assert head.way == pytest.approx((np.cos(angle), np.sin(angle)), abs=1e-6)
    assert head.length == pytest.approx(length)


def test_a_swept_head_is_one_and_other_small_shapes_are_none() -> None:
    tip, left, right = _corners((300.0, 300.0), 0.3, 25.0, 9.0)
    notch = tip + 0.8 * ((left + right) / 2.0 - tip)
    assert len(arrowheads(_filled(np.array([tip, left, notch, right])))) == 1
    square = np.array([(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)])
    turns = np.linspace(0.0, 6.28, 24, endpoint=False)
    dot = 300.0 + 5.0 * np.stack([np.cos(turns), np.sin(turns)], 1)
    even = np.array([(0.0, 0.0), (20.0, 0.0), (10.0, 17.3)])
    right_angled = np.array([(0.0, 0.0), (30.0, 0.0), (0.0, 12.0)])
    for corners in (square, dot, even, right_angled, 20.0 * _corners((9.0, 9.0), 0.0, 25.0, 9.0)):
        assert arrowheads([*_filled(corners), *_outlined(corners)]) == ()


def test_two_heads_tip_to_tip_are_two() -> None:
    tips = [_corners((300.0, 300.0), angle, 20.0, 7.0) for angle in (0.0, np.pi)]
    found = arrowheads([stroke for corners in tips for stroke in _filled(corners)])
    assert sorted(round(head.way[0]) for head in found) == [-1, 1]


def test_no_outline_of_three_corners_is_passed_over() -> None:
    random = np.random.default_rng(7)
    for _ in range(2000):
        corners = random.uniform(0.0, 40.0, (3, 2))
        size = float(np.ptp(corners, axis=0).max())
        near = 0.06 * size
        # Rounded corners, and points within the outline.
        ends = corners[random.integers(0, 3, 12)] + random.uniform(-0.7, 0.7, (12, 2)) * near
        inner = random.dirichlet((1.0, 1.0, 1.0), 5) @ corners
        points = np.concatenate([corners, ends, inner])
        hull = points[ConvexHull(points).vertices]
        if module._three(hull, near) is not None:
            assert module._may_be_triangle(points, near)
    angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    round_one = 10.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    square = np.array([[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]])
    assert not module._may_be_triangle(round_one, 1.2)
    assert not module._may_be_triangle(square, 0.6)
