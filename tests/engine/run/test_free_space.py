"""Drawings without paper, as programs for cutting plates write them, from file to solid."""

import json
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import ezdxf
import numpy as np
import pytest
from ezdxf.layouts import Modelspace

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.kernel.brep import bounding_box, faces_of
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.pipeline import reconstruct
from gaussiancad_core.sheet.reading_options import FileUnit, ReadingOptions
from gaussiancad_protocol.modes import ResultKind

_MM = 4
_INCH = 1

_HOLES = ((8.0, 8.0, 2.2), (52.0, 8.0, 2.2), (52.0, 32.0, 2.2), (30.0, 20.0, 9.0))

Run = Callable[..., tuple[dict, list[float], int]]


def _plate(model: Modelspace, per_mm: float = 1.0, layer: str = "0") -> None:
    """A plate of 60 x 40 mm with four holes, these in a layer of their own."""
    corners = [(0, 0), (60 * per_mm, 0), (60 * per_mm, 40 * per_mm), (0, 40 * per_mm)]
    model.add_lwpolyline(corners, close=True)
    for x, y, radius in _HOLES:
        place = (x * per_mm, y * per_mm)
        model.add_circle(place, radius * per_mm, dxfattribs={"layer": layer})


def _note(model: Modelspace, text: str, place: tuple[float, float], height: float = 4.0) -> None:
    model.add_text(text, height=height).set_placement(place)


@pytest.fixture
def run(tmp_path: Path) -> Run:
    """Makes a solid of a drawing: the report, its extents in mm, and how many faces it has."""

    def make(doc: ezdxf.document.Drawing, reading: ReadingOptions | None = None):  # noqa: ANN202
        path, output = tmp_path / "plate.dxf", tmp_path / "out"
        doc.saveas(path)
        options = reading or ReadingOptions()
        reconstruct(Job(path, output, options, result=ResultKind.SOLID), Silence())
        report = json.loads((output / "report.json").read_text("utf-8"))
        solid = read_solid(output / "solid.step")
        return report, np.ptp(bounding_box(solid), axis=0).tolist(), len(faces_of(solid))

    return make


def _drawing(unit: int = _MM) -> tuple[ezdxf.document.Drawing, Modelspace]:
    doc = ezdxf.new("R2010")
    doc.header["$INSUNITS"] = unit
    return doc, doc.modelspace()


def _codes(found: list[dict]) -> set[str]:
    return {item["code"] for item in found}


@pytest.mark.parametrize(("layer", "place"), [("0", (0.0, -12.0)), ("HOLES", (22.0, 2.0))])
def test_a_plate_with_its_thickness_beside_it_or_on_it(
    run: Run, layer: str, place: tuple[float, float]
) -> None:
    doc, model = _drawing()
    _plate(model, layer=layer)
    _note(model, "t=3", place, 3.0)
    report, extents, faces = run(doc)
    assert extents == pytest.approx([60.0, 3.0, 40.0], abs=1e-3)
    assert faces == 6 + len(_HOLES)
    assert report["status"] == "approximate"
    assert "second-view-assumed" in _codes(report["reasons"])
    assert report["unused"] == []


@pytest.mark.parametrize("per_mm", [1 / 6, 50.0])
def test_a_plate_of_any_size_keeps_its_unit(run: Run, per_mm: float) -> None:
    doc, model = _drawing()
    _plate(model, per_mm)
    _note(model, "2 mm thick", (0.0, -8.0 * per_mm), 3.0 * per_mm)
    _, extents, faces = run(doc)
    assert extents == pytest.approx([60 * per_mm, 2.0, 40 * per_mm], rel=1e-4)
    assert faces == 6 + len(_HOLES)


def test_numbers_of_a_drawing_in_inches_are_inches(run: Run) -> None:
    doc, model = _drawing(_INCH)
    _plate(model, 1 / 25.4)
    _note(model, ".125 THK", (0.0, -0.4), 0.15)
    _, extents, _ = run(doc)
    assert extents == pytest.approx([60.0, 3.175, 40.0], abs=1e-3)


def test_a_frame_around_a_single_view_is_told_as_not_used_and_in_doubt(run: Run) -> None:
    doc, model = _drawing()
    _plate(model)
    model.add_lwpolyline([(-80, -60), (197, -60), (197, 130), (-80, 130)], close=True)
    _note(model, "Dicke 3", (80.0, 20.0))
    report, extents, _ = run(doc)
    assert extents == pytest.approx([60.0, 3.0, 40.0], abs=1e-3)
    assert [item["kind"] for item in report["unused"]] == ["frame"]
    assert "frame-left-out" in _codes(report["reasons"])
    assert "frame-left-out" not in _codes(report["warnings"])


def test_a_plate_with_a_pocket_and_a_hole_beside_it_is_no_frame(run: Run) -> None:
    doc, model = _drawing()
    for x, y, w, h in ((0, 0, 120, 80), (10, 15, 70, 50)):
        model.add_lwpolyline([(x, y), (x + w, y), (x + w, y + h), (x, y + h)], close=True)
    model.add_circle((30, 30), 6)
    model.add_circle((100, 40), 8)
    _note(model, "t=10", (85.0, 5.0))
    report, extents, _ = run(doc)
    assert extents == pytest.approx([120.0, 10.0, 80.0], abs=1e-3)
    assert report["unused"] == []


def test_a_plate_without_a_thickness_asks_for_one_and_takes_it(run: Run) -> None:
    doc, model = _drawing()
    _plate(model)
    with pytest.raises(NoModelError) as caught:
        run(doc)
    assert caught.value.code == "one-view"
    _, extents, _ = run(doc, ReadingOptions(lengths=((Axis.Y, 3.0),)))
    assert extents == pytest.approx([60.0, 3.0, 40.0], abs=1e-3)


@pytest.mark.parametrize(
    ("unit", "stated", "factor"),
    [
        (FileUnit.FOOT, 0, 304.8),
        # What the file states stands.
        (FileUnit.INCH, _MM, 1.0),
    ],
)
def test_a_file_without_a_unit_is_told_one(
    run: Run, unit: FileUnit, stated: int, factor: float
) -> None:
    doc, model = _drawing(stated)
    _plate(model)
    report, extents, _ = run(doc, ReadingOptions(lengths=((Axis.Y, 3.0),), unit=unit))
    assert extents == pytest.approx([60.0 * factor, 3.0, 40.0 * factor], rel=1e-5)
    assert report["scale_source"] == "sheet"
    assert "paper-size-unknown" not in _codes(report["warnings"])


def test_a_plate_is_told_its_width_and_its_thickness(run: Run) -> None:
    doc, model = _drawing()
    _plate(model)
    _, extents, _ = run(doc, ReadingOptions(lengths=((Axis.X, 90.0), (Axis.Y, 3.0))))
    assert extents == pytest.approx([90.0, 3.0, 60.0], abs=1e-3)


def test_circles_of_chords_that_are_drawn_twice_are_circles(run: Run) -> None:
    doc, model = _drawing()
    model.add_lwpolyline([(0, 0), (60, 0), (60, 40), (0, 40)], close=True)
    turns = np.linspace(0.0, 2.0 * np.pi, 49)
    for x, y, radius in _HOLES:
        points = np.stack([x + radius * np.cos(turns), y + radius * np.sin(turns)], axis=1)
        for start, end in pairwise(points):
            model.add_line(start, end)
    for entity in list(model):
        model.add_entity(entity.copy())
    _note(model, "t=3", (0.0, -12.0))
    _, extents, faces = run(doc)
    assert extents == pytest.approx([60.0, 3.0, 40.0], abs=1e-3)
    assert faces == 6 + len(_HOLES)
