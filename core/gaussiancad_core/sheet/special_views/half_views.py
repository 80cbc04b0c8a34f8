"""Half views: symmetric views that are drawn up to their centre line alone (ISO 128-3).

Such a view is open where its centre line runs: edges end at it, and none runs along it.  The other
half is its mirror image.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.annotations.erase import Told
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.line_conventions import SMALLEST_VIEW
from gaussiancad_core.sheet.picture_noise import LEVEL
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.votes import HALF

_NEAR = 2.0
"""Distance of the centre line from the side of the view at most, in stroke widths."""

_COVERED = 0.05
"""Share of the side that the centre line may miss at either end: it reaches beyond it."""

_LEAST_EDGES = 2
"""Edges that end at the centre line at least."""


@dataclass(frozen=True)
class Half:
    """A half view.

    Attributes:
        box: px, of what is drawn.
        upright: whether its centre line is.
        at: px across the centre line.
        beyond: whether the missing half lies at larger coordinates than the line.
        span: px along the centre line, its ends.
    """

    box: Box
    upright: bool
    at: float
    beyond: bool
    span: tuple[float, float]

    @property
    def whole(self) -> Box:
        """px around both halves."""
        x0, y0, x1, y1 = self.box
        low, high = (x0, x1) if self.upright else (y0, y1)
        low, high = (low, 2 * self.at - low) if self.beyond else (2 * self.at - high, high)
        return (low, y0, high, y1) if self.upright else (x0, low, x1, high)

    def marks(self, box: Box) -> bool:
        """Whether a small drawing is what is left of a mark of symmetry on the centre line."""
        x0, y0, x1, y1 = box if self.upright else (box[1], box[0], box[3], box[2])
        on_line = x0 - _NEAR <= self.at <= x1 + _NEAR
        within = y0 > self.span[0] - SMALLEST_VIEW and y1 < self.span[1] + SMALLEST_VIEW
        return on_line and within and max(x1 - x0, y1 - y0) < SMALLEST_VIEW


def find_halves(
    ink: Mask, stated: Told, clusters: Sequence[Box], stroke_width: float
) -> list[Half]:
    """Half views among clusters of ink.

    Args:
        ink: (h, w) bool, without annotations.
        stated: the sheet's lines, and which of them are centre lines.
        clusters: boxes of what may be half views.
        stroke_width: px.
    """
    found = []
    for upright, at, span in _centre_lines(stated):
        values = ink if upright else ink.T
        for box in clusters:
            x0, y0, x1, y1 = box if upright else (box[1], box[0], box[3], box[2])
            length = y1 - y0
            covers = span[0] < y0 + _COVERED * length and span[1] > y1 - _COVERED * length
            if length < SMALLEST_VIEW or not covers:
                continue
            for side, beyond in ((x1, True), (x0, False)):
                near = abs(side - at) < _NEAR * stroke_width + 1.0
                if near and _is_open(values, (y0, y1), (at, beyond), stroke_width):
                    found.append(Half(box, upright, at, beyond, span))
    return found


def _centre_lines(stated: Told) -> list[tuple[bool, float, tuple[float, float]]]:
    """Whether each level or upright centre line is upright, its place across it, and its ends."""
    found = []
    for shape, kinds in zip(stated.shapes, stated.kinds, strict=True):
        runs = [
            run.run
            for run, kind in zip(shape.runs, kinds, strict=True)
            if kind is AnnotationKind.CENTRE_LINE
        ]
        if not runs or not isinstance(shape.geometry, Line):
            continue
        ends = np.array([shape.geometry.at(runs[0].start), shape.geometry.at(runs[-1].end)]) + 0.5
        way = np.abs(shape.geometry.direction)
        if way.min() > LEVEL:
            continue
        across = int(np.argmin(way))
        low, high = sorted(ends[:, 1 - across].tolist())
        found.append((across == 0, float(ends[:, across].mean()), (low, high)))
    return found


def _is_open(
    ink: Mask, rows: tuple[float, float], line: tuple[float, bool], stroke_width: float
) -> bool:
    """Whether edges end at an upright line, and none runs along it."""
    at, beyond = line
    first, last = max(int(rows[0]), 0), min(int(np.ceil(rows[1])), ink.shape[0])
    reach = int(np.ceil(stroke_width))
    middle = int(at)
    along = ink[first:last, max(middle - reach, 0) : middle + reach + 1].any(axis=1)
    start = middle - 3 * reach - 2 if beyond else middle + reach + 1
    neighbour = ink[first:last, max(start, 0) : start + 2 * reach + 2].any(axis=1)
    ending = np.concatenate([[False], neighbour & along])
    edges = int(np.count_nonzero(ending[1:] & ~ending[:-1]))
    return float(along.mean()) < HALF and edges >= _LEAST_EDGES


def completed(sheet: CleanSheet, half: Half, others: Sequence[Box]) -> CleanSheet | None:
    """The sheet with a half view's mirror image, or nothing where there is no room for it.

    Args:
        sheet: without annotations.
        half: the view.
        others: boxes of all other drawings.
    """
    box = half.whole
    height, width = sheet.ink.shape
    if box[0] < 0 or box[1] < 0 or box[2] > width or box[3] > height:
        return None
    if any(_overlap(box, other) for other in others):
        return None
    axis = 0 if half.upright else 1
    low, high = box[axis], box[axis + 2]
    start, end = (half.at, high) if half.beyond else (low, half.at)
    margin = sheet.stroke_width + 4.0
    first, last = int(start - margin * (not half.beyond)), int(np.ceil(end + margin * half.beyond))
    first, last = max(first, 0), min(last, (width, height)[axis])
    centres = np.arange(first, last) + 0.5
    # Between the centre line and the first px beyond it both halves have a share.
    source = 2.0 * half.at - centres - 0.5
    side = slice(max(int(box[1 - axis] - margin), 0), int(np.ceil(box[3 - axis] + margin)))
    weight = sheet.weight if half.upright else sheet.weight.T
    ink = sheet.ink if half.upright else sheet.ink.T
    rows = np.arange(weight.shape[0], dtype=np.float32)[side]
    maps = np.meshgrid(source.astype(np.float32), rows)
    image = cv2.remap(np.ascontiguousarray(weight), *maps, cv2.INTER_CUBIC, borderValue=0.0)
    mirrored = np.clip(image, 0.0, 1.0)
    nearest = cv2.remap(
        np.ascontiguousarray(ink).astype(np.uint8), *maps, cv2.INTER_NEAREST, borderValue=0
    )
    weight, ink = weight.copy(), ink.copy()
    window = side, slice(first, last)
    far = np.abs(centres - half.at) > 1.0
    weight[window] = np.where(far, mirrored, np.maximum(weight[window], mirrored))
    ink[window] = np.where(far, nearest > 0, ink[window] | (nearest > 0))
    odds = sheet.hidden_odds
    if odds is not None:
        values = (odds if half.upright else odds.T).astype(np.float32)
        across = cv2.remap(np.ascontiguousarray(values), *maps, cv2.INTER_NEAREST)
        values[window] = np.where(far, across, values[window])
        odds = np.ascontiguousarray(values if half.upright else values.T).astype(np.float16)
    if not half.upright:
        weight, ink = np.ascontiguousarray(weight.T), np.ascontiguousarray(ink.T)
    return replace(sheet, weight=weight, ink=ink, hidden_odds=odds)


def _overlap(one: Box, other: Box) -> bool:
    return min(one[2], other[2]) > max(one[0], other[0]) and min(one[3], other[3]) > max(
        one[1], other[1]
    )
