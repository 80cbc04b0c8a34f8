"""CD, HD, EMD, point to surface and volume IoU on inputs whose answers are known."""

from collections.abc import Callable
from itertools import permutations

import numpy as np
import pytest

from gaussiancad_core.comparison.distances import (
    IouMethod,
    earth_movers_distance,
    point_to_surface,
    sample_distances,
    volume_iou,
)
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh


def _grid() -> np.ndarray:
    axis = np.arange(6.0)
    return np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)


def test_a_known_offset_gives_exact_distances() -> None:
    """Each point's nearest one is its own copy, 0.25 away: the chamfer is the SUM of both ways."""
    found = sample_distances(_grid(), _grid() + np.array([0.25, 0.0, 0.0]))
    assert found.chamfer == pytest.approx(0.5)
    assert found.hausdorff == pytest.approx(0.25)
    assert found.emd == pytest.approx(0.25)
    assert found.emd_points == 216


def test_distances_are_not_squared_and_the_larger_way_counts() -> None:
    first, second = np.zeros((1, 3)), np.array([[3.0, 0, 0], [0, 5.0, 0]])
    found = sample_distances(first, second)
    assert found.chamfer == pytest.approx(3.0 + 4.0)
    assert found.hausdorff == pytest.approx(5.0)


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("count", [1, 2, 5, 7])
def test_emd_is_the_least_of_all_assignments(count: int, seed: int) -> None:
    first, second = np.random.default_rng(seed).normal(size=(2, count, 3))
    costs = np.linalg.norm(first[:, None] - second[None], axis=2)
    least = min(costs[range(count), order].mean() for order in permutations(range(count)))
    assert earth_movers_distance(first, second) == pytest.approx(least, rel=1e-12)


def test_point_to_surface_of_nested_boxes(box: Callable[..., TriangleMesh]) -> None:
    """A cube of edge 2 in one of edge 4: 1 outwards everywhere; inwards the mean is computed."""
    small = make_mesh(box(2, 2, 2).vertices - 1.0, box(2, 2, 2).triangles)
    large = make_mesh(box(4, 4, 4).vertices - 2.0, box(4, 4, 4).triangles)
    first, second = random_streams(0, 2)
    inner, outer = (sample_surface(small, 3000, first), sample_surface(large, 3000, second))
    back = np.linalg.norm(np.maximum(np.abs(outer) - 1.0, 0.0), axis=1).mean()
    found = point_to_surface((SurfaceQueries(small), inner), (SurfaceQueries(large), outer))
    assert found == pytest.approx((1.0 + back) / 2.0)


def test_iou_of_overlapping_boxes_is_exact(box: Callable[..., TriangleMesh]) -> None:
    shifted = make_mesh(box(2, 1, 1).vertices + np.array([0.5, 0, 0]), box(2, 1, 1).triangles)
    found = volume_iou(
        SurfaceQueries(box(2, 1, 1)), SurfaceQueries(shifted), np.random.default_rng(0)
    )
    assert found.method is IouMethod.BOOLEAN
    assert found.value == pytest.approx(1.5 / 2.5)


def test_iou_of_an_open_mesh_is_estimated(box: Callable[..., TriangleMesh]) -> None:
    cube = box(2, 1, 1)
    open_box = make_mesh(cube.vertices + np.array([0.5, 0, 0]), cube.triangles[1:])
    found = volume_iou(SurfaceQueries(open_box), SurfaceQueries(cube), np.random.default_rng(0))
    assert found.method is IouMethod.OCCUPANCY
    assert found.value == pytest.approx(0.6, abs=0.05)


def test_a_box_without_a_lid_is_nearly_full(box: Callable[..., TriangleMesh]) -> None:
    cube = box(1, 1, 1)
    for axis, side in ((0, 0.0), (0, 1.0), (1, 0.0), (1, 1.0), (2, 0.0), (2, 1.0)):
        lid = (cube.corners[:, :, axis] == side).all(axis=1)
        pot = make_mesh(cube.vertices, cube.triangles[~lid])
        found = volume_iou(SurfaceQueries(pot), SurfaceQueries(cube), np.random.default_rng(0))
        assert found.method is IouMethod.OCCUPANCY
        assert 0.8 < found.value < 1.0


@pytest.mark.parametrize("seed", range(4))
def test_a_sheet_encloses_nothing(box: Callable[..., TriangleMesh], seed: int) -> None:
    # Larger than the box and across it, in any direction.
    normal, along, across = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    corners = [40 * along, -20 * along + 40 * across, -20 * along - 40 * across]
    sheet = make_mesh(np.array(corners) + 5.0 + 0.5 * normal, [[0, 1, 2]])
    found = volume_iou(
        SurfaceQueries(sheet), SurfaceQueries(box(10, 10, 10)), np.random.default_rng(0)
    )
    assert (found.value, found.method) == (0.0, IouMethod.OCCUPANCY)


def test_iou_of_sheets_is_none() -> None:
    sheet = make_mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    found = volume_iou(SurfaceQueries(sheet), SurfaceQueries(sheet), np.random.default_rng(0))
    assert found.method is IouMethod.NONE
    assert found.value is None
