"""How far ends that meet miss each other in a file, where its numbers tell no grid any more.

What was rounded may have been taken apart, turned or fitted again since.  Lines that ended together
are still apart by about a step.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.near_points import near_pairs
from gaussiancad_core.sheet.file_noise import EXACT

_COARSEST = 0.3
"""px between the ends of rounded strokes that meet, at most: farther ones may be two corners of a
part."""

_ASKED = 3
"""Nearest ends of other strokes that are asked of each end."""

_OFTEN, _FEWEST = 0.3, 8
"""Share of meetings that are missed where that is a rule, and strokes from which it is one."""


def missed_px(curves: Sequence[Curve]) -> float:
    """px by which ends that meet miss each other at the median; 0 where most do not."""
    open_curves = [curve for curve in curves if isinstance(curve, LineSegment | CircularArc)]
    if len(open_curves) < _FEWEST:
        return 0.0
    ends = np.concatenate([open_curve.vertices(np.inf)[[0, -1]] for open_curve in open_curves])
    pairs = near_pairs(ends, _COARSEST)
    one, other = np.concatenate([pairs, pairs[:, ::-1]]).T
    away = np.hypot(*(ends[one] - ends[other]).T)
    nearest = np.lexsort((away, one))
    one, away = one[nearest], away[nearest]
    is_asked = np.arange(len(one)) - np.searchsorted(one, one) < _ASKED
    missed = is_asked & (away > EXACT)
    exactly = np.isin(one, one[is_asked & ~missed])
    meeting = len(np.unique(one))
    if not meeting or len(np.unique(one[missed & ~exactly])) <= _OFTEN * meeting:
        return 0.0
    return float(np.median(away[missed]))
