"""Lines that lead from a text to what it tells of."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import LEFT, RIGHT, Board
from learning.sheets.chains_of_points import circle, norm, segment, shifted, unit

_SHORTEST_PX = 4.0
"""px of a leader at least."""

_ROW = 1.5
"""Heights of the text from line to line."""


def leader(board: Board, tip: npt.ArrayLike, knee: npt.ArrayLike, texts: Sequence[str]) -> None:
    """A leader with lines of text.

    Args:
        board: to draw with.
        tip: (2,) what it points at.
        knee: (2,) where it bends towards the text.
        texts: one under the other.
    """
    tip, knee = np.asarray(tip, dtype=np.float64), np.asarray(knee, dtype=np.float64)
    if norm(tip - knee) < _SHORTEST_PX:
        return
    style, height = board.style, board.style.height
    rightward = (knee[0] >= tip[0]) == board.likely(0.95)
    sign = 1.0 if rightward else -1.0
    end = shifted(knee, sign * height * board.chance.choice([0.0, 0.6, 1.0, 1.5]), 0.0)
    if board.likely(0.85):
        board.arrow(tip, unit(tip - knee))
    else:
        dot = circle(tip, 0.14 * height + 1.0)
        board.canvas.fill(dot, InkClass.DIMENSION, style.darkness.dimension)
    line = [tip, knee, end]
    under = board.likely(0.3)
    if under:
        line.append(
            shifted(end, sign * 0.6 * height * max(len(this_text) for this_text in texts), 0.0)
        )
    board.thin([np.array(line)])
    rise = 0.75 * height if under else 0.5 * _ROW * height * (len(texts) - 1)
    for row, text in enumerate(texts):
        at = shifted(end, sign * (1.0 if under else 3.0), row * _ROW * height - rise)
        board.write(text, at, LEFT if rightward else RIGHT)


def balloon(board: Board, tip: npt.ArrayLike) -> None:
    """The number of an item in a circle, led to it."""
    tip = np.asarray(tip, dtype=np.float64)
    end, radius = board.near(tip, 3.0, 8.0), board.heights(0.9, 1.4)
    centre = end + unit(end - tip) * radius
    board.thin([segment(tip, end), circle(centre, radius)])
    board.write(str(board.chance.randint(1, 20)), centre)
