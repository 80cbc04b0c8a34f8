"""What was read of numbers and notes, as the canvas writes it at them.

The text says what is printed almost everywhere, and would hide its neighbours: it is quiet there,
and shown while the mouse is at it.  Where a person said another value, or a doubt is about the
number, it is shown all the time.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from freecad.gaussiancad.canvas.changes import CHANGED, Change, new_texts
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


def labels_of(sheet: Sheet, changes: Sequence[Change] = ()) -> list[Label]:
    """The labels of a sheet's numbers and notes.

    Args:
        sheet: has them.
        changes: numbers that are others in the body.
    """
    changed = new_texts(sheet, changes)
    doubted = [place for row in sheet.problems if row.of_numbers for place in row.places]
    found = []
    for number in sheet.numbers:
        if number.id in changed:
            found.append(Label(changed[number.id], number.box, CHANGED, quiet=False))
            continue
        quiet = not number.given and not _meets_any(number.box, doubted)
        text = f"{number.value:g}" if number.given else number.text
        found.append(Label(text, number.box, NUMBER if number.used else OTHER, quiet))
    # A person says notes of circles, where nothing is printed.
    found += [Label(note.text, note.box, NUMBER, note.circle is None) for note in sheet.notes]
    return found


def _meets_any(box: Box, places: Iterable[Box]) -> bool:
    x0, y0, x1, y1 = box
    return any(
        x0 <= place[2] and place[0] <= x1 and y0 <= place[3] and place[1] <= y1 for place in places
    )
