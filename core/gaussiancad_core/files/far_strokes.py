"""Strokes that lie so far from all others that they are none of the drawing: what programs leave
at absurd places would make the drawing itself a dot."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.content import Note
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.messages import Message
from gaussiancad_protocol.codes import Code

_APART = 50.0
"""Distance from the middle of a drawing, in its size, from which a stroke is none of it: a part
beside it would have some 60 of the 3000 px of a sheet."""

_ENDLESS = 5000.0
"""The same of strokes that go through the drawing or around it, such as the sides of a long bar
around a hole."""


def near_numbers(curves: Sequence[Curve]) -> npt.NDArray[np.int64]:
    """Numbers of the curves that are the drawing: at least half of them, with all that reach no
    farther than some times as far from their middle.

    Args:
        curves: in any unit.
    """
    boxes = np.array([curve.box for curve in curves], dtype=np.float64).reshape(-1, 4)
    finite = np.flatnonzero(np.isfinite(boxes).all(axis=1))
    if len(finite) < 2:
        return finite
    low, high = boxes[finite, :2], boxes[finite, 2:]
    middle = np.median((low + high) / 2.0, axis=0)
    reach = np.maximum(np.abs(low - middle), np.abs(high - middle)).max(axis=1)
    apart = np.maximum(low - middle, middle - high).max(axis=1)
    order = np.argsort(reach, kind="stable")
    least = (len(order) + 1) // 2
    within = reach[order][least - 1 : -1]
    # The nearest of all that reach farther than each.
    nearest = np.minimum.accumulate(apart[order][::-1])[::-1][least:]
    is_end = (reach[order][least:] > _ENDLESS * within) | (nearest > _APART * within)
    is_end &= within > 0.0
    if not is_end.any():
        return finite
    return np.sort(finite[order[: least + int(np.argmax(is_end))]])


def far_strokes_left_out(path: Path, count: int) -> tuple[Note, ...]:
    """That strokes were left out as they lie far from all others, if any were.

    Args:
        path: of the file.
        count: of the strokes.
    """
    if not count:
        return ()
    message = Message(
        "{name} has {count} line(s) far from all others, which were left out: remove them where "
        "they show nothing",
        name=path.name,
        count=count,
        case="far",
    )
    return (Note(Code.LINES_LEFT_OUT, message),)
