"""Seeded points on a surface, uniform by area."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.meshes import TriangleMesh

RandomState = np.random.Generator


@dataclass(frozen=True, eq=False)
class SurfaceSample:
    """Points on a mesh.

    Attributes:
        points: (n, 3).
        triangles: (n,) int64, the triangle that each lies on.
    """

    points: npt.NDArray[np.float64]
    triangles: npt.NDArray[np.int64]


def random_streams(seed: int, count: int) -> list[RandomState]:
    """Independent generators that depend on the seed and their place in the list only."""
    return [np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(count)]


def sample_surface(mesh: TriangleMesh, count: int, random: RandomState) -> npt.NDArray[np.float64]:
    """(count, 3) independent points, equally likely on every part of the mesh's area."""
    return sample_triangles(mesh, count, random).points


def sample_triangles(mesh: TriangleMesh, count: int, random: RandomState) -> SurfaceSample:
    """The points of :func:`sample_surface`, and the triangles that they lie on."""
    import trimesh

    points, triangles = trimesh.sample.sample_surface(mesh.to_trimesh(), count, seed=random)
    return SurfaceSample(
        np.asarray(points, dtype=np.float64), np.asarray(triangles, dtype=np.int64)
    )
