"""An isometric picture of the part in a free corner of the sheet (ISO 5456-3)."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import sqrt

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Box
from gaussiancad_core.drawing.annotation_pen import Room
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.frame import block_box, border
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import ViewFrame
from gaussiancad_core.model.views import Linetype

_SIDES = (0.5, 0.42, 0.35, 0.29, 0.24, 0.2)
"""Sides of the square for the picture, as shares of the sheet's shorter side."""

CLEARANCE = 1.5
"""To everything else, in heights of the text."""


@dataclass(frozen=True)
class SlantedFrame(ViewFrame):
    """A frame whose directions are no axes of the model: unit vectors at right angles."""

    right: tuple[float, float, float]
    up: tuple[float, float, float]
    look: tuple[float, float, float]


ISOMETRIC = SlantedFrame(
    (sqrt(1 / 2), sqrt(1 / 2), 0.0),
    (-sqrt(1 / 6), sqrt(1 / 6), sqrt(2 / 3)),
    (-sqrt(1 / 3), sqrt(1 / 3), -sqrt(1 / 3)),
)
"""From the front, the right and above, all axes foreshortened alike."""


def draw_picture(
    strokes: tuple[DrawnStroke, ...],
    views: tuple[DrawnView, ...],
    annotations: tuple[Annotation, ...],
    style: SheetStyle,
) -> list[Annotation]:
    """The visible lines of a picture, as large as the freest corner allows; none without room.

    Args:
        strokes: in mm of the picture's plane.
        views: not turned.
        annotations: all others on the sheet, not turned.
        style: size of the sheet, widths.
    """
    visible = tuple(stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE)
    if not visible:
        return []
    box = free_corner(views, annotations, style)
    if box is None:
        return []
    pad = CLEARANCE * style.text_height
    x0, y0, x1, y1 = bounds(visible)
    scale = min(
        (box[2] - box[0] - 2.0 * pad) / (x1 - x0), (box[3] - box[1] - 2.0 * pad) / (y1 - y0)
    )
    offset = (
        0.5 * (box[0] + box[2]) - scale * 0.5 * (x0 + x1),
        0.5 * (box[1] + box[3]) + scale * 0.5 * (y0 + y1),
    )
    place = Similarity(scale=scale, offset=offset, flip=True)
    placed = tuple(stroke.mapped(place) for stroke in visible)
    return [Annotation(AnnotationKind.PICTURE, 0, placed, style.visible_width)]


def free_corner(
    views: tuple[DrawnView, ...], annotations: tuple[Annotation, ...], style: SheetStyle
) -> Box | None:
    """The largest square in a corner of the sheet where nothing is, or none."""
    room = _room(views, annotations, style)
    return next((box for box in _corners(style) if room.free(box)), None)


def _room(
    views: tuple[DrawnView, ...], annotations: tuple[Annotation, ...], style: SheetStyle
) -> Room:
    taken = [view.box for view in views]
    taken += [mark.box for mark in annotations if mark.kind is not AnnotationKind.FRAME]
    if style.frame:
        return Room(border(style), [*taken, block_box(style)])
    return Room((0.0, 0.0, float(style.width), float(style.height)), taken)


def _corners(style: SheetStyle) -> Iterator[Box]:
    """Squares in the corners, large ones first, the upper right one first of its size."""
    x0, y0, x1, y1 = border(style)
    for share in _SIDES:
        side = share * min(style.width, style.height)
        for left in (x1 - side, x0):
            for top in (y0, 0.5 * (y0 + y1 - side), y1 - side):
                yield left, top, left + side, top + side
