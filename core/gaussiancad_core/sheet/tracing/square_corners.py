"""Square corners that look like a small arc: the end of a narrow slot is no half circle.

Where a short stroke joins two parallel ones a few px apart, ridges cut both corners, and a circle
of half the distance has much of its ink.  What fills the outer corners tells.
"""

import numpy as np

from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample

_LARGEST = 2.5
"""Radius in widths of strokes up to which corners look like arcs."""

_FILLED = 0.45
"""Weight of the ink where the tangents of an arc meet, from which they go on to there."""

_CLEAR = 0.2
"""px that an arc's ink leaves free there, at least, for that to tell."""

_WITHIN = np.radians(25.0)
"""Angle by which the ends of a piece lie beyond the middle of a corner at least."""


def has_square_corner(circle: Circle, piece: Piece, sheet: CleanSheet) -> bool:
    """Whether a piece of a small circle goes around a corner of two lines along the sheet's axes.

    Args:
        circle: px.
        piece: of it.
        sheet: the view's ink.
    """
    away = (np.sqrt(2.0) - 1.0) * circle.radius
    if circle.radius > _LARGEST * sheet.stroke_width or away < sheet.stroke_width / 2.0 + _CLEAR:
        return False
    start, end = piece.start / circle.radius, piece.end / circle.radius
    turns = 2.0 * np.pi * np.arange(-1.0, 3.0)
    for corner in np.pi * np.array([0.25, 0.75, 1.25, 1.75]):
        at = corner + turns
        if not ((at >= start + _WITHIN) & (at <= end - _WITHIN)).any():
            continue
        outwards = np.sign([np.cos(corner), np.sin(corner)])
        x, y = np.array(circle.centre) + circle.radius * outwards
        if float(sample(sheet.weight, np.array([[x]]), np.array([[y]]))[0, 0]) > _FILLED:
            return True
    return False
