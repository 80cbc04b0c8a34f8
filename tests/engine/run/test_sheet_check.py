"""``gaussiancad check``: exit codes, files and places, from a sheet and a model on disk."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.cli import main
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder

_PART = cut(
    box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0)),
    box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0)),
    cylinder(Axis.Z, (15.0, 12.0), 5.0, -1.0, 31.0),
)


@pytest.fixture(scope="module")
def sheet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("checked")
    _written(_PART, folder / "part.step")
    sheet = folder / "sheet.png"
    assert main(["draw", str(folder / "part.step"), str(sheet)]) == 0
    # Read once for all tests.
    assert main(["read", str(sheet), "--output", str(folder / "read")]) == 0
    return sheet


def _written(shape: TopoDS_Shape, path: Path) -> Path:
    write_step(shape, path)
    return path


def _checked(sheet: Path, model: Path, output: Path, *options: str) -> tuple[int, dict]:
    read = sheet.parent / "read" / "reading.json"
    given = [f"--reading={read}"] if read.is_file() else []
    code = main(["check", str(sheet), str(model), f"--output={output}", *given, *options])
    return code, json.loads((output / "check.json").read_text("utf-8"))


def test_the_part_agrees_whatever_its_position(sheet: Path, tmp_path: Path) -> None:
    code, values = _checked(sheet, sheet.parent / "part.step", tmp_path / "out")
    assert (code, values["verdict"], values["reasons"]) == (0, "agrees", [])
    assert values["share"] < 0.02
    assert np.array(values["pose"]["matrix"]).shape == (4, 4)
    assert cv2.imread(str(tmp_path / "out" / "check.png")) is not None


def test_a_lacking_hole_is_told_with_its_place(sheet: Path, tmp_path: Path) -> None:
    filled = cut(
        box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0)), box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0))
    )
    model = _written(filled, tmp_path / "filled.step")
    code, values = _checked(sheet, model, tmp_path / "out")
    assert (code, values["verdict"]) == (4, "differs")
    assert values["reasons"][0]["code"] == "circle-missing"
    worst = values["differences"][0]
    assert (worst["view"], worst["kind"]) == ("top", "missing")
    # The sheet tells no size: the part is 100 mm long.
    assert worst["length_mm"] == pytest.approx(10.0 * np.pi * 100.0 / 60.0, rel=0.02)
    # Its two ends lie on the circle, a diameter apart at most.
    ink = cv2.imread(str(sheet), cv2.IMREAD_GRAYSCALE)
    for x, y in worst["ends"]:
        assert ink[round(y) - 3 : round(y) + 3, round(x) - 3 : round(x) + 3].min() < 128
    assert values["edits"][0]["what"] == "drill"


def test_the_size_is_told_where_the_user_says_it(sheet: Path, tmp_path: Path) -> None:
    code, values = _checked(
        sheet, sheet.parent / "part.step", tmp_path / "out", "--length", "x=1524"
    )
    assert (code, values["reasons"][0]["code"]) == (4, "size-differs")
    assert values["pose"]["scale"] == pytest.approx(60.0 / 1524.0, rel=1e-2)


def test_a_sheet_without_views_tells_nothing(sheet: Path, tmp_path: Path) -> None:
    blank = tmp_path / "note.png"
    picture = np.full((400, 600), 255, np.uint8)
    cv2.putText(picture, "NOTE", (80, 200), cv2.FONT_HERSHEY_SIMPLEX, 2.0, 0, 3)
    cv2.imwrite(str(blank), picture)
    code, values = _checked(blank, sheet.parent / "part.step", tmp_path / "out")
    assert (code, values["verdict"]) == (5, "cannot-tell")
    assert values["differences"] == []
    assert values["pose"] is None


def test_what_is_no_model_is_told_in_a_line(
    sheet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "part.step").write_text("no step", "utf-8")
    out = tmp_path / "out"
    code = main(["check", str(sheet), str(tmp_path / "part.step"), "--output", str(out)])
    assert code == 3
    assert len(capsys.readouterr().err.strip().splitlines()) == 1
    assert not out.exists() or not list(out.iterdir())


def test_a_second_check_replaces_the_first_and_nothing_else(sheet: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.mkdir()
    (out / "check.png").write_bytes(b"mine")
    part, read = sheet.parent / "part.step", sheet.parent / "read" / "reading.json"
    command = ["check", str(sheet), str(part), f"--output={out}", f"--reading={read}"]
    assert main(command) == 2
    assert (out / "check.png").read_bytes() == b"mine"
    (out / "check.png").unlink()
    assert main(command) == 0
    assert main(command) == 0
