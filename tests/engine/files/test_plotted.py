import numpy as np
import pytest

from gaussiancad_core.files.plotted import lines_and_arcs
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment


def test_plotted_polygons_hold_lines_and_arcs() -> None:
    """A slot: two half circles of 18 pieces each, joined by lines, and a corner."""
    right = (400, 100) + 50 * _turning(-np.pi / 2, np.pi / 2, 19)
    left = (100, 100) + 50 * _turning(np.pi / 2, 3 * np.pi / 2, 19)
    points = np.round(np.concatenate([right, left, right[:1], [[400, 0]]]), 1)
    curves = lines_and_arcs(points, 0.1)
    assert [type(curve) for curve in curves] == [
        CircularArc,
        LineSegment,
        CircularArc,
        LineSegment,
        LineSegment,
    ]
    for curve, centre in ((curves[0], (400, 100)), (curves[2], (100, 100))):
        assert np.allclose(curve.centre, centre, atol=0.05)
        assert curve.radius == pytest.approx(50, abs=0.05)
        assert curve.sweep == pytest.approx(np.pi, abs=0.01)


@pytest.mark.parametrize("corners", [3, 4, 6, 8, 12])
def test_polygons_stay_polygons(corners: int) -> None:
    points = 100 * _turning(0, 2 * np.pi, corners + 1)
    assert [type(curve) for curve in lines_and_arcs(points, 0.0)] == [LineSegment] * corners


def test_arcs_of_different_radius_are_told_apart() -> None:
    small = 60 * _turning(0, np.pi / 2, 15)
    large = (0, -60) + 120 * _turning(np.pi / 2, 0.9 * np.pi, 30)
    first, second = lines_and_arcs(np.concatenate([small, large[1:]]), 0.0)
    assert (first.radius, second.radius) == pytest.approx((60, 120), rel=0.02)


def _turning(start: float, end: float, count: int) -> np.ndarray:
    t = np.linspace(start, end, count)
    return np.stack([np.cos(t), np.sin(t)], 1)


@pytest.mark.parametrize(("step", "share"), [(0.0, 1.0), (0.1, 0.99), (0.2778, 0.97)])
def test_an_arc_is_one_however_its_points_are_rounded(step: float, share: float) -> None:
    lot = np.random.default_rng(0)
    drawn = [(lot.uniform(12, 120), lot.uniform(0.8, 2 * np.pi)) for _ in range(400)]
    whole = [_is_whole(*item, lot.uniform(0.0, 6.0), step) for item in drawn]
    # Rounding may part the end of one from the rest.
    assert np.mean(whole) >= share


def _is_whole(radius: float, sweep: float, start: float, step: float) -> bool:
    """Whether an arc whose points were rounded comes back as one, of its radius and sweep."""
    count = max(9, int(sweep * max(radius / 2.5, 24 / np.pi)))
    points = (300, 200) + radius * _turning(start, start + sweep, count)
    if step:
        points = np.round(points / step) * step
    curve, *others = lines_and_arcs(points, step)
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
    first, arc, last = lines_and_arcs(points, 0.2778)
    assert isinstance(first, LineSegment) and isinstance(last, LineSegment)
    assert isinstance(arc, CircularArc)
    assert arc.radius == pytest.approx(13.3, abs=0.3)


def test_an_arc_of_few_chords_on_a_coarse_grid_is_one_by_the_step_of_its_file() -> None:
    points = np.round((300, 200) + 40 * _turning(0.2, 1.5, 8))
    (arc,) = lines_and_arcs(points, 1.0)
    assert isinstance(arc, CircularArc)
    assert arc.radius == pytest.approx(40, abs=3)
    assert len(lines_and_arcs(points, 0.0)) > 1
