"""Writing that a file draws, stroke by stroke as plotters do or as filled shapes, and has no texts
for.

A letter is some strokes that touch each other and nothing else, small beside the sheet, or a small
shape that is no arrowhead.  So are other small signs: what each says, if anything, is for those who
read it.
"""

from collections.abc import Iterable, Sequence

import numpy as np

from gaussiancad_core.files.vectors import StrokeKind, VectorStroke
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.sheet.graph.stroke_groups import grouped
from gaussiancad_core.sheet.graph.touching_ends import Flags, Touches
from gaussiancad_core.sheet.labels.writing_lines import written_lines
from gaussiancad_core.sheet.reading_options import Box

_TALLEST = 0.03
"""Size of a letter at most, as a share of the sheet's longest side."""

_PITCH = 1.2
"""Distance of two letters' middles at most, in the larger one's height: plotted letters are up to
as wide as high, and all have the same space."""


def drawn_lines_of_writing(
    touches: Touches, annotations: Flags, size: tuple[int, int], filled: Iterable[Box] = ()
) -> list[Box]:
    """The boxes of lines of writing, px.

    Args:
        touches: of all strokes.
        annotations: (n,) which strokes are no edges, frames or hatching.
        size: width and height of the sheet in px.
        filled: boxes of filled letters.
    """
    tallest = _TALLEST * max(size)
    letters = list(filled)
    if annotations.any():
        groups = grouped(touches, annotations)
        free = groups.sums(np.any(touches.met_by(~annotations), axis=1)) == 0
        small = groups.sizes.max(axis=1) <= tallest
        letters += [(x0, y0, x1, y1) for x0, y0, x1, y1 in groups.boxes[small & free].tolist()]
    return written_lines(letters, _PITCH)


def filled_letters(
    strokes: Iterable[VectorStroke], heads: Sequence[Head], size: tuple[int, int]
) -> list[Box]:
    """The boxes of the filled shapes of a drawing that are as small as letters, and no arrowheads,
    px.

    Args:
        strokes: of the drawing.
        heads: its arrowheads.
        size: width and height of the sheet in px.
    """
    tallest = _TALLEST * max(size)
    tips = {(round(x), round(y)) for x, y in (head.tip for head in heads)}
    boxes = (stroke.curve.box for stroke in strokes if stroke.kind is StrokeKind.FILL)
    return [
        box
        for box in boxes
        if max(box[2] - box[0], box[3] - box[1]) <= tallest and not _has_tip(box, tips)
    ]


def _has_tip(box: Box, tips: set[tuple[int, int]]) -> bool:
    """Whether the tip of a head lies at a corner or a side of a box."""
    x0, y0, x1, y1 = (round(value) for value in box)
    return any((x, y) in tips for x in range(x0, x1 + 1) for y in (y0, y1)) or any(
        (x, y) in tips for x in (x0, x1) for y in range(y0, y1 + 1)
    )
