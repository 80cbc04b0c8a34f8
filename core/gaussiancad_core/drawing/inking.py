"""Annotations to pixels."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import Annotation, Point, Rhythm
from gaussiancad_core.drawing.lettering import ink_label
from gaussiancad_core.drawing.sheet_style import Cap, SheetStyle
from gaussiancad_core.drawing.stroke_raster import Coverage, draw_stroke
from gaussiancad_core.lines.strokes import DrawnStroke

LONG, GAP, SHORT = 16.0, 3.0, 4.0
"""Rhythm of centre lines in multiples of their width (ISO 128-2 has 24, 3 and a dot; CAD systems
make the dot a short dash)."""


def ink_annotations(annotations: tuple[Annotation, ...], style: SheetStyle) -> Coverage:
    """(height, width) share of ink, 0 to 1, of annotations in sheet px."""
    ink = np.zeros((style.height, style.width), dtype=np.float32)
    for annotation in annotations:
        for stroke in annotation.strokes:
            for piece in _pieces(stroke, annotation):
                draw_stroke(ink, piece, annotation.width, Cap.BUTT)
        for arrow in annotation.arrows:
            _fill(ink, arrow)
        if annotation.label is not None:
            ink_label(ink, annotation.label)
    if not style.antialiasing:
        ink = (ink >= 0.5).astype(np.float32)
    return ink


def _pieces(stroke: DrawnStroke, annotation: Annotation) -> list[DrawnStroke]:
    if annotation.rhythm is Rhythm.CONTINUOUS:
        return [stroke]
    intervals = long_short_intervals(stroke.length, annotation.width)
    return [stroke.part(low, high) for low, high in intervals]


def long_short_intervals(length: float, width: float) -> list[tuple[float, float]]:
    """Where along a centre line there is ink: long and short in turn, both ends and the middle
    long.

    Args:
        length: of the line; both in one unit.
        width: of the line.
    """
    period = (LONG + 2.0 * GAP + SHORT) * width
    # An even number of periods, so that the crossing in a circle's middle is one of long dashes.
    count = 2 * max(1, round((length - LONG * width) / period / 2.0))
    stretch = length / (count * period + LONG * width)
    long, gap, short = (share * width * stretch for share in (LONG, GAP, SHORT))
    intervals = []
    for index in range(count + 1):
        start = index * period * stretch
        intervals.append((start, start + long))
        if index < count:
            intervals.append((start + long + gap, start + long + gap + short))
    return intervals


def _fill(ink: npt.NDArray[np.float32], corners: tuple[Point, ...]) -> None:
    """Fill a convex polygon; every border is a ramp one pixel wide."""
    points = np.array(corners)
    height, width = ink.shape
    x0, y0 = (max(0, int(np.floor(value)) - 1) for value in points.min(axis=0))
    x1 = min(width, int(np.ceil(points[:, 0].max())) + 1)
    y1 = min(height, int(np.ceil(points[:, 1].max())) + 1)
    if x0 >= x1 or y0 >= y1:
        return
    x = np.arange(x0, x1)[None, :] + 0.5
    y = np.arange(y0, y1)[:, None] + 0.5
    ways = np.roll(points, -1, axis=0) - points
    first, second = ways[0], ways[1]
    orientation = np.sign(first[0] * second[1] - first[1] * second[0])
    depth = np.full((y1 - y0, x1 - x0), np.inf)
    for (px, py), (dx, dy) in zip(points, ways, strict=True):
        inside = orientation * (dx * (y - py) - dy * (x - px)) / np.hypot(dx, dy)
        depth = np.minimum(depth, inside)
    area = ink[y0:y1, x0:x1]
    np.maximum(area, np.clip(depth + 0.5, 0.0, 1.0).astype(np.float32), out=area)
