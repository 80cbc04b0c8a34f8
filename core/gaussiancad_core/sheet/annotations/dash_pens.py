"""Hidden lines that are narrower than edges and wider than the lines of dimensions.

Many sheets are drawn with three pens.  The middle one counts as narrow, so that what has no other
dash beside it, as the flanks of a drill's tip or a bore's bottom in a crowded view, was taken for
an extension line.  Where all narrow lines, long ones and those of long and short dashes, are of one
width, and the dashes of hidden lines are wider, a piece as long as a dash and as wide is one.
"""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedShape
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.runs import learn_rhythm

_LONG = 4.0
"""Length of a line at least, in the sheet's dashes, that tells how wide narrow ones are."""

_SHORTEST, _LONGEST = 0.5, 1.3
"""Length of a dash, in the sheet's usual ones: strokes that cross it make it longer or shorter."""

_JOINED = 3.0
"""Length of dashes at most, in the sheet's usual ones, that strokes across their gaps join."""

_FEWEST = 6
"""Narrow lines, and dashes, of a sheet at least from which their pens are known."""

_WIDER = 1.2
"""Width of hidden lines at least, in that of dimensions: ISO 128-2 has no pens that are closer."""

_MOST, _LEAST = 90.0, 10.0
"""Percentile of the narrow lines under whose width no more than this one of the dashes lies."""

_NEARER = 0.6
"""Where between the two pens' widths a dash's lies at least."""

Floats = npt.NDArray[np.float64]


def spare_by_pen(
    shapes: Sequence[InkedShape], kinds: Kinds, weights: Weights, stroke_width: float
) -> None:
    """Take back what was told of dashes that the pen of hidden lines drew, in place.

    Args:
        shapes: lines and circles of a sheet.
        kinds: what each run is known to be.
        weights: of wide and narrow lines.
        stroke_width: px, the mean over the sheet.
    """
    dash = _dash(shapes, kinds, stroke_width)
    limit = _limit(shapes, kinds, weights.limit, dash)
    if not limit:
        return
    longest = _JOINED * dash + stroke_width
    for shape, own in zip(shapes, kinds, strict=True):
        for k, run in enumerate(shape.runs):
            wide = run.width is not None and limit <= run.width < weights.limit
            is_dash = wide and _SHORTEST * dash <= run.run.length <= longest
            if is_dash and own[k] is AnnotationKind.EXTENSION:
                own[k] = None


def _dash(shapes: Sequence[InkedShape], kinds: Kinds, stroke_width: float) -> float:
    series = [
        [run.run for run, kind in zip(shape.runs, own, strict=True) if kind is None]
        for shape, own in zip(shapes, kinds, strict=True)
    ]
    return learn_rhythm(series, stroke_width).dash


def _limit(shapes: Sequence[InkedShape], kinds: Kinds, limit: float, dash: float) -> float:
    """px from which what is narrow is a dash's; 0 where one pen drew both."""
    runs = [
        (run, kind)
        for shape, own in zip(shapes, kinds, strict=True)
        for run, kind in zip(shape.runs, own, strict=True)
        if run.width is not None and run.width < limit
    ]
    lines = [
        run.width
        for run, kind in runs
        if kind is not None
        and (kind is AnnotationKind.CENTRE_LINE or run.run.length >= _LONG * dash)
    ]
    dashes = [
        run.width
        for run, kind in runs
        if kind is None and _SHORTEST * dash <= run.run.length <= _LONGEST * dash
    ]
    if min(len(lines), len(dashes)) < _FEWEST:
        return 0.0
    narrow, wide = float(np.median(lines)), float(np.median(dashes))
    apart = np.percentile(lines, _MOST) < np.percentile(dashes, _LEAST)
    if wide < _WIDER * narrow or not apart:
        return 0.0
    return narrow + _NEARER * (wide - narrow)
