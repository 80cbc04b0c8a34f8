"""Coordinates of an axis: clusters in order, and views brought together."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.sheet.registration.axis_clusters import (
    Limits,
    SeenCoordinates,
    averages,
    clustered,
    fit_axis,
)

LIMITS = Limits(apart=0.5, reach=1.0, finest=0.3)
SEEN = st.lists(
    st.tuples(st.floats(0.0, 12.0), st.floats(0.1, 10.0), st.integers(0, 2)),
    min_size=1,
    max_size=30,
)


def seen(rows: list[tuple[float, float, int]]) -> SeenCoordinates:
    """Coordinate, weight and view of each row."""
    at, weight, view = zip(*rows, strict=True)
    return SeenCoordinates(np.array(at), np.array(weight), np.array(view))


@given(SEEN)
def test_clusters_are_runs_of_the_sorted_values_and_stay(
    rows: list[tuple[float, float, int]],
) -> None:
    this_seen = seen(rows)
    found = clustered(this_seen, LIMITS)
    order = np.argsort(this_seen.at, kind="stable")
    assert set(np.diff(found[order])) <= {0, 1}
    assert found[order][0] == 0
    middle = averages(this_seen.at, this_seen.weight, found)
    assert (np.diff(middle) > 0.0).all()
    again = SeenCoordinates(middle[found], this_seen.weight, this_seen.view)
    assert (clustered(again, LIMITS) == found).all()


def test_near_ones_of_two_views_are_one_far_ones_are_not() -> None:
    rows = [(10.0, 1.0, 0), (10.9, 3.0, 1), (20.0, 1.0, 0), (21.1, 1.0, 1)]
    found = clustered(seen(rows), LIMITS)
    assert found.tolist() == [0, 0, 1, 2]
    this_seen = seen(rows)
    assert averages(this_seen.at, this_seen.weight, found)[0] == pytest.approx(10.675)


def test_what_one_view_shows_apart_stays_two() -> None:
    # The one between belongs to the nearer of the two.
    rows = [(10.0, 1.0, 0), (10.8, 1.0, 0), (10.3, 1.0, 1)]
    assert clustered(seen(rows), LIMITS).tolist() == [0, 1, 0]
    within = [(10.0, 1.0, 0), (10.4, 1.0, 0)]
    assert clustered(seen(within), LIMITS).tolist() == [0, 0]


def test_the_ends_are_one_whatever_lies_between() -> None:
    rows = [(0.0, 1.0, 0), (0.9, 1.0, 0), (1.4, 1.0, 1), (50.0, 1.0, 0)]
    assert clustered(seen(rows), LIMITS, (1.4, 50.0)).tolist() == [0, 0, 0, 1]


def test_views_are_shifted_by_what_they_share() -> None:
    # One box is 1.2 px too long; five lines in both views say where it belongs.
    lines = [10.0, 35.0, 52.0, 71.0, 90.0]
    rows = [(0.0, 1e-3, 0), (100.0, 1e-3, 0), (0.0, 1e-3, 1), (101.2, 1e-3, 1)]
    rows += [(at, 100.0, 0) for at in lines] + [(at + 1.2, 100.0, 1) for at in lines]
    this_seen = seen(rows)
    fit = fit_axis(this_seen, np.array([100.0, 101.2]), LIMITS)
    assert fit.gain.tolist() == [1.0, 1.0]
    assert fit.shift[0] - fit.shift[1] == pytest.approx(1.2, abs=1e-6)
    common = fit.common(this_seen)
    assert common[4:9] == pytest.approx(common[9:], abs=1e-6)
    assert (fit.cluster[4:9] == fit.cluster[9:]).all()


def test_a_wrong_match_does_not_pull() -> None:
    lines = [10.0, 35.0, 52.0, 71.0, 90.0]
    rows = [(0.0, 1e-3, 0), (100.0, 1e-3, 0), (0.0, 1e-3, 1), (100.0, 1e-3, 1)]
    rows += [(at, 100.0, 0) for at in lines] + [(at, 100.0, 1) for at in lines[:-1]]
    rows.append((lines[-1] + 0.8, 100.0, 1))
    fit = fit_axis(seen(rows), np.array([100.0, 100.0]), LIMITS)
    assert fit.shift[0] == pytest.approx(fit.shift[1], abs=1e-3)
    assert fit.cluster[8] != fit.cluster[-1]


def test_views_of_two_scales_are_stretched_to_their_mean() -> None:
    lines = np.array([0.0, 20.0, 45.0, 80.0, 100.0])
    rows = [(at, 10.0, 0) for at in lines] + [(1.04 * at, 10.0, 1) for at in lines]
    this_seen = seen(rows)
    fit = fit_axis(this_seen, np.array([100.0, 104.0]), LIMITS)
    assert fit.gain == pytest.approx([1.02, 1.02 / 1.04], abs=1e-9)
    assert fit.common(this_seen)[:5] == pytest.approx(fit.common(this_seen)[5:], abs=1e-9)
