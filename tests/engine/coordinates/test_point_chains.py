"""Drawn curves that are known as points."""

import itertools

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.point_chains import (
    chain_distances,
    crossings_with_chain,
    crossings_with_curves,
    single_runs,
    through_points,
)
from gaussiancad_core.geometry.whole_curves import Circle, axis_line, line_through

_POINTS = st.lists(
    st.tuples(st.integers(-200, 200), st.integers(-200, 200)),
    min_size=2,
    max_size=12,
    unique=True,
).map(lambda points: np.array(points, dtype=float) / 4.0)


def _wave(count: int = 65) -> npt.NDArray[np.float64]:
    t = np.linspace(0.0, 2.0 * np.pi, count)
    return np.stack([10.0 * t, 8.0 * np.sin(t)], axis=1)


def test_a_curve_without_turning_back_is_one_run() -> None:
    (run,) = single_runs(_wave(), 0.01)
    assert np.array(run) == pytest.approx(_wave())


def test_the_way_back_is_left_out() -> None:
    wave = _wave()
    (run,) = single_runs(np.concatenate([wave, wave[-2::-1]]), 0.01)
    assert np.array(run) == pytest.approx(wave)


def test_a_closed_curve_that_begins_amid_a_run_is_one_run() -> None:
    wave = _wave()
    around = np.concatenate([wave[20:], wave[-2::-1], wave[1:21]])
    (run,) = single_runs(around, 0.01)
    assert np.array(run)[[0, -1]] == pytest.approx(wave[[-1, 0]])
    assert len(run) == len(wave)


def test_a_way_back_beside_the_way_out_is_another_run() -> None:
    out = np.array([[0.0, 0.0], [10.0, 0.0]])
    back = np.array([[10.0, 0.0], [0.0, 1.0]])
    assert len(single_runs(np.concatenate([out, back[1:]]), 0.01)) == 2
    assert len(single_runs(np.concatenate([out, back[1:]]), 1.5)) == 1


def test_repeated_points_make_no_links() -> None:
    points = np.repeat(_wave(9), 3, axis=0)
    (run,) = single_runs(points, 0.01)
    assert len(run) == 9
    assert single_runs(np.zeros((5, 2)), 0.01) == []


@given(
    _POINTS,
    st.lists(st.tuples(st.floats(-60, 60), st.floats(-60, 60)), min_size=1, max_size=6),
)
def test_distances_are_those_of_the_densely_sampled_chain(
    chain: npt.NDArray[np.float64], points: list[tuple[float, float]]
) -> None:
    targets = np.array(points)
    shares = np.linspace(0.0, 1.0, 201)[:, None]
    dense = np.concatenate([a + shares * (b - a) for a, b in itertools.pairwise(chain)])
    sampled = np.hypot(*(targets[:, None] - dense[None]).transpose(2, 0, 1)).min(axis=1)
    longest = np.hypot(*np.diff(chain, axis=0).T).max()
    found = chain_distances(chain, targets)
    assert (found <= sampled + 1e-9).all()
    assert (found >= sampled - longest / 200.0).all()


@given(_POINTS, st.integers(-200, 200))
def test_crossings_with_a_line_lie_on_both(chain: npt.NDArray[np.float64], level: int) -> None:
    # Off the grid that the chain's points lie on: each link crosses or does not.
    value = level / 4.0 + 0.1
    links = list(itertools.pairwise(chain))
    flat = crossings_with_curves(tuple(map(tuple, chain)), [axis_line(1, value)])
    assert len(flat) == sum((a[1] - value) * (b[1] - value) < 0 for a, b in links)
    for first in flat:
        assert chain_distances(chain, np.array([[first, value]]))[0] < 1e-9
    upright = crossings_with_curves(tuple(map(tuple, chain)), [axis_line(0, value)])
    assert len(upright) == sum((a[0] - value) * (b[0] - value) < 0 for a, b in links)
    assert upright == pytest.approx([value] * len(upright))


def test_crossings_with_a_circle_and_a_slant() -> None:
    chain = ((-10.0, 3.0), (10.0, 3.0))
    through = ((-10.0, 3.0), (0.0, 3.0), (10.0, 3.0))
    circle = Circle((0.0, 0.0), 5.0)
    assert sorted(crossings_with_curves(through, [circle])) == pytest.approx([-4.0, 4.0])
    slant = line_through((-4.0, 0.0), (4.0, 8.0))
    assert crossings_with_curves(chain, [slant]) == pytest.approx([-1.0])


@given(_POINTS, _POINTS)
def test_crossings_of_chains_lie_on_both(
    one: npt.NDArray[np.float64], other: npt.NDArray[np.float64]
) -> None:
    first, second = tuple(map(tuple, one)), tuple(map(tuple, other + 0.0317))
    found = crossings_with_chain(first, second)
    assert sorted(found) == pytest.approx(sorted(crossings_with_chain(second, first)), abs=1e-7)
    for a in found:
        ups = [
            line[0][1] + (a - line[0][0]) / (line[1][0] - line[0][0]) * (line[1][1] - line[0][1])
            for chain in (first, second)
            for line in itertools.pairwise(chain)
            if line[0][0] != line[1][0]
            and min(line[0][0], line[1][0]) - 1e-9 <= a <= max(line[0][0], line[1][0]) + 1e-9
        ]
        upright = any(abs(p[0] - a) < 1e-7 for chain in (first, second) for p in chain)
        near = min(abs(u - v) for i, u in enumerate(ups) for v in ups[:i]) if len(ups) > 1 else 0.0
        assert near < 1e-7 or upright


def test_two_waves_cross_as_often_as_they_do() -> None:
    wave = _wave()
    other = np.stack([wave[:, 0], 4.0 * np.cos(wave[:, 0] / 10.0)], axis=1)
    found = crossings_with_chain(tuple(map(tuple, wave)), tuple(map(tuple, other)))
    expected = 10.0 * np.arctan([0.5, 0.5]) + [0.0, 10.0 * np.pi]
    assert sorted(found) == pytest.approx(expected, abs=0.05)
    far = tuple((a, b + 50.0) for a, b in wave)
    assert crossings_with_chain(tuple(map(tuple, wave)), far) == []


@given(st.lists(st.floats(0.0, 62.0), min_size=1, max_size=5, unique=True))
def test_a_chain_is_led_through_points_that_it_passes(firsts: list[float]) -> None:
    wave = _wave()
    targets = np.array([[a, 8.0 * np.sin(a / 10.0)] for a in firsts])
    led = np.array(through_points(wave, targets, 0.1))
    assert len(led) <= len(wave) + len(targets)
    for target in targets:
        assert np.hypot(*(led - target).T).min() < 1e-9
    for point in wave:
        assert np.hypot(*(led - point).T).min() < 1e-12
    assert (np.diff(led[:, 0]) > -0.1).all()
    assert chain_distances(led, wave).max() < 0.1


def test_points_that_a_chain_passes_by_are_left_out() -> None:
    wave = _wave()
    led = through_points(wave, np.array([[31.0, 20.0], [0.0, 0.0]]), 0.1)
    assert np.array(led) == pytest.approx(wave)
