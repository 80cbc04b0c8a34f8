"""Edges that end just before or beyond the edges that end them, drawn too short or too long.

No edge of a drawing ends in blank paper: an end that nothing meets belongs to the nearest crossing,
if one is a few pixels away.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line, WholeCurve
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.picture_noise import ONE_PLACE, OVERSHOOT
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.junctions import crossings_with

_CLEAR_PX = 4
"""px around an end in which there is no ink that no stroke explains: it may go on as a curve."""


def with_met_ends(
    pieces: Sequence[Placed], unexplained: npt.NDArray[np.bool_], stroke_width: float
) -> list[Placed]:
    """The pieces with dangling ends of visible lines at the nearest crossing with visible strokes.

    Args:
        pieces: of all shapes of a view.
        unexplained: (h, w) ink that is none of theirs.
        stroke_width: px.
    """
    moved: list[Placed] = []
    for number, (geometry, piece) in enumerate(pieces):
        if not isinstance(geometry, Line) or piece.linetype is not Linetype.VISIBLE:
            moved.append((geometry, piece))
            continue
        others = [
            this_piece
            for k, this_piece in enumerate(pieces)
            if k != number and this_piece[0] != geometry
        ]
        along = [
            this_piece
            for k, (other, this_piece) in enumerate(pieces)
            if k != number and other == geometry
        ]
        # Where a line goes on hidden, its visible part ends there.
        joints = [end for this_piece in along for end in (this_piece.start, this_piece.end)]
        start, end = (
            at
            if any(abs(joint - at) <= ONE_PLACE for joint in joints)
            else _met(geometry, piece, at, (others, unexplained, stroke_width))
            for at in (piece.start, piece.end)
        )
        fits = end - start > OVERSHOOT
        moved.append((geometry, replace(piece, start=start, end=end) if fits else piece))
    return moved


def _met(
    line: Line,
    piece: Piece,
    at: float,
    around: tuple[Sequence[Placed], npt.NDArray[np.bool_], float],
) -> float:
    """Where an end of a piece is to be."""
    others, unexplained, stroke_width = around
    x, y = line.at(at)
    column, row = round(x), round(y)
    adjacent = (
        slice(max(row - _CLEAR_PX, 0), max(row + _CLEAR_PX + 1, 0)),
        slice(max(column - _CLEAR_PX, 0), max(column + _CLEAR_PX + 1, 0)),
    )
    if unexplained[adjacent].any():
        return at
    way = 1.0 if at > (piece.start + piece.end) / 2.0 else -1.0
    # Short strokes are seen to end as soon as others' ink is beside them.
    short: list[float] = []
    near: list[float] = []
    for other, stretch in others:
        if _is_far(line, at, other, stretch):
            continue
        longer = replace(stretch, start=stretch.start - OVERSHOOT, end=stretch.end + OVERSHOOT)
        for crossing in crossings_with(line, piece, other, stretch, stroke_width):
            if abs(crossing.at - at) <= crossing.reach + ONE_PLACE:
                if (
                    stretch.linetype is not Linetype.VISIBLE
                    or way * (crossing.at - at) <= ONE_PLACE
                ):
                    return at
                short.append(crossing.at)
        if stretch.linetype is Linetype.VISIBLE:
            found = crossings_with(line, piece, other, longer, stroke_width)
            near += [
                this_crossing.at
                for this_crossing in found
                if abs(this_crossing.at - at) <= OVERSHOOT
            ]
    return min(short or near, key=lambda place: abs(place - at), default=at)


def _is_far(line: Line, at: float, other: WholeCurve, stretch: Piece) -> bool:
    """Whether a stroke is nowhere near a place: most are not."""
    x, y = line.at(at)
    if not isinstance(other, Line):
        return float(np.abs(other.distances(np.array([(x, y)])))[0]) > 2.0 * OVERSHOOT
    (dx, dy), ox, oy = other.direction, x - other.point[0], y - other.point[1]
    if abs(oy * dx - ox * dy) > 2.0 * OVERSHOOT:
        return True
    along = ox * dx + oy * dy
    return along < stretch.start - 2.0 * OVERSHOOT or along > stretch.end + 2.0 * OVERSHOOT
