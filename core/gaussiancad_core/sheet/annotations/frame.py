"""The frame around a drawing, its zone marks and title block (ISO 5457, ISO 7200).

The frame is the ink that spans nearly the whole sheet.  The title block hangs together with it.
What it encloses are areas: the largest is where the part is drawn, all others are fields.
"""

from dataclasses import dataclass

import cv2
import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.marks import Mark, Mask

_SPAN = 0.75
"""Share of the sheet that a frame spans both ways."""

_LARGEST = 0.3
"""Share of the sheet that the drawing area has at least: less is a view drawn large."""

_FILLED = 0.05
"""Share of its box that a frame inks at most."""


@dataclass(frozen=True, eq=False)
class Frame:
    """The frame of a sheet.

    Attributes:
        drawing_area: (h, w) bool, where the part may be drawn.
        marks: the frame itself and the fields.
    """

    drawing_area: Mask
    marks: tuple[Mark, ...]


def find_frame(ink: Mask) -> Frame | None:
    """The frame of a sheet, or nothing where it has none."""
    height, width = ink.shape
    # Lines of one pixel that a scan broke still hold together.
    closed = cv2.dilate(ink.astype(np.uint8), np.ones((3, 3), np.uint8))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    spans = (stats[:, cv2.CC_STAT_WIDTH] > _SPAN * width) & (
        stats[:, cv2.CC_STAT_HEIGHT] > _SPAN * height
    )
    spans &= stats[:, cv2.CC_STAT_AREA] < _FILLED * height * width
    spans[0] = False
    if not spans.any():
        return None
    frame = spans[labels]
    _, areas, facts, _ = cv2.connectedComponentsWithStats((~frame).astype(np.uint8), connectivity=4)
    sizes = facts[:, cv2.CC_STAT_AREA].copy()
    sizes[0] = 0
    # What reaches the border of the sheet lies outside of the frame.
    border = np.concatenate([areas[0], areas[-1], areas[:, 0], areas[:, -1]])
    sizes[np.unique(border)] = 0
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
    written = [
        facts[label]
        for label in np.flatnonzero(sizes)
        if label != largest and _is_written(ink, facts[label])
    ]
    marks += [Mark(AnnotationKind.TITLE_BLOCK, _box(fact)) for fact in written]
    return Frame(drawing_area, tuple(marks))


def _is_written(ink: Mask, fact: np.ndarray) -> bool:
    """Whether there is ink in a field, away from its border."""
    x, y, w, h = (int(value) for value in fact[:4])
    return bool(ink[y + 2 : y + h - 2, x + 2 : x + w - 2].any())


def _box(fact: np.ndarray) -> tuple[float, float, float, float]:
    x, y, w, h = (float(value) for value in fact[:4])
    return x, y, x + w, y + h
