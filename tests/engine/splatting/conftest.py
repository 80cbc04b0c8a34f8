"""A small box and its three views, which most tests here start from."""

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.model.views import View, ViewSet

SIZE = (20.0, 12.0, 16.0)
ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
PIXEL = 0.25
COLOUR = (200, 100, 50)


def _view(role: Role, size: tuple[float, float, float]) -> View:
    (across, sign_x), (upward, sign_y) = role.frame.right_axis, role.frame.up_axis
    low_x = min(0.0, sign_x * size[across.value])
    high_y = max(0.0, sign_y * size[upward.value])
    margin = 3
    width, height = (round(size[axis.value] / PIXEL) for axis in (across, upward))
    mask = np.pad(np.ones((height, width), bool), margin)
    colour = np.where(mask[..., None], np.uint8(COLOUR), np.uint8(255))
    origin = (low_x - margin * PIXEL, high_y + margin * PIXEL)
    return View(role, (0, 0, 1, 1), (), mask, colour, origin, PIXEL)


@pytest.fixture
def box_views() -> ViewSet:
    """Three views of a box of 20 x 12 x 16 mm, four pixels a millimetre."""
    return ViewSet(tuple(_view(role, SIZE) for role in ROLES), SIZE)


@pytest.fixture
def box_surface() -> TriangleMesh:
    """The box itself, subdivided."""
    box = trimesh.creation.box(bounds=[(0, 0, 0), SIZE]).subdivide().subdivide()
    return make_mesh(box.vertices, box.faces)
