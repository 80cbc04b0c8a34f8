"""Points on the centre lines of strokes, to a fraction of a pixel (Steger 1998).

The ink is smoothed by a Gaussian about as wide as the strokes.  Where its second derivative across
a stroke is strongly negative, the logarithm of the stroke's profile is a parabola, and its top is
the point.  Nothing is thresholded, so that thin and pale lines keep their place.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

_LEAST_INK = 0.15
"""Smoothed ink, as a share of full ink, under which nothing is a stroke."""

_LEAST_CURVATURE = 0.05
"""Share of full ink per px^2 by which the profile must fall off across a stroke, at sigma 1."""

_FLOOR = 0.02
"""Smoothed ink under which its logarithm would say more of the paper than of the stroke."""

_FARTHEST = 0.7
"""px from the pixel's centre to the top of its parabola: beyond, a neighbour has the point."""


@dataclass(frozen=True, eq=False)
class RidgePoints:
    """Points on centre lines, at most one a pixel.

    Attributes:
        points: (n, 2) x, y in px, centres of pixels at integers.
        tangents: (n, 2) unit vectors along the strokes, their sign arbitrary.
        index: (h, w) int32, the row of a pixel's point, -1 where there is none.
    """

    points: Floats
    tangents: Floats
    index: npt.NDArray[np.int32]


def ridge_points(weight: npt.NDArray[np.float32], stroke_width: float) -> RidgePoints:
    """Find the points on the centre lines of an image of ink.

    Args:
        weight: (h, w) float32, ink from 0 to 1.
        stroke_width: px, of the strokes looked for; those up to twice as wide are found as well.
    """
    # Under width / sqrt(12) the two edges of a stroke become two ridges.
    return _ridge_points(weight, max(1.1, 0.42 * stroke_width))


def fine_ridge_points(weight: npt.NDArray[np.float32], stroke_width: float) -> RidgePoints:
    """The same with as little smoothing as strokes of a width in px allow: those that nearly touch
    stay apart, and wider ones may become two."""
    return _ridge_points(weight, max(0.8, 0.31 * stroke_width))


def _ridge_points(weight: npt.NDArray[np.float32], sigma: float) -> RidgePoints:
    smooth = np.asarray(cv2.GaussianBlur(weight, (0, 0), sigma), dtype=np.float32)
    candidates = smooth > _LEAST_INK
    ys, xs = np.nonzero(candidates)
    inner = (ys > 0) & (xs > 0) & (ys < weight.shape[0] - 1) & (xs < weight.shape[1] - 1)
    ys, xs = ys[inner], xs[inner]
    curvature, _ = _strongest(*_derivatives(smooth, xs, ys)[2:])
    # A smoothed stroke is nearly a Gaussian across, and its logarithm a parabola everywhere: its
    # differences give the top exactly, those of the stroke itself to a tenth of a pixel.
    gx, gy, *hessian = _derivatives(np.log(np.maximum(smooth, _FLOOR)), xs, ys)
    bend, angle = _strongest(*hessian)
    nx, ny = np.cos(angle), np.sin(angle)
    with np.errstate(divide="ignore", invalid="ignore"):
        top = -(gx * nx + gy * ny) / bend
    near = np.abs(top) * np.maximum(np.abs(nx), np.abs(ny)) <= _FARTHEST
    found = (curvature < -_LEAST_CURVATURE / sigma**2) & near
    xs, ys, nx, ny, top = xs[found], ys[found], nx[found], ny[found], top[found]
    index = np.full(weight.shape, -1, dtype=np.int32)
    index[ys, xs] = np.arange(len(xs), dtype=np.int32)
    points = np.stack([xs + top * nx, ys + top * ny], axis=1)
    return RidgePoints(points, np.stack([-ny, nx], axis=1), index)


def _strongest(xx: Floats, xy: Floats, yy: Floats) -> tuple[Floats, Floats]:
    """The more negative eigenvalue of Hessians and the angle of its vector, (n,) each."""
    half_trace, half_difference = (xx + yy) / 2, (xx - yy) / 2
    angle = 0.5 * np.arctan2(-2 * xy, -2 * half_difference)
    return half_trace - np.hypot(half_difference, xy), angle


def _derivatives(
    smooth: npt.NDArray[np.float32], xs: npt.NDArray[np.int64], ys: npt.NDArray[np.int64]
) -> tuple[Floats, ...]:
    """First and second derivatives at pixels that are not on the border, each (n,)."""

    def at(dx: int, dy: int) -> Floats:
        return smooth[ys + dy, xs + dx].astype(np.float64)

    here, east, west, south, north = at(0, 0), at(1, 0), at(-1, 0), at(0, 1), at(0, -1)
    xy = (at(1, 1) - at(-1, 1) - at(1, -1) + at(-1, -1)) / 4
    return (
        (east - west) / 2,
        (south - north) / 2,
        east - 2 * here + west,
        xy,
        south - 2 * here + north,
    )
