"""Chamfers about as small as the pen is wide, told by the edge that they make.

The ink of such a cut is one with that of the corner's lines, which seem to meet.  But beside the
one line runs the edge where the chamfer begins, and it ends on the other one: where, is known
exactly.  With this the corner is drawn cut, by how much along the first line is fitted, and sharp,
in the ways that pens and printers join lines, and compared with the sheet pixel by pixel (analysis
by synthesis).  A fillet of this size has no edge.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.picture_noise import FEWEST_PIXELS, FINEST_STEP
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.corners import Corner, End, from_joins
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to, visible_leg
from gaussiancad_core.sheet.tracing.pen_profile import Pen, visible_pen
from gaussiancad_core.sheet.tracing.small_fillets import open_corners, straight_ends

_SHORTEST, _LEAST_SHORTEST, _LONGEST = 0.8, 2.2, 2.0
"""Line widths, and px at least, from the corner to the edge; line widths at most: longer chamfers
leave ends of lines with nothing beyond."""

_MEETING = 0.6
"""Line widths within which the edge ends at a line of the corner, and beyond where the chamfer
begins."""

_PARALLEL = 0.02
"""Sine of the angle between the edge and the line beside it, at most."""

_SQUARE = 0.1
"""Cosine of the angle between the lines of the corner, at most."""

_FLATTEST, _STEEPEST = 0.4, 2.5
"""Times the length along the one line that a chamfer has along the other."""

_EVEN = 0.35
"""Share of the squared error of a sharp corner up to which an even chamfer is one."""

_BETTER, _LEAST_GAIN = 0.4, 1.0
"""Share of a sharp corner's squared error that a cut one leaves at most; squared ink, in full
pixels, that it explains at least."""

_AROUND = 2.0
"""px beside the ink of the corner that are compared."""

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class _Edged:
    """A corner with an edge beside one of its lines.

    Attributes:
        neighbour: the end at the corner of the line along which the edge runs.
        across: the end at the corner of the line that the edge ends on.
        corner: of the two.
        away: px from the corner to the edge.
    """

    neighbour: End
    across: End
    corner: Corner
    away: float


def with_edged_chamfers(
    weight: npt.NDArray[np.float32], placed: Sequence[Placed], stroke_width: float
) -> tuple[list[Placed], list[Placed]]:
    """The pieces, which end at chamfers beside whose edges they end, with these; and these alone.

    Args:
        weight: (h, w) ink.
        placed: pieces with their ends at junctions; px, pixel centres at integers.
        stroke_width: px.
    """
    pieces = list(placed)
    edged = list(_edged_corners(pieces, stroke_width))
    if not edged:
        return pieces, []
    chamfers: list[Placed] = []
    pen = visible_pen(weight, placed, stroke_width)
    for this_edged in sorted(edged, key=lambda item: item.away):
        length = _length(weight, this_edged, pieces, pen)
        if length is None:
            continue
        start = this_edged.corner.place + this_edged.away * this_edged.across.inward
        end = this_edged.corner.place + length * this_edged.neighbour.inward
        pieces[this_edged.across.index] = _ended_at(
            pieces[this_edged.across.index], this_edged.across, start
        )
        pieces[this_edged.neighbour.index] = _ended_at(
            pieces[this_edged.neighbour.index], this_edged.neighbour, end
        )
        chamfers.append(visible_leg(start, end))
        pieces.append(chamfers[-1])
    return pieces, chamfers


def _edged_corners(placed: Sequence[Placed], width: float) -> Iterator[_Edged]:
    ends = straight_ends(placed, Linetype.VISIBLE)
    for corner in open_corners(ends, placed):
        if abs(corner.first.inward @ corner.second.inward) > _SQUARE:
            continue
        for adjacent_end, across in (
            (corner.first, corner.second),
            (corner.second, corner.first),
        ):
            away = _edge_beside(adjacent_end, across, corner, ends, width)
            # Each reaches the corner, or leaves off where the chamfer begins.
            if away is not None and all(
                np.hypot(*(end.place - corner.place)) <= away + _MEETING * width
                for end in (adjacent_end, across)
            ):
                yield _Edged(adjacent_end, across, corner, away)


def _edge_beside(
    neighbour: End, across: End, corner: Corner, ends: Sequence[End], width: float
) -> float | None:
    """px from the corner along one of its lines to where the nearest edge ends on it."""
    least = max(_LEAST_SHORTEST, _SHORTEST * width)
    found = []
    for end in ends:
        if end.index in (neighbour.index, across.index):
            continue
        way = end.place - corner.place
        along = float(way @ across.inward)
        off = float(way[0] * across.inward[1] - way[1] * across.inward[0])
        turn = neighbour.inward[0] * end.inward[1] - neighbour.inward[1] * end.inward[0]
        if (
            least <= along <= _LONGEST * width
            and abs(off) <= _MEETING * width
            and abs(turn) <= _PARALLEL
            and end.inward @ neighbour.inward > 0.0
        ):
            found.append(along)
    return min(found, default=None)


def _length(
    weight: npt.NDArray[np.float32], edged: _Edged, pieces: Sequence[Placed], pen: Pen
) -> float | None:
    """px from the corner to where the chamfer ends; None if the corner is sharp."""
    turning = edged.neighbour.index, edged.across.index
    others = [piece for k, piece in enumerate(pieces) if k not in turning]
    pixels = _pixels(weight.shape, edged, others, pen)
    if len(pixels) < FEWEST_PIXELS:
        return None
    columns, rows = pixels.astype(int).T
    ink = weight[rows, columns].astype(np.float64)
    rest = np.full(len(pixels), 1e3)
    for other in others:
        rest = np.minimum(rest, distances_to(other, pixels))

    def error(distance: Floats) -> float:
        return float(((pen.ink(np.minimum(rest, distance)) - ink) ** 2).sum())

    def cut(length: float) -> float:
        start = edged.corner.place + edged.away * edged.across.inward
        end = edged.corner.place + length * edged.neighbour.inward
        distance = distances_to(visible_leg(start, end), pixels)
        for stroke, place in ((edged.across, start), (edged.neighbour, end)):
            shorter = _ended_at(pieces[stroke.index], stroke, place)
            distance = np.minimum(distance, distances_to(shorter, pixels))
        return error(distance)

    as_it_is = np.minimum(*(distances_to(pieces[k], pixels) for k in turning))
    joined = from_joins(edged.corner, pixels - edged.corner.place)
    sharp = min(error(distance) for distance in (as_it_is, *joined))
    room = min(_STEEPEST * edged.away, edged.neighbour.length - pen.width)
    tried = np.arange(_FLATTEST * edged.away, room, FINEST_STEP)
    if sharp < _LEAST_GAIN or not len(tried):
        return None
    left = [cut(float(length)) for length in tried]
    best = float(tried[int(np.argmin(left))])
    even = cut(edged.away)
    if even <= _EVEN * sharp and even - min(left) < _LEAST_GAIN:
        # Nearly all chamfers are even, and so few pixels tell their length badly.
        best = edged.away
    if min(left) > _BETTER * sharp or sharp - min(left) < _LEAST_GAIN:
        return None
    return best


def _pixels(shape: tuple[int, ...], edged: _Edged, others: Sequence[Placed], pen: Pen) -> Floats:
    """(n, 2) px around a corner, away from dashes."""
    offset = pen.width / 2.0 + _AROUND
    reach = _STEEPEST * edged.away + offset
    low = np.maximum(np.floor(edged.corner.place - reach), 0).astype(int)
    high = np.minimum(np.ceil(edged.corner.place + reach) + 1, shape[::-1]).astype(int)
    ys, xs = np.mgrid[low[1] : max(high[1], low[1]), low[0] : max(high[0], low[0])]
    pixels = np.stack([xs.ravel(), ys.ravel()], axis=1).astype(np.float64)
    offsets = pixels - edged.corner.place
    along, across = (offsets @ end.inward for end in (edged.neighbour, edged.across))
    near = (along >= -offset) & (across >= -offset)
    near &= (along <= reach) & (across <= edged.away)
    for other in others:
        if other[1].linetype is Linetype.HIDDEN:
            near &= distances_to(other, pixels) > offset
    return pixels[near]


def _ended_at(placed: Placed, end: End, place: Floats) -> Placed:
    geometry, piece = placed
    at = float(geometry.positions(place[None])[0])
    return geometry, replace(piece, start=at) if end.at_start else replace(piece, end=at)
