"""A view that a file has as a shaded picture is read with the lines that were drawn on it."""

from itertools import pairwise
from pathlib import Path

import cv2
import numpy as np
import pytest

from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.recognition.file_views import file_views
from gaussiancad_core.recognition.labelled_file import strokes_of_file
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.sheet_stages import ReadView, read_views

LEFT, TOP, RIGHT, BOTTOM = 800, 200, 1100, 500
"""Of the shaded view, px."""

INNER = 920
"""Its inner line."""


def _shaded(*, edges: bool, texture: int = 0, dashed: bool = False) -> np.ndarray:
    """A sheet with a grey face, with lines on it or without."""
    grey = np.full((800, 1500), 255, np.uint8)
    face = grey[TOP : BOTTOM + 1, LEFT : RIGHT + 1]
    face[:] = 150
    face[::7] -= texture
    if edges:
        cv2.rectangle(grey, (LEFT, TOP), (RIGHT, BOTTOM), 60, 3)
        for start in range(TOP, BOTTOM, 20):
            end = start + (12 if dashed else 20)
            cv2.line(grey, (INNER, start), (INNER, min(end, BOTTOM)), 60, 3)
    return grey


def _right_view(grey: np.ndarray) -> ReadView:
    """The right view, beside a front view that the file draws."""
    corners = [(200, TOP), (600, TOP), (600, BOTTOM), (200, BOTTOM), (200, TOP)]
    outline = [VectorStroke(LineSegment(a, b), 3.0) for a, b in pairwise(corners)]
    around = (LEFT - 10.0, TOP - 10.0, RIGHT + 10.0, BOTTOM + 10.0)
    drawing = VectorDrawing(tuple(outline), (), complete=False, pictures=(around,))
    sheet = OpenedSheet(SheetImage(Path("sheet.pdf"), grey, "", 200.0, drawing))
    file = strokes_of_file(sheet, Projection.THIRD)
    assert file is not None
    found = file_views(file, {}, Projection.THIRD, None)
    assert found is not None and set(found.layout.boxes) == {Role.FRONT, Role.RIGHT}
    drawn = read_views(found.separated.part, found.layout, vectors=found.vectors)
    views = found.with_traced_lines(drawn)
    return next(view for view in views if view.role is Role.RIGHT)


def _inner_lines(view: ReadView) -> list[Segment]:
    return [
        stroke
        for stroke in view.strokes
        if isinstance(stroke, Segment)
        and abs(stroke.start[0] - stroke.end[0]) < 1.0
        and LEFT + 20 < stroke.start[0] < RIGHT - 20
    ]


@pytest.mark.parametrize("texture", [0, 15])
@pytest.mark.parametrize("dashed", [False, True])
def test_lines_on_a_face_are_edges_and_its_texture_is_none(texture: int, dashed: bool) -> None:
    view = _right_view(_shaded(edges=True, texture=texture, dashed=dashed))
    (line,) = _inner_lines(view)
    assert line.start[0] == pytest.approx(INNER + 0.5, abs=0.5)
    assert line.length == pytest.approx(BOTTOM - TOP, abs=12.0)
    assert line.linetype is (Linetype.HIDDEN if dashed else Linetype.VISIBLE)
    assert len(view.strokes) == 5
    assert view.box == pytest.approx((LEFT + 0.5, TOP + 0.5, RIGHT + 0.5, BOTTOM + 0.5), abs=1.0)


def test_a_face_without_lines_keeps_its_outline() -> None:
    view = _right_view(_shaded(edges=False))
    assert len(view.strokes) == 4 and view.outline is not None
    assert view.box == pytest.approx((LEFT, TOP, RIGHT, BOTTOM), abs=2.0)
