"""Drawings beside the views: an enlarged detail, an auxiliary view, another part (ISO 128-3)."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Box, Point
from gaussiancad_core.drawing.drawn_view import CURVE_STEP, DrawnView
from gaussiancad_core.drawing.isometric_picture import CLEARANCE, free_corner
from gaussiancad_core.drawing.lettering import label
from gaussiancad_core.drawing.sheet_style import Inset, SheetStyle
from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.geometry.similarities import Similarity, turn_about
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Arc, Linetype, Segment

_DETAIL_SHARE = 0.2
"""Radius of what a detail shows, as a share of the view's shorter side."""

_SLANT = np.radians(30.0)
"""By which an auxiliary view is turned."""

_SIZE = 0.75
"""Size of an auxiliary view beside the view that it shows the part like."""


def draw_inset(
    views: tuple[DrawnView, ...], annotations: tuple[Annotation, ...], style: SheetStyle
) -> list[Annotation]:
    """What a style asks for beside the views, in the freest corner; nothing without room.

    Args:
        views: not turned.
        annotations: all others on the sheet, not turned.
        style: says what; size of the sheet, widths.
    """
    box = free_corner(views, annotations, style)
    if box is None or style.inset is None:
        return []
    pad = CLEARANCE * style.text_height
    room = (box[0] + pad, box[1] + pad, box[2] - pad, box[3] - pad)
    draw = {
        Inset.DETAIL: _detail,
        Inset.AUXILIARY: _auxiliary,
        Inset.OTHER_PART: _other_part,
    }[style.inset]
    return draw(views, room, style)


def _detail(views: tuple[DrawnView, ...], room: Box, style: SheetStyle) -> list[Annotation]:
    """A corner of the first view, enlarged, both places ringed and lettered."""
    view = views[0]
    x0, y0, x1, y1 = view.box
    radius = _DETAIL_SHARE * min(x1 - x0, y1 - y0)
    corner = max(_visible_ends(view.strokes), key=lambda point: point[0] - point[1])
    middle = _middle(room)
    larger = 0.5 * min(room[2] - room[0], room[3] - room[1] - 2.0 * style.text_height)
    scale = larger / radius
    offset = (middle[0] - scale * corner[0], middle[1] - scale * corner[1])
    cut = cut_by_circle(view.strokes, corner, radius)
    place = Similarity(scale=scale, offset=offset)
    shown = tuple(stroke.mapped(place) for stroke in cut)
    rings = tuple(
        Arc(centre, size, 0.0, 2.0 * np.pi, Linetype.VISIBLE)
        for centre, size in ((corner, radius), (middle, larger))
    )
    height = style.text_height
    names = [
        _text("A", (corner[0] + radius + 0.8 * height, corner[1] - radius), height),
        _text("A (2:1)", (middle[0], middle[1] + larger + 1.2 * height), height),
    ]
    thin = style.annotation_width
    return [
        Annotation(AnnotationKind.DETAIL, 0, shown, style.visible_width),
        Annotation(AnnotationKind.DETAIL, 0, rings[1:], thin),
        Annotation(AnnotationKind.LEADER, 0, rings[:1], thin),
        *names,
    ]


def _auxiliary(views: tuple[DrawnView, ...], room: Box, style: SheetStyle) -> list[Annotation]:
    """The visible lines of the first view, turned."""
    visible = [s for s in views[0].strokes if s.linetype is Linetype.VISIBLE]
    turn = turn_about(_middle(views[0].box), -_SLANT)
    slanted = tuple(stroke.mapped(turn) for stroke in visible)
    x0, y0, x1, y1 = bounds(slanted)
    width, height = room[2] - room[0], room[3] - room[1]
    scale = min(_SIZE, width / (x1 - x0), height / (y1 - y0))
    middle = _middle(room)
    offset = (middle[0] - scale * 0.5 * (x0 + x1), middle[1] - scale * 0.5 * (y0 + y1))
    place = Similarity(scale=scale, offset=offset)
    placed = tuple(stroke.mapped(place) for stroke in slanted)
    return [Annotation(AnnotationKind.AUXILIARY, 0, placed, style.visible_width)]


def _other_part(views: tuple[DrawnView, ...], room: Box, style: SheetStyle) -> list[Annotation]:
    """A flanged bush from two sides."""
    side = min(room[2] - room[0], room[3] - room[1])
    middle = _middle(room)
    flange, body, bore = 0.22 * side, 0.15 * side, 0.08 * side
    left, step, right = (middle[0] - share * side for share in (0.48, 0.38, 0.12))
    y = middle[1]
    outline = _chain(
        [
            (left, y - flange),
            (step, y - flange),
            (step, y - body),
            (right, y - body),
            (right, y + body),
            (step, y + body),
            (step, y + flange),
            (left, y + flange),
            (left, y - flange),
        ]
    )
    shoulder = _chain([(step, y - body), (step, y + body)])
    centre = (middle[0] + 0.24 * side, y)
    rounds = tuple(
        Arc(centre, radius, 0.0, 2.0 * np.pi, Linetype.VISIBLE) for radius in (flange, body, bore)
    )
    strokes: tuple[DrawnStroke, ...] = (*outline, *shoulder, *rounds)
    return [Annotation(AnnotationKind.OTHER_PART, 0, strokes, style.visible_width)]


def cut_by_circle(
    strokes: Sequence[DrawnStroke], centre: Point, radius: float
) -> tuple[DrawnStroke, ...]:
    """What of visible strokes lies within a circle; curves become chains."""
    disc = shapely.Point(centre).buffer(radius, 64)
    found: list[DrawnStroke] = []
    for stroke in strokes:
        if stroke.linetype is not Linetype.VISIBLE:
            continue
        points = _points_of(stroke)
        inside = shapely.intersection(shapely.LineString(points), disc)
        for piece in shapely.get_parts(inside):
            if piece.geom_type == "LineString" and piece.length > CURVE_STEP:
                found.append(Polyline(tuple(piece.coords), Linetype.VISIBLE))
    return tuple(found)


def _points_of(stroke: DrawnStroke) -> npt.NDArray[np.float64]:
    if isinstance(stroke, Segment):
        return np.array([stroke.start, stroke.end])
    return stroke.sample(CURVE_STEP)


def _visible_ends(strokes: Sequence[DrawnStroke]) -> list[Point]:
    return [
        (float(x), float(y))
        for stroke in strokes
        if stroke.linetype is Linetype.VISIBLE
        for x, y in _points_of(stroke)[[0, -1]]
    ]


def _chain(points: Sequence[Point]) -> tuple[Segment, ...]:
    return tuple(Segment(one, other, Linetype.VISIBLE) for one, other in pairwise(points))


def _middle(box: Box) -> Point:
    return 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])


def _text(text: str, centre: Point, height: float) -> Annotation:
    return Annotation(AnnotationKind.TEXT, 0, label=label(text, centre, height))
