"""Dashes that were read askew.

A dash beside another line may come out as a short slanted stroke, though it is one of a line that
was read as a whole as well.  As a line of its own it would tell a slanted plane.  So may a dash of
a circle where a straight line leads on to its extreme, and it would tell a plane that touches it.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.verification.lines import Curve
from gaussiancad_core.views import Arc, Segment

_DASH = 12.0
"""Tolerances of length up to which a stroke may be a dash that was read askew."""

_LONG_DASH = 24.0
"""The same where a circle tells it: where it is drawn, no other line has room beside it."""

_ASKEW = 2.0
"""Tolerances by which its ends lie beside its line at most; less than one is no slant."""

_TOUCHING = 0.75
"""Tolerances by which a dash of a circle lies beside it at most."""

_SKEW = 0.3
"""Sine of the angle between the two at most."""


def without_askew_dashes(views: DrawnViews) -> DrawnViews:
    """The views without short strokes that run along a longer straight one, or a circle."""
    strokes = {
        role: tuple(stroke for stroke in own if not _is_askew(stroke, own, views.tolerance))
        for role, own in views.strokes.items()
    }
    return replace(views, strokes=strokes)


def _is_askew(stroke: Curve, others: Sequence[Curve], tolerance: float) -> bool:
    if not isinstance(stroke, Segment) or stroke.length > _LONG_DASH * tolerance:
        return False
    return any(_is_of(stroke, other, tolerance) for other in others)


def _is_of(dash: Segment, other: Curve, tolerance: float) -> bool:
    if isinstance(other, Arc):
        return other.length > _LONG_DASH * tolerance and _runs_around(dash, other, tolerance)
    if not isinstance(other, Segment) or dash.length > _DASH * tolerance:
        return False
    return other.length > _DASH * tolerance and _runs_along(dash, other, tolerance)


def _runs_around(dash: Segment, arc: Arc, tolerance: float) -> bool:
    """Whether a dash lies on an arc that is drawn all along it."""
    if arc.linetype is not dash.linetype:
        return False
    off = np.array([dash.start, dash.end]) - np.array(arc.centre)
    middle = np.hypot(*off.mean(axis=0))
    away = [*np.hypot(*off.T), middle]
    angles = np.mod(np.arctan2(off[:, 1], off[:, 0]) - arc.start_angle, 2.0 * np.pi)
    return bool(
        np.abs(np.array(away) - arc.radius).max() <= _TOUCHING * tolerance
        and angles.max() <= arc.sweep
        and np.ptp(angles) < np.pi
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
