"""Frames of drawings in free space, which no paper tells from an outline.

The box around a drawing that has no paper is the drawing's own: a plate with holes spans it as a
frame does.  A frame goes around everything, notes and dimensions with it, and holds what a part's
outline cannot: closed lines within closed lines (a view with a hole, which would lie in the air
otherwise), a table, or writing beside lines of other pens alone.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.sheet.files.vectors import VectorText
from gaussiancad_core.sheet.graph.touching import Flags, Ints, Touches

_CLOSED = 0.9
"""Share of the lines of a group that are closed, or meet others of it at both ends, at least: as of
tables."""

_EVEN = 2.0
"""px by which what lies within a box may reach over it: half of a wide line (ISO 128-2)."""


def goes_around_sheet(
    own: Flags,
    found: Flags,
    touches: Touches,
    numbers: Ints,
    texts: Sequence[VectorText],
    *,
    has_table: bool,
) -> bool:
    """Whether lines that span a drawing in free space are its frame, and not a part's outline.

    Args:
        own: (n,) the lines.
        found: (n,) lines of frames around these, and of tables.
        touches: of the strokes.
        numbers: (n,) of each stroke's pen.
        texts: of the drawing.
        has_table: whether a table hangs together with them.
    """
    low, high = _extent(touches, own)
    rest = ~own & ~found
    held = _within(touches.boxes, low, high)
    written = _within(np.array([text.box for text in texts]).reshape(-1, 4), low, high)
    if not rest.any() or not held[rest].all() or not written.all():
        return False
    if has_table or _is_nested(rest, touches):
        return True
    return bool(len(texts)) and not np.isin(numbers[rest], numbers[own]).any()


def _is_nested(rest: Flags, touches: Touches) -> bool:
    """Whether some lines are closed and hold others that are."""
    closed = touches.closed | (rest & touches.met(rest).all(axis=1))
    groups = touches.groups(rest)
    boxes = []
    for group in np.unique(groups[rest]):
        own = groups == group
        if float(closed[own].mean()) >= _CLOSED:
            boxes.append(np.concatenate(_extent(touches, own)))
    around = np.array(boxes).reshape(-1, 4)
    return any(bool((_within(around, box[:2], box[2:])).sum() > 1) for box in boxes)


def _extent(touches: Touches, own: Flags) -> tuple[np.ndarray, np.ndarray]:
    return touches.boxes[own, :2].min(axis=0), touches.boxes[own, 2:].max(axis=0)


def _within(boxes: np.ndarray, low: np.ndarray, high: np.ndarray) -> Flags:
    """(n,) which boxes lie within another."""
    inside = (boxes[:, :2] >= low - _EVEN) & (boxes[:, 2:] <= high + _EVEN)
    found: Flags = inside.all(axis=1)
    return found
