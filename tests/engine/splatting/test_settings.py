"""Recipes and presets."""

import pytest

from gaussiancad_core.axes import Role
from gaussiancad_core.cameras import CameraModel
from gaussiancad_core.modes import Preset, Recipe
from gaussiancad_core.splatting.settings import training_cameras, training_settings

SIZE = (20.0, 12.0, 16.0)
ROLES = (Role.FRONT, Role.LEFT, Role.BOTTOM)


def test_paper_recipe_is_the_papers() -> None:
    fine = training_settings(Recipe.PAPER, Preset.FINE)
    assert fine.iterations == 10_000
    assert fine.weights.ssim == 0.2
    assert fine.optics.dilation == 0.3
    assert fine.rates.epsilon == 1e-15
    assert fine.anchor == 0.0
    assert not fine.thin_axis_locked


@pytest.mark.parametrize("preset", list(Preset))
def test_default_recipe_holds_the_hull(preset: Preset) -> None:
    settings = training_settings(Recipe.ORTHOGRAPHIC, preset)
    assert settings.anchor == 5.0
    assert settings.thin_axis_locked
    assert settings.optics.dilation == 0.02
    assert settings.rates.position == pytest.approx(8e-4 / 5)


@pytest.mark.parametrize("recipe", list(Recipe))
def test_finer_presets_do_more_work(recipe: Recipe) -> None:
    work = [training_settings(recipe, preset) for preset in Preset]
    amounts = [settings.count * settings.pixels**2 * settings.iterations for settings in work]
    assert amounts == sorted(amounts)
    assert len(set(amounts)) == 3


@pytest.mark.parametrize(
    ("recipe", "model"),
    [
        (Recipe.ORTHOGRAPHIC, CameraModel.ORTHOGRAPHIC),
        (Recipe.PAPER, CameraModel.PINHOLE),
    ],
)
def test_cameras_are_the_recipes_with_the_presets_size(recipe: Recipe, model: CameraModel) -> None:
    settings = training_settings(recipe, Preset.DRAFT)
    cameras = training_cameras(recipe, settings, ROLES, SIZE)
    assert [camera.role for camera in cameras] == list(ROLES)
    assert {camera.model for camera in cameras} == {model}
    assert {camera.width for camera in cameras} == {settings.pixels}
    assert len({camera.height for camera in cameras}) == 1
