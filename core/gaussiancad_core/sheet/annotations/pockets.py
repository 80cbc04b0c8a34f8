"""Small pockets in a row, whose outlines are closed as those of letters are: rectangles."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.marks import Mask

_COVERED = 0.97
"""Share of a rectangle's sides that are ink at least; the corners of a D or an O are round."""

_BLANK = 0.5
"""Share of its inside that is paper at least."""


def is_rectangle(piece: Mask, stroke_width: float) -> bool:
    """Whether a piece of ink is the outline of a rectangle along the sheet's axes.

    Args:
        piece: (h, w) bool, of the size of its box.
        stroke_width: px.
    """
    height, width = piece.shape
    border = max(2, int(np.ceil(stroke_width)))
    if min(height, width) <= 2 * border + 1:
        return False
    # Its outermost row of pixels may be grey here and there.
    sides = [
        piece[:border].any(axis=0),
        piece[-border:].any(axis=0),
        piece[:, :border].any(axis=1),
        piece[:, -border:].any(axis=1),
    ]
    first, last = slice(None, border), slice(-border, None)
    corners = [piece[y, x].any() for y in (first, last) for x in (first, last)]
    inside = piece[border:-border, border:-border]
    return (
        float(np.concatenate(sides).mean()) >= _COVERED
        and all(corners)
        and float((~inside).mean()) >= _BLANK
    )


def are_pockets(
    labels: npt.NDArray[np.int32],
    stats: npt.NDArray[np.int32],
    word: list[int],
    stroke_width: float,
) -> bool:
    """Whether all pieces of a word are rectangles.

    Args:
        labels, stats: of all pieces, as OpenCV gives them.
        word: numbers of pieces.
        stroke_width: px.
    """
    return all(
        is_rectangle(labels[y : y + h, x : x + w] == piece, stroke_width)
        for piece in word
        for x, y, w, h in [(int(value) for value in stats[piece, :4])]
    )
