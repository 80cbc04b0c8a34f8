"""Broken views: a long part drawn without a piece of its middle (ISO 128-3).

Both halves end in a break line, a wave or a zigzag, and the second one's is the first one's moved
along the part.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations

import numpy as np
import numpy.typing as npt
from scipy.ndimage import median_filter

from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.votes import LARGELY, MOST, NEARLY_ALL

Floats = npt.NDArray[np.float64]

_WIDEST = 0.6
"""Gap between the halves at most, in widths of the part."""

_ENDS = 0.06
"""Share of the part's width at either side of it where its own edges are."""

_ALIKE_PX = 3.5
"""px by which the break lines may differ."""

_LEAST_SWING_PX = 5.0
"""px by which a break line swings at least."""

_EDGE_PX = 6
"""px about the side of a box in which a straight edge along it lies."""

_TURNS = 0.2
"""Way that a break line goes each way at least, in its swing: an edge goes one way only."""


@dataclass(frozen=True, eq=False)
class Break:
    """Two halves of a view.

    Attributes:
        halves: their boxes in px.
        box: around both.
        lines: (h, w) bool, the ink of both break lines.
    """

    halves: tuple[Box, Box]
    box: Box
    lines: Mask


def find_breaks(ink: Mask, clusters: Sequence[Box], stroke_width: float) -> list[Break]:
    """Broken views among clusters of ink.

    Args:
        ink: (h, w) bool of the upright sheet with narrow lines on it.
        clusters: boxes of what may be halves.
        stroke_width: px.
    """
    found = []
    for upright in (False, True):
        values = ink.T if upright else ink
        boxes = [_swapped(box) if upright else box for box in clusters]
        for k, one in enumerate(boxes):
            for j, other in enumerate(boxes):
                if k == j or not _face(one, other):
                    continue
                lines = _break_lines(values, one, other, stroke_width)
                if lines is not None:
                    box = (
                        one[0],
                        min(one[1], other[1]),
                        other[2],
                        max(one[3], other[3]),
                    )
                    found.append(
                        Break(
                            (clusters[k], clusters[j]),
                            _swapped(box) if upright else box,
                            lines.T if upright else lines,
                        )
                    )
    return found


def may_be_broken(ink: Mask, clusters: Sequence[Box]) -> bool:
    """Whether any two of some boxes stand to each other as the halves of a broken view do, and end
    there in no straight edge.

    Args:
        ink: (h, w) bool, of the part.
        clusters: boxes of what may be halves.
    """
    return any(
        _face(one, other) and not _is_edge(values, one, 2) and not _is_edge(values, other, 0)
        for values, boxes in ((ink, clusters), (ink.T, [_swapped(box) for box in clusters]))
        for one, other in permutations(boxes, 2)
    )


def _is_edge(ink: Mask, box: Box, side: int) -> bool:
    """Whether a straight edge runs along most of the left (0) or right (2) side of a box."""
    at = int(box[side])
    columns = ink[int(box[1]) : int(box[3]), max(at - _EDGE_PX, 0) : at + _EDGE_PX]
    return bool(columns.size) and float(columns.mean(axis=0).max()) > MOST


def _swapped(box: Box) -> Box:
    return box[1], box[0], box[3], box[2]


def _face(one: Box, other: Box) -> bool:
    """Whether one box stands close to the left of another, beside it."""
    heights = one[3] - one[1], other[3] - other[1]
    shared = min(one[3], other[3]) - max(one[1], other[1])
    adjacent = shared > NEARLY_ALL * min(heights)
    return adjacent and 0.0 < other[0] - one[2] < _WIDEST * min(heights)


def _break_lines(ink: Mask, one: Box, other: Box, stroke_width: float) -> Mask | None:
    """(h, w) bool, the ink of two break lines that face each other, or None."""
    top, bottom = max(one[1], other[1]), min(one[3], other[3])
    inset = _ENDS * (bottom - top)
    rows = np.arange(int(top + inset), int(bottom - inset))
    middle = int(0.5 * (one[2] + other[0]))
    left, right = ink[rows, int(one[0]) : middle], ink[rows, middle : int(other[2])]
    both = left.any(axis=1) & right.any(axis=1)
    if both.sum() < max(LARGELY * len(rows), 12):
        return None
    first = int(one[0]) + left.shape[1] - 1 - np.argmax(left[:, ::-1], axis=1)
    second = middle + np.argmax(right, axis=1)
    first, second = (median_filter(side.astype(float), 5) for side in (first, second))
    apart = (second - first)[both]
    alike = np.abs(apart - np.median(apart)) < _ALIKE_PX
    if alike.mean() < LARGELY or not _swings(first[both][alike]):
        return None
    lines = np.zeros(ink.shape, dtype=bool)
    reach = int(np.ceil(stroke_width)) + 2
    for side in (first, second):
        for row, column in zip(rows, side.astype(int), strict=True):
            lines[row, max(column - reach, 0) : column + reach + 1] = True
    # Their ends lie in the outline's own stretch, where they are not looked at.
    for row in (*range(int(top), rows[0]), *range(rows[-1] + 1, int(bottom))):
        for end, start in ((one[2], first), (other[0], second)):
            at = int(start[0 if row < rows[0] else -1])
            low, high = sorted((at, int(end)))
            lines[row, max(low - 3 * reach, 0) : high + 3 * reach] = True
    return lines & ink


def _swings(line: Floats) -> bool:
    """Whether a line goes to and fro."""
    swing = float(np.percentile(line, 97) - np.percentile(line, 3))
    forth = float((line - np.minimum.accumulate(line)).max())
    back = float((np.maximum.accumulate(line) - line).max())
    return swing > _LEAST_SWING_PX and min(forth, back) > _TURNS * swing
