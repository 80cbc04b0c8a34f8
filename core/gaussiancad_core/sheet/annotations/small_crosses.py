"""Crosses at the centres of circles that are too small for lines.

A small centre mark drawn with a wide pen is hardly longer than it is wide: no line is found in it,
or one of two.  But it is a piece of ink by itself, a cross, and no dash goes on from it.
"""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape, points_along
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

_LARGEST = 8.0
"""Side of such a cross at most, in stroke widths."""

_ARM_PX = 1.5
"""px by which an arm is longer than the pen is wide at least."""

_OFF_PX, _EVEN_PX = 2.0, 2.0
"""px by which a cross may miss its circle's centre, and its sides may differ."""

_CORNER = 0.1
"""Share of the ink in the corners of its box at most."""

_TURNED = 0.9
"""Share of a cross that is within a px of itself turned by a right angle at least."""

_SQUARE = 0.1
"""Cosine of the angle between its lines at most."""

_AHEAD = 1.6
"""Blank way ahead of its arms, in the sheet's gaps between dashes, but for its circle."""

Pieces = tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]
"""Numbers of the pieces of ink (h, w), and of each x, y, width, height and area in px."""


def mark_small_crosses(shapes: list[InkedShape], kinds: Kinds, sheet: CleanSheet) -> None:
    """Add the two lines of each small cross at the centre of a circle, as centre lines, in place.

    Args:
        shapes: lines and circles of the sheet.
        kinds: what each run is known to be.
        sheet: their ink.
    """
    _, labels, facts, _ = cv2.connectedComponentsWithStats(
        sheet.ink.astype(np.uint8), connectivity=8
    )
    circles = {shape.geometry for shape in shapes if isinstance(shape.geometry, Circle)}
    told: set[int] = set()
    for circle in sorted(circles, key=lambda own: (own.centre, own.radius)):
        column, row = np.rint(circle.centre).astype(int)
        if not (0 <= row < labels.shape[0] and 0 <= column < labels.shape[1]):
            continue
        piece = int(labels[row, column])
        if piece and piece not in told and _is_cross(piece, (labels, facts), circle, sheet):
            told.add(piece)
            _mark(facts[piece], (shapes, kinds), circle)


def _is_cross(piece: int, ink: Pieces, circle: Circle, sheet: CleanSheet) -> bool:
    labels, facts = ink
    x, y, wide, high = (int(value) for value in facts[piece][:4])
    side, pen = max(wide, high), sheet.stroke_width
    middle = np.array([x + 0.5 * (wide - 1), y + 0.5 * (high - 1)])
    if (
        side > min(_LARGEST * pen, circle.radius)
        or abs(wide - high) > _EVEN_PX
        or np.abs(middle - np.array(circle.centre)).max() > _OFF_PX
    ):
        return False
    arm = int(0.5 * (min(wide, high) - pen - 1.0))
    if arm < _ARM_PX:
        return False
    own = labels[y : y + high, x : x + wide] == piece
    ends = slice(None, arm), slice(-arm, None)
    corners = np.stack([own[rows, columns] for rows in ends for columns in ends])
    square = cv2.resize(own.astype(np.uint8), (side, side), interpolation=cv2.INTER_NEAREST) > 0
    # A thin line has one row of pixels, or two.
    turned = cv2.dilate(np.rot90(square).astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    alike = (square & turned).sum() / max(int(square.sum()), 1)
    if corners.mean() > _CORNER or alike < _TURNED:
        return False
    room = circle.radius - 0.5 * side - pen - 1.0
    ahead = int(min(max(_AHEAD * sheet.dash_gap, 2.0 * pen), room))
    return ahead < 1 or not _goes_on(piece, ink, ahead)


def _goes_on(piece: int, ink: Pieces, ahead: int) -> bool:
    """Whether other ink is so many px ahead of the arms of a piece."""
    labels, facts = ink
    x, y, wide, high = (int(value) for value in facts[piece][:4])
    reach = ahead + 1
    around = labels[max(y - reach, 0) : y + high + reach, max(x - reach, 0) : x + wide + reach]
    row, column = min(y, reach) + high // 2, min(x, reach) + wide // 2
    across = np.concatenate(
        [around[row - 1 : row + 2].ravel(), around[:, column - 1 : column + 2].ravel()]
    )
    return bool(((across != 0) & (across != piece)).any())


def _mark(
    facts: npt.NDArray[np.int32], told: tuple[list[InkedShape], Kinds], circle: Circle
) -> None:
    """Tell what was found of a cross, in place; add both lines where these are not told."""
    shapes, kinds = told
    x, y, wide, high = (int(value) for value in facts[:4])
    low, past = np.array([x - 2.0, y - 2.0]), np.array([x + wide + 1.0, y + high + 1.0])
    found = []
    for k, shape in enumerate(shapes):
        for i, run in enumerate(shape.runs):
            points = points_along(shape.geometry, run.run, 2.0)
            if ((points > low) & (points < past)).all():
                found.append((k, i))
    known = [
        shapes[k].geometry
        for k, i in found
        if kinds[k][i] is AnnotationKind.CENTRE_LINE and isinstance(shapes[k].geometry, Line)
    ]
    # Between its arms other lines and small circles may have been found.
    for k, i in found:
        kinds[k][i] = AnnotationKind.CENTRE_LINE
    if any(abs(float(np.dot(a.direction, b.direction))) < _SQUARE for a in known for b in known):
        return
    half = 0.5 * max(wide, high)
    for way in ((1.0, 0.0), (0.0, 1.0)):
        shapes.append(InkedShape(Line(circle.centre, way), (InkedRun(Run(-half, half), None),)))
        kinds.append([AnnotationKind.CENTRE_LINE])
