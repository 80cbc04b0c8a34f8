"""Hidden lines that go on for less than a dash behind the edge that they seem to end at.

The bore of a chamfered ring passes the edge of the chamfer and ends at the face a few px beyond.
No dash need be whole there, and what is left of one is as short as noise; but it lies on the line,
with paper on both sides, before the next edge.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import CLEAR, FINE_STEP, ONE_PLACE
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.votes import MOST, NEARLY_ALL

Floats = npt.NDArray[np.float64]

_BESIDE = 1.5
"""px beside a line's own ink where its flanks are."""

_DARKER = 0.25
"""Weight by which ink on the line exceeds that of both flanks."""

_SHORTEST = 1.5
"""px of such ink at least, in one piece or at both edges."""

_WHOLE = 0.6
"""Dashes from which such a stretch that is inked is rather an edge that goes on as the hidden line.
"""

_MOST = 3
"""Edges, one behind the other, that an end is led past at most."""


def with_ends_behind_edges(
    pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm
) -> list[Placed]:
    """The pieces, hidden lines led on past edges where their ink goes on to the next one.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.
        rhythm: of its dashes.
    """
    led = list(pieces)
    for index, (line, piece) in enumerate(pieces):
        if not isinstance(line, Line) or piece.linetype is not Linetype.HIDDEN:
            continue
        others = [pair for k, pair in enumerate(led) if k != index]
        start, end = (
            _led(line, stated, others, sheet, rhythm)
            for stated in ((piece.start, -1.0), (piece.end, 1.0))
        )
        led[index] = line, replace(piece, start=start, end=end)
    return led


def _led(
    line: Line,
    end: tuple[float, float],
    others: Sequence[Placed],
    sheet: CleanSheet,
    rhythm: Rhythm,
) -> float:
    """Where a line ends, past the edges behind which its ink goes on."""
    at, way = end
    for _ in range(_MOST):
        further = _next_edge(line, (at, way), others, sheet, rhythm)
        if further is None:
            break
        at = further
    return at


def _next_edge(
    line: Line,
    end: tuple[float, float],
    others: Sequence[Placed],
    sheet: CleanSheet,
    rhythm: Rhythm,
) -> float | None:
    """Where a line meets the next edge behind the one that it ends at, if its ink leads there.

    The end is told by its position and the sign of outwards.
    """
    at, way = end
    reach = rhythm.dash + 2.0 * rhythm.gap
    ahead = at + way * np.arange(0.0, reach, FINE_STEP)
    points = line.points_at(ahead)
    corner = points[:1]
    near = [
        other
        for other in others
        if distances_to(other, points[len(points) // 2][None])[0] <= 2.0 * reach
    ]
    away = np.array([distances_to(pair, points) for pair in near]).reshape(len(near), len(points))
    edges = np.array([piece.linetype is Linetype.VISIBLE for _, piece in near], dtype=bool)
    left = np.array([distances_to(pair, corner)[0] <= ONE_PLACE for pair in near], dtype=bool)
    if not (edges & left).any():
        return None
    met = (edges & ~left)[:, None] & (away <= ONE_PLACE / 2.0)
    places = np.flatnonzero(met.any(axis=0))
    if not len(places):
        return None
    first = int(np.argmax(met[:, places[0]]))
    target = places[0] + int(np.argmin(away[first, places[0] :]))
    # Ink beside edges and along other hidden lines is theirs.
    half = sheet.stroke_width / 2.0 + CLEAR
    clear = (away[:, :target] > half).all(axis=0)
    if clear.sum() < MOST * (target - 2.0 * half / FINE_STEP):
        return None
    inked = _inked(line, points[:target][clear], sheet)
    if inked.sum() * FINE_STEP < _SHORTEST:
        return None
    solid = inked.mean() >= NEARLY_ALL and len(inked) * FINE_STEP >= _WHOLE * rhythm.dash
    return None if solid else float(ahead[target])


def _inked(line: Line, points: Floats, sheet: CleanSheet) -> npt.NDArray[np.bool_]:
    """(n,) whether there is ink at points (n, 2) px of a line, and paper on both sides of it."""
    if not len(points):
        return np.zeros(0, dtype=bool)
    dx, dy = line.direction
    normal = np.array([-dy, dx])
    offsets = np.array([-0.5, 0.0, 0.5])
    flank = sheet.stroke_width / 2.0 + _BESIDE
    item = _weights(points, offsets, normal, sheet).mean(axis=1)
    neighbour = _weights(points, np.array([-flank, flank]), normal, sheet).max(axis=1)
    return item - neighbour > _DARKER


def _weights(
    points: Floats, offsets: Floats, normal: Floats, sheet: CleanSheet
) -> npt.NDArray[np.float32]:
    """(n, m) weights of the ink at points, shifted by offsets along a normal."""
    places = points[:, None] + offsets[None, :, None] * normal
    return sample(sheet.weight, places[..., 0], places[..., 1])
