"""Numbers of the sheet that are others in the body that was made of it: where they are, and what
is said of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freecad.gaussiancad.canvas.rows import Line
from freecad.gaussiancad.canvas.sheet import Number, Sheet
from freecad.gaussiancad.language import translate

CHANGED = "#7b1fa2"
"""Colour of what is another in the body."""

_NEAR = 0.005
"""Share by which a number of the sheet may differ from the one that drives the body: what was
measured on a picture was rounded."""

_ARROW = "\u2192"


@dataclass(frozen=True)
class Change:
    """A number that is another in the body.

    Attributes:
        name: of the number in the body.
        on_sheet, now: mm.
    """

    name: str
    on_sheet: float
    now: float


def numbers_of(change: Change, sheet: Sheet) -> list[Number]:
    """The numbers of a sheet that a change may be of; of several nobody knows which."""
    same = [n for n in sheet.numbers if abs(n.value - change.on_sheet) <= _NEAR * abs(n.value)]
    return [number for number in same if number.used] or same


def new_texts(sheet: Sheet, changes: Sequence[Change]) -> dict[str, str]:
    """What is written at numbers whose value is another in the body, by their ids.

    Where several numbers are alike, each may be the one that was changed: it has a question mark.
    """
    texts: dict[str, str] = {}
    for change in changes:
        found = numbers_of(change, sheet)
        for number in found:
            now = f"{change.now / _mm_per_unit(sheet):.6g}"
            sure = "" if len(found) == 1 else "?"
            before = texts.get(number.id, number.text)
            texts[number.id] = f"{before} {_ARROW} {now}{sure}"
    return texts


def change_lines(sheet: Sheet, changes: Sequence[Change], back: Callable[[], None]) -> list[Line]:
    """Rows of the list at the canvas, the first one with the way back."""
    if not changes:
        return []
    said = translate("GaussianCAD", "In the body numbers are others than on the sheet")
    text = translate("GaussianCAD", "Back to the Sheet's Numbers")
    lines = [Line(said, buttons=((text, back),), colour=CHANGED)]
    row = translate("GaussianCAD", "{name}: {sheet} mm on the sheet, {now} mm in the body")
    for change in changes:
        found = numbers_of(change, sheet)
        stated = row.format(
            name=change.name, sheet=f"{change.on_sheet:.6g}", now=f"{change.now:.6g}"
        )
        lines.append(Line(stated, found[0].box if found else None))
    return lines


def _mm_per_unit(sheet: Sheet) -> float:
    return 25.4 if sheet.unit == "in" else 1.0
