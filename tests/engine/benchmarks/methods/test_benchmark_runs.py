"""One small part, drawn, made into models and measured."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from benchmarks.methods.benchmark_runs import SCRATCH, Effort, Method, Run, RunTask, run_task
from benchmarks.run.workers import Row
from benchmarks.sheets.benchmark_parts import Part, SheetKind, given_parts, make_sheet
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.samples.modelling import box, cut
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_protocol.modes import Preset

EFFORT = Effort(points=200, preset=Preset.DRAFT)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A solid angle, like none of its turned or mirrored images but for one."""
    folder = tmp_path_factory.mktemp("parts")
    angle = cut(box((0, 0, 0), (60, 40, 30)), box((20, -1, 10), (61, 41, 31)))
    write_step(angle, folder / "angle.step")
    return folder


def last(bits: Iterator[Row]) -> Row:
    row: Row = {}
    for bit in bits:
        row.update(bit)
    return row["models"]


def only(folder: Path, projection: Projection = Projection.THIRD) -> Part:
    (part,) = given_parts(folder, projection)
    return part


def task_of(part: Part, kind: SheetKind, run: Run, folder: Path) -> RunTask:
    return RunTask(part, kind, run, EFFORT, folder, pictures=True)


def test_ends_are_wrong_by_more_at_each_strength(folder: Path, tmp_path: Path) -> None:
    part = only(folder)
    solid = part.case.truth()
    images = {}
    for kind in (SheetKind.CLEAN, SheetKind.ENDS_1, SheetKind.ENDS_3, SheetKind.ENDS_8):
        place = tmp_path / kind.name
        place.mkdir()
        sheet = make_sheet(part, solid, kind, place, tmp_path)
        images[kind] = read_sheet(sheet).grey.astype(float)
    clean = images.pop(SheetKind.CLEAN)
    changed = [int((np.abs(image - clean) > 100.0).sum()) for image in images.values()]
    assert 0 < changed[0] < changed[1] < changed[2]


def test_outlines_are_made_into_models_and_measured(folder: Path, tmp_path: Path) -> None:
    models = last(run_task(task_of(only(folder), SheetKind.CLEAN, Run.OUTLINES, tmp_path)))
    assert set(models) == {Method.HULL.value, Method.SWEEP.value}
    swept = models[Method.SWEEP.value]
    assert swept["exact"] and swept["status"] == "approximate"
    for model in models.values():
        comparison = model["comparison"]
        assert set(comparison["protocols"]) == {"gaussiancad", "deepcad", "engineering"}
        # An angle is its own hull but for the pixels.
        assert comparison["protocols"]["engineering"]["volume_iou"] > 0.98
        assert comparison["points"] == 200
        assert model["picture"].startswith("/9j/") and model["seconds"] > 0.0
    assert not list((tmp_path / SCRATCH).iterdir())


def test_solids_of_given_sheets_are_turned_to_fit(folder: Path, tmp_path: Path) -> None:
    drawn = only(folder)
    sheet = make_sheet(drawn, drawn.case.truth(), SheetKind.CLEAN, tmp_path, tmp_path)
    pairs = tmp_path / "pairs"
    pairs.mkdir()
    # The same angle lying otherwise, and in other units.
    turned = cut(box((0, 0, 0), (3, 6, 4)), box((1, 2, -1), (4, 7, 5)))
    write_step(turned, pairs / "angle.step")
    sheet.rename(pairs / "angle.png")
    models = last(run_task(task_of(only(pairs), SheetKind.GIVEN, Run.OUTLINES, tmp_path)))
    assert models[Method.SWEEP.value]["exact"]
    found = models[Method.HULL.value]["comparison"]
    assert found["protocols"]["deepcad"]["volume_iou"] > 0.98
    # The solid's own millimetres, whatever the sheet's are.
    assert max(found["result"]["extent_mm"]) == pytest.approx(6.0, rel=1e-6)
    assert found["reference"]["extent_mm"] == pytest.approx([6.0, 4.0, 3.0])
