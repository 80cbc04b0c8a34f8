"""The area of a sheet in which its views lie: inside the frame, beside the title block.

The largest face of the lines along the paper's edges is that area, whatever is ruled around it, if
anything says that it is framed: cells with text that share a side with it, margins to the edges of
the paper, a second line around it.  Else it may as well be the outline of a plate.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Polygon

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke, lines_of

_LEVEL = 0.02
"""Sine of the angle by which a line may lean and still run along the paper's edges."""

_SHORTEST = 4.0
"""mm of a ruled line at least."""

_OVERRUN = 0.3
"""mm by which ends of ruled lines may miss each other."""

_LARGE = 0.4
"""Share of the sheet that the area has at least: else there is no frame."""

_EDGE = 0.25
"""mm to the area's edge within which strokes lie on its frame."""

_CELLS = 3
"""Cells with text beside the area that tell a title block."""

_MARGIN = 32.0
"""mm from a frame to the edge of the paper at most: ISO 5457 has 20 on the left and 10 else, and
some leave room for zone marks."""

_FILING, _OFF = 2.0, 0.1
"""The filing margin, on the left, over the other ones, which are alike (ISO 5457: 20 and 10 mm),
and share by which margins may differ from that."""

_BESIDE = 8.0
"""mm from a frame to a title block that stands by itself at most."""


@dataclass(frozen=True, eq=False)
class DrawingArea:
    """Where the views of a sheet lie.

    Attributes:
        polygon: mm.
        is_framed: whether lines go around it.
        is_certain: whether anything but its size says that these are a frame.
    """

    polygon: Polygon
    is_framed: bool
    is_certain: bool


def is_ruled(stroke: PaperStroke) -> bool:
    """Whether a stroke is a solid line along the paper's edges."""
    return stroke.is_line and not stroke.dashes and bool(np.abs(stroke.way).min() < _LEVEL)


def drawing_area(sheet: PaperSheet, labelled: LabelledStrokes, words: Sequence[Box]) -> DrawingArea:
    """The area in which the views of a sheet lie; all of it where no lines go around one.

    Args:
        sheet: its size.
        labelled: its strokes, those of letters told.
        words: boxes of what is written, mm.
    """
    page = shapely.box(0.0, 0.0, *sheet.size)
    ruled = [
        stroke
        for stroke in labelled.of(Label.OPEN)
        if stroke.length > _SHORTEST and is_ruled(stroke)
    ]
    longer = [
        LineString([line.points[0] - _OVERRUN * line.way, line.points[1] + _OVERRUN * line.way])
        for line in ruled
    ]
    faces = shapely.polygonize([shapely.union_all(longer)]).geoms if longer else ()
    largest = max(faces, key=lambda face: face.area, default=None)
    if largest is None or Polygon(largest.exterior).area <= _LARGE * page.area:
        return DrawingArea(page, is_framed=False, is_certain=True)
    area = Polygon(largest.exterior)
    is_certain = (
        (sheet.has_paper and _has_margins(area, sheet.size))
        or _has_border(area, faces)
        or _has_cells(area, faces, words)
    )
    return DrawingArea(area, is_framed=True, is_certain=is_certain)


def frame_apart(labelled: LabelledStrokes, area: DrawingArea) -> LabelledStrokes:
    """The strokes, those of the frame and beyond it told."""
    inner = area.polygon.buffer(-_EDGE)
    shapely.prepare(inner)
    numbers = labelled.numbers(Label.OPEN)
    lines = lines_of([labelled.strokes[number] for number in numbers])
    inside = shapely.contains_properly(inner, lines)
    outside = []
    for number, line, is_inside in zip(numbers, lines, inside, strict=True):
        if not is_inside and inner.intersection(line).length < 0.5 * line.length:
            outside.append(number)
    return labelled.with_label(outside, Label.FRAME, "on the edge of the drawing area, or beyond")


def whole_sheet(sheet: PaperSheet) -> DrawingArea:
    """All of a sheet."""
    return DrawingArea(shapely.box(0.0, 0.0, *sheet.size), is_framed=False, is_certain=True)


def _has_margins(area: Polygon, size: tuple[float, float]) -> bool:
    x0, y0, x1, y1 = area.bounds
    return max(x0, y0, size[0] - x1, size[1] - y1) <= _MARGIN


def _has_border(area: Polygon, faces: Sequence[Polygon]) -> bool:
    """Whether a second line goes around with the margins of a sheet: twice as much on the left."""
    low, high = np.array(area.bounds[:2]), np.array(area.bounds[2:])
    for face in faces:
        x0, y0, x1, y1 = face.bounds
        gaps = np.concatenate([low - (x0, y0), (x1, y1) - high]) / (_FILING, 1.0, 1.0, 1.0)
        if (gaps > _EDGE).all() and (np.abs(gaps - gaps[1:].mean()) <= _OFF * gaps.mean()).all():
            return True
    return False


def _has_cells(area: Polygon, faces: Sequence[Polygon], words: Sequence[Box]) -> bool:
    """Whether cells with text hang together with the area's edge, as a title block does."""
    corners = np.array(words).reshape(-1, 4)
    middles = shapely.points((corners[:, :2] + corners[:, 2:]) / 2.0)
    inner = area.buffer(-_EDGE)
    shapely.prepare(inner)
    neighbours = [face for face in faces if not inner.intersects(face)]
    edge = area.exterior.buffer(_BESIDE)
    joined = shapely.union_all([edge, *(face.buffer(_OVERRUN) for face in neighbours)])
    pieces = [piece for piece in shapely.get_parts(joined) if piece.intersects(area.exterior)]
    return (
        sum(
            any(piece.contains(face) for piece in pieces)
            and bool(shapely.contains(face, middles).any())
            for face in neighbours
        )
        >= _CELLS
    )
