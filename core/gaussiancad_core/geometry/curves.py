"""The curves of drawings: pieces of lines, circles and ellipses, and chains along all others."""

from collections.abc import Iterable

from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.points import Box

Curve = LineSegment | CircularArc | EllipticArc | Chain


def bounds(curves: Iterable[Curve]) -> Box:
    """Around one or more curves."""
    x0, y0, x1, y1 = zip(*(curve.box for curve in curves), strict=True)
    return min(x0), min(y0), max(x1), max(y1)
