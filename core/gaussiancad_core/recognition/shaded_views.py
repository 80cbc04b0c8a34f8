"""Views that a file has as shaded pictures: their lines, traced where they were drawn.

The outline of the shading tells where such a view is, and stands for it where no lines were drawn,
or these do not close.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import cv2
import numpy as np
import shapely

from gaussiancad_core.geometry.near_points import Points, pairs_between
from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.recognition.stroke_reading import StrokeReading
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView, read_views
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet.votes import HALF
from gaussiancad_core.structure.shaded_pictures import OVER
from gaussiancad_core.views.role_search import Arrangement
from gaussiancad_core.views.stroke_levels import is_painted

_AROUND = 3.0
"""px around a view's box in which its ink is traced."""

_ENCLOSED = 0.95
"""Share of the shading that traced lines enclose at least, where they tell a view."""

_FEWEST_GAPS = 3
"""Gaps of a dashed line at least."""

_BESIDE, _STEP = 3.0, 1.0
"""px from an outline from which a line is none of it, and between the points that tell that."""


@dataclass(frozen=True, eq=False)
class ShadedViews:
    """Views that are shaded pictures, by their numbers among the drawings of a sheet.

    Attributes:
        traced: the lines that were drawn on each; what is its role does not count.
        areas: px^2 of the shading of each.
    """

    traced: Mapping[int, ReadView]
    areas: Mapping[int, float]


def shaded_views(
    reading: StrokeReading, best: Arrangement, sheet: OpenedSheet, scale: float
) -> ShadedViews | None:
    """The views of a file that are shaded pictures; None where there are none.

    Args:
        reading: of the file.
        best: its views in their roles.
        sheet: that, upright as stored.
        scale: px per mm.
    """
    numbers = {
        placed.role: number
        for number, placed in best.placed.items()
        if is_painted(reading.views[number])
    }
    if not numbers:
        return None
    # Few sheets have such views: the others do not wait for what reads pixels.
    from gaussiancad_core.sheet.image.valley_lines import valley_sheet

    painted = {role: reading.views[number] for role, number in numbers.items()}
    rings = [
        [np.array(part.exterior.coords) * scale for part in shapely.get_parts(view.outline)]
        for view in painted.values()
    ]
    over = [stroke.points * scale for stroke in reading.labelled.of(*OVER)]
    ink = valley_sheet(sheet.image.grey, rings, over, sheet.turn)
    if not ink.ink.any():
        return None
    boxes = {role: _around(view.box, scale) for role, view in painted.items()}
    found = read_views(ink, Layout(boxes, best.projection, "default", (), ()))
    wide = cv2.dilate(ink.ink.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    traced = {numbers[view.role]: _told(view, wide) for view in found}
    areas = {number: reading.views[number].outline.area * scale**2 for number in traced}
    return ShadedViews(traced, areas)


def with_traced_lines(
    drawn: tuple[ReadView, ...], best: Arrangement, shaded: ShadedViews
) -> tuple[ReadView, ...]:
    """The views, shaded ones by their traced lines where these close.

    Args:
        drawn: the views of a file, shaded ones by their outlines.
        best: they in their roles.
        shaded: those that are.
    """
    traced = {placed.role: number for number, placed in best.placed.items()}
    traced = {role: number for role, number in traced.items() if number in shaded.traced}
    return tuple(
        _with_lines(view, shaded.traced[number], shaded.areas[number])
        if (number := traced.get(view.role)) is not None
        else view
        for view in drawn
    )


def _told(view: ReadView, ink: Mask) -> ReadView:
    """A traced view, lines hidden that are drawn in dashes: such views mostly show none."""
    strokes = tuple(
        replace(stroke, linetype=Linetype.HIDDEN if _is_dashed(stroke, ink) else Linetype.VISIBLE)
        for stroke in view.strokes
    )
    return replace(view, strokes=strokes)


def _is_dashed(stroke: Stroke, ink: Mask) -> bool:
    """Whether ink, a px wider than it is, leaves gaps along a stroke."""
    columns, rows = np.floor(stroke.sample(_STEP)).astype(int).T
    height, width = ink.shape
    is_inked = ink[rows.clip(0, height - 1), columns.clip(0, width - 1)]
    return int(np.count_nonzero(is_inked[:-1] & ~is_inked[1:])) >= _FEWEST_GAPS


def _with_lines(view: ReadView, traced: ReadView, area: float) -> ReadView:
    """A shaded view by its traced lines where these enclose it; else its outline with those within.

    Args:
        view: its outline.
        traced: its lines.
        area: px^2 of its shading.
    """
    if traced.outline is not None and _area(traced) > _ENCLOSED * area:
        return replace(traced, role=view.role)
    outline = np.concatenate([stroke.sample(_STEP) for stroke in view.strokes])
    within = [stroke for stroke in traced.strokes if not _runs_along(stroke, outline)]
    return replace(view, strokes=(*view.strokes, *within))


def _runs_along(stroke: Stroke, outline: Points) -> bool:
    """Whether most of a stroke lies beside (n, 2) points of an outline."""
    points = stroke.sample(_STEP)
    near = np.unique(pairs_between(points, outline, _BESIDE)[:, 0])
    return len(near) > HALF * len(points)


def _area(view: ReadView) -> float:
    """px^2 that a view's outline encloses, holes too."""
    outline = view.closed
    return float((outline.depth > 0.0).sum()) / outline.supersampling**2


def _around(box: Box, scale: float) -> Box:
    x0, y0, x1, y1 = (value * scale for value in box)
    return x0 - _AROUND, y0 - _AROUND, x1 + _AROUND, y1 + _AROUND
