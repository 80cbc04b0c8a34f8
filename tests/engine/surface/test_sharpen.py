"""Rounded edges become sharp, and nothing else changes."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.surface.discs import Creases, DiscSampling, creases_of, discs_of
from gaussiancad_core.surface.oriented_points import disc_points
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface, poisson_surface
from gaussiancad_core.surface.sharpen import Sharpening, sharpened

SETTINGS = PoissonSettings(depth=7)
CELL = 20.0 * 1.1 / 2**7
REACH = 1.0


@pytest.fixture(scope="module")
def creases(bracket_gaussians: Gaussians) -> Creases:
    return creases_of(discs_of(bracket_gaussians, DiscSampling()), DiscSampling())


@pytest.fixture(scope="module")
def rounded(bracket_gaussians: Gaussians, creases: Creases) -> TriangleMesh:
    discs = discs_of(bracket_gaussians, DiscSampling())
    return poisson_surface(disc_points(discs, creases, DiscSampling()), SETTINGS)


@pytest.fixture(scope="module")
def sharp(rounded: TriangleMesh, creases: Creases) -> TriangleMesh:
    return sharpened(rounded, creases, CELL, REACH, Sharpening())


def distances(target: TriangleMesh, points: np.ndarray) -> np.ndarray:
    return trimesh.proximity.closest_point(target.to_trimesh(), points)[1]


def test_edges_have_vertices_on_them(rounded: TriangleMesh, sharp: TriangleMesh) -> None:
    edge = np.column_stack([np.linspace(1, 19, 200), np.zeros(200), np.zeros(200)])
    nearest = np.linalg.norm(sharp.vertices[:, None] - edge[::20], axis=2).min(axis=0)
    assert nearest.max() < CELL
    before, after = (distances(mesh, edge) for mesh in (rounded, sharp))
    assert after.mean() < 0.4 * before.mean()
    assert np.median(after) < 1e-6


def test_triangles_stay_and_none_turns_over(rounded: TriangleMesh, sharp: TriangleMesh) -> None:
    assert sharp.watertight
    assert np.array_equal(sharp.triangles, rounded.triangles)
    assert ((sharp.area_vectors * rounded.area_vectors).sum(axis=1) >= 0.0).all()


def test_what_is_far_from_edges_stays(
    rounded: TriangleMesh, sharp: TriangleMesh, creases: Creases
) -> None:
    far = cKDTree(creases.points).query(rounded.vertices)[0] > REACH + 6.0 * CELL
    assert far.sum() > 1000
    assert np.array_equal(sharp.vertices[far], rounded.vertices[far])
    assert not np.array_equal(sharp.vertices, rounded.vertices)


def test_without_creases_and_beside_bent_ones_all_stays(
    rounded: TriangleMesh, creases: Creases
) -> None:
    bent = replace(creases, bends=np.full(len(creases), 20.0))
    assert sharpened(rounded, bent, CELL, REACH, Sharpening()) is rounded


def test_the_gaussians_surface_is_sharp_unless_asked_for_otherwise(
    bracket: TriangleMesh, bracket_gaussians: Gaussians
) -> None:
    plain = gaussian_surface(bracket_gaussians, replace(SETTINGS, sharpening=None))
    found = gaussian_surface(bracket_gaussians, SETTINGS)
    assert found.watertight
    assert len(found.triangles) < len(plain.triangles)
    errors = [
        distances(bracket, trimesh.sample.sample_surface(mesh.to_trimesh(), 4000, seed=0)[0])
        for mesh in (plain, found)
    ]
    assert errors[1].mean() < 0.5 * errors[0].mean()
