"""Thinned ink, pixel by pixel as scikit-image has it."""

import cv2
import numpy as np
import pytest
from skimage.morphology import skeletonize

from gaussiancad_core.geometry.skeletons import Mask, skeleton


def blots(seed: int) -> Mask:
    """Noise, smooth on every second seed."""
    rng = np.random.default_rng(seed)
    values = rng.random(rng.integers(2, 90, 2))
    if seed % 2:
        values = cv2.GaussianBlur(values, (0, 0), rng.uniform(0.5, 3.0))
    return values.reshape(values.shape[0], -1) > np.quantile(values, rng.uniform(0.1, 0.9))


def lines(seed: int) -> Mask:
    """Lines, circles and ellipses of all widths, across each other."""
    rng = np.random.default_rng(seed)
    picture = np.zeros((240, 320), np.uint8)
    for _ in range(12):
        (x0, x1), (y0, y1) = rng.integers(0, 320, 2).tolist(), rng.integers(0, 240, 2).tolist()
        width = int(rng.integers(1, 9))
        cv2.line(picture, (x0, y0), (x1, y1), 1, width)
        cv2.ellipse(picture, (x1, y1), (x0 // 3 + 1, y0 // 3 + 1), 30.0, 0.0, 360.0, 1, width)
    return picture > 0


@pytest.mark.parametrize("seed", range(40))
@pytest.mark.parametrize("draw", [blots, lines])
def test_each_pixel_is_that_of_scikit_image(draw, seed: int) -> None:  # noqa: ANN001
    ink = draw(seed)
    assert np.array_equal(skeleton(ink), skeletonize(ink))


def test_all_that_nine_pixels_can_be() -> None:
    for pattern in range(512):
        ink = np.array([bool(pattern >> place & 1) for place in range(9)]).reshape(3, 3)
        assert np.array_equal(skeleton(ink), skeletonize(ink)), pattern
