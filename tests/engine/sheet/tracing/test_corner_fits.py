"""Which arcs are corners."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sheet.tracing.corner_fits import is_corner

_NOISE = 0.05


def _fitted(points: np.ndarray) -> Circle:
    """The circle through points, by least squares of the algebraic distance."""
    middle = points.mean(0)
    item = points - middle
    left = np.column_stack([2.0 * item, np.ones(len(item))])
    x, y, rest = np.linalg.lstsq(left, (item**2).sum(1), rcond=None)[0]
    return Circle((x + middle[0], y + middle[1]), float(np.sqrt(rest + x * x + y * y)))


def _turned(points: np.ndarray, angle: float) -> np.ndarray:
    cosine, sine = np.cos(angle), np.sin(angle)
    return points @ np.array([[cosine, sine], [-sine, cosine]]) + 100.0


@given(
    st.integers(15, 40),
    st.integers(15, 40),
    st.floats(0.3, 0.6),
    st.floats(0.0, 6.2),
    st.integers(0, 9),
)
def test_two_lines_are_a_corner(one: int, other: int, bend: float, turn: float, seed: int) -> None:
    before = np.column_stack([np.arange(-one, 0.0), np.zeros(one)])
    after = np.arange(0.0, other)[:, None] * np.array([np.cos(bend), np.sin(bend)])
    points = np.concatenate([before, after])
    points += np.random.default_rng(seed).normal(0.0, _NOISE, points.shape)
    points = _turned(points, turn)
    assert is_corner(_fitted(points), points)


@given(st.floats(5.0, 200.0), st.floats(0.4, 2.0), st.floats(0.0, 6.2), st.integers(0, 9))
def test_an_arc_is_none(radius: float, sweep: float, turn: float, seed: int) -> None:
    # Flatter ones are no arcs to the reader.
    assume(radius * (1.0 - np.cos(sweep / 2.0)) > 0.8)
    count = max(12, int(radius * sweep))
    angles = turn + np.linspace(0.0, sweep, count)
    points = 100.0 + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    points += np.random.default_rng(seed).normal(0.0, _NOISE, points.shape)
    assert not is_corner(Circle((100.0, 100.0), radius), points)


@pytest.mark.parametrize("count", [3, 11])
def test_few_points_tell_nothing(count: int) -> None:
    points = np.random.default_rng(1).normal(0.0, 3.0, (count, 2))
    assert not is_corner(Circle((0.0, 0.0), 5.0), points)


@given(
    st.tuples(st.integers(12, 16), st.integers(10, 13), st.integers(12, 16)),
    st.floats(0.7, 0.85),
    st.floats(0.0, 6.2),
    st.integers(0, 9),
)
def test_the_flank_of_a_groove_between_two_lines_is_no_arc(
    lengths: tuple[int, int, int], bend: float, turn: float, seed: int
) -> None:
    one, flank, other = lengths
    before = np.column_stack([np.arange(-one, 0.0), np.zeros(one)])
    way = np.array([np.cos(bend), np.sin(bend)])
    middle = np.arange(0.0, flank)[:, None] * way
    last = np.array([np.cos(2.0 * bend), np.sin(2.0 * bend)])
    after = flank * way + np.arange(0.0, other)[:, None] * last
    points = np.concatenate([before, middle, after])
    points += np.random.default_rng(seed).normal(0.0, _NOISE, points.shape)
    points = _turned(points, turn)
    assert is_corner(_fitted(points), points)
