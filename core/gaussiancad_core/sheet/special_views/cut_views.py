"""Which views are cut open, told by where they are hatched (ISO 128-3)."""

from collections.abc import Sequence

import cv2
import numpy as np
import shapely
from shapely import Polygon

from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind
from gaussiancad_core.sheet.votes import LARGELY

_LEAST = 0.015
"""Share of a view that is hatched at least, for it to be a section."""

_HALF = 0.6
"""Share of its half, and of the other direction, that the hatching of a half section spans."""

_OVER = 0.06
"""Share of the view by which the hatching of a half section reaches over the middle at most."""


def section_kind(hatched: Mask, box: Box) -> SpecialKind | None:
    """What kind of section a view is, or nothing where it is none.

    Args:
        hatched: (h, w) bool, cut material.
        box: of the view in px.
    """
    x0, y0, x1, y1 = (round(value) for value in box)
    window = hatched[y0:y1, x0:x1]
    if not window.size or window.mean() < _LEAST:
        return None
    spans = [_span(np.any(window, axis=axis)) for axis in (0, 1)]
    if all(high - low > LARGELY for low, high in spans):
        return SpecialKind.SECTION
    for pair, other in (spans, spans[::-1]):
        if other[1] - other[0] > _HALF and _is_half(pair):
            return SpecialKind.HALF_SECTION
    return SpecialKind.PARTIAL_SECTION


def hatched_box(hatched: Mask, box: Box) -> Box:
    """The box in px around what is hatched of a view."""
    x0, y0, x1, y1 = (round(value) for value in box)
    rows, columns = np.nonzero(hatched[y0:y1, x0:x1])
    return (
        float(x0 + columns.min()),
        float(y0 + rows.min()),
        float(x0 + columns.max() + 1),
        float(y0 + rows.max() + 1),
    )


def _span(flags: np.ndarray) -> tuple[float, float]:
    """First and last place that is marked, as shares of the whole."""
    places = np.flatnonzero(flags)
    return float(places[0] / len(flags)), float((places[-1] + 1) / len(flags))


def _is_half(span: tuple[float, float]) -> bool:
    low, high = span
    beyond = high < 0.5 + _OVER or low > 0.5 - _OVER
    return beyond and high - low > 0.5 * _HALF


def cut_mask(faces: Sequence[Polygon], sheet: CleanSheet, scale: float) -> Mask | None:
    """(h, w) what cut faces hold between the lines around them; None where there are none.

    Args:
        faces: mm.
        sheet: in px.
        scale: px per mm.
    """
    inner = shapely.union_all(faces).buffer(-0.5 * sheet.stroke_width / scale)
    if inner.is_empty:
        return None
    mask = np.zeros(sheet.ink.shape, np.uint8)
    for part in shapely.get_parts(inner):
        rings = [np.array(ring.coords) * scale for ring in (part.exterior, *part.interiors)]
        places = [np.rint((ring - 0.5) * 16.0).astype(np.int32) for ring in rings]
        cv2.fillPoly(mask, places, 1, shift=4)
    return mask > 0
