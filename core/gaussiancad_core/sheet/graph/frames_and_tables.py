"""Frames and tables: what a sheet has before anything is drawn on it (ISO 5457, ISO 7200).

Both are level and upright lines of one pen that touch.  A frame spans most of the sheet both ways,
and reaches to its margins, in one box, or in several that stand on or beside each other; a table is
closed and divided into cells, several of which have writing in them.  Such lines that hang together
with either are a part of it, in whatever pen.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.files.vectors import StrokeKind, VectorStroke, VectorText
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.graph.free_frames import Spanning, free_frames
from gaussiancad_core.sheet.graph.stroke_groups import EVEN, Groups, grouped
from gaussiancad_core.sheet.graph.touching_ends import Flags, Floats, Ints, Touches
from gaussiancad_core.sheet.line_conventions import CELLS, FRAME, MARGIN
from gaussiancad_core.sheet.votes import NEARLY_ALL

_LEVEL = 1e-3
"""Slope of a line up to which it is level, or upright."""

_SIDES = 4
"""Lines of a box at least."""

_DIVIDING = 2
"""Lines from side to side that make a table's cells, at least."""


@dataclass(frozen=True, eq=False)
class Furniture:
    """What a sheet has besides its drawing.

    Attributes:
        lines: (n,) which strokes are lines of frames and tables.
        guessed: whether a frame of a drawing in free space may as well be the part's outline.
    """

    lines: Flags
    guessed: bool = False


def furniture(
    strokes: Sequence[VectorStroke],
    texts: Sequence[VectorText],
    touches: Touches,
    numbers: Ints,
    size: tuple[int, int],
    *,
    has_paper: bool = True,
) -> Furniture:
    """Find the lines of frames and tables.

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
    spanning: list[Spanning] = []
    for pen in np.unique(numbers[level]):
        chosen = level & (numbers == pen)
        groups = grouped(touches, chosen)
        closed = groups.means(touches.met(chosen).mean(axis=1)) >= NEARLY_ALL
        divided = closed & (groups.sums(touches.dividing(chosen)) >= _DIVIDING)
        found[_boxed_frames(groups, closed, divided, touches, size)] = True
        longest = groups.most(touches.boxes[:, 2:] - touches.boxes[:, :2])
        spans = (longest >= FRAME * np.array(size)).all(axis=1) & _fill(groups.boxes, size)
        for group in np.flatnonzero(spans | divided).tolist():
            lines = groups.members(group)
            written = divided[group] and _written_cells(touches.boxes[lines], middles) >= CELLS
            if spans[group] and not has_paper:
                spanning.append(Spanning(lines, groups.boxes[group], bool(written)))
            elif spans[group] or written:
                found[lines] = True
    annotations = np.array(
        [stroke.kind not in (StrokeKind.GEOMETRY, StrokeKind.BLOCK) for stroke in strokes],
        dtype=bool,
    )
    frames, guessed = free_frames(spanning, found, annotations, touches, texts)
    found |= frames
    every = touches.groups(level)
    return Furniture(found | np.isin(every, every[found]), guessed)


def _boxed_frames(
    groups: Groups, closed: Flags, divided: Flags, touches: Touches, size: tuple[int, int]
) -> Flags:
    """(n,) lines of groups that are closed boxes, as wide or as high as each other, which together
    reach to the margins of the sheet; one of them has cells with something in several of them."""
    boxed = np.flatnonzero(closed & (groups.counts >= _SIDES))
    boxes = groups.boxes[boxed]
    written = np.zeros(len(boxed), dtype=bool)
    asked = np.zeros(len(boxed), dtype=bool)
    found = np.zeros(len(boxed), dtype=bool)
    for way in (0, 1):
        for box in boxes:
            even = np.abs(boxes - box)[:, [way, way + 2]].max(axis=1) <= EVEN
            if found[even].all() or even.sum() < 2 or not _fill(_around(boxes[even]), size)[0]:
                continue
            for number in np.flatnonzero(even & divided[boxed] & ~asked):
                written[number] = _is_written(groups.members(boxed[number]), touches)
                asked[number] = True
            found |= even & bool(written[even].any())
    return np.isin(groups.places, boxed[found])


def _is_written(lines: Ints, touches: Touches) -> bool:
    """Whether several of the cells that lines make hold other strokes."""
    box = _around(touches.boxes[lines])[0]
    middles = (touches.boxes[:, :2] + touches.boxes[:, 2:]) / 2.0
    inside = ((middles > box[:2]) & (middles < box[2:])).all(axis=1)
    inside[lines] = False
    return _written_cells(touches.boxes[lines], middles[inside]) >= CELLS


def _around(boxes: Floats) -> Floats:
    """(1, 4) the box around some."""
    return np.concatenate([boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)])[None]


def _fill(boxes: Floats, size: tuple[int, int]) -> Flags:
    """(k,) which boxes reach to the margins of the sheet, on all four sides."""
    margin = MARGIN * np.array(size)
    return np.all((boxes[:, :2] <= margin) & (boxes[:, 2:] >= size - margin), axis=1)


def _is_level(stroke: VectorStroke) -> bool:
    curve = stroke.curve
    if not isinstance(curve, LineSegment) or curve.length <= 0.0:
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
        if all(len(bound) for bound in bounds):
            sides.append(tuple(round(float(bound.max()), 1) for bound in bounds))
    return len(set(sides))
