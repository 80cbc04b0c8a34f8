"""Boxes around single letters, as datum features have them (ISO 5459): no pockets of the part.

Such a box hangs on an edge by a line with a triangle, so that its ink is one piece with the part's.
"""

from collections.abc import Sequence

import cv2
import numpy as np
import numpy.typing as npt
from scipy.ndimage import binary_fill_holes

from gaussiancad_core.sheet.annotations.marks import Mark, Mask

_ROOM = 3.0
"""Side of the paper around a letter in its box at most, in sizes of the letter."""

_SQUARE = 0.94
"""Share of its bounding box that this paper takes at least, with the letter."""

_BESIDE = 1.5
"""Stroke widths from the paper within which the sides of a box lie."""


def is_boxed(paper: npt.NDArray[np.int32], letter: npt.NDArray[np.int32], area: int) -> bool:
    """Whether paper with a letter in it is a box around that letter.

    Args:
        paper: (4,) x, y, width, height in px of the paper around it.
        letter: the same of the letter.
        area: px of the paper, and of the letter that stands in it.
    """
    size = int(max(letter[2:4]))
    inside = (paper[:2] < letter[:2]).all() and (
        paper[:2] + paper[2:4] > letter[:2] + letter[2:4]
    ).all()
    if not inside or max(paper[2:4]) > _ROOM * size:
        return False
    return area >= _SQUARE * int(paper[2]) * int(paper[3])


def enclosed(
    areas: npt.NDArray[np.int32], own: int, paper: npt.NDArray[np.int32]
) -> npt.NDArray[np.bool_]:
    """(height, width) bool, one of the areas of paper with all that stands in it.

    Args:
        areas: (h, w) numbers of the areas.
        own: its number.
        paper: (4,) its x, y, width, height in px.
    """
    x, y, width, height = (int(value) for value in paper)
    return binary_fill_holes(areas[y : y + height, x : x + width] == own)


def letter_boxes(ink: Mask, letters: Sequence[Mark], stroke_width: float) -> Mask:
    """(h, w) bool, boxes around single letters with their sides.

    Args:
        ink: (h, w) without the letters.
        letters: their marks.
        stroke_width: px.
    """
    _, areas, stats, _ = cv2.connectedComponentsWithStats((~ink).astype(np.uint8), connectivity=4)
    mask = np.zeros(ink.shape, dtype=bool)
    beside = int(np.ceil(_BESIDE * stroke_width))
    for mark in letters:
        x0, y0, x1, y1 = (int(value) for value in mark.box)
        own = int(areas[(y0 + y1) // 2, (x0 + x1) // 2])
        paper = stats[own]
        letter = np.array([x0, y0, x1 - x0, y1 - y0], dtype=np.int32)
        # The letter is off the ink: its place is paper as well.
        if own and is_boxed(paper[:4], letter, int(paper[cv2.CC_STAT_AREA])):
            x, y, width, height = (int(value) for value in paper[:4])
            rows = slice(max(y - beside, 0), y + height + beside)
            mask[rows, max(x - beside, 0) : x + width + beside] = True
    return mask
