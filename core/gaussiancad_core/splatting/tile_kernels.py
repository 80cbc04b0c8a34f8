# Compiled functions get their types from the arrays they are called with.
# ruff: noqa: ANN001, ANN201, ANN202, PLR0917
"""Compositing of a tile's Gaussians and the gradient of that, compiled.

Each tile is composited from front to back by one thread, so that no two threads write to one place.
In the backward pass each (Gaussian, tile) pair has a row of its own; the rows of a Gaussian are
added up in a fixed order.  So the result does not depend on the number of threads.

The gradient also runs from front to back.  With ``v`` the upstream gradient's product with a
Gaussian's colour, one and depth, and ``w = a T`` its weight, the loss changes with its alpha by
``T v - (rest behind) / (1 - a)``, where the rest behind is the pixel's total of ``w v``, known from
the image itself, less what was met so far.

All that a tile needs lies in one flat array, one field of ``TILE_PIXELS`` values after the other,
and is indexed with unsigned integers: only so does the compiler see that the fields do not overlap
and turn the loops over pixels into SIMD code (four times as fast).  A tile is eight pixels wide.

Threads take runs of neighbouring tiles, which share Gaussians, and all runs have as much to do.
"""

import math
from typing import Any

import numpy as np
from numba import njit, prange, types
from numba.extending import overload

from gaussiancad_core.splatting.tile_sorting import RECORD_FIELDS, TILE_HEIGHT, TILE_WIDTH

TILE_PIXELS = TILE_WIDTH * TILE_HEIGHT

PAIR_FIELDS = 10
"""Gradients kept for a (Gaussian, tile) pair: mean 2, conic 3, opacity, depth, colour 3."""

_BATCH = 16
"""Gaussians whose records are fetched at once, so that they are waited for together; between two
batches it is looked whether the tile is opaque all over."""

_COMPILE: dict[str, Any] = {"fastmath": True, "error_model": "numpy", "cache": True}

# Places of the fields in a tile's array.  Forward and backward share the first three.
_COLUMN, _LINE, _LEFT = (np.uint64(field * TILE_PIXELS) for field in range(3))
_RED, _GREEN, _BLUE, _DEPTH = (np.uint64(field * TILE_PIXELS) for field in range(3, 7))
_ALPHA, _TOTAL, _MET = (np.uint64(field * TILE_PIXELS) for field in range(7, 10))
_FORWARD_FIELDS = 7
_BACKWARD_FIELDS = 10

# Single-precision constants: a Python number would turn single into double precision.
_ZERO = np.float32(0.0)
_HALF = np.float32(0.5)
_ONE = np.float32(1.0)
_LAST_COLUMN = np.float32(TILE_WIDTH - 1)
_BEFORE = np.float32(1.0 - 0.01)
_AFTER = np.float32(1.0 + 0.01)
"""Rounding up the first line, and one past the last, with a margin of a hundredth of a pixel."""
_LOG2_E = np.float32(math.log2(math.e))
_SERIES = tuple(np.float32(math.log(2.0) ** k / math.factorial(k)) for k in range(7))
_LOWEST = np.float32(-86.0)
_BIAS = np.int32(127)
_MANTISSA = np.int32(23)


@njit(inline="always", **_COMPILE)
def _exp_single(x):
    """exp of a float32 that is not positive, to about 5e-7; unlike libm's it becomes SIMD code."""
    scaled = max(x, _LOWEST) * _LOG2_E
    whole = np.int32(scaled - _HALF)
    rest = scaled - np.float32(whole)
    c0, c1, c2, c3, c4, c5, c6 = _SERIES
    power = (((((c6 * rest + c5) * rest + c4) * rest + c3) * rest + c2) * rest + c1) * rest + c0
    return power * np.int32((whole + _BIAS) << _MANTISSA).view(np.float32)


def _exp(x: float) -> float:
    return math.exp(x)


@overload(_exp, inline="always")
def _exp_for(x):
    # numba wants the implementation's own signature, so a bare function would not do.
    if x == types.float32:
        return lambda x: _exp_single(x)  # noqa: PLW0108
    return lambda x: math.exp(x)  # noqa: PLW0108


@njit(inline="always", **_COMPILE)
def _clear(tile):
    """Make a tile's array empty, and let everything through."""
    for p in range(np.uint64(len(tile))):
        tile[p] = _ZERO
    for p in range(np.uint64(TILE_PIXELS)):
        tile[p + _COLUMN] = p % np.uint64(TILE_WIDTH)
        tile[p + _LINE] = p // np.uint64(TILE_WIDTH)
        tile[p + _LEFT] = _ONE


@njit(inline="always", **_COMPILE)
def _clearest(tile):
    """The largest transmittance in a tile."""
    largest = tile[_LEFT]
    for p in range(np.uint64(TILE_PIXELS)):
        largest = max(largest, tile[p + _LEFT])
    return largest


@njit(inline="always", **_COMPILE)
def _lines(records, row, x, y, lines):
    """First and last line (exclusive) of a tile that a Gaussian reaches within its columns.

    The outline of a Gaussian is an ellipse; within a range of columns it is highest at its top, or
    at the column that is nearest to it.

    Args:
        records: of all Gaussians.
        row: of the Gaussian.
        x, y: from its mean to the centre of the tile's first pixel.
        lines: of the tile.
    """
    slope, height, fall, top = (
        records[row, 10],
        records[row, 11],
        records[row, 12],
        records[row, 13],
    )
    last_x = x + _LAST_COLUMN
    upper_x = min(max(top, x), last_x)
    lower_x = min(max(-top, x), last_x)
    above = height - fall * upper_x * upper_x
    below = height - fall * lower_x * lower_x
    if above < _ZERO or below < _ZERO:
        return 0, 0
    # Within the tile both are small numbers that are not negative: cutting off is rounding down.
    start = min(max(slope * lower_x - math.sqrt(below) - y + _BEFORE, _ZERO), lines)
    stop = min(max(slope * upper_x + math.sqrt(above) - y + _AFTER, _ZERO), lines)
    return np.int32(start), np.int32(stop)


@njit(inline="always", **_COMPILE)
def _pixels(first, last):
    """First and last pixel (exclusive) of a range of lines."""
    return np.uint64(first * TILE_WIDTH), np.uint64(last * TILE_WIDTH)


@njit(inline="always", **_COMPILE)
def _offset(x0, y0, records, row):
    """From a mean to the centre of a tile's first pixel, in the mean's precision."""
    return np.float32(x0) + _HALF - records[row, 0], np.float32(y0) + _HALF - records[row, 1]


@njit(inline="always", **_COMPILE)
def _fetch(records, members, first, end, batch):
    """Copy the records of the next few of a tile's Gaussians side by side; their number."""
    count = min(_BATCH, end - first)
    for n in range(count):
        row = members[first + n]
        for field in range(RECORD_FIELDS):
            batch[n, field] = records[row, field]
    return count


@njit(**_COMPILE)
def _composite(tile, span, offset, records, row, limits):
    """Add one Gaussian to a tile: its weights times colour and depth, and what it leaves."""
    smallest_alpha, largest_alpha, smallest_left = limits
    xx, xy, yy, opacity = records[row, 2], records[row, 3], records[row, 4], records[row, 5]
    red, green, blue, depth = records[row, 6], records[row, 7], records[row, 8], records[row, 9]
    for p in range(span[0], span[1]):
        dx, dy = offset[0] + tile[p + _COLUMN], offset[1] + tile[p + _LINE]
        alpha = min(opacity * _exp(-((xx * dx + xy * dy) * dx + yy * dy * dy)), largest_alpha)
        before = tile[p + _LEFT]
        drawn = (alpha >= smallest_alpha) & (before > smallest_left)
        weight = alpha * before if drawn else _ZERO
        tile[p + _LEFT] = before - weight
        tile[p + _RED] += weight * red
        tile[p + _GREEN] += weight * green
        tile[p + _BLUE] += weight * blue
        tile[p + _DEPTH] += weight * depth


@njit(**_COMPILE)
def _composite_gradient(tile, span, offset, records, row, limits, gradients, pair):
    """Gradients that one tile gives to one Gaussian, written to the pair's row."""
    smallest_alpha, largest_alpha, smallest_left = limits
    xx, xy, yy, opacity = records[row, 2], records[row, 3], records[row, 4], records[row, 5]
    red, green, blue, depth = records[row, 6], records[row, 7], records[row, 8], records[row, 9]
    zero = _ZERO * opacity
    sum_1, sum_x, sum_y, sum_xx, sum_xy, sum_yy = zero, zero, zero, zero, zero, zero
    to_red, to_green, to_blue, to_depth = zero, zero, zero, zero
    for p in range(span[0], span[1]):
        dx, dy = offset[0] + tile[p + _COLUMN], offset[1] + tile[p + _LINE]
        free = opacity * _exp(-((xx * dx + xy * dy) * dx + yy * dy * dy))
        alpha = min(free, largest_alpha)
        before = tile[p + _LEFT]
        drawn = (alpha >= smallest_alpha) & (before > smallest_left)
        weight = alpha * before if drawn else _ZERO
        value = (
            red * tile[p + _RED]
            + green * tile[p + _GREEN]
            + blue * tile[p + _BLUE]
            + depth * tile[p + _DEPTH]
            + tile[p + _ALPHA]
        )
        met = tile[p + _MET] + weight * value
        tile[p + _LEFT] = before - weight
        tile[p + _MET] = met
        to_red += weight * tile[p + _RED]
        to_green += weight * tile[p + _GREEN]
        to_blue += weight * tile[p + _BLUE]
        to_depth += weight * tile[p + _DEPTH]
        to_alpha = before * value - (tile[p + _TOTAL] - met) / (_ONE - alpha)
        to_exponent = to_alpha * alpha if drawn & (free <= largest_alpha) else _ZERO
        sum_1 += to_exponent
        sum_x += to_exponent * dx
        sum_y += to_exponent * dy
        sum_xx += to_exponent * dx * dx
        sum_xy += to_exponent * dx * dy
        sum_yy += to_exponent * dy * dy
    gradients[pair, 0] = (xx + xx) * sum_x + xy * sum_y
    gradients[pair, 1] = xy * sum_x + (yy + yy) * sum_y
    gradients[pair, 2] = -_HALF * sum_xx
    gradients[pair, 3] = -sum_xy
    gradients[pair, 4] = -_HALF * sum_yy
    gradients[pair, 5] = sum_1 / opacity
    gradients[pair, 6] = to_depth
    gradients[pair, 7] = to_red
    gradients[pair, 8] = to_green
    gradients[pair, 9] = to_blue


@njit(parallel=True, **_COMPILE)
def composite_forward(size, grid, tiles, records, limits, spans, images):
    """Fill the images: colour (v, 3, h, w), alpha (v, h, w), depth (v, h, w).

    ``spans`` (pairs, 2) is filled with the lines of its tile that each Gaussian reaches.
    """
    height, width = size
    starts, members, parts = tiles
    colours, alphas, depth_sums = images
    per_view = grid[0] * grid[1]
    for part in prange(len(parts) - 1):
        tile = np.empty(_FORWARD_FIELDS * TILE_PIXELS, records.dtype)
        batch = np.empty((_BATCH, RECORD_FIELDS), records.dtype)
        for index in range(parts[part], parts[part + 1]):
            v = index // per_view
            x0 = (index - v * per_view) % grid[1] * TILE_WIDTH
            y0 = (index - v * per_view) // grid[1] * TILE_HEIGHT
            lines = np.float32(min(TILE_HEIGHT, height - y0))
            _clear(tile)
            for first_pair in range(starts[index], starts[index + 1], _BATCH):
                if first_pair > starts[index] and _clearest(tile) <= limits[2]:
                    break
                count = _fetch(records, members, first_pair, starts[index + 1], batch)
                for n in range(count):
                    offset = _offset(x0, y0, batch, n)
                    first, last = _lines(batch, n, offset[0], offset[1], lines)
                    spans[first_pair + n, 0], spans[first_pair + n, 1] = first, last
                    if first < last:
                        _composite(tile, _pixels(first, last), offset, batch, n, limits)
            for r in range(min(TILE_HEIGHT, height - y0)):
                for x in range(min(TILE_WIDTH, width - x0)):
                    p, row, column = r * TILE_WIDTH + x, y0 + r, x0 + x
                    colours[v, 0, row, column] = tile[p + _RED]
                    colours[v, 1, row, column] = tile[p + _GREEN]
                    colours[v, 2, row, column] = tile[p + _BLUE]
                    alphas[v, row, column] = _ONE - tile[p + _LEFT]
                    depth_sums[v, row, column] = tile[p + _DEPTH]


@njit(inline="always", **_COMPILE)
def _fill_upstream(tile, v, corner, extent, images, upstream):
    """Put a tile's upstream gradients, and the totals of their products with the images, there."""
    colours, alphas, depths = images
    to_colours, to_alphas, to_depths = upstream
    for r in range(extent[0]):
        for x in range(extent[1]):
            p, row, column = r * TILE_WIDTH + x, corner[0] + r, corner[1] + x
            tile[p + _RED] = to_colours[v, 0, row, column]
            tile[p + _GREEN] = to_colours[v, 1, row, column]
            tile[p + _BLUE] = to_colours[v, 2, row, column]
            tile[p + _DEPTH] = to_depths[v, row, column]
            tile[p + _ALPHA] = to_alphas[v, row, column]
            tile[p + _TOTAL] = (
                tile[p + _RED] * colours[v, 0, row, column]
                + tile[p + _GREEN] * colours[v, 1, row, column]
                + tile[p + _BLUE] * colours[v, 2, row, column]
                + tile[p + _DEPTH] * depths[v, row, column]
                + tile[p + _ALPHA] * alphas[v, row, column]
            )


@njit(parallel=True, **_COMPILE)
def composite_backward(size, grid, tiles, records, limits, spans, images, upstream, gradients):
    """Fill the (pairs, PAIR_FIELDS) gradients of all (Gaussian, tile) pairs."""
    height, width = size
    starts, members, parts = tiles
    per_view = grid[0] * grid[1]
    for part in prange(len(parts) - 1):
        tile = np.empty(_BACKWARD_FIELDS * TILE_PIXELS, records.dtype)
        batch = np.empty((_BATCH, RECORD_FIELDS), records.dtype)
        for index in range(parts[part], parts[part + 1]):
            if starts[index] == starts[index + 1]:
                continue
            v = index // per_view
            x0 = (index - v * per_view) % grid[1] * TILE_WIDTH
            y0 = (index - v * per_view) // grid[1] * TILE_HEIGHT
            _clear(tile)
            extent = (min(TILE_HEIGHT, height - y0), min(TILE_WIDTH, width - x0))
            _fill_upstream(tile, v, (y0, x0), extent, images, upstream)
            opaque = False
            for first_pair in range(starts[index], starts[index + 1], _BATCH):
                opaque = opaque or (first_pair > starts[index] and _clearest(tile) <= limits[2])
                count = _fetch(records, members, first_pair, starts[index + 1], batch)
                for n in range(count):
                    pair = first_pair + n
                    if opaque or spans[pair, 0] >= spans[pair, 1]:
                        for field in range(PAIR_FIELDS):
                            gradients[pair, field] = 0
                        continue
                    offset = _offset(x0, y0, batch, n)
                    span = _pixels(spans[pair, 0], spans[pair, 1])
                    _composite_gradient(tile, span, offset, batch, n, limits, gradients, pair)


@njit(parallel=True, **_COMPILE)
def add_pairs(counts, first_slots, pairs, gradients, upstream, opacities, colours):
    """Sum the rows of each Gaussian: per view for the projection, over all views for the rest."""
    to_means, to_conics, to_depths = upstream
    views, number = counts.shape
    zero = gradients.dtype.type(0)
    for i in prange(number):
        opacity, red, green, blue = zero, zero, zero, zero
        for v in range(views):
            x, y, xx, xy, yy, depth = zero, zero, zero, zero, zero, zero
            for slot in range(first_slots[v, i], first_slots[v, i] + counts[v, i]):
                pair = pairs[slot]
                x += gradients[pair, 0]
                y += gradients[pair, 1]
                xx += gradients[pair, 2]
                xy += gradients[pair, 3]
                yy += gradients[pair, 4]
                opacity += gradients[pair, 5]
                depth += gradients[pair, 6]
                red += gradients[pair, 7]
                green += gradients[pair, 8]
                blue += gradients[pair, 9]
            to_means[v, i, 0], to_means[v, i, 1] = x, y
            to_conics[v, i, 0], to_conics[v, i, 1], to_conics[v, i, 2] = xx, xy, yy
            to_depths[v, i] = depth
        opacities[i] = opacity
        colours[i, 0], colours[i, 1], colours[i, 2] = red, green, blue
