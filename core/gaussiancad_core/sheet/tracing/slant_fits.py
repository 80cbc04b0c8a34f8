"""Short lines aslant, fitted to the ink that is theirs alone.

The edge of a chamfer, or of a cone's foot, is seldom longer than a few line widths, and at both
ends its ink merges with that of other strokes, which pulls a fit to its centre line aside; so do
the strokes that cross the few dashes of a bore's tip.  What lies clear of all others shows the
line's course as the pen would draw it.
"""

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import (
    AROUND,
    ASLANT,
    CLOSER,
    DARK,
    DASH_END,
    EVEN,
    FEWEST_PIXELS,
)
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.leftover import dash_pen
from gaussiancad_core.sheet.tracing.outline_jogs import distances_to
from gaussiancad_core.sheet.tracing.pen_profile import Pen, visible_pen

Floats = npt.NDArray[np.float64]

_LONGEST = {Linetype.VISIBLE: 30.0, Linetype.HIDDEN: 80.0}
"""px of a line up to which what merges with it may pull it aside."""

_CLEAR = 1.2
"""px from the edges of other lines from which ink is a line's alone."""

_LEAST_LONG = 4.0
"""px of a line alone along which its pixels lie, that tell its course."""

_MOVED = 1.8
"""px by which its ends may be off at most."""


def with_fitted_slants(
    pieces: Sequence[Placed], ended: Sequence[Placed], sheet: CleanSheet
) -> list[Placed]:
    """The pieces with short lines aslant on their own ink.

    Args:
        pieces: of a view; px, pixel centres at integers.
        ended: the same ones with their ends at junctions.
        sheet: the view's ink.
    """
    courses: dict[Line, Piece] = {}
    for geometry, piece in ended:
        if isinstance(geometry, Line) and min(abs(value) for value in geometry.direction) > ASLANT:
            before = courses.get(geometry, piece)
            start, end = min(before.start, piece.start), max(before.end, piece.end)
            kind = piece.linetype if before.linetype is piece.linetype else Linetype.VISIBLE
            courses[geometry] = Piece(start, end, kind, piece.confidence)
    short = [
        this_course
        for this_course in courses.items()
        if this_course[1].end - this_course[1].start <= _LONGEST[this_course[1].linetype]
    ]
    if not short:
        return list(pieces)
    pens = {
        Linetype.VISIBLE: visible_pen(sheet.weight, ended, sheet.stroke_width),
        Linetype.HIDDEN: dash_pen(ended, sheet),
    }
    fitted: dict[Line, Line] = {}
    for line, piece in short:
        others = [pair for pair in ended if pair[0] != line]
        course = _fitted((line, piece), others, sheet, pens)
        if course is not None:
            fitted[line] = course
    return [
        (fitted[this_line], piece)
        if isinstance(this_line, Line) and this_line in fitted
        else (this_line, piece)
        for this_line, piece in pieces
    ]


def _fitted(
    placed: tuple[Line, Piece],
    others: Sequence[Placed],
    sheet: CleanSheet,
    pens: Mapping[Linetype, Pen],
) -> Line | None:
    """The line through a piece's own ink, its positions as before; None where that does not tell.

    Both ends are moved across the line until the pen gives the ink of the pixels that are clear of
    other strokes.
    """
    from scipy.optimize import least_squares

    line, piece = placed
    pen = pens[piece.linetype]
    pixels = _own_pixels(placed, others, sheet, pens[Linetype.VISIBLE])
    along, across = line.coordinates(pixels)
    if len(pixels) < FEWEST_PIXELS or np.ptp(along) < _LEAST_LONG:
        return None
    ink = sheet.weight[pixels[:, 1].astype(int), pixels[:, 0].astype(int)]
    share = (along - piece.start) / (piece.end - piece.start)

    def residual(moved: Floats) -> Floats:
        turned = (moved[1] - moved[0]) / (piece.end - piece.start)
        away = across - moved[0] - (moved[1] - moved[0]) * share
        return pen.ink(np.abs(away) / np.hypot(1.0, turned)) - ink

    found = least_squares(residual, (0.0, 0.0), bounds=(-_MOVED, _MOVED), diff_step=1e-3)
    if float(np.abs(found.fun).mean()) > EVEN or np.abs(found.x).max() > 0.99 * _MOVED:
        return None
    if found.cost > CLOSER * 0.5 * float(np.square(residual(np.zeros(2))).sum()):
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
    reach = pen.width / 2.0 + AROUND
    corners = line.points_at(np.array([piece.start, piece.end]))
    height, width = sheet.weight.shape
    low = np.maximum(np.floor(corners.min(axis=0) - reach), 0).astype(int)
    high = np.minimum(np.ceil(corners.max(axis=0) + reach) + 1, (width, height)).astype(int)
    xs, ys = np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1]))
    pixels = np.stack([xs.ravel(), ys.ravel()], axis=1).astype(np.float64)
    along, across = line.coordinates(pixels)
    pixels = pixels[(np.abs(across) < reach) & _is_drawn(line, piece, along, sheet)]
    clear = pen.width / 2.0 + _CLEAR
    for other in others:
        if not len(pixels):
            break
        pixels = pixels[distances_to(other, pixels) > clear]
    return pixels


def _is_drawn(line: Line, piece: Piece, along: Floats, sheet: CleanSheet) -> npt.NDArray[np.bool_]:
    """Of (n,) px along a piece whether there is ink of it, and not the end of a dash."""
    inside = (along > piece.start) & (along < piece.end)
    if piece.linetype is Linetype.VISIBLE:
        return inside
    near = along[:, None] + np.array([-DASH_END, 0.0, DASH_END])
    points = line.points_at(near.ravel())
    ink = sample(sheet.weight, points[:, :1], points[:, 1:]).reshape(near.shape)
    return inside & (ink.min(axis=1) > DARK)
