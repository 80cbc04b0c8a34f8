"""Strokes of views from a file's curves, for those views whose ink they explain."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.axes import Role
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.files.plotted import grid_step
from gaussiancad_core.sheet.files.vectors import (
    CircularArc,
    Curve,
    Line,
    VectorDrawing,
    VectorStroke,
    bounds,
)
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.precision import StrokesSource
from gaussiancad_core.sheet.vector_views.part_curves import InkMasks, Mask, part_curves
from gaussiancad_core.sheet.vector_views.view_strokes import strokes_of, tracks_and_dashes
from gaussiancad_core.views import Linetype, Stroke

_MARGIN = 4.0
"""px by which a view's curves may reach over its box, beyond half a stroke."""

_MOST_CURVES = 6000
"""Curves of a view from which it is no drawing of edges."""

_EXPLAINED = 0.98
"""Share of a view's ink that lies on its strokes."""

_SHOWN, _DASHES_SHOWN = 0.97, 0.3
"""Share of the strokes, visible and hidden, that ink shows."""


_PLOTTER_STEP, _EXACTLY = 0.3, 0.005
"""px between the ends of plotted strokes that meet, and of exact ones."""

_OFTEN, _FEWEST_PLOTTED = 0.3, 8
"""Share of meetings that are missed in plots, and strokes from which that is a rule."""

_MOST_CHORDS = 4000
"""Pieces in which a curve is drawn."""

_COARSE_STEP = 0.4
"""px of the grid from which what was rounded to it is known no better than from a picture."""

_FEWEST_ARCS, _MEETING, _MISSED = 2, 1.0, 0.04
"""Arcs from which they tell whether a file is rounded; px within which they meet lines, and beyond
which most of them miss these, if it is: on a grid the least miss tells, else the last decimal of
a file is none that counts."""

_GRID = 0.1
"""px of a grid from which rounding to it is more than the last decimal of a file."""


@dataclass(frozen=True, eq=False)
class VectorSheet:
    """The exact lines of a sheet, and the sheet before annotations were taken off.

    Attributes:
        drawing: in px of the sheet as stored.
        whole: the upright sheet.
        grid: px of the grid to which the file's places are rounded; 0 where they tell of none.
    """

    drawing: VectorDrawing
    whole: CleanSheet
    grid: float = 0.0

    @classmethod
    def of(cls, drawing: VectorDrawing, whole: CleanSheet) -> "VectorSheet":
        """All lines of a file."""
        return cls(drawing, whole, drawing_grid(drawing))


def drawing_grid(drawing: VectorDrawing) -> float:
    """px of the grid to which the places of a file are rounded; 0 where they tell of none."""
    lines = [own.curve for own in drawing.strokes if isinstance(own.curve, Line)]
    return grid_step(np.array([(own.start, own.end) for own in lines]).reshape(-1, 2))


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
) -> dict[Role, tuple[tuple[Stroke, ...], StrokesSource]]:
    """The strokes of the views that the file's curves explain, in px of the upright sheet, and
    whether they were plotted.

    Args:
        vectors: of the file.
        part: the upright sheet without annotations.
        layout: its views.
    """
    masks = InkMasks.of(vectors.whole, part)
    curves, others = part_curves(vectors.drawing.strokes, vectors.whole.turn, masks)
    margin = _MARGIN + part.stroke_width / 2.0
    of_view = {
        role: [stroke for stroke in curves if _lies_in(stroke.curve, box, margin)]
        for role, box in layout.boxes.items()
    }
    usable = [role for role, own in of_view.items() if 0 < len(own) <= _MOST_CURVES]
    grid = vectors.grid or drawing_grid(VectorDrawing(tuple(curves), ()))
    source = _source(curves, grid)
    tracks, dashes = tracks_and_dashes([of_view[role] for role in usable], part.stroke_width)
    found = {}
    for role, own in zip(usable, tracks, strict=True):
        strokes = strokes_of(own, of_view[role], dashes)
        known = _Known(of_view[role], others, masks)
        if _explains(strokes, known, layout.boxes[role], part):
            found[role] = strokes, source
    return found


def _source(strokes: Sequence[VectorStroke], grid: float) -> StrokesSource:
    """How exactly the strokes of a file are known.

    Round measures lie on a grid, too.  What was rounded to it is told by arcs that miss the lines
    that they go over into.
    """
    if not _misses(strokes, _EXACTLY if grid >= _GRID else _MISSED):
        return StrokesSource.PLOT if _are_plotted(strokes) else StrokesSource.VECTOR
    return StrokesSource.COARSE if grid >= _COARSE_STEP else StrokesSource.PLOT


def _misses(strokes: Sequence[VectorStroke], beyond: float) -> bool:
    """Whether arcs mostly end farther than so many px from the ends of the lines that they meet."""
    arcs = [own.curve for own in strokes if isinstance(own.curve, CircularArc)]
    ends = [arc.sample(np.inf)[[0, -1]] for arc in arcs if not arc.is_full]
    lines = [own.curve for own in strokes if isinstance(own.curve, Line)]
    if len(ends) < _FEWEST_ARCS or not lines:
        return False
    corners = np.array([(line.start, line.end) for line in lines]).reshape(-1, 2)
    away = cKDTree(corners).query(np.concatenate(ends))[0]
    meeting = away[away < _MEETING]
    return len(meeting) >= _FEWEST_ARCS and float(np.median(meeting)) > beyond


def _are_plotted(strokes: Sequence[VectorStroke]) -> bool:
    """Whether strokes that meet often miss each other by a plotter's step."""
    open_curves = [s.curve for s in strokes if isinstance(s.curve, Line | CircularArc)]
    if len(open_curves) < _FEWEST_PLOTTED:
        return False
    ends = np.concatenate([curve.sample(np.inf)[[0, -1]] for curve in open_curves])
    # The nearest but one: the nearest is the end itself, or the other end of a circle.
    distances = cKDTree(ends).query(ends, k=min(4, len(ends)))[0][:, 1:]
    meeting = distances[(distances < _PLOTTER_STEP).any(axis=1)]
    missed = (meeting > _EXACTLY) & (meeting < _PLOTTER_STEP)
    exactly = (meeting <= _EXACTLY).any(axis=1)
    return bool((missed.any(axis=1) & ~exactly).mean() > _OFTEN) if len(meeting) else False


def _lies_in(curve: Curve, box: Box, margin: float) -> bool:
    own = bounds([curve])
    if own is None:
        return False
    within = np.array([own[0] - box[0], own[1] - box[1], box[2] - own[2], box[3] - own[3]])
    return bool((within >= -margin).all())


def _explains(strokes: tuple[Stroke, ...], known: _Known, box: Box, part: CleanSheet) -> bool:
    """Whether strokes and ink of a view agree, both ways.

    What the file draws and is not the part's need not be explained.
    """
    solid = [stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE]
    if not solid:
        return False
    widths = [stroke.width for stroke in known.curves if stroke.width is not None]
    width = int(np.ceil(max([part.stroke_width, *widths]))) + 3
    x0, y0 = (max(0, int(value - _MARGIN)) for value in box[:2])
    x1, y1 = (int(np.ceil(value + _MARGIN)) for value in box[2:])
    ink = part.ink[y0:y1, x0:x1]
    drawn = np.zeros(ink.shape, np.uint8)
    for curve in known.others:
        if (own := bounds([curve])) and own[0] < x1 and own[2] > x0 and own[1] < y1 and own[3] > y0:
            _draw(drawn, curve, (x0, y0), width)
    ink = ink & (drawn == 0)
    drawn[:] = 0
    for stroke in strokes:
        _draw(drawn, stroke, (x0, y0), width)
    if ink.any() and float((drawn[ink] > 0).mean()) < _EXPLAINED:
        return False
    shown = {
        kind: _shown([s for s in strokes if s.linetype is kind], known.masks) for kind in Linetype
    }
    return shown[Linetype.VISIBLE] >= _SHOWN and shown[Linetype.HIDDEN] >= _DASHES_SHOWN


def _draw(mask: Mask, curve: Curve | Stroke, corner: tuple[int, int], width: int) -> None:
    step = max(2.0, curve.length / _MOST_CHORDS)
    path = np.rint((curve.sample(step) - np.array(corner) - 0.5) * 16).astype(np.int32)
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
