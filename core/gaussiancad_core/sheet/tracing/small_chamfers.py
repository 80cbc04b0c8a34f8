"""Small chamfers: the straight cut between a line that ends with nothing beyond and the next end.

A cut of a few line widths leaves too little ink of its own between two corners for a line to be
grown from.  What tells it are an end without a continuation and another end close by.  Both are
drawn without and with a straight stroke between them, from wherever on its line the first one may
turn, and compared with the sheet pixel by pixel (analysis by synthesis).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.picture_noise import (
    AROUND,
    BETTER,
    FEWEST_PIXELS,
    FINEST_STEP,
    FREE,
    LEAST_GAIN,
    LONGEST_SHORT,
)
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to, visible_leg
from gaussiancad_core.sheet.tracing.pen_profile import Pen, visible_pen
from gaussiancad_core.sheet.work_limits import ENDS

_LONGEST = 6.0
"""Line widths that a chamfer is long at most: longer ones are found as lines."""

_LONGER = 2.0
"""Times that length up to which an arc may be a chamfer's with a part of what it joins."""

_SHORTEST, _SEEN = 1.3, 0.8
"""Line widths that it is long at least, and from one seen end to the other."""

_FLATTEST, _STEEPEST = np.cos(np.radians(12.0)), np.cos(np.radians(78.0))
"""Cosines of the turns between a line and its chamfer that are looked for."""

_BACK, _ON = 1.5, 0.5
"""Line widths before and beyond a line's seen end where it may turn."""

_COARSE = 1.0
"""px between the places that are tried first."""

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class _End:
    """An end of a piece.

    Attributes:
        index: of the piece.
        at_start: whether it is the piece's start.
        place: (2,) px.
        outward: (2,) unit vector out of the piece.
        free: whether it is a line's and no other stroke is around.
    """

    index: int
    at_start: bool
    place: Floats
    outward: Floats
    free: bool


@dataclass(frozen=True)
class _Cut:
    """A straight stroke between two ends, px by which each moves outward, and what it leaves of
    the squared error."""

    first: _End
    second: _End
    shifts: tuple[float, float]
    left: float

    @property
    def ends(self) -> tuple[Floats, Floats]:
        """(2,) px of its start and of its end."""
        return _moved(self.first, self.shifts[0]), _moved(self.second, self.shifts[1])


def with_chamfers(
    weight: npt.NDArray[np.float32], placed: Sequence[Placed], stroke_width: float
) -> list[Placed]:
    """The pieces and the chamfers between their ends, which then end there.

    The ink of a chamfer and of what it joins is about as bent as that of an arc: where one was
    taken for it, what leaves less of the ink stays.

    Args:
        weight: (h, w) ink.
        placed: pieces with their ends at junctions; px, pixel centres at integers.
        stroke_width: px.
    """
    pen = visible_pen(weight, placed, stroke_width)
    pieces = _chamfered(weight, placed, stroke_width, pen)
    for arc in placed:
        if _is_short_arc(arc, stroke_width):
            others = [piece for piece in pieces if piece is not arc]
            without = _chamfered(weight, others, stroke_width, pen, arc)
            if _left(weight, without, arc, pen) < _left(weight, pieces, arc, pen):
                pieces = without
    return pieces


def _is_short_arc(placed: Placed, width: float) -> bool:
    """Whether an arc is no longer than a chamfer and a part of what it joins."""
    geometry, piece = placed
    return (
        isinstance(geometry, Circle)
        and piece.linetype is Linetype.VISIBLE
        and piece.end - piece.start <= _LONGER * max(LONGEST_SHORT, _LONGEST * width)
    )


def _left(
    weight: npt.NDArray[np.float32], pieces: Sequence[Placed], arc: Placed, pen: Pen
) -> float:
    """The squared error of the ink around an arc."""
    ends = arc[0].points_at(np.array([arc[1].start, arc[1].end]))
    pixels = _pixels_beside(weight.shape, ends, arc, pieces, pen)
    columns, rows = pixels.astype(int).T
    return float(((pen.ink(_nearest(pieces, pixels)) - weight[rows, columns]) ** 2).sum())


def _chamfered(
    weight: npt.NDArray[np.float32],
    placed: Sequence[Placed],
    stroke_width: float,
    pen: Pen,
    instead: Placed | None = None,
) -> list[Placed]:
    """The pieces with chamfers; with those ``instead`` of an arc alone where one is given."""
    ends = list(_visible_ends(placed, stroke_width))
    free = [end for end in ends if end.free]
    ahead = _ON * pen.width
    if instead is not None and free:
        away = distances_to(instead, np.array([end.place for end in free]))
        free = [end for end, far in zip(free, away, strict=True) if far <= _ON * stroke_width]
        # What an arc touched goes on below it.
        ahead = (instead[1].end - instead[1].start) / 2.0
    pieces = list(placed)
    if not free or len(free) > ENDS:
        return pieces
    taken: set[tuple[int, bool]] = set()
    for first, second in _pairs(free, ends, stroke_width):
        keys = {(end.index, end.at_start) for end in (first, second) if end.free}
        if keys & taken:
            continue
        cut = _best_cut(weight, (first, second), pieces, pen, ahead)
        if cut is None:
            continue
        taken |= keys
        for end, shift in zip((first, second), cut.shifts, strict=True):
            if end.free:
                pieces[end.index] = _lengthened(pieces[end.index], end, shift)
        pieces.append(visible_leg(*cut.ends))
    return pieces


def _visible_ends(placed: Sequence[Placed], width: float) -> Iterator[_End]:
    found: list[_End] = []
    for index, (geometry, piece) in enumerate(placed):
        whole = piece.end - piece.start >= geometry.around - 1e-6
        if piece.linetype is not Linetype.VISIBLE or whole:
            continue
        at = np.array([piece.start, piece.end])
        places, ways = geometry.points_at(at), geometry.tangents_at(at)
        found.append(_End(index, True, places[0], -ways[0], isinstance(geometry, Line)))
        found.append(_End(index, False, places[1], ways[1], isinstance(geometry, Line)))
    if not found:
        return
    away = np.array([distances_to(pair, np.array([e.place for e in found])) for pair in placed])
    away[[end.index for end in found], np.arange(len(found))] = np.inf
    for end, nearest in zip(found, away.min(axis=0), strict=True):
        yield replace(end, free=end.free and bool(nearest > FREE * width))


def _pairs(free: Sequence[_End], ends: Sequence[_End], width: float) -> Iterator[tuple[_End, _End]]:
    """A free end and another end that a chamfer may join, the nearest first."""
    longest = max(LONGEST_SHORT, _LONGEST * width)
    found = []
    for first in free:
        for second in ends:
            way = second.place - first.place
            away = float(np.hypot(*way))
            if first.index == second.index or not _SEEN * width <= away <= longest:
                continue
            if second.free and second.index < first.index:
                continue
            turns = [way @ first.outward / away]
            if second.free:
                turns.append(-way @ second.outward / away)
            if all(_STEEPEST <= turn <= _FLATTEST for turn in turns):
                found.append((away, first, second))
    for _, first, second in sorted(found, key=lambda pair: pair[0]):
        yield first, second


def _best_cut(
    weight: npt.NDArray[np.float32],
    pair: tuple[_End, _End],
    pieces: Sequence[Placed],
    pen: Pen,
    ahead: float,
) -> _Cut | None:
    """The chamfer between two ends, up to so many px ahead of them, if the ink has one."""
    first, second = pair
    pixels = _pixels_around(weight.shape, first, second, pieces, pen)
    if len(pixels) < FEWEST_PIXELS:
        return None
    columns, rows = pixels.astype(int).T
    ink = weight[rows, columns].astype(np.float64)
    others = _nearest(
        [piece for k, piece in enumerate(pieces) if k not in _turning(first, second)], pixels
    )
    tips = [
        np.minimum(others, _nearest([pieces[end.index]], pixels)) if end.free else others
        for end in (first, second)
    ]
    without = float(((pen.ink(np.minimum(*tips)) - ink) ** 2).sum())

    def left(shifts: tuple[float, float]) -> float:
        cut = _Cut(first, second, shifts, 0.0)
        distance = np.minimum(others, distances_to(visible_leg(*cut.ends), pixels))
        for end, shift in zip((first, second), shifts, strict=True):
            if end.free:
                longer = _lengthened(pieces[end.index], end, shift)
                distance = np.minimum(distance, distances_to(longer, pixels))
        return float(((pen.ink(distance) - ink) ** 2).sum())

    shifts = (0.0, 0.0)
    # No piece ends before it starts.
    most_back = [
        FINEST_STEP + piece.start - piece.end for _, piece in (pieces[end.index] for end in pair)
    ]
    reach = np.arange(-_BACK * pen.width, ahead + _COARSE, _COARSE)
    step = _COARSE
    while step >= FINEST_STEP:
        tried = [
            (np.maximum(reach + shift, back) if end.free else np.zeros(1))
            for end, shift, back in zip(pair, shifts, most_back, strict=True)
        ]
        shifts = min(((float(a), float(b)) for a in tried[0] for b in tried[1]), key=left)
        step /= 2.0
        reach = np.array([-step, 0.0, step])
    best = left(shifts)
    start, end = _Cut(first, second, shifts, best).ends
    if np.hypot(*(end - start)) < _SHORTEST * pen.width:
        return None
    if best > BETTER * without or without - best < LEAST_GAIN:
        return None
    return _Cut(first, second, shifts, best)


def _turning(first: _End, second: _End) -> set[int]:
    return {end.index for end in (first, second) if end.free}


def _pixels_around(
    shape: tuple[int, ...], first: _End, second: _End, pieces: Sequence[Placed], pen: Pen
) -> Floats:
    """(n, 2) px near a chamfer and the ends before it, away from dashes."""
    corners = np.array([first.place, second.place])
    return _pixels_beside(shape, corners, visible_leg(*corners), pieces, pen)


def _pixels_beside(
    shape: tuple[int, ...], corners: Floats, pair: Placed, pieces: Sequence[Placed], pen: Pen
) -> Floats:
    """(n, 2) px near a piece with (2, 2) px as its ends, away from dashes."""
    offset = pen.width / 2.0 + AROUND
    low = np.maximum(np.floor(corners.min(0) - 2.0 * offset), 0).astype(int)
    high = np.minimum(np.ceil(corners.max(0) + 2.0 * offset) + 1, shape[::-1]).astype(int)
    ys, xs = np.mgrid[low[1] : max(high[1], low[1]), low[0] : max(high[0], low[0])]
    pixels = np.stack([xs.ravel(), ys.ravel()], axis=1).astype(np.float64)
    near = distances_to(pair, pixels) <= offset
    dashed = [other for other in pieces if other[1].linetype is Linetype.HIDDEN]
    return pixels[near & (_nearest(dashed, pixels) > offset)]


def _nearest(pieces: Sequence[Placed], pixels: Floats) -> Floats:
    """(n,) px to the nearest of some pieces; far where there is none."""
    distance = np.full(len(pixels), 1e3)
    for piece in pieces:
        distance = np.minimum(distance, distances_to(piece, pixels))
    return distance


def _moved(end: _End, shift: float) -> Floats:
    return end.place + shift * end.outward


def _lengthened(placed: Placed, end: _End, shift: float) -> Placed:
    geometry, piece = placed
    if end.at_start:
        return geometry, replace(piece, start=piece.start - shift)
    return geometry, replace(piece, end=piece.end + shift)
