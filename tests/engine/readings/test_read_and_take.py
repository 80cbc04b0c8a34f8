"""``gaussiancad read``, and a reading instead of reading."""

import hashlib
import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image, ImageDraw

from gaussiancad_core.cli import main

SAMPLES = Path(__file__).parents[3] / "resources" / "samples"

_OPTIONS = ("--length", "x=80")


def _json(path: Path) -> dict[str, Any]:
    return json.loads(path.read_text("utf-8"))


def _made(sheet: Path, output: Path, *options: "str | Path") -> dict[str, Any]:
    words = ["reconstruct", sheet, "--output", output, "--result", "solid", *_OPTIONS, *options]
    assert main(list(map(str, words))) == 0
    return _json(output / "report.json")


@pytest.fixture
def sheet(plain_picture: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(plain_picture, tmp_path / "bracket.png"))


@pytest.fixture(scope="module")
def read_once(tmp_path_factory: pytest.TempPathFactory, plain_picture: Path) -> Path:
    """What ``read`` leaves of the sheet."""
    folder = tmp_path_factory.mktemp("once")
    sheet = shutil.copy(plain_picture, folder / "bracket.png")
    assert main(["read", str(sheet), "--output", str(folder / "read"), *_OPTIONS]) == 0
    return folder / "read"


@pytest.fixture
def read(read_once: Path, tmp_path: Path) -> Path:
    shutil.copytree(read_once, tmp_path / "read")
    return tmp_path / "read" / "reading.json"


def test_what_was_read_makes_the_same_solid(sheet: Path, read: Path, tmp_path: Path) -> None:
    direct = _made(sheet, tmp_path / "direct")
    taken = _made(sheet, tmp_path / "taken", "--reading", read)
    for name in ("status", "reasons", "warnings", "projection", "projection_source", "views"):
        assert taken[name] == direct[name], name
    for name in ("faces", "valid", "closed", "alternatives"):
        assert taken["solid"][name] == direct["solid"][name]
    assert taken["solid"]["volume_mm3"] == pytest.approx(direct["solid"]["volume_mm3"], rel=1e-6)
    assert (read.parent / "reading.png").stat().st_size > 1_000
    # A run writes the same reading as it goes on.
    assert _json(tmp_path / "direct" / "reading.json")["strokes"] == _json(read)["strokes"]


def test_the_report_has_the_numbers_of_what_was_read(tmp_path: Path) -> None:
    solid, drawn = SAMPLES / "l-bracket.step", tmp_path / "drawn.png"
    assert main(["draw", str(solid), str(drawn), "--style", "dimensioned"]) == 0
    assert main(["read", str(drawn), "--output", str(tmp_path / "read")]) == 0
    read = tmp_path / "read" / "reading.json"
    options = ("--output", str(tmp_path / "taken"), "--result", "solid", "--reading", str(read))
    assert main(["reconstruct", str(drawn), *options]) == 0
    found = _json(tmp_path / "taken" / "report.json")["dimensions"]
    written = {entry["value_mm"] for entry in found if entry["used"]}
    assert {80.0, 60.0, 50.0, 14.0, 12.0} <= written
    assert len(found) == len(_json(read)["dimensions"])


def test_a_hidden_line_that_was_missed_is_drawn_by_hand(
    sheet: Path, read: Path, tmp_path: Path
) -> None:
    values = _json(read)
    hidden = [item for item in values["strokes"] if item["kind"] == "hidden"]
    assert hidden
    values["strokes"] = [item for item in values["strokes"] if item["kind"] != "hidden"]
    read.write_text(json.dumps(values))
    assert _made(sheet, tmp_path / "without", "--reading", read)["status"] != "verified"
    drawn = [
        {"op": "draw", "view": item["view"], "kind": "hidden", "line": item["line"]}
        for item in hidden
    ]
    _correct(sheet, drawn)
    report = _made(sheet, tmp_path / "mended", "--reading", read)
    assert report["status"] == "verified"
    assert report["solid"]["volume_mm3"] == pytest.approx(
        _made(sheet, tmp_path / "again")["solid"]["volume_mm3"], rel=1e-6
    )
    (stated,) = [item for item in report["warnings"] if item["code"] == "corrected"]
    assert stated["message"].startswith(f"{len(hidden)} correction(s)")


def _correct(sheet: Path, operations: list[dict[str, Any]]) -> Path:
    path = sheet.with_name(f"{sheet.name}.corrections.json")
    digest = hashlib.sha256(sheet.read_bytes()).hexdigest()
    schema = "gaussiancad-corrections/1"
    path.write_text(json.dumps({"schema": schema, "sheet_sha256": digest, "ops": operations}))
    return path


def test_corrections_beside_a_sheet_are_taken_and_those_without_a_place_are_told(
    sheet: Path, tmp_path: Path
) -> None:
    line = [[1.0, 1.0], [9.0, 1.0]]
    _correct(sheet, [{"op": "erase", "target": {"id": "s1", "line": line}}])
    report = _made(sheet, tmp_path / "out")
    assert [item["code"] for item in report["reasons"]] == ["corrections-unmatched"]
    assert report["status"] == "approximate"


def _boxes(path: Path, *boxes: tuple[int, int, int, int]) -> Path:
    """A sheet of rectangles."""
    picture = Image.new("L", (600, 400), 255)
    for box in boxes:
        ImageDraw.Draw(picture).rectangle(box, outline=0, width=3)
    picture.save(path)
    return path


def test_reading_never_fails_for_geometry(tmp_path: Path) -> None:
    path = _boxes(tmp_path / "apart.png", (60, 60, 260, 160), (360, 210, 540, 360))
    output = tmp_path / "out"
    assert main(["read", str(path), "--output", str(output)]) == 0
    values = _json(output / "reading.json")
    (refused,) = [item for item in values["problems"] if item["severity"] == "refused"]
    assert refused["offers"] and values["strokes"] == []
    assert [item["role"] for item in values["views"]] == ["ignore", "ignore"]


def test_a_plate_in_one_view_is_read_and_told_its_thickness_and_scale(tmp_path: Path) -> None:
    path, output = _boxes(tmp_path / "one.png", (100, 100, 300, 250)), tmp_path / "out"

    def refused() -> list[dict[str, Any]]:
        assert main(["read", str(path), "--output", str(output)]) == 0
        values = _json(output / "reading.json")
        assert [item["role"] for item in values["views"]] == ["front"]
        assert len(values["strokes"]) == 4
        return [item for item in values["problems"] if item["severity"] == "refused"]

    (problem,) = refused()
    assert (problem["code"], problem["offers"]) == ("one-view", ["scale", "view"])
    assert problem["args"]["axis"] == "y" and "case" not in problem["args"]
    thickness = {"op": "scale", "axis": "y", "length_mm": 5}
    _correct(path, [thickness])
    (problem,) = refused()
    assert problem["args"] == {"axis": "y", "case": "scale"}
    width = {"op": "scale", "points": [[100, 100], [300, 100]], "length_mm": 80}
    for stated in ([thickness, width], [width, thickness]):
        _correct(path, stated)
        assert refused() == []
    extents = _made(path, tmp_path / "made")["bounding_box_mm"]
    assert extents == pytest.approx([80, 5, 60], rel=0.02)


def test_a_scale_is_told_in_one_way(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = _boxes(tmp_path / "one.png", (100, 100, 300, 250))
    words = ["read", str(path), "--output", str(tmp_path), "--mm-per-pixel", "0.4"]
    assert main([*words, "--length", "y=5"]) == 0
    assert main([*words, "--length", "x=80"]) == 2
    assert "[wrong-usage]" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("content", "place"),
    [
        (b"", "truncated"),
        (b"[]", "object"),
        (b'{"schema": "gaussiancad-reading/9"}', "$.schema"),
        (b"\xff\xfe", "malformed"),
        (b'{"schema": "gaussiancad-reading/1", "sheet": {"sha256": 3}}', "$.sheet.sha256"),
    ],
)
def test_a_file_that_is_no_reading_is_told_by_its_place(
    content: bytes, place: str, sheet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "wrong.json"
    path.write_bytes(content)
    words = ["reconstruct", str(sheet), "--output", str(tmp_path / "o"), "--reading", str(path)]
    assert main(words) == 3
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "[reading-not-read]" in said and place in said.lower()


def _repeat(strokes: list[dict[str, Any]], count: int) -> None:
    """The strokes, and one of them that often, under new names."""
    drawn = next(stroke for stroke in strokes if stroke["kind"] == "visible" and "line" in stroke)
    strokes += [{**drawn, "id": f"again{number}"} for number in range(count)]


@pytest.mark.parametrize(
    "case",
    [
        (lambda item: item["sheet"].update(sha256="0"), "reading-of-another-sheet", 2),
        (lambda item: item["views"][1].update(role="front"), "role-repeated", 2),
        (lambda item: item["views"].append(item["views"][0]), "reading-not-read", 3),
        (lambda item: item["strokes"][0]["line"][0].append(3.0), "reading-not-read", 3),
        (lambda item: item["strokes"][0].update(line=[[1e9, 0], [0, 0]]), "reading-not-read", 3),
        (lambda item: item["strokes"][0].update(line=[[2e5, 0], [0, 0]]), "reading-not-read", 3),
        (lambda item: item["strokes"].append(item["strokes"][-1]), "reading-not-read", 3),
        (lambda item: _repeat(item["strokes"], 3_001), "part-too-complex", 4),
        (lambda item: _repeat(item["strokes"], 20_001), "too-many-elements", 5),
        (
            lambda item: item.update(
                strokes=[], views=[{**view, "box": [1, 1, 40, 40]} for view in item["views"]]
            ),
            "empty-view-box",
            2,
        ),
        (
            lambda item: [stroke.update(kind="ignore") for stroke in item["strokes"]],
            "empty-view",
            4,
        ),
        (lambda item: item.update(views=item["views"][:1]), "one-view", 4),
    ],
)
def test_a_reading_that_cannot_be_taken_says_why(
    case: tuple[Callable[[dict[str, Any]], None], str, int],
    sheet: Path,
    read: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    change, code, exit_code = case
    values = _json(read)
    change(values)
    read.write_text(json.dumps(values))
    output = str(read.parent / "o")
    words = ["reconstruct", str(sheet), "--output", output, "--reading", str(read)]
    assert main(words) == exit_code
    assert f"[{code}]" in capsys.readouterr().err


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes have no names here")
def test_a_pipe_is_no_reading(
    sheet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    os.mkfifo(tmp_path / "pipe.json")
    words = ["reconstruct", str(sheet), "--output", str(tmp_path / "o")]
    assert main([*words, "--reading", str(tmp_path / "pipe.json")]) == 3
    assert "[reading-not-read]" in capsys.readouterr().err


def test_more_corrections_than_anybody_makes_are_a_limit(
    sheet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _correct(sheet, [{"op": "unit", "value": "mm"}] * 2_001)
    assert main(["read", str(sheet), "--output", str(tmp_path / "o")]) == 5
    assert "[too-many-elements]" in capsys.readouterr().err


def test_corrections_of_another_sheet_are_not_taken(
    sheet: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = _correct(sheet, [])
    path.write_text(path.read_text().replace('"sheet_sha256": "', '"sheet_sha256": "0'))
    assert main(["read", str(sheet), "--output", str(tmp_path / "o")]) == 2
    assert "[corrections-of-another-sheet]" in capsys.readouterr().err


def test_a_sheet_is_explained_without_a_run(
    sheet: Path, read: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    capsys.readouterr()
    assert main(["explain", str(sheet)]) == 0
    assert capsys.readouterr().out.startswith("The front view at ")
    (x0, y0), (x1, y1) = next(item["line"] for item in _json(read)["strokes"] if "line" in item)
    place = f"{(x0 + x1) / 2.0},{(y0 + y1) / 2.0}"
    assert main(["explain", str(sheet), "--at", place]) == 0
    assert "A visible line of" in capsys.readouterr().out
    assert main(["explain", str(sheet), "--view", "front"]) == 2


def test_views_that_a_person_boxes_are_read_from_the_ink(
    sheet: Path, read: Path, tmp_path: Path
) -> None:
    values = _json(read)
    # A sheet whose views were not found has their lines neither.
    boxes = {view["role"]: view["box"] for view in values["views"]}
    values["views"], values["strokes"] = [], []
    read.write_text(json.dumps(values))
    grown = [-4.0, -4.0, 4.0, 4.0]
    _correct(
        sheet,
        [
            {
                "op": "view",
                "id": role,
                "role": role,
                "box": [a + b for a, b in zip(box, grown, strict=True)],
            }
            for role, box in boxes.items()
        ],
    )
    report = _made(sheet, tmp_path / "boxed", "--reading", read)
    assert report["status"] == "verified" and report["solid"]["faces"] == 9


def test_a_hole_is_as_deep_as_a_person_says(sheet: Path, read: Path, tmp_path: Path) -> None:
    values = _json(read)
    values["strokes"] = [item for item in values["strokes"] if item["kind"] != "hidden"]
    read.write_text(json.dumps(values))
    through = _made(sheet, tmp_path / "through", "--reading", read)
    holes = [item for item in through["assumptions"] if item["code"] == "hole-through"]
    assert len(holes) == 1
    (x, y, radius, *_) = next(
        item["arc"] for item in values["strokes"] if item["view"] == "top" and "arc" in item
    )
    deep = {"op": "note", "circle": [x, y, radius], "depth_mm": 5.0}
    stated = {
        "schema": "gaussiancad-corrections/1",
        "sheet_sha256": values["sheet"]["sha256"],
        "ops": [deep],
    }
    corrections = tmp_path / "told.json"
    corrections.write_text(json.dumps(stated))
    blind = _made(sheet, tmp_path / "blind", "--reading", read, "--corrections", corrections)
    assert "hole-through" not in [item["code"] for item in blind["assumptions"]]
    more = blind["solid"]["volume_mm3"] - through["solid"]["volume_mm3"]
    rings = 3.141592653589793 * (radius * through["scale_mm_per_pixel"]) ** 2
    # The foot is a quarter of the length thick.
    assert more == pytest.approx(rings * (20.0 - 5.0), rel=1e-2)
