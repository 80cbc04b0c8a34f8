"""Shaded views that are pictures in a file: their outlines stand for edges that it has not."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

import cv2
import numpy as np
import shapely
from shapely import Polygon

from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import Box, to_point
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke, Pen, Points

PICTURE = Pen(0.0, None, "picture")
"""Of the edges that are the outline of a picture."""

_WHITE = 250
"""Grey level from which a pixel is paper."""

_SMALLEST, _LARGEST = 20.0, 0.5
"""mm^2 of a picture at least, and share of the sheet at most."""

_LEAST = 15.0
"""mm^2 of a figure in it at least."""

_CORNER_PX, _LINE_PX, _WIDE_PX = 1.2, 3, 7
"""px by which an outline may run beside a figure's; width at which lines over it are taken off,
and that no line has."""

_LINE = 0.12
"""mm from the middle of the line that is painted around a figure to its outer side."""

_AROUND = 0.6
"""mm around a figure that belong to it."""

_DRAWN = 0.97
"""Share of a figure's width and height that edges span where the file draws it itself."""

OVER = (
    Label.DIMENSION,
    Label.EXTENSION,
    Label.CENTRE,
    Label.ARROW,
    Label.TEXT,
    Label.OTHER,
)
"""What is drawn over pictures and does not belong to them."""


def with_picture_outlines(
    sheet: PaperSheet, labelled: LabelledStrokes, area: Polygon
) -> LabelledStrokes:
    """The strokes, with the outlines of pictures in which the file draws none as edges.

    Args:
        sheet: with its pictures.
        labelled: its strokes.
        area: in which its views lie, mm.
    """
    if sheet.paint is None or not sheet.pictures:
        return labelled
    edges = labelled.of(Label.EDGE)
    over = labelled.of(*OVER)
    found: list[PaperStroke] = []
    for box in sheet.pictures:
        frame = shapely.box(*box)
        is_large = frame.area > _LARGEST * sheet.size[0] * sheet.size[1]
        if frame.area < _SMALLEST or is_large or not area.contains(frame.centroid):
            continue
        for corners in _figures(sheet, box, over):
            if not _is_drawn(corners, edges):
                ring = np.concatenate([corners, corners[:1]])
                found += [
                    PaperStroke(LineSegment(to_point(start), to_point(end)), PICTURE)
                    for start, end in pairwise(ring)
                ]
    first = len(labelled.strokes)
    labelled = labelled.joined([], found, "")
    numbers = range(first, len(labelled.strokes))
    return labelled.with_label(numbers, Label.EDGE, "outline of a picture")


def _figures(sheet: PaperSheet, box: Box, over: Sequence[PaperStroke]) -> Iterator[Points]:
    """(n, 2) mm, the corners of what is dark within a box."""
    assert sheet.paint is not None
    grey = sheet.paint(box)
    if min(grey.shape) < 8:
        return
    scale = sheet.px_per_mm
    mask = (grey < _WHITE).astype(np.uint8)
    # What is wider than lines is shaded, whatever is drawn over it.
    wide = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((_WIDE_PX, _WIDE_PX), np.uint8))
    frame = shapely.box(*box)
    for stroke in over:
        if frame.intersects(shapely.box(*stroke.box)):
            places = np.rint((stroke.points - np.array(box[:2])) * scale - 0.5).astype(np.int32)
            cv2.polylines(mask, [places], False, 0, _LINE_PX)
    mask = np.maximum(mask, wide)
    corner = np.floor(np.array(box[:2]) * scale + 0.5) / scale
    for contour in cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]:
        if cv2.contourArea(contour) < _LEAST * scale * scale:
            continue
        places = (cv2.approxPolyDP(contour, _CORNER_PX, closed=True)[:, 0] + 0.5) / scale + corner
        ring = Polygon(places).buffer(0.0).buffer(-_LINE, join_style="mitre")
        if isinstance(ring, Polygon) and not ring.is_empty:
            yield np.array(ring.exterior.coords)[:-1]


def _is_drawn(corners: Points, edges: Sequence[PaperStroke]) -> bool:
    """Whether edges span a figure."""
    ring = Polygon(corners).buffer(_AROUND)
    boxes = [shapely.box(*edge.box) for edge in edges]
    inside = [box.bounds for box in boxes if ring.contains(box.centroid)]
    if not inside:
        return False
    low, high = np.min(inside, axis=0)[:2], np.max(inside, axis=0)[2:]
    return bool((high - low > _DRAWN * np.ptp(corners, axis=0)).all())
