import numpy as np
import pytest

from gaussiancad_core.model.axes import Axis, Projection, Role, mutually_orthogonal


@pytest.mark.parametrize("role", Role)
def test_frames_are_right_handed(role: Role) -> None:
    frame = role.frame
    assert np.array_equal(np.cross(frame.right, frame.up), -np.array(frame.look))
    assert np.linalg.det(frame.world_to_camera()) == 1.0


@pytest.mark.parametrize(
    ("role", "right", "up", "look"),
    [
        (Role.FRONT, (1, 0, 0), (0, 0, 1), (0, 1, 0)),
        (Role.TOP, (1, 0, 0), (0, 1, 0), (0, 0, -1)),
        (Role.RIGHT, (0, 1, 0), (0, 0, 1), (-1, 0, 0)),
        (Role.LEFT, (0, -1, 0), (0, 0, 1), (1, 0, 0)),
        (Role.BOTTOM, (1, 0, 0), (0, -1, 0), (0, 0, 1)),
        (Role.REAR, (-1, 0, 0), (0, 0, 1), (0, -1, 0)),
    ],
)
def test_roles_look_as_defined(role: Role, right: tuple, up: tuple, look: tuple) -> None:
    assert (role.frame.right, role.frame.up, role.frame.look) == (right, up, look)


def test_first_angle_is_third_angle_the_other_way_round() -> None:
    assert Role.TOP.slot(Projection.THIRD) == (0, 1)
    assert Role.RIGHT.slot(Projection.THIRD) == (1, 0)
    for role in (Role.TOP, Role.BOTTOM, Role.LEFT, Role.RIGHT):
        column, row = role.slot(Projection.THIRD)
        assert role.slot(Projection.FIRST) == (-column, -row)


def test_left_view_runs_against_y() -> None:
    assert Role.LEFT.frame.right_axis == (Axis.Y, -1)


def test_three_directions_are_needed_for_orthogonality() -> None:
    assert mutually_orthogonal((Role.REAR, Role.TOP, Role.LEFT))
    assert not mutually_orthogonal((Role.FRONT, Role.TOP, Role.REAR))
