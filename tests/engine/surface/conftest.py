"""Solids and Gaussians on them, which most tests here start from."""

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface


@pytest.fixture(scope="session")
def box() -> TriangleMesh:
    """A box of 20 x 12 x 16 mm."""
    mesh = trimesh.creation.box(bounds=[(0, 0, 0), (20, 12, 16)])
    return make_mesh(mesh.vertices, mesh.faces)


@pytest.fixture(scope="session")
def ball() -> TriangleMesh:
    """A ball of radius 10 mm, 5,120 triangles."""
    mesh = trimesh.creation.icosphere(subdivisions=4, radius=10.0)
    return make_mesh(mesh.vertices, mesh.faces)


@pytest.fixture(scope="session")
def bracket() -> TriangleMesh:
    """An L of 20 x 12 x 16 mm: a box less the upper right one of 14 x 12 x 11 mm."""
    outline = np.array([(0, 0), (20, 0), (20, 5), (6, 5), (6, 16), (0, 16)], float)
    front = np.column_stack([outline[:, 0], np.zeros(6), outline[:, 1]])
    cap = np.array([(0, 1, 3), (1, 2, 3), (0, 3, 5), (3, 4, 5)])
    walls = [
        triangle
        for k in range(6)
        for j in [(k + 1) % 6]
        for triangle in ((k, k + 6, j), (j, k + 6, j + 6))
    ]
    triangles = np.concatenate([cap, cap[:, ::-1] + 6, walls])
    mesh = make_mesh(np.concatenate([front, front + np.array([0, 12, 0])]), triangles)
    fine = mesh.oriented_outward().to_trimesh().subdivide().subdivide()
    return make_mesh(fine.vertices, fine.faces)


@pytest.fixture(scope="session")
def bracket_gaussians(bracket: TriangleMesh) -> Gaussians:
    """Flat Gaussians on the bracket, as they start."""
    return gaussians_on(bracket, Start(count=2_000, thickness=0.04))


@pytest.fixture(scope="session")
def bracket_surface(bracket_gaussians: Gaussians) -> TriangleMesh:
    """Their Poisson mesh."""
    return gaussian_surface(bracket_gaussians, PoissonSettings(depth=7))
