"""Points on centre lines to a twentieth of a pixel."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.sheet.tracing.ridges import RidgePoints, ridge_points

Sketch = Any
"""The class that the fixture gives."""

WIDTHS = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.5, 8.0]


def _within(ridges: RidgePoints, low: float, high: float) -> np.ndarray:
    return np.all((ridges.points > low) & (ridges.points < high), axis=1)


@settings(max_examples=60, deadline=None)
@given(st.floats(0.0, np.pi), st.floats(-2.0, 2.0), st.floats(1.0, 8.0))
def test_points_lie_on_the_line(sketch: Sketch, angle: float, shift: float, width: float) -> None:
    way, normal = (
        np.array([np.cos(angle), np.sin(angle)]),
        np.array([-np.sin(angle), np.cos(angle)]),
    )
    middle = 60.0 + shift * normal
    drawn = sketch(121, 121).line(tuple(middle - 100 * way), tuple(middle + 100 * way), width)
    ridges = ridge_points(drawn.weight, width)
    # Where the line leaves the sheet its profile is cut.
    inner = _within(ridges, 16, 104)
    assert np.abs((ridges.points[inner] - middle) @ normal).max() < 0.04
    assert np.abs(ridges.tangents[inner] @ normal).max() < np.sin(np.radians(1.0))
    # Every px of the line has a point; most have two, both sides of it.
    steep = int(abs(way[1]) > abs(way[0]))
    columns, counts = np.unique(np.nonzero(ridges.index >= 0)[1 - steep], return_counts=True)
    assert set(range(20, 100)) <= set(columns[counts > 0])
    assert counts.max() <= 4
    assert counts.mean() <= 3.0


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("radius", [20.0, 35.0, 60.0])
def test_points_lie_beside_a_circle_by_what_its_bend_explains(
    sketch: Sketch, width: float, radius: float
) -> None:
    """Smoothing draws a bent stroke inwards by the Gaussian's variance over twice the radius."""
    centre = (80.3, 79.6)
    ridges = ridge_points(sketch(160, 160).arc(centre, radius, width).weight, width)
    offset = ridges.points - np.array(centre)
    distance = np.hypot(*offset.T)
    sigma = max(1.1, 0.42 * width)
    shift = -(sigma**2) / (2 * radius)
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
    neighbour = ridges.points[item] - np.stack([columns, rows], axis=1)
    # Hardly beyond the pixel, along the more upright of its axes.
    assert np.abs(neighbour).max() < 0.7
    assert np.hypot(*ridges.tangents.T) == pytest.approx(1.0)


@pytest.mark.parametrize("share", [0.3, 0.5, 1.0])
def test_pale_lines_keep_their_place(sketch: Sketch, share: float) -> None:
    drawn = sketch(121, 121).line((-50, 20), (170, 90), 2.0)
    ridges = ridge_points(np.float32(share) * drawn.weight, 2.0)
    way = np.array([220.0, 70.0]) / np.hypot(220, 70)
    inner = _within(ridges, 10, 110)
    across = (ridges.points[inner] - (-50, 20)) @ np.array([-way[1], way[0]])
    assert np.ptp(ridges.points[inner][:, 0]) > 95
    assert np.abs(across).max() < 0.05


@pytest.mark.parametrize("other", [1.0, 1.5, 3.0, 4.5, 6.0])
def test_strokes_up_to_twice_as_wide_are_found_as_well(sketch: Sketch, other: float) -> None:
    """A sheet has a mean width; its wide and its narrow lines differ by two."""
    ridges = ridge_points(sketch(121, 121).line((-9, 40.3), (130, 40.3), other).weight, 3.0)
    inner = _within(ridges, 10, 110)
    assert len(np.unique(np.rint(ridges.points[inner][:, 0]))) == 99
    assert np.abs(ridges.points[inner][:, 1] - 40.3).max() < 0.05


@pytest.mark.parametrize("gap", [4.0, 5.0, 7.0])
def test_parallel_lines_stay_apart(sketch: Sketch, gap: float) -> None:
    """Each has points of its own, drawn a little towards the other."""
    drawn = (
        sketch(121, 121)
        .line((-9, 40.2), (130, 40.2), 2)
        .line((-9, 40.2 + gap), (130, 40.2 + gap), 2)
    )
    ridges = ridge_points(drawn.weight, 2.0)
    inner = _within(ridges, 10, 110)
    across = ridges.points[inner][:, 1] - 40.2
    first = across < gap / 2
    assert len(np.unique(np.rint(ridges.points[inner][first, 0]))) == 99
    assert len(np.unique(np.rint(ridges.points[inner][~first, 0]))) == 99
    assert np.abs(across[first]).max() < 0.3
    assert np.abs(across[~first] - gap).max() < 0.3


def test_blank_paper_and_flat_ink_have_none() -> None:
    assert len(ridge_points(np.zeros((40, 60), np.float32), 3.0).points) == 0
    full = ridge_points(np.ones((40, 60), np.float32), 3.0)
    assert full.points.shape == (0, 2)
    assert full.tangents.shape == (0, 2)
    assert (full.index == -1).all()
