"""How often the strokes of a sheet meet each other: faces between them take as long as that."""

from collections.abc import Sequence

import shapely

from gaussiancad_core.errors import LimitError
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, lines_of
from gaussiancad_protocol.codes import Code

MOST_CROSSINGS = 60_000
"""Pairs of strokes that meet, over which a sheet is no drawing: so many are read within half
a minute."""

_ASKED = 400
"""Strokes that are asked how many others they meet, at most twice."""


def check_crossings(strokes: Sequence[PaperStroke]) -> None:
    """Refuse strokes that meet each other too often.

    Raises:
        LimitError: ``too-many-elements``.
    """
    if meetings(strokes) > MOST_CROSSINGS:
        raise LimitError(
            Code.TOO_MANY_ELEMENTS,
            "the lines of the sheet cross each other more than {most:,} times: save only the "
            "views, or export it as PNG",
            case="crossings",
            most=MOST_CROSSINGS,
        )


def meetings(strokes: Sequence[PaperStroke]) -> float:
    """Pairs of strokes that meet: counted where they are few, else told by some of them."""
    if not strokes:
        return 0.0
    lines = lines_of(strokes)
    asked = lines[:: max(1, len(lines) // _ASKED)]
    met = shapely.STRtree(lines).query(asked, "intersects").shape[1] - len(asked)
    return 0.5 * met * len(lines) / len(asked)
