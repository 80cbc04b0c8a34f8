"""Writing that a file draws stroke by stroke, as plotters do, and has no texts for.

A letter is some strokes that touch each other and nothing else, small beside the sheet.  So are
other small signs: what each says, if anything, is for those who read it.
"""

from gaussiancad_core.sheet.graph.groups import grouped
from gaussiancad_core.sheet.graph.touching import Flags, Touches
from gaussiancad_core.sheet.labels.words import written_lines
from gaussiancad_core.sheet.options import Box

_TALLEST = 0.03
"""Size of a letter at most, as a share of the sheet's longest side."""

_PITCH = 1.2
"""Distance of two letters' middles at most, in the larger one's height: plotted letters are up to
as wide as high, and all have the same space."""


def drawn_lines_of_writing(
    touches: Touches, annotations: Flags, size: tuple[int, int]
) -> list[Box]:
    """The boxes of lines of writing, px.

    Args:
        touches: of all strokes.
        annotations: (n,) which strokes are no edges, frames or hatching.
        size: width and height of the sheet in px.
    """
    if not annotations.any():
        return []
    groups = grouped(touches, annotations)
    free = groups.sums(touches.met_by(~annotations).any(axis=1)) == 0
    small = groups.sizes.max(axis=1) <= _TALLEST * max(size)
    letters = groups.boxes[small & free]
    return written_lines([(x0, y0, x1, y1) for x0, y0, x1, y1 in letters], _PITCH)
