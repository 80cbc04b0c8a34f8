"""The gaps between a sheet's dashes, as far as its free dashes tell them.

Standards have them in widths of the line (ISO 128-2), CAD programs in millimetres of the paper: on
a fine scan a gap is many times as wide as the line.
"""

from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.dash_noise import TELLING
from gaussiancad_core.sheet.line_conventions import LONGEST_DASH, SLENDER, WIDEST_GAP
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.votes import HALF, MOST

Boxes = npt.NDArray[np.float64]

_ALIKE = 0.25
"""Share by which dashes that follow each other, and the gaps of a sheet, differ at most."""


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
    if len(gaps) < TELLING:
        gaps = []
        for order, turned in ([0, 1, 2, 3], ink), ([1, 0, 3, 2], ink.T):
            gaps += _gaps_beside(boxes[:, order], turned, stroke_width)
        if not _agree(gaps):
            return 0.0
    return float(np.median(gaps)) if len(gaps) >= TELLING else 0.0


def _gaps(boxes: Boxes, stroke_width: float) -> list[float]:
    """Gaps between level dashes; boxes are (n, 4) of start, top, length and height."""
    slender = _slender(boxes, stroke_width)
    middle = slender[:, 1] + slender[:, 3] / 2.0
    found = []
    for first in _rows(middle):
        row = slender[first][np.argsort(slender[first, 0])]
        for one, other in pairwise(row):
            gap, longer = other[0] - one[0] - one[2], max(one[2], other[2])
            alike = abs(one[2] - other[2]) <= _ALIKE * longer
            if alike and 0.0 < gap <= WIDEST_GAP * longer:
                found.append(float(gap))
    return found


def _slender(boxes: Boxes, stroke_width: float) -> Boxes:
    """Those of a free dash."""
    _, _, length, height = boxes.T
    slender = (length >= SLENDER * height) & (length <= LONGEST_DASH)
    return boxes[slender & (height <= SLENDER * stroke_width)]


def _gaps_beside(boxes: Boxes, ink: npt.NDArray[np.bool_], stroke_width: float) -> list[float]:
    """Gaps between free level dashes and such as other strokes cross or touch.

    Args:
        boxes: (n, 4) of start, top, length and height.
        ink: (h, w) bool.
        stroke_width: px.
    """
    found = []
    neighbour = round(stroke_width + ONE_PLACE)
    for start, top, length, height in _slender(boxes, stroke_width).astype(int):
        row = top + height // 2
        above, below = max(row - neighbour, 0), min(row + neighbour, len(ink) - 1)
        crowded = ink[above] | ink[below]
        for line, aside in (
            (ink[row, start + length :], crowded[start + length :]),
            (ink[row, :start][::-1], crowded[:start][::-1]),
        ):
            at = 0
            while True:
                gap, other = _next(line[at : at + int((WIDEST_GAP + 2.0) * length)])
                alike = abs(other - length) <= _ALIKE * max(length, other)
                lean = ~aside[at + gap : at + gap + other]
                if not alike or not stroke_width < gap <= WIDEST_GAP * length or lean.mean() < HALF:
                    break
                found.append(float(gap))
                at += gap + other
    return found


def _agree(gaps: list[float]) -> bool:
    """Whether most of the gaps are about as wide as their median."""
    if not gaps:
        return False
    values = np.array(gaps)
    middle = float(np.median(values))
    return float((np.abs(values - middle) <= _ALIKE * middle).mean()) >= MOST


def _next(line: npt.NDArray[np.bool_]) -> tuple[int, int]:
    """Px until the next ink of a line and its length; no length where there is none, or no end."""
    borders = np.flatnonzero(np.diff(line.astype(int), prepend=0))
    return (int(borders[0]), int(borders[1] - borders[0])) if len(borders) > 1 else (0, 0)


def _rows(middle: npt.NDArray[np.float64]) -> list[npt.NDArray[np.int64]]:
    """Indices of the dashes at each height."""
    order = np.argsort(middle, kind="stable")
    borders = np.flatnonzero(np.diff(middle[order]) > ONE_PLACE) + 1
    return [row for row in np.split(order, borders) if len(row) > 1]
