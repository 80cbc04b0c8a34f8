"""Flat arcs that round a corner: they pass smoothly into other strokes at both of their ends.

An arc that rises by a few tolerances may be any curve; one between two strokes that it touches is
a fillet, whatever they are: lines, or arcs, that end there or run past.
"""

from collections.abc import Iterable
from math import cos, hypot, pi, sin

import numpy as np

from gaussiancad_core.geometry.tolerances import TELLING
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Arc, Segment

_LEAST_SWEEP, _MOST_SWEEP = pi / 3.0, 0.75 * pi
"""Radians that a fillet turns by: less says little of its circle, more needs no neighbours."""

_FLAT_SWEEP, _FLAT_RISE = pi / 7.0, 1.5
"""Radians and tolerances by which one between two straight lines turns and rises at least: both are
its tangents, which tell its circle but for the radius."""

_SMOOTH = 0.12
"""Sine of the angle within which two strokes pass smoothly into each other."""


def is_rounding(arc: Arc, strokes: Iterable[DrawnStroke], tolerance: float) -> bool:
    """Whether an arc rounds a corner between two other strokes of its view.

    Args:
        arc: one of the strokes.
        strokes: of the view; mm.
        tolerance: mm by which strokes may miss where they belong.
    """
    if arc.radius <= TELLING * tolerance or not _FLAT_SWEEP <= arc.sweep <= _MOST_SWEEP:
        return False
    others = [stroke for stroke in strokes if stroke is not arc]
    if arc.sweep < _LEAST_SWEEP:
        # Flatter arcs one after the other follow a free curve.
        others = [s for s in others if isinstance(s, Segment) and s.length >= TELLING * tolerance]
        if arc.radius * (1.0 - cos(arc.sweep / 2.0)) < _FLAT_RISE * tolerance:
            return False
    angles = (arc.start_angle, arc.start_angle + arc.sweep)
    return all(any(_goes_on(other, arc, at, tolerance) for other in others) for at in angles)


def is_quarter(arc: Arc, tolerance: float) -> bool:
    """Whether an arc rounds a corner between lines along the axes: its ends tell its circle.

    Args:
        arc: of a view; mm.
        tolerance: mm by which strokes may miss where they belong.
    """
    if arc.radius <= TELLING * tolerance:
        return False
    ends = np.array([arc.start_angle, arc.start_angle + arc.sweep]) / (pi / 2.0)
    off = np.abs(ends - np.rint(ends)).max() * (pi / 2.0) * arc.radius
    return bool(off <= tolerance and round(arc.sweep / (pi / 2.0)) == 1)


def _goes_on(stroke: DrawnStroke, arc: Arc, angle: float, tolerance: float) -> bool:
    """Whether an arc's end at an angle lies on a stroke, along it."""
    x, y = cos(angle), sin(angle)
    end = np.array([arc.centre[0] + arc.radius * x, arc.centre[1] + arc.radius * y])
    if isinstance(stroke, Segment):
        if stroke.length <= tolerance:
            return False
        start = np.array(stroke.start)
        way = (np.array(stroke.end) - start) / stroke.length
        foot = start + np.clip((end - start) @ way, 0.0, stroke.length) * way
        return bool(np.hypot(*(end - foot)) <= tolerance and abs(way @ (x, y)) <= _SMOOTH)
    if not isinstance(stroke, Arc):
        return False
    dx, dy = end[0] - stroke.centre[0], end[1] - stroke.centre[1]
    away = hypot(dx, dy)
    slack = tolerance / stroke.radius
    within = (np.arctan2(dy, dx) - stroke.start_angle + slack) % (2.0 * pi)
    if abs(away - stroke.radius) > tolerance or within > stroke.sweep + 2.0 * slack:
        return False
    return abs(dx * y - dy * x) <= _SMOOTH * away
