"""Where Gaussians and drawing disagree."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.residuals import ResidualRegion, ViewResidual, residuals_of
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_core.splatting.targets import targets_of
from gaussiancad_protocol.modes import Preset, Recipe

SETTINGS = replace(training_settings(Recipe.ORTHOGRAPHIC, Preset.DRAFT), pixels=128)


def residuals(views: ViewSet, surface: TriangleMesh) -> tuple[ViewResidual, ...]:
    cameras = training_cameras(Recipe.ORTHOGRAPHIC, SETTINGS, views.roles, views.size)
    start = gaussians_on(surface, Start(20_000, thickness=0.04, opacity=0.95))
    return residuals_of(start, cameras, targets_of(views, cameras), SETTINGS)


def test_gaussians_on_the_part_leave_little_and_no_region(
    box_views: ViewSet, box_surface: TriangleMesh
) -> None:
    found = residuals(box_views, box_surface)
    assert tuple(residual.role for residual in found) == box_views.roles
    for residual in found:
        assert residual.regions == ()
        # About a ring of one pixel around the part.
        assert residual.difference < 0.05


def test_what_the_drawing_does_not_have_is_an_excess_at_its_place(
    box_views: ViewSet, box_surface: TriangleMesh
) -> None:
    front, *others = box_views.views
    mask = front.mask.copy()
    # A square of 4 mm, four pixels a millimetre.
    mask[20:36, 30:46] = False
    views = ViewSet((replace(front, mask=mask), *others), box_views.size)
    found = residuals(views, box_surface)
    assert [len(residual.regions) for residual in found] == [1, 0, 0]
    region = found[0].regions[0]
    assert region.excess
    low, high, pixel = place(views, region)
    assert low == pytest.approx([30 * 0.25 - 0.75, 16.75 - 20 * 0.25], abs=1.5 * pixel)
    assert high - low == pytest.approx([4.0, -4.0], abs=2.0 * pixel)
    assert region.pixels == pytest.approx((4.0 / pixel) ** 2, rel=0.2)
    assert found[0].difference > found[1].difference


def test_what_the_gaussians_do_not_have_is_missing_in_all_views_that_show_it(
    box_views: ViewSet,
) -> None:
    short = trimesh.creation.box(bounds=[(0, 0, 0), (16, 12, 16)])
    found = residuals(box_views, make_mesh(short.vertices, short.faces))
    # Seen from the front and from above; the right view looks along it.
    assert [len(residual.regions) for residual in found] == [1, 1, 0]
    region = found[0].regions[0]
    assert not region.excess
    low, high, pixel = place(box_views, region)
    assert low == pytest.approx([16.0, 16.0], abs=2.0 * pixel)
    assert high == pytest.approx([20.0, 0.0], abs=2.0 * pixel)


def place(views: ViewSet, region: ResidualRegion) -> tuple[np.ndarray, np.ndarray, float]:
    """Upper left and lower right corner in the front view, and a pixel, mm."""
    camera = training_cameras(Recipe.ORTHOGRAPHIC, SETTINGS, views.roles, views.size)[0]
    corners = camera.on_view_plane(np.array(region.box).reshape(2, 2))
    return corners[0], corners[1], 1.0 / camera.fx
