"""Where the sheet of a DXF page lies: its paper, or the drawing itself where it has none."""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.files.dxf_text import PlacedText
from gaussiancad_core.geometry.points import Box

_MARGIN = 0.05
"""Blank border around a drawing without paper, as a share of its longest side."""

_LEAST_USE = 0.15
"""A drawing that is smaller than this share of the limits was not drawn for them."""

_OVERHANG = 0.02
"""Share of the paper by which a drawing may reach over it."""

_EDGE = 5e-4
"""Share of the paper that stays blank where it does, so that the outermost line is whole; a drawing
that comes as near to a side reaches it."""

_BESIDE = 1.0
"""Distance of a note from the drawing that it belongs to at most, as a share of the drawing's
longest side: what lies farther away would make the drawing itself small."""


def paper_box(box: Box, limits: Box | None) -> Box | None:
    """The paper of a drawing: its limits, if it was drawn for them; None where it was not.

    Where the drawing reaches a little over the limits, they are widened on that side.  A drawing
    that begins at their corner and ends within them, with no frame around it, was drawn for no
    paper: programs that write files without asking for one give all of them the same limits, and
    half of the outermost lines would lie outside.

    Args:
        box: (x0, y0, x1, y1) around the drawing's curves, in its units, y up.
        limits: as the file says, in the same.
    """
    longest = max(box[2] - box[0], box[3] - box[1])
    if limits is None:
        return None
    paper = max(limits[2] - limits[0], limits[3] - limits[1])
    over = (limits[0] - box[0], limits[1] - box[1], box[2] - limits[2], box[3] - limits[3])
    reached = [abs(reach) <= _EDGE * paper for reach in over]
    meant = longest >= _LEAST_USE * paper and (all(reached) or not any(reached))
    if meant and paper > 0.0 and max(over) <= _OVERHANG * paper:
        left, bottom, right, top = (reach + _EDGE * paper if reach > 0.0 else 0.0 for reach in over)
        return (limits[0] - left, limits[1] - bottom, limits[2] + right, limits[3] + top)
    return None


def drawing_box(box: Box, texts: Sequence[PlacedText]) -> Box:
    """What stands for the paper of a drawing that has none: all that is drawn, with a margin.

    Args:
        box: (x0, y0, x1, y1) around the drawing's curves, in its units, y up.
        texts: of the drawing; those beside it belong to it, each as far as it lies beside it.
    """
    low, high = np.array(box[:2]), np.array(box[2:])
    offset = _BESIDE * float((high - low).max())
    farthest = np.array(box[:2]) - offset, np.array(box[2:]) + offset
    for text in texts:
        c, s = abs(np.cos(text.angle)), abs(np.sin(text.angle))
        half = np.array([text.length * c + text.height * s, text.length * s + text.height * c]) / 2
        first, last = np.array(text.centre) - half, np.array(text.centre) + half
        if (last >= farthest[0]).all() and (first <= farthest[1]).all():
            low = np.minimum(low, np.maximum(first, farthest[0]))
            high = np.maximum(high, np.minimum(last, farthest[1]))
    margin = _MARGIN * float((high - low).max())
    (x0, y0), (x1, y1) = (low - margin).tolist(), (high + margin).tolist()
    return x0, y0, x1, y1
