"""Curves of a file as strokes of views, px of the upright sheet."""

import numpy as np

from gaussiancad_core.files.vectors import CircularArc, Curve, EllipticArc, Line
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke


def stroke_along(curve: Curve, linetype: Linetype = Linetype.VISIBLE) -> Stroke | None:
    """The stroke along a curve; None for a free curve, and where the curve has no length."""
    if isinstance(curve, Line):
        return Segment(curve.start, curve.end, linetype) if curve.length else None
    if isinstance(curve, CircularArc):
        return Arc(curve.centre, curve.radius, curve.start_angle, curve.sweep, linetype)
    if isinstance(curve, EllipticArc):
        along, across = curve.major
        semi_major = float(np.hypot(along, across))
        axes = semi_major, semi_major * curve.ratio, float(np.arctan2(across, along))
        return Ellipse(curve.centre, *axes, curve.start, curve.sweep, linetype)
    return None
