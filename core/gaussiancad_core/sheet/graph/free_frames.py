"""Frames of drawings in free space, which no paper tells from an outline.

The box around a drawing that has no paper is the drawing's own: a plate with holes spans it as a
frame does.  A frame goes around everything, notes and dimensions with it, and holds what a part's
outline cannot: closed lines within closed lines (a view with a hole, which would lie in the air
otherwise), lines that end on others of it (edges within a view; holes have none), or a table.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.sheet.files.vectors import VectorText
from gaussiancad_core.sheet.graph.touching import Flags, Ints, Touches

_CLOSED = 0.9
"""Share of the lines of a group that are closed, or meet others of it at both ends, at least: as of
tables."""

_VIEW = 0.1
"""Share of a frame's width and height that a view in it has at least: engraved letters have
less."""

_EVEN = 2.0
"""px by which what lies within a box may reach over it: half of a wide line (ISO 128-2)."""


def goes_around_sheet(
    own: Flags,
    found: Flags,
    touches: Touches,
    texts: Sequence[VectorText],
    *,
    has_table: bool,
) -> bool:
    """Whether lines that span a drawing in free space are its frame, and not a part's outline.

    Args:
        own: (n,) the lines.
        found: (n,) lines of frames around these, and of tables.
        touches: of the strokes.
        texts: of the drawing.
        has_table: whether a table hangs together with them.
    """
    low, high = _extent(touches, own)
    rest = ~own & ~found
    held = _within(touches.boxes, low, high)
    written = _within(np.array([text.box for text in texts]).reshape(-1, 4), low, high)
    if not rest.any() or not held[rest].all() or not written.all():
        return False
    if has_table:
        return True
    groups = touches.groups(rest)
    large = [
        own for own in np.unique(groups[rest]) if _is_large(touches, groups == own, high - low)
    ]
    divided = touches.dividing(rest)
    return any(bool(divided[groups == own].any()) for own in large) or _is_nested(
        groups, large, rest, touches
    )


def _is_large(touches: Touches, own: Flags, size: np.ndarray) -> bool:
    """Whether some lines are as large as a view."""
    low, high = _extent(touches, own)
    return bool((high - low >= _VIEW * size).all())


def _is_nested(groups: Ints, large: Sequence[int], rest: Flags, touches: Touches) -> bool:
    """Whether closed lines as large as a view hold others that are closed; circles around one
    middle are a hole with a counterbore or countersink."""
    closed = touches.closed | touches.met(rest).all(axis=1)
    boxes = {
        number: np.concatenate(_extent(touches, own))
        for number in np.unique(groups[rest])
        for own in [groups == number]
        if float(closed[own].mean()) >= _CLOSED
    }
    for number in large:
        if number not in boxes:
            continue
        around = boxes[number]
        held = np.array([box for k, box in boxes.items() if k != number]).reshape(-1, 4)
        held = held[_within(held, around[:2], around[2:])]
        if int((groups == number).sum()) == 1:
            apart = np.abs(held[:, :2] + held[:, 2:] - around[:2] - around[2:]).max(axis=1) / 2.0
            held = held[apart > _EVEN]
        if len(held):
            return True
    return False


def _extent(touches: Touches, own: Flags) -> tuple[np.ndarray, np.ndarray]:
    return touches.boxes[own, :2].min(axis=0), touches.boxes[own, 2:].max(axis=0)


def _within(boxes: np.ndarray, low: np.ndarray, high: np.ndarray) -> Flags:
    """(n,) which boxes lie within another."""
    inside = (boxes[:, :2] >= low - _EVEN) & (boxes[:, 2:] <= high + _EVEN)
    found: Flags = inside.all(axis=1)
    return found
