"""Order by depth, and the lists of the tiles."""

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from gaussiancad_core.splatting.tile_sorting import (
    CHUNKS,
    TILE_HEIGHT,
    TILE_WIDTH,
    count_tiles,
    depth_order,
    fill_tiles,
)

# Every float32 but -0.0, which bits tell from 0.0 and comparison does not.
DEPTHS = st.floats(width=32, allow_nan=False).map(lambda depth: depth + 0.0)


@given(arrays(np.float32, st.tuples(st.just(2), st.integers(0, 60)), elements=DEPTHS))
def test_order_is_that_of_a_stable_sort(depths: npt.NDArray[np.float32]) -> None:
    expected = np.argsort(depths, axis=1, kind="stable")
    assert np.array_equal(depth_order(depths), expected)
    assert np.array_equal(depth_order(depths.astype(np.float64)), expected)


def test_equal_depths_stay_in_their_own_order() -> None:
    depths = np.tile(np.float32([2.0, -1.0, 2.0, 0.5]), (3, 1000))
    order = depth_order(depths)
    assert np.array_equal(order, np.argsort(depths, axis=1, kind="stable"))


@pytest.mark.parametrize("number", [1, 3, 200])
def test_each_tile_lists_its_gaussians_from_front_to_back(number: int) -> None:
    random = np.random.default_rng(number)
    grid, views = (4, 6), 2
    low = random.integers(0, [grid[1] * TILE_WIDTH, grid[0] * TILE_HEIGHT], (views, number, 2))
    high = low + random.integers(0, 30, low.shape)
    high = np.minimum(high, [grid[1] * TILE_WIDTH - 1, grid[0] * TILE_HEIGHT - 1])
    boxes = np.stack([low[..., 0], high[..., 0], low[..., 1], high[..., 1]], axis=-1)
    boxes = boxes.astype(np.int32)
    columns = boxes[..., 1] // TILE_WIDTH - boxes[..., 0] // TILE_WIDTH + 1
    lines = boxes[..., 3] // TILE_HEIGHT - boxes[..., 2] // TILE_HEIGHT + 1
    counts = (columns * lines).astype(np.int32)
    counts[:, ::5] = 0  # not seen
    depths = random.random((views, number), np.float32)
    order = depth_order(depths)
    totals = np.zeros((views, CHUNKS, grid[0] * grid[1]), np.int64)
    count_tiles(grid, order, boxes, counts, totals)
    listed = totals.transpose(0, 2, 1)
    after = np.cumsum(listed).reshape(listed.shape)
    places = np.ascontiguousarray((after - listed).transpose(0, 2, 1))
    ends = np.cumsum(counts.ravel())
    members = np.full(ends[-1], -1, np.int32)
    pairs = np.full(ends[-1], -1, np.int32)
    first_slots = (ends - counts.ravel()).reshape(views, number)
    fill_tiles(grid, order, boxes, counts, first_slots, places, members, pairs)
    assert sorted(pairs) == list(range(ends[-1]))
    assert np.array_equal(members[pairs], np.repeat(np.arange(views * number), counts.ravel()))
    starts = np.concatenate([[0], after[:, :, -1].ravel()])
    for v in range(views):
        for tile in range(grid[0] * grid[1]):
            index = v * grid[0] * grid[1] + tile
            found = members[starts[index] : starts[index + 1]] - v * number
            line, column = divmod(tile, grid[1])
            reaches = (
                (boxes[v, :, 0] // TILE_WIDTH <= column)
                & (column <= boxes[v, :, 1] // TILE_WIDTH)
                & (boxes[v, :, 2] // TILE_HEIGHT <= line)
                & (line <= boxes[v, :, 3] // TILE_HEIGHT)
                & (counts[v] > 0)
            )
            assert found.tolist() == [i for i in order[v] if reaches[i]]
