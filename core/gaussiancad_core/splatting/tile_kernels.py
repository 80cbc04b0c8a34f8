"""Sorting Gaussians into tiles, compositing them, and the gradient of that, compiled.

A tile is a small rectangle of pixels that one thread composites from front to back, so that no two
threads write to one place.  In the backward pass each (Gaussian, tile) pair has a slot of its own;
the slots are added up in a fixed order.  So the result does not depend on the number of threads.

The gradient also runs from front to back.  With ``v`` the upstream gradient's product with a
Gaussian's colour, one and depth, and ``w = a T`` its weight, the loss changes with its alpha by
``T v - (rest behind) / (1 - a)``, where the rest behind is the pixel's total of ``w v``, known from
the image itself, less what was met so far.
"""

import math

import numpy as np
from numba import njit, prange, types
from numba.extending import overload

TILE_WIDTH = 16
TILE_HEIGHT = 8

SLOT_FIELDS = 10
"""Gradients kept for a (Gaussian, tile) pair: mean 2, conic 3, opacity, depth, colour 3."""

_CHECK_EVERY = 16
"""Gaussians between two looks whether a tile is opaque all over."""

_COMPILE = {"fastmath": True, "error_model": "numpy", "cache": True}

_LOG2_E = np.float32(math.log2(math.e))
_SERIES = tuple(np.float32(math.log(2.0) ** k / math.factorial(k)) for k in range(7))
_LOWEST = np.float32(-86.0)
_HALF = np.float32(0.5)
_BIAS = np.int32(127)
_MANTISSA = np.int32(23)


@njit(inline="always", **_COMPILE)
def _exp_single(x):  # noqa: ANN001, ANN202
    """exp of a float32 that is not positive, to about 2e-7; unlike libm's it becomes SIMD code."""
    scaled = max(x, _LOWEST) * _LOG2_E
    whole = np.int32(scaled - _HALF)
    rest = scaled - np.float32(whole)
    c0, c1, c2, c3, c4, c5, c6 = _SERIES
    power = (((((c6 * rest + c5) * rest + c4) * rest + c3) * rest + c2) * rest + c1) * rest + c0
    return power * np.int32((whole + _BIAS) << _MANTISSA).view(np.float32)


def _exp(x: float) -> float:
    return math.exp(x)


@overload(_exp, inline="always")
def _exp_for(x):  # noqa: ANN001, ANN202
    if x == types.float32:
        return lambda x: _exp_single(x)
    return lambda x: math.exp(x)


@njit(parallel=True, **_COMPILE)
def find_boxes(
    size, means, covariances, opacities, smallest_alpha, boxes, counts
):  # noqa: ANN001, ANN201
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
            if not (x + half_x >= 0 and x - half_x <= width and y + half_y >= 0 and y - half_y <= height):
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
def fill_tiles(
    grid, order, boxes, counts, first_slots, starts, members, slots
):  # noqa: ANN001, ANN201
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


@njit(inline="always", **_COMPILE)
def _clearest(left):  # noqa: ANN001, ANN202
    """The largest transmittance in a tile."""
    largest = left[0, 0]
    for r in range(TILE_HEIGHT):
        for x in range(TILE_WIDTH):
            largest = max(largest, left[r, x])
    return largest


@njit(**_COMPILE)
def _composite(
    left, sums, weights, columns, rows, offset, conic, opacity, limits, features
):  # noqa: ANN001, ANN202
    """Add one Gaussian to a tile: its weights times colour and depth, and what it leaves."""
    smallest_alpha, largest_alpha, smallest_left = limits
    half = opacity * 0 + np.float32(0.5)
    xx, xy, yy = half * conic[0], conic[1], half * conic[2]
    red, green, blue, depth = features
    for r in range(rows[0], rows[1]):
        dy = offset[1] + np.float32(r)
        linear, constant = xy * dy, yy * dy * dy
        for x in range(TILE_WIDTH):
            dx = offset[0] + columns[x]
            alpha = min(opacity * _exp(-((xx * dx + linear) * dx + constant)), largest_alpha)
            before = left[r, x]
            drawn = (alpha >= smallest_alpha) & (before > smallest_left)
            weight = alpha * before if drawn else alpha * 0
            weights[x] = weight
            left[r, x] = before - weight
        for x in range(TILE_WIDTH):
            sums[0, r, x] += weights[x] * red
            sums[1, r, x] += weights[x] * green
            sums[2, r, x] += weights[x] * blue
            sums[3, r, x] += weights[x] * depth


@njit(parallel=True, **_COMPILE)
def composite_forward(
    size, grid, tiles, projected, opacities, palette, limits, images
):  # noqa: ANN001, ANN201
    """Fill the images: colour (v, 3, h, w), alpha (v, h, w), depth (v, h, w)."""
    height, width = size
    lines, across = grid
    starts, members, boxes = tiles
    means, conics, depths = projected
    colours, alphas, depth_sums = images
    kind = means.dtype
    for index in prange(len(means) * lines * across):
        v = index // (lines * across)
        line = (index - v * lines * across) // across
        x0 = (index - (v * lines + line) * across) * TILE_WIDTH
        y0 = line * TILE_HEIGHT
        left = np.ones((TILE_HEIGHT, TILE_WIDTH), kind)
        sums = np.zeros((4, TILE_HEIGHT, TILE_WIDTH), kind)
        weights = np.empty(TILE_WIDTH, kind)
        columns = np.arange(TILE_WIDTH).astype(kind)
        for k in range(starts[index], starts[index + 1]):
            if (k - starts[index]) % _CHECK_EVERY == _CHECK_EVERY - 1 and _clearest(left) <= limits[2]:
                break
            g = members[k]
            rows = (max(0, boxes[v, g, 2] - y0), min(TILE_HEIGHT, boxes[v, g, 3] - y0 + 1))
            offset = (_centre(x0, means[v, g, 0]), _centre(y0, means[v, g, 1]))
            features = (palette[g, 0], palette[g, 1], palette[g, 2], depths[v, g])
            _composite(
                left, sums, weights, columns, rows, offset, conics[v, g], opacities[g], limits, features
            )
        for r in range(min(TILE_HEIGHT, height - y0)):
            for x in range(min(TILE_WIDTH, width - x0)):
                for c in range(3):
                    colours[v, c, y0 + r, x0 + x] = sums[c, r, x]
                alphas[v, y0 + r, x0 + x] = 1 - left[r, x]
                depth_sums[v, y0 + r, x0 + x] = sums[3, r, x]


@njit(inline="always", **_COMPILE)
def _centre(pixel, mean):  # noqa: ANN001, ANN202
    """From a mean to the centre of a pixel, in the mean's precision."""
    return np.float32(pixel) + np.float32(0.5) - mean


@njit(**_COMPILE)
def _composite_gradient(
    state, upstream, scratch, columns, rows, offset, conic, opacity, limits, features, slot
):  # noqa: ANN001, ANN202
    """Gradients that one tile gives to one Gaussian, written to its slot."""
    left, met, totals = state
    weights, values = scratch
    smallest_alpha, largest_alpha, smallest_left = limits
    red, green, blue, depth = features
    zero = opacity * 0
    half = zero + np.float32(0.5)
    xx, xy, yy = half * conic[0], conic[1], half * conic[2]
    sum_1, sum_x, sum_xx, sum_y, sum_yy, sum_xy = zero, zero, zero, zero, zero, zero
    to_depth, to_red, to_green, to_blue = zero, zero, zero, zero
    for r in range(rows[0], rows[1]):
        dy = offset[1] + np.float32(r)
        linear, constant = xy * dy, yy * dy * dy
        for x in range(TILE_WIDTH):
            values[x] = (
                red * upstream[0, r, x]
                + green * upstream[1, r, x]
                + blue * upstream[2, r, x]
                + depth * upstream[3, r, x]
                + upstream[4, r, x]
            )
        row_1, row_x, row_xx = zero, zero, zero
        for x in range(TILE_WIDTH):
            dx = offset[0] + columns[x]
            free = opacity * _exp(-((xx * dx + linear) * dx + constant))
            alpha = min(free, largest_alpha)
            before = left[r, x]
            drawn = (alpha >= smallest_alpha) & (before > smallest_left)
            weight = alpha * before if drawn else zero
            weights[x] = weight
            left[r, x] = before - weight
            value = values[x]
            so_far = met[r, x] + weight * value
            met[r, x] = so_far
            to_alpha = before * value - (totals[r, x] - so_far) / (1 - alpha)
            to_exponent = to_alpha * alpha if drawn & (free <= largest_alpha) else zero
            row_1 += to_exponent
            row_x += to_exponent * dx
            row_xx += to_exponent * dx * dx
        for x in range(TILE_WIDTH):
            to_red += weights[x] * upstream[0, r, x]
            to_green += weights[x] * upstream[1, r, x]
            to_blue += weights[x] * upstream[2, r, x]
            to_depth += weights[x] * upstream[3, r, x]
        sum_1 += row_1
        sum_x += row_x
        sum_xx += row_xx
        sum_y += row_1 * dy
        sum_yy += row_1 * dy * dy
        sum_xy += row_x * dy
    slot[0] = conic[0] * sum_x + conic[1] * sum_y
    slot[1] = conic[1] * sum_x + conic[2] * sum_y
    slot[2] = -half * sum_xx
    slot[3] = -sum_xy
    slot[4] = -half * sum_yy
    slot[5] = sum_1 / opacity
    slot[6] = to_depth
    slot[7] = to_red
    slot[8] = to_green
    slot[9] = to_blue


@njit(parallel=True, **_COMPILE)
def composite_backward(
    size, grid, tiles, slots, projected, opacities, palette, limits, images, upstream, gradients
):  # noqa: ANN001, ANN201
    """Fill the (pairs, SLOT_FIELDS) gradients of all (Gaussian, tile) pairs."""
    height, width = size
    lines, across = grid
    starts, members, boxes = tiles
    means, conics, depths = projected
    kind = means.dtype
    for index in prange(len(means) * lines * across):
        if starts[index] == starts[index + 1]:
            continue
        v = index // (lines * across)
        line = (index - v * lines * across) // across
        x0 = (index - (v * lines + line) * across) * TILE_WIDTH
        y0 = line * TILE_HEIGHT
        left = np.ones((TILE_HEIGHT, TILE_WIDTH), kind)
        met = np.zeros((TILE_HEIGHT, TILE_WIDTH), kind)
        totals = np.zeros((TILE_HEIGHT, TILE_WIDTH), kind)
        above = np.zeros((5, TILE_HEIGHT, TILE_WIDTH), kind)
        scratch = (np.empty(TILE_WIDTH, kind), np.empty(TILE_WIDTH, kind))
        columns = np.arange(TILE_WIDTH).astype(kind)
        for r in range(min(TILE_HEIGHT, height - y0)):
            for x in range(min(TILE_WIDTH, width - x0)):
                row, column = y0 + r, x0 + x
                for c in range(3):
                    above[c, r, x] = upstream[0][v, c, row, column]
                    totals[r, x] += above[c, r, x] * images[0][v, c, row, column]
                above[3, r, x] = upstream[2][v, row, column]
                above[4, r, x] = upstream[1][v, row, column]
                totals[r, x] += above[3, r, x] * images[2][v, row, column]
                totals[r, x] += above[4, r, x] * images[1][v, row, column]
        opaque = False
        for k in range(starts[index], starts[index + 1]):
            if (k - starts[index]) % _CHECK_EVERY == _CHECK_EVERY - 1 and not opaque:
                opaque = _clearest(left) <= limits[2]
            if opaque:
                gradients[slots[k], :] = 0
                continue
            g = members[k]
            rows = (max(0, boxes[v, g, 2] - y0), min(TILE_HEIGHT, boxes[v, g, 3] - y0 + 1))
            offset = (_centre(x0, means[v, g, 0]), _centre(y0, means[v, g, 1]))
            features = (palette[g, 0], palette[g, 1], palette[g, 2], depths[v, g])
            _composite_gradient(
                (left, met, totals),
                above,
                scratch,
                columns,
                rows,
                offset,
                conics[v, g],
                opacities[g],
                limits,
                features,
                gradients[slots[k]],
            )


@njit(parallel=True, **_COMPILE)
def add_slots(counts, first_slots, gradients, upstream, opacities, colours):  # noqa: ANN001, ANN201
    """Sum the slots of each Gaussian: per view for the projection, over all views for the rest."""
    to_means, to_conics, to_depths = upstream
    views, number = counts.shape
    for i in prange(number):
        opacities[i] = 0
        colours[i, :] = 0
        for v in range(views):
            to_means[v, i, :] = 0
            to_conics[v, i, :] = 0
            to_depths[v, i] = 0
            for s in range(first_slots[v, i], first_slots[v, i] + counts[v, i]):
                for k in range(2):
                    to_means[v, i, k] += gradients[s, k]
                for k in range(3):
                    to_conics[v, i, k] += gradients[s, 2 + k]
                    colours[i, k] += gradients[s, 7 + k]
                opacities[i] += gradients[s, 5]
                to_depths[v, i] += gradients[s, 6]
