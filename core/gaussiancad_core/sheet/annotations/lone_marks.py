"""Centre marks beside circles as thick as their gaps, or of which a stroke faded.

Their crosses come so close to the circle that their ends are not free, yet no piece of one touches
anything: edges end at edges, and dashes follow each other.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedShape
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.geometry import Circle, Line

_OFF = 1.0
"""px by which a piece may miss its circle's centre."""

_EVEN = 3.0
"""px by which the two sides of a mark may differ."""

_SQUARE = 0.05
"""Cosine of the angle between a mark's lines at most."""

_NEAR = 2.5
"""How far from the centre a mark may reach, in radii."""

_APART = 6.0
"""Distance to the next dash of a line that is no mark at most, in stroke widths."""

_FILLED = 2.5
"""Ink of a piece at most, in that of a stroke as long as it is: two of them cross."""


@dataclass(frozen=True)
class _Piece:
    """A run that touches nothing, on a line through a circle's centre.

    Attributes:
        shape, run: its numbers.
        direction: of its line, pointing right, or down.
        start, end: px along it from the centre.
    """

    shape: int
    run: int
    direction: tuple[float, float]
    start: float
    end: float


@dataclass(frozen=True, eq=False)
class _Pieces:
    """The connected pieces of a sheet's ink: labels (h, w), and facts of each."""

    labels: npt.NDArray[np.int32]
    facts: npt.NDArray[np.int32]


def mark_lone_marks(
    shapes: Sequence[InkedShape], kinds: Kinds, ink: Mask, stroke_width: float
) -> None:
    """Mark the pieces of centre marks that touch nothing as centre lines, in place.

    On one of a mark's two lines there are a stroke through the centre, within the circle, and one
    beyond it on either side; on the other one of these may have faded.

    Args:
        shapes: lines and circles of the sheet.
        kinds: what each run is known to be.
        ink: (h, w) bool.
        stroke_width: px.
    """
    circles = {shape.geometry for shape in shapes if isinstance(shape.geometry, Circle)}
    _, labels, facts, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    for circle in sorted(circles, key=lambda own: (own.centre, own.radius)):
        lines = _lines(_pieces(circle, shapes, kinds, _Pieces(labels, facts), stroke_width))
        whole = [own for own in lines if _is_mark(own, circle, stroke_width, faded=False)]
        for found in whole:
            across = [own for own in lines if _is_square(own[0], found[0])]
            faded = [own for own in across if _is_mark(own, circle, stroke_width, faded=True)]
            for piece in (*found, *(piece for own in faded for piece in own)):
                if abs(piece.start) < _NEAR * circle.radius:
                    kinds[piece.shape][piece.run] = AnnotationKind.CENTRE_LINE


def _pieces(
    circle: Circle,
    shapes: Sequence[InkedShape],
    kinds: Kinds,
    ink: _Pieces,
    stroke_width: float,
) -> list[_Piece]:
    """The runs on lines through a circle's centre that touch nothing, near it and a little on."""
    centre = np.array([circle.centre])
    reach = _NEAR * circle.radius + 2.0 * _APART * stroke_width
    found = []
    for k, shape in enumerate(shapes):
        line = shape.geometry
        if not isinstance(line, Line):
            continue
        along, across = line.coordinates(centre)
        if abs(float(across[0])) > _OFF:
            continue
        zero = float(along[0])
        sign = 1.0 if line.direction > (0.0, 0.0) else -1.0
        for i, own in enumerate(shape.runs):
            start, end = sorted((sign * (own.run.start - zero), sign * (own.run.end - zero)))
            if kinds[k][i] is not None or max(abs(start), abs(end)) > reach:
                continue
            direction = sign * line.direction[0], sign * line.direction[1]
            piece = _Piece(k, i, direction, start, end)
            if _is_alone(piece, circle, ink, stroke_width):
                found.append(piece)
    return found


def _is_alone(piece: _Piece, circle: Circle, ink: _Pieces, stroke_width: float) -> bool:
    """Whether the ink of a piece is no more than it, and what crosses it as a cross does."""
    middle = np.array(circle.centre) + np.array(piece.direction) * (piece.start + piece.end) / 2
    column, row = np.rint(middle).astype(int)
    height, width = ink.labels.shape
    if not (0 <= column < width and 0 <= row < height) or not ink.labels[row, column]:
        return False
    *_, wide, high, area = ink.facts[ink.labels[row, column]]
    length = piece.end - piece.start
    longest = length + 2.0 * stroke_width
    # A crossing stroke makes the piece no longer, and at most as wide as it is long.
    return max(wide, high) <= longest and area <= _FILLED * longest * stroke_width


def _lines(pieces: Sequence[_Piece]) -> list[list[_Piece]]:
    """Pieces of one direction, in order along it."""
    lines: list[list[_Piece]] = []
    for piece in sorted(pieces, key=lambda own: own.start):
        for own in lines:
            if abs(float(np.dot(own[0].direction, piece.direction))) > 1.0 - _SQUARE:
                own.append(piece)
                break
        else:
            lines.append([piece])
    return lines


def _is_square(one: _Piece, other: _Piece) -> bool:
    return abs(float(np.dot(one.direction, other.direction))) < _SQUARE


def _is_mark(line: list[_Piece], circle: Circle, stroke_width: float, *, faded: bool) -> bool:
    """Whether the pieces of a line are a mark's and no dashes: each side is the other's picture,
    with a stroke through the centre and one beyond the circle on either side."""
    near = [piece for piece in line if abs(piece.start) < _NEAR * circle.radius]
    crosses = [piece for piece in near if piece.start < 0.0 < piece.end]
    arms = [piece for piece in near if min(abs(piece.start), abs(piece.end)) > circle.radius]
    if len(near) != len(crosses) + len(arms) or not near:
        return False
    even = all(
        any(max(abs(one.start + other.end), abs(one.end + other.start)) <= _EVEN for other in near)
        for one in near
    )
    within = all(piece.end < circle.radius for piece in crosses)
    whole = len(crosses) == 1 and len(arms) == 2
    last = max(piece.end for piece in near)
    beyond = [piece for piece in line if piece not in near]
    dashes = any(
        min(abs(piece.start), abs(piece.end)) < last + _APART * stroke_width for piece in beyond
    )
    return even and within and not dashes and (whole or (faded and len(near) <= 2))
