"""Dashes that were read askew.

A dash beside another line may come out as a short slanted stroke, though it is one of a line that
was read as a whole as well.  As a line of its own it would tell a slanted plane.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.verification.lines import Curve
from gaussiancad_core.views import Segment

_DASH = 12.0
"""Tolerances of length up to which a stroke may be a dash that was read askew."""

_ASKEW = 2.0
"""Tolerances by which its ends lie beside its line at most; less than one is no slant."""

_SKEW = 0.3
"""Sine of the angle between the two at most."""


def without_askew_dashes(views: DrawnViews) -> DrawnViews:
    """The views without short slanted strokes that run along a longer straight one."""
    strokes = {
        role: tuple(stroke for stroke in own if not _is_askew(stroke, own, views.tolerance))
        for role, own in views.strokes.items()
    }
    return replace(views, strokes=strokes)


def _is_askew(stroke: Curve, others: Sequence[Curve], tolerance: float) -> bool:
    if not isinstance(stroke, Segment) or stroke.length > _DASH * tolerance:
        return False
    return any(
        _runs_along(stroke, other, tolerance)
        for other in others
        if isinstance(other, Segment) and other.length > _DASH * tolerance
    )


def _runs_along(dash: Segment, line: Segment, tolerance: float) -> bool:
    """Whether a dash lies beside a line between the line's ends, a little turned against it."""
    start = np.array(line.start)
    along = (np.array(line.end) - start) / line.length
    ends = np.array([dash.start, dash.end]) - start
    at, off = ends @ along, ends @ np.array([-along[1], along[0]])
    beside = -tolerance <= at.min() and at.max() <= line.length + tolerance
    turned = tolerance < np.ptp(off) <= _SKEW * dash.length
    return bool(beside and turned and np.abs(off).max() <= _ASKEW * tolerance)
