"""Ink that the strokes of a view do not account for, pixel by pixel.

The strokes are drawn again with the pens of visible lines and of dashes.  What the sheet has beyond
that tells of strokes that are still missing, also right beside the others, where marks as wide as
strokes would cover it.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import AROUND, BLANK, DARK, STEP
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import runs_of_ink
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.tracing.pen_profile import Pen, fit_pen, visible_pen

Floats = npt.NDArray[np.float64]

_WITHIN, _MOSTLY = 1.2, 0.6
"""Line widths beside a way in which ink counts, and the share of it, squared, on the way."""

_LONGER = 5.0
"""px by which dashes are made longer, since nothing within 8 px of a stroke's end tells its pen."""


@dataclass(frozen=True, eq=False)
class Leftover:
    """What strokes leave.

    Attributes:
        expected: (h, w) float32 ink of the strokes, their gaps filled.
        ink: (h, w) float32 beyond that.
        pen: of visible lines.
    """

    expected: npt.NDArray[np.float32]
    ink: npt.NDArray[np.float32]
    pen: Pen

    def is_mostly_on(self, start: Floats, end: Floats, width: float) -> bool:
        """Whether most of what is left beside a straight way is that of a stroke from (2,) px to
        (2,) px, ``width`` px wide."""
        length = float(np.hypot(*(end - start)))
        way = (end - start) / length
        low = np.maximum(np.floor(np.minimum(start, end) - width), 0).astype(int)
        high = np.ceil(np.maximum(start, end) + width).astype(int) + 1
        part = self.ink[low[1] : high[1], low[0] : high[0]]
        rows, columns = np.nonzero(part > BLANK)
        offsets = np.stack([columns, rows], axis=1) + low - start
        along, across = offsets @ way, np.abs(offsets @ np.array([-way[1], way[0]]))
        ink = part[rows, columns] ** 2
        neighbour = (along > -width) & (along < length + width) & (across <= _WITHIN * width)
        item = (along > -width / 2.0) & (along < length + width / 2.0) & (across <= width / 2.0)
        return float(ink[item].sum()) >= _MOSTLY * float(ink[neighbour].sum())


def leftover_ink(placed: Sequence[Placed], sheet: CleanSheet) -> Leftover:
    """The ink of a view that pieces with their ends at junctions leave."""
    pens = {
        Linetype.VISIBLE: visible_pen(sheet.weight, placed, sheet.stroke_width),
        Linetype.HIDDEN: dash_pen(placed, sheet),
    }
    rows, columns = np.nonzero(sheet.weight > BLANK)
    pixels = np.stack([columns, rows], axis=1).astype(np.float64)
    expected = np.zeros(len(pixels))
    for pair in placed:
        geometry, piece = pair
        pen = pens[piece.linetype]
        count = max(2, int(piece.end - piece.start))
        course = geometry.points_at(np.linspace(piece.start, piece.end, count))
        reach = pen.width / 2.0 + AROUND
        low, high = course.min(0) - reach, course.max(0) + reach
        near = np.flatnonzero(((pixels >= low) & (pixels <= high)).all(axis=1))
        expected[near] = np.maximum(expected[near], pen.ink(distances_to(pair, pixels[near])))
    there = np.zeros(sheet.weight.shape, dtype=np.float32)
    there[rows, columns] = expected
    return Leftover(there, np.clip(sheet.weight - there, 0.0, None), pens[Linetype.VISIBLE])


def dash_pen(placed: Sequence[Placed], sheet: CleanSheet) -> Pen:
    """The pen of the dashes of hidden lines."""
    dashes = []
    for geometry, piece in placed:
        if isinstance(geometry, Line) and piece.linetype is Linetype.HIDDEN:
            along = np.arange(piece.start, piece.end, STEP)
            points = geometry.points_at(along)
            dark = sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] > DARK
            for first, last in runs_of_ink(dark):
                start, end = float(along[first]) - _LONGER, float(along[last]) + _LONGER
                dashes.append((geometry, start, end))
    return fit_pen(sheet.weight, dashes, sheet.stroke_width)
