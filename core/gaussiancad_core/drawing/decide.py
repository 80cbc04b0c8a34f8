"""Visible or hidden, decided for each line between its meetings with all others.

Between two such points a line's visibility cannot change.  Each line is therefore cut where others
cross or touch it, and sight lines beside each piece decide
(:mod:`gaussiancad_core.drawing.sightings`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.coverage import StrokeIndex, points_at
from gaussiancad_core.drawing.junctions import junctions
from gaussiancad_core.drawing.precision import Precision
from gaussiancad_core.drawing.sightings import Sighting, Witness
from gaussiancad_core.drawing.strokes import DrawnStroke, is_closed, part
from gaussiancad_core.views import Linetype

Points = npt.NDArray[np.float64]

_SHORT_SHARES = (0.438,)
_LONG_SHARES = (0.137, 0.438, 0.862)
"""Where in a piece the sight lines stand: not at middles, which symmetric parts align."""

_LONG = 60.0
"""Length in fragments from which a piece is looked at three times."""


@dataclass(frozen=True)
class _Piece:
    """A stretch of a line between two lengths, and where its samples stand in a list of all."""

    low: float
    high: float
    samples: slice


def decided(
    strokes: Sequence[DrawnStroke], witness: Witness, precision: Precision, tangent_edges: bool
) -> list[DrawnStroke]:
    """The parts of lines that are visible or hidden, with their linetypes.

    Args:
        strokes: the lines of one view, each once, in mm; their linetypes do not matter.
        witness: looks beside them.
        precision: stretches shorter than its fragment are not looked at on their own.
        tangent_edges: whether lines between faces that meet smoothly are kept.
    """
    if not strokes:
        return []
    pieces, positions = _pieces(strokes, precision)
    points, normals = [], []
    for stroke, own in zip(strokes, pieces, strict=True):
        at = positions[own[0].samples.start : own[-1].samples.stop]
        points.append(points_at(stroke, at))
        normals.append(_normals_at(stroke, at, precision.fragment))
    sightings = witness.sightings(np.concatenate(points), np.concatenate(normals))
    result: list[DrawnStroke] = []
    for stroke, own in zip(strokes, pieces, strict=True):
        kinds = [_linetype(sightings[piece.samples], tangent_edges) for piece in own]
        result.extend(_runs(stroke, own, kinds))
    return result


def _runs(
    stroke: DrawnStroke, pieces: Sequence[_Piece], kinds: Sequence[Linetype | None]
) -> list[DrawnStroke]:
    """One stroke for every run of pieces of one kind."""
    runs: list[tuple[float, float, Linetype | None]] = []
    for piece, kind in zip(pieces, kinds, strict=True):
        if runs and runs[-1][2] is kind:
            runs[-1] = (runs[-1][0], piece.high, kind)
        else:
            runs.append((piece.low, piece.high, kind))
    if len(runs) > 1 and is_closed(stroke) and runs[0][2] is runs[-1][2]:
        # The run that goes over the start of a closed line.
        last = runs.pop()
        runs[0] = (last[0] - stroke.length, runs[0][1], last[2])
    return [replace(part(stroke, low, high), linetype=kind) for low, high, kind in runs if kind]


def _pieces(
    strokes: Sequence[DrawnStroke], precision: Precision
) -> tuple[list[list[_Piece]], Points]:
    """The pieces of each stroke, and the (n,) lengths along the strokes of all their samples."""
    pieces: list[list[_Piece]] = []
    positions: list[float] = []
    index = StrokeIndex(strokes)
    for stroke in strokes:
        own: list[_Piece] = []
        for low, high in pairwise(_bounds(stroke, index, precision)):
            long = high - low > _LONG * precision.fragment
            shares = _LONG_SHARES if long else _SHORT_SHARES
            first = len(positions)
            positions.extend(low + share * (high - low) for share in shares)
            own.append(_Piece(float(low), float(high), slice(first, len(positions))))
        pieces.append(own)
    return pieces, np.array(positions)


def _bounds(stroke: DrawnStroke, index: StrokeIndex, precision: Precision) -> list[float]:
    """The stroke's ends and, between them, its junctions that are further apart than a fragment."""
    length = stroke.length
    bounds = [0.0]
    for at in junctions(stroke, index, 4.0 * precision.fit):
        if at - bounds[-1] >= precision.fragment and length - at >= precision.fragment:
            bounds.append(float(at))
    return [*bounds, length]


def _normals_at(stroke: DrawnStroke, positions: Points, step: float) -> Points:
    """(n, 2) unit vectors across a stroke."""
    half = min(step, stroke.length / 4.0) / 2.0
    middle = np.clip(positions, half, stroke.length - half)
    way = points_at(stroke, middle + half) - points_at(stroke, middle - half)
    way /= np.hypot(*way.T)[:, None]
    return np.stack([-way[:, 1], way[:, 0]], axis=1)


def _linetype(sightings: Sequence[Sighting], tangent_edges: bool) -> Linetype | None:
    """What the majority saw."""
    visible = sightings.count(Sighting.VISIBLE)
    hidden = sightings.count(Sighting.HIDDEN)
    if tangent_edges and not visible and not hidden:
        visible = sightings.count(Sighting.SMOOTH_VISIBLE)
        hidden = sightings.count(Sighting.SMOOTH_HIDDEN)
    if not visible and not hidden:
        return None
    return Linetype.VISIBLE if visible >= hidden else Linetype.HIDDEN
