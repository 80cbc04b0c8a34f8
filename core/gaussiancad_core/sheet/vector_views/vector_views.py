"""Strokes of views from a file's curves, for those views whose ink they explain."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.vector_views.missed_ends import missed_px
from gaussiancad_core.sheet.vector_views.part_curves import InkMasks, Mask, part_curves
from gaussiancad_core.sheet.vector_views.view_strokes import strokes_of, tracks_and_dashes
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet.votes import NEARLY_ALL
from gaussiancad_core.sheet.work_limits import PLACES

_MARGIN = 4.0
"""px by which a view's curves may reach over its box, beyond half a stroke."""

_MOST_CURVES = 6000
"""Curves of a view from which it is no drawing of edges."""

_DASHES_SHOWN = 0.3
"""Share of the hidden strokes that ink shows."""


@dataclass(frozen=True, eq=False)
class VectorSheet:
    """The exact lines of a sheet.

    Attributes:
        drawing: in px of the sheet as stored.
        whole: the upright sheet with all of its ink, by which lines of the part are told from
            others; None where the drawing has no others.
    """

    drawing: VectorDrawing
    whole: CleanSheet | None = None


@dataclass(frozen=True, eq=False)
class _Known:
    """What the file says about a view.

    Attributes:
        curves: of the part.
        others: of annotations, anywhere on the sheet.
        masks: of the ink.
    """

    curves: list[VectorStroke]
    others: tuple[Curve, ...]
    masks: InkMasks


def vector_views(
    vectors: VectorSheet, part: CleanSheet, layout: Layout
) -> dict[Role, tuple[tuple[Stroke, ...], float]]:
    """The strokes of the views that the file's curves explain, in px of the upright sheet, and px
    of the grid to which these were rounded.

    Args:
        vectors: of the file.
        part: the upright sheet without annotations.
        layout: its views.
    """
    if vectors.whole is None:
        return _of_strokes(vectors.drawing.strokes, part.stroke_width, layout)[1]
    masks = InkMasks.of(vectors.whole, part)
    curves, others = part_curves(vectors.drawing.strokes, vectors.whole.turn, masks)
    of_view, found = _of_strokes(curves, part.stroke_width, layout)
    return {
        role: read
        for role, read in found.items()
        if _explains(read[0], _Known(of_view[role], others, masks), layout.boxes[role], part)
    }


def _of_strokes(
    curves: Sequence[VectorStroke], stroke_width: float, layout: Layout
) -> tuple[dict[Role, list[VectorStroke]], dict[Role, tuple[tuple[Stroke, ...], float]]]:
    """The curves of each view of a layout, and the strokes that they are, with px of their grid;
    no strokes where there are too many for a drawing."""
    margin = _MARGIN + stroke_width / 2.0
    of_view = {
        role: [stroke for stroke in curves if _lies_in(stroke.curve, box, margin)]
        for role, box in layout.boxes.items()
    }
    usable = [
        role for role, vector_strokes in of_view.items() if 0 < len(vector_strokes) <= _MOST_CURVES
    ]
    missed = missed_px([curve.curve for curve in curves])
    tracks, dashes = tracks_and_dashes([of_view[role] for role in usable], stroke_width)
    found = {}
    for role, this_tracks in zip(usable, tracks, strict=True):
        strokes = strokes_of(this_tracks, of_view[role], dashes)
        if any(stroke.linetype is Linetype.VISIBLE for stroke in strokes):
            found[role] = strokes, max(missed, *(stroke.step for stroke in of_view[role]))
    return of_view, found


def _lies_in(curve: Curve, box: Box, margin: float) -> bool:
    x0, y0, x1, y1 = curve.box
    return min(x0 - box[0], y0 - box[1], box[2] - x1, box[3] - y1) >= -margin


def _explains(strokes: tuple[Stroke, ...], known: _Known, box: Box, part: CleanSheet) -> bool:
    """Whether strokes and ink of a view agree, both ways.

    What the file draws and is not the part's need not be explained.
    """
    widths = [stroke.width for stroke in known.curves if stroke.width is not None]
    width = int(np.ceil(max([part.stroke_width, *widths]))) + 3
    x0, y0 = (max(0, int(value - _MARGIN)) for value in box[:2])
    x1, y1 = (int(np.ceil(value + _MARGIN)) for value in box[2:])
    ink = part.ink[y0:y1, x0:x1]
    drawn = np.zeros(ink.shape, np.uint8)
    for curve in known.others:
        left, top, right, bottom = curve.box
        if left < x1 and right > x0 and top < y1 and bottom > y0:
            _draw(drawn, curve, (x0, y0), width)
    ink = ink & (drawn == 0)
    drawn[:] = 0
    for stroke in strokes:
        _draw(drawn, stroke, (x0, y0), width)
    if ink.any() and float((drawn[ink] > 0).mean()) < NEARLY_ALL:
        return False
    shown = {
        kind: _shown([s for s in strokes if s.linetype is kind], known.masks) for kind in Linetype
    }
    return shown[Linetype.VISIBLE] >= NEARLY_ALL and shown[Linetype.HIDDEN] >= _DASHES_SHOWN


def _draw(mask: Mask, curve: Curve | Stroke, corner: tuple[int, int], width: int) -> None:
    step = max(2.0, curve.length / PLACES)
    path = np.rint((curve.vertices(step) - np.array(corner) - 0.5) * 16).astype(np.int32)
    cv2.polylines(mask, [path], False, 1, width, shift=4)


def _shown(strokes: list[Stroke], masks: InkMasks) -> float:
    """Share of some strokes that lies on the sheet's ink; 1 where there are none."""
    if not strokes:
        return 1.0
    points = np.concatenate([stroke.sample(1.0) for stroke in strokes])
    height, width = masks.whole.shape
    columns = np.clip(np.floor(points[:, 0]).astype(int), 0, width - 1)
    rows = np.clip(np.floor(points[:, 1]).astype(int), 0, height - 1)
    return float(masks.whole[rows, columns].mean())
