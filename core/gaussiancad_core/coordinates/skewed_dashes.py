"""Dashes that were read askew.

A dash beside another line may come out as a short slanted stroke, though it is one of a line that
was read as a whole as well.  As a line of its own it would tell a slanted plane.  So may a dash of
a circle where a straight line leads on to its extreme, and it would tell a plane that touches it.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import atan2, dist, pi

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import WELL_READ
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Arc, Segment

_DASH = 12.0
"""Tolerances of length up to which a stroke may be a dash that was read askew."""

_LONG_DASH = 24.0
"""The same where a circle tells it: where it is drawn, no other line has room beside it."""

_ASKEW = 2.0
"""Tolerances by which its ends lie beside its line at most; less than one is no slant."""

_SKEW = 0.3
"""Sine of the angle between the two at most."""


def without_askew_dashes(views: DrawnViews) -> DrawnViews:
    """The views without short strokes that run along a longer straight one, or a circle."""
    strokes = {role: _without(curves, views.tolerance) for role, curves in views.strokes.items()}
    return replace(views, strokes=strokes)


def _without(strokes: Sequence[DrawnStroke], tolerance: float) -> tuple[DrawnStroke, ...]:
    segments = [stroke for stroke in strokes if isinstance(stroke, Segment)]
    lines = [segment for segment in segments if segment.length > _DASH * tolerance]
    arcs = [
        stroke
        for stroke in strokes
        if isinstance(stroke, Arc) and stroke.length > _LONG_DASH * tolerance
    ]
    askew = {
        id(segment)
        for segment in segments
        if segment.length <= _LONG_DASH * tolerance
        and (
            any(_runs_around(segment, arc, tolerance) for arc in arcs)
            or (
                segment.length <= _DASH * tolerance
                and any(_runs_along(segment, line, tolerance) for line in lines)
            )
        )
    }
    return tuple(stroke for stroke in strokes if id(stroke) not in askew)


def _runs_around(dash: Segment, arc: Arc, tolerance: float) -> bool:
    """Whether a dash lies on an arc that is drawn all along it."""
    (x, y), (ox, oy) = dash.start, dash.end
    points = dash.start, dash.end, ((x + ox) / 2.0, (y + oy) / 2.0)
    away = max(abs(dist(point, arc.centre) - arc.radius) for point in points)
    if arc.linetype is not dash.linetype or away > WELL_READ * tolerance:
        return False
    angles = [
        (atan2(y - arc.centre[1], x - arc.centre[0]) - arc.start_angle) % FULL_TURN
        for x, y in (dash.start, dash.end)
    ]
    return max(angles) <= arc.sweep and max(angles) - min(angles) < pi


def _runs_along(dash: Segment, line: Segment, tolerance: float) -> bool:
    """Whether a dash lies beside a line between the line's ends, a little turned against it."""
    (x, y), (ox, oy), length = line.start, line.end, line.length
    dx, dy = (ox - x) / length, (oy - y) / length
    off = [(b - y) * dx - (a - x) * dy for a, b in (dash.start, dash.end)]
    if max(map(abs, off)) > _ASKEW * tolerance:
        return False
    at = [(a - x) * dx + (b - y) * dy for a, b in (dash.start, dash.end)]
    adjacent = -tolerance <= min(at) and max(at) <= length + tolerance
    return adjacent and tolerance < max(off) - min(off) <= _SKEW * dash.length
