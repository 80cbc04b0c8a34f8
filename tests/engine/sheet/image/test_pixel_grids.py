"""Whether lines lie on parts of a pixel."""

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.pixel_grids import Rounding, rounding_step, seen_rounding

_READ = 0.006
"""px, how exactly lines are read."""


def _views(
    columns: np.ndarray, rows: np.ndarray, seed: int = 0, length: float = 60.0
) -> list[list[Segment]]:
    """Two views whose lines stand at the columns, and one of them at the rows."""
    random = np.random.default_rng(seed)
    first, second = [], []
    for x in columns:
        for top, view in ((40.0, first), (700.0, second)):
            at = x + random.normal(0.0, _READ)
            view.append(Segment((at, top), (at, top + length), Linetype.VISIBLE))
    for y in rows:
        at = y + random.normal(0.0, _READ)
        first.append(Segment((40.0, at), (40.0 + length, at), Linetype.HIDDEN))
    return [first, second]


def _places(seed: int, count: int) -> np.ndarray:
    return np.sort(np.random.default_rng(seed).uniform(50.0, 600.0, count))


def _told(views: list[list[Segment]], *, well_read: bool = True) -> Rounding:
    return seen_rounding(views, well_read=well_read)


@pytest.mark.parametrize(("parts", "seed"), [(1, 1), (2, 2), (4, 3), (5, 1), (8, 2)])
def test_rounded_lines_are_told(parts: int, seed: int) -> None:
    columns, rows = (np.round(_places(seed + k, 8) * parts) / parts for k in (0, 10))
    assert _told(_views(columns, rows)) is Rounding.TOLD
    # Between the rows of a raster as well.
    half = 0.5 / parts
    assert _told(_views(columns + half, rows + half)) is Rounding.TOLD


@pytest.mark.parametrize("parts", [1, 2, 4])
def test_the_step_is_told_though_wide_lines_lie_between_its_multiples(parts: int) -> None:
    columns, rows = (np.round(_places(seed, 8) * parts) / parts for seed in (1, 2))
    assert rounding_step(_views(columns, rows), well_read=True) == 1.0 / parts
    # Visible lines, the columns, are of an odd width, and hidden ones of an even one.
    half = 0.5 / parts
    assert rounding_step(_views(columns + half, rows), well_read=True) == 1.0 / parts


def test_no_step_is_told_where_nothing_is_rounded() -> None:
    for seed in range(20):
        views = _views(_places(seed, 9), _places(seed + 40, 9))
        assert rounding_step(views, well_read=False) == 0.0


def test_some_lines_that_were_read_badly_change_nothing() -> None:
    columns, rows = (np.round(_places(k, 12) * 4.0) / 4.0 for k in (1, 2))
    columns[:3] += 0.1
    assert _told(_views(columns, rows), well_read=False) is Rounding.TOLD
    assert _told(_views(columns, rows)) is Rounding.UNTOLD


def test_what_is_read_badly_is_never_free() -> None:
    views = _views(_places(1, 20), _places(2, 20))
    assert _told(views) is Rounding.NONE
    assert _told(views, well_read=False) is Rounding.UNTOLD


def test_lines_anywhere_are_not_rounded() -> None:
    stated = [_told(_views(_places(k, 9), _places(k + 50, 9))) for k in range(40)]
    assert Rounding.TOLD not in stated
    assert stated.count(Rounding.NONE) >= 30


@pytest.mark.parametrize("seed", range(5))
def test_what_is_rounded_finely_or_in_one_direction_is_never_free(seed: int) -> None:
    columns, rows = _places(seed, 9), _places(seed + 50, 9)
    fine = _views(np.round(10.0 * columns) / 10.0, np.round(10.0 * rows) / 10.0)
    one_way, other_way = np.round(4.0 * rows) / 4.0, np.round(4.0 * columns) / 4.0
    for views in (fine, _views(columns, one_way), _views(other_way, rows)):
        assert _told(views) is not Rounding.NONE


def test_one_coordinate_in_two_views_tells_no_more_than_in_one() -> None:
    few = _views(_places(1, 4), _places(2, 3))
    assert sum(map(len, few)) > 10
    assert _told(few) is Rounding.UNTOLD
    short = _views(_places(1, 9), _places(2, 9), length=20.0)
    assert _told(short) is Rounding.UNTOLD
    assert _told([]) is Rounding.UNTOLD


def test_slanted_lines_have_no_place() -> None:
    lines = [
        Segment((x, 40.0), (x + 3.0, 100.0), Linetype.VISIBLE)
        for x in np.round(_places(1, 20) * 4) / 4
    ]
    assert _told([lines]) is Rounding.UNTOLD
