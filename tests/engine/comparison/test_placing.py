"""A result that has something more than the reference is laid where the rest of it fits."""

import numpy as np
import pytest
import trimesh

from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import CompareOptions, Protocol
from gaussiancad_core.comparison.model_files import Model
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

UNMOVED = np.zeros(3)
ELSEWHERE = np.array([210.0, -37.0, 55.0])


@pytest.fixture(scope="module")
def bumped(bracket: TriangleMesh) -> TriangleMesh:
    """The bracket with a pin on top, 3 mm higher than the bracket is; else the same."""
    pin = trimesh.creation.box((2.0, 2.0, 5.0))
    pin.apply_translation((5.0, 15.0, 20.5))
    solid = trimesh.boolean.union([bracket.to_trimesh(), pin])
    return make_mesh(solid.vertices, solid.faces)


@pytest.mark.parametrize("shift", [UNMOVED, ELSEWHERE])
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
