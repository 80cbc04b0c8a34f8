"""Pieces of lines that are another stroke's ink.

Where a stroke crosses the course of a long line at a small angle, its ink lies on that course for a
while, and looks like a piece of the line if the line is taken first.  So does that of a circle that
touches the course, and a dash of a hidden one.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.explained_ink import path_points
from gaussiancad_core.sheet.tracing.junctions import is_full_circle
from gaussiancad_core.sheet.votes import NEARLY_ALL

_LONGEST = 40.0
"""px of a shadow at most: a longer one is crossed at hardly any angle."""

_LONGER = 1.5
"""Times the shadow's length that the stroke has which throws it."""

_LEAST_TURN, _MOST_TURN = 0.05, 0.35
"""Sine of the angle between them."""

_MIDDLE = 0.25
"""Share of a shadow's length by which a circle may touch it off its middle."""

_BEYOND = 2.0
"""px by which the circle goes on beyond both of its ends at least."""


def without_shadows(
    pieces: Sequence[Placed], stroke_width: float, dash: float = 0.0
) -> list[Placed]:
    """The pieces but the visible ones that lie on longer visible strokes that cross them, and the
    single dashes that are those of hidden circles.

    Args:
        pieces: of a view, px.
        stroke_width: px.
        dash: px of a dash, if there are any.
    """
    straight = [piece for piece in pieces if _is_visible_line(piece)]
    round_ = [
        piece
        for piece in pieces
        if isinstance(piece[0], Circle) and piece[1].linetype is Linetype.VISIBLE
    ]
    dashed = [
        piece
        for piece in pieces
        if isinstance(piece[0], Circle)
        and piece[1].linetype is Linetype.HIDDEN
        and is_full_circle(*piece)
    ]
    return [
        piece
        for piece in pieces
        if not (
            _is_visible_line(piece)
            and piece[1].end - piece[1].start <= _LONGEST
            and (
                any(_throws(other, piece, stroke_width) for other in straight)
                or any(_touches(other, piece, stroke_width) for other in round_)
            )
        )
        and not (
            _is_one_dash(piece, dash)
            and any(_touches(other, piece, stroke_width) for other in dashed)
        )
    ]


def _is_visible_line(placed: Placed) -> bool:
    return isinstance(placed[0], Line) and placed[1].linetype is Linetype.VISIBLE


def _is_one_dash(placed: Placed, dash: float) -> bool:
    geometry, piece = placed
    hidden = isinstance(geometry, Line) and piece.linetype is Linetype.HIDDEN
    return hidden and piece.end - piece.start <= (1.0 + LIKE_A_DASH) * dash


def _throws(stroke: Placed, shadow: Placed, stroke_width: float) -> bool:
    line, piece = stroke
    course, this_piece = shadow
    if not isinstance(line, Line) or not isinstance(course, Line):
        return False
    length = this_piece.end - this_piece.start
    if piece.end - piece.start < _LONGER * length:
        return False
    (ax, ay), (bx, by) = line.direction, course.direction
    if not _LEAST_TURN < abs(ax * by - ay * bx) < _MOST_TURN:
        return False
    points = path_points(course, this_piece.start, this_piece.end)
    along, across = line.coordinates(points)
    inside = (along > piece.start - 1.0) & (along < piece.end + 1.0)
    covered = inside & (np.abs(across) <= stroke_width / 2.0 + 1.0)
    return bool(covered.mean() >= NEARLY_ALL)


def _touches(stroke: Placed, shadow: Placed, stroke_width: float) -> bool:
    """Whether a circle touches a line in the middle of a piece, and goes on beside all of it."""
    circle, piece = stroke
    course, this_piece = shadow
    if not isinstance(circle, Circle):
        return False
    length = this_piece.end - this_piece.start
    foot = float(course.positions(np.array([circle.centre]))[0])
    if abs(foot - (this_piece.start + this_piece.end) / 2.0) > _MIDDLE * length:
        return False
    points = path_points(course, this_piece.start, this_piece.end)
    if (circle.distances(points) <= stroke_width / 2.0 + 1.0).mean() < NEARLY_ALL:
        return False
    ends = circle.positions(points[[0, -1]])
    middle = float(circle.positions(points[len(points) // 2][None])[0])
    # Both ends of the shadow as positions before and behind its middle, on the piece's own turn.
    at = piece.start + np.mod(middle - piece.start, circle.around)
    half = float(
        np.abs((ends - middle + circle.around / 2) % circle.around - circle.around / 2).max()
    )
    return is_full_circle(circle, piece) or (
        at - half - _BEYOND >= piece.start and at + half + _BEYOND <= piece.end
    )
