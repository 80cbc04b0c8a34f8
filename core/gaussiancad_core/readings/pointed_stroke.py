"""The stroke that a person points at: of the file where it has lines, else found in the ink.

Nothing is told from annotations here: what a person points at is wanted.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from gaussiancad_core.model.views import Stroke
from gaussiancad_core.readings.reading_schema import Box, Point
from gaussiancad_core.readings.reading_shapes import shape_of
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.tracing.file_strokes import stroke_along

_REACH_PX = 8.0
"""px of the sheet as stored by which a stroke may be missed."""

_STEP_PX = 1.0

_MOST_BOXES = 8
"""Boxes whose strokes are kept."""


def tracer(sheet: OpenedSheet) -> Callable[[Point, Box], Mapping[str, Any] | None]:
    """Finds strokes on a sheet.

    Returns:
        A function of a place and of a box to look in, px of the sheet as stored: the nearest
        stroke as the attribute of a stroke's entry; None where none is near.  The strokes of a box
        are found once.
    """

    @lru_cache(maxsize=_MOST_BOXES)
    def strokes_in(box: Box) -> tuple[Stroke, ...]:
        return tuple(_of_file(sheet, box)) or _of_ink(sheet, box)

    def traced(at: Point, box: Box) -> Mapping[str, Any] | None:
        turn = sheet.turn
        ((x, y),) = turn.to_upright(np.array([at])).tolist()
        found = _nearest(strokes_in(box), (x, y), _REACH_PX / turn.scale)
        return None if found is None else shape_of(found, turn)

    return traced


def _nearest(strokes: Sequence[Stroke], at: Point, reach: float) -> Stroke | None:
    away = [np.hypot(*(stroke.sample(_STEP_PX) - at).T).min() for stroke in strokes]
    if not away or min(away) > reach:
        return None
    return strokes[int(np.argmin(away))]


def _of_ink(sheet: OpenedSheet, box: Box) -> tuple[Stroke, ...]:
    # What follows pixels is compiled: a file whose strokes are known waits for none of it.
    from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
    from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_pens, view_rhythm

    clean = sheet.clean
    height, width = clean.ink.shape
    x0, y0, x1, y1 = clean.turn.box_to_upright(box)
    inside = max(0.0, x0), max(0.0, y0), min(float(width), x1), min(float(height), y1)
    if inside[2] - inside[0] < 1.0 or inside[3] - inside[1] < 1.0:
        return ()
    shapes = find_shapes(clean, inside)
    rhythm = view_rhythm([shapes], clean.stroke_width)
    return classify_strokes(shapes, rhythm, view_pens([shapes], rhythm))


def _of_file(sheet: OpenedSheet, box: Box) -> list[Stroke]:
    """The lines of the file that meet a box; none of a sheet that lies turned."""
    vectors, turn = sheet.image.vectors, sheet.turn
    if vectors is None or turn.angle:
        return []
    x0, y0, x1, y1 = turn.box_to_upright(box)
    found = []
    for vector_stroke in vectors.strokes:
        points = vector_stroke.curve.vertices(_STEP_PX)
        inside = (points >= (x0, y0)) & (points <= (x1, y1))
        if inside.all(1).any() and (stroke := stroke_along(vector_stroke.curve)) is not None:
            found.append(stroke)
    return found
