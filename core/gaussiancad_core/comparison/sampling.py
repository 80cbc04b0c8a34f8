"""Seeded points on a surface, uniform by area."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.meshes import TriangleMesh

RandomState = np.random.Generator


def random_streams(seed: int, count: int) -> list[RandomState]:
    """Independent generators that depend on the seed and their place in the list only."""
    return [np.random.default_rng(child) for child in np.random.SeedSequence(seed).spawn(count)]


def sample_surface(mesh: TriangleMesh, count: int, random: RandomState) -> npt.NDArray[np.float64]:
    """(count, 3) independent points, equally likely on every part of the mesh's area."""
    import trimesh

    points, _ = trimesh.sample.sample_surface(mesh.to_trimesh(), count, seed=random)
    return np.asarray(points, dtype=np.float64)
