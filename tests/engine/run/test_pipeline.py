"""One draft run from sheet to files, and what becomes of runs that fail, stop or are killed."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import psutil
import pytest
import trimesh
from OCP.Standard import Standard_NullObject

from gaussiancad_core.cli import main
from gaussiancad_core.comparison.distances import point_to_surface, volume_iou
from gaussiancad_core.comparison.model_files import load_model
from gaussiancad_core.comparison.queries import SurfaceQueries
from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.errors import EngineError, LimitError, NoModelError
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.kernel.brep import moved_to_origin, soundness, tessellate
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.report.job import Job
from gaussiancad_core.run import exact_stage, surface_stage
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_core.run.pipeline import STAGES, reconstruct, stages_of
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.storage.outputs import PUBLISHED_FILE, STAGING_PREFIX
from gaussiancad_protocol.modes import Preset, ResultKind, SolidWay, Status
from sample_parts import SAMPLES

FILES = {
    *("report.json", "reading.json", "solid.step", "surface.stl", "surface.ply", "surface.step"),
    *("hull.stl", "gaussians.ply", "cameras", "overlay.png", "preview.png"),
}


def _command(sheet: Path, output: Path, *options: str) -> list[str]:
    run = [sys.executable, "-I", "-m", "gaussiancad_core", "reconstruct", str(sheet)]
    return [*run, "--output", str(output), "--preset", "draft", *options]


def _events(text: str) -> list[dict]:
    return [json.loads(line) for line in text.splitlines()]


@pytest.fixture(scope="session")
def sheet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The bracket in first angle: front, top below it, left to its right."""
    part = next(sample for sample in SAMPLES if sample.name == "l-bracket")
    roles = (Role.FRONT, Role.TOP, Role.LEFT)
    drawn = draw_sheet(part.build(), roles, Projection.FIRST, parse_style("clean"))
    path = tmp_path_factory.mktemp("a folder 图") / "sheet 三.png"
    write_image(drawn.image, path)
    return path


@pytest.fixture(scope="session")
def run(sheet: Path) -> tuple[Path, list[dict]]:
    """A finished run: its folder and its events."""
    output = sheet.parent / "model 模"
    options = ("--projection", "first", "--length", "x=80", "--events")
    process = subprocess.Popen(
        _command(sheet, output, *options),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
    )
    # Standard input stays open: its end would stop the run.
    lines = process.stdout.read()
    errors = process.stderr.read()
    process.stdin.close()
    assert process.wait() == 0, errors
    return output, _events(lines)


def test_the_report_has_what_others_rely_on(run: tuple) -> None:
    report = json.loads((run[0] / "report.json").read_text("utf-8"))
    assert report["schema"] == 2 and report["status"] == "verified"
    assert report["reasons"] == report["warnings"] == []
    assert (report["projection"], report["projection_source"]) == ("first", "given")
    assert report["projection_alternatives"] == []
    solid = report["solid"]
    assert (solid["valid"], solid["closed"], solid["alternatives"]) == (True, True, 0)
    assert solid["faces"] == 10
    assert solid["source"] == "lines"
    assert solid["bounding_box_mm"] == pytest.approx([80, 50, 60], abs=0.2)
    assert set(report["views"]) == {"front", "top", "left"}
    for view in report["views"].values():
        x0, y0, x1, y1 = view["box"]
        assert 0 < x0 < x1 < 1920 and 0 < y0 < y1 < 1080
        shares = [view[f"{k}_{m}"] for k in ("visible", "hidden") for m in ("recall", "precision")]
        assert all(0.0 <= share <= 1.0 for share in shares)
        assert min(shares) > 0.95
    assert report["scale_source"] == "given" and report["scale_mm_per_pixel"] > 0
    assert report["strokes_source"] == "raster"
    assert set(report["residuals_px"]) == {"x", "y", "z"}
    for residual in report["residuals_px"].values():
        assert 0.0 <= residual["median"] <= residual["max"] < 0.5
    assert report["hull"] == {"carved_from": None, "regions": 0, "doubted": 0, "refused": ""}
    assert report["surface"]["watertight"] is True
    # Masks that agree leave nothing to mend: the hull has the sharper edges.
    assert report["surface"]["nearer"] == "hull"
    shares = report["surface"]["outline_difference"]
    assert 0.0 < shares["hull"] < shares["gaussians"] < 0.02
    gaussians = report["gaussians"]
    assert gaussians["count"] > 0 and gaussians["loss"] < 0.2
    assert gaussians["image_px"] == [128, 128] and gaussians["resumed"] == 0
    assert set(gaussians["residuals"]) == {"front", "top", "left"}
    for residual in gaussians["residuals"].values():
        assert 0.0 <= residual["difference"] < 0.2
    assert set(report["seconds"]) == set(STAGES) and report["peak_memory_mb"] > 0
    assert len(report["engine"]["sheet_sha256"]) == 64 and report["engine"]["seed"] == 0


def test_events_tell_the_stages_in_order_and_the_solid_before_any_gaussian(run: tuple) -> None:
    output, events = run
    assert events[0]["event"] == "hello" and events[0]["protocol"] == 1
    stages = [event for event in events if event["event"] == "stage"]
    assert [stage["name"] for stage in stages] == list(STAGES)
    assert [stage["index"] for stage in stages] == list(range(1, len(STAGES) + 1))
    assert {stage["of"] for stage in stages} == {len(STAGES)}
    progress = [event for event in events if event["event"] == "progress"]
    assert all(0.0 <= event["fraction"] <= 1.0 for event in progress)
    assert any("loss" in event for event in progress)
    assert events[-1]["event"] == "result"
    assert Path(events[-1]["path"]) == (output / "report.json").resolve()
    at = next(i for i, event in enumerate(events) if event["event"] == "solid")
    before = [event["name"] for event in events[:at] if event["event"] == "stage"]
    assert before[-1] == "solid"
    assert Path(events[at]["path"]) == (output / "solid.step").resolve()
    assert events[at]["status"] == "verified" == events[-1]["status"]


def test_the_surface_is_made_of_the_gaussians_and_is_the_part_in_its_own_axes(run: tuple) -> None:
    surface, hull = (load_model(run[0] / name) for name in ("surface.stl", "hull.stl"))
    centres = np.asarray(trimesh.load(run[0] / "gaussians.ply").vertices)
    truth = next(sample for sample in SAMPLES if sample.name == "l-bracket").build()
    expected = soundness(truth).volume_mm3
    # Poisson's vertices are many and lie where the Gaussians do; a hull of planes needs few.
    assert len(hull.triangles) < len(surface.triangles) / 4
    assert np.median(SurfaceQueries(surface).distances(centres)) < 0.1
    for mesh in (surface, hull):
        assert mesh.watertight
        assert mesh.volume == pytest.approx(expected, rel=0.03)
    # Along edges Poisson stands out by a hundredth of the longest one.
    assert surface.bounds == pytest.approx(np.array([[0, 0, 0], [80, 50, 60]]), abs=1.0)
    part = TriangleMesh(*tessellate(moved_to_origin(truth), 0.02))
    streams = random_streams(0, 3)
    sides = [
        (SurfaceQueries(mesh), sample_surface(mesh, 4000, stream))
        for mesh, stream in zip((surface, part), streams, strict=False)
    ]
    assert volume_iou(sides[0][0], sides[1][0], streams[2]).value > 0.97
    assert point_to_surface(*sides) < 0.01 * 80 / 5


def test_the_exact_solid_is_the_part(run: tuple) -> None:
    part = next(sample for sample in SAMPLES if sample.name == "l-bracket")
    truth = moved_to_origin(part.build())
    solid = read_solid(run[0] / "solid.step")
    state, expected = soundness(solid), soundness(truth)
    assert state.valid and state.closed and state.solids == 1
    assert state.faces == expected.faces
    assert state.volume_mm3 == pytest.approx(expected.volume_mm3, rel=5e-3)
    report = json.loads((run[0] / "report.json").read_text("utf-8"))
    assert report["solid"]["volume_mm3"] == pytest.approx(state.volume_mm3, rel=1e-6)


def test_a_run_for_the_solid_alone_makes_no_surface(plain_sheet: Path, tmp_path: Path) -> None:
    report = reconstruct(Job(plain_sheet, tmp_path, result=ResultKind.SOLID), Silence())
    found = {path.name for path in tmp_path.iterdir()}
    assert found == {"report.json", "reading.json", "solid.step", "overlay.png", "preview.png"}
    assert report.status is Status.VERIFIED
    assert report.surface is None and report.gaussians is None
    assert tuple(report.seconds) == stages_of(ResultKind.SOLID)


def test_a_run_for_the_surface_alone_has_the_same_bytes_and_no_solid(
    run: tuple, sheet: Path, tmp_path: Path
) -> None:
    job = replace(_job(sheet, tmp_path, ResultKind.SURFACE), transforms=True)
    report = reconstruct(job, Silence())
    assert {path.name for path in tmp_path.iterdir()} == FILES - {"solid.step"}
    assert (tmp_path / "cameras" / "transforms.json").is_file()
    assert report.status is Status.APPROXIMATE and report.solid is None
    assert "no-exact-solid" in {reason.code for reason in report.reasons}
    assert tuple(report.seconds) == stages_of(ResultKind.SURFACE)
    for name in ("surface.stl", "gaussians.ply", "cameras/points3D.txt"):
        assert (tmp_path / name).read_bytes() == (run[0] / name).read_bytes()


def test_the_step_file_is_a_sound_solid_of_few_faces(run: tuple) -> None:
    solid = read_solid(run[0] / "surface.step")
    state = soundness(solid)
    assert state.valid and state.closed and state.solids == 1
    assert state.volume_mm3 == pytest.approx(load_model(run[0] / "surface.stl").volume, rel=0.01)
    assert (run[0] / "surface.step").read_text("utf-8").count("ADVANCED_FACE") <= 3000


def test_every_file_is_there_and_pictures_show_something(run: tuple) -> None:
    assert {path.name for path in run[0].iterdir()} == FILES
    for name in ("overlay.png", "preview.png", "cameras/images/front.png"):
        image = cv2.imdecode(np.fromfile(run[0] / name, np.uint8), cv2.IMREAD_COLOR)
        assert image is not None and image.std() > 5


def test_resuming_a_finished_run_keeps_it(run: tuple, sheet: Path) -> None:
    before = (run[0] / "report.json").stat().st_mtime_ns
    reconstruct(replace(_job(sheet, run[0]), resume=True), Silence())
    assert (run[0] / "report.json").stat().st_mtime_ns == before
    assert {path.name for path in run[0].iterdir()} == FILES


def test_a_failed_run_says_so_and_leaves_no_model(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    image = np.full((600, 800), 255, np.uint8)
    cv2.rectangle(image, (200, 200), (500, 400), 0, 3)
    cv2.imwrite(str(tmp_path / "one.png"), image)
    output = tmp_path / "out"
    output.mkdir()
    _left_by_a_run(output, "surface.stl")
    assert main(["reconstruct", str(tmp_path / "one.png"), "--output", str(output)]) == 4
    errors = capsys.readouterr().err
    assert errors.count("\n") == 1 and "[one-view]" in errors
    assert [path.name for path in output.iterdir()] == ["report.json"]
    report = json.loads((output / "report.json").read_text("utf-8"))
    assert report["status"] == "failed" and report["reasons"][0]["code"] == "one-view"
    assert report["surface"] is None


def _job(sheet: Path, output: Path, result: ResultKind = ResultKind.BOTH) -> Job:
    projection = Projection.FIRST if sheet.suffix == ".png" else Projection.THIRD
    reading = ReadingOptions(projection, lengths=((Axis.X, 80.0),))
    return Job(sheet, output, reading, result=result, preset=Preset.DRAFT)


def _raising(error: Exception) -> Callable[..., None]:
    def stand_in(*_arguments: object, **_options: object) -> None:
        raise error

    return stand_in


def test_gaussians_that_bound_no_body_take_nothing_from_the_solid(
    plain_sheet: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    nothing = NoModelError("no-surface", "the Gaussians bound no body")
    monkeypatch.setattr(surface_stage, "make_surface", _raising(nothing))
    reconstruct(_job(plain_sheet, tmp_path), Silence())
    surfaces = {"surface.stl", "surface.ply", "surface.step"}
    assert {path.name for path in tmp_path.iterdir()} == FILES - surfaces
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["status"] == "verified" and report["surface"] is None
    assert [warning["code"] for warning in report["warnings"]] == ["no-surface"]
    with pytest.raises(NoModelError):
        reconstruct(_job(plain_sheet, tmp_path, ResultKind.SURFACE), Silence())
    assert {path.name for path in tmp_path.iterdir()} == {"report.json", "reading.json"}


def test_a_limit_after_the_solid_leaves_the_solid_and_says_so(
    plain_sheet: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(surface_stage, "train_on", _raising(MemoryError()))
    with pytest.raises(LimitError):
        reconstruct(_job(plain_sheet, tmp_path), Silence())
    assert {path.name for path in tmp_path.iterdir()} == {
        "report.json",
        "reading.json",
        "solid.step",
    }
    report = json.loads((tmp_path / "report.json").read_text("utf-8"))
    assert report["status"] == "approximate"
    assert [reason["code"] for reason in report["reasons"]] == ["out-of-memory"]
    assert report["solid"]["faces"] == 9 and report["surface"] is None


def _left_by_a_run(output: Path, *names: str) -> None:
    """Files of an earlier run, and its report."""
    for name in names:
        (output / name).write_text("of an earlier run")
    report = {"engine": {}, "files": {name: {} for name in names}}
    (output / "report.json").write_text(json.dumps(report))


def _started(sheet: Path, output: Path, stage: str) -> subprocess.Popen:
    """A run that has reached a stage."""
    process = subprocess.Popen(
        _command(sheet, output, "--events"),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
    )
    for line in process.stdout:
        event = json.loads(line)
        if event["event"] == "stage" and event["name"] == stage:
            return process
    raise AssertionError(process.stderr.read())


@pytest.mark.parametrize("way", ["line", "end", "signal"])
def test_a_cancelled_run_leaves_nothing(plain_sheet: Path, tmp_path: Path, way: str) -> None:
    output = tmp_path / "out"
    process = _started(plain_sheet, output, "lines")
    if way == "line":
        process.stdin.write("cancel\n")
        process.stdin.flush()
    elif way == "end":
        process.stdin.close()
    else:
        process.send_signal(signal.SIGTERM)
    events = _events(process.stdout.read())
    assert process.wait() == 130
    assert events[-1]["event"] == "error" and events[-1]["code"] == "cancelled"
    assert "lines (3 of 10): nothing was written" in events[-1]["message"]
    causes = {"line": "on standard input", "end": "standard input ended", "signal": "by SIGTERM"}
    assert causes[way] in events[-1]["message"]
    assert not output.exists()


def test_a_run_that_is_cancelled_later_leaves_its_solid_and_nothing_of_an_earlier_run(
    plain_sheet: Path, tmp_path: Path
) -> None:
    _left_by_a_run(tmp_path, "surface.stl")
    (tmp_path / "mine.txt").write_text("of nobody else")
    process = _started(plain_sheet, tmp_path, "gaussians")
    process.stdin.write("cancel\n")
    process.stdin.flush()
    events = _events(process.stdout.read())
    assert process.wait() == 130
    assert (
        "gaussians (7 of 10): only the reading and the solid were written" in events[-1]["message"]
    )
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {"mine.txt", "reading.json", "solid.step", PUBLISHED_FILE}
    state = soundness(read_solid(tmp_path / "solid.step"))
    assert state.valid and state.closed


def test_a_killed_run_leaves_no_half_file_and_is_swept(plain_sheet: Path, tmp_path: Path) -> None:
    output = tmp_path / "out"
    whole = {"reading.json", "solid.step", PUBLISHED_FILE}
    process = _started(plain_sheet, output, "gaussians")
    engines = psutil.Process(process.pid).children()
    process.kill()
    process.wait()
    psutil.wait_procs(engines)
    (left,) = {path.name for path in output.iterdir()} - whole
    assert left.startswith(STAGING_PREFIX)
    again = _started(plain_sheet, output, "views")
    assert not (output / left).exists()
    (item,) = {path.name for path in output.iterdir()} - whole
    assert item.startswith(STAGING_PREFIX)
    again.kill()
    again.wait()


def test_a_reader_that_goes_away_is_no_error_of_the_run(plain_sheet: Path, tmp_path: Path) -> None:
    process = _started(plain_sheet, tmp_path / "out", "read")
    process.stdout.close()
    os.kill(process.pid, signal.SIGTERM)
    assert process.wait() == 130
    assert "Traceback" not in process.stderr.read()


def test_a_way_in_which_the_kernel_breaks_down_is_left_out(
    plain_sheet: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ways: list[SolidWay] = []

    def find_exact(*readings: ProjectedReading, way: SolidWay, **more: bool) -> ExactModel:
        ways.append(way)
        if way is SolidWay.ALL:
            raise Standard_NullObject("no shape")
        return exact_stage_find_exact(*readings, way=way, **more)

    exact_stage_find_exact = exact_stage.find_exact
    monkeypatch.setattr(exact_stage, "find_exact", find_exact)
    report = reconstruct(Job(plain_sheet, tmp_path, result=ResultKind.SOLID), Silence())
    assert ways == [SolidWay.ALL, SolidWay.SKETCH]
    assert report.status is Status.APPROXIMATE
    assert report.reasons[0].code == "solid-way-left-out"
    assert report.solid.valid


def test_where_the_kernel_breaks_down_in_all_ways_nothing_is_made(
    plain_sheet: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(exact_stage, "find_exact", _raising(Standard_NullObject("no shape")))
    with pytest.raises(EngineError) as caught:
        reconstruct(Job(plain_sheet, tmp_path, result=ResultKind.SOLID), Silence())
    assert caught.value.code == "unforeseen"
    assert json.loads((tmp_path / "report.json").read_text())["stage"] == "solid"
