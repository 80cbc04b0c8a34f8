"""Trainings that are broken off and go on end as those that were not."""

import os
import subprocess
import sys
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.splatting.checkpoints import CheckpointPlace
from gaussiancad_core.splatting.gaussian_training import TrainingResult, train
from gaussiancad_core.splatting.gaussians import Gaussians, Start, gaussians_on
from gaussiancad_core.splatting.settings import (
    DensityControl,
    TrainingSettings,
    training_cameras,
    training_settings,
)
from gaussiancad_core.splatting.targets import targets_of
from gaussiancad_protocol.modes import Preset, Recipe

BUSY = DensityControl(start=2, until=40, every=5, pull=1e-5, reset_every=12)
RECIPES = pytest.mark.parametrize("recipe", list(Recipe))


def settings_of(recipe: Recipe) -> TrainingSettings:
    found = replace(training_settings(recipe, Preset.DRAFT), count=150, pixels=48, iterations=20)
    return replace(found, density=BUSY) if recipe is Recipe.PAPER else found


class Stopped(Exception):
    """A training was broken off."""


class Bench:
    """Trainings of one scene in one folder."""

    def __init__(self, views: ViewSet, surface: TriangleMesh, folder: Path) -> None:
        self.views, self.surface = views, surface
        self.place = CheckpointPlace(folder / "c.npz", folder, interval_s=0.0, resume=True)

    def run(
        self, settings: TrainingSettings, stop: int | None = None, *, kept: bool = True
    ) -> TrainingResult:
        """Train; break off after ``stop`` iterations of this run."""
        made = 0

        def count(_fraction: float, _loss: float | None) -> None:
            nonlocal made
            made += 1
            if made == stop:
                raise Stopped

        cameras = training_cameras(Recipe.ORTHOGRAPHIC, settings, self.views.roles, self.views.size)
        if settings.one_view:
            cameras = training_cameras(Recipe.PAPER, settings, self.views.roles, self.views.size)
        start = gaussians_on(self.surface, Start(settings.count, thickness=settings.thickness))
        targets = targets_of(self.views, cameras)
        place = self.place if kept else None
        return train(start, cameras, targets, settings, count, place=place)


@pytest.fixture
def bench(box_views: ViewSet, box_surface: TriangleMesh, tmp_path: Path) -> Bench:
    return Bench(box_views, box_surface, tmp_path)


def same(one: Gaussians, other: Gaussians) -> bool:
    return all(
        np.array_equal(getattr(one, field.name), getattr(other, field.name))
        for field in fields(Gaussians)
    )


@RECIPES
@pytest.mark.parametrize("stop", [1, 7, 19])
def test_a_broken_off_training_ends_bit_for_bit_as_an_unbroken_one(
    bench: Bench, recipe: Recipe, stop: int
) -> None:
    settings = settings_of(recipe)
    whole = bench.run(settings, kept=False)
    with pytest.raises(Stopped):
        bench.run(settings, stop)
    again = bench.run(settings)
    assert (again.resumed, again.iterations) == (stop, 20)
    assert again.losses == whole.losses
    assert same(again.gaussians, whole.gaussians)
    assert whole.resumed == 0 and not again.passed_over


def test_it_can_be_broken_off_again_and_again(bench: Bench) -> None:
    settings = settings_of(Recipe.PAPER)
    whole = bench.run(settings, kept=False)
    assert len(whole.gaussians) != 150
    for _ in range(4):
        with pytest.raises(Stopped):
            bench.run(settings, 4)
    again = bench.run(settings)
    assert again.resumed == 16
    assert same(again.gaussians, whole.gaussians)


@pytest.mark.parametrize("change", [{"seed": 1}, {"iterations": 21}, {"anchor": 2.0}])
def test_a_checkpoint_of_other_settings_is_passed_over(bench: Bench, change: dict) -> None:
    settings = settings_of(Recipe.ORTHOGRAPHIC)
    bench.run(settings)
    other = bench.run(replace(settings, **change))
    assert other.passed_over and other.resumed == 0
    assert same(other.gaussians, bench.run(replace(settings, **change), kept=False).gaussians)


def test_a_checkpoint_of_other_views_is_passed_over(bench: Bench) -> None:
    settings = settings_of(Recipe.ORTHOGRAPHIC)
    bench.run(settings)
    first, *others = bench.views.views
    changed = replace(first, mask=np.roll(first.mask, 1, axis=0))
    bench.views = ViewSet((changed, *others), bench.views.size)
    assert bench.run(settings).passed_over


@pytest.mark.parametrize("content", [b"", b"no zip file", b"PK\x03\x04 and then nothing", None])
def test_a_damaged_checkpoint_is_passed_over(bench: Bench, content: bytes | None) -> None:
    settings = settings_of(Recipe.ORTHOGRAPHIC)
    bench.run(settings)
    path = bench.place.path
    path.write_bytes(path.read_bytes()[:-100] if content is None else content)
    again = bench.run(settings)
    assert again.passed_over and again.resumed == 0


def test_nothing_in_a_checkpoint_is_executed(bench: Bench) -> None:
    """An array of objects is a pickle, and unpickling runs what it says."""

    class Trap:
        def __reduce__(self) -> tuple:
            return os.mkdir, (str(bench.place.staging / "sprung"),)

    np.savez(bench.place.path, training=np.array([Trap()], dtype=object))
    assert bench.run(settings_of(Recipe.ORTHOGRAPHIC)).passed_over
    assert not (bench.place.staging / "sprung").exists()


def test_short_trainings_leave_none_and_none_is_read_unasked(bench: Bench) -> None:
    settings = settings_of(Recipe.ORTHOGRAPHIC)
    asked = bench.place
    bench.place = replace(asked, interval_s=3600.0)
    bench.run(settings)
    assert not asked.path.exists()
    bench.place = replace(asked, resume=False)
    with pytest.raises(Stopped):
        bench.run(settings, 5)
    assert [path.name for path in asked.staging.iterdir()] == ["c.npz"]
    assert bench.run(settings).resumed == 0


def test_a_folder_that_cannot_be_written_is_told(bench: Bench) -> None:
    bench.place = replace(bench.place, staging=bench.place.staging / "gone")
    with pytest.raises(UsageError):
        bench.run(settings_of(Recipe.ORTHOGRAPHIC))


_KILLED = """
import os, signal, sys
import numpy as np
from pathlib import Path
import trimesh
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.cameras import orthographic_camera
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.splatting.checkpoints import CheckpointPlace
from gaussiancad_core.splatting.gaussians import Start, gaussians_on
from gaussiancad_core.splatting.losses import Targets
from gaussiancad_core.splatting.ply import write_gaussians
from gaussiancad_core.splatting.settings import TrainingSettings
from gaussiancad_core.splatting.gaussian_training import train
import torch

folder, last = Path(sys.argv[1]), int(sys.argv[2])
size = (20.0, 12.0, 16.0)
box = trimesh.creation.box(bounds=[(0, 0, 0), size])
cameras = tuple(orthographic_camera(role, size, 48) for role in (Role.FRONT, Role.TOP, Role.RIGHT))
masks = torch.zeros(3, 48, 48)
masks[:, 10:40, 8:42] = 1.0
targets = Targets((1.0 - masks)[:, None].repeat(1, 3, 1, 1), masks)
made = 0

def kill(fraction, loss):
    global made
    made += 1
    if made == last:
        os.kill(os.getpid(), signal.SIGKILL)

start = gaussians_on(make_mesh(box.vertices, box.faces), Start(100))
place = CheckpointPlace(folder / "c.npz", folder, interval_s=0.0, resume=True)
result = train(start, cameras, targets, TrainingSettings(iterations=12), kill, place=place)
write_gaussians(result.gaussians, folder / "gaussians.ply")
print(result.resumed)
"""


def test_a_killed_process_goes_on_in_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    found = []
    for name, killed in (("broken", True), ("whole", False)):
        folder = tmp_path / name
        folder.mkdir()
        if killed:
            command = [sys.executable, "-c", _KILLED, str(folder), "5"]
            done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
            assert done.returncode == -9, done.stderr
        monkeypatch.setattr(sys, "argv", ["", str(folder), "0"])
        exec(compile(_KILLED, "goes on", "exec"), {})
        assert sorted(path.name for path in folder.iterdir()) == ["c.npz", "gaussians.ply"]
        resumed = int(capsys.readouterr().out)
        found.append(((folder / "gaussians.ply").read_bytes(), resumed))
    assert found[0][0] == found[1][0]
    assert (found[0][1], found[1][1]) == (5, 0)
