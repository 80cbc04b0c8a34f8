# Compiled functions get their types from the arrays they are called with.
# ruff: noqa: ANN001, ANN201, ANN202, PLR0917, PLR0912, PLR0915
"""Projection of all Gaussians into all views and its gradient, compiled.

The formulas are those of :mod:`.projection`; here they are written out, so that forward and
backward take well under a millisecond instead of the ten that torch needs for 5,000 Gaussians.
Arrays are float32 or float64 throughout.
"""

import math
from typing import Any

import numpy as np
from numba import njit, prange

_RUNS = 48
"""Runs of Gaussians that the threads share out; each has scratch arrays of its own, since to make
them anew for every Gaussian takes longer than the work."""

_COMPILE: dict[str, Any] = {"fastmath": True, "error_model": "numpy", "cache": True}


@njit(**_COMPILE)
def _rotation(quaternion, matrix):
    """Fill a (3, 3) matrix from a quaternion of any length; return the length's inverse."""
    w, x, y, z = quaternion[0], quaternion[1], quaternion[2], quaternion[3]
    inverse = 1 / math.sqrt(w * w + x * x + y * y + z * z)
    w *= inverse
    x *= inverse
    y *= inverse
    z *= inverse
    matrix[0, 0] = 1 - 2 * (y * y + z * z)
    matrix[0, 1] = 2 * (x * y - w * z)
    matrix[0, 2] = 2 * (x * z + w * y)
    matrix[1, 0] = 2 * (x * y + w * z)
    matrix[1, 1] = 1 - 2 * (x * x + z * z)
    matrix[1, 2] = 2 * (y * z - w * x)
    matrix[2, 0] = 2 * (x * z - w * y)
    matrix[2, 1] = 2 * (y * z + w * x)
    matrix[2, 2] = 1 - 2 * (x * x + y * y)
    return inverse


@njit(**_COMPILE)
def _rotation_gradient(quaternion, inverse, upstream, gradient):
    """Gradient of a quaternion from the (3, 3) gradient of its matrix."""
    w, x, y, z = (
        quaternion[0] * inverse,
        quaternion[1] * inverse,
        quaternion[2] * inverse,
        quaternion[3] * inverse,
    )
    g = upstream
    gw = 2 * (x * (g[2, 1] - g[1, 2]) + y * (g[0, 2] - g[2, 0]) + z * (g[1, 0] - g[0, 1]))
    gx = 2 * (
        w * (g[2, 1] - g[1, 2])
        + y * (g[0, 1] + g[1, 0])
        + z * (g[0, 2] + g[2, 0])
        - 2 * x * (g[1, 1] + g[2, 2])
    )
    gy = 2 * (
        w * (g[0, 2] - g[2, 0])
        + x * (g[0, 1] + g[1, 0])
        + z * (g[1, 2] + g[2, 1])
        - 2 * y * (g[0, 0] + g[2, 2])
    )
    gz = 2 * (
        w * (g[1, 0] - g[0, 1])
        + x * (g[0, 2] + g[2, 0])
        + y * (g[1, 2] + g[2, 1])
        - 2 * z * (g[0, 0] + g[1, 1])
    )
    # The length of a quaternion does not matter: no gradient along it.
    along = w * gw + x * gx + y * gy + z * gz
    gradient[0] = (gw - w * along) * inverse
    gradient[1] = (gx - x * along) * inverse
    gradient[2] = (gy - y * along) * inverse
    gradient[3] = (gz - z * along) * inverse


@njit(**_COMPILE)
def _image_rows(pinhole, rotation, focal, local, limit, rows, slope):
    """Rows of the map from the model to the image about a mean; the slopes it was taken at."""
    if pinhole:
        inverse = 1 / local[2]
        for k in range(2):
            slope[k] = min(max(local[k] * inverse, -limit[k]), limit[k])
            for j in range(3):
                rows[k, j] = focal[k] * inverse * (rotation[k, j] - slope[k] * rotation[2, j])
    else:
        for k in range(2):
            for j in range(3):
                rows[k, j] = focal[k] * rotation[k, j]


@njit(inline="always", **_COMPILE)
def _run_of(number, run):
    """First and last Gaussian (exclusive) of a run."""
    return number * run // _RUNS, number * (run + 1) // _RUNS


@njit(parallel=True, **_COMPILE)
def project_forward(gaussians, cameras, pinhole, nearest, dilation, projected):
    """Fill the (v, n, ...) arrays of means, covariances, conics and depths.

    A Gaussian nearer than ``nearest`` gets a covariance of zero: it is not drawn.
    """
    for run in prange(_RUNS):
        part = _run_of(len(gaussians[0]), run)
        _project_run(part, gaussians, cameras, pinhole, nearest, dilation, projected)


@njit(**_COMPILE)
def _project_run(part, gaussians, cameras, pinhole, nearest, dilation, projected):
    means, covariances, conics, depths = projected
    centres, quaternions, log_scales = gaussians
    rotations, translations, focals, principals, limits = cameras
    axes = np.empty((3, 3), centres.dtype)
    rows = np.empty((2, 3), centres.dtype)
    local = np.empty(3, centres.dtype)
    slope = np.empty(2, centres.dtype)
    for i in range(part[0], part[1]):
        _rotation(quaternions[i], axes)
        for k in range(3):
            scale = math.exp(log_scales[i, k])
            for j in range(3):
                axes[j, k] *= scale
        for v in range(len(rotations)):
            r = rotations[v]
            for k in range(3):
                local[k] = translations[v, k]
                for j in range(3):
                    local[k] += r[k, j] * centres[i, j]
            depths[v, i] = local[2]
            if local[2] <= nearest:
                covariances[v, i, :] = 0
                conics[v, i, :] = 0
                means[v, i, :] = 0
                continue
            _image_rows(pinhole, r, focals[v], local, limits[v], rows, slope)
            for k in range(2):
                plane = local[k] / local[2] if pinhole else local[k]
                means[v, i, k] = plane * focals[v, k] + principals[v, k]
            xx = dilation
            xy = dilation * 0
            yy = dilation
            for k in range(3):
                a = rows[0, 0] * axes[0, k] + rows[0, 1] * axes[1, k] + rows[0, 2] * axes[2, k]
                b = rows[1, 0] * axes[0, k] + rows[1, 1] * axes[1, k] + rows[1, 2] * axes[2, k]
                xx += a * a
                xy += a * b
                yy += b * b
            inverse = 1 / (xx * yy - xy * xy)
            covariances[v, i, 0] = xx
            covariances[v, i, 1] = xy
            covariances[v, i, 2] = yy
            conics[v, i, 0] = yy * inverse
            conics[v, i, 1] = -xy * inverse
            conics[v, i, 2] = xx * inverse


@njit(parallel=True, **_COMPILE)
def project_backward(gaussians, cameras, pinhole, nearest, conics, depths, upstream, gradients):
    """Gradients of centres, quaternions and log scales from those of the projection.

    ``upstream`` holds the gradients of means (v, n, 2), conics (v, n, 3; the mixed term counted
    once) and depths (v, n).
    """
    for run in prange(_RUNS):
        part = _run_of(len(gaussians[0]), run)
        _differentiate_run(
            part, gaussians, cameras, pinhole, nearest, conics, depths, upstream, gradients
        )


@njit(**_COMPILE)
def _differentiate_run(
    part, gaussians, cameras, pinhole, nearest, conics, depths, upstream, gradients
):
    centres, quaternions, log_scales = gaussians
    rotations, translations, focals, _principals, limits = cameras
    to_means, to_conics, to_depths = upstream
    centre_gradient, quaternion_gradient, scale_gradient = gradients
    turn = np.empty((3, 3), centres.dtype)
    axes = np.empty((3, 3), centres.dtype)
    to_axes = np.empty((3, 3), centres.dtype)
    rows = np.empty((2, 3), centres.dtype)
    to_rows = np.empty((2, 3), centres.dtype)
    local = np.empty(3, centres.dtype)
    to_local = np.empty(3, centres.dtype)
    slope = np.empty(2, centres.dtype)
    scales = np.empty(3, centres.dtype)
    for i in range(part[0], part[1]):
        to_axes[:] = 0
        inverse = _rotation(quaternions[i], turn)
        for k in range(3):
            scales[k] = math.exp(log_scales[i, k])
            centre_gradient[i, k] = 0
            for j in range(3):
                axes[j, k] = turn[j, k] * scales[k]
        for v in range(len(rotations)):
            if depths[v, i] <= nearest:
                continue
            r = rotations[v]
            for k in range(3):
                local[k] = translations[v, k]
                for j in range(3):
                    local[k] += r[k, j] * centres[i, j]
            _image_rows(pinhole, r, focals[v], local, limits[v], rows, slope)
            # The gradient of an inverse: -K G K.
            p, q, s = conics[v, i, 0], conics[v, i, 1], conics[v, i, 2]
            gp, gq, gs = to_conics[v, i, 0], to_conics[v, i, 1] / 2, to_conics[v, i, 2]
            left00, left01 = p * gp + q * gq, p * gq + q * gs
            left10, left11 = q * gp + s * gq, q * gq + s * gs
            h00 = -(left00 * p + left01 * q)
            h01 = -(left00 * q + left01 * s)
            h11 = -(left10 * q + left11 * s)
            to_rows[:] = 0
            for k in range(3):
                a = rows[0, 0] * axes[0, k] + rows[0, 1] * axes[1, k] + rows[0, 2] * axes[2, k]
                b = rows[1, 0] * axes[0, k] + rows[1, 1] * axes[1, k] + rows[1, 2] * axes[2, k]
                ga = 2 * (h00 * a + h01 * b)
                gb = 2 * (h01 * a + h11 * b)
                for j in range(3):
                    to_axes[j, k] += ga * rows[0, j] + gb * rows[1, j]
                    to_rows[0, j] += ga * axes[j, k]
                    to_rows[1, j] += gb * axes[j, k]
            if pinhole:
                nearness = 1 / local[2]
                to_nearness = centres[i, 0] * 0
                for k in range(2):
                    plane = local[k] * nearness
                    to_plane = to_means[v, i, k] * focals[v, k]
                    for j in range(3):
                        to_nearness += rows[k, j] * to_rows[k, j] * local[2]
                        if abs(plane) <= limits[v, k]:
                            to_plane -= focals[v, k] * nearness * r[2, j] * to_rows[k, j]
                    to_local[k] = to_plane * nearness
                    to_nearness += to_plane * local[k]
                to_local[2] = to_depths[v, i] - nearness * nearness * to_nearness
            else:
                for k in range(2):
                    to_local[k] = to_means[v, i, k] * focals[v, k]
                to_local[2] = to_depths[v, i]
            for j in range(3):
                centre_gradient[i, j] += (
                    r[0, j] * to_local[0] + r[1, j] * to_local[1] + r[2, j] * to_local[2]
                )
        for k in range(3):
            along = centres[i, 0] * 0
            for j in range(3):
                along += axes[j, k] * to_axes[j, k]
                to_axes[j, k] *= scales[k]
            scale_gradient[i, k] = along
        _rotation_gradient(quaternions[i], inverse, to_axes, quaternion_gradient[i])
