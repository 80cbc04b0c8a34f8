"""The views' masks and colours as the cameras would see them.

A camera's image of the view's plane is the plane scaled and shifted along both axes: an
orthographic camera sees the plane itself, a pinhole the plane through the part's centre.  So
resampling splits into one matrix per axis, whose entries are the exact overlaps of pixels.
"""

import numpy as np
import numpy.typing as npt
import torch

from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.model.views import View, ViewSet
from gaussiancad_core.splatting.losses import Targets


def targets_of(views: ViewSet, cameras: tuple[Camera, ...]) -> Targets:
    """Resample each camera's view to the camera's pixels, averaged over their areas.

    Args:
        views: holds the role of each camera.
        cameras: of one image size.

    Returns:
        Colours and masks in the order of the cameras; white where the view shows nothing.
    """
    pairs = [_resampled(views[camera.role], camera) for camera in cameras]
    return Targets(
        colours=torch.from_numpy(np.stack([colours for colours, _ in pairs])),
        masks=torch.from_numpy(np.stack([mask for _, mask in pairs])),
        background=(1.0, 1.0, 1.0),
    )


def mean_colour(views: ViewSet) -> tuple[float, float, float]:
    """The mean RGB, 0 to 1, inside the masks."""
    inside = np.concatenate([view.colour[view.mask] for view in views.views])
    if not len(inside):
        return (0.5, 0.5, 0.5)
    red, green, blue = inside.mean(axis=0) / 255.0
    return (float(red), float(green), float(blue))


def _resampled(
    view: View, camera: Camera
) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.float32]]:
    """(3, h, w) colours and (h, w) mask on the camera's pixels."""
    corners = _plane_to_mask(view, camera)
    across = _overlaps(corners[:, 0], camera.width, view.mask.shape[1])
    down = _overlaps(corners[:, 1], camera.height, view.mask.shape[0])
    mask = down @ view.mask.astype(np.float64) @ across.T
    shown = down.sum(axis=1)[:, None] * across.sum(axis=1)[None, :]
    colours = np.ascontiguousarray(np.moveaxis(view.colour, 2, 0)) / 255.0
    blended = down @ colours @ across.T + (1.0 - shown)
    return blended.astype(np.float32), np.clip(mask, 0.0, 1.0).astype(np.float32)


def _plane_to_mask(view: View, camera: Camera) -> npt.NDArray[np.float64]:
    """(2, 2) mask px (x, y) of the image's upper left and lower right corners."""
    pixels = np.array([[0.0, 0.0], [camera.width, camera.height]])
    return view.to_pixels(camera.on_view_plane(pixels))


def _overlaps(ends: npt.NDArray[np.float64], count: int, source: int) -> npt.NDArray[np.float64]:
    """(count, source) shares of each new pixel that the old pixels cover.

    Args:
        ends: (2,) where the first new pixel begins and the last one ends, in old pixels.
        count: number of new pixels.
        source: number of old pixels.
    """
    borders = np.linspace(ends[0], ends[1], count + 1)
    low, high = borders[:-1, None], borders[1:, None]
    pixels = np.arange(source)
    covered = np.minimum(high, pixels + 1) - np.maximum(low, pixels)
    return np.maximum(covered, 0.0) / (high - low)
