"""Sheets as practice draws them: sections, notes, few views."""

import json
from math import pi
from pathlib import Path

import pytest

from benchmarks.ask.practice import Task
from benchmarks.judge.exact_measures import closeness, fine_mesh, registered
from benchmarks.parts.practice_parts import CLASSES, Lot
from benchmarks.sheets.practice_pdf import Page, Pen, arrow
from benchmarks.sheets.practice_sheets import Practice, write_sheet
from gaussiancad_core.cli import main
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.views import Arc, Linetype

_CASES = (
    ("bracket", Practice.PLACE),
    ("flange", Practice.HALF),
    ("plate", Practice.OFFSET),
    ("block", Practice.NOTES),
    ("plate", Practice.TWO),
)


def _reconstructed(folder: Path, *more: str) -> dict:
    arguments = ["reconstruct", str(folder / "sheet.pdf"), "--output", str(folder / "out")]
    assert main([*arguments, "--result", "solid", *more]) == 0
    return json.loads((folder / "out" / "report.json").read_text(encoding="utf-8"))


def _is_part(folder: Path, name: str) -> bool:
    shape = read_solid(folder / "out" / "solid.step")
    low, high = bounding_box(shape)
    part = CLASSES[name](Lot(name, 0)).shape
    placed, _ = registered(fine_mesh(shape), part, tuple((high - low).tolist()))
    return closeness(shape, placed).exact


@pytest.fixture
def sheet(tmp_path: Path, request: pytest.FixtureRequest) -> Path:
    name, how = request.param
    task = Task(name, 0, how, 0, 60.0)
    part = CLASSES[name](Lot(name, 0))
    write_sheet(part, how, task.projection, 0, tmp_path / "sheet.pdf")
    return tmp_path


@pytest.mark.parametrize(("sheet", "case"), [(item, item) for item in _CASES], indirect=["sheet"])
def test_what_practice_draws_is_the_part(sheet: Path, case: tuple[str, Practice]) -> None:
    name, how = case
    report = _reconstructed(sheet)
    assert _is_part(sheet, name)
    # It rests on what is usual, and says so.
    assert report["status"] == "approximate"
    assert "nothing-hidden" in {item["code"] for item in report["assumptions"]}
    assert bool(report["sections"]) is (how not in (Practice.NOTES, Practice.TWO))
    for entry in report["sections"]:
        assert min(entry["line_recall"], entry["line_precision"]) > 0.99
        assert entry["area_agreement"] > 0.95
    through = [item for item in report["assumptions"] if item["code"] == "hole-through"]
    assert all(item["at"] and item["alternative"] for item in through)
    assert through or how is not Practice.OFFSET
    holes = [item for item in report["notes"] if item["through"] or item["depth_mm"]]
    assert all(hole["used"] for hole in holes)


@pytest.mark.parametrize("sheet", [("block", Practice.BESIDE)], indirect=True)
def test_a_section_beside_travels_in_the_reading(sheet: Path) -> None:
    assert main(["read", str(sheet / "sheet.pdf"), "--output", str(sheet / "read")]) == 0
    path = sheet / "read" / "reading.json"
    reading = json.loads(path.read_text(encoding="utf-8"))
    (section,) = (item for item in reading["views"] if item["role"] == "section")
    assert section["looks"] == "front"
    assert section["hatch"]
    assert any(item["view"] == section["id"] for item in reading["strokes"])
    report = _reconstructed(sheet, "--reading", str(path))
    assert _is_part(sheet, "block")
    (entry,) = report["sections"]
    assert entry["plane"]["axis"] == "y"
    assert entry["plane"]["source"] == "trace"


@pytest.mark.parametrize("sheet", [("shaft", Practice.ONE)], indirect=True)
def test_a_view_that_was_not_drawn_is_an_assumption(sheet: Path) -> None:
    report = _reconstructed(sheet)
    assert _is_part(sheet, "shaft")
    assert "second-view-assumed" in {item["code"] for item in report["reasons"]}
    assert "second-view" in {item["code"] for item in report["assumptions"]}
    assert report["solid"]["source"] == "sketch"
    assert list(report["views"]) == ["front"]
    written = ["read", str(sheet / "sheet.pdf"), "--output", str(sheet / "read")]
    assert main(written) == 0
    again = _reconstructed(sheet, "--reading", str(sheet / "read" / "reading.json"))
    for name in ("faces", "source", "agreement"):
        assert again["solid"][name] == report["solid"][name]
    assert again["solid"]["volume_mm3"] == pytest.approx(report["solid"]["volume_mm3"], rel=1e-5)


def _plate(path: Path, *texts: str) -> None:
    """One view of a plate, 80 x 50 mm, with a hole, and texts beside it."""
    page = Page(200.0, 150.0)
    corners = [(50.0, 50.0), (130.0, 50.0), (130.0, 100.0), (50.0, 100.0), (50.0, 50.0)]
    page.path(corners, Pen(0.5))
    hole = Arc((30.0, 20.0), 8.0, 0.0, 2.0 * pi, Linetype.VISIBLE)
    page.strokes([hole], (50.0, 50.0), 1.0, Pen(0.5))
    for x in (50.0, 130.0):
        page.line((x, 48.0), (x, 36.0), Pen(0.18))
        arrow(page, (x, 38.0), (90.0, 38.0), 3.0)
    page.line((50.0, 38.0), (130.0, 38.0), Pen(0.18))
    page.text((86.0, 39.0), "80", 3.5)
    for number, text in enumerate(texts):
        page.text((150.0, 120.0 - 8.0 * number), text, 3.5)
    page.write(path)


@pytest.mark.parametrize(("texts", "said"), [(("t = 4",), ()), ((), ("--length", "y=4"))])
def test_a_plate_in_one_view_is_as_thick_as_is_said(
    texts: tuple[str, ...], said: tuple[str, ...], tmp_path: Path
) -> None:
    _plate(tmp_path / "sheet.pdf", *texts)
    report = _reconstructed(tmp_path, *said)
    assert report["status"] == "approximate"
    assert "second-view-assumed" in {item["code"] for item in report["reasons"]}
    solid = report["solid"]
    assert (solid["source"], solid["faces"]) == ("sketch", 7)
    assert solid["bounding_box_mm"] == pytest.approx([80.0, 4.0, 50.0], abs=1e-3)
    assert solid["volume_mm3"] == pytest.approx(4.0 * (80.0 * 50.0 - 64.0 * pi), rel=1e-4)
