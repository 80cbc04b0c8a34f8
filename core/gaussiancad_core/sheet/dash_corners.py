"""Two dashes that meet at a square corner, and look like an arc for their ridge cuts it."""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle
from gaussiancad_core.sheet.runs import Piece, Rhythm

_LONGEST = 1.5
"""Dashes that a leg is long at most, beside the width of the stroke."""

_IN_LEGS, _OF_LEGS = 0.85, 0.8
"""Share of the ink that is in both legs, and of either leg that is ink, at least."""

_CORNER = 0.55
"""Ink of the square where both legs meet, in that of a leg: of an arc's, most is paper."""


def is_dash_corner(circle: Circle, piece: Piece, sheet: CleanSheet, rhythm: Rhythm) -> bool:
    """Whether a piece of ink by itself is two legs at a right angle along the sheet's axes.

    Args:
        circle: px.
        piece: of it.
        sheet: the view's ink.
        rhythm: of the sheet's dashes.
    """
    longest = _LONGEST * rhythm.dash + sheet.stroke_width
    if rhythm.dash <= 0.0 or piece.end - piece.start > 2.0 * longest:
        return False
    (place,) = circle.points_at(np.array([0.5 * (piece.start + piece.end)]))
    column, row = np.rint(place).astype(int)
    if not (0 <= row < sheet.ink.shape[0] and 0 <= column < sheet.ink.shape[1]):
        return False
    reach = int(np.ceil(longest)) + 2
    top, left = max(row - reach, 0), max(column - reach, 0)
    window = sheet.ink[top : row + reach + 1, left : column + reach + 1]
    _, labels, stats, _ = cv2.connectedComponentsWithStats(window.astype(np.uint8), connectivity=8)
    number = int(labels[row - top, column - left])
    if not number:
        return False
    x, y, width, height = stats[number, :4].tolist()
    inside = x > 0 and y > 0 and x + width < window.shape[1] and y + height < window.shape[0]
    if not inside or max(width, height) > longest:
        return False
    weight = sheet.weight[top + y : top + y + height, left + x : left + x + width]
    own = np.where(labels[y : y + height, x : x + width] == number, weight, 0.0)
    return any(_are_legs(turned) for turned in _turned(own))


def _turned(ink: npt.NDArray[np.float64]) -> list[npt.NDArray[np.float64]]:
    """The same with each of its corners at the top left."""
    return [ink, ink[::-1], ink[:, ::-1], ink[::-1, ::-1]]


def _are_legs(ink: npt.NDArray[np.float64]) -> bool:
    """Whether (h, w) ink is that of two legs along its top and its left."""
    area, sides = float(ink.sum()), float(sum(ink.shape))
    # Legs of a width w have w (a + b - w) of ink.
    wide = 0.5 * (sides - np.sqrt(max(sides**2 - 4.0 * area, 0.0)))
    # Strokes lie between rows of pixels, and pens that end square leave a notch.
    k = int(np.ceil(wide + 0.25))
    if min(ink.shape) < 1.5 * k:
        return False
    legs = area - float(ink[k:, k:].sum())
    along = min(float(ink[:k, k:].mean()), float(ink[k:, :k].mean()))
    full = max(float(ink[:k].mean()), 1e-9)
    return (
        legs >= _IN_LEGS * area
        and along >= _OF_LEGS * full
        and float(ink[:k, :k].mean()) >= _CORNER * full
    )
