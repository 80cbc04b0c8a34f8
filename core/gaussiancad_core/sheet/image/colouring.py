"""Views in one colour with their visible lines darker: what Gaussians are trained to show."""

from dataclasses import replace

import cv2
import numpy as np

from gaussiancad_core.model.views import Linetype, View, ViewSet


def coloured(views: ViewSet, colour: tuple[int, int, int]) -> ViewSet:
    """The views with pictures of the part.

    Args:
        views: on shared axes.
        colour: RGB of the part; what is beside it is white.
    """
    return replace(views, views=tuple(colourised(view, colour) for view in views.views))


def colourised(view: View, colour: tuple[int, int, int]) -> View:
    """The view with one RGB colour inside the mask, the visible strokes dark, the rest white."""
    image = np.full((*view.mask.shape, 3), 255, np.uint8)
    inside = view.mask.astype(np.uint8)
    cv2.copyTo(np.full_like(image, colour), inside, image)
    dark = tuple(int(0.25 * channel) for channel in colour)
    thickness = max(1, round(max(view.mask.shape) / 300))
    for stroke in view.strokes:
        if stroke.linetype is Linetype.VISIBLE:
            points = view.to_pixels(stroke.sample(view.mm_per_pixel)) - 0.5
            path = np.rint(points * 16).astype(np.int32)
            cv2.polylines(image, [path], False, dark, thickness, cv2.LINE_AA, 4)
    # Half of the outline's strokes lies outside of the part.
    cv2.copyTo(np.full_like(image, 255), 1 - inside, image)
    return replace(view, colour=image)
