# Compiled functions get their types from the arrays they are called with.
# ruff: noqa: ANN001, ANN201, PLR0917
"""Sorting Gaussians into tiles, compiled.

A tile is a small square of pixels that one thread composites.  Each (Gaussian, tile) pair has a
slot of its own for its gradients, and the slots of a Gaussian lie side by side.
"""

import math

from numba import njit, prange

TILE_WIDTH = 8
TILE_HEIGHT = 16
"""Narrow, so that small Gaussians touch few pixels in vain; a line fills a vector register.

Other modules compile these numbers in: where they are not changed, too, their cached code has the
old ones.
"""

_COMPILE = {"fastmath": True, "error_model": "numpy", "cache": True}


@njit(parallel=True, **_COMPILE)
def find_boxes(size, means, covariances, opacities, smallest_alpha, boxes, counts):
    """Pixel boxes (v, n, 4: x0, x1, y0, y1, inclusive) that a Gaussian reaches; its tiles' number.

    It reaches where its alpha is at least the smallest; with zero for that it reaches everywhere.
    """
    height, width = size
    views, number = counts.shape
    for index in prange(views * number):
        v = index // number
        i = index - v * number
        counts[v, i] = 0
        opacity = opacities[i]
        if covariances[v, i, 0] <= 0 or opacity < smallest_alpha:
            continue
        x0, x1, y0, y1 = 0, width - 1, 0, height - 1
        if smallest_alpha > 0:
            reach = 2 * math.log(opacity / smallest_alpha)
            half_x = math.sqrt(reach * covariances[v, i, 0])
            half_y = math.sqrt(reach * covariances[v, i, 2])
            # Held near the image, since a number far outside does not fit into an integer.
            x = min(max(means[v, i, 0] - 0.5, -half_x - 1), width + half_x)
            y = min(max(means[v, i, 1] - 0.5, -half_y - 1), height + half_y)
            x0 = max(x0, math.ceil(max(x - half_x, -1.0)))
            x1 = min(x1, math.floor(min(x + half_x, width + 0.0)))
            y0 = max(y0, math.ceil(max(y - half_y, -1.0)))
            y1 = min(y1, math.floor(min(y + half_y, height + 0.0)))
        if x1 < x0 or y1 < y0:
            continue
        boxes[v, i, 0] = x0
        boxes[v, i, 1] = x1
        boxes[v, i, 2] = y0
        boxes[v, i, 3] = y1
        columns = boxes[v, i, 1] // TILE_WIDTH - boxes[v, i, 0] // TILE_WIDTH + 1
        lines = boxes[v, i, 3] // TILE_HEIGHT - boxes[v, i, 2] // TILE_HEIGHT + 1
        counts[v, i] = columns * lines


@njit(parallel=True, **_COMPILE)
def count_tiles(grid, boxes, counts, totals):
    """Number of Gaussians in each tile, (v, lines * columns)."""
    _lines, columns = grid
    for v in prange(len(counts)):
        for i in range(counts.shape[1]):
            if counts[v, i] == 0:
                continue
            for line in range(boxes[v, i, 2] // TILE_HEIGHT, boxes[v, i, 3] // TILE_HEIGHT + 1):
                for column in range(boxes[v, i, 0] // TILE_WIDTH, boxes[v, i, 1] // TILE_WIDTH + 1):
                    totals[v, line * columns + column] += 1


@njit(parallel=True, **_COMPILE)
def fill_tiles(grid, order, boxes, counts, first_slots, starts, members, slots):
    """List each tile's Gaussians from front to back, and the slot of each pair."""
    lines, columns = grid
    tiles = lines * columns
    for v in prange(len(counts)):
        place = starts[v * tiles : (v + 1) * tiles].copy()
        for rank in range(counts.shape[1]):
            i = order[v, rank]
            if counts[v, i] == 0:
                continue
            slot = first_slots[v, i]
            for line in range(boxes[v, i, 2] // TILE_HEIGHT, boxes[v, i, 3] // TILE_HEIGHT + 1):
                for column in range(boxes[v, i, 0] // TILE_WIDTH, boxes[v, i, 1] // TILE_WIDTH + 1):
                    tile = line * columns + column
                    members[place[tile]] = i
                    slots[place[tile]] = slot
                    place[tile] += 1
                    slot += 1
