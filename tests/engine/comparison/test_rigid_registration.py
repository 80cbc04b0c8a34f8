"""Which motion lays one model over the other."""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from gaussiancad_core.comparison.normalise import inverse, moved_mesh, normalising_matrix
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.rigid_registration import (
    Side,
    axis_rotations,
    register,
)
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh


def _side(mesh: TriangleMesh, stream: int = 0, box: bool = True) -> Side:
    boxed = moved_mesh(mesh, normalising_matrix(mesh)) if box else mesh
    random = random_streams(0, 2)[stream]
    return Side(SurfaceQueries(boxed), sample_surface(boxed, 1000, random))


def _turned(mesh: TriangleMesh, turn: np.ndarray) -> TriangleMesh:
    moved = make_mesh(mesh.vertices @ turn.T, mesh.triangles)
    return moved if np.linalg.det(turn) > 0 else moved.flipped()


@pytest.mark.parametrize("number", range(24))
def test_each_rotation_is_recovered(bracket: TriangleMesh, number: int) -> None:
    turn = axis_rotations()[number]
    found = register(_side(_turned(bracket, turn)), _side(bracket, 1))
    assert found.pose[:3, :3] == pytest.approx(turn.T, abs=1e-9)
    assert found.pose[:3, 3] == pytest.approx(np.zeros(3), abs=1e-9)
    assert found.distance < 1e-5
    assert not found.mirrored


def test_a_symmetric_part_stays_where_it_is(box: Callable[..., TriangleMesh]) -> None:
    found = register(_side(box(3, 2, 1)), _side(box(3, 2, 1), 1))
    assert (found.pose == np.eye(4)).all()
    assert not found.mirrored


def test_a_small_turn_is_found_by_icp(bracket: TriangleMesh) -> None:
    reference = moved_mesh(bracket, normalising_matrix(bracket))
    motion = np.eye(4)
    motion[:3, :3] = Rotation.from_euler("xyz", [2.0, -3.0, 4.0], degrees=True).as_matrix()
    motion[:3, 3] = [0.05, -0.03, 0.02]
    found = register(_side(moved_mesh(reference, motion), box=False), _side(reference, 1, False))
    assert found.pose == pytest.approx(inverse(motion), abs=1e-5)
    assert found.distance < 1e-5


def test_icp_never_makes_it_worse(bracket: TriangleMesh, box: Callable[..., TriangleMesh]) -> None:
    """A plain block against the bracket: whatever ICP proposes, the start is the upper bound."""
    result, reference = _side(box(40, 30, 20)), _side(bracket, 1)
    found = register(result, reference)
    there = reference.surface.distances(result.points)
    back = result.surface.distances(reference.points)
    assert found.distance <= (there.mean() + back.mean()) / 2


def test_missing_material_does_not_pull(
    bracket: TriangleMesh, box: Callable[..., TriangleMesh]
) -> None:
    """Half of the part is enough to find the other half's place."""
    import trimesh

    half = trimesh.boolean.intersection([bracket.to_trimesh(), box(40, 30, 12).to_trimesh()])
    shift = np.diag([5 / 40, 5 / 40, 5 / 40, 1.0])
    shift[:3, 3] = 0.02
    reference = moved_mesh(bracket, np.diag([5 / 40, 5 / 40, 5 / 40, 1.0]))
    cut = moved_mesh(make_mesh(half.vertices, half.faces), shift)
    found = register(_side(cut, box=False), _side(reference, 1, False))
    assert found.pose[:3, 3] == pytest.approx(-0.02 * np.ones(3), abs=5e-3)
