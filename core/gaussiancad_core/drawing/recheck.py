"""Visible or hidden, decided anew for each line between its crossings with all others.

OpenCASCADE's algorithm finds the lines of a drawing, but now and then calls a visible one hidden or
the other way round.  Each line is therefore cut where others meet it, and sight lines beside each
piece decide (:mod:`gaussiancad_core.drawing.sightings`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.coverage import points_at
from gaussiancad_core.drawing.junctions import junctions
from gaussiancad_core.drawing.precision import Precision
from gaussiancad_core.drawing.sightings import Sighting, Witness
from gaussiancad_core.drawing.strokes import DrawnStroke, part
from gaussiancad_core.views import Linetype

Points = npt.NDArray[np.float64]

_SHORT_SHARES = (0.438,)
_LONG_SHARES = (0.137, 0.438, 0.862)
"""Where in a piece the sight lines stand: not at middles, which symmetric parts align."""

_LONG = 60.0
"""Length in fragments from which a piece is looked at three times."""


@dataclass(frozen=True)
class _Piece:
    stroke: DrawnStroke
    low: float
    high: float
    samples: slice


def rechecked(
    strokes: Sequence[DrawnStroke],
    witness: Witness,
    precision: Precision,
    keep_blank: bool,
) -> list[DrawnStroke]:
    """The same lines in pieces whose linetypes are what sight lines say.

    Args:
        strokes: the lines of one view, each once, in mm.
        witness: looks beside them.
        precision: pieces shorter than its fragment are not looked at on their own.
        keep_blank: whether a piece that sight lines see nothing at keeps its linetype, as smooth
            edges do, or is left out.
    """
    pieces, positions = _pieces(strokes, precision)
    if not pieces:
        return []
    points, normals = [], []
    for piece in pieces:
        at = positions[piece.samples]
        points.append(points_at(piece.stroke, at))
        normals.append(_normals_at(piece.stroke, at, precision.fragment))
    sightings = witness.sightings(np.concatenate(points), np.concatenate(normals))
    result = []
    for piece in pieces:
        linetype = _decided(sightings[piece.samples], piece.stroke.linetype, keep_blank)
        if linetype is not None:
            cut = part(piece.stroke, piece.low, piece.high)
            result.append(replace(cut, linetype=linetype))
    return result


def _pieces(
    strokes: Sequence[DrawnStroke], precision: Precision
) -> tuple[list[_Piece], Points]:
    pieces: list[_Piece] = []
    positions: list[float] = []
    for stroke in strokes:
        bounds = _bounds(stroke, strokes, precision)
        for low, high in pairwise(bounds):
            long = high - low > _LONG * precision.fragment
            shares = _LONG_SHARES if long else _SHORT_SHARES
            first = len(positions)
            positions.extend(low + share * (high - low) for share in shares)
            pieces.append(
                _Piece(stroke, float(low), float(high), slice(first, len(positions)))
            )
    return pieces, np.array(positions)


def _bounds(
    stroke: DrawnStroke, strokes: Sequence[DrawnStroke], precision: Precision
) -> list[float]:
    """The stroke's ends and, between them, its junctions that are further apart than a fragment."""
    length = stroke.length
    bounds = [0.0]
    for at in junctions(stroke, strokes, 4.0 * precision.fit):
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


def _decided(
    sightings: Sequence[Sighting], before: Linetype, keep_blank: bool
) -> Linetype | None:
    """The majority of what was seen; what cannot be seen stays as it was."""
    visible = sum(sighting is Sighting.VISIBLE for sighting in sightings)
    hidden = sum(sighting is Sighting.HIDDEN for sighting in sightings)
    if visible or hidden:
        return Linetype.VISIBLE if visible >= hidden else Linetype.HIDDEN
    if Sighting.UNCERTAIN in sightings or keep_blank:
        return before
    return None
