"""Curves of a file that lie on one line, circle or ellipse, put together.

Exports break what was one edge: lines at every vertex, dashes of a line into lines of their own.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import StrokeRole, VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.whole_curves import Circle, Line, WholeCurve
from gaussiancad_core.sheet.file_noise import EXACT
from gaussiancad_core.sheet.vector_views.curve_intervals import Span

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Track:
    """A line, circle or ellipse, and what of it is drawn.

    Attributes:
        geometry: px of the sheet.
        solid: stretches drawn solid, as the file has them.
        hidden: stretches that the file calls hidden.
        patterned: whether any of these is longer than a dash and a gap of its own pattern: the file
            dashes them itself, and gaps between them are there.
    """

    geometry: WholeCurve
    solid: tuple[Span, ...]
    hidden: tuple[Span, ...]
    patterned: bool = False


_RoundStroke = tuple[VectorStroke, CircularArc | EllipticArc]
"""A stroke and its curve."""


def tracks_of(strokes: Sequence[VectorStroke]) -> list[Track]:
    """All lines, circles and ellipses of some strokes; chains are passed over.

    Args:
        strokes: of a view.
    """
    lines = [(stroke, stroke.curve) for stroke in strokes if isinstance(stroke.curve, LineSegment)]
    rounds = [
        (stroke, stroke.curve)
        for stroke in strokes
        if isinstance(stroke.curve, CircularArc | EllipticArc)
    ]
    return _line_tracks(lines) + _round_tracks(rounds)


def _line_tracks(strokes: Sequence[tuple[VectorStroke, LineSegment]]) -> list[Track]:
    ends = np.array([(line.start, line.end) for _, line in strokes]).reshape(-1, 2, 2)
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    free = np.ones(len(strokes), bool)
    found = []
    for seed in np.argsort(-lengths, kind="stable"):
        if free[seed]:
            members, line = _collinear(int(seed), ends, free)
            free[members] = False
            spans = np.sort(line.coordinates(ends[members].reshape(-1, 2))[0].reshape(-1, 2))
            found.append(_track(line, [strokes[index][0] for index in members], spans))
    return found


def _collinear(seed: int, ends: Floats, free: npt.NDArray[np.bool_]) -> tuple[list[int], Line]:
    """The pieces on the line through a piece, which gets surer as it grows."""
    members = [seed]
    low, high = ends[seed]
    while True:
        line = _through(low, high)
        along, across = line.coordinates(ends.reshape(-1, 2))
        along, across = along.reshape(-1, 2), across.reshape(-1, 2)
        alike = free & (np.abs(across).max(axis=1) <= EXACT)
        alike[members] = False
        first, last = line.coordinates(np.array([low, high]))[0]
        gap = np.maximum(along.min(axis=1) - last, first - along.max(axis=1))
        near = np.flatnonzero(alike)
        if not len(near):
            return members, line
        # Pieces within what is known are as sure; of those beyond the nearest comes first.
        inside = near[gap[near] <= 0.0]
        taken = inside if len(inside) else near[[int(np.argmin(gap[near]))]]
        members += taken.tolist()
        points = ends[members].reshape(-1, 2)
        positions = line.coordinates(points)[0]
        low, high = points[int(np.argmin(positions))], points[int(np.argmax(positions))]


def _through(low: Floats, high: Floats) -> Line:
    way = (high - low) / max(float(np.hypot(*(high - low))), 1e-12)
    return Line((float(low[0]), float(low[1])), (float(way[0]), float(way[1])))


def _round_tracks(strokes: Sequence[_RoundStroke]) -> list[Track]:
    groups: list[tuple[Circle | WholeEllipse, list[_RoundStroke]]] = []
    for stroke in sorted(strokes, key=lambda stroke: -stroke[1].length):
        geometry = stroke[1].carrier
        same = next((held for item, held in groups if _same(item, geometry)), None)
        if same is None:
            groups.append((geometry, [stroke]))
        else:
            same.append(stroke)
    return [
        _track(
            geometry,
            [stroke for stroke, _ in held],
            np.array([_round_span(geometry, curve) for _, curve in held]),
        )
        for geometry, held in groups
    ]


def _same(first: Circle | WholeEllipse, other: Circle | WholeEllipse) -> bool:
    if np.hypot(*np.subtract(first.centre, other.centre)) > EXACT:
        return False
    if isinstance(first, Circle) and isinstance(other, Circle):
        return abs(first.radius - other.radius) <= EXACT
    if isinstance(first, Circle) or isinstance(other, Circle):
        return False
    points = other.at(np.arange(8, dtype=np.float64) * (np.pi / 4))
    return bool(first.distances(points).max() <= EXACT)


def _round_span(geometry: Circle | WholeEllipse, curve: CircularArc | EllipticArc) -> Span:
    """Where an arc lies on its circle or ellipse; whole turns start where it starts."""
    start = float(geometry.positions(curve.vertices(np.inf)[:1])[0])
    if curve.is_closed:
        return start, start + geometry.around
    if isinstance(geometry, Circle):
        return start, start + geometry.radius * curve.sweep
    end = float(geometry.positions(curve.vertices(np.inf)[-1:])[0])
    return start, start + float(np.mod(end - start, geometry.around))


def _track(geometry: WholeCurve, strokes: Sequence[VectorStroke], spans: Floats) -> Track:
    solid: list[Span] = []
    hidden: list[Span] = []
    for stroke, (start, end) in zip(strokes, spans, strict=True):
        of = hidden if stroke.role is StrokeRole.HIDDEN else solid
        of.append((float(start), float(end)))
    patterned = any(
        stroke.role is StrokeRole.HIDDEN and 0.0 < sum(stroke.dashes[:2]) < stroke.curve.length
        for stroke in strokes
    )
    return Track(geometry, tuple(solid), tuple(hidden), patterned)
