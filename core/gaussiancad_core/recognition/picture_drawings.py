"""The drawings of a picture, by the lines that its ink was labelled as.

A picture has no paper to measure by: a line is taken to be as wide as pens are, and all else in mm
follows from that.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import shapely

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet_model.labelled_strokes import LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, PaperText, Pen
from gaussiancad_core.structure.closed_outlines import faces_of
from gaussiancad_core.structure.hatching import hatching_apart
from gaussiancad_core.views.drawing_kinds import with_kinds
from gaussiancad_core.views.drawing_titles import with_titles
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.writing.sheet_texts import SheetText

_PEN = Pen(0.35, None, "")
"""Of the lines of a picture: a usual width."""

_ROUGH = 0.5
"""mm by which places of a picture's lines may be off."""

_REACH = 2.0
"""Widths of a line by which it is made longer to meet what it ends at."""

_GAP = 1.5
"""Half of the gap in the ink of an outline that does not open it, in widths of a line."""

_CLOSED, _LEAST_SIDE = 0.9, 0.5
"""Share of what ink encloses that lines enclose where these tell the outline; share of its sides
that a drawing has at least without what sticks out of it."""

_THINNEST = 3.0
"""Width of what is no line, in widths of a line."""

_SMALLEST = 2.0
"""mm^2 that a drawing encloses at least, which is no scrap."""


@dataclass(frozen=True, eq=False)
class PictureDrawings:
    """What is drawn on a picture.

    Attributes:
        views: the drawings, mm.
        boxes: around the ink of each, px.
        bare: boxes of each without what sticks out of its outline, mm.
        scale: px per mm.
    """

    views: tuple[DrawnView, ...]
    boxes: tuple[Box, ...]
    bare: tuple[Box, ...]
    scale: float

    def without_loose_ends(self) -> "PictureDrawings":
        """The same without what sticks out of closed outlines, such as rests of a dimension."""
        views, boxes = [], []
        for view, box, bare in zip(self.views, self.boxes, self.bare, strict=True):
            x0, y0, x1, y1 = (value * self.scale for value in bare)
            half = _PEN.width * self.scale / 2.0 + 1.0
            inner = np.floor([x0 - half, y0 - half]), np.ceil([x1 + half, y1 + half])
            low, high = np.maximum(inner[0], box[:2]), np.minimum(inner[1], box[2:])
            views.append(replace(view, box=bare))
            boxes.append((*low.tolist(), *high.tolist()))
        return replace(self, views=tuple(views), boxes=tuple(boxes))


def picture_drawings(
    separated: SeparatedSheet, clusters: Sequence[Box], texts: Sequence[SheetText]
) -> PictureDrawings:
    """The drawings of a picture, their kinds and names told.

    Args:
        separated: the sheet.
        clusters: boxes around groups of the part's ink, px.
        texts: all that is written on it.
    """
    scale = separated.part.stroke_width / _PEN.width
    strokes = {
        ink: _Strokes.of(separated, ink, scale)
        for ink in (InkClass.VISIBLE, InkClass.HIDDEN, InkClass.HATCHING)
    }
    pairs = [_drawing(separated.part.ink, box, strokes, scale) for box in clusters]
    words = [
        PaperText(text.text, _scaled(text.box, 1.0 / scale))
        for text in texts
        if text.level and not text.field
    ]
    views = with_titles(with_kinds([view for view, _ in pairs], ()), words)
    return PictureDrawings(tuple(views), tuple(clusters), tuple(bare for _, bare in pairs), scale)


@dataclass(frozen=True, eq=False)
class _Strokes:
    """Strokes of one kind, mm, and (n, 2) the middle of each, px."""

    strokes: tuple[PaperStroke, ...]
    middles: np.ndarray

    @classmethod
    def of(cls, separated: SeparatedSheet, ink: InkClass, scale: float) -> "_Strokes":
        to_mm = Similarity(1.0 / scale)
        lines = [line for line in separated.labels.lines if line.ink is ink and line.curve]
        strokes = tuple(
            PaperStroke(line.curve.mapped(to_mm), _PEN) for line in lines if line.curve is not None
        )
        middles = [np.add(line.box[:2], line.box[2:]) / 2.0 for line in lines]
        return cls(strokes, np.reshape(middles, (-1, 2)))

    def within(self, box: Box) -> tuple[PaperStroke, ...]:
        """Those in a box, px."""
        inside = (self.middles >= box[:2]).all(axis=1) & (self.middles <= box[2:]).all(axis=1)
        return tuple(self.strokes[number] for number in np.flatnonzero(inside))


def _drawing(
    ink: Mask, box: Box, strokes: dict[InkClass, _Strokes], scale: float
) -> tuple[DrawnView, Box]:
    """The drawing in a box, px, and its own box without what sticks out of it, mm."""
    half = _PEN.width / 2.0
    x0, y0, x1, y1 = _scaled(box, 1.0 / scale)
    around = x0 + half, y0 + half, max(x1 - half, x0 + half), max(y1 - half, y0 + half)
    edges = strokes[InkClass.VISIBLE].within(box)
    hatches = LabelledStrokes.open(strokes[InkClass.HATCHING].within(box))
    inked, outline = _inked_outline(ink, box, scale), _outline(edges)
    is_closed = outline.area > _CLOSED * inked.area
    view = DrawnView(
        around,
        edges,
        # Ink has corners where curves have none.
        outline if is_closed else shapely.box(*around),
        strokes[InkClass.HIDDEN].within(box),
        tuple(tuple(family) for family in hatching_apart(hatches)[1]),
        kind=DrawingKind.PLAIN if inked.area > _SMALLEST else DrawingKind.SCRAP,
        rough=_ROUGH,
    )
    return view, _bare_box(outline if is_closed else _opened(inked), view)


def _bare_box(figure: shapely.Geometry, view: DrawnView) -> Box:
    """The box of a figure, if it is most of a drawing; else that of the drawing."""
    if figure.is_empty:
        return view.box
    low, high = np.reshape(figure.bounds, (2, 2))
    is_most = (high - low > _LEAST_SIDE * np.array(view.size)).all()
    return (*low.tolist(), *high.tolist()) if is_most else view.box


def _opened(figure: shapely.Geometry) -> shapely.Geometry:
    """A figure without what is as narrow as lines side by side."""
    thick = _THINNEST * _PEN.width / 2.0
    # Mitred, as corners are part of it.
    return figure.buffer(-thick, join_style="mitre").buffer(thick, join_style="mitre")


def _outline(edges: Sequence[PaperStroke]) -> shapely.Geometry:
    """What lines enclose that may end a little before they meet."""
    return faces_of([_longer(edge) for edge in edges]).outline


def _longer(edge: PaperStroke) -> PaperStroke:
    curve, reach = edge.curve, _REACH * _PEN.width
    if isinstance(curve, LineSegment) or (
        isinstance(curve, CircularArc) and curve.length + 2.0 * reach < curve.carrier.around
    ):
        return replace(edge, curve=curve.part(-reach, curve.length + reach))
    return edge


def _inked_outline(ink: Mask, box: Box, scale: float) -> shapely.Geometry:
    """What ink encloses, mm."""
    x0, y0, x1, y1 = (int(value) for value in box)
    side = 2 * int(np.ceil(_GAP * _PEN.width * scale)) + 1
    window = np.pad(ink[y0:y1, x0:x1].astype(np.uint8), side)
    closed = cv2.morphologyEx(window, cv2.MORPH_CLOSE, np.ones((side, side), np.uint8))
    contours, _ = cv2.findContours(closed, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    corner = np.array([x0 - side, y0 - side]) + 0.5
    rings = [shapely.Polygon((ring[:, 0] + corner) / scale) for ring in contours if len(ring) > 2]
    return shapely.union_all([ring.buffer(0.0) for ring in rings])


def _scaled(box: Box, by: float) -> Box:
    x0, y0, x1, y1 = box
    return x0 * by, y0 * by, x1 * by, y1 * by
