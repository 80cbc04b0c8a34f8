"""Frames and tables: what a sheet has before anything is drawn on it (ISO 5457, ISO 7200).

Both are level and upright lines of one pen that touch.  A frame spans most of the sheet both ways,
and reaches to its margins, in one box, or in several that stand on or beside each other; a table is
closed and divided into cells, several of which have writing in them.  Such lines that hang together
with either are a part of it, in whatever pen.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.sheet.files.vectors import Line, VectorStroke, VectorText
from gaussiancad_core.sheet.graph.free_frames import goes_around_sheet
from gaussiancad_core.sheet.graph.touching import Flags, Ints, Touches

_LEVEL = 1e-3
"""Slope of a line up to which it is level, or upright."""

_SPAN = 0.6
"""Share of the sheet that the longest lines of a frame are long, level and upright, at least."""

_MARGIN = 0.15
"""Share of the sheet that its margin, a title strip or filing margin with it, is wide at most."""

_SIDES = 4
"""Lines of a box at least."""

_EVEN = 2.0
"""px within which boxes are as wide, or as high, as each other."""

_CLOSED = 0.9
"""Share of the ends of a table's lines that meet others of it, at least."""

_DIVIDING = 2
"""Lines from side to side that make a table's cells, at least."""

_CELLS = 3
"""Cells with writing that a table has at least."""


def furniture(
    strokes: Sequence[VectorStroke],
    texts: Sequence[VectorText],
    touches: Touches,
    numbers: Ints,
    size: tuple[int, int],
    *,
    has_paper: bool = True,
) -> Flags:
    """(n,) which strokes are lines of frames and tables.

    Args:
        strokes: of the sheet, px.
        texts: on it.
        touches: of the strokes.
        numbers: (n,) of each stroke's pen: one pen draws the sides of a table's cells.
        size: width and height of the sheet in px.
        has_paper: False of a drawing in free space, whose outline may span the sheet.
    """
    level = np.array([stroke.is_solid and _is_level(stroke) for stroke in strokes], dtype=bool)
    found = np.zeros(len(strokes), dtype=bool)
    middles = np.array(
        [((t.box[0] + t.box[2]) / 2.0, (t.box[1] + t.box[3]) / 2.0) for t in texts]
    ).reshape(-1, 2)
    spanning: list[tuple[Flags, bool]] = []
    for pen in np.unique(numbers[level]):
        groups = touches.groups(level & (numbers == pen))
        found |= np.isin(groups, _boxed_frames(groups, touches, size))
        for group in np.unique(groups[groups >= 0]):
            own = groups == group
            boxes = touches.boxes[own]
            longest = (boxes[:, 2:] - boxes[:, :2]).max(axis=0)
            is_frame = bool((longest >= _SPAN * np.array(size)).all()) and _fills(boxes, size)
            closed = float(touches.met(own)[own].mean())
            is_divided = closed >= _CLOSED and int(touches.dividing(own).sum()) >= _DIVIDING
            is_table = is_divided and _written_cells(boxes, middles) >= _CELLS
            if is_frame and not has_paper:
                spanning.append((own, is_table))
            elif is_frame or is_table:
                found |= own
    # The outer ones first: what they are leaves what the inner ones go around.
    for own, has_table in sorted(spanning, key=lambda each: -_spanned(touches.boxes[each[0]])):
        if goes_around_sheet(own, found, touches, texts, has_table=has_table):
            found |= own
    groups = touches.groups(level)
    return found | np.isin(groups, groups[found])


def _boxed_frames(groups: Ints, touches: Touches, size: tuple[int, int]) -> list[int]:
    """Numbers of groups that are closed boxes, as wide or as high as each other, which together
    reach to the margins of the sheet; one of them has cells with something in several of them."""
    boxes = {}
    for group in np.unique(groups[groups >= 0]):
        own = groups == group
        if own.sum() >= _SIDES and float(touches.met(own)[own].mean()) >= _CLOSED:
            low, high = touches.boxes[own, :2].min(axis=0), touches.boxes[own, 2:].max(axis=0)
            boxes[int(group)] = np.concatenate([low, high])
    found: list[int] = []
    for way in (0, 1):
        sides = [way, way + 2]
        for box in boxes.values():
            even = [k for k, own in boxes.items() if np.abs(own - box)[sides].max() <= _EVEN]
            reach = len(even) > 1 and _fills(np.array([boxes[k] for k in even]), size)
            if reach and any(_is_written(groups == k, touches) for k in even):
                found += even
    return found


def _is_written(own: Flags, touches: Touches) -> bool:
    """Whether lines make several cells that hold other strokes."""
    low, high = touches.boxes[own, :2].min(axis=0), touches.boxes[own, 2:].max(axis=0)
    middles = (touches.boxes[:, :2] + touches.boxes[:, 2:]) / 2.0
    inside = ~own & ((middles > low) & (middles < high)).all(axis=1)
    divided = int(touches.dividing(own).sum()) >= _DIVIDING
    return divided and _written_cells(touches.boxes[own], middles[inside]) >= _CELLS


def _fills(boxes: np.ndarray, size: tuple[int, int]) -> bool:
    """Whether lines reach to the margins of the sheet, on all four sides."""
    margin = _MARGIN * np.array(size)
    low, high = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    return bool((low <= margin).all() and (high >= size - margin).all())


def _spanned(boxes: np.ndarray) -> float:
    """px^2 of the box around lines."""
    return float(np.prod(boxes[:, 2:].max(axis=0) - boxes[:, :2].min(axis=0)))


def _is_level(stroke: VectorStroke) -> bool:
    curve = stroke.curve
    if not isinstance(curve, Line) or curve.length <= 0.0:
        return False
    across = abs(np.subtract(curve.end, curve.start)).min()
    return bool(across <= _LEVEL * curve.length)


def _written_cells(boxes: np.ndarray, middles: np.ndarray) -> int:
    """How many cells between level and upright lines have the middle of a text, or of what may be
    one, in them.

    A cell is bounded by lines on all four sides, which reach over the place.
    """
    sides = []
    for x, y in middles:
        level = (boxes[:, 0] <= x) & (x <= boxes[:, 2])
        upright = (boxes[:, 1] <= y) & (y <= boxes[:, 3])
        rows, columns = boxes[level, 1], boxes[upright, 0]
        bounds = (rows[rows < y], -rows[rows > y], columns[columns < x], -columns[columns > x])
        if all(len(own) for own in bounds):
            sides.append(tuple(round(float(own.max()), 1) for own in bounds))
    return len(set(sides))
