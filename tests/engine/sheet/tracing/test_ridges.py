"""Points on centre lines to a twentieth of a pixel."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.sheet.tracing.ridges import RidgePoints, ridge_points

Sketch = Any
"""The class that the fixture gives."""


def _inner(ridges: RidgePoints) -> np.ndarray:
    """Which points are far from the borders, where profiles are cut."""
    return np.all((ridges.points > 16) & (ridges.points < 104), axis=1)


@settings(max_examples=25, deadline=None)
@given(
    st.floats(0.0, np.pi), st.floats(-2.0, 2.0), st.floats(1.0, 8.0), st.sampled_from([0.5, 1.0])
)
def test_points_lie_on_the_line(
    sketch: Sketch, angle: float, shift: float, width: float, share: float
) -> None:
    way = np.array([np.cos(angle), np.sin(angle)])
    normal = np.array([-way[1], way[0]])
    middle = 60.0 + shift * normal
    drawn = sketch(121, 121).line(tuple(middle - 100 * way), tuple(middle + 100 * way), width)
    ridges = ridge_points(np.float32(share) * drawn.weight, width)
    inner = _inner(ridges)
    assert np.abs((ridges.points[inner] - middle) @ normal).max() < 0.05
    assert np.abs(ridges.tangents[inner] @ normal).max() < np.sin(np.radians(1.0))
    # Every px of the line has a point; most have two, both sides of it.
    steep = int(abs(way[1]) > abs(way[0]))
    columns, counts = np.unique(np.nonzero(ridges.index >= 0)[1 - steep], return_counts=True)
    assert set(range(20, 100)) <= set(columns[counts > 0])
    assert counts.max() <= 4
    assert counts.mean() <= 3.0


@pytest.mark.parametrize(("width", "radius"), [(1.0, 20.0), (3.0, 35.0), (8.0, 60.0)])
def test_points_lie_beside_a_circle_by_what_its_bend_explains(
    sketch: Sketch, width: float, radius: float
) -> None:
    """Smoothing draws a bent stroke inwards by the Gaussian's variance over twice the radius."""
    centre = (80.3, 79.6)
    ridges = ridge_points(sketch(160, 160).arc(centre, radius, width).weight, width)
    offset = ridges.points - np.array(centre)
    distance = np.hypot(*offset.T)
    shift = -(max(1.1, 0.42 * width) ** 2) / (2 * radius)
    assert np.abs(distance - radius - shift).max() < 0.05
    radial = np.abs((ridges.tangents * offset).sum(1)) / distance
    assert radial.max() < np.sin(np.radians(1.0))
    angles = np.sort(np.arctan2(offset[:, 1], offset[:, 0]))
    assert np.diff(angles).max() * radius < 1.6


def test_the_index_finds_the_points(sketch: Sketch) -> None:
    drawn = sketch().line((20, 30), (180, 90)).arc((100, 90), 40)
    ridges = ridge_points(drawn.weight, 3.0)
    rows, columns = np.nonzero(ridges.index >= 0)
    item = ridges.index[rows, columns]
    assert np.array_equal(np.sort(item), np.arange(len(ridges.points)))
    # Hardly beyond the pixel, along the more upright of its axes.
    assert np.abs(ridges.points[item] - np.stack([columns, rows], axis=1)).max() < 0.7
    assert np.hypot(*ridges.tangents.T) == pytest.approx(1.0)


@pytest.mark.parametrize("gap", [4.0, 7.0])
def test_parallel_lines_have_points_of_their_own(sketch: Sketch, gap: float) -> None:
    drawn = sketch(121, 121).line((-9, 40.2), (130, 40.2), 2)
    ridges = ridge_points(drawn.line((-9, 40.2 + gap), (130, 40.2 + gap), 2).weight, 2.0)
    across = ridges.points[_inner(ridges)][:, 1] - 40.2
    assert np.abs(across - gap * (across > gap / 2)).max() < 0.3


def test_blank_paper_and_flat_ink_have_none() -> None:
    for weight in (np.zeros((40, 60), np.float32), np.ones((40, 60), np.float32)):
        ridges = ridge_points(weight, 3.0)
        assert ridges.points.shape == ridges.tangents.shape == (0, 2)
        assert (ridges.index == -1).all()
