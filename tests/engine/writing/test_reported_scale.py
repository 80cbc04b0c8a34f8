"""What a run reports of the scale, from files of pixels and of vectors."""

import json
from pathlib import Path

import ezdxf
import pytest

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.report.job import Job
from gaussiancad_core.run import pipeline
from gaussiancad_core.sheet.reading_options import ReadingOptions
from sample_parts import sample


@pytest.fixture
def report(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):  # noqa: ANN201
    """Reads a sheet in a run that stops before its models, and gives its report."""

    def stop(*_: object) -> None:
        raise NoModelError("no-surface", "the test ends here")

    monkeypatch.setattr(pipeline._Run, "_make_models", stop)

    def run(sheet: Path, reading: ReadingOptions) -> dict:
        output = tmp_path / "out"
        with pytest.raises(NoModelError, match="the test ends here"):
            pipeline.reconstruct(Job(sheet, output, reading), Silence())
        return json.loads((output / "report.json").read_text("utf-8"))

    return run


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, float]:
    """A dimensioned sheet and its true mm per px."""
    path = tmp_path_factory.mktemp("sheets") / "bracket.png"
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    style = PRESETS["dimensioned"]
    sheet = draw_sheet(sample("l-bracket").build(), roles, Projection.THIRD, style)
    write_image(sheet.image, path, dpi=sheet.dpi)
    return path, sheet.mm_per_pixel


def test_the_report_names_the_dimensions(report, drawn) -> None:  # noqa: ANN001
    path, true = drawn
    found = report(path, ReadingOptions())
    assert found["scale_source"] == "dimension"
    assert found["scale_mm_per_pixel"] == pytest.approx(true, rel=0.002)
    assert found["bounding_box_mm"] == pytest.approx([80, 50, 60], rel=0.002)
    codes = {item["code"] for item in (*found["reasons"], *found["warnings"])}
    assert not codes & {"scale-assumed", "scale-contradicts-dimensions"}
    assert all(
        set(item) == {"text", "type", "value_mm", "box", "mm_per_pixel", "used"}
        for item in found["dimensions"]
    )
    assert {12.0, 14.0, 50.0, 52.0, 60.0, 80.0} <= {
        item["value_mm"] for item in found["dimensions"]
    }


def test_what_the_user_says_counts_more_and_contradicts(report, drawn) -> None:  # noqa: ANN001
    path, true = drawn
    found = report(path, ReadingOptions(lengths=((Axis.X, 160.0),)))
    assert found["scale_source"] == "given"
    assert found["scale_mm_per_pixel"] == pytest.approx(2 * true, rel=0.002)
    assert found["dimensions"]
    assert "scale-contradicts-dimensions" in {item["code"] for item in found["reasons"]}


def dxf_sheet(path: Path, factor: float) -> None:
    """Three views of a block of 60 x 30 x 40 on A3, ``factor`` times as large, dimensioned."""
    document = ezdxf.new(setup=True, units=4)
    space = document.modelspace()
    block = ((30, 30, 60, 40), (30, 110, 60, 30), (170, 30, 30, 40))
    for x, y, width, height in block:
        w, h = width * factor, height * factor
        corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
        space.add_lwpolyline(corners, close=True, dxfattribs={"lineweight": 50})
        style = {"dimlfac": 1.0 / factor, "dimtxt": 3.5, "dimdec": 1}
        space.add_linear_dim((x, y - 10), (x, y), (x + w, y), override=style).render()
        space.add_linear_dim((x - 10, y), (x, y), (x, y + h), angle=90, override=style).render()
    document.saveas(path)


def test_a_dxf_sheet_has_its_dimensions_without_ocr(report, tmp_path) -> None:  # noqa: ANN001
    path = tmp_path / "block.dxf"
    dxf_sheet(path, 1.5)
    found = report(path, ReadingOptions())
    assert found["scale_source"] == "dimension"
    assert found["scale_mm_per_pixel"] == pytest.approx(25.4 / 200 / 1.5, rel=0.002)
    assert found["bounding_box_mm"] == pytest.approx([60, 30, 40], rel=0.005)
