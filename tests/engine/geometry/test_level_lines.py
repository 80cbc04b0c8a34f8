"""Where a field is zero, point by point as scikit-image has it."""

import cv2
import numpy as np
import pytest
from skimage.measure import find_contours

from gaussiancad_core.geometry.level_lines import zero_lines
from gaussiancad_core.geometry.points import Points


def field(seed: int) -> Points:
    """Noise, smooth or of whole numbers, some nodes of it unknown."""
    rng = np.random.default_rng(seed)
    values = rng.standard_normal(rng.integers(2, 50, 2))
    if seed % 3 == 1:
        values = cv2.GaussianBlur(values, (0, 0), rng.uniform(0.5, 4.0)).reshape(values.shape)
    if seed % 3 == 2:
        values = np.round(values)
    if seed % 5 == 0:
        values[rng.random(values.shape) < 0.1] = np.nan
    return values


@pytest.mark.parametrize("seed", range(60))
def test_each_line_is_that_of_scikit_image(seed: int) -> None:
    values = field(seed)
    found, expected = zero_lines(values), find_contours(values, 0.0)
    assert len(found) == len(expected)
    assert all(np.array_equal(one, other) for one, other in zip(found, expected, strict=True))


def test_a_field_of_one_sign_has_none() -> None:
    assert zero_lines(np.ones((4, 5))) == []
    assert zero_lines(np.full((4, 5), np.nan)) == []
