"""Whether the strokes of a file tell all that its sheet shows."""

from itertools import pairwise
from pathlib import Path

import pytest

from gaussiancad_core.files.painting import paint
from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.recognition.file_views import FileViews, file_views
from gaussiancad_core.recognition.labelled_file import strokes_of_file
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage

FRAME = (60.0, 60.0, 1440.0, 940.0)
TITLE_BLOCK = (900.0, 800.0, 1440.0, 940.0)
FRONT, RIGHT = (200.0, 200.0, 600.0, 500.0), (700.0, 200.0, 900.0, 500.0)
LOGO = (1100.0, 830.0, 1300.0, 920.0)
BESIDE_THE_VIEWS = (1050.0, 250.0, 1350.0, 450.0)
WITHIN_A_VIEW = (350.0, 300.0, 450.0, 400.0)


def _box(x0: float, y0: float, x1: float, y1: float) -> list[VectorStroke]:
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
    return [VectorStroke(LineSegment(start, end), 3.0) for start, end in pairwise(corners)]


def _views(*pictures: Box, complete: bool) -> FileViews:
    """A sheet with a frame, a title block and two views that its file draws."""
    strokes = tuple(stroke for box in (FRAME, TITLE_BLOCK, FRONT, RIGHT) for stroke in _box(*box))
    drawing = VectorDrawing(strokes, (), complete=complete, pictures=pictures)
    grey = paint(drawing, 1500, 1000)
    sheet = OpenedSheet(SheetImage(Path("sheet.pdf"), grey, "", 200.0, drawing))
    file = strokes_of_file(sheet, Projection.THIRD)
    assert file is not None
    found = file_views(file, {}, Projection.THIRD, None)
    assert found is not None and len(found.layout.boxes) == 2
    return found


def test_a_file_of_strokes_alone_shows_all() -> None:
    assert _views(complete=True).is_all


@pytest.mark.parametrize(
    ("picture", "is_all"),
    [(LOGO, True), (WITHIN_A_VIEW, True), (BESIDE_THE_VIEWS, False)],
)
def test_only_a_picture_in_the_drawing_area_that_is_no_drawing_may_be_a_view(
    picture: Box, is_all: bool
) -> None:
    assert _views(picture, complete=False).is_all is is_all
    assert _views(LOGO, picture, complete=False).is_all is is_all


def test_what_lies_nobody_knows_where_may_be_a_view() -> None:
    assert not _views(complete=False).is_all
