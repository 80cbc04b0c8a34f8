"""Border, zones, title block and projection symbol (ISO 5457, ISO 7200, ISO 5456-2)."""

from dataclasses import dataclass

import numpy as np

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Box, Rhythm
from gaussiancad_core.drawing.annotation_pen import Pen
from gaussiancad_core.drawing.lettering import label, text_width
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.views import Arc, Linetype, Segment

BLOCK = (27.0, 8.0)
"""Width and height of the title block in heights of the text."""

_EDGE, _ZONE = 0.45, 1.45
"""From the sheet's edge to the outer line, and width of the zones, in heights of the text."""

_ZONE_LENGTH = 14.0
"""Nominal length of a zone in heights of the text."""

_LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ"

_CAPTION = 0.5
"""Height of the title block's captions in heights of the text."""


@dataclass(frozen=True)
class TitleBlock:
    """What a title block says.

    Attributes:
        title: of the part.
        scale: as in ISO 5455, such as ``1:2``.
        projection: shown as its symbol.
    """

    title: str
    scale: str
    projection: Projection


def border(style: SheetStyle) -> Box:
    """The border inside which everything is drawn, in sheet px."""
    inset = (_EDGE + _ZONE) * style.text_height
    return inset, inset, style.width - inset, style.height - inset


def block_box(style: SheetStyle) -> Box:
    """The title block, in the lower right corner of the border, in sheet px."""
    _, _, x1, y1 = border(style)
    width, height = (share * style.text_height for share in BLOCK)
    return x1 - width, y1 - height, x1, y1


def draw_frame(style: SheetStyle) -> list[Annotation]:
    """Border, outer line, centring marks and zones with their names."""
    height = style.text_height
    inner = border(style)
    edge = _EDGE * height
    outer = (edge, edge, style.width - edge, style.height - edge)
    marks: list[DrawnStroke] = []
    names: list[Annotation] = []
    for index, extent in enumerate((style.width, style.height)):
        # An even number, so that zones begin at the centring marks.
        count = 2 * max(1, round(extent / (_ZONE_LENGTH * height) / 2.0))
        low, high = inner[index], inner[index + 2]
        cuts = np.linspace(low, high, count + 1)
        for near, far in (
            (inner[1 - index], outer[1 - index]),
            (inner[3 - index], outer[3 - index]),
        ):
            marks += [_across(index, float(at), near, far) for at in cuts[1:-1]]
            for number, at in enumerate((cuts[1:] + cuts[:-1]) / 2.0):
                name = str(number + 1) if index == 0 else _LETTERS[number % len(_LETTERS)]
                middle = 0.5 * (near + far)
                point = (float(at), middle) if index == 0 else (middle, float(at))
                names.append(_text(name, point, 0.75 * height))
    centring = [
        _across(index, 0.5 * (inner[index] + inner[index + 2]), outer[side], end)
        for index in (0, 1)
        for side, end in (
            (1 - index, inner[1 - index] + 0.6 * height),
            (3 - index, inner[3 - index] - 0.6 * height),
        )
    ]
    wide = style.visible_width
    return [
        Annotation(AnnotationKind.FRAME, 0, _rectangle(inner), wide),
        Annotation(AnnotationKind.FRAME, 0, tuple(centring), wide),
        Annotation(AnnotationKind.FRAME, 0, (*_rectangle(outer), *marks), style.annotation_width),
        *names,
    ]


def draw_title_block(style: SheetStyle, content: TitleBlock) -> list[Annotation]:
    """Outline and fields of the title block, their text, and the projection symbol."""
    h = style.text_height
    left, top, right, bottom = block_box(style)

    def field(x0: float, y0: float, x1: float, y1: float) -> Box:
        return left + x0 * h, top + y0 * h, left + x1 * h, top + y1 * h

    fields = (
        (field(0, 0, 9, 2.5), "GENERAL TOLERANCES", "ISO 2768-m"),
        (field(9, 0, 18, 2.5), "MATERIAL", "S235JR"),
        (field(18, 0, 27, 2.5), "DIMENSIONS IN", "mm"),
        (field(0, 2.5, 9, 5.5), "DRAWN", "GaussianCAD"),
        (field(9, 2.5, 27, 5.5), "TITLE", content.title),
        (field(0, 5.5, 9, 8), "PROJ.", ""),
        (field(9, 5.5, 15, 8), "SCALE", content.scale),
        (field(15, 5.5, 21, 8), "SIZE", f"{style.width} x {style.height}"),
        (field(21, 5.5, 27, 8), "SHEET", "1/1"),
    )
    inner = [
        *(_across(1, top + y * h, left, right) for y in (2.5, 5.5)),
        *(_across(0, left + x * h, top, top + 2.5 * h) for x in (9, 18)),
        _across(0, left + 9 * h, top + 2.5 * h, bottom),
        *(_across(0, left + x * h, top + 5.5 * h, bottom) for x in (15, 21)),
    ]
    # The border closes the block below and at the right.
    outline = (_across(1, top, left, right), _across(0, left, top, bottom))
    texts = []
    for box, caption, value in fields:
        texts += _field_text(box, caption, value, h)
    symbol = []
    if style.symbol:
        middle = (left + 6.4 * h, top + 6.75 * h)
        symbol = draw_symbol(content.projection, middle, 1.4 * h, Pen.of(style))
    return [
        Annotation(AnnotationKind.TITLE_BLOCK, 0, outline, style.visible_width),
        Annotation(AnnotationKind.TITLE_BLOCK, 0, tuple(inner), style.annotation_width),
        *texts,
        *symbol,
    ]


def draw_symbol(
    projection: Projection, centre: tuple[float, float], size: float, pen: Pen
) -> list[Annotation]:
    """A truncated cone and its end view (ISO 5456-2).

    The end view shows both circles, so it looks at the narrow end: it stands on that side in third
    angle, and on the other one in first angle.  The narrow end is at the left.

    Args:
        projection: which symbol.
        centre: (2,) sheet px of its middle.
        size: px, the larger diameter.
        pen: of its lines.
    """
    side = -1.0 if projection is Projection.THIRD else 1.0
    ring = (centre[0] + side * 0.75 * size, centre[1])
    x = centre[0] - side * 0.75 * size
    narrow, wide = x - 0.5 * size, x + 0.5 * size
    y = centre[1]
    corners = [
        (narrow, y - 0.25 * size),
        (wide, y - 0.5 * size),
        (wide, y + 0.5 * size),
        (narrow, y + 0.25 * size),
    ]
    cone = [
        Segment(one, other, Linetype.VISIBLE)
        for one, other in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    circles = [
        Arc(ring, radius * size, 0.0, 2.0 * np.pi, Linetype.VISIBLE) for radius in (0.25, 0.5)
    ]
    reach = 0.5 * size + pen.overshoot
    axes = (
        _across(1, y, narrow - pen.overshoot, wide + pen.overshoot),
        _across(1, y, ring[0] - reach, ring[0] + reach),
        _across(0, ring[0], y - reach, y + reach),
    )
    return [
        Annotation(AnnotationKind.SYMBOL, 0, (*cone, *circles), pen.width),
        Annotation(AnnotationKind.SYMBOL, 0, axes, 0.6 * pen.width, Rhythm.LONG_SHORT),
    ]


def _field_text(box: Box, caption: str, value: str, height: float) -> list[Annotation]:
    x0, y0, x1, y1 = box
    small = _CAPTION * height
    pad = 0.35 * height
    start = x0 + pad + text_width(caption, small) / 2.0
    texts = [_text(caption, (start, y0 + pad + small / 2.0), small)]
    if value:
        fitting = (x1 - x0 - 2.0 * pad) / text_width(value, 1.0)
        size = min(height, fitting)
        middle = 0.5 * (y0 + pad + small + y1)
        texts.append(_text(value, (0.5 * (x0 + x1), middle), size))
    return texts


def _text(text: str, centre: tuple[float, float], height: float) -> Annotation:
    return Annotation(AnnotationKind.TEXT, 0, label=label(text, centre, height))


def _across(index: int, at: float, start: float, end: float) -> Segment:
    """A line at a coordinate of axis ``index``, from ``start`` to ``end`` on the other axis."""
    if index == 0:
        return Segment((at, start), (at, end), Linetype.VISIBLE)
    return Segment((start, at), (end, at), Linetype.VISIBLE)


def _rectangle(box: Box) -> tuple[DrawnStroke, ...]:
    x0, y0, x1, y1 = box
    return (
        _across(1, y0, x0, x1),
        _across(0, x1, y0, y1),
        _across(1, y1, x0, x1),
        _across(0, x0, y0, y1),
    )
