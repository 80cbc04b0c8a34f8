"""Each line of a view once: pieces on one support merged, nothing hidden under what is visible.

Pieces that lie on one straight line or one circle become intervals of that support.  Visible
intervals are united; hidden ones are united and lose what is visible.  Chains are compared by
distance (:mod:`gaussiancad_core.lines.coverage`).
"""

from collections.abc import Iterable
from math import hypot

from gaussiancad_core.geometry.intervals import (
    Interval,
    subtract,
    unite,
    unite_on_circle,
)
from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.lines.coverage import StrokeIndex, uncovered
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Arc, Linetype, Segment

_Intervals = dict[Linetype, list[Interval]]
"""What is drawn along a support: lengths of a line, angles of a circle."""


def distinct_strokes(
    strokes: Iterable[DrawnStroke], precision: Precision
) -> tuple[DrawnStroke, ...]:
    """Merge what lies on one line or circle, and drop chains that run along others all the way.

    Args:
        strokes: in mm, in any order.
        precision: what counts as coincident, and as too short to draw.
    """
    kept: list[DrawnStroke] = []
    index = StrokeIndex()
    for stroke in sorted(_merged(strokes, precision), key=_precedence):
        near = index.near(stroke, precision.cover)
        if isinstance(stroke, Polyline) and not uncovered(stroke, near, precision):
            continue
        kept.append(stroke)
        index.add(stroke)
    return tuple(kept)


def clean_strokes(strokes: Iterable[DrawnStroke], precision: Precision) -> tuple[DrawnStroke, ...]:
    """Merge what coincides, keep what is seen.

    Args:
        strokes: in mm, in any order.
        precision: what counts as coincident, and as too short to draw.

    Returns:
        Visible strokes, then hidden ones; lines and arcs before chains.
    """
    kept: list[DrawnStroke] = []
    everything, chains = StrokeIndex(), StrokeIndex()
    for stroke in sorted(_merged(strokes, precision), key=_precedence):
        # Lines and circles have been compared by their supports.
        index = everything if isinstance(stroke, Polyline) else chains
        for left in uncovered(stroke, index.near(stroke, precision.cover), precision):
            kept.append(left)
            everything.add(left)
            if isinstance(left, Polyline):
                chains.add(left)
    return tuple(kept)


def _precedence(stroke: DrawnStroke) -> tuple[bool, bool]:
    return stroke.linetype is Linetype.HIDDEN, isinstance(stroke, Polyline)


def _merged(strokes: Iterable[DrawnStroke], precision: Precision) -> list[DrawnStroke]:
    """Lines and circles merged by their supports, and the chains as they are."""
    tolerance = 4.0 * precision.fit
    # Long pieces define the supports: the direction of a short one says little.
    pieces = sorted(strokes, key=lambda piece: -piece.length)
    segments = [p for p in pieces if isinstance(p, Segment) and p.length > 0.0]
    lines = _line_supports(segments, tolerance)
    circles = _circle_supports([p for p in pieces if isinstance(p, Arc)], tolerance)
    merged: list[DrawnStroke] = []
    for line, drawn in lines.items():
        merged.extend(_line_strokes(line, drawn, precision.fragment))
    for circle, drawn in circles.items():
        merged.extend(_circle_strokes(circle, drawn, precision.fragment))
    return merged + [piece for piece in pieces if isinstance(piece, Polyline)]


def _line_supports(pieces: list[Segment], tolerance: float) -> dict[Line, _Intervals]:
    supports: dict[Line, _Intervals] = {}
    for piece in pieces:
        ends = piece.start, piece.end
        holding = (line for line in supports if max(map(line.distance, ends)) < tolerance)
        line = next(holding, piece.carrier)
        intervals = supports.setdefault(line, {kind: [] for kind in Linetype})
        low, high = sorted(map(line.parameter, ends))
        intervals[piece.linetype].append((low, high))
    return supports


def _line_strokes(line: Line, drawn: _Intervals, fragment: float) -> list[Segment]:
    visible = unite(drawn[Linetype.VISIBLE], fragment)
    hidden = subtract(unite(drawn[Linetype.HIDDEN], fragment), visible)
    return [
        Segment(line.at(low), line.at(high), linetype)
        for linetype, intervals in ((Linetype.VISIBLE, visible), (Linetype.HIDDEN, hidden))
        for low, high in intervals
        if high - low >= fragment
    ]


def _circle_supports(pieces: list[Arc], tolerance: float) -> dict[Circle, _Intervals]:
    supports: dict[Circle, _Intervals] = {}
    for piece in pieces:
        holding = (circle for circle in supports if _apart(circle, piece.carrier) < tolerance)
        intervals = supports.setdefault(
            next(holding, piece.carrier), {kind: [] for kind in Linetype}
        )
        intervals[piece.linetype].append((piece.start_angle, piece.start_angle + piece.sweep))
    return supports


def _apart(one: Circle, other: Circle) -> float:
    """The farthest that two circles are from each other."""
    away = hypot(one.centre[0] - other.centre[0], one.centre[1] - other.centre[1])
    return away + abs(one.radius - other.radius)


def _circle_strokes(circle: Circle, drawn: _Intervals, fragment: float) -> list[Arc]:
    gap = fragment / circle.radius
    visible = unite_on_circle(drawn[Linetype.VISIBLE], gap)
    # The visible angles are repeated a turn further on, where hidden ones may run over zero.
    turned = [
        (low + turn, high + turn) for low, high in visible for turn in (-FULL_TURN, 0.0, FULL_TURN)
    ]
    hidden = subtract(unite_on_circle(drawn[Linetype.HIDDEN], gap), unite(turned, gap))
    return [
        Arc(circle.centre, circle.radius, low % FULL_TURN, min(high - low, FULL_TURN), linetype)
        for linetype, intervals in ((Linetype.VISIBLE, visible), (Linetype.HIDDEN, hidden))
        for low, high in intervals
        if high - low >= gap
    ]
