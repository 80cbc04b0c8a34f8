# Compiled functions get their types from the arrays they are called with.
# ruff: noqa: ANN001, ANN201, ANN202, PLR0917
"""A rendering on its background, its distance from the targets and the gradient, compiled.

One pass over the lines of the images each way, where torch makes one for each operation.  Threads
take runs of lines that do not depend on their number, so that the sums do not either.
"""

import math
from typing import Any

import numpy as np
from numba import njit, prange

PARTS = 96
"""Runs of lines; a number that many numbers of threads divide."""

_COMPILE: dict[str, Any] = {"fastmath": True, "error_model": "numpy", "cache": True}

_ZERO, _ONE, _TWO = np.float32(0.0), np.float32(1.0), np.float32(2.0)
_LN_2 = np.float32(math.log(2.0))
_BELOW_ONE = np.int32(0x3F3504F3)
"""Bits of the square root of a half, from which on mantissas are counted."""
_MANTISSA = np.int32(23)
_ODD = tuple(np.float32(1.0 / k) for k in (3, 5, 7, 9))


@njit(inline="always", **_COMPILE)
def _log_single(x):
    """log of a positive normal float32, to about 2e-7; unlike libm's it becomes SIMD code."""
    exponent = (np.float32(x).view(np.int32) - _BELOW_ONE) >> _MANTISSA
    mantissa = np.int32(np.float32(x).view(np.int32) - (exponent << _MANTISSA)).view(np.float32)
    # The series of twice the inverse hyperbolic tangent, whose argument is at most 0.18.
    s = (mantissa - _ONE) / (mantissa + _ONE)
    square = s * s
    c3, c5, c7, c9 = _ODD
    series = (((c9 * square + c7) * square + c5) * square + c3) * square + _ONE
    return np.float32(exponent) * _LN_2 + _TWO * s * series


@njit(**_COMPILE)
def _compose(colour, alpha, target, behind, image):
    """Fill a line of one channel; sum of its distances from the target."""
    total = _ZERO
    for c in range(len(alpha)):
        x = colour[c] + (_ONE - alpha[c]) * behind
        image[c] = x
        total += abs(x - target[c])
    return total


@njit(**_COMPILE)
def _entropy(alpha, mask, margin):
    """Sum of a line's cross entropies."""
    total = _ZERO
    for c in range(len(alpha)):
        held = min(max(alpha[c], margin), _ONE - margin)
        total -= mask[c] * _log_single(held) + (_ONE - mask[c]) * _log_single(_ONE - held)
    return total


@njit(parallel=True, **_COMPILE)
def compare_forward(rendered, wanted, background, margin, images, sums):
    """Fill the images, and the sums over pixels for each run of lines.

    Args:
        rendered, wanted: colours (v, 3, h, w) and alphas (v, h, w); float32.
        background: (3,).
        margin: by which alphas are held from 0 and 1.
        images: (v, 3, h, w), gets the colours on the background.
        sums: (PARTS, 2) float64, gets the distances of the colours and the entropies of the masks.
    """
    (colours, alphas), (targets, masks) = rendered, wanted
    views, height, _ = alphas.shape
    lines = views * height
    for part in prange(PARTS):
        absolute, entropy = 0.0, 0.0
        for line in range(part * lines // PARTS, (part + 1) * lines // PARTS):
            v, row = line // height, line % height
            alpha = alphas[v, row]
            for channel in range(3):
                place = v, channel, row
                absolute += _compose(
                    colours[place], alpha, targets[place], background[channel], images[place]
                )
            entropy += _entropy(alpha, masks[v, row], margin)
        sums[part, 0], sums[part, 1] = absolute, entropy


@njit(**_COMPILE)
def _from_entropy(alpha, mask, margin, slope, to_alpha):
    """Fill a line of the gradient to the alphas with what the cross entropy gives."""
    for c in range(len(alpha)):
        held = min(max(alpha[c], margin), _ONE - margin)
        item = slope * (held - mask[c]) / (held * (_ONE - held))
        to_alpha[c] = item if held == alpha[c] else _ZERO


@njit(**_COMPILE)
def _from_image(image, target, upstream, slope, behind, to_colour, to_alpha):
    """Fill a line of the gradient to a channel, and add what it gives to the alphas."""
    for c in range(len(image)):
        away = image[c] - target[c]
        side = slope if away > _ZERO else -slope
        item = upstream[c] + (_ZERO if away == _ZERO else side)
        to_colour[c] = item
        to_alpha[c] -= behind * item


@njit(parallel=True, **_COMPILE)
def compare_backward(alphas, images, wanted, background, margin, upstream, gradients):
    """Fill the gradients to colours (v, 3, h, w) and alphas (v, h, w).

    Args:
        alphas, images, wanted, background, margin: as in :func:`compare_forward`.
        upstream: gradients to the images, to each distance and to each entropy.
        gradients: the two arrays.
    """
    (targets, masks), (to_images, to_distance, to_entropy) = wanted, upstream
    to_colours, to_alphas = gradients
    views, height, _ = alphas.shape
    lines = views * height
    for part in prange(PARTS):
        for line in range(part * lines // PARTS, (part + 1) * lines // PARTS):
            v, row = line // height, line % height
            to_alpha = to_alphas[v, row]
            _from_entropy(alphas[v, row], masks[v, row], margin, to_entropy, to_alpha)
            for channel in range(3):
                place = v, channel, row
                _from_image(
                    images[place],
                    targets[place],
                    to_images[place],
                    to_distance,
                    background[channel],
                    to_colours[place],
                    to_alpha,
                )
