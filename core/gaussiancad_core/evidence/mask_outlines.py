"""Outlines of masks: signed distances to them in millimetres, and their straight parts.

Masks lie on the pixels of a view; an outline runs between the centres of the pixels inside and
outside.  Everything here works on masks with a border of ``PAD_PX`` pixels, so that distances are
right up to the outline even where the part reaches the end of the view's own mask.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import View

PAD_PX = 4
"""Border around a mask, in pixels."""

_TOUCH_PX = 1.25
"""An outline that comes this near to a side of the box lies in it: a mask is whole pixels, and its
grid begins some of them before a side, from which it may be one away but for rounding."""

_STRAIGHT = 0.04
"""Shortest straight part of an outline that counts as one, as a share of the mask's longer side."""

Mask = npt.NDArray[np.bool_]
Field = npt.NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class PlaneField:
    """Values at pixels of a view's plane, interpolated in between.

    Attributes:
        values: (h, w) float32 at the pixels' centres; two each way at least.
        origin: (right, up) in mm of the upper left corner of the first pixel.
        mm_per_pixel: size of a pixel.
    """

    values: Field
    origin: tuple[float, float]
    mm_per_pixel: float

    def at(self, points: npt.NDArray[np.float64]) -> Field:
        """(n, 2) (right, up) in mm -> (n,) values, bilinear; beyond the border as on the border."""
        pixels = (points - np.array(self.origin)) / self.mm_per_pixel * np.array([1.0, -1.0]) - 0.5
        height, width = self.values.shape
        x = np.clip(pixels[:, 0], 0.0, width - 1.0)
        y = np.clip(pixels[:, 1], 0.0, height - 1.0)
        column = np.minimum(x.astype(np.int64), width - 2)
        row = np.minimum(y.astype(np.int64), height - 2)
        right, down = (x - column).astype(np.float32), (y - row).astype(np.float32)
        upper = self.values[row, column] * (1 - right) + self.values[row, column + 1] * right
        lower = (
            self.values[row + 1, column] * (1 - right) + self.values[row + 1, column + 1] * right
        )
        return upper * (1 - down) + lower * down


def padded_mask(view: View, size: tuple[float, float, float], to_box: bool) -> Mask:
    """The view's mask with its border.

    Args:
        view: holds the mask.
        size: (3,) extent of the part in mm.
        to_box: whether a mask that ends about a pixel before a side of the box goes on beyond
            that side: the box is known better than the pixels are.
    """
    mask = np.pad(view.mask, PAD_PX)
    if not to_box or not mask.any():
        return mask
    for array_axis, index in ((1, 0), (0, 1)):
        low, high = _box_pixels(view, size, index)
        lines = np.moveaxis(mask, array_axis, 0)
        filled = np.flatnonzero(lines.any(axis=1))
        first, last = filled[0], filled[-1]
        if abs(first - low) <= _TOUCH_PX:
            lines[:first] = lines[first]
        if abs(last + 1 - high) <= _TOUCH_PX:
            lines[last + 1 :] = lines[last]
    return mask


def signed_distance(mask: Mask, mm_per_pixel: float) -> Field:
    """(h, w) distance of each pixel's centre from the outline in mm, negative inside.

    Exact Euclidean between pixel centres, less the half pixel to the outline.
    """
    inside = mask.astype(np.uint8)
    outer = cv2.distanceTransform(1 - inside, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    inner = cv2.distanceTransform(inside, cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    pixels = np.where(mask, np.float32(0.5) - inner, outer - np.float32(0.5))
    # A mask without an outline is infinitely far from it; half of the largest number still adds.
    largest = np.float32(np.hypot(*mask.shape))
    return np.clip(pixels, -largest, largest) * np.float32(mm_per_pixel)


def plane_field(values: Field, view: View, corner: tuple[int, int] = (0, 0)) -> PlaneField:
    """Values on the pixels of a padded mask, or of a part of it that starts at (row, column)."""
    row, column = corner[0] - PAD_PX, corner[1] - PAD_PX
    origin = (
        view.origin[0] + column * view.mm_per_pixel,
        view.origin[1] - row * view.mm_per_pixel,
    )
    return PlaneField(values, origin, view.mm_per_pixel)


def straight_parts(mask: Mask, view: View, axis: Axis) -> list[float]:
    """Coordinates in mm on ``axis`` of the straight parts of an outline that stand across it.

    Args:
        mask: padded.
        view: on whose pixels it lies.
        axis: a view that looks along it knows nothing of it.
    """
    frame = view.role.frame
    for index, (this_axis, sign) in enumerate((frame.right_axis, frame.up_axis)):
        if this_axis is axis:
            lines = np.moveaxis(mask, 1 - index, 0)
            changes = (lines[1:] != lines[:-1]).sum(axis=1)
            borders = np.flatnonzero(changes >= _STRAIGHT * max(mask.shape)) + 1 - PAD_PX
            along = view.origin[index] + borders * view.mm_per_pixel * (1.0, -1.0)[index]
            return [float(value) for value in along * sign]
    return []


def _box_pixels(view: View, size: tuple[float, float, float], index: int) -> tuple[float, float]:
    """Where the box's two sides lie along x (0) or y (1) in pixels of the padded mask."""
    frame = view.role.frame
    axis, sign = (frame.right_axis, frame.up_axis)[index]
    ends = np.zeros((2, 2))
    ends[1, index] = sign * size[axis.value]
    low, high = sorted(view.to_pixels(ends)[:, index] + PAD_PX)
    return float(low), float(high)
