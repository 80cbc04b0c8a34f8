"""Each line of a view once: pieces on one support merged, nothing hidden under what is visible.

Pieces that lie on one straight line or one circle become intervals of that support.  Visible
intervals are united; hidden ones are united and lose what is visible.  Chains are compared by
distance.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.intervals import (
    Interval,
    subtract,
    unite,
    unite_on_circle,
)
from gaussiancad_core.drawing.strokes import DrawnStroke, Polyline
from gaussiancad_core.views import Arc, Linetype, Segment

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


def clean_strokes(
    strokes: Iterable[DrawnStroke], tolerance: float, fragment: float
) -> tuple[DrawnStroke, ...]:
    """Merge what coincides, keep what is seen.

    Args:
        strokes: in mm, in any order.
        tolerance: mm between strokes that count as one.
        fragment: mm; shorter strokes are dropped, shorter gaps are closed.

    Returns:
        Straight strokes, then arcs, then chains; visible before hidden on each support.
    """
    pieces = list(strokes)
    # Long pieces define the supports: the direction of a short one says little.
    pieces.sort(key=lambda piece: -piece.length)
    lines = _line_supports([p for p in pieces if isinstance(p, Segment)], tolerance)
    circles = _circle_supports([p for p in pieces if isinstance(p, Arc)], tolerance)
    result: list[DrawnStroke] = []
    for line in lines:
        result.extend(_line_strokes(line, fragment))
    for circle in circles:
        result.extend(_circle_strokes(circle, fragment))
    chains = [piece for piece in pieces if isinstance(piece, Polyline)]
    result.extend(_clean_chains(chains, tolerance, fragment))
    return tuple(result)


def _line_supports(pieces: list[Segment], tolerance: float) -> list[_Line]:
    supports: list[_Line] = []
    for piece in pieces:
        support = next(
            (
                line
                for line in supports
                if line.distance(piece.start) < tolerance
                and line.distance(piece.end) < tolerance
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
        support = next(
            (circle for circle in supports if circle.holds(piece, tolerance)), None
        )
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
    turned = [
        (low + turn, high + turn)
        for low, high in visible
        for turn in (-_TURN, 0.0, _TURN)
    ]
    hidden = subtract(
        unite_on_circle(circle.intervals[Linetype.HIDDEN], gap), unite(turned, gap)
    )
    return [
        Arc(circle.centre, circle.radius, low % _TURN, min(high - low, _TURN), linetype)
        for linetype, intervals in (
            (Linetype.VISIBLE, visible),
            (Linetype.HIDDEN, hidden),
        )
        for low, high in intervals
        if high - low >= gap
    ]


def _clean_chains(
    chains: list[Polyline], tolerance: float, fragment: float
) -> list[Polyline]:
    """Visible chains first, the longest first; each keeps what no earlier one covers."""
    kept: list[Polyline] = []
    ordered = sorted(chains, key=lambda chain: chain.linetype is Linetype.HIDDEN)
    for chain in ordered:
        for run in _uncovered_runs(chain, kept, tolerance):
            if run.length >= fragment:
                kept.append(run)
    return kept


def _uncovered_runs(
    chain: Polyline, kept: list[Polyline], tolerance: float
) -> list[Polyline]:
    if not kept:
        return [chain]
    points = np.array(chain.points)
    middles = (points[:-1] + points[1:]) / 2.0
    covered = np.zeros(len(middles), dtype=bool)
    for other in kept:
        covered |= _distances(middles, np.array(other.points)) < tolerance
    runs: list[Polyline] = []
    start: int | None = None
    for index, hidden in enumerate([*covered, True]):
        if not hidden and start is None:
            start = index
        elif hidden and start is not None:
            runs.append(Polyline(chain.points[start : index + 1], chain.linetype))
            start = None
    return runs


def _distances(
    points: npt.NDArray[np.float64], chain: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """(n,) distance of (n, 2) points from a chain of (m, 2) vertices."""
    starts, spans = chain[:-1], np.diff(chain, axis=0)
    squares = np.maximum((spans**2).sum(axis=1), 1e-300)
    offsets = points[:, None, :] - starts[None]
    shares = np.clip((offsets * spans).sum(axis=2) / squares, 0.0, 1.0)
    nearest = offsets - shares[..., None] * spans
    return np.sqrt((nearest**2).sum(axis=2).min(axis=1))
