"""Points on a surface."""

from collections.abc import Callable

import numpy as np

from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.model.meshes import TriangleMesh


def test_points_lie_on_the_surface(bracket: TriangleMesh) -> None:
    points = sample_surface(bracket, 2000, random_streams(1, 1)[0])
    assert points.shape == (2000, 3)
    assert SurfaceQueries(bracket).nearest(points).distances.max() < 1e-9


def test_points_are_uniform_by_area(box: Callable[..., TriangleMesh]) -> None:
    points = sample_surface(box(10, 1, 1), 42_000, random_streams(5, 1)[0])
    on_end = ((points[:, 0] < 1e-9) | (points[:, 0] > 10 - 1e-9)).sum()
    # The two ends hold 2 of 42 mm2: 2000 points, with a standard deviation of 44.
    assert abs(on_end - 2000) < 5 * 44


def test_streams_depend_on_seed_and_place(bracket: TriangleMesh) -> None:
    first, second = (sample_surface(bracket, 50, stream) for stream in random_streams(7, 2))
    again = sample_surface(bracket, 50, random_streams(7, 4)[0])
    other = sample_surface(bracket, 50, random_streams(8, 2)[0])
    assert (first == again).all()
    assert not np.isclose(first, second).all()
    assert not np.isclose(first, other).all()
