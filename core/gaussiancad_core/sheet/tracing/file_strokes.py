"""Curves of a file as strokes of views, px of the upright sheet."""

from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke


def stroke_along(curve: Curve, linetype: Linetype = Linetype.VISIBLE) -> Stroke | None:
    """The stroke along a curve; None for a free curve, and where the curve has no length."""
    if isinstance(curve, LineSegment):
        return Segment(curve.start, curve.end, linetype) if curve.length else None
    if isinstance(curve, CircularArc):
        return Arc(curve.centre, curve.radius, curve.start_angle, curve.sweep, linetype)
    if isinstance(curve, EllipticArc):
        axes = curve.semi_major, curve.semi_minor, curve.rotation
        return Ellipse(curve.centre, *axes, curve.start, curve.sweep, linetype)
    return None
