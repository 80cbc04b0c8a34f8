"""Similarities and the box of the protocol."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.comparison.normalise import (
    BOX,
    inverse,
    moved_mesh,
    moved_points,
    normalising_matrix,
    scale_of,
)
from gaussiancad_core.comparison.rigid_registration import axis_rotations
from gaussiancad_core.model.meshes import TriangleMesh


def test_longest_edge_becomes_the_box(bracket: TriangleMesh) -> None:
    boxed = moved_mesh(bracket, normalising_matrix(bracket))
    assert boxed.bounds == pytest.approx(
        np.array([[-2.5, -1.875, -1.25], [2.5, 1.875, 1.25]]), abs=1e-12
    )
    assert boxed.volume == pytest.approx(bracket.volume * (BOX / 40) ** 3)


@given(st.floats(1e-3, 1e3), st.integers(0, 23), st.tuples(*[st.floats(-100, 100)] * 3))
def test_inverse_undoes(scale: float, turn: int, shift: tuple[float, float, float]) -> None:
    matrix = np.eye(4)
    matrix[:3, :3] = scale * axis_rotations()[turn]
    matrix[:3, 3] = shift
    points = np.random.default_rng(0).uniform(-5, 5, (20, 3))
    back = moved_points(moved_points(points, matrix), inverse(matrix))
    assert back == pytest.approx(points, abs=1e-9 * (1 + max(map(abs, shift)) / scale))
    assert scale_of(matrix) == pytest.approx(scale)
