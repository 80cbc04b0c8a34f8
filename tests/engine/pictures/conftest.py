"""Boxes, made by trimesh."""

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
