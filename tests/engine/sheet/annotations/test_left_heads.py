"""Arrowheads as wide as edges go with their lines; what the part has stays."""

from typing import Any

import cv2
import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Told
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.left_heads import without_heads
from gaussiancad_core.sheet.annotations.separate import separate_annotations
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

WIDTH = 3.0


def _headed(grey: np.ndarray, tip: tuple[int, int], way: int) -> None:
    """A filled head of 24 px by 10, its tip at a place, its line to the right of it or left."""
    x, y = tip
    corners = np.array([[x, y], [x + 24 * way, y - 5], [x + 24 * way, y + 5]])
    cv2.fillPoly(grey, [corners], 0)


def _pieces(sheet: CleanSheet) -> int:
    return cv2.connectedComponents(sheet.ink.astype(np.uint8), connectivity=8)[0] - 1


def _left(sketch: Sketch) -> CleanSheet:
    """An edge, two heads, and a blot of the heads' size on no line."""
    grey = sketch(400, 300).line((60.0, 40.0), (60.0, 200.0), WIDTH).grey
    _headed(grey, (100, 240), 1)
    _headed(grey, (300, 240), -1)
    _headed(grey, (200, 100), 1)
    return clean_sheet(grey)


def _told(start: float, end: float, y: float, kind: AnnotationKind | None) -> Told:
    line = InkedShape(Line((0.0, y), (1.0, 0.0)), (InkedRun(Run(start, end), 1.5),))
    return Told([line], [[kind]], np.zeros((300, 400), dtype=bool))


def test_heads_at_both_ends_of_a_told_line_go(sketch: Sketch) -> None:
    sheet = _left(sketch)
    part = without_heads(sheet, _told(126.0, 274.0, 240.0, AnnotationKind.DIMENSION), WIDTH)
    assert _pieces(sheet) == 4
    assert _pieces(part) == 2
    assert part.ink[:220].sum() == sheet.ink[:220].sum()


def test_blots_of_lines_that_are_no_annotations_stay(sketch: Sketch) -> None:
    sheet = _left(sketch)
    assert _pieces(without_heads(sheet, _told(126.0, 274.0, 240.0, None), WIDTH)) == 4


def test_blots_beside_a_told_line_stay(sketch: Sketch) -> None:
    sheet = _left(sketch)
    told = _told(126.0, 274.0, 246.0, AnnotationKind.DIMENSION)
    assert _pieces(without_heads(sheet, told, WIDTH)) == 4


def test_a_dash_that_an_annotation_crossed_stays(sketch: Sketch) -> None:
    """With what is left of the crossing it is thicker than a line."""
    drawn = sketch(400, 300).line((60.0, 40.0), (60.0, 200.0), 3.4)
    drawn.line((200.0, 144.0), (200.0, 156.0), 3.4).line((196.5, 150.0), (203.5, 150.0), 3.4)
    sheet = clean_sheet(drawn.grey)
    part = without_heads(sheet, _told(80.0, 196.0, 150.0, AnnotationKind.CENTRE_LINE), 2.5)
    assert part.ink.sum() == sheet.ink.sum()


def test_a_bore_with_a_blot_on_it_stays_where_a_leader_points_at_it(sketch: Sketch) -> None:
    grey = sketch(400, 300).arc((200.0, 150.0), 25.0, width=WIDTH).grey
    cv2.circle(grey, (175, 150), 4, 0, -1)
    sheet = clean_sheet(grey)
    part = without_heads(sheet, _told(80.0, 172.0, 150.0, AnnotationKind.LEADER), WIDTH)
    assert part.ink.sum() == sheet.ink.sum()


def test_no_heads_stay_where_narrow_lines_are_told_by_width(sketch: Sketch) -> None:
    """Each head is longer and wider than what goes with a line of its own width."""
    drawn = sketch(700, 500)
    corners = [(150.4, 100.3), (550.2, 100.3), (550.2, 350.6), (150.4, 350.6), (150.4, 100.3)]
    drawn.lines(*corners, width=2.0)
    for y in (150.0, 300.0):
        drawn.line((150.4, y), (550.2, y), 2.0)
    for x in (150.4, 550.2):
        drawn.line((x, 356.0), (x, 430.0), 1.0)
    drawn.line((150.4, 420.0), (550.2, 420.0), 1.0)
    grey = drawn.grey
    cv2.fillPoly(grey, [np.array([[150, 420], [178, 413], [178, 427]])], 0)
    cv2.fillPoly(grey, [np.array([[550, 420], [522, 413], [522, 427]])], 0)
    separated = separate_annotations(clean_sheet(grey))
    assert separated.by_weight
    assert _pieces(separated.part) == 1
