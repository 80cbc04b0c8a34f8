"""The lines of a shaded picture: valleys that are darker than the faces on both sides of them.

A face may be darker than a line elsewhere, and its texture has valleys too: what counts is how much
darker a valley is than its sides, beside the darkest ones of the same view.
"""

from collections.abc import Iterable, Sequence

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.points import box_around
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.image.pale_strokes import mean_stroke_width

_WIDEST = 9
"""px that a line is wide at most."""

_LEAST = 8
"""Grey levels by which a valley is darker than its sides at least."""

_DARKEST = 95.0
"""Percentile of the depths of a view's valleys that its lines have."""

_INK = 0.4
"""Depth of a valley from which it is a line, in that of the lines."""

_AROUND = 4
"""px around a view in which its lines lie."""

_LINE_PX = 3
"""px that a line is wide."""

Points = npt.NDArray[np.float64]


def valley_sheet(
    grey: npt.NDArray[np.uint8],
    outlines: Iterable[Sequence[Points]],
    over: Sequence[Points],
    turn: Turn,
) -> CleanSheet:
    """The ink of the lines of shaded views, as if nothing else were drawn on the sheet.

    Args:
        grey: (h, w) of the sheet.
        outlines: of each view (n, 2) px each, the rings around its shading.
        over: (n, 2) px each, chains along what else is drawn; on an outline it changes nothing.
        turn: of the sheet.
    """
    weight = np.zeros(grey.shape, np.float32)
    for rings in outlines:
        box = box_around(np.concatenate(rings))
        x0, y0 = (max(0, int(value) - _AROUND) for value in box[:2])
        x1, y1 = (int(np.ceil(value)) + _AROUND for value in box[2:])
        window = grey[y0:y1, x0:x1]
        sides = cv2.morphologyEx(window, cv2.MORPH_CLOSE, np.ones((_WIDEST, _WIDEST), np.uint8))
        depth = sides.astype(np.float32) - window
        depth[depth < _LEAST] = 0.0
        gone, kept = (_drawn(window.shape, chains, (x0, y0)) for chains in (over, rings))
        depth[gone & ~kept] = 0.0
        if depth.any():
            full = float(np.percentile(depth[depth > 0.0], _DARKEST))
            weight[y0:y1, x0:x1] = np.minimum(depth / full, 1.0)
    ink = weight > _INK
    weight = np.where(cv2.dilate(ink.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0, weight, 0.0)
    width = mean_stroke_width(ink, weight) if ink.any() else 0.0
    return CleanSheet(ink, weight, width, turn)


def _drawn(
    shape: tuple[int, ...], chains: Iterable[Points], corner: tuple[int, int]
) -> npt.NDArray[np.bool_]:
    """(h, w) whether chains run there, a line wide."""
    mask = np.zeros(shape, np.uint8)
    for chain in chains:
        places = np.rint(chain - np.array(corner) - 0.5).astype(np.int32)
        cv2.polylines(mask, [places], False, 1, _LINE_PX)
    return mask > 0
