"""Whole comparisons of files."""

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from OCP.BRep import BRep_Builder
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.BRepTools import BRepTools
from OCP.TopoDS import TopoDS_Compound

from gaussiancad_core.cli import main
from gaussiancad_core.comparison.compare_command import COMPARISON_FILES, compare_files
from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import CompareOptions, Protocol
from gaussiancad_core.comparison.comparison_report import Comparison, comparison_dict
from gaussiancad_core.comparison.comparison_text import comparison_text
from gaussiancad_core.comparison.deviation import Deviation
from gaussiancad_core.comparison.distances import IouMethod
from gaussiancad_core.comparison.model_files import Model
from gaussiancad_core.comparison.normalise import moved_points, scale_of
from gaussiancad_core.comparison.rigid_registration import axis_rotations
from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh


def compare_meshes(
    result: TriangleMesh, reference: TriangleMesh, points: int = 10_000, seed: int = 0
) -> tuple[Comparison, Deviation]:
    return compare_models(Model(result), Model(reference), CompareOptions(points, seed))


def test_a_model_equals_itself(bracket: TriangleMesh) -> None:
    found, deviation = compare_meshes(bracket, bracket)
    assert found.point_to_surface == pytest.approx(0.0, abs=1e-6)
    assert found.volume_iou.value == pytest.approx(1.0, abs=1e-9)
    assert found.volume_iou.method is IouMethod.BOOLEAN
    assert found.matrix == pytest.approx(np.eye(4), abs=1e-12)
    assert found.distances.chamfer == pytest.approx(found.floor.chamfer, rel=0.03)
    assert found.distances.emd == pytest.approx(found.floor.emd, rel=0.15)
    assert not found.mirrored
    assert np.abs(deviation.distances).max() < 1e-3


def test_the_matrix_maps_file_to_file(bracket: TriangleMesh) -> None:
    """Turned, shrunk and moved away: the matrix brings every vertex back."""
    turn = axis_rotations()[13]
    moved = make_mesh(bracket.vertices @ turn.T * 0.25 + [100, -50, 7], bracket.triangles)
    found, deviation = compare_meshes(moved, bracket, points=2000)
    assert moved_points(moved.vertices, found.matrix) == pytest.approx(bracket.vertices, abs=1e-9)
    assert scale_of(found.matrix) == pytest.approx(4.0)
    assert found.unit_mm == pytest.approx(8.0)
    assert deviation.mesh.bounds == pytest.approx(bracket.bounds, abs=1e-6)


def test_a_box_against_one_twice_as_long(box: Callable[..., TriangleMesh]) -> None:
    """In the 5-unit box: 5 x 2.5 x 2.5 against a cube of 5; one fits into the other."""
    found, _ = compare_meshes(box(20, 10, 10), box(10, 10, 10), points=4000)
    assert found.volume_iou.value == pytest.approx(0.25)
    assert found.distances.hausdorff == pytest.approx(1.25 * np.sqrt(2), abs=0.1)
    assert scale_of(found.matrix) == pytest.approx(0.5)


def test_deviation_is_measured_in_the_results_own_size(box: Callable[..., TriangleMesh]) -> None:
    """The protocol's box would scale a block that is 1 % too long, and shift all its faces."""
    found, deviation = compare_meshes(box(101, 60, 30), box(100, 60, 30), points=1000)
    assert scale_of(found.matrix) == pytest.approx(100 / 101)
    assert found.deviation.scale == 1.0
    assert np.ptp(deviation.mesh.bounds, axis=0) == pytest.approx([101, 60, 30])
    # Flush at one end or in the middle: both are as near on the whole.
    low, high = deviation.mesh.bounds[:, 0]
    along = deviation.mesh.vertices[:, 0]
    ends = [deviation.distances[np.abs(along - end) < 1e-6].max() for end in (low, high)]
    assert sum(ends) == pytest.approx(1.0, abs=0.04)
    assert min(ends) > -0.02
    assert np.quantile(np.abs(deviation.distances), 0.5) < 0.02


def test_deviation_of_another_scale_is_scaled(bracket: TriangleMesh) -> None:
    found, deviation = compare_meshes(
        make_mesh(bracket.vertices / 25.4, bracket.triangles), bracket, points=1000
    )
    assert found.deviation.scale == pytest.approx(25.4)
    assert deviation.mesh.bounds == pytest.approx(bracket.bounds, abs=1e-6)
    assert found.deviation.greatest_mm < 1e-3


def test_same_seed_same_numbers(bracket: TriangleMesh, box: Callable[..., TriangleMesh]) -> None:
    pairs = [compare_meshes(box(40, 30, 20), bracket, 1000, seed)[0] for seed in (3, 3, 4)]
    assert comparison_dict(pairs[0]) == comparison_dict(pairs[1])
    assert pairs[0].distances.chamfer != pairs[2].distances.chamfer


def test_files_are_written_as_promised(bracket: TriangleMesh, tmp_path: Path) -> None:
    solid, mesh = tmp_path / "Klotz ä.STEP", tmp_path / "part.stl"
    write_step(BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape(), solid)
    bracket.to_trimesh().export(mesh)
    output = tmp_path / "out put"
    found = compare_files(mesh, solid, output, CompareOptions(points=1000, seed=5))
    assert {path.name for path in output.iterdir()} <= set(COMPARISON_FILES)
    report = json.loads((output / "comparison.json").read_text("utf-8"))
    assert report == json.loads(json.dumps(comparison_dict(found)))
    assert report["schema"] == 1
    assert (report["points"], report["seed"]) == (1000, 5)
    assert set(report["floor"]) == {"chamfer", "hausdorff", "emd"}
    assert np.array(report["registration"]["matrix"]).shape == (4, 4)
    assert report["registration"]["mirrored"] is False
    assert report["volume_iou"] == pytest.approx(bracket.volume / 24000, abs=0.02)
    assert report["deviation"]["range_mm"] > 0
    assert (output / "deviation.ply").read_bytes().startswith(b"ply\n")


def test_the_command_takes_all_options(
    bracket: TriangleMesh, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    part = tmp_path / "part.stl"
    bracket.to_trimesh().export(part)
    asked = ["--protocol", "deepcad,engineering", "--register", "axes", "--scale", "fixed"]
    asked += ["--tolerance", "0.5", "--points", "500", "--seed", "3", "--factor", "2"]
    assert main(["compare", str(part), str(part), *asked, "--json"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert list(report["protocols"]) == ["deepcad", "engineering"]
    assert report["protocols"]["engineering"]["tolerance_mm"] == 0.5
    assert report["protocols"]["engineering"]["volume_difference_share"] == pytest.approx(7.0)
    assert report["registration"]["mode"] == "axes"
    assert report["registration"]["scale"] == pytest.approx(1.0)
    assert report["result"]["extent_mm"] == pytest.approx([80, 60, 40])
    assert main(["compare", str(part), str(part), *asked]) == 0
    text = capsys.readouterr().out
    assert "deepcad: 8192 points" in text and "agreeing: within 0.5 mm" in text


@pytest.mark.parametrize(
    "option", [("--protocol", "iso"), ("--register", "best"), ("--scale", "2"), ("--factor", "-1")]
)
def test_wrong_words_are_wrong_usage(option: tuple[str, str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(["compare", "a.stl", "b.stl", *option])
    assert caught.value.code == 2


def test_a_failed_comparison_leaves_nothing(bracket: TriangleMesh, tmp_path: Path) -> None:
    mesh = tmp_path / "part.stl"
    bracket.to_trimesh().export(mesh)
    with pytest.raises(UnreadableError):
        compare_files(mesh, tmp_path / "gone.step", tmp_path / "out")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("points", "seed", "code"),
    [
        (10, 0, "points-out-of-range"),
        (10**7, 0, "points-out-of-range"),
        (1000, -1, "seed-negative"),
    ],
)
def test_wrong_options(tmp_path: Path, points: int, seed: int, code: str) -> None:
    with pytest.raises(UsageError) as caught:
        compare_files(tmp_path / "a.stl", tmp_path / "b.stl", None, CompareOptions(points, seed))
    assert caught.value.code == code


def test_what_is_only_rounding_is_told_as_zero(bracket: TriangleMesh) -> None:
    # A shift that binary numbers do not have leaves areas and volumes equal but for rounding.
    moved = make_mesh(bracket.vertices + 0.1, bracket.triangles)
    asked = CompareOptions(points=200, protocols=(Protocol.ENGINEERING,))
    found, _ = compare_models(Model(moved), Model(bracket), asked)
    assert found.engineering.volume_mm3 != 0.0
    text = comparison_text(found)
    assert "+0 mm3 (+0.0000 %)" in text and "+0 mm2 (+0.0000 %)" in text
    assert "e-" not in text and "-0.0000" not in text


def test_one_triangle_is_told_as_one(bracket: TriangleMesh) -> None:
    single = make_mesh([[0, 0, 0], [40, 0, 0], [0, 30, 0]], [[0, 1, 2]])
    found, _ = compare_meshes(single, bracket, points=200)
    assert " 1 triangle, not closed" in comparison_text(found)
    assert found.volume_iou.value == 0.0


@pytest.fixture
def step(tmp_path: Path) -> Path:
    write_step(BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Solid(), tmp_path / "box.step")
    return tmp_path / "box.step"


def test_a_model_that_breaks_the_library_is_one_line_and_no_traceback(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], step: Path
) -> None:
    empty = TopoDS_Compound()
    BRep_Builder().MakeCompound(empty)
    BRepTools.Write_s(empty, str(tmp_path / "empty.brep"))
    capfd.readouterr()
    assert main(["compare", str(tmp_path / "empty.brep"), str(step)]) == 3
    stated = capfd.readouterr()
    assert stated.out == "" and stated.err.count("\n") == 1


@pytest.mark.parametrize(
    ("limit", "code"), [("--seconds", "takes-too-long"), ("--memory", "out-of-memory")]
)
def test_a_comparison_that_takes_too_much_is_ended(
    limit: str, code: str, capfd: pytest.CaptureFixture[str], step: Path
) -> None:
    capfd.readouterr()
    assert main(["compare", str(step), str(step), limit, "0.05"]) == 5
    stated = capfd.readouterr()
    assert stated.out == "" and stated.err.count("\n") == 1 and f"[{code}]" in stated.err
