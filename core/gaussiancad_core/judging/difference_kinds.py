"""In what a solid and a sheet differ between two lines of sight, and what a mm of it costs."""

from enum import Enum

import numpy as np

from gaussiancad_core.judging.drawn_lines import DrawnView
from gaussiancad_core.judging.faceted_solids import Numbers
from gaussiancad_core.judging.lines_of_sight import Seen
from gaussiancad_core.judging.sight_pairs import Drawn


class Kind(Enum):
    """In what a solid and a sheet differ at a place."""

    MISSING = "missing"
    MISSING_HIDDEN = "missing-hidden"
    EXTRA = "extra"
    EXTRA_HIDDEN = "extra-hidden"
    LINETYPE = "linetype"
    TANGENT = "tangent"
    HATCHING = "hatching"


KINDS = tuple(Kind)
"""In the order of their numbers."""

NO_KIND = -1
"""Number of what does not differ."""

NUMBER = {kind: number for number, kind in enumerate(KINDS)}
"""Number of each kind."""

PRICES = {
    Kind.MISSING: 1.0,
    Kind.MISSING_HIDDEN: 0.7,
    Kind.EXTRA: 1.0,
    Kind.EXTRA_HIDDEN: 0.7,
    Kind.LINETYPE: 0.35,
    Kind.TANGENT: 0.1,
    Kind.HATCHING: 1.0,
}
"""What a mm of line costs.  A smooth edge costs something where it is drawn as an edge on a sheet
that is not known to draw such edges, and a tangent edge of the sheet where the solid has none; what
is hidden is often left out, and a linetype is the least sure of what a reader tells."""

PRICES_OF_NUMBERS = np.array([PRICES[kind] for kind in KINDS])
"""The same by the kinds' numbers."""


def kinds_between(
    signs: Seen, ends: tuple[Numbers, Numbers], drawn: Numbers, view: DrawnView
) -> Numbers:
    """(p,) number of the kind in which each pair differs from what is drawn; -1 where it does not.

    A tangent edge of the sheet is explained by a smooth edge of the solid, and by what is hidden
    under it.  An edge of the sheet is a smooth one of the solid where the view draws such edges.

    Args:
        signs: of lines of sight.
        ends: (p,) numbers of the two of each pair.
        drawn: (p,) a :class:`Drawn` each.
        view: of the sheet, with what it draws and what it leaves out.
    """
    one, other = ends
    same = signs.sharp[one] == signs.sharp[other]
    shown = signs.first[one] != signs.first[other]
    smooth = same & (signs.every[one] != signs.every[other])
    nothing, visible, hidden, tangent = (drawn == each for each in Drawn)
    kind = np.full(len(drawn), NO_KIND)
    kind[nothing & ~same & shown] = NUMBER[Kind.EXTRA]
    if view.draws_hidden:
        kind[nothing & ~same & ~shown] = NUMBER[Kind.EXTRA_HIDDEN]
    kind[visible & same] = NUMBER[Kind.MISSING]
    kind[hidden & same] = NUMBER[Kind.MISSING_HIDDEN]
    kind[(visible | hidden) & smooth] = NO_KIND if view.draws_tangents else NUMBER[Kind.TANGENT]
    kind[tangent & same & ~smooth] = NUMBER[Kind.TANGENT]
    kind[tangent & ~same & shown] = NUMBER[Kind.LINETYPE]
    kind[visible & ~same & ~shown] = NUMBER[Kind.LINETYPE]
    kind[hidden & ~same & shown] = NUMBER[Kind.LINETYPE]
    return kind
