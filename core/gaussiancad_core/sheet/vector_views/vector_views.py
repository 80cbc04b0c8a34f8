"""Strokes of views from a file's curves, for those views whose ink they explain."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.vector_views.missed_ends import missed_px
from gaussiancad_core.sheet.vector_views.view_strokes import strokes_of, tracks_and_gap
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet.votes import NEARLY_ALL
from gaussiancad_core.sheet.work_limits import PLACES

_MARGIN = 4.0
"""px by which a view's curves may reach over its box, beyond half a stroke."""

_MOST_CURVES = 6000
"""Curves of a view from which it is no drawing of edges."""

Mask = npt.NDArray[np.uint8]

_DASHES_SHOWN = 0.3
"""Share of the hidden strokes that ink shows."""


@dataclass(frozen=True, eq=False)
class VectorSheet:
    """The exact lines of a part.

    Attributes:
        drawing: px of the upright sheet.
        whole: that with all of its ink, which has to agree with them; None where the lines alone
            tell the views.
    """

    drawing: VectorDrawing
    whole: CleanSheet | None = None


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
    found = _of_strokes(vectors.drawing.strokes, part.stroke_width, layout)
    if vectors.whole is None:
        return found
    wide = cv2.dilate(vectors.whole.ink.astype(np.uint8), np.ones((3, 3), np.uint8))
    ink = np.asarray(wide, dtype=np.uint8)
    width = max([part.stroke_width, *(s.width for s in vectors.drawing.strokes if s.width)])
    return {
        role: read
        for role, read in found.items()
        if _explains(read[0], layout.boxes[role], part, width) and _is_shown(read[0], ink)
    }


def _of_strokes(
    curves: Sequence[VectorStroke], stroke_width: float, layout: Layout
) -> dict[Role, tuple[tuple[Stroke, ...], float]]:
    """The strokes of each view of a layout, with px of their grid; none where there are too many
    for a drawing."""
    margin = _MARGIN + stroke_width / 2.0
    of_view = {
        role: [stroke for stroke in curves if _lies_in(stroke.curve, box, margin)]
        for role, box in layout.boxes.items()
    }
    usable = [
        role for role, vector_strokes in of_view.items() if 0 < len(vector_strokes) <= _MOST_CURVES
    ]
    missed = missed_px([curve.curve for curve in curves])
    tracks, gap = tracks_and_gap([of_view[role] for role in usable])
    found = {}
    for role, this_tracks in zip(usable, tracks, strict=True):
        strokes = strokes_of(this_tracks, of_view[role], gap)
        if any(stroke.linetype is Linetype.VISIBLE for stroke in strokes):
            found[role] = strokes, max(missed, *(stroke.step for stroke in of_view[role]))
    return found


def _lies_in(curve: Curve, box: Box, margin: float) -> bool:
    x0, y0, x1, y1 = curve.box
    return min(x0 - box[0], y0 - box[1], box[2] - x1, box[3] - y1) >= -margin


def _explains(strokes: tuple[Stroke, ...], box: Box, part: CleanSheet, width: float) -> bool:
    """Whether the strokes of a view explain its ink."""
    x0, y0 = (max(0, int(value - _MARGIN)) for value in box[:2])
    x1, y1 = (int(np.ceil(value + _MARGIN)) for value in box[2:])
    ink = part.ink[y0:y1, x0:x1]
    drawn = np.zeros(ink.shape, np.uint8)
    for stroke in strokes:
        _draw(drawn, stroke, (x0, y0), int(np.ceil(width)) + 3)
    return not ink.any() or float((drawn[ink] > 0).mean()) >= NEARLY_ALL


def _is_shown(strokes: tuple[Stroke, ...], ink: Mask) -> bool:
    """Whether ink shows the strokes of a view."""
    shown = {kind: _shown([s for s in strokes if s.linetype is kind], ink) for kind in Linetype}
    return shown[Linetype.VISIBLE] >= NEARLY_ALL and shown[Linetype.HIDDEN] >= _DASHES_SHOWN


def _draw(mask: Mask, curve: Stroke, corner: tuple[int, int], width: int) -> None:
    step = max(2.0, curve.length / PLACES)
    path = np.rint((curve.vertices(step) - np.array(corner) - 0.5) * 16).astype(np.int32)
    cv2.polylines(mask, [path], False, 1, width, shift=4)


def _shown(strokes: list[Stroke], ink: Mask) -> float:
    """Share of some strokes that lies on the sheet's ink; 1 where there are none."""
    if not strokes:
        return 1.0
    points = np.concatenate([stroke.sample(1.0) for stroke in strokes])
    height, width = ink.shape
    columns = np.clip(np.floor(points[:, 0]).astype(int), 0, width - 1)
    rows = np.clip(np.floor(points[:, 1]).astype(int), 0, height - 1)
    return float(ink[rows, columns].mean())
