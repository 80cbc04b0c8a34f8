"""A broken view: a piece of the middle left out between two wavy lines (ISO 128-3)."""

from dataclasses import replace

import numpy as np
import shapely

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.drawn_view import CURVE_STEP, DrawnView
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Linetype, Segment

_GAP = 0.07
"""Width of the gap as a share of the view's."""

_SWING = 0.02
"""Swing of the waves to either side in the same."""


def break_view(view: DrawnView, style: SheetStyle) -> tuple[DrawnView, Annotation]:
    """Leave out a strip in the middle of a view, its longer way.

    Args:
        view: not turned.
        style: width of the break lines.

    Returns:
        The view without what is in the strip, and the break lines as far as the part reaches.
    """
    x0, y0, x1, y1 = view.box
    along = 0 if x1 - x0 >= y1 - y0 else 1
    low, high = (x0, x1) if along == 0 else (y0, y1)
    start, end = (y0, y1) if along == 0 else (x0, x1)
    length, middle = high - low, 0.5 * (low + high)
    shares = np.linspace(0.0, 1.0, 121)
    wave = _SWING * length * np.sin(2.0 * np.pi * shares)
    across = start + (end - start) * shares
    sides = [middle + sign * 0.5 * _GAP * length + wave for sign in (-1.0, 1.0)]
    chains = [_points(side, across, along) for side in sides]
    strip = shapely.Polygon(np.concatenate([chains[0], chains[1][::-1]]))
    # A hair wider at both ends, so that edges there are cut through.
    strokes = _without(view.strokes, strip.buffer(1e-3))
    lines = tuple(
        Polyline(tuple((float(x), float(y)) for x, y in chain), Linetype.VISIBLE)
        for chain in chains
    )
    note = Annotation(AnnotationKind.BREAK, 0, lines, style.annotation_width)
    return replace(view, strokes=strokes), note


def _points(along: np.ndarray, across: np.ndarray, axis: int) -> np.ndarray:
    return np.stack([along, across] if axis == 0 else [across, along], axis=1)


def _without(strokes: tuple[DrawnStroke, ...], strip: shapely.Polygon) -> tuple[DrawnStroke, ...]:
    """Strokes outside of a strip; those that it cuts become chains."""
    left: list[DrawnStroke] = []
    for stroke in strokes:
        points = (
            np.array([stroke.start, stroke.end])
            if isinstance(stroke, Segment)
            else stroke.sample(CURVE_STEP)
        )
        line = shapely.LineString(points)
        if not line.intersects(strip):
            left.append(stroke)
            continue
        for piece in shapely.get_parts(shapely.difference(line, strip)):
            if piece.length > 1e-6:
                left.append(Polyline(tuple(piece.coords), stroke.linetype))
    return tuple(left)
