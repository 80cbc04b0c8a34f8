"""The area of a sheet in which its views lie: inside the frame, beside the title block.

Whatever is ruled around it, the largest face of the lines along the paper's edges is that area.
"""

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import LineString, Polygon

from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke

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


def is_ruled(stroke: PaperStroke) -> bool:
    """Whether a stroke is a solid line along the paper's edges."""
    return stroke.is_line and not stroke.dashes and bool(np.abs(stroke.way).min() < _LEVEL)


def frame_apart(
    sheet: PaperSheet, labelled: LabelledStrokes
) -> tuple[LabelledStrokes, Polygon]:
    """The strokes, those of the frame and beyond it told, and the drawing area in mm."""
    ruled = [
        labelled.strokes[number]
        for number in labelled.numbers(Label.OPEN)
        if is_ruled(labelled.strokes[number]) and labelled.strokes[number].length > _SHORTEST
    ]
    area = drawing_area(sheet.size, ruled)
    inner = area.buffer(-_EDGE)
    shapely.prepare(inner)
    numbers = labelled.numbers(Label.OPEN)
    lines = np.array([labelled.strokes[number].line for number in numbers])
    inside = shapely.contains_properly(inner, lines) if len(lines) else np.zeros(0, dtype=bool)
    outside = []
    for number, line, is_inside in zip(numbers, lines, inside, strict=True):
        if not is_inside and inner.intersection(line).length < 0.5 * line.length:
            outside.append(number)
    return labelled.told(outside, Label.FRAME, "on the edge of the drawing area, or beyond"), area


def drawing_area(size: tuple[float, float], ruled: Sequence[PaperStroke]) -> Polygon:
    """The largest face of ruled lines, without holes; the whole sheet where it is small.

    Args:
        size: of the sheet, mm.
        ruled: lines along its edges.
    """
    page = shapely.box(0.0, 0.0, *size)
    if not ruled:
        return page
    longer = [
        LineString([line.points[0] - _OVERRUN * line.way, line.points[1] + _OVERRUN * line.way])
        for line in ruled
    ]
    faces = shapely.polygonize([shapely.union_all(longer)]).geoms
    largest = max(faces, key=lambda face: face.area, default=None)
    if largest is None:
        return page
    filled = Polygon(largest.exterior)
    return filled if filled.area > _LARGE * page.area else page
