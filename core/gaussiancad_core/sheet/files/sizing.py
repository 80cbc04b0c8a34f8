"""How many pixels a drawing gets: 200 a paper inch, less if memory does not suffice for these, and
others if its size is no paper's."""

from dataclasses import dataclass
from math import sqrt
from pathlib import Path

from gaussiancad_core.messages import Message
from gaussiancad_core.sheet.files.content import MAX_PIXELS, MOST_WORKED_ON, VECTOR_DPI, Note

_SMALLEST, _LARGEST = 2.0, 104.0
"""Inches: longest side of what is taken for paper; twice A0 is 93.6 inches long."""

_FREE_SIDE = 3000.0
"""px: longest side of a drawing that is no paper."""


@dataclass(frozen=True)
class Sizing:
    """Scale of a drawing's raster.

    Attributes:
        scale: px per unit of the drawing.
        pixels_per_inch: of paper; None if the drawing's size is no paper's.
    """

    scale: float
    pixels_per_inch: float | None


def size_drawing(width: float, height: float, inches_per_unit: float) -> Sizing:
    """Choose the scale of a drawing.

    Args:
        width, height: units of the drawing.
        inches_per_unit: of paper.
    """
    longest = max(width, height)
    pixels = width * height * (inches_per_unit * VECTOR_DPI) ** 2
    if _SMALLEST <= longest * inches_per_unit <= _LARGEST and pixels <= MAX_PIXELS:
        dpi = paper_dpi(width * inches_per_unit, height * inches_per_unit)
        return Sizing(inches_per_unit * dpi, dpi)
    return Sizing(_FREE_SIDE / longest, None)


def paper_dpi(width: float, height: float) -> float:
    """px per inch at which paper of so many inches is drawn."""
    return min(VECTOR_DPI, sqrt(MOST_WORKED_ON / (width * height)))


def notes_on(path: Path, dpi: float | None) -> tuple[Note, ...]:
    """That a drawing on paper was drawn at less than usual, if it was."""
    if dpi is None or dpi >= VECTOR_DPI:
        return ()
    message = Message(
        "{name} is so large that it was looked at in {dpi} dpi: its lines are exact, but what is "
        "thin or close may not be told apart",
        name=path.name,
        dpi=round(dpi),
    )
    return (Note("resolution-lowered", message),)


def no_paper_size(path: Path) -> Note:
    """That a file does not say how large its paper is."""
    message = Message(
        "{name} does not say how large its paper is: tell --length or --mm-per-pixel",
        name=path.name,
    )
    return Note("paper-size-unknown", message)
