"""A half view: a symmetric view drawn up to its centre line (ISO 128-3)."""

from dataclasses import replace

import numpy as np
import shapely

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Rhythm
from gaussiancad_core.drawing.drawn_view import CURVE_STEP, DrawnView
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Linetype, Segment

_BEYOND = 2.4
"""Length of the centre line beyond the view at either end, in heights of the text."""

_MARKS = (1.2, 1.7)
"""Distances of the two short lines of each symmetry mark from the view, in heights of the text."""

_MARK = 0.6
"""Half their length, in the same."""

_FAR = 1e5


def halve_view(view: DrawnView, style: SheetStyle) -> tuple[DrawnView, list[Annotation]]:
    """Leave out what of a view lies right of its middle.

    Args:
        view: not turned.
        style: width of the centre line, height of the text.

    Returns:
        The half, and its centre line with the marks of symmetry at both ends.
    """
    x0, y0, x1, y1 = view.box
    middle, height = 0.5 * (x0 + x1), style.text_height
    kept = shapely.box(-_FAR, -_FAR, middle, _FAR)
    strokes: list[DrawnStroke] = []
    for stroke in view.strokes:
        strokes += _within(stroke, kept, middle)
    centre = _line((middle, y0 - _BEYOND * height), (middle, y1 + _BEYOND * height))
    marks = tuple(
        _line((middle - _MARK * height, y), (middle + _MARK * height, y))
        for away in _MARKS
        for y in (y0 - away * height, y1 + away * height)
    )
    thin = style.annotation_width
    notes = [
        Annotation(AnnotationKind.CENTRE_LINE, 0, (centre,), thin, Rhythm.LONG_SHORT),
        Annotation(AnnotationKind.SYMMETRY, 0, marks, thin),
    ]
    return replace(view, strokes=tuple(strokes)), notes


def _within(stroke: DrawnStroke, kept: shapely.Polygon, middle: float) -> list[DrawnStroke]:
    """What of a stroke lies left of the middle; edges along it are left out, curves are chains."""
    if isinstance(stroke, Segment):
        if stroke.start[0] <= middle and stroke.end[0] <= middle:
            along = min(stroke.start[0], stroke.end[0]) > middle - 1e-6
            return [] if along else [stroke]
        points = np.array([stroke.start, stroke.end])
    else:
        points = stroke.sample(CURVE_STEP)
        if points[:, 0].max() <= middle:
            return [stroke]
    pieces = shapely.get_parts(shapely.intersection(shapely.LineString(points), kept))
    lines = [piece for piece in pieces if piece.geom_type == "LineString" and piece.length > 1e-6]
    if isinstance(stroke, Segment):
        return [replace(stroke, start=p.coords[0], end=p.coords[-1]) for p in lines]
    return [Polyline(tuple(piece.coords), stroke.linetype) for piece in lines]


def _line(start: tuple[float, float], end: tuple[float, float]) -> Segment:
    return Segment(start, end, Linetype.VISIBLE)
