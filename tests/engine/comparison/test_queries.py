"""Nearest points, enclosure and samples of one surface."""

from collections.abc import Callable

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

_COORDINATE = st.floats(-3.0, 3.0, allow_nan=False, width=32)


def _box_distance(point: np.ndarray, half: float) -> float:
    """Distance of a point from the surface of a cube about the origin."""
    outside = np.maximum(np.abs(point) - half, 0.0)
    if outside.any():
        return float(np.linalg.norm(outside))
    return float((half - np.abs(point)).min())


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(_COORDINATE, _COORDINATE, _COORDINATE), min_size=1, max_size=20))
def test_distances_from_a_cube_are_exact(points: list[tuple[float, float, float]]) -> None:
    import trimesh

    cube = trimesh.creation.box((2, 2, 2))
    surface = SurfaceQueries(make_mesh(cube.vertices, cube.faces))
    array = np.array(points)
    expected = np.array([_box_distance(point, 1.0) for point in array])
    nearest = surface.nearest(array)
    assert np.allclose(nearest.distances, expected, atol=1e-12)
    assert np.allclose(np.linalg.norm(nearest.points - array, axis=1), expected, atol=1e-12)
    assert np.allclose(surface.distances(array), expected, atol=1e-5)


def test_inside_agrees_with_the_box(unit_cube: TriangleMesh) -> None:
    points = np.random.default_rng(3).uniform(-0.5, 1.5, (5000, 3))
    expected = ((points > 0) & (points < 1)).all(axis=1)
    assert (SurfaceQueries(unit_cube).inside(points) == expected).all()


def test_inside_bears_a_missing_triangle(unit_cube: TriangleMesh) -> None:
    open_cube = make_mesh(unit_cube.vertices, unit_cube.triangles[:-1])
    points = np.random.default_rng(3).uniform(-0.5, 1.5, (5000, 3))
    expected = ((points > 0) & (points < 1)).all(axis=1)
    agreed = (SurfaceQueries(open_cube).inside(points) == expected).mean()
    assert agreed > 0.97


def test_slivers_are_found_where_single_precision_fails() -> None:
    """The triangles of a pierced plate are long and thin; trimesh looks at all of them."""
    import trimesh

    plate = trimesh.creation.box((5.0, 3.75, 2.5))
    drill = trimesh.creation.cylinder(0.8125, 5.0)
    drill.apply_translation((1.0, 0.375, 0.0))
    pierced = plate.difference(drill)
    mesh = make_mesh(pierced.vertices, pierced.faces)
    points = np.asarray(trimesh.sample.sample_surface(pierced, 20_000, seed=5)[0])
    assert SurfaceQueries(mesh).nearest(points).distances.max() < 1e-9
    away = points[:1000] * 1.1
    _, expected, _ = trimesh.proximity.closest_point(pierced, away)
    assert np.abs(SurfaceQueries(mesh).nearest(away).distances - expected).max() < 1e-6


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
