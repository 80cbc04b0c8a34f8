"""Rows of dashes nearly as wide as they are long: those of two hidden lines beside each other.

The ridges of such a block run to its corners, and lines are grown from corner to corner of a row.
The blocks themselves are in line, so that one line is laid through their middles instead; whether
it is two, :mod:`gaussiancad_core.sheet.tracing.twin_lines` tells.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run, runs_of_ink
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.view_shapes import Shape, ViewShapes

Floats = npt.NDArray[np.float64]

_FEWEST = 4
"""Blocks of a row."""

_LIKE_A_DASH = 0.35
"""Share by which a block may be longer or shorter than the sheet's dashes."""

_WIDER, _WIDEST = 1.4, 2.9
"""Width of a block in those of the sheet's dashes, at least and at most."""

_SQUARE = 0.55
"""Width of a block in its lengths at least: of narrower ones the ridges run along."""

_SOLID = 0.85
"""Share of its box that a block fills."""

_IN_LINE_PX = 1.0
"""px by which the sides of a row's blocks differ at most."""

_STEADY = 0.35
"""Share by which the steps of a row differ from the sheet's at most, on the median."""

_INSIDE = 0.8
"""Share of a run within blocks from which it is theirs."""

_STRAIGHT, _ON_AXIS_PX = 1e-3, 0.3
"""Sine of the angle to the sheet's axes, and px from the row's middle, of a line that is right."""

_DARK, _STEP = 0.5, 0.5
"""Weight from which a place is ink, and px between the places that are looked at."""


@dataclass(frozen=True, eq=False)
class _Row:
    """Blocks in line.

    Attributes:
        along: 0 if the row runs along x, 1 if along y.
        boxes: (n, 2, 2) px, the lower and upper corner of each block; pixels' outer edges.
        middle: px across the row.
    """

    along: int
    boxes: Floats
    middle: float


def with_dash_blocks(views: Sequence[ViewShapes], rhythm: Rhythm) -> list[ViewShapes]:
    """The views, with one line through each row of blocks in the place of those across it.

    Args:
        views: shapes of all views of a sheet.
        rhythm: of the sheet's dashes.
    """
    return [_with_rows(view, rhythm) for view in views]


def _with_rows(view: ViewShapes, rhythm: Rhythm) -> ViewShapes:
    shapes = list(view.shapes)
    for row in _rows(view.sheet, rhythm):
        right = _right(shapes, row)
        reach = _reach(shapes, row)
        left = [shape if shape is right else _without(shape, row) for shape in shapes]
        shapes = [shape for shape in left if shape is not None]
        if right is None:
            shapes.append(_line_through(row, reach, view.sheet))
    return replace(view, shapes=tuple(shapes))


def _rows(sheet: CleanSheet, rhythm: Rhythm) -> Iterator[_Row]:
    count, labels, stats, _ = cv2.connectedComponentsWithStats(
        sheet.ink.astype(np.uint8), connectivity=8
    )
    low = stats[1:, [cv2.CC_STAT_LEFT, cv2.CC_STAT_TOP]].astype(float)
    size = stats[1:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].astype(float)
    ink = np.bincount(labels.ravel(), weights=sheet.weight.ravel(), minlength=count)[1:]
    # What is grey at the edges of a dash is there as a part of its width.
    width = ink[:, None] / size
    solid = stats[1:, cv2.CC_STAT_AREA] >= _SOLID * size.prod(axis=1)
    dashes = np.abs(size / max(rhythm.dash, 1.0) - 1.0) < _LIKE_A_DASH
    pens = [width[solid & dashes[:, k] & ~dashes[:, 1 - k], k] for k in (0, 1)]
    if not sum(map(len, pens)):
        return
    pen = float(np.median(np.concatenate(pens)))
    for along in (0, 1):
        across = 1 - along
        wide = (width[:, along] > _WIDER * pen) & (width[:, along] < _WIDEST * pen)
        wide &= solid & dashes[:, along] & (size[:, across] > _SQUARE * size[:, along])
        values = np.flatnonzero(wide)
        values = values[np.lexsort((low[values, along], low[values, across]))]
        breaks = np.flatnonzero(np.diff(low[values, across]) > _IN_LINE_PX) + 1
        for group in np.split(values, breaks):
            boxes = np.stack([low[group], low[group] + size[group]], axis=1) - 0.5
            boxes = boxes[np.argsort(boxes[:, 0, along])]
            if len(group) >= _FEWEST and _is_row(boxes, along, rhythm):
                yield _Row(along, boxes, _middle(boxes, across, sheet))


def _is_row(boxes: Floats, along: int, rhythm: Rhythm) -> bool:
    steps = np.diff(boxes[:, 0, along])
    off = np.abs(steps / (rhythm.dash + rhythm.gap) - 1.0)
    uneven = np.ptp(boxes[:, :, 1 - along], axis=0).max() > _IN_LINE_PX
    return bool(np.median(off) < _STEADY and not uneven)


def _middle(boxes: Floats, across: int, sheet: CleanSheet) -> float:
    """px across a row of the middle of its blocks' ink, on the median."""
    middles = []
    for (x0, y0), (x1, y1) in np.rint(boxes + 0.5).astype(int):
        left, top = max(x0 - 1, 0), max(y0 - 1, 0)
        ink = sheet.weight[top : y1 + 1, left : x1 + 1].sum(axis=across)
        start = (left, top)[across]
        middles.append(float(np.average(start + np.arange(len(ink)), weights=ink)))
    return float(np.median(middles))


def _right(shapes: Sequence[Shape], row: _Row) -> Shape | None:
    """The line along the middle of a row."""
    for shape in shapes:
        line = shape.geometry
        if not isinstance(line, Line) or abs(line.direction[1 - row.along]) > _STRAIGHT:
            continue
        within = sum(_inside(line, run, row) > _INSIDE for run in shape.runs)
        off = abs(line.point[1 - row.along] - row.middle)
        if off < _ON_AXIS_PX and within >= len(row.boxes) / 2.0:
            return shape
    return None


def _inside(line: Line, run: Run, row: _Row) -> float:
    """Share of a run that lies in a row's blocks."""
    points = line.points_at(np.arange(run.start, run.end + _STEP, _STEP))[:, None]
    within = (points >= row.boxes[:, 0] - _STEP) & (points <= row.boxes[:, 1] + _STEP)
    return float(np.any(np.all(within, axis=2), axis=1).mean())


def _without(shape: Shape, row: _Row) -> Shape | None:
    """A shape without its runs in a row's blocks; None if that is all of it."""
    line = shape.geometry
    if not isinstance(line, Line):
        return shape
    rest = tuple(run for run in shape.runs if _inside(line, run, row) <= _INSIDE)
    if len(rest) == len(shape.runs):
        return shape
    # What such a line has beyond, where a dash ends on another stroke, is the row's as well.
    if len(rest) < len(shape.runs) / 2.0:
        return None
    return replace(shape, runs=rest)


def _reach(shapes: Sequence[Shape], row: _Row) -> tuple[float, float]:
    """px along a row between which the lines that are its own have ink."""
    low, high = float(row.boxes[:, 0, row.along].min()), float(row.boxes[:, 1, row.along].max())
    for shape in shapes:
        if _without(shape, row) is None:
            line = shape.geometry
            assert isinstance(line, Line)
            ends = line.points_at(np.array([shape.runs[0].start, shape.runs[-1].end]))
            low, high = min(low, *ends[:, row.along]), max(high, *ends[:, row.along])
    return low, high


def _line_through(row: _Row, reach: tuple[float, float], sheet: CleanSheet) -> Shape:
    point = (0.0, row.middle) if row.along == 0 else (row.middle, 0.0)
    line = Line(point, (1.0, 0.0) if row.along == 0 else (0.0, 1.0))
    along = np.arange(reach[0], reach[1] + _STEP, _STEP)
    points = line.points_at(along)
    # Between two lines whose strokes just touch there may be a shade of paper.
    neighbour = (
        np.array([-1.0, 0.0, 1.0]) * np.ptp(row.boxes[:, :, 1 - row.along], axis=1).min() / 4.0
    )
    shift = (0.0, 1.0) if row.along == 0 else (1.0, 0.0)
    ink = sample(
        sheet.weight, points[:, :1] + shift[0] * neighbour, points[:, 1:] + shift[1] * neighbour
    )
    dark = ink.max(axis=1) > _DARK
    runs = tuple(Run(float(along[a]), float(along[b])) for a, b in runs_of_ink(dark))
    return Shape(line, runs, float(sum(run.length for run in runs)))
