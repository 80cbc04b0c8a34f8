"""Short visible strokes from the corner of two others to the corner of two others, or between ends
that are free.

Where the walls of a pocket or of a boss taper, an edge leads from each corner of its rim to one
of its floor.  Where these lie a few line widths beside each other, most of the edge's ink is that
of the four strokes it joins: too little is its own for a line to be grown from.  So it is with a
step of an outline between two slanted edges.  All is known of such a stroke but whether it is
there: it is drawn with the sheet's pen and compared with the ink.
"""

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.jogs import distances_to
from gaussiancad_core.sheet.leftover import Leftover, leftover_ink
from gaussiancad_core.sheet.runs import Piece
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.sheet.stubs import Placed
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]

_SHORTEST, _LONGEST = 2.0, 7.0
"""Line widths from corner to corner."""

_SAME = 1.0
"""px between ends of strokes that are one corner."""

_FREE = 2.0
"""px from an end within which no other stroke lies where it is free."""

_LEVEL = 0.36
"""Sine of the angle to an axis up to which a stroke between free ends runs along it: they were seen
to end up to two px beyond it."""

_STEEPEST = 0.95
"""Cosine of the angle to the strokes of its corners under which an edge has ink of its own."""

_KNOWN = 0.6
"""Line widths within which a stroke that was found has its ink."""

_DARK, _STEP = 0.5, 0.25
"""Weight from which a place is ink, and px between the places that are looked at."""

_AROUND = 1.5
"""px beyond half a line within which the ink is compared."""

_EXPLAINED, _LEAST = 0.35, 2.0
"""Share of the squared error without an edge that is left with it, at most; that error in full
pixels, at least."""

_CONFIDENCE = 0.7


def find_corner_rungs(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """Straight visible strokes between corners close by.

    Args:
        pieces: of a view, with their ends at junctions; px, pixel centres at integers.
        sheet: its ink.

    Returns:
        Lines from corner to corner.
    """
    found: list[Placed] = []
    left: Leftover | None = None
    for start, end in _ways(pieces, sheet):
        left = left or leftover_ink(pieces, sheet)
        if _is_drawn(start, end, left, sheet):
            length = float(np.hypot(*(end - start)))
            x, y = ((end - start) / length).tolist()
            line = Line((float(start[0]), float(start[1])), (x, y))
            found.append((line, Piece(0.0, length, Linetype.VISIBLE, _CONFIDENCE)))
    return found


def _ways(pieces: Sequence[Placed], sheet: CleanSheet) -> Iterator[tuple[Floats, Floats]]:
    """(2,) px of pairs of corners with ink all along between them that no piece runs along."""
    from scipy.spatial import cKDTree

    corners = list(_corners(pieces))
    if len(corners) < 2:
        return
    places = np.array([place for place, _ in corners])
    width = sheet.stroke_width
    pairs = cKDTree(places).query_pairs(_LONGEST * width, output_type="ndarray")
    for i, k in pairs[np.lexsort(pairs.T)]:
        start, end = places[i], places[k]
        if len(corners[i][1]) == len(corners[k][1]) == 1:
            start, end = _levelled(start, end)
        length = float(np.hypot(*(end - start)))
        if length < _SHORTEST * width:
            continue
        way = (end - start) / length
        if any(abs(float(own @ way)) > _STEEPEST for c in (i, k) for own in corners[c][1]):
            continue
        points = start + np.arange(0.0, length, _STEP)[:, None] * way
        if (sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] <= _DARK).any():
            continue
        middle = (start + end)[None] / 2.0
        if min(distances_to(own, middle)[0] for own in pieces) > _KNOWN * width:
            yield start, end


def _corners(pieces: Sequence[Placed]) -> Iterator[tuple[Floats, list[Floats]]]:
    """(2,) px of where straight visible strokes in two directions end, or one that meets nothing,
    and (2,) their directions."""
    ends = [
        (np.array(line.at(at)), np.array(line.direction))
        for line, piece in pieces
        if isinstance(line, Line) and piece.linetype is Linetype.VISIBLE
        for at in (piece.start, piece.end)
    ]
    left = list(range(len(ends)))
    places = np.array([place for place, _ in ends]).reshape(-1, 2)
    while left:
        own = [k for k in left if np.hypot(*(places[k] - places[left[0]])) <= _SAME]
        left = [k for k in left if k not in own]
        ways = [ends[k][1] for k in own]
        place = places[own].mean(0)
        if len(own) == 1:
            met = [p for p in pieces if distances_to(p, place[None])[0] <= _FREE]
            ways += _passing(place, met)
            if len(met) > 1 and len(ways) == 1:
                continue
            yield place, ways
        elif any(abs(float(ways[0] @ way)) < _STEEPEST for way in ways[1:]):
            yield place, ways


def _passing(place: Floats, met: Sequence[Placed]) -> list[Floats]:
    """(2,) directions of straight visible strokes that pass by the end of another."""
    return [
        np.array(line.direction)
        for line, piece in met
        if isinstance(line, Line)
        and piece.linetype is Linetype.VISIBLE
        and distances_to((line, piece), place[None])[0] <= _SAME
        and piece.start + _FREE < float(line.coordinates(place[None])[0][0]) < piece.end - _FREE
    ]


def _levelled(start: Floats, end: Floats) -> tuple[Floats, Floats]:
    """Ends of a stroke along an axis, halfway between both, if they lie nearly on one."""
    way = np.abs(end - start)
    across = int(np.argmin(way))
    if way[across] > _LEVEL * np.hypot(*way):
        return start, end
    start, end = start.copy(), end.copy()
    start[across] = end[across] = (start[across] + end[across]) / 2.0
    return start, end


def _is_drawn(start: Floats, end: Floats, left: Leftover, sheet: CleanSheet) -> bool:
    """Whether a stroke from (2,) px to (2,) px has the ink that others leave beside it."""
    reach = sheet.stroke_width / 2.0 + _AROUND
    low = np.maximum(np.floor(np.minimum(start, end) - reach), 0).astype(int)
    high = np.ceil(np.maximum(start, end) + reach).astype(int) + 1
    part = slice(low[1], high[1]), slice(low[0], high[0])
    ink, others = sheet.weight[part], left.expected[part]
    rows, columns = np.indices(ink.shape)
    places = np.stack([columns, rows], axis=-1) + low - start
    length = float(np.hypot(*(end - start)))
    along = np.clip(places @ (end - start) / length, 0.0, length)
    away = np.hypot(*np.moveaxis(places - along[..., None] * (end - start) / length, -1, 0))
    near = away <= reach
    drawn = np.maximum(left.pen.ink(away), others)
    without = float(((others - ink)[near] ** 2).sum())
    return without >= _LEAST and float(((drawn - ink)[near] ** 2).sum()) <= _EXPLAINED * without
