"""Arcs that files write in pieces.

Where other edges end on an arc some systems cut it, and write a short piece as its chord or as an
arc of a circle of its own, which misses the arc by less than can be seen.  As lines chords would
tell planes, and between the pieces the arc's surface would be open.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import hypot, pi

import numpy as np

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import MEETING
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Arc, Segment

_SAME = 0.05
"""Tolerances within which centres and radii are one, and ends of a chord lie on its arc."""

_TURN = pi / 4.0
"""Radians that a piece turns by at most."""


def with_pieces_of_arcs(views: DrawnViews) -> DrawnViews:
    """The views, in which chords and flat arcs that go on from an arc along its circle are its.

    Only lines that are known exactly are looked at: what was read may lie so beside any circle.
    """
    if views.apart is not None:
        return views
    strokes = {
        role: _with_pieces(curves, views.tolerance) for role, curves in views.strokes.items()
    }
    return replace(views, strokes=strokes)


def is_piece(arc: Arc, strokes: Sequence[DrawnStroke], views: DrawnViews) -> bool:
    """Whether another arc of its view lies on the very circle of an arc, flat as both may be.

    Args:
        arc: one of the strokes.
        strokes: of one of the views.
        views: whose lines are known exactly, or there is no very circle.
    """
    return views.apart is None and _has_twin(arc, strokes, views.tolerance)


def _has_twin(arc: Arc, strokes: Sequence[DrawnStroke], tolerance: float) -> bool:
    for other in strokes:
        if isinstance(other, Arc) and other is not arc:
            away = hypot(arc.centre[0] - other.centre[0], arc.centre[1] - other.centre[1])
            if max(away, abs(arc.radius - other.radius)) <= _SAME * tolerance:
                return True
    return False


def _with_pieces(strokes: Sequence[DrawnStroke], tolerance: float) -> tuple[DrawnStroke, ...]:
    """The strokes, pieces one after the other as well."""
    curves = list(strokes)
    left = [
        number for number, stroke in enumerate(curves) if _may_be_piece(stroke, curves, tolerance)
    ]
    while left:
        carriers = [
            stroke
            for number, stroke in enumerate(curves)
            if isinstance(stroke, Arc) and number not in left
        ]
        pieces = ((number, _piece(curves[number], carriers, tolerance)) for number in left)
        found = {number: piece for number, piece in pieces if piece is not None}
        if not found:
            break
        for number, piece in found.items():
            curves[number] = piece
        left = [number for number in left if number not in found]
    return tuple(curves)


def _may_be_piece(stroke: DrawnStroke, strokes: Sequence[DrawnStroke], tolerance: float) -> bool:
    if isinstance(stroke, Arc):
        rise = stroke.radius * (1.0 - np.cos(min(stroke.sweep, FULL_TURN) / 2.0))
        return bool(rise <= MEETING * tolerance) and not _has_twin(stroke, strokes, tolerance)
    return isinstance(stroke, Segment) and stroke.length > 0.0


def _piece(stroke: DrawnStroke, arcs: Sequence[Arc], tolerance: float) -> Arc | None:
    """The stroke as a part of the circle of an arc that it goes on from; None if there is none."""
    points = stroke.sample(stroke.length / 4.0)
    best, least = None, _SAME * tolerance
    offs = points - np.array([arc.centre for arc in arcs]).reshape(-1, 1, 2)
    aways = np.abs(np.hypot(*offs.transpose(2, 1, 0)) - [arc.radius for arc in arcs])
    ends_away = np.maximum(aways[0], aways[-1])
    near = (ends_away <= least) & (aways.max(axis=0) <= MEETING * tolerance)
    for number in np.flatnonzero(near).tolist():
        arc, off, ends = arcs[number], offs[number], ends_away[number]
        if ends > least:
            continue
        angles = np.unwrap(np.arctan2(off[:, 1], off[:, 0]))
        low, high = sorted((float(angles[0]), float(angles[-1])))
        if high - low <= _TURN and _touches((low, high), arc, tolerance):
            best = Arc(arc.centre, arc.radius, low % FULL_TURN, high - low, stroke.linetype)
            least = float(ends)
    return best


def _touches(angles: tuple[float, float], arc: Arc, tolerance: float) -> bool:
    """Whether one of the ends of a piece lies on the drawn part of its circle."""
    slack = tolerance / arc.radius
    after = [(angle - arc.start_angle + slack) % FULL_TURN for angle in angles]
    return min(after) <= arc.sweep + 2.0 * slack
