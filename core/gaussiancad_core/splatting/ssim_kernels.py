# Compiled functions get their types from the arrays they are called with.
# ruff: noqa: ANN001, ANN201, ANN202, PLR0917
"""Structural similarity and its gradient, tile by tile, compiled.

A tile with what its pixels look at fits into a processor's cache: its six blurs, three of the
images and three of the gradient, are made there without going through memory.  Where a tile and all
that it looks at are as the targets, the similarity is one, which is its maximum, so that the
gradient is zero: nothing is worked out.  Most of a page is such.

As in :mod:`.tile_kernels` all that a tile needs lies in one flat array that is indexed with
unsigned integers, and the result does not depend on the number of threads.
"""

import math
from typing import Any

import numpy as np
from numba import njit, prange

WINDOW = 11
SIGMA = 1.5
C1 = 0.01**2
C2 = 0.03**2

PARTS = 16
"""Runs of tiles that threads take."""

ROWS, COLUMNS = 44, 220
"""Of a tile's own pixels.  What it looks at is 240 wide: lines of a power of two would fall into
the same places of the cache."""

_HALF = WINDOW // 2
_ROUND = 2 * _HALF
"""Pixels about a tile that its gradient depends on."""

_HEIGHT, _WIDTH = ROWS + 2 * _ROUND, COLUMNS + 2 * _ROUND
_FIELD = _HEIGHT * _WIDTH

_COMPILE: dict[str, Any] = {"fastmath": True, "error_model": "numpy", "cache": True}

_STEP = np.uint64(_WIDTH)
_IMAGE, _TARGET = np.uint64(0), np.uint64(_FIELD)
_TO_MEAN, _TO_SQUARE, _TO_PRODUCT = (np.uint64(field * _FIELD) for field in range(2, 5))
_LINES = tuple(np.uint64(5 * _FIELD + line * _WIDTH) for line in range(3))
"""Three lines that were blurred along the columns."""
_SCRATCH = 5 * _FIELD + 3 * _WIDTH

_ONE, _TWO, _ZERO = np.float32(1.0), np.float32(2.0), np.float32(0.0)
_SINGLE_C1, _SINGLE_C2 = np.float32(C1), np.float32(C2)

_HEIGHTS = [math.exp(-((k - _HALF) ** 2) / (2.0 * SIGMA**2)) for k in range(WINDOW)]
_W = tuple(np.float32(height / sum(_HEIGHTS)) for height in _HEIGHTS[: _HALF + 1])


@njit(inline="always", **_COMPILE)
def _weighed(tile, at, step):
    """The window's sum over eleven places from one on."""
    w0, w1, w2, w3, w4, w5 = _W
    total = w0 * (tile[at] + tile[at + np.uint64(10) * step])
    total += w1 * (tile[at + step] + tile[at + np.uint64(9) * step])
    total += w2 * (tile[at + np.uint64(2) * step] + tile[at + np.uint64(8) * step])
    total += w3 * (tile[at + np.uint64(3) * step] + tile[at + np.uint64(7) * step])
    total += w4 * (tile[at + np.uint64(4) * step] + tile[at + np.uint64(6) * step])
    return total + w5 * tile[at + np.uint64(5) * step]


@njit(inline="always", **_COMPILE)
def _moments(tile, at):
    """The window's sums of an image, its square and its product with the target, downwards."""
    w0, w1, w2, w3, w4, w5 = _W
    mean, square, product = _ZERO, _ZERO, _ZERO
    place = at
    for weight in (w0, w1, w2, w3, w4, w5, w4, w3, w2, w1, w0):
        x = tile[place + _IMAGE]
        item = weight * x
        mean += item
        square += item * x
        product += item * tile[place + _TARGET]
        place += _STEP
    return mean, square, product


@njit(**_COMPILE)
def _alike(image, target, top, left):
    """Whether a tile and all that it looks at are as the target.

    Args:
        image, target: (h, w).
        top, left: of what the tile looks at, may be beyond the border.
    """
    height, width = image.shape
    first, last = max(0, left), min(width, left + _WIDTH)
    for line in range(max(0, top), min(height, top + _HEIGHT)):
        x, y = image[line, first:last], target[line, first:last]
        unlike = 0
        for c in range(len(x)):
            unlike |= x[c] != y[c]
        if unlike:
            return False
    return True


@njit(**_COMPILE)
def _load(tile, image, target, top, left):
    """Copy what a tile looks at; blank beyond the border."""
    height, width = image.shape
    if top < 0 or left < 0 or top + _HEIGHT > height or left + _WIDTH > width:
        tile[:] = _ZERO
    first, last = max(0, -left), min(_WIDTH, width - left)
    for line in range(max(0, -top), min(_HEIGHT, height - top)):
        x = image[top + line, left + first : left + last]
        y = target[top + line, left + first : left + last]
        at = np.uint64(line * _WIDTH + first)
        for c in range(np.uint64(last - first)):
            tile[at + c + _IMAGE] = x[c]
            tile[at + c + _TARGET] = y[c]


@njit(**_COMPILE)
def _similar(tile, means, variances, top, left):
    """Sum of a tile's own similarities; leaves the gradients to the blurred images there."""
    height, width = means.shape
    low, high = max(_HALF, -top), min(_HEIGHT - _HALF, height - top)
    first, last = max(_HALF, -left), min(_WIDTH - _HALF, width - left)
    to_mean, to_square, to_product = _LINES
    total: float | np.floating = 0.0
    for line in range(low, high):
        at = np.uint64((line - _HALF) * _WIDTH)
        for c in range(np.uint64(_WIDTH)):
            mean, square, product = _moments(tile, at + c)
            tile[to_mean + c] = mean
            tile[to_square + c] = square
            tile[to_product + c] = product
        mean_y = means[top + line, left + first : left + last]
        variance_y = variances[top + line, left + first : left + last]
        item = _ROUND <= line < _HEIGHT - _ROUND
        before, after = np.uint64(_ROUND - first), np.uint64(_WIDTH - _ROUND - first)
        at = np.uint64(line * _WIDTH + first)
        begin = np.uint64(first - _HALF)
        line_total = _ZERO
        for c in range(np.uint64(last - first)):
            x, y = _weighed(tile, to_mean + begin + c, np.uint64(1)), mean_y[c]
            variance = _weighed(tile, to_square + begin + c, np.uint64(1)) - x * x
            covariance = _weighed(tile, to_product + begin + c, np.uint64(1)) - x * y
            a1, a2 = _TWO * x * y + _SINGLE_C1, _TWO * covariance + _SINGLE_C2
            b1 = x * x + y * y + _SINGLE_C1
            b2 = variance + variance_y[c] + _SINGLE_C2
            share = _ONE / (b1 * b2)
            value = a1 * a2 * share
            line_total += value if before <= c < after else _ZERO
            slope = -value * b1 * share
            along = _TWO * a1 * share
            tile[at + c + _TO_PRODUCT] = along
            tile[at + c + _TO_SQUARE] = slope
            # The mean also enters through the variance and the covariance.
            direct = _TWO * y * a2 * share - _TWO * value * x * b2 * share
            tile[at + c + _TO_MEAN] = direct - _TWO * x * slope - y * along
        if item:
            total += line_total
    return total


@njit(**_COMPILE)
def _spread(tile, gradient, top, left, scale):
    """The gradient to a tile's own pixels."""
    height, width = gradient.shape
    high, last = min(_HEIGHT - _ROUND, height - top), min(_WIDTH - _ROUND, width - left)
    to_mean, to_square, to_product = _LINES
    for line in range(_ROUND, high):
        at = np.uint64((line - _HALF) * _WIDTH)
        for c in range(np.uint64(_WIDTH)):
            tile[to_mean + c] = _weighed(tile, at + c + _TO_MEAN, _STEP)
            tile[to_square + c] = _weighed(tile, at + c + _TO_SQUARE, _STEP)
            tile[to_product + c] = _weighed(tile, at + c + _TO_PRODUCT, _STEP)
        at = np.uint64(line * _WIDTH + _ROUND)
        out = gradient[top + line, left + _ROUND : left + last]
        begin = np.uint64(_ROUND - _HALF)
        for c in range(np.uint64(last - _ROUND)):
            first = _weighed(tile, to_mean + begin + c, np.uint64(1))
            second = _weighed(tile, to_square + begin + c, np.uint64(1))
            third = _weighed(tile, to_product + begin + c, np.uint64(1))
            x, y = tile[at + c + _IMAGE], tile[at + c + _TARGET]
            out[c] = scale * (first + _TWO * x * second + y * third)


def tile_count(shape: tuple[int, ...]) -> int:
    """How many tiles (n, h, w) images have."""
    count, height, width = shape
    return count * -(-height // ROWS) * -(-width // COLUMNS)


@njit(parallel=True, **_COMPILE)
def similarities(images, targets, means, variances, gradients, sums):
    """Sums of the similarities of each tile's pixels, and the gradient of the mean of all.

    Args:
        images, targets: (n, h, w) float32.
        means, variances: (n, h, w) of the targets, blurred.
        gradients: (n, h, w) zeros, gets the gradient to the images.
        sums: (tiles,) float64, gets the sums.
    """
    height, width = images.shape[1:]
    down, across = -(-height // ROWS), -(-width // COLUMNS)
    scale = np.float32(1.0 / images.size)
    for part in prange(PARTS):
        tile = np.zeros(_SCRATCH, dtype=np.float32)
        for index in range(part, len(sums), PARTS):
            n, place = divmod(index, down * across)
            row, column = divmod(place, across)
            top, left = row * ROWS - _ROUND, column * COLUMNS - _ROUND
            if _alike(images[n], targets[n], top, left):
                items = min(ROWS, height - row * ROWS), min(COLUMNS, width - column * COLUMNS)
                sums[index] = items[0] * items[1]
            else:
                _load(tile, images[n], targets[n], top, left)
                sums[index] = _similar(tile, means[n], variances[n], top, left)
                _spread(tile, gradients[n], top, left, scale)
