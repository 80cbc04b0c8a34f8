"""Pairs of near points are those that all pairs tell, however they are spread."""

import numpy as np
import pytest

from gaussiancad_core.geometry.near_points import (
    connected_groups,
    near_lists,
    near_pairs,
    pairs_between,
)


@pytest.mark.parametrize(
    ("count", "axes", "reach", "wide"),
    [
        *[(40, 2, 0.2, 1.0), (400, 2, 0.05, 1.0), (400, 3, 0.2, 1.0), (300, 5, 0.4, 1.0)],
        # All of one place, none near, coordinates a billion apart, one row.
        *[(150, 2, 0.1, 0.0), (300, 2, 0.0, 1.0), (300, 2, 1.0, 1e9), (400, 1, 1e-3, 1.0)],
    ],
)
def test_those_are_found_that_all_pairs_tell(
    count: int, axes: int, reach: float, wide: float
) -> None:
    random = np.random.default_rng(count + axes)
    points = wide * random.random((count, axes))
    others = np.concatenate([points[::3], points[1::3] + 0.3 * reach])
    away = np.hypot.reduce(points[:, None] - others[None], axis=2)
    wanted = np.argwhere(away <= reach)
    assert np.array_equal(pairs_between(points, others, reach), wanted)
    lists = near_lists(points, others, reach)
    assert [(one, other) for one, near in enumerate(lists) for other in near] == list(
        map(tuple, wanted.tolist())
    )
    is_near = np.hypot.reduce(points[:, None] - points[None], axis=2) <= reach
    assert np.array_equal(near_pairs(points, reach), np.argwhere(np.triu(is_near, 1)))


def test_many_points_have_the_pairs_that_cells_tell() -> None:
    points = np.random.default_rng(5).random((6000, 2))
    pairs = pairs_between(points, points, 0.01)
    assert np.array_equal(near_pairs(points, 0.01), pairs[pairs[:, 0] < pairs[:, 1]])


def test_no_points_are_near_none() -> None:
    nothing = np.empty((0, 2))
    assert len(pairs_between(nothing, np.ones((3, 2)), 1.0)) == 0
    assert near_lists(np.ones((2, 2)), nothing, 1.0) == [[], []]


def test_groups_hang_together_along_any_chain_and_are_counted_by_their_first_members() -> None:
    chain = np.random.default_rng(3).permutation(2000)
    links = np.stack([chain[:-1], chain[1:]], axis=1)
    assert connected_groups(links, 2000).max() == 0
    pairs = np.array([[4, 1], [3, 0], [0, 3], [5, 5]])
    assert connected_groups(pairs, 6).tolist() == [0, 1, 2, 0, 1, 3]
    assert connected_groups(np.empty((0, 2), dtype=np.int64), 2).tolist() == [0, 1]
