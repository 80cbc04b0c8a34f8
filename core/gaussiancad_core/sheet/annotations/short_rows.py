"""Hidden lines of a few dashes between two edges, on sheets without a whole row of dashes.

Where a plate is thin all of its hidden lines are two or three dashes long, and the last one touches
an edge: nothing tells how long a dash is.  But dashes follow each other at the sheet's gap, are
alike, and lead from one edge to another, which extension lines do not.
"""

from collections.abc import Iterator, Sequence

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape, points_along
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.geometry import Line

_EVEN, _EVEN_PX = 0.2, 2.0
"""Share, and px beside that, by which the gaps of a row may differ from the sheet's."""

_LONGER = 1.25
"""Times its longest dash is as long as its shortest whole one, at most."""

_LONGEST = 5.0
"""Gaps that a dash is long at most: pieces of extension lines that edges cut are longer."""

_MET_PX = 2.5
"""px between a row's end and the axis of an edge that it meets at most, beyond half a stroke."""


def spare_short_rows(
    shapes: Sequence[InkedShape],
    kinds: Kinds,
    weights: Weights,
    dash_gap: float,
    stroke_width: float,
) -> None:
    """Take back what was told of such rows, in place.

    Args:
        shapes: lines and circles of the sheet.
        kinds: what each run is known to be.
        weights: of wide and narrow lines.
        dash_gap: px, usual between the sheet's dashes.
        stroke_width: px, the mean over the sheet.
    """
    wide = [
        points_along(shape.geometry, run.run, 1.0)
        for shape in shapes
        for run in shape.runs
        if run.width is not None and run.width >= weights.limit
    ]
    if not wide:
        return
    edges = cKDTree(np.concatenate(wide))
    met = _MET_PX + stroke_width / 2.0
    for shape, own in zip(shapes, kinds, strict=True):
        line = shape.geometry
        if not isinstance(line, Line):
            continue
        for first, last in _rows(shape.runs, own, dash_gap):
            runs = [run.run for run in shape.runs[first : last + 1]]
            # Its first or last dash may be cut, or have an edge's ink.
            ends = np.array([line.at(runs[0].start), line.at(runs[-1].end)])
            away = edges.query(ends)[0]
            if away.min() <= met and away.max() <= (1.0 + _EVEN) * dash_gap + _EVEN_PX + met:
                own[first : last + 1] = [None] * (last + 1 - first)


def _rows(
    runs: Sequence[InkedRun], own: Sequence[AnnotationKind | None], dash_gap: float
) -> Iterator[tuple[int, int]]:
    """First and last of runs that are alike and follow each other at the sheet's gap, some of them
    told as extension lines."""
    told = AnnotationKind.EXTENSION
    most = _EVEN * dash_gap + _EVEN_PX
    first = 0
    for k in range(1, len(runs) + 1):
        if k < len(runs):
            gap = runs[k].run.start - runs[k - 1].run.end
            if abs(gap - dash_gap) <= most and {own[k], own[k - 1]} <= {None, told}:
                continue
        lengths = [run.run.length for run in runs[first:k]]
        if max(lengths) <= _LONGEST * dash_gap and _is_alike(lengths) and told in own[first:k]:
            yield first, k - 1
        first = k


def _is_alike(lengths: Sequence[float]) -> bool:
    """Whether these are lengths of dashes, of which the first and the last one may be cut."""
    if len(lengths) < 2:
        return False
    whole = lengths[1:-1] or lengths
    return max(lengths) <= _LONGER * max(whole) and max(whole) <= _LONGER * min(whole)
