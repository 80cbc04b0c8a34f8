"""The frame, the drawing area and the fields of the title block, to the pixel."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.frame import (
    TitleBlock,
    block_box,
    border,
    draw_frame,
    draw_title_block,
)
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.annotations.sheet_frame import Frame, find_frame
from gaussiancad_core.sheet.image.deskew import Turn

Sketch = Any
"""The class that the fixture gives."""

STYLE = replace(PRESETS["dimensioned"], width=1280, height=800, text_height=18.0)
BLOCK = TitleBlock("BRACKET", "1:2", Projection.THIRD)


def _framed(style: SheetStyle = STYLE, block: bool = True) -> Mask:
    marks = draw_frame(style)
    if block:
        marks += draw_title_block(style, BLOCK)
    return ink_annotations(tuple(marks), style) >= 0.5


def _found(ink: Mask) -> Frame | None:
    """The frame of a sheet that was not turned."""
    return find_frame(ink, Turn(0.0, (ink.shape[1] / 2, ink.shape[0] / 2)))


def test_a_sheet_read_at_another_scale_has_the_same_frame() -> None:
    ink = _framed()
    half = Turn(0.0, (ink.shape[1] / 2, ink.shape[0] / 2), 2.0)
    frame, other = _found(ink), find_frame(ink, half)
    assert frame is not None
    assert other is not None
    assert (frame.drawing_area == other.drawing_area).all()
    assert frame.marks == other.marks


def _boxes(frame: Frame, kind: AnnotationKind) -> list[tuple[float, float, float, float]]:
    return sorted(mark.box for mark in frame.marks if mark.kind is kind)


@pytest.mark.parametrize("style", [STYLE, replace(STYLE, visible_width=2.0, annotation_width=1.0)])
def test_the_drawing_area_is_what_the_border_encloses_but_the_block(style: SheetStyle) -> None:
    frame = _found(_framed(style))
    assert frame is not None
    x0, y0, x1, y1 = border(style)
    bx0, by0, _, _ = block_box(style)
    columns, rows = np.arange(style.width) + 0.5, np.arange(style.height)[:, None] + 0.5
    # Ink may be dropped with the frame's lines, never paper two px away from them.
    reach = style.visible_width / 2 + 2.5
    # The centring marks reach into the drawing.
    marks = np.zeros((style.height, style.width), bool)
    long = 0.6 * style.text_height + reach
    for x, y in (
        ((x0 + x1) / 2, y0),
        ((x0 + x1) / 2, y1),
        (x0, (y0 + y1) / 2),
        (x1, (y0 + y1) / 2),
    ):
        marks |= (np.abs(columns - x) < long) & (np.abs(rows - y) < long)
    for grown, inside in ((-reach, True), (reach, False)):
        within = (columns > x0 - grown) & (columns < x1 + grown)
        within = within & (rows > y0 - grown) & (rows < y1 + grown)
        block = (columns > bx0 + grown) & (rows > by0 + grown)
        expected = within & ~block
        if inside:
            assert frame.drawing_area[expected & ~marks].all()
        else:
            assert not frame.drawing_area[~expected].any()


def test_the_fields_of_the_title_block() -> None:
    """Nine written fields; the zones lie outside of the border and are not told."""
    frame = _found(_framed())
    assert frame is not None
    fields = _boxes(frame, AnnotationKind.TITLE_BLOCK)
    x0, y0, _, y1 = block_box(STYLE)
    h = STYLE.text_height
    # The projection symbol encloses areas of its own.
    large = [box for box in fields if box[2] - box[0] > 4 * h]
    inside = [box for box in large if box[0] > x0 - 2 and box[1] > y0 - 2 and box[3] < y1 + 2]
    expected = sorted(
        (x0 + a * h, y0 + b * h, x0 + c * h, y0 + d * h)
        for a, b, c, d in (
            (0, 0, 9, 2.5),
            (9, 0, 18, 2.5),
            (18, 0, 27, 2.5),
            (0, 2.5, 9, 5.5),
            (9, 2.5, 27, 5.5),
            (0, 5.5, 9, 8),
            (9, 5.5, 15, 8),
            (15, 5.5, 21, 8),
            (21, 5.5, 27, 8),
        )
    )
    assert len(inside) == 9
    for found, true in zip(inside, expected, strict=True):
        assert found == pytest.approx(true, abs=4.0)


def test_the_frame_itself() -> None:
    frame = _found(_framed())
    assert frame is not None
    edge = 0.45 * STYLE.text_height
    boxes = _boxes(frame, AnnotationKind.FRAME)
    assert boxes[0] == pytest.approx((edge, edge, STYLE.width - edge, STYLE.height - edge), abs=3.0)


def test_views_stay_in_the_drawing_area() -> None:
    """Closed outlines within it are no holes in it."""
    ink = _framed()
    part = np.zeros_like(ink)
    part[150:153, 200:500] = part[400:403, 200:500] = True
    part[150:403, 200:203] = part[150:403, 497:500] = True
    frame = _found(ink | part)
    plain = _found(ink)
    assert frame is not None
    assert plain is not None
    assert np.array_equal(frame.drawing_area, plain.drawing_area)
    assert frame.marks == plain.marks


def test_a_frame_without_a_block() -> None:
    frame = _found(_framed(block=False))
    assert frame is not None
    x0, y0, x1, y1 = border(STYLE)
    assert frame.drawing_area.sum() == pytest.approx((x1 - x0) * (y1 - y0), rel=0.02)
    assert frame.drawing_area[int(y1) - 20, int(x1) - 20]


def test_a_plain_border(sketch: Sketch) -> None:
    """A single line around the drawing, one px wide and broken by a scanner here and there."""
    ink = sketch(400, 300).box(20, 20, 380, 280, 1.0).weight >= 0.5
    ink[20, 100:102] = False
    ink[150, 380] = False
    frame = _found(ink)
    assert frame is not None
    assert frame.drawing_area[22:279, 22:379].all()
    assert not frame.drawing_area[:20].any()
    assert not frame.drawing_area[:, 381:].any()
    assert [mark.kind for mark in frame.marks] == [AnnotationKind.FRAME]


def test_no_frame(sketch: Sketch) -> None:
    drawn = sketch(400, 300).box(120, 90, 300, 220)
    assert _found(drawn.weight >= 0.5) is None
    assert _found(np.zeros((300, 400), bool)) is None


@pytest.mark.parametrize("cuts", [1, 2, 3])
def test_a_view_that_spans_the_sheet_is_no_frame(sketch: Sketch, cuts: int) -> None:
    """A plate drawn large, its steps across: none of its faces is most of the sheet."""
    drawn = sketch(400, 300).box(30, 25, 370, 275)
    for k in range(1, 4):
        drawn.line((30 + 85 * k, 25), (30 + 85 * k, 275))
    for k in range(1, cuts):
        drawn.line((30, 25 + 250 * k / cuts), (370, 25 + 250 * k / cuts))
    assert _found(drawn.weight >= 0.5) is None


def test_a_dark_border_of_a_copier_is_taken_off() -> None:
    """The shadow of a copier's lid goes like a frame, and all of the paper stays."""
    ink = np.zeros((300, 400), bool)
    ink[:30] = ink[:, :25] = ink[-30:] = ink[:, -25:] = True
    frame = _found(ink)
    assert frame is not None
    assert frame.drawing_area[31:-31, 26:-26].all()
    assert not (frame.drawing_area & ink).any()


def _on_paper(width: int, sketch: Sketch) -> np.ndarray:
    """A frame of 300 x 200 px with a view in it, in the middle of paper of some width."""
    left = (width - 300) / 2
    drawn = sketch(width, 240)
    for inset in (0, 12):
        drawn.box(left + inset, 20 + inset, left + 300 - inset, 220 - inset)
    drawn.line((left + 150, 20), (left + 150, 32))
    drawn.box(left + 100, 80, left + 180, 150)
    return drawn.weight >= 0.5


@pytest.mark.parametrize("width", [320, 400, 480])
def test_a_frame_on_wider_paper_is_taken_off(sketch: Sketch, width: int) -> None:
    ink = _on_paper(width, sketch)
    frame = _found(ink)
    assert frame is not None
    left = ink & frame.drawing_area
    columns = np.flatnonzero(left.any(axis=0))
    assert (columns[0], columns[-1]) == pytest.approx((width / 2 - 50, width / 2 + 30), abs=2.5)


def test_a_long_view_that_is_empty_within_is_no_frame(sketch: Sketch) -> None:
    """A plate wider than most of the sheet, beside other views."""
    drawn = sketch(400, 300).box(20, 40, 300, 180)
    drawn.box(20, 230, 300, 250)
    assert _found(drawn.weight >= 0.5) is None


def _box(ink: Mask, x0: int, y0: int, x1: int, y1: int) -> None:
    """Draw a rectangle, two px wide."""
    ink[y0 : y1 + 2, [x0, x0 + 1, x1, x1 + 1]] = True
    ink[[y0, y0 + 1, y1, y1 + 1], x0 : x1 + 2] = True


@pytest.mark.parametrize(("wide", "written"), [(True, True), (False, True), (True, False)])
def test_a_frame_may_be_of_boxes_that_are_as_wide_as_each_other(wide: bool, written: bool) -> None:
    ink = np.zeros((1300, 920), bool)
    _box(ink, 107, 114, 868, 900)
    _box(ink, 107, 925, 868 if wide else 600, 1207)
    for y in (995, 1065, 1135):
        ink[y : y + 2, 107 : 868 if wide else 600] = True
    for y in (940, 1010, 1080) if written else ():
        ink[y : y + 20, 200:260] = True
    _box(ink, 300, 540, 380, 700)
    # Writing above the frame.
    ink[50:75, 110:270] = True
    frame = _found(ink)
    if wide and written:
        assert frame is not None
        assert frame.drawing_area[600, 340] and frame.drawing_area[200, 200]
        assert not frame.drawing_area[1000, 400] and not frame.drawing_area[60, 200]
    else:
        # Two views may be as large, and as wide as each other.
        assert frame is None
