"""The start on a surface: counts, places, orientations."""

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.splatting.gaussians import (
    Start,
    gaussians_on,
    quaternions_to,
    rotation_matrices,
    spread_points,
)


def sphere(radius: float = 10.0) -> TriangleMesh:
    mesh = trimesh.creation.icosphere(subdivisions=3, radius=radius)
    return make_mesh(mesh.vertices, mesh.faces)


@given(st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: np.linalg.norm(v) > 1e-3))
def test_the_third_axis_turns_to_the_normal(vector: tuple[float, float, float]) -> None:
    normal = np.array([vector]) / np.linalg.norm(vector)
    rotation = rotation_matrices(quaternions_to(normal))[0]
    assert rotation[:, 2] == pytest.approx(normal[0], abs=1e-7)
    assert rotation @ rotation.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(rotation) == pytest.approx(1.0)


def test_start_is_flat_on_the_surface_and_as_wide_as_asked() -> None:
    surface = sphere()
    start = Start(count=700, spread=0.5, thickness=0.1, opacity=0.9, colour=(0.1, 0.2, 0.3))
    gaussians = gaussians_on(surface, start)
    assert len(gaussians) == 700
    radii = np.linalg.norm(gaussians.means, axis=1)
    assert (radii > 9.9).all()
    assert (radii < 10.0 + 1e-4).all()
    sigma = 0.5 * np.sqrt(surface.area / 700)
    scales = np.exp(gaussians.log_scales)
    assert scales == pytest.approx(np.tile([sigma, sigma, 0.1 * sigma], (700, 1)), rel=1e-5)
    assert gaussians.rotations[:, :, 2] == pytest.approx(gaussians.normals, abs=1e-6)
    outward = (gaussians.means / radii[:, None] * gaussians.normals).sum(axis=1)
    assert outward.min() > 0.98
    assert gaussians.opacities == pytest.approx(0.9, abs=1e-6)
    assert gaussians.colours == pytest.approx(np.tile([0.1, 0.2, 0.3], (700, 1)))


def test_points_are_more_even_than_chance() -> None:
    surface = sphere()
    points, _ = spread_points(surface, 2000, seed=3)
    mean = surface.area / 2000
    gaps = _nearest(points)
    random = np.random.default_rng(3).standard_normal((2000, 3))
    independent = _nearest(10.0 * random / np.linalg.norm(random, axis=1, keepdims=True))
    assert np.quantile(gaps, 0.01) > 2.0 * np.quantile(independent, 0.1)
    assert gaps.min() > 0.6 * np.sqrt(mean)
    assert gaps.max() < 1.3 * np.sqrt(mean)


def _nearest(points: np.ndarray) -> np.ndarray:
    distances = np.linalg.norm(points[:, None] - points[None], axis=2)
    np.fill_diagonal(distances, np.inf)
    return distances.min(axis=1)


def test_every_face_gets_its_share_of_the_area() -> None:
    box = trimesh.creation.box(bounds=[(0, 0, 0), (10, 4, 1)])
    _, normals = spread_points(make_mesh(box.vertices, box.faces), 1000, seed=0)
    shares = {axis: (np.abs(normals[:, axis]) > 0.5).sum() for axis in range(3)}
    area = 2 * (40 + 10 + 4)
    assert [shares[axis] for axis in range(3)] == [
        pytest.approx(1000 * 2 * face / area, abs=15) for face in (4, 10, 40)
    ]


def test_same_seed_same_start_other_seed_other_start() -> None:
    surface = sphere()
    first, again = (gaussians_on(surface, Start(count=50, seed=1)) for _ in range(2))
    other = gaussians_on(surface, Start(count=50, seed=2))
    assert np.array_equal(first.means, again.means)
    assert not np.array_equal(first.means, other.means)
