"""Each line of a view once: pieces on one support merged, nothing hidden under what is visible.

Pieces that lie on one straight line or one circle become intervals of that support.  Visible
intervals are united; hidden ones are united and lose what is visible.  Chains are compared by
distance (:mod:`gaussiancad_core.lines.coverage`).
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.intervals import (
    Interval,
    subtract,
    unite,
    unite_on_circle,
)
from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.lines.coverage import StrokeIndex, uncovered
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Arc, Linetype, Segment

_TURN = 2.0 * np.pi


@dataclass
class _Line:
    """A straight support: base point, unit direction, and the intervals drawn along it."""

    base: npt.NDArray[np.float64]
    direction: npt.NDArray[np.float64]
    intervals: dict[Linetype, list[Interval]] = field(
        default_factory=lambda: {kind: [] for kind in Linetype}
    )

    def along(self, point: tuple[float, float]) -> float:
        return float((np.array(point) - self.base) @ self.direction)

    def distance(self, point: tuple[float, float]) -> float:
        offset = np.array(point) - self.base
        return float(abs(offset[0] * self.direction[1] - offset[1] * self.direction[0]))

    def point(self, at: float) -> tuple[float, float]:
        point = self.base + at * self.direction
        return float(point[0]), float(point[1])


@dataclass
class _Circle:
    """A circular support: centre, radius, and the angles drawn along it."""

    centre: tuple[float, float]
    radius: float
    intervals: dict[Linetype, list[Interval]] = field(
        default_factory=lambda: {kind: [] for kind in Linetype}
    )

    def holds(self, arc: Arc, tolerance: float) -> bool:
        apart = np.hypot(arc.centre[0] - self.centre[0], arc.centre[1] - self.centre[1])
        return bool(apart + abs(arc.radius - self.radius) < tolerance)


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
    lines = _line_supports([p for p in pieces if isinstance(p, Segment)], tolerance)
    circles = _circle_supports([p for p in pieces if isinstance(p, Arc)], tolerance)
    merged: list[DrawnStroke] = []
    for line in lines:
        merged.extend(_line_strokes(line, precision.fragment))
    for circle in circles:
        merged.extend(_circle_strokes(circle, precision.fragment))
    return merged + [piece for piece in pieces if isinstance(piece, Polyline)]


def _line_supports(pieces: list[Segment], tolerance: float) -> list[_Line]:
    supports: list[_Line] = []
    for piece in pieces:
        support = next(
            (
                line
                for line in supports
                if line.distance(piece.start) < tolerance and line.distance(piece.end) < tolerance
            ),
            None,
        )
        if support is None:
            base = np.array(piece.start)
            direction = (np.array(piece.end) - base) / piece.length
            support = _Line(base, direction)
            supports.append(support)
        ends = sorted((support.along(piece.start), support.along(piece.end)))
        support.intervals[piece.linetype].append((ends[0], ends[1]))
    return supports


def _line_strokes(line: _Line, fragment: float) -> list[Segment]:
    visible = unite(line.intervals[Linetype.VISIBLE], fragment)
    hidden = subtract(unite(line.intervals[Linetype.HIDDEN], fragment), visible)
    return [
        Segment(line.point(low), line.point(high), linetype)
        for linetype, intervals in (
            (Linetype.VISIBLE, visible),
            (Linetype.HIDDEN, hidden),
        )
        for low, high in intervals
        if high - low >= fragment
    ]


def _circle_supports(pieces: list[Arc], tolerance: float) -> list[_Circle]:
    supports: list[_Circle] = []
    for piece in pieces:
        support = next((circle for circle in supports if circle.holds(piece, tolerance)), None)
        if support is None:
            support = _Circle(piece.centre, piece.radius)
            supports.append(support)
        support.intervals[piece.linetype].append(
            (piece.start_angle, piece.start_angle + piece.sweep)
        )
    return supports


def _circle_strokes(circle: _Circle, fragment: float) -> list[Arc]:
    gap = fragment / circle.radius
    visible = unite_on_circle(circle.intervals[Linetype.VISIBLE], gap)
    # The visible angles are repeated a turn further on, where hidden ones may run over zero.
    turned = [(low + turn, high + turn) for low, high in visible for turn in (-_TURN, 0.0, _TURN)]
    hidden = subtract(unite_on_circle(circle.intervals[Linetype.HIDDEN], gap), unite(turned, gap))
    return [
        Arc(circle.centre, circle.radius, low % _TURN, min(high - low, _TURN), linetype)
        for linetype, intervals in (
            (Linetype.VISIBLE, visible),
            (Linetype.HIDDEN, hidden),
        )
        for low, high in intervals
        if high - low >= gap
    ]
