"""Plane faces become plane, and bent ones stay."""

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.surface.discs import Discs, DiscSampling, discs_of
from gaussiancad_core.surface.flatten import Flattening, flattened

SAMPLING = DiscSampling()
CELL = 0.2


@pytest.fixture(scope="module")
def discs(bracket_gaussians: Gaussians) -> Discs:
    return discs_of(bracket_gaussians, SAMPLING)


def uneven(mesh: TriangleMesh, rounds: int) -> TriangleMesh:
    """The same solid, finer, its vertices up to three quarters of a cell away."""
    fine = mesh.to_trimesh()
    for _ in range(rounds):
        fine = fine.subdivide()
    fine.merge_vertices()
    off = np.random.default_rng(0).uniform(-0.75 * CELL, 0.75 * CELL, len(fine.vertices))
    return make_mesh(fine.vertices + off[:, None] * fine.vertex_normals, fine.faces)


def distances(target: TriangleMesh, points: np.ndarray) -> np.ndarray:
    return trimesh.proximity.closest_point(target.to_trimesh(), points)[1]


def test_vertices_of_plane_faces_lie_on_them(bracket: TriangleMesh, discs: Discs) -> None:
    before = uneven(bracket, 2)
    after = flattened(before, discs, CELL, SAMPLING, Flattening())
    far, near = (distances(bracket, mesh.vertices) for mesh in (before, after))
    assert far.mean() > 0.3 * CELL
    assert (near < 1e-5).mean() > 0.9
    assert np.array_equal(after.triangles, before.triangles)
    assert after.watertight
    assert ((after.area_vectors * before.area_vectors).sum(axis=1) >= 0.0).all()


def test_a_bulge_in_a_gap_between_discs_goes(bracket: TriangleMesh, discs: Discs) -> None:
    middle = np.array([10.0, 6.0, 0.0])
    there = discs.chosen(np.linalg.norm(discs.centres - middle, axis=1) > 0.8)
    fine = bracket.to_trimesh().subdivide().subdivide()
    vertices = np.array(fine.vertices)
    away = np.linalg.norm(vertices - middle, axis=1)
    vertices[:, 2] -= 0.3 * np.exp(-((away / 0.5) ** 2))
    found = flattened(make_mesh(vertices, fine.faces), there, CELL, SAMPLING, Flattening())
    assert distances(bracket, vertices).max() > 0.25
    assert distances(bracket, found.vertices).max() < 1e-5


def test_a_step_between_parallel_faces_stays() -> None:
    """Its faces are nearer to each other than discs are."""
    low = trimesh.creation.box(bounds=[(0, 0, 0), (20, 20, 5)])
    high = trimesh.creation.box(bounds=[(0, 0, 0), (10, 20, 5.3)])
    both = trimesh.boolean.union([low, high], engine="manifold")
    solid = make_mesh(both.vertices, both.faces)
    discs = discs_of(gaussians_on(solid, Start(count=1_500)), SAMPLING)
    fine = both.subdivide_to_size(1.0)
    before = make_mesh(fine.vertices, fine.faces)
    after = flattened(before, discs, CELL, SAMPLING, Flattening())
    assert distances(solid, after.vertices).max() < 1e-5
    assert after.volume == pytest.approx(before.volume, rel=1e-6)


def test_a_ball_stays_as_it_is(ball: TriangleMesh) -> None:
    discs = discs_of(gaussians_on(ball, Start(count=500)), SAMPLING)
    assert np.array_equal(
        flattened(ball, discs, CELL, SAMPLING, Flattening()).vertices, ball.vertices
    )
