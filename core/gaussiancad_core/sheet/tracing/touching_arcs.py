"""What an arc explains where lines pass into it: its ink up to where they touch.

Beyond there its ink is the line's for as long as both lie in one stroke.  Were all of it the arc's,
a short line between two arcs would have nothing left that is new.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from gaussiancad_core.geometry.whole_curves import Circle, Line, WholeCurve
from gaussiancad_core.sheet.picture_noise import SEEN_BEYOND, TOUCHING
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Run

_SHARED = 1.5
"""px, beside half a line's width, that an arc has left its tangent by where the ink parts."""

_GOES_ON = 2.0
"""px by which the line reaches beyond the arc's seen end at least."""

_LEFT = 0.4
"""Share of an arc that is its own at least."""


def up_to_tangents(
    geometry: WholeCurve,
    piece: Piece,
    lines: Iterable[tuple[Line, Sequence[Run]]],
    stroke_width: float,
) -> Piece:
    """A piece of a circle without what lines have that touch it shortly before its ends.

    Args:
        geometry: of the piece; of other shapes than circles the piece stays as it is.
        piece: where its ink was seen.
        lines: with their ink.
        stroke_width: px.
    """
    if not isinstance(geometry, Circle) or piece.end - piece.start >= geometry.around - 1e-6:
        return piece
    start, end = piece.start, piece.end
    reach = float(np.sqrt(2.0 * geometry.radius * (stroke_width / 2.0 + _SHARED))) + SEEN_BEYOND
    for line, runs in lines:
        along, across = line.coordinates(np.array([geometry.centre]))
        if abs(abs(float(across[0])) - geometry.radius) > TOUCHING or not runs:
            continue
        foot = float(along[0])
        touch = np.array([line.at(foot)])
        at = piece.start + (float(geometry.positions(touch)[0]) - piece.start) % geometry.around
        tangent = geometry.tangents_at(np.array([at]))[0]
        ahead = 1.0 if float(tangent @ np.array(line.direction)) > 0.0 else -1.0
        # The line goes on the way that the arc does at its end, and back at its start.
        if 0.0 < piece.end - at <= reach and _goes_on(runs, foot, ahead, piece.end - at):
            end = min(end, at)
        elif 0.0 < at - piece.start <= reach and _goes_on(runs, foot, -ahead, at - piece.start):
            start = max(start, at)
    if end - start < _LEFT * (piece.end - piece.start):
        return piece
    return replace(piece, start=start, end=end)


def ended_where_lines_touch(pieces: Sequence[Placed], stroke_width: float) -> list[Placed]:
    """The pieces of a view, those of circles up to where lines of their kind touch them."""
    ended = []
    for geometry, piece in pieces:
        lines = [
            (other, (Run(this_piece.start, this_piece.end),))
            for other, this_piece in pieces
            if isinstance(other, Line) and this_piece.linetype is piece.linetype
        ]
        ended.append((geometry, up_to_tangents(geometry, piece, lines, stroke_width)))
    return ended


def _goes_on(runs: Sequence[Run], foot: float, way: float, beyond: float) -> bool:
    """Whether a line's ink reaches farther from the touch than the arc's seen end."""
    farthest = max(way * ((run.end if way > 0.0 else run.start) - foot) for run in runs)
    return farthest >= beyond + _GOES_ON
