"""Solids with known drawings, made by trimesh."""

from collections.abc import Callable

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

Corner = tuple[float, float, float]


def placed_box(low: Corner, high: Corner) -> trimesh.Trimesh:
    solid = trimesh.creation.box(np.subtract(high, low))
    solid.apply_translation(np.add(low, high) / 2)
    return solid


@pytest.fixture(scope="session")
def box() -> Callable[..., TriangleMesh]:
    """Makes a box between two corners."""

    def make(low: Corner, high: Corner) -> TriangleMesh:
        solid = placed_box(low, high)
        return make_mesh(solid.vertices, solid.faces)

    return make


@pytest.fixture(scope="session")
def blind_hole() -> TriangleMesh:
    """A block of 40 x 30 x 20 mm with a hole of radius 6 about (25, 12), 13 deep, from above."""
    drill = trimesh.creation.cylinder(6.0, 20.0, sections=180)
    drill.apply_translation((25, 12, 17))
    solid = trimesh.boolean.difference([placed_box((0, 0, 0), (40, 30, 20)), drill])
    mesh = make_mesh(solid.vertices, solid.faces)
    assert mesh.watertight
    return mesh


@pytest.fixture(scope="session")
def rounded_block(blind_hole: TriangleMesh) -> TriangleMesh:
    """The block with the blind hole as a Poisson surface of noisy points."""
    from gaussiancad_core.kernel.bare_open3d import open3d

    exact = blind_hole.to_trimesh()
    points, faces = trimesh.sample.sample_surface(exact, 20_000, seed=1)
    points += np.random.default_rng(1).normal(scale=0.02, size=points.shape)
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    cloud.normals = open3d.utility.Vector3dVector(exact.face_normals[faces])
    surface, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
        cloud, depth=7, n_threads=1
    )
    return make_mesh(np.asarray(surface.vertices), np.asarray(surface.triangles))
