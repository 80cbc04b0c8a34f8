"""Targets: the views on the cameras' pixels."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import Camera, orthographic_camera, paper_camera
from gaussiancad_core.model.views import View, ViewSet
from gaussiancad_core.splatting.targets import mean_colour, targets_of


def test_area_of_the_mask_is_that_of_the_part(box_views: ViewSet) -> None:
    cameras = tuple(orthographic_camera(role, box_views.size, 50) for role in box_views.roles)
    masks = targets_of(box_views, cameras).masks.numpy()
    for camera, mask, area in zip(cameras, masks, (20 * 16, 20 * 12, 12 * 16), strict=True):
        assert mask.sum() / camera.fx**2 == pytest.approx(area, rel=1e-5)


def test_pinhole_sees_the_plane_through_the_middle(box_views: ViewSet) -> None:
    cameras = tuple(paper_camera(role, box_views.size, 0.1) for role in box_views.roles)
    masks = targets_of(box_views, cameras).masks.numpy()
    for camera, mask, area in zip(cameras, masks, (20 * 16, 20 * 12, 12 * 16), strict=True):
        pixel = camera.reference_depth**2 / (camera.fx * camera.fy)
        assert mask.sum() * pixel == pytest.approx(area, rel=1e-5)


@pytest.mark.parametrize("make", [orthographic_camera, paper_camera])
@pytest.mark.parametrize("role", list(Role))
def test_a_mark_lands_where_the_camera_projects_it(make: object, role: Role) -> None:
    size = (20.0, 12.0, 16.0)
    camera: Camera = make(role, size, 80) if make is orthographic_camera else make(role, size, 0.08)
    (across, sign_x), (upward, sign_y) = role.frame.right_axis, role.frame.up_axis
    origin = (min(0.0, sign_x * size[across.value]), max(0.0, sign_y * size[upward.value]))
    mask = np.zeros((round(size[upward.value] * 4), round(size[across.value] * 4)), bool)
    mask[8:12, 4:8] = True
    colour = np.where(mask[..., None], np.uint8(0), np.uint8(255))
    colour = np.repeat(colour, 3, axis=2)
    view = View(role, (0, 0, 1, 1), (), mask, colour, origin, 0.25)
    point = np.array(size) / 2.0
    point[across.value] = sign_x * (origin[0] + 1.5)
    point[upward.value] = sign_y * (origin[1] - 2.5)
    targets = targets_of(ViewSet((view,), size), (camera,))
    weights = targets.masks[0].numpy()
    # Averaging over pixels moves a middle by a fraction of one.
    rows, columns = np.mgrid[: camera.height, : camera.width] + 0.5
    found = [(weights * axis).sum() / weights.sum() for axis in (columns, rows)]
    assert found == pytest.approx(camera.project(point[None])[0], abs=0.15)
    assert targets.colours[0].numpy() == pytest.approx(np.tile(1.0 - weights, (3, 1, 1)), abs=1e-6)


def test_colour_inside_is_the_views_and_white_outside(box_views: ViewSet) -> None:
    camera = orthographic_camera(Role.FRONT, box_views.size, 64)
    targets = targets_of(box_views, (camera,))
    middle = targets.colours[0, :, 32, 32].numpy()
    assert middle == pytest.approx(np.array([200, 100, 50]) / 255.0, abs=1e-6)
    assert targets.colours[0, :, 0, 0].numpy() == pytest.approx(np.ones(3))
    assert targets.background == (1.0, 1.0, 1.0)


@given(st.integers(5, 90))
def test_masks_stay_between_nothing_and_all(pixels: int) -> None:
    mask = np.ones((7, 9), bool)
    view = View(Role.FRONT, (0, 0, 1, 1), (), mask, np.zeros((7, 9, 3), np.uint8), (0.0, 7.0), 1.0)
    size = (9.0, 3.0, 7.0)
    camera = orthographic_camera(Role.FRONT, size, pixels)
    targets = targets_of(ViewSet((view,), size), (camera,))
    masks = targets.masks.numpy()
    assert masks.min() >= 0.0
    assert masks.max() <= 1.0
    assert masks.sum() / camera.fx**2 == pytest.approx(63.0, rel=1e-4)


def test_mean_colour_is_that_inside_the_masks(box_views: ViewSet) -> None:
    assert mean_colour(box_views) == pytest.approx(np.array([200, 100, 50]) / 255.0)
