"""Drawn parts: every view has lines, and the same seed draws the same ones."""

import math
from itertools import pairwise

import numpy as np
import pytest

from learning.training_parts import Circle, DrawnPart, PartView, drawn_parts

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def parts() -> list[DrawnPart]:
    return drawn_parts(seed=3, count=2)


def _chains(part: DrawnPart) -> list[np.ndarray]:
    return [chain for view in part.views.values() for chain in (*view.visible, *view.hidden)]


def test_all_views_have_visible_lines_of_two_points_or_more(parts: list[DrawnPart]) -> None:
    for part in parts:
        assert len(part.views) == 3
        for view in part.views.values():
            assert view.visible
            for chain in (*view.visible, *view.hidden, *view.tangent):
                assert chain.shape[0] >= 2 and chain.shape[1:] == (2,)
                assert np.isfinite(chain).all()


def test_the_hull_of_a_view_is_drawn_visible(parts: list[DrawnPart]) -> None:
    for part in parts:
        for view in part.views.values():
            points = np.concatenate(view.visible)
            extent = np.stack([points.min(axis=0), points.max(axis=0)])
            assert np.allclose(extent, view.box(), atol=1e-3 * np.ptp(view.box()))


def test_views_of_a_part_share_their_extents(parts: list[DrawnPart]) -> None:
    for part in parts:
        extents: dict[int, list[float]] = {}
        for role, view in part.views.items():
            frame = role.frame
            for (axis, _), extent in zip(
                (frame.right_axis, frame.up_axis), np.ptp(view.box(), axis=0), strict=True
            ):
                extents.setdefault(axis.value, []).append(float(extent))
        for this_extent in extents.values():
            assert max(this_extent) - min(this_extent) < 2e-3 * max(this_extent)


def test_the_same_seed_draws_the_same_part_in_any_number(parts: list[DrawnPart]) -> None:
    again = drawn_parts(seed=3, count=1)[0]
    first, second = _chains(parts[0]), _chains(again)
    assert len(first) == len(second)
    assert all(np.array_equal(one, other) for one, other in zip(first, second, strict=True))
    assert parts[0].views.keys() == again.views.keys()


def test_areas_of_sections_are_closed_rings(parts: list[DrawnPart]) -> None:
    for part in parts:
        for section in part.sections:
            assert section.view.areas
            for area in section.view.areas:
                assert all(np.array_equal(ring[0], ring[-1]) for ring in area)


@pytest.mark.parametrize("mirrored", [False, True])
def test_a_moved_circle_runs_along_the_moved_points(mirrored: bool) -> None:
    circle = Circle((3.0, -2.0), 5.0, 0.4, 1.1, hidden=False)
    angles = circle.start + np.linspace(0.0, circle.sweep, 9)
    points = np.array(circle.centre) + 5.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    matrix = 2.0 * np.array([[math.cos(0.7), -math.sin(0.7)], [math.sin(0.7), math.cos(0.7)]])
    if mirrored:
        matrix = matrix @ np.diag([1.0, -1.0])
    moved = circle.moved(matrix, (10.0, 20.0))
    angles = moved.start + np.linspace(0.0, moved.sweep, 9)
    found = np.array(moved.centre) + moved.radius * np.stack(
        [np.cos(angles), np.sin(angles)], axis=1
    )
    expected = points @ matrix.T + (10.0, 20.0)
    assert np.allclose(found, expected[::-1] if mirrored else expected)


def test_a_change_goes_to_each_line() -> None:
    line = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], np.float32)
    view = PartView((line,), (line,), (line, line))

    def parted(chain: np.ndarray) -> list[np.ndarray]:
        return [np.stack(item) for item in pairwise(chain)]

    changed = view.each(parted)
    assert [len(item) for item in (changed.visible, changed.hidden, changed.tangent)] == [2, 2, 4]
