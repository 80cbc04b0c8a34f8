"""The gaps between a sheet's dashes, as far as its free dashes tell them.

Standards have them in widths of the line (ISO 128-2), CAD programs in millimetres of the paper: on
a fine scan a gap is many times as wide as the line.
"""

from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt

_SLENDER = 2.5
"""Times a free dash is as long as wide, at least, and stroke widths that it is wide, at most."""

_LONGEST_PX = 120.0
"""Length of a dash at most."""

_ALIKE = 0.25
"""Share by which dashes that follow each other differ in length at most."""

_WIDEST = 1.5
"""Gap between them, in their lengths, at most."""

_FEWEST = 6
"""Gaps that tell anything, at least."""

_BESIDE_PX = 1.5
"""px by which they may lie beside each other."""

Boxes = npt.NDArray[np.float64]


def dash_gap(ink: npt.NDArray[np.bool_], stroke_width: float) -> float:
    """px, the median gap between dashes along the rows and columns of a sheet; 0 where there are
    none.

    Args:
        ink: (h, w) bool, upright.
        stroke_width: px.
    """
    _, _, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    boxes = stats[1:, :4].astype(np.float64)
    gaps: list[float] = []
    for order in ([0, 1, 2, 3], [1, 0, 3, 2]):
        gaps += _gaps(boxes[:, order], stroke_width)
    return float(np.median(gaps)) if len(gaps) >= _FEWEST else 0.0


def _gaps(boxes: Boxes, stroke_width: float) -> list[float]:
    """Gaps between level dashes; boxes are (n, 4) of start, top, length and height."""
    _, _, length, height = boxes.T
    slender = (length >= _SLENDER * height) & (length <= _LONGEST_PX)
    own = boxes[slender & (height <= _SLENDER * stroke_width)]
    middle = own[:, 1] + own[:, 3] / 2.0
    found = []
    for first in _rows(middle):
        row = own[first][np.argsort(own[first, 0])]
        for one, other in pairwise(row):
            gap, longer = other[0] - one[0] - one[2], max(one[2], other[2])
            alike = abs(one[2] - other[2]) <= _ALIKE * longer
            if alike and 0.0 < gap <= _WIDEST * longer:
                found.append(float(gap))
    return found


def _rows(middle: npt.NDArray[np.float64]) -> list[npt.NDArray[np.int64]]:
    """Indices of the dashes at each height."""
    order = np.argsort(middle, kind="stable")
    borders = np.flatnonzero(np.diff(middle[order]) > _BESIDE_PX) + 1
    return [row for row in np.split(order, borders) if len(row) > 1]
