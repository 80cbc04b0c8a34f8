"""Solids with known measures, made by trimesh."""

from collections.abc import Callable

import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh


def _placed(mesh: trimesh.Trimesh, *shift: float) -> trimesh.Trimesh:
    mesh.apply_translation(shift)
    return mesh


@pytest.fixture(scope="session")
def bracket() -> TriangleMesh:
    """A part that no rotation and no mirror maps onto itself: 40 x 30 x 20 mm, planes only."""
    solid = trimesh.boolean.union(
        [
            _placed(trimesh.creation.box((40, 30, 8)), 20, 15, 4),
            _placed(trimesh.creation.box((10, 30, 20)), 5, 15, 10),
            _placed(trimesh.creation.box((12, 8, 14)), 34, 4, 7),
        ]
    )
    mesh = make_mesh(solid.vertices, solid.faces)
    assert mesh.watertight
    return mesh


@pytest.fixture(scope="session")
def unit_cube() -> TriangleMesh:
    """A cube of edge 1 from the origin."""
    return box_mesh(1.0, 1.0, 1.0)


def box_mesh(*edges: float) -> TriangleMesh:
    """A box from the origin."""
    solid = _placed(trimesh.creation.box(edges), *(edge / 2 for edge in edges))
    return make_mesh(solid.vertices, solid.faces)


@pytest.fixture(scope="session")
def box() -> Callable[..., TriangleMesh]:
    """Makes a box from the origin with the given edges."""
    return box_mesh
