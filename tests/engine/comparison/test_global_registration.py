"""Turns that are none of the 24 by quarters, and a result that has more than the reference."""

from collections.abc import Callable

import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import Alignment, CompareOptions, Protocol
from gaussiancad_core.comparison.global_registration import find_turn
from gaussiancad_core.comparison.model_files import Model
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

TURNS = Rotation.from_euler("xyz", [[25, 130, -70], [-160, 40, 77]], degrees=True).as_matrix()


def _turned(mesh: TriangleMesh, turn: np.ndarray, scale: float = 1.0) -> TriangleMesh:
    return make_mesh(scale * mesh.vertices @ turn.T + [500.0, -20.0, 3.0], mesh.triangles)


@pytest.mark.parametrize("turn", TURNS)
def test_any_turn_is_undone_at_any_size(bracket: TriangleMesh, turn: np.ndarray) -> None:
    found = find_turn(_turned(bracket, turn, 3.0), bracket, np.random.default_rng(0))
    assert found.rotation @ turn == pytest.approx(np.eye(3), abs=1e-3)
    assert not found.mirrored


def test_a_symmetric_part_stays_where_it_is(box: Callable[..., TriangleMesh]) -> None:
    found = find_turn(box(4, 3, 2), box(4, 3, 2), np.random.default_rng(0))
    assert found.rotation == pytest.approx(np.eye(3), abs=1e-6)
    assert not found.mirrored


def test_a_mirror_image_in_any_pose_is_told(bracket: TriangleMesh) -> None:
    image = make_mesh(bracket.vertices * [1, -1, 1], bracket.triangles).flipped()
    found = find_turn(_turned(image, TURNS[0]), bracket, np.random.default_rng(0))
    assert found.mirrored
    assert np.linalg.det(found.rotation) == pytest.approx(1.0)


def test_a_part_in_any_pose_is_compared_as_if_in_place(bracket: TriangleMesh) -> None:
    asked = CompareOptions(1000, protocols=tuple(Protocol), alignment=Alignment.GLOBAL)
    moved = _turned(bracket, TURNS[1])
    found, deviation = compare_models(Model(moved), Model(bracket), asked)
    assert found.point_to_surface < 1e-3
    assert found.engineering.agreement > 0.98
    placed = moved.vertices @ found.engineering.matrix[:3, :3].T + found.engineering.matrix[:3, 3]
    assert placed == pytest.approx(bracket.vertices, abs=0.01)
    assert np.abs(deviation.distances).max() < 0.02


@pytest.fixture(scope="module")
def bumped(bracket: TriangleMesh) -> TriangleMesh:
    """The bracket with a pin on top, 3 mm higher than the bracket is; else the same."""
    pin = trimesh.creation.box((2.0, 2.0, 5.0))
    pin.apply_translation((5.0, 15.0, 20.5))
    solid = trimesh.boolean.union([bracket.to_trimesh(), pin])
    return make_mesh(solid.vertices, solid.faces)


@pytest.mark.parametrize("shift", [np.zeros(3), np.array([210.0, -37.0, 55.0])])
def test_one_pin_does_not_move_the_part(
    bracket: TriangleMesh, bumped: TriangleMesh, shift: np.ndarray
) -> None:
    result = Model(make_mesh(bumped.vertices + shift, bumped.triangles))
    asked = CompareOptions(points=2000, protocols=(Protocol.ENGINEERING,))
    found, _ = compare_models(result, Model(bracket), asked)
    placed = found.engineering
    assert placed.matrix[:3, 3] == pytest.approx(-shift, abs=2e-3)
    assert placed.matrix[:3, :3] == pytest.approx(np.eye(3), abs=1e-4)
    assert placed.result_to_reference.greatest == pytest.approx(3.0, abs=2e-3)
    assert placed.reference_to_result.rms < 0.2
    assert placed.agreement > 0.98
