"""Whole sheets whose notes tell what no line shows: depths, in words, in tables, under a leader."""

import json
from collections.abc import Iterable
from math import pi
from pathlib import Path
from typing import Any

import ezdxf
import pytest
from ezdxf.layouts import Modelspace

from gaussiancad_core.cli import main

Point = tuple[float, float]

_PLATE = 100.0, 60.0, 14.0
_HOLES: tuple[Point, ...] = ((20.0, 15.0), (80.0, 15.0), (20.0, 45.0), (80.0, 45.0))
_NARROW, _WIDE, _DEEP = 6.0, 11.0, 6.5


class _Sheet:
    """A sheet in millimetres, full scale, whose only texts are those that a test writes."""

    def __init__(self) -> None:
        self._file = ezdxf.new(units=4)
        for name, weight in (("visible", 50), ("narrow", 18), ("text", 25), ("frame", 35)):
            self._file.layers.add(name, lineweight=weight)
        self._space: Modelspace = self._file.modelspace()
        self.box((10.0, 10.0), (287.0, 200.0), "frame")

    def line(self, start: Point, end: Point, layer: str = "visible") -> None:
        self._space.add_line(start, end, dxfattribs={"layer": layer})

    def box(self, low: Point, high: Point, layer: str = "visible") -> None:
        corners = [low, (high[0], low[1]), high, (low[0], high[1])]
        for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
            self.line(start, end, layer)

    def circle(self, centre: Point, diameter: float) -> None:
        self._space.add_circle(centre, diameter / 2.0, dxfattribs={"layer": "visible"})

    def text(self, text: str, at: Point, height: float = 3.5) -> None:
        look = {"layer": "text", "height": height, "insert": at}
        self._space.add_text(text, dxfattribs=look)

    def table(self, rows: Iterable[tuple[str, ...]], at: Point) -> None:
        """A ruled table from its upper left corner."""
        cells = list(rows)
        width, height = 24.0, 6.0
        right, bottom = at[0] + width * len(cells[0]), at[1] - height * len(cells)
        for k in range(len(cells) + 1):
            self.line((at[0], at[1] - k * height), (right, at[1] - k * height), "frame")
        for k in range(len(cells[0]) + 1):
            self.line((at[0] + k * width, at[1]), (at[0] + k * width, bottom), "frame")
        for k, row in enumerate(cells):
            for n, cell in enumerate(row):
                place = at[0] + n * width + 1.5, at[1] - (k + 1) * height + 1.7
                self.text(cell, place, 2.5)

    def made(self, folder: Path, *options: str) -> dict[str, Any]:
        """The report of what is made of it."""
        path = folder / "sheet.dxf"
        self._file.saveas(path)
        output = folder / "made"
        words = ["reconstruct", str(path), "--output", str(output), "--result", "solid"]
        assert main([*words, *options]) == 0
        return json.loads((output / "report.json").read_text("utf-8"))


def _counterbored(*lines: str) -> _Sheet:
    """A plate in one view with four counterbored holes, and notes under the leader of one."""
    sheet = _Sheet()
    x, y = 50.0, 90.0
    sheet.box((x, y), (x + _PLATE[0], y + _PLATE[1]))
    for a, b in _HOLES:
        sheet.circle((x + a, y + b), _NARROW)
        sheet.circle((x + a, y + b), _WIDE)
    a, b = x + _HOLES[3][0], y + _HOLES[3][1]
    reach = _WIDE / 2.0 * 0.5**0.5
    elbow = a + reach + 18.0, b + reach + 18.0
    sheet.line((a + reach, b + reach), elbow, "narrow")
    sheet.line(elbow, (elbow[0] + 6.0, elbow[1]), "narrow")
    for k, text in enumerate(lines):
        sheet.text(text, (elbow[0] + 7.0, elbow[1] - 6.0 * k))
    sheet.text("t=14", (200.0, 70.0))
    return sheet


@pytest.mark.slow
@pytest.mark.parametrize(
    "lines",
    [
        ("4 x 6 THRU ALL", "C'BORE 11 X 6.5 DP"),
        ("\u23006 durchgehend, 4 Stellen", "Zylindersenkung \u230011", "6,5 tief"),
        (
            "4 \u043e\u0442\u0432. \u00d86 \u0441\u043a\u0432\u043e\u0437\u043d.",
            "\u0446\u0435\u043a. \u00d811 \u0433\u043b\u0443\u0431. 6,5",
        ),
    ],
    ids=["en", "de", "ru"],
)
def test_a_counterbore_is_as_deep_as_its_note_says(lines: tuple[str, ...], tmp_path: Path) -> None:
    report = _counterbored(*lines).made(tmp_path)
    narrow, wide = (pi * d**2 / 4.0 for d in (_NARROW, _WIDE))
    length, width, thick = _PLATE
    volume = length * width * thick - 4.0 * (narrow * thick + (wide - narrow) * _DEEP)
    assert report["solid"]["volume_mm3"] == pytest.approx(volume, rel=1e-5)
    assert report["solid"]["faces"] == 18
    assert all(note["used"] for note in report["notes"])
    assert not [item for item in report["assumptions"] if item["code"] == "hole-through"]


@pytest.mark.slow
def test_a_note_that_the_solid_does_not_keep_is_not_used(tmp_path: Path) -> None:
    report = _counterbored("4 x 6 THRU ALL", "C'BORE 11 X 44 DP").made(tmp_path)
    used = {note["text"]: note["used"] for note in report["notes"]}
    assert not used["C'BORE 11 X 44 DP"]


@pytest.mark.slow
@pytest.mark.parametrize("options", [(), ("--length", "x=100")], ids=["read", "given"])
def test_a_hole_table_tells_depths_by_labels(options: tuple[str, ...], tmp_path: Path) -> None:
    sheet = _Sheet()
    x, y = 30.0, 110.0
    sheet.box((x, y), (x + 100.0, y + 60.0))
    sheet.box((x, 60.0), (x + 100.0, 74.0))
    holes = {"A1": (15.0, 12.0, 5.0), "A2": (85.0, 48.0, 5.0)}
    holes |= {"B1": (30.0, 35.0, 18.0), "B2": (70.0, 30.0, 18.0)}
    for label, (a, b, diameter) in holes.items():
        sheet.circle((x + a, y + b), diameter)
        sheet.text(label, (x + a + diameter / 2.0 + 1.0, y + b + diameter / 2.0 - 1.0), 2.5)
    rows = [(label, f"{a:g}", f"{b:g}") for label, (a, b, _) in holes.items()]
    said = ["\u00d85 THRU", "\u00d85 THRU", "\u00d818 \u21a7 6", "\u00d818 \u21a7 9"]
    table = [(*row, text) for row, text in zip(rows, said, strict=True)]
    sheet.table([("TAG", "X", "Y", "SIZE"), *table], (160.0, 180.0))
    report = sheet.made(tmp_path, *options)
    bores = 2.0 * 14.0 * pi * 2.5**2 + (6.0 + 9.0) * pi * 9.0**2
    assert report["solid"]["volume_mm3"] == pytest.approx(100.0 * 60.0 * 14.0 - bores, rel=1e-5)
    assert [note["used"] for note in report["notes"]] == 4 * [True]
    assert all(item["mm_per_pixel"] for item in report["dimensions"])
