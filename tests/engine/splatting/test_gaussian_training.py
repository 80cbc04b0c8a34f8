"""Training: it fits, stays on the hull, and repeats itself bit for bit."""

from dataclasses import replace

import numpy as np
import pytest
import torch

from gaussiancad_core.model.cameras import Camera
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.splatting.gaussian_training import TrainingResult, train
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.splatting.losses import Targets
from gaussiancad_core.splatting.rasterizer import Backend
from gaussiancad_core.splatting.settings import (
    TrainingSettings,
    training_cameras,
    training_settings,
)
from gaussiancad_core.splatting.targets import targets_of
from gaussiancad_protocol.modes import Preset, Recipe

Scene = tuple[Gaussians, tuple[Camera, ...], Targets, TrainingSettings]


def scene(views: ViewSet, surface: TriangleMesh, recipe: Recipe, **changes: object) -> Scene:
    settings = replace(training_settings(recipe, Preset.DRAFT), count=400, pixels=64, iterations=20)
    settings = replace(settings, **changes)
    cameras = training_cameras(recipe, settings, views.roles, views.size)
    start = Start(settings.count, thickness=settings.thickness, opacity=settings.opacity)
    return gaussians_on(surface, start), cameras, targets_of(views, cameras), settings


def trained(parts: Scene) -> TrainingResult:
    return train(*parts, lambda fraction, loss: None)


@pytest.mark.parametrize("recipe", list(Recipe))
def test_loss_falls_and_the_colour_is_learnt(
    box_views: ViewSet, box_surface: TriangleMesh, recipe: Recipe
) -> None:
    # The paper's recipe looks at one of the three views at a time, and changes colours slowly.
    iterations = 60 if recipe is Recipe.ORTHOGRAPHIC else 360
    parts = scene(box_views, box_surface, recipe, iterations=iterations)
    result = trained(parts)
    assert result.iterations == len(result.losses) == iterations
    assert np.mean(result.losses[-3:]) < 0.5 * np.mean(result.losses[:3])
    wanted = np.array([200, 100, 50]) / 255.0
    before, after = (
        np.abs(gaussians.colours.mean(axis=0) - wanted).sum()
        for gaussians in (parts[0], result.gaussians)
    )
    assert after < 0.85 * before
    assert len(result.gaussians) == 400


def test_gaussians_stay_on_the_surface_they_started_on(
    box_views: ViewSet, box_surface: TriangleMesh
) -> None:
    parts = scene(box_views, box_surface, Recipe.ORTHOGRAPHIC, iterations=60)
    start, result = parts[0], trained(parts).gaussians
    away = ((result.means - start.means) * start.normals).sum(axis=1)
    # In a thousandth of the longest edge.
    assert np.abs(away).mean() < 1e-3 * 20.0
    assert np.array_equal(result.normals, start.normals)
    tilts = np.abs((result.rotations[:, :, 2] * start.normals).sum(axis=1))
    # Most do not tilt at all, and none by as much as two degrees.
    assert np.degrees(np.arccos(np.minimum(np.median(tilts), 1.0))) < 0.05
    assert np.degrees(np.arccos(tilts.min())) < 2.0
    assert result.log_scales[:, 2] == pytest.approx(start.log_scales[:, 2], abs=1e-5)
    assert np.linalg.norm(result.quaternions, axis=1) == pytest.approx(1.0, abs=1e-5)


def test_papers_recipe_is_not_held(box_views: ViewSet, box_surface: TriangleMesh) -> None:
    parts = scene(box_views, box_surface, Recipe.PAPER, iterations=60)
    start, result = parts[0], trained(parts).gaussians
    away = ((result.means - start.means) * start.normals).sum(axis=1)
    assert np.abs(away).mean() > 1e-3 * 20.0
    assert np.abs(result.log_scales[:, 2] - start.log_scales[:, 2]).max() > 1e-3


def test_same_input_same_bits(box_views: ViewSet, box_surface: TriangleMesh) -> None:
    parts = scene(box_views, box_surface, Recipe.ORTHOGRAPHIC)
    first, again = trained(parts), trained(parts)
    assert first.losses == again.losses
    for name in ("means", "quaternions", "log_scales", "logit_opacities", "colours"):
        assert np.array_equal(getattr(first.gaussians, name), getattr(again.gaussians, name)), name


def test_the_size_of_the_part_does_not_matter(
    box_views: ViewSet, box_surface: TriangleMesh
) -> None:
    plain = trained(scene(box_views, box_surface, Recipe.ORTHOGRAPHIC))
    # A power of two, so that nothing is rounded differently.
    views = ViewSet(
        tuple(
            replace(
                view,
                origin=(view.origin[0] * 8.0, view.origin[1] * 8.0),
                mm_per_pixel=view.mm_per_pixel * 8.0,
            )
            for view in box_views.views
        ),
        tuple(extent * 8.0 for extent in box_views.size),
    )
    surface = make_mesh(box_surface.vertices * 8.0, box_surface.triangles)
    large = trained(scene(views, surface, Recipe.ORTHOGRAPHIC))
    assert large.losses == pytest.approx(plain.losses, rel=1e-4)
    assert large.gaussians.means / 8.0 == pytest.approx(plain.gaussians.means, abs=1e-3)


def test_progress_is_told_after_every_iteration(
    box_views: ViewSet, box_surface: TriangleMesh
) -> None:
    stated: list[tuple[float, float | None]] = []
    parts = scene(box_views, box_surface, Recipe.ORTHOGRAPHIC, iterations=5)
    result = train(*parts, lambda fraction, loss: stated.append((fraction, loss)))
    assert [fraction for fraction, _ in stated] == pytest.approx([0.2, 0.4, 0.6, 0.8, 1.0])
    assert tuple(loss for _, loss in stated) == result.losses


def test_it_ends_early_when_nothing_is_gained(
    box_views: ViewSet, box_surface: TriangleMesh
) -> None:
    # No loss can become better by all of itself.
    parts = scene(box_views, box_surface, Recipe.ORTHOGRAPHIC, patience=4, least_gain=1.0)
    result = trained(parts)
    assert (result.iterations, result.settled) == (5, True)
    assert not trained(scene(box_views, box_surface, Recipe.ORTHOGRAPHIC)).settled


def test_torch_gets_its_threads_back_even_after_a_failure(
    box_views: ViewSet, box_surface: TriangleMesh
) -> None:
    before = torch.get_num_threads()
    seen: list[int] = []

    def stop(fraction: float, loss: float | None) -> None:
        seen.append(torch.get_num_threads())
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        train(*scene(box_views, box_surface, Recipe.ORTHOGRAPHIC), stop)
    assert seen == [1]
    assert torch.get_num_threads() == before


def test_the_plain_back_end_trains_alike(box_views: ViewSet, box_surface: TriangleMesh) -> None:
    changes = {"count": 60, "pixels": 32, "iterations": 4}
    fast = scene(box_views, box_surface, Recipe.ORTHOGRAPHIC, **changes)
    plain = scene(box_views, box_surface, Recipe.ORTHOGRAPHIC, backend=Backend.REFERENCE, **changes)
    assert trained(fast).losses == pytest.approx(trained(plain).losses, rel=1e-4)
