"""Sorting Gaussians into tiles, compiled.

A tile is a small square of pixels that one thread composites.  Each (Gaussian, tile) pair has a slot
of its own for its gradients, and the slots of a Gaussian lie side by side.
"""

import math

from numba import njit, prange

TILE_WIDTH = 16
TILE_HEIGHT = 16

_COMPILE = {"fastmath": True, "error_model": "numpy", "cache": True}


@njit(parallel=True, **_COMPILE)
def find_boxes(size, means, covariances, opacities, smallest_alpha, boxes, counts):  # noqa: ANN001, ANN201
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
            x, y = means[v, i, 0] - 0.5, means[v, i, 1] - 0.5
            if not (
                x + half_x >= 0 and x - half_x <= width and y + half_y >= 0 and y - half_y <= height
            ):
                continue
            x0 = max(x0, int(math.ceil(x - half_x)))
            x1 = min(float(x1), math.floor(x + half_x))
            y0 = max(y0, int(math.ceil(y - half_y)))
            y1 = min(float(y1), math.floor(y + half_y))
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
def count_tiles(grid, boxes, counts, totals):  # noqa: ANN001, ANN201
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
def fill_tiles(grid, order, boxes, counts, first_slots, starts, members, slots):  # noqa: ANN001, ANN201
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
