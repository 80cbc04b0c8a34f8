"""The frame around a drawing, its zone marks and title block (ISO 5457, ISO 7200).

The frame is ink that spans most of the sheet and keeps off its middle.  The title block hangs
together with it.  With the border of the paper it encloses areas: the largest is where the part is
drawn, all others are fields.
"""

from dataclasses import dataclass

import cv2
import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, Mask
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.line_conventions import CELLS, FRAME, MARGIN
from gaussiancad_core.sheet.votes import MOST, NEARLY_ALL

_MIDDLE = (0.1, 0.1, 0.9, 0.8)
"""Left, top, right and bottom of the middle of a frame, as shares of its box: its lines and title
block lie outside."""

_IN_MIDDLE = 0.1
"""Share of a frame's ink in its middle at most."""

_EVEN = 4
"""px within which pieces of a frame are as wide, or as high, as each other."""

_LARGEST = 0.3
"""Share of the sheet that the drawing area has at least: less is a view drawn large."""


@dataclass(frozen=True, eq=False)
class Frame:
    """The frame of a sheet.

    Attributes:
        drawing_area: (h, w) bool, where the part may be drawn.
        marks: the frame itself and the fields.
    """

    drawing_area: Mask
    marks: tuple[Mark, ...]


def find_frame(ink: Mask, turn: Turn) -> Frame | None:
    """The frame of a sheet, or nothing where it has none.

    Args:
        ink: (h, w) bool of the upright sheet.
        turn: by which the sheet was turned: a frame may have lost its corners beyond the border.
    """
    height, width = ink.shape
    # Lines of one pixel that a scan broke still hold together.
    closed = cv2.dilate(ink.astype(np.uint8), np.ones((3, 3), np.uint8))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    spans = (stats[:, cv2.CC_STAT_WIDTH] > FRAME * width) | (
        stats[:, cv2.CC_STAT_HEIGHT] > FRAME * height
    )
    spans[0] = False
    boxed = _boxed(labels, stats, np.flatnonzero(spans), ink.shape)
    for label in np.flatnonzero(spans & ~boxed).tolist():
        around = _middle_of((0, 0, width, height))
        if not _contains_all(closed, stats[label]):
            # The paper's own middle, not the piece's: a long view has an empty one, too.
            spans[label] = _share_in(labels, stats[label], label, around) < _IN_MIDDLE
            continue
        middle = _middle_of(_box_of(stats[label]))
        spans[label] = _share_in(labels, stats[label], label, middle) < _IN_MIDDLE
    if not spans.any():
        return None
    frame = spans[labels]
    walls = frame.astype(np.uint8)
    stored = turn.scale * np.array([[0, 0], [width, 0], [width, height], [0, height]])
    corners = turn.to_upright(stored)
    cv2.polylines(walls, [np.rint(corners - 0.5).astype(np.int32)], True, 1, 5)
    _, areas, facts, _ = cv2.connectedComponentsWithStats(1 - walls, connectivity=4)
    sizes = facts[:, cv2.CC_STAT_AREA].copy()
    sizes[0] = 0
    largest = int(np.argmax(sizes))
    if sizes[largest] < _LARGEST * height * width:
        return None
    # Views are holes in the drawing area, fields are not.
    contours, _ = cv2.findContours(
        (areas == largest).astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE
    )
    area = np.zeros(ink.shape, np.uint8)
    cv2.drawContours(area, contours, -1, 1, cv2.FILLED)
    drawing_area = (area > 0) & ~frame
    marks = [Mark(AnnotationKind.FRAME, _box(stats[label])) for label in np.flatnonzero(spans)]
    fields = [
        facts[label]
        for label in np.flatnonzero(sizes)
        if label != largest and _is_field(ink, facts[label])
    ]
    marks += [Mark(AnnotationKind.TITLE_BLOCK, _box(fact)) for fact in fields]
    return Frame(drawing_area, tuple(marks))


def _box_of(facts: np.ndarray) -> tuple[int, int, int, int]:
    """Left, top, width and height of what OpenCV states of a piece."""
    left, top, width, height = (int(value) for value in facts[:4])
    return left, top, width, height


def _boxed(
    labels: np.ndarray, stats: np.ndarray, spanning: np.ndarray, shape: tuple[int, int]
) -> np.ndarray:
    """(n,) bool, pieces that stand on or beside each other, as wide or as high, and reach to the
    margins together: a box for the drawing, with an empty middle, and fields for writing."""
    found = np.zeros(len(stats), dtype=bool)
    low, extents = stats[:, :2], stats[:, 2:4]
    size = np.array(shape[::-1])
    for label in spanning:
        middle = _middle_of(_box_of(stats[label]))
        if _share_in(labels, stats[label], int(label), middle) >= _IN_MIDDLE:
            continue
        for way in (0, 1):
            apart = np.abs(low - low[label])[:, way], np.abs(extents - extents[label])[:, way]
            even = spanning[np.maximum(*apart)[spanning] <= _EVEN]
            first, last = low[even].min(axis=0), (low + extents)[even].max(axis=0)
            reach = (first <= MARGIN * size).all() and (last >= (1.0 - MARGIN) * size).all()
            if reach and any(_is_written(labels, stats[k], int(k)) for k in even if k != label):
                found[even] = True
    return found


def _is_written(labels: np.ndarray, fact: np.ndarray, label: int) -> bool:
    """Whether a piece has several fields with something in them."""
    x, y, w, h = (int(value) for value in fact[:4])
    values = labels[y : y + h, x : x + w]
    _, areas = cv2.connectedComponents((values != label).astype(np.uint8), connectivity=4)
    within = np.unique(areas[(values != label) & (values > 0)])
    return len(within) >= CELLS


def _middle_of(box: tuple[int, int, int, int]) -> tuple[slice, slice]:
    """Rows and columns of the middle of a box (x, y, width, height)."""
    x, y, w, h = box
    left, top, right, bottom = _MIDDLE
    rows = slice(y + int(top * h), y + int(bottom * h))
    return rows, slice(x + int(left * w), x + int(right * w))


def _share_in(
    labels: np.ndarray, fact: np.ndarray, label: int, middle: tuple[slice, slice]
) -> float:
    """Share of a piece's ink in a middle."""
    return float((labels[middle] == label).sum()) / float(fact[cv2.CC_STAT_AREA])


def _contains_all(ink: np.ndarray, fact: np.ndarray) -> bool:
    """Whether a piece goes around nearly all ink and most of the paper: a frame that is smaller
    than the paper, not in proportion to it."""
    x, y, w, h = (int(value) for value in fact[:4])
    large = w > FRAME * ink.shape[1] and h > FRAME * ink.shape[0]
    return large and float(ink[y : y + h, x : x + w].sum()) > NEARLY_ALL * float(ink.sum())


def _is_field(ink: Mask, fact: np.ndarray) -> bool:
    """Whether an area is a rectangle with writing in it, away from its border."""
    x, y, w, h, filled = (int(value) for value in fact)
    return filled > MOST * w * h and bool(ink[y + 2 : y + h - 2, x + 2 : x + w - 2].any())


def _box(fact: np.ndarray) -> tuple[float, float, float, float]:
    x, y, w, h = (float(value) for value in fact[:4])
    return x, y, x + w, y + h
