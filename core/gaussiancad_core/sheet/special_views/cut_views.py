"""Half sections that stand for a view: edges inside of the cut are hidden ones of the whole part.

Parts are cut where they are alike on both sides, as a rule.  What such a section shows within its
outline is then what the view of the whole part would show in dashes.
"""

from dataclasses import replace

import numpy as np

from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.masks import Outline
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.special_views.kinds import SpecialKind
from gaussiancad_core.views import Linetype, Stroke

_DEEP_PX = 3.0
"""Distance from the outline at which a stroke is no part of it."""

_INSIDE = 0.8
"""Share of a stroke that lies within the outline, and within the cut, at least."""

_SURE = 0.5
"""Confidence that such an edge is hidden: nothing on the sheet says so."""


def cut_region(layout: Layout, box: Box) -> Box | None:
    """The half of a view that shows the inside, in px, or nothing where it is no half section."""
    own = next((view for view in layout.special if view.box == box and view.used), None)
    if own is None or own.cut is None or own.kind is not SpecialKind.HALF_SECTION:
        return None
    x0, y0, x1, y1 = box
    middle = (0.5 * (x0 + x1), 0.5 * (y0 + y1))
    # The direction in which the hatching keeps to one side.
    off_x = abs(0.5 * (own.cut[0] + own.cut[2]) - middle[0]) / (x1 - x0)
    off_y = abs(0.5 * (own.cut[1] + own.cut[3]) - middle[1]) / (y1 - y0)
    if off_x >= off_y:
        right = own.cut[2] - middle[0] > middle[0] - own.cut[0]
        return (middle[0] - _DEEP_PX, y0, x1, y1) if right else (x0, y0, middle[0] + _DEEP_PX, y1)
    below = own.cut[3] - middle[1] > middle[1] - own.cut[1]
    return (x0, middle[1] - _DEEP_PX, x1, y1) if below else (x0, y0, x1, middle[1] + _DEEP_PX)


def with_hidden_inside(
    strokes: tuple[Stroke, ...], outline: Outline, region: Box
) -> tuple[Stroke, ...]:
    """The strokes of a section, those within its outline hidden.

    Args:
        strokes: in px of the sheet.
        outline: of the view.
        region: px of the sheet, the part of the view that is cut.
    """
    return tuple(
        replace(stroke, linetype=Linetype.HIDDEN, confidence=_SURE)
        if stroke.linetype is Linetype.VISIBLE and _is_inside(stroke, outline, region)
        else stroke
        for stroke in strokes
    )


def _is_inside(stroke: Stroke, outline: Outline, region: Box) -> bool:
    points = stroke.sample(1.0)
    x0, y0, x1, y1 = region
    cut = (points >= (x0, y0)).all(axis=1) & (points <= (x1, y1)).all(axis=1)
    places = (points - np.array(outline.offset)) * outline.supersampling
    columns, rows = np.floor(places).astype(int).T
    columns = np.clip(columns, 0, outline.depth.shape[1] - 1)
    rows = np.clip(rows, 0, outline.depth.shape[0] - 1)
    deep = outline.depth[rows, columns] > _DEEP_PX * outline.supersampling
    return float((cut & deep).mean()) > _INSIDE
