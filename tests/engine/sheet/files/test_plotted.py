import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.files.plotted import grid_step, lines_and_arcs
from gaussiancad_core.sheet.files.vectors import CircularArc, Line


def test_plotted_polygons_hold_lines_and_arcs() -> None:
    """A slot: two half circles of 18 pieces each, joined by lines, and a corner."""
    right = (400, 100) + 50 * _turning(-np.pi / 2, np.pi / 2, 19)
    left = (100, 100) + 50 * _turning(np.pi / 2, 3 * np.pi / 2, 19)
    points = np.round(np.concatenate([right, left, right[:1], [[400, 0]]]), 1)
    curves = lines_and_arcs(points)
    assert [type(curve) for curve in curves] == [CircularArc, Line, CircularArc, Line, Line]
    for curve, centre in ((curves[0], (400, 100)), (curves[2], (100, 100))):
        assert np.allclose(curve.centre, centre, atol=0.05)
        assert curve.radius == pytest.approx(50, abs=0.05)
        assert curve.sweep == pytest.approx(np.pi, abs=0.01)


@pytest.mark.parametrize("corners", [3, 4, 6, 8, 12])
def test_polygons_stay_polygons(corners: int) -> None:
    points = 100 * _turning(0, 2 * np.pi, corners + 1)
    assert [type(curve) for curve in lines_and_arcs(points)] == [Line] * corners


def test_arcs_of_different_radius_are_told_apart() -> None:
    small = 60 * _turning(0, np.pi / 2, 15)
    large = (0, -60) + 120 * _turning(np.pi / 2, 0.9 * np.pi, 30)
    first, second = lines_and_arcs(np.concatenate([small, large[1:]]))
    assert (first.radius, second.radius) == pytest.approx((60, 120), rel=0.02)


def _turning(start: float, end: float, count: int) -> np.ndarray:
    t = np.linspace(start, end, count)
    return np.stack([np.cos(t), np.sin(t)], 1)


@pytest.mark.parametrize(("step", "share"), [(0.0, 1.0), (0.1, 0.99), (0.2778, 0.97)])
def test_an_arc_is_one_however_its_points_are_rounded(step: float, share: float) -> None:
    lot = np.random.default_rng(0)
    drawn = [(lot.uniform(12, 120), lot.uniform(0.8, 2 * np.pi)) for _ in range(400)]
    whole = [_is_whole(*own, lot.uniform(0.0, 6.0), step) for own in drawn]
    # Rounding may part the end of one from the rest.
    assert np.mean(whole) >= share


def _is_whole(radius: float, sweep: float, start: float, step: float) -> bool:
    """Whether an arc whose points were rounded comes back as one, of its radius and sweep."""
    count = max(9, int(sweep * max(radius / 2.5, 24 / np.pi)))
    points = (300, 200) + radius * _turning(start, start + sweep, count)
    if step:
        points = np.round(points / step) * step
    curve, *others = lines_and_arcs(points)
    return (
        not others
        and isinstance(curve, CircularArc)
        and curve.radius == pytest.approx(radius, rel=0.12, abs=1.5 * step)
        and curve.sweep == pytest.approx(sweep, rel=0.15, abs=2 * step / radius)
    )


def test_a_rounding_between_lines_is_an_arc_from_one_to_the_other() -> None:
    corner = (200, 100) + 13.3 * _turning(-np.pi / 2, 0.0, 10)
    points = np.concatenate([[[100.0, 86.7]], corner, [[213.3, 200.0]]])
    points = np.round(points / 0.2778) * 0.2778
    first, arc, last = lines_and_arcs(points)
    assert isinstance(first, Line) and isinstance(last, Line)
    assert isinstance(arc, CircularArc)
    assert arc.radius == pytest.approx(13.3, abs=0.3)


@given(step=st.floats(0.05, 0.39), seed=st.integers(0, 2**32 - 1))
def test_a_grid_is_told_though_no_two_lines_are_one_step_apart(step: float, seed: int) -> None:
    lot = np.random.default_rng(seed)
    steps = np.cumsum(lot.integers(2, 9, size=(40, 2)), axis=0)
    found = grid_step(steps * step)
    # The grid, or one whose lines all of its lines are on.
    assert found > 0.0
    assert abs(found / step - round(found / step)) < 0.01


@given(seed=st.integers(0, 2**32 - 1))
def test_places_that_are_rounded_to_nothing_have_no_grid(seed: int) -> None:
    lot = np.random.default_rng(seed)
    assert grid_step(np.cumsum(lot.uniform(0.3, 3.0, size=(60, 2)), axis=0)) < 0.05
