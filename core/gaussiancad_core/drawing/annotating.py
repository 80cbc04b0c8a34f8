"""Everything on a sheet beside the part's own lines: what, in which order, and where."""

import math

from gaussiancad_core.drawing.annotation import Annotation
from gaussiancad_core.drawing.annotation_pen import Board, Pen, Room
from gaussiancad_core.drawing.centre_lines import draw_centre_lines
from gaussiancad_core.drawing.drawn_dimensions import draw_dimensions
from gaussiancad_core.drawing.drawn_notes import draw_notes
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.frame import (
    TitleBlock,
    block_box,
    border,
    draw_frame,
    draw_title_block,
)
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.model.axes import Projection

_SCALES = tuple(
    (mantissa * 10**power, 1) if enlarged else (1, mantissa * 10**power)
    for power in range(4)
    for mantissa in (1, 2, 5)
    for enlarged in (False, True)
)
"""Lengths on the sheet to lengths of the part (ISO 5455)."""

_USUAL_DPI = 200.0


def annotate(
    views: tuple[DrawnView, ...],
    projection: Projection,
    mm_per_pixel: float,
    style: SheetStyle,
    title: str,
) -> tuple[Annotation, ...]:
    """The annotations that a style asks for, in sheet px, not turned.

    Args:
        views: not turned.
        projection: shown in the title block.
        mm_per_pixel: scale of the views.
        style: says which kinds of annotation.
        title: of the title block.
    """
    pen = Pen.of(style)
    found: list[Annotation] = []
    taken = [view.box for view in views]
    bounds = (0.0, 0.0, float(style.width), float(style.height))
    if style.frame:
        content = TitleBlock(title, scale_note(mm_per_pixel), projection)
        found += draw_frame(style) + draw_title_block(style, content)
        taken.append(block_box(style))
        bounds = border(style)
    centre_lines: list[Annotation] = []
    if style.centre_lines:
        centre_lines = draw_centre_lines(views, pen, _next_group(found))
        found += centre_lines
    if style.annotations:
        strokes = tuple(stroke for line in centre_lines for stroke in line.strokes)
        board = Board(views, strokes, mm_per_pixel, pen, Room(bounds, taken))
        found += draw_dimensions(board, _next_group(found))
        found += draw_notes(board, _next_group(found))
    return tuple(found)


def _next_group(found: list[Annotation]) -> int:
    return max((annotation.group for annotation in found), default=0) + 1


def reserved_corner(style: SheetStyle) -> tuple[float, float]:
    """Width and height in px at the sheet's lower right that the views leave to the title block."""
    if not style.frame:
        return 0.0, 0.0
    x0, y0, _, _ = block_box(style)
    clearance = 2.5 * style.text_height
    return style.width - x0 + clearance, style.height - y0 + clearance


def _scale_and_dpi(mm_per_pixel: float) -> tuple[str, float]:
    """The standard scale at which the sheet's resolution is most usual, and that resolution."""
    # On paper a pixel is ``sheet / part`` times as long as what it shows.
    choices = [(f"{sheet}:{part}", 25.4 * part / (sheet * mm_per_pixel)) for sheet, part in _SCALES]
    return min(choices, key=lambda choice: abs(math.log(choice[1] / _USUAL_DPI)))


def scale_note(mm_per_pixel: float) -> str:
    """The scale for the title block, one of ISO 5455."""
    return _scale_and_dpi(mm_per_pixel)[0]


def sheet_dpi(mm_per_pixel: float) -> float:
    """Pixels per inch of the sheet for which :func:`scale_note` is true."""
    return _scale_and_dpi(mm_per_pixel)[1]
