"""Recipes and presets."""

from dataclasses import replace

import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import CameraModel
from gaussiancad_core.splatting.settings import training_cameras, training_settings
from gaussiancad_protocol.modes import Preset, Recipe

SIZE = (20.0, 12.0, 16.0)
ROLES = (Role.FRONT, Role.LEFT, Role.BOTTOM)


@pytest.mark.parametrize("preset", [Preset.STANDARD, Preset.FINE])
def test_paper_recipe_is_the_papers(preset: Preset) -> None:
    settings = training_settings(Recipe.PAPER, preset)
    assert settings.iterations == settings.patience == 10_000
    assert (settings.weights.ssim, settings.weights.mask) == (0.2, 0.01)
    assert settings.optics.dilation == 0.3
    assert settings.rates.epsilon == 1e-15
    assert settings.rates.position_steps == 30_000
    assert settings.anchor == 0.0
    assert not settings.thin_axis_locked
    assert settings.one_view
    density = settings.density
    assert (density.start, density.until, density.every) == (500, 6_000, 100)
    assert (density.pull, density.reset_every) == (2e-4, 1_000)
    for camera in training_cameras(Recipe.PAPER, settings, ROLES, SIZE):
        assert (camera.width, camera.height) == (1920, 1080)
        assert (camera.fx, camera.fy, camera.cx, camera.cy) == (2480.0, 2080.0, 960.0, 540.0)


@pytest.mark.parametrize("recipe", list(Recipe))
def test_images_are_scaled_down_and_nothing_else_is(recipe: Recipe) -> None:
    full = training_settings(recipe, Preset.STANDARD)
    small = training_settings(recipe, Preset.STANDARD, 4)
    assert small.pixels == full.pixels // 4
    assert replace(small, pixels=full.pixels) == full
    for one, other in zip(
        training_cameras(recipe, small, ROLES, SIZE),
        training_cameras(recipe, full, ROLES, SIZE),
        strict=True,
    ):
        assert one.fx / one.width == pytest.approx(other.fx / other.width)
        assert one.height == other.height // 4


@pytest.mark.parametrize("recipe", list(Recipe))
def test_finer_presets_do_more_work(recipe: Recipe) -> None:
    # The paper's is as printed at two of the presets, with more Gaussians at the finer one.
    work = [training_settings(recipe, preset) for preset in Preset]
    amounts = [settings.count * settings.pixels**2 * settings.iterations for settings in work]
    assert amounts == sorted(amounts)
    assert len(set(amounts)) == 3


@pytest.mark.parametrize(
    ("recipe", "model"),
    [(Recipe.ORTHOGRAPHIC, CameraModel.ORTHOGRAPHIC), (Recipe.PAPER, CameraModel.PINHOLE)],
)
def test_cameras_are_the_recipes_with_the_presets_size(recipe: Recipe, model: CameraModel) -> None:
    settings = training_settings(recipe, Preset.DRAFT)
    cameras = training_cameras(recipe, settings, ROLES, SIZE)
    assert [camera.role for camera in cameras] == list(ROLES)
    assert {camera.model for camera in cameras} == {model}
    assert {camera.width for camera in cameras} == {settings.pixels}
    assert len({camera.height for camera in cameras}) == 1
