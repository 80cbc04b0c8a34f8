"""The corners that a chain needs, as scikit-image has them."""

import numpy as np
import pytest
from skimage.measure import approximate_polygon

from gaussiancad_core.geometry.chains import chain_distances, simplified
from gaussiancad_core.geometry.points import Points


def chain(seed: int) -> Points:
    """A walk, a walk on a grid, an arc of an ellipse, or a whole one."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(2, 80))
    if seed % 4 < 2:
        steps = rng.standard_normal((count, 2)).cumsum(axis=0)
        return steps if seed % 4 else np.round(2.0 * steps) / 4.0
    turn = 2.0 * np.pi if seed % 4 == 2 else rng.uniform(0.5, 6.0)
    angles = np.linspace(0.0, turn, count)
    points = np.stack([30.0 * np.cos(angles), 20.0 * np.sin(angles)], axis=1) + 500.0
    if seed % 4 == 2:
        points[-1] = points[0]
    return points


@pytest.mark.parametrize("slack", [0.05, 0.35, 1.0])
@pytest.mark.parametrize("seed", range(60))
def test_each_corner_is_that_of_scikit_image(seed: int, slack: float) -> None:
    points = chain(seed)
    assert np.array_equal(simplified(points, slack), approximate_polygon(points, slack))


@pytest.mark.parametrize("seed", range(20))
def test_no_point_is_further_off_than_asked(seed: int) -> None:
    points = chain(seed)
    assert chain_distances(points, simplified(points, 0.4)).max() <= 0.4 + 1e-9
