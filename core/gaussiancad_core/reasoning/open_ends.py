"""Strokes that may go on beyond their ends.

Readers lead the end of a stroke to a line close by.  Where several lines pass within some pixels of
each other the corner may lie at another one of them, or beyond: behind a wide line the last dash of
a hidden one is not seen.  Led to the wrong line, an end leaves a region open, and what lies on both
sides of a face is one cell.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from gaussiancad_core.reasoning.curves import LineCurve, Point, meetings
from gaussiancad_core.reasoning.spans import Span, Support
from gaussiancad_core.reasoning.supports import PartSupports, PlaneSupports
from gaussiancad_core.views import Linetype

_BEYOND = 8.0
"""Tolerances by which a stroke may go on."""

_SAME = 1e-4
"""Units within which ends are one."""


def with_open_ends(supports: PartSupports) -> PartSupports:
    """The supports with stretches, which may be drawn or not, from ends of strokes to the lines
    and circles that are drawn close by."""
    planes = {axis: _opened(plane, supports.tolerance) for axis, plane in supports.planes.items()}
    return replace(supports, planes=planes)


def _opened(plane: PlaneSupports, tolerance: float) -> PlaneSupports:
    opened = []
    for support in plane.supports:
        others = [other for other in plane.supports if other is not support]
        spans = {
            role: (*own, *_further(support, others, tolerance))
            for role, own in support.spans.items()
        }
        opened.append(Support(support.curve, spans))
    return replace(plane, supports=tuple(opened))


def _further(support: Support, others: Sequence[Support], tolerance: float) -> Iterator[Span]:
    """From each end of what is drawn to the farthest meeting with a drawn curve within reach."""
    curve = support.curve
    if not isinstance(curve, LineCurve):
        return
    places = [
        curve.parameter(point)
        for other in others
        for point in meetings(curve, other.curve)
        if _is_drawn(other, point, tolerance)
    ]
    reach = _BEYOND * tolerance
    for low, high in support.drawn():
        for end, way in ((low, -1.0), (high, 1.0)):
            beyond = [at for at in places if _SAME < way * (at - end) <= reach]
            if beyond:
                last = max(beyond, key=lambda at: way * at)
                yield Span(min(end, last), max(end, last), Linetype.HIDDEN, 0.0)


def _is_drawn(support: Support, point: Point, tolerance: float) -> bool:
    """Whether a support is drawn at a point, or ends right beside it."""
    at, slack = support.curve.parameter(point), tolerance / support.curve.speed
    return any(low - slack <= at <= high + slack for low, high in support.drawn())
