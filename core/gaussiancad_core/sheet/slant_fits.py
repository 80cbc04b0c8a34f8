"""Short visible lines aslant, fitted to the ink that is theirs alone.

The edge of a chamfer, or of a cone's foot, is seldom longer than a few line widths, and at both
ends its ink merges with that of other strokes, which pulls a fit to its centre line aside.  What
lies clear of all others shows the line's course as the pen would draw it.
"""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.jogs import distances_to
from gaussiancad_core.sheet.junctions import Placed
from gaussiancad_core.sheet.pen import Pen, visible_pen
from gaussiancad_core.sheet.runs import Piece
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]

_LONGEST = 30.0
"""px of a line up to which what merges at its ends may pull it aside."""

_ASLANT = 0.05
"""Sine of the angle to both axes of the sheet at least: views tell the others' places, too."""

_BESIDE, _CLEAR = 2.0, 1.2
"""px beside a line's edge that are looked at, and px from the edges of others."""

_FEWEST, _LEAST_LONG = 15, 4.0
"""Pixels of a line alone, and px of it along which they lie, that tell its course."""

_MOVED = 1.8
"""px by which its ends may be off at most."""

_EVEN = 0.12
"""Mean ink by which pixels may differ from the pen's, at most."""


def with_fitted_slants(
    pieces: Sequence[Placed], ended: Sequence[Placed], sheet: CleanSheet
) -> list[Placed]:
    """The pieces with short lines aslant on their own ink.

    Args:
        pieces: of a view; px, pixel centres at integers.
        ended: the same ones with their ends at junctions.
        sheet: the view's ink.
    """
    courses: dict[Line, list[tuple[Line, Piece]]] = {}
    for geometry, piece in ended:
        if isinstance(geometry, Line):
            courses.setdefault(geometry, []).append((geometry, piece))
    short = [own[0] for own in courses.values() if len(own) == 1 and _is_short_slant(*own[0])]
    if not short:
        return list(pieces)
    pen = visible_pen(sheet.weight, ended, sheet.stroke_width)
    fitted: dict[Line, Line] = {}
    for line, piece in short:
        others = [own for own in ended if own[0] != line]
        course = _fitted((line, piece), others, sheet, pen)
        if course is not None:
            fitted[line] = course
    return [
        (fitted[own], piece) if isinstance(own, Line) and own in fitted else (own, piece)
        for own, piece in pieces
    ]


def _is_short_slant(line: Line, piece: Piece) -> bool:
    short = piece.end - piece.start <= _LONGEST and piece.linetype is Linetype.VISIBLE
    return short and min(abs(own) for own in line.direction) > _ASLANT


def _fitted(
    placed: tuple[Line, Piece], others: Sequence[Placed], sheet: CleanSheet, pen: Pen
) -> Line | None:
    """The line through a piece's own ink, its positions as before; None where that does not tell.

    Both ends are moved across the line until the pen gives the ink of the pixels that are clear of
    other strokes.
    """
    from scipy.optimize import least_squares

    line, piece = placed
    pixels = _own_pixels(placed, others, sheet, pen)
    along, across = line.coordinates(pixels)
    if len(pixels) < _FEWEST or np.ptp(along) < _LEAST_LONG:
        return None
    ink = sheet.weight[pixels[:, 1].astype(int), pixels[:, 0].astype(int)]
    share = (along - piece.start) / (piece.end - piece.start)

    def residual(moved: Floats) -> Floats:
        turned = (moved[1] - moved[0]) / (piece.end - piece.start)
        away = across - moved[0] - (moved[1] - moved[0]) * share
        return pen.ink(np.abs(away) / np.hypot(1.0, turned)) - ink

    found = least_squares(residual, (0.0, 0.0), bounds=(-_MOVED, _MOVED), diff_step=1e-3)
    if float(np.abs(found.fun).mean()) > _EVEN or np.abs(found.x).max() > 0.99 * _MOVED:
        return None
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    start, end = (
        np.array(line.at(at)) + shift * normal
        for at, shift in zip((piece.start, piece.end), found.x, strict=True)
    )
    way = (end - start) / np.hypot(*(end - start))
    origin = start - piece.start * way
    return Line((float(origin[0]), float(origin[1])), (float(way[0]), float(way[1])))


def _own_pixels(
    placed: tuple[Line, Piece], others: Sequence[Placed], sheet: CleanSheet, pen: Pen
) -> Floats:
    """(n, 2) pixels on and beside a piece that are clear of other strokes."""
    line, piece = placed
    reach = pen.width / 2.0 + _BESIDE
    corners = line.points_at(np.array([piece.start, piece.end]))
    height, width = sheet.weight.shape
    low = np.maximum(np.floor(corners.min(axis=0) - reach), 0).astype(int)
    high = np.minimum(np.ceil(corners.max(axis=0) + reach) + 1, (width, height)).astype(int)
    xs, ys = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
    pixels = np.stack([xs.ravel(), ys.ravel()], axis=1).astype(np.float64)
    along, across = line.coordinates(pixels)
    pixels = pixels[(np.abs(across) < reach) & (along > piece.start) & (along < piece.end)]
    clear = pen.width / 2.0 + _CLEAR
    for other in others:
        if not len(pixels):
            break
        pixels = pixels[distances_to(other, pixels) > clear]
    return pixels
