"""Where the last dash of a line ends in a corner that a slanted one leaves.

The slanted dash lies on the line's course for a while, and makes its last dash seem a few px
longer: long enough for the line to be led on to the next stroke.  There the middle of the ink
leaves the line to one side at a small angle, and ends beside it.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import COURSE, FAINT, ON_LINE, STEP
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample

_LAST = 6.0
"""px from the end of a piece that are looked at."""

_BESIDE, _ACROSS = 1.5, 0.25
"""px beyond half a line within which ink is the dash's, and between the places across."""

_UNEVEN = 0.1
"""px by which it comes back to the line on its way there, at most."""

_BEYOND, _FAR = 3.0, 4.0
"""px beyond half a line between which there is: a stroke that leaves it steeply has ink there."""


def ended_before_slants(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces, hidden straight ones without the ink of slanted dashes at their ends.

    Args:
        pieces: of a view, where their ink is seen; px, pixel centres at integers.
        sheet: the ink.
    """
    return [
        (geometry, _trimmed(geometry, piece, sheet))
        if isinstance(geometry, Line)
        and piece.linetype is Linetype.HIDDEN
        and piece.end - piece.start > 2.0 * _LAST
        else (geometry, piece)
        for geometry, piece in pieces
    ]


def _trimmed(line: Line, piece: Piece, sheet: CleanSheet) -> Piece:
    end = piece.end - _slanted(line, piece.end, -1.0, sheet)
    return replace(piece, start=piece.start + _slanted(line, piece.start, 1.0, sheet), end=end)


def _slanted(line: Line, end: float, inward: float, sheet: CleanSheet) -> float:
    """px at an end of a line that are another dash's."""
    at = end + inward * np.arange(0.0, _LAST, STEP)
    half = sheet.stroke_width / 2.0
    across = np.arange(-half - _FAR, half + _FAR + _ACROSS / 2.0, _ACROSS)
    normal = np.array([-line.direction[1], line.direction[0]])
    places = line.points_at(at)[:, None] + across[:, None] * normal
    ink = sample(sheet.weight, places[..., 0], places[..., 1])
    near = np.abs(across) <= half + _BESIDE
    middle = (ink[:, near] @ across[near]) / np.maximum(ink[:, near].sum(axis=1), 1e-9)
    side = float(np.sign(middle[0]))
    off = side * middle
    straight = np.flatnonzero(off <= COURSE)
    if off[0] < ON_LINE or not len(straight):
        return 0.0
    first = int(straight[0])
    paper = (side * across <= -half - ON_LINE) | (side * across >= half + _BEYOND)
    if (np.diff(off[: first + 1]) > _UNEVEN).any() or (ink[:first, paper] > FAINT).any():
        return 0.0
    return first * STEP
