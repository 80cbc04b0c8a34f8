# Compiled functions get their types from the arrays they are called with.
# ruff: noqa: ANN001, ANN201, ANN202, PLR0917
"""Sorting Gaussians into tiles, compiled.

A tile is a small rectangle of pixels that one thread composites.  Each (Gaussian, tile) pair has a
place of its own for its gradients; those of a tile lie side by side, as they are worked out.  For
each Gaussian it is listed where its own are.

All that compositing reads of a Gaussian in a view is one record, as long as a cache line in single
precision: a tile's Gaussians lie anywhere in memory, and what is read from one place is waited for
once.
"""

import math
from typing import Any

import numpy as np
import numpy.typing as npt
from numba import njit, prange

TILE_WIDTH = 8
TILE_HEIGHT = 16
"""Narrow, so that small Gaussians touch few pixels in vain; a line fills a vector register.

Other modules compile these numbers in: where they are not changed, too, their cached code has the
old ones.
"""

RECORD_FIELDS = 16
"""Numbers kept of a Gaussian in a view.

0, 1: mean.  2, 3, 4: conic, the outer two halved.  5: opacity.  6, 7, 8: colour.  9: depth.
10: by how much its middle line moves in y along x.  11, 12: square of half its height at its mean
in x, and by how much that falls with the square of x.  13: x of its top, from the mean.
14, 15 fill the cache line.
"""

CHUNKS = 4
"""Runs of Gaussians of a view, in order of depth, that threads share out."""

_FAR = 1e12
"""Square of a height in px that covers all images."""

_SLACK = 1e-3
"""By how much the reach of a Gaussian is widened, so that rounding cuts no pixel off."""

_DIGIT = 11
_DIGIT_VALUES = 1 << _DIGIT
"""Bits, and values, that a pass of the radix sort orders by."""

_COMPILE: dict[str, Any] = {"fastmath": True, "error_model": "numpy", "cache": True}


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
def fill_records(projected, opacities, palette, smallest_alpha, counts, records):
    """Put what compositing reads of each Gaussian that is seen side by side, (v n, fields)."""
    means, conics, depths = projected
    views, number = counts.shape
    for index in prange(views * number):
        v = index // number
        i = index - v * number
        if counts[v, i] == 0:
            continue
        # In double precision: the determinant of a thin Gaussian's conic is a small difference.
        xx, xy, yy = np.float64(conics[v, i, 0]), np.float64(conics[v, i, 1]), conics[v, i, 2] + 0.0
        slope, height, fall, top = 0.0, _FAR, 0.0, 0.0
        determinant = xx * yy - xy * xy
        if smallest_alpha > 0 and determinant > 0:
            reach = 2 * math.log(opacities[i] / smallest_alpha) * (1 + _SLACK) + _SLACK
            slope = -xy / yy
            height = reach / yy
            fall = determinant / (yy * yy)
            top = -xy / xx * math.sqrt(reach * xx / determinant)
        records[index, 0] = means[v, i, 0]
        records[index, 1] = means[v, i, 1]
        records[index, 2] = conics[v, i, 0] / 2
        records[index, 3] = conics[v, i, 1]
        records[index, 4] = conics[v, i, 2] / 2
        records[index, 5] = opacities[i]
        for k in range(3):
            records[index, 6 + k] = palette[i, k]
        records[index, 9] = depths[v, i]
        records[index, 10] = slope
        records[index, 11] = height
        records[index, 12] = fall
        records[index, 13] = top


def depth_order(depths: npt.NDArray[np.floating]) -> npt.NDArray[np.int32]:
    """(v, n) the Gaussians of each view from front to back; of equal depth in their own order."""
    if depths.dtype == np.float32:
        order = np.empty(depths.shape, dtype=np.int32)
        _radix_order(depths.view(np.uint32), order)
        return order
    return np.argsort(depths, axis=1, kind="stable").astype(np.int32)


@njit(parallel=True, **_COMPILE)
def _radix_order(bits, order):
    """Order of float32 numbers, given as their bits; least digit first (Knuth, volume 3, 5.2.5)."""
    views, number = bits.shape
    for v in prange(views):
        keys = np.empty(number, np.uint32)
        other_keys = np.empty(number, np.uint32)
        other_order = np.empty(number, np.int32)
        own_order = order[v]
        for i in range(number):
            # Turned so that negative numbers, whose bits count backwards, come first.
            negative = bits[v, i] >> np.uint32(31)
            flip = np.uint32(0xFFFFFFFF) if negative else np.uint32(0x80000000)
            keys[i] = bits[v, i] ^ flip
            own_order[i] = i
        for shift in range(0, 32, _DIGIT):
            places = np.zeros(_DIGIT_VALUES + 1, np.int64)
            for i in range(number):
                places[((keys[i] >> np.uint32(shift)) & np.uint32(_DIGIT_VALUES - 1)) + 1] += 1
            for digit in range(_DIGIT_VALUES):
                places[digit + 1] += places[digit]
            for i in range(number):
                digit = (keys[i] >> np.uint32(shift)) & np.uint32(_DIGIT_VALUES - 1)
                other_keys[places[digit]] = keys[i]
                other_order[places[digit]] = own_order[i]
                places[digit] += 1
            keys, other_keys = other_keys, keys
            for i in range(number):
                own_order[i] = other_order[i]


@njit(inline="always", **_COMPILE)
def _chunk(number, chunk):
    """First and last rank (exclusive) of a chunk."""
    return number * chunk // CHUNKS, number * (chunk + 1) // CHUNKS


@njit(parallel=True, **_COMPILE)
def count_tiles(grid, order, boxes, counts, totals):
    """Number of each chunk's Gaussians in each tile, (v, chunks, lines * columns)."""
    _lines, columns = grid
    views, number = counts.shape
    for unit in prange(views * CHUNKS):
        v, chunk = unit // CHUNKS, unit % CHUNKS
        first, last = _chunk(number, chunk)
        for rank in range(first, last):
            i = order[v, rank]
            if counts[v, i] == 0:
                continue
            for line in range(boxes[v, i, 2] // TILE_HEIGHT, boxes[v, i, 3] // TILE_HEIGHT + 1):
                for column in range(boxes[v, i, 0] // TILE_WIDTH, boxes[v, i, 1] // TILE_WIDTH + 1):
                    totals[v, chunk, line * columns + column] += 1


@njit(parallel=True, **_COMPILE)
def fill_tiles(grid, order, boxes, counts, first_slots, places, members, pairs):
    """List each tile's Gaussians (rows of records) from front to back, and each Gaussian's pairs.

    ``places`` (v, chunks, lines * columns) says where each chunk's part of a tile's list begins,
    and then where it ends.
    """
    _lines, columns = grid
    views, number = counts.shape
    for unit in prange(views * CHUNKS):
        v, chunk = unit // CHUNKS, unit % CHUNKS
        first, last = _chunk(number, chunk)
        for rank in range(first, last):
            i = order[v, rank]
            if counts[v, i] == 0:
                continue
            slot = first_slots[v, i]
            for line in range(boxes[v, i, 2] // TILE_HEIGHT, boxes[v, i, 3] // TILE_HEIGHT + 1):
                for column in range(boxes[v, i, 0] // TILE_WIDTH, boxes[v, i, 1] // TILE_WIDTH + 1):
                    tile = line * columns + column
                    place = places[v, chunk, tile]
                    members[place] = v * number + i
                    pairs[slot] = place
                    places[v, chunk, tile] = place + 1
                    slot += 1
