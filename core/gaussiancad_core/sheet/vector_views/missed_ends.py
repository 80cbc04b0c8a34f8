"""How far ends that meet miss each other in a file, where its numbers tell no grid any more.

What was rounded may have been taken apart, turned or fitted again since.  Lines that ended together
are still apart by about a step.
"""

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.sheet.file_noise import EXACT

_COARSEST = 0.3
"""px between the ends of rounded strokes that meet, at most: farther ones may be two corners of a
part."""

_OFTEN, _FEWEST = 0.3, 8
"""Share of meetings that are missed where that is a rule, and strokes from which it is one."""


def missed_px(curves: Sequence[Curve]) -> float:
    """px by which ends that meet miss each other at the median; 0 where most do not."""
    open_curves = [curve for curve in curves if isinstance(curve, LineSegment | CircularArc)]
    if len(open_curves) < _FEWEST:
        return 0.0
    ends = np.concatenate([open_curve.vertices(np.inf)[[0, -1]] for open_curve in open_curves])
    # The nearest but one: the nearest is the end itself, or the other end of a circle.
    away = cKDTree(ends).query(ends, k=min(4, len(ends)))[0][:, 1:]
    meeting = away[(away < _COARSEST).any(axis=1)]
    missed = (meeting > EXACT) & (meeting < _COARSEST)
    exactly = (meeting <= EXACT).any(axis=1)
    if not len(meeting) or (missed.any(axis=1) & ~exactly).mean() <= _OFTEN:
        return 0.0
    return float(np.median(meeting[missed]))
