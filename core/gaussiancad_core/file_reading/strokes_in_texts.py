"""Strokes that draw the letters of a text that a file has as such."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.near_points import connected_groups, near_pairs
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke

TALLEST = 9.0
"""mm of a letter at most."""

_AROUND = 0.4
"""mm by which a text's drawing may reach over its box."""

_LIKE_TEXT, _BESIDES = 1.3, 0.5
"""Size of a stroke of a text's drawing at most, in the text's height, and mm besides."""

_WIDEST_PEN = 0.45
"""mm of a pen that draws texts at most."""

_MEET, _IN_LINE = 0.02, 0.9999
"""mm within which the ends of pieces of one line meet, and cosine of the angle between them."""


def strokes_within_texts(strokes: Sequence[PaperStroke], boxes: Sequence[Box]) -> list[int]:
    """Numbers of strokes that lie within the box of a text, and are no larger than its letters."""
    if not boxes or not strokes:
        return []
    around = np.array(boxes) + np.array([-_AROUND, -_AROUND, _AROUND, _AROUND])
    low, high = np.array(boxes)[:, :2], np.array(boxes)[:, 2:]
    heights = (high - low + 2.0 * _AROUND).min(axis=1)
    runs = _runs(strokes)
    found = []
    for number, stroke in enumerate(strokes):
        if stroke.size > TALLEST or stroke.pen.width >= _WIDEST_PEN:
            continue
        x0, y0, x1, y1 = runs[number]
        inside = (around[:, :2] <= (x0, y0)).all(axis=1) & (around[:, 2:] >= (x1, y1)).all(axis=1)
        if inside.any() and stroke.size < _LIKE_TEXT * heights[inside].min() + _BESIDES:
            found.append(number)
    return found


def _runs(strokes: Sequence[PaperStroke]) -> npt.NDArray[np.float64]:
    """(n, 4) mm, boxes around strokes and what goes on from them in line: of an edge that a program
    writes in pieces some lie within the box of a text, those of a letter do all."""
    boxes = np.array([stroke.box for stroke in strokes])
    lines = [number for number, stroke in enumerate(strokes) if stroke.is_line]
    if not lines:
        return boxes
    ends = np.concatenate([strokes[number].points for number in lines])
    ways = np.array([strokes[number].way for number in lines])
    pairs = near_pairs(ends, _MEET) // 2
    is_in_line = np.abs((ways[pairs[:, 0]] * ways[pairs[:, 1]]).sum(axis=1)) > _IN_LINE
    groups = connected_groups(pairs[is_in_line], len(lines))
    low, high = np.full((len(lines), 2), np.inf), np.full((len(lines), 2), -np.inf)
    np.minimum.at(low, np.repeat(groups, 2), ends)
    np.maximum.at(high, np.repeat(groups, 2), ends)
    boxes[lines] = np.concatenate([low, high], axis=1)[groups]
    return boxes
