import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.annotation_pen import Pen
from gaussiancad_core.drawing.frame import (
    TitleBlock,
    block_box,
    border,
    draw_frame,
    draw_symbol,
    draw_title_block,
)
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.views import Arc, Segment

STYLE = PRESETS["dimensioned"]
BLOCK = TitleBlock(
    "BEARING BRACKET OF A NAME THAT IS MUCH TOO LONG FOR ITS FIELD", "1:2", Projection.FIRST
)


def _texts(annotations: list) -> list[str]:
    return [mark.label.text for mark in annotations if mark.kind is AnnotationKind.TEXT]


def test_the_frame_lies_on_the_sheet_around_the_border() -> None:
    frame = draw_frame(STYLE)
    x0, y0, x1, y1 = border(STYLE)
    for mark in frame:
        u0, v0, u1, v1 = mark.box
        assert u0 > 0.0 and v0 > 0.0 and u1 < STYLE.width and v1 < STYLE.height
        if mark.kind is AnnotationKind.TEXT:
            # Names of zones stand between the border and the outer line.
            assert u1 < x0 or u0 > x1 or v1 < y0 or v0 > y1
    rectangle = frame[0].strokes
    assert {stroke.length for stroke in rectangle} == {x1 - x0, y1 - y0}


@pytest.mark.parametrize("size", [(1920, 1080), (3000, 4000), (1200, 1200)])
def test_opposite_zones_have_the_same_names(size: tuple[int, int]) -> None:
    style = SheetStyle(width=size[0], height=size[1], frame=True)
    names = _texts(draw_frame(style))
    letters = [name for name in names if name.isalpha()]
    numbers = [name for name in names if name.isdigit()]
    half = len(numbers) // 2
    assert numbers[:half] == numbers[half:] == [str(n + 1) for n in range(half)]
    half = len(letters) // 2
    assert letters[:half] == letters[half:] == sorted(letters[:half])
    assert not {"I", "O"} & set(letters)


def test_the_title_block_fills_the_lower_right_corner() -> None:
    marks = draw_title_block(STYLE, BLOCK)
    box = block_box(STYLE)
    assert box[2:] == border(STYLE)[2:]
    for mark in marks:
        u0, v0, u1, v1 = mark.box
        assert box[0] <= u0 and box[1] <= v0 and u1 <= box[2] + 1e-9 and v1 <= box[3] + 1e-9
    texts = _texts(marks)
    assert {"1:2", BLOCK.title, "mm"} <= set(texts)


def test_nothing_in_the_title_block_overlaps() -> None:
    marks = draw_title_block(STYLE, BLOCK)
    boxes = [mark.box for mark in marks if mark.kind is AnnotationKind.TEXT]
    symbols = np.array([mark.box for mark in marks if mark.kind is AnnotationKind.SYMBOL])
    boxes.append((*symbols[:, :2].min(axis=0), *symbols[:, 2:].max(axis=0)))
    lines = [
        (*np.minimum(s.start, s.end), *np.maximum(s.start, s.end))
        for mark in marks
        if mark.kind is AnnotationKind.TITLE_BLOCK
        for s in mark.strokes
    ]
    for index, one in enumerate(boxes):
        for other in (*boxes[:index], *lines):
            apart = (
                one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
            )
            assert apart, (one, other)


@pytest.mark.parametrize(("projection", "side"), [(Projection.THIRD, -1), (Projection.FIRST, 1)])
def test_the_symbol_shows_the_narrow_end_where_the_projection_puts_it(
    projection: Projection, side: int
) -> None:
    lines, axes = draw_symbol(projection, (100.0, 50.0), 40.0, Pen(1.0, 18.0))
    circles = [stroke for stroke in lines.strokes if isinstance(stroke, Arc)]
    edges = [stroke for stroke in lines.strokes if isinstance(stroke, Segment)]
    assert sorted(circle.radius for circle in circles) == [10.0, 20.0]
    assert {circle.centre for circle in circles} == {(100.0 + side * 30.0, 50.0)}
    ends = {round(e.start[0], 6): e.length for e in edges if e.start[0] == e.end[0]}
    # The narrow end is at the left in both; the end view looks at it.
    assert [ends[x] for x in sorted(ends)] == [20.0, 40.0]
    low, high = sorted(ends)
    assert 0.5 * (low + high) == pytest.approx(100.0 - side * 30.0)
    assert axes.box[0] < lines.box[0] and axes.box[2] > lines.box[2]
