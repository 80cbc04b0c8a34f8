"""Where strokes end: at the crossings with others, not where their ink was seen to end.

The ink of a stroke ends half a stroke beyond or before the place that is meant, merges with a
tangent's, or goes on in the first dash of a hidden line.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Piece, Rhythm
from gaussiancad_core.views import Linetype

FULL_TURN = 2 * np.pi

_SEEN_BEYOND = 1.8
"""px by which a run may seem to end beyond the ink it has in common with another stroke."""

_ABUTTING = 0.75
"""px between the ends of pieces that continue each other."""

Placed = tuple[Line | Circle, Piece]
"""A piece and the shape that it is a stretch of."""

Crossing = tuple[float, float]
"""Position along a shape where another meets it, and how far their common ink reaches from it."""


def ended_at_junctions(
    pieces: Sequence[Placed], rhythm: Rhythm, stroke_width: float
) -> list[Placed]:
    """The pieces with their ends at the nearest crossings with strokes on other shapes.

    Pieces of one shape follow each other in the order of their positions.  Those of one linetype
    that end at one crossing become one.
    """
    moved: list[Placed] = []
    for geometry in dict.fromkeys(geometry for geometry, _ in pieces):
        stretches = [piece for other, piece in pieces if other == geometry]
        others = [(other, piece) for other, piece in pieces if other != geometry]
        ended = []
        for piece in stretches:
            if is_full_circle(geometry, piece):
                ended.append(piece)
                continue
            crossings = [
                crossing
                for other, stretch in others
                for crossing in _crossings(geometry, piece, other, stretch, stroke_width)
            ]
            ended.append(_end_at(piece, crossings, rhythm))
            ended[-2:] = _parted(ended[-2:], crossings, rhythm)
        moved += [(geometry, piece) for piece in _joined(ended)]
    return moved


def is_full_circle(geometry: Line | Circle, piece: Piece) -> bool:
    """Whether a piece goes once around its circle."""
    around = FULL_TURN * geometry.radius if isinstance(geometry, Circle) else np.inf
    return piece.end - piece.start >= around - 1e-6


def _end_at(piece: Piece, crossings: list[Crossing], rhythm: Rhythm) -> Piece:
    """Move the ends of a piece to the nearest crossings."""
    visible = piece.linetype is Linetype.VISIBLE
    outward = _SEEN_BEYOND if visible else 1.8 * rhythm.gap + 3.0
    start = -_nearest([(-at, reach) for at, reach in crossings], -piece.start, outward)
    end = _nearest(crossings, piece.end, outward)
    return replace(piece, start=start, end=end) if end - start > 1.0 else piece


def _nearest(crossings: list[Crossing], position: float, outward: float) -> float:
    """The crossing at which a piece that was seen to end at ``position`` really ends."""
    near = [at for at, reach in crossings if -reach - _SEEN_BEYOND <= at - position <= outward]
    return min(near, key=lambda at: abs(at - position), default=position)


def _parted(pair: list[Piece], crossings: list[Crossing], rhythm: Rhythm) -> list[Piece]:
    """A visible piece and the hidden one that continues it, parted at one place.

    A visible line is only hidden from where another crosses it.  Where none does, but one does a
    dash earlier, the first dash was taken for a part of the visible line.
    """
    if len(pair) < 2 or pair[0].linetype is pair[1].linetype:
        return pair
    first, second = pair
    if second.start - first.end > _ABUTTING:
        return pair
    visible_first = first.linetype is Linetype.VISIBLE
    at = first.end if visible_first else second.start
    if not any(abs(other - at) < reach + _SEEN_BEYOND for other, reach in crossings):
        inward = -1.0 if visible_first else 1.0
        dashes = {(other - at) * inward / rhythm.dash: other for other, _ in crossings}
        likely = min(dashes, key=lambda dash: abs(dash - 1.0), default=0.0)
        at = dashes[likely] if 0.55 < likely < 1.45 else at
    if at - first.start < 1.0 or second.end - at < 1.0:
        return pair
    return [replace(first, end=at), replace(second, start=at)]


def _joined(pieces: list[Piece]) -> list[Piece]:
    """Pieces of one linetype that continue each other as one."""
    joined: list[Piece] = []
    for piece in pieces:
        before = joined[-1] if joined else None
        if (
            before
            and before.linetype is piece.linetype
            and abs(piece.start - before.end) < _ABUTTING
        ):
            sure = max(before.confidence, piece.confidence)
            joined[-1] = replace(before, end=piece.end, confidence=sure)
        else:
            joined.append(piece)
    return joined


def _crossings(
    geometry: Line | Circle, piece: Piece, other: Line | Circle, stretch: Piece, stroke_width: float
) -> list[Crossing]:
    """Where along ``geometry`` a stretch of another shape meets it."""
    half = stroke_width / 2
    reach = half
    if isinstance(geometry, Line) and isinstance(other, Line):
        points = _line_line(geometry, other)
        # Strokes that meet at a flat angle share their ink over a longer way; runs are seen up to
        # 1 px beside the ink.
        da, db = np.array(geometry.direction), np.array(other.direction)
        sine = max(abs(da[0] * db[1] - da[1] * db[0]), 0.05)
        reach = min((half + 1.0) / sine - 1.0, 8.0 * half)
    elif isinstance(geometry, Line) and isinstance(other, Circle):
        points = _line_circle(geometry, other)
        reach = _shared_with_tangent(points, other, half)
    elif isinstance(geometry, Circle) and isinstance(other, Line):
        points = _line_circle(other, geometry)
        reach = _shared_with_tangent(points, geometry, half)
    else:
        return []
    slack = max(stroke_width, reach) + 2.0
    return [
        (_position(geometry, point, piece), reach)
        for point in points
        if stretch.start - slack <= _position(other, point, stretch) <= stretch.end + slack
    ]


def _shared_with_tangent(
    points: list[npt.NDArray[np.float64]], circle: Circle, half: float
) -> float:
    """How far from a junction a line and a circle share their ink: long if they are tangent."""
    return float(np.sqrt(2.0 * circle.radius * (half + 1.0))) if len(points) == 1 else half


def _position(geometry: Line | Circle, point: npt.NDArray[np.float64], piece: Piece) -> float:
    """Position of a point along a shape; on a circle the turn nearest to the piece's middle."""
    if isinstance(geometry, Line):
        return float(geometry.coordinates(point[None])[0][0])
    offset = point - np.array(geometry.centre)
    around = FULL_TURN * geometry.radius
    along = float(np.arctan2(offset[1], offset[0])) * geometry.radius
    middle = (piece.start + piece.end) / 2
    return along + around * round((middle - along) / around)


def _line_line(a: Line, b: Line) -> list[npt.NDArray[np.float64]]:
    da, db = np.array(a.direction), np.array(b.direction)
    cross = da[0] * db[1] - da[1] * db[0]
    if abs(cross) < 0.05:
        return []
    offset = np.array(b.point) - np.array(a.point)
    along = (offset[0] * db[1] - offset[1] * db[0]) / cross
    return [np.array(a.point) + along * da]


def _line_circle(line: Line, circle: Circle) -> list[npt.NDArray[np.float64]]:
    along, across = line.coordinates(np.array([circle.centre]))
    distance = abs(float(across[0]))
    if distance > circle.radius + 1.2:
        return []
    half = np.sqrt(max(circle.radius**2 - distance**2, 0.0))
    # Within 1.2 px a line is tangent: one junction, below the centre.
    halves = (0.0,) if abs(distance - circle.radius) < 1.2 else (-half, half)
    return [np.array(line.at(float(along[0]) + h)) for h in halves]
