"""What was read of numbers and notes, as the canvas writes it at them.

The text says what is printed almost everywhere, and would hide its neighbours: it is quiet there,
and shown while the mouse is at it.  Where a person said another value, or a doubt is about the
number, it is shown all the time.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from freecad.gaussiancad.canvas.kinds import NUMBER, OTHER
from freecad.gaussiancad.canvas.sheet import Box, Point, Sheet


@dataclass(frozen=True)
class Label:
    """A text at a place of the sheet.

    Attributes:
        text: what was read, or said.
        box: around what is printed, px of the sheet.
        colour: of text and frame.
        quiet: whether it says no more than what is printed.
    """

    text: str
    box: Box
    colour: str
    quiet: bool

    def holds(self, at: Point) -> bool:
        """Whether a place is within its box."""
        x0, y0, x1, y1 = self.box
        return x0 <= at[0] <= x1 and y0 <= at[1] <= y1


def labels_of(sheet: Sheet) -> list[Label]:
    """The labels of a sheet's numbers and notes."""
    doubted = [place for row in sheet.problems if row.of_numbers for place in row.places]
    found = []
    for own in sheet.numbers:
        quiet = not own.given and not _meets_any(own.box, doubted)
        text = f"{own.value:g}" if own.given else own.text
        found.append(Label(text, own.box, NUMBER if own.used else OTHER, quiet))
    # A person says notes of circles, where nothing is printed.
    found += [Label(own.text, own.box, NUMBER, own.circle is None) for own in sheet.notes]
    return found


def _meets_any(box: Box, places: Iterable[Box]) -> bool:
    x0, y0, x1, y1 = box
    return any(x0 <= own[2] and own[0] <= x1 and y0 <= own[3] and own[1] <= y1 for own in places)
