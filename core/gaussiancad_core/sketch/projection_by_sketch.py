"""First or third angle: the reading under which the sheet's lines fit together.

Where exact solids do not tell (:mod:`gaussiancad_core.run.exact_stage`), sketches do.  Under the
other reading each view beside the front is its opposite, and the part is mirrored.  The outlines do
not tell the two apart, but what hides what does: the part of either reading that explains the lines
best leaves more of them unexplained where the reading is wrong.  Where both leave as much, both
readings mostly show one and the same part.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.sheet.views.sheet_layout import is_unusual
from gaussiancad_core.sketch.sketching import Sketch, sketch

_CLEAR = 0.1
"""Share of what the one sketch leaves unexplained that the other leaves more, for its reading to be
clearly the worse."""

_CLEAR_UNUSUAL = 0.3
"""The same where the better one has a view from below in place of one from above."""


_LIKELIER = 0.01
"""The same for its reading to be the less likely, where nothing else tells."""

_TELLING = 0.25
"""Share of the lines' length that the better sketch costs at most for anything to be clear: what
hardly fits is no better for fitting a little less badly."""

_PLAIN = 1.0
"""The same for it to be so whatever a projection symbol says: title blocks are copied."""


class ReadViews(Protocol):
    """What was read of a part's views, of a sheet or not."""

    @property
    def drawn(self) -> DrawnViews:
        """The lines of the views."""

    @property
    def numbered(self) -> DrawnViews:
        """The same with what the sheet's numbers say of lengths."""

    @property
    def grid(self) -> float:
        """mm within which lines are one."""

    @property
    def is_alone(self) -> bool:
        """Whether it is one view."""


@dataclass(frozen=True, eq=False)
class Weighed:
    """How well the readings of a sheet are sketched.

    Attributes:
        sketches: of each reading; None where there is none.
        likelier: number of the reading whose sketch explains more, as far as these were searched;
            the first where all do alike.
        is_clear: whether it clearly does.
        is_plain: whether it does even against a symbol.
    """

    sketches: tuple[Sketch | None, ...]
    likelier: int
    is_clear: bool
    is_plain: bool = False


def weigh(readings: Sequence[ReadViews]) -> Weighed:
    """Sketch the part under each reading of a sheet.

    Args:
        readings: one or two, the first as the views are named.
    """
    sketches = tuple(sketch(reading.numbered, reading.grid) for reading in readings)
    known = {number: sketch for number, sketch in enumerate(sketches) if sketch is not None}
    if len(known) < len(readings) or len(readings) == 1:
        return Weighed(sketches, min(known, default=0), is_clear=False)
    best = min(known, key=lambda number: known[number].energy)
    least = known[best].energy
    # Whether a search that was not ended finds less for the other one, nobody knows.
    most = known[1 - best].at_least
    unusual = is_unusual(readings[best].drawn.roles)
    telling = least <= _TELLING * sum(
        stroke.length for strokes in readings[best].drawn.strokes.values() for stroke in strokes
    )
    clear = telling and most > (1.0 + (_CLEAR_UNUSUAL if unusual else _CLEAR)) * least
    if clear:
        return Weighed(sketches, best, clear, most > (1.0 + _PLAIN) * least)
    # A search that was not ended tells no unusual reading.
    likelier = _likelier(known)
    if likelier is None or not telling or is_unusual(readings[likelier].drawn.roles):
        likelier = 0
    return Weighed(sketches, likelier, is_clear=False)


def _likelier(known: Mapping[int, Sketch]) -> int | None:
    """The reading whose part leaves less unexplained, or else whose slabs cost less; None where
    both do alike."""
    values: tuple[Callable[[Sketch], float], ...] = (
        lambda found: found.unexplained,
        lambda found: found.energy,
    )
    for value in values:
        one, other = sorted(known, key=lambda number: value(known[number]))
        if value(known[other]) > (1.0 + _LIKELIER) * value(known[one]):
            return one
    return None
