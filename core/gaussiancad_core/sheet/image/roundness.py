"""Whether a picture of a drawing is as wide as it should be: by its circles.

Circles of a drawing that is stretched in one direction are ellipses, all of the same proportion.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.votes import HALF

Floats = npt.NDArray[np.float64]

_BLOCK, _CONTRAST = 41, 25
"""Side in px of the neighbourhood, and grey levels, by which ink is told from paper."""

_LEAST = 24.0
"""px across an ellipse, at least."""

_WANTED = 0.012
"""Root mean square distance from an ellipse, in its mean radius, of an outline that is one."""

_SHALLOW = 0.85
"""Shortest axis of a circle that is stretched a little, in its longest."""

_SAME = 0.006
"""Share by which proportions of circles differ, which the median of them bears."""


@dataclass(frozen=True)
class _Oval:
    centre: Floats
    radius: float
    proportion: float
    """Extent across by that down."""


def proportion(grey: npt.NDArray[np.uint8]) -> float | None:
    """How much wider than high the circles of a sheet are; None where no two of them agree.

    Args:
        grey: (h, w) uint8, dark ink on light paper, upright.
    """
    binary = cv2.adaptiveThreshold(
        grey, 255, cv2.ADAPTIVE_THRESH_GAUSSIAN_C, cv2.THRESH_BINARY_INV, _BLOCK, _CONTRAST
    )
    outlines, _ = cv2.findContours(binary, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    ovals = [oval for outline in outlines if (oval := _oval(outline.reshape(-1, 2))) is not None]
    if not ovals:
        return None
    values = np.array([this_oval.proportion for this_oval in ovals])
    radii = np.array([this_oval.radius for this_oval in ovals])
    # Most of the outline's length has about the proportion that is looked for.
    near = np.abs(np.log(values[:, None] / values)) < _SAME
    best = near[int(np.argmax(near @ radii))]
    chosen = [this_oval for this_oval, taken in zip(ovals, best, strict=True) if taken]
    if not _several(chosen) or radii[best].sum() < radii.sum() / 2:
        return None
    return float(np.exp(np.average(np.log(values[best]), weights=radii[best])))


def _oval(points: npt.NDArray[np.integer | np.floating]) -> _Oval | None:
    """The ellipse that an outline is, if it is one and nearly a circle."""
    extent = np.ptp(points, axis=0) if len(points) else np.zeros(2)
    if len(points) < 2.0 * _LEAST or extent.min() < _LEAST:
        return None
    if extent.min() < _SHALLOW * extent.max():
        return None
    (x, y), axes, degrees = cv2.fitEllipseDirect(points.astype(np.float32))
    if not np.all(np.isfinite([x, y, *axes])) or min(axes) < _SHALLOW * max(axes):
        return None
    turn = np.radians(degrees)
    along = np.array([np.cos(turn), np.sin(turn)])
    across = np.array([-np.sin(turn), np.cos(turn)])
    offset = points - np.array([x, y])
    scaled = np.hypot(offset @ along / (axes[0] / 2), offset @ across / (axes[1] / 2))
    if float(np.sqrt(np.mean((scaled - 1.0) ** 2))) > _WANTED + 0.5 / min(axes):
        return None
    half = np.hypot(along * axes[0], across * axes[1]) / 2
    return _Oval(np.array([x, y]), sum(axes) / 4, float(half[0] / half[1]))


def _several(ovals: list[_Oval]) -> bool:
    first = ovals[0]
    return any(
        np.hypot(*(oval.centre - first.centre)) > HALF * min(oval.radius, first.radius)
        for oval in ovals[1:]
    )
