import numpy as np
import pytest

from gaussiancad_core.kernel.brep import bounding_box, volume
from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.model.axes import Role
from sample_parts import SAMPLES, SamplePart, sample


@pytest.mark.parametrize("part", SAMPLES, ids=lambda part: part.name)
def test_columns_enter_and_leave_in_turn_and_hold_the_volume(part: SamplePart) -> None:
    shape = part.build()
    for role in (Role.FRONT, Role.BOTTOM, Role.LEFT):
        plane = np.array([role.frame.right, role.frame.up], dtype=float)
        corners = bounding_box(shape) @ plane.T
        low, high = corners.min(axis=0), corners.max(axis=0)
        steps = (np.arange(24) + 0.4371) / 24.0
        grid = np.stack(np.meshgrid(steps, steps), axis=2).reshape(-1, 2)
        columns = SolidRays(shape, role.frame, 1e-6).crossings_at(low + grid * (high - low))
        assert all(column.sound for column in columns)
        inside = sum(
            float(column.depth[1::2].sum() - column.depth[0::2].sum()) for column in columns
        )
        estimate = inside / len(columns) * float(np.prod(high - low))
        assert estimate == pytest.approx(volume(shape), rel=0.06)


def test_a_column_tells_depth_normal_and_face() -> None:
    shape = sample("pocket-block").build()
    neighbour, through, outside = SolidRays(shape, Role.TOP.frame, 1e-6).crossings_at(
        np.array([[5.0, 5.0], [30.0, 20.0], [100.0, 5.0]])
    )
    assert neighbour.depth == pytest.approx([-30.0, 0.0])
    assert through.depth == pytest.approx([-12.0, 0.0])
    np.testing.assert_allclose(neighbour.normal, [[0, 0, 1], [0, 0, -1]], atol=1e-12)
    assert neighbour.face[1] == through.face[1]
    assert neighbour.face[0] != through.face[0]
    assert len(outside.depth) == 0
    assert outside.sound
