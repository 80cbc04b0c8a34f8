"""Files of several pages: what is told of them, and which page is taken."""

from pathlib import Path

import ezdxf
import pytest
from PIL import Image, ImageDraw

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.readings.reading_files import open_typed
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_core.report.job import Job
from gaussiancad_core.run.pipeline import reconstruct
from gaussiancad_core.run.read_run import read_to_file
from gaussiancad_protocol.modes import ResultKind

_VIEWS = (
    ((0.0, 0.0), (60.0, 20.0)),
    ((900.0, 300.0), (60.0, 40.0)),
    ((-700.0, 1200.0), (40.0, 20.0)),
)
"""Corner and size of front, top and right view of a block, far apart in model space, mm."""

_PLACES = ((80.0, 60.0), (80.0, 120.0), (160.0, 60.0))
"""Middle of each on paper, third angle."""


def _drawing(path: Path, layouts: int) -> Path:
    doc = ezdxf.new("R2018", setup=True, units=4)
    model = doc.modelspace()
    for (x, y), (width, height) in _VIEWS:
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
        model.add_lwpolyline(corners, close=True, dxfattribs={"lineweight": 50})
    for number in range(1, layouts + 1):
        paper = doc.layout("Layout1") if number == 1 else doc.layouts.new(f"Layout{number}")
        paper.page_setup(size=(200, 150), margins=(0, 0, 0, 0), units="mm")
        for ((x, y), (width, height)), place in zip(_VIEWS, _PLACES, strict=True):
            paper.add_viewport(
                center=place,
                size=(width + 10.0, height + 10.0),
                view_center_point=(x + width / 2.0, y + height / 2.0),
                view_height=height + 10.0,
            )
    doc.saveas(path)
    return path


def _job(sheet: Path, tmp_path: Path, page: int = 1) -> Job:
    return Job(sheet, tmp_path / "out", page=page, result=ResultKind.SOLID)


@pytest.mark.parametrize("page", [1, 2])
def test_the_layout_that_brings_views_together_is_taken(tmp_path: Path, page: int) -> None:
    report = reconstruct(_job(_drawing(tmp_path / "a.dxf", 1), tmp_path, page), Silence())
    assert report.solid.bounding_box_mm == pytest.approx((60.0, 40.0, 20.0), abs=1e-3)
    codes = {warning.code for warning in report.warnings}
    assert ("other-page-taken" in codes) is (page == 1)
    assert report.settings["page"] == page


def test_of_several_layouts_none_is_taken_and_the_refusal_names_the_pages(tmp_path: Path) -> None:
    with pytest.raises(NoModelError, match=r"3 pages.*--page"):
        reconstruct(_job(_drawing(tmp_path / "a.dxf", 2), tmp_path), Silence())


@pytest.mark.parametrize("suffix", ["pdf", "tif"])
def test_a_page_without_views_tells_how_many_pages_there_are(tmp_path: Path, suffix: str) -> None:
    cover, rest = Image.new("L", (900, 700), "white"), Image.new("L", (900, 700), "white")
    ImageDraw.Draw(rest).rectangle((100, 100, 400, 300), outline="black", width=3)
    sheet = tmp_path / f"a.{suffix}"
    cover.save(sheet, save_all=True, append_images=[rest, rest])
    with pytest.raises(NoModelError, match=r"3 pages.*--page") as caught:
        reconstruct(_job(sheet, tmp_path), Silence())
    assert caught.value.code == "blank-sheet"
    single = tmp_path / f"b.{suffix}"
    cover.save(single)
    with pytest.raises(NoModelError) as caught:
        reconstruct(_job(single, tmp_path), Silence())
    assert "page" not in str(caught.value)


def test_a_reading_of_a_page_without_views_tells_of_the_others(tmp_path: Path) -> None:
    read_to_file(_job(_drawing(tmp_path / "a.dxf", 1), tmp_path), Silence())
    found = open_typed(tmp_path / "out" / "reading.json", SheetReading, "reading-not-read")
    refused = [problem for problem in found.problems if problem.severity == "refused"]
    assert refused and all("2 pages" in item.message for item in refused)
