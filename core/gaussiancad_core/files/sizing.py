"""How many pixels a drawing gets: 200 an inch of paper, less if memory does not suffice for these,
and others if its size is no paper's.

How finely a drawing is looked at says nothing of the unit that it is drawn in: a file that names
one keeps it at any resolution.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import sqrt
from pathlib import Path

from gaussiancad_core.files.content import MAX_PIXELS, MOST_WORKED_ON, VECTOR_DPI, Note
from gaussiancad_core.messages import Message
from gaussiancad_core.model.length_units import MM_PER_INCH
from gaussiancad_protocol.codes import Code

_SMALLEST, _LARGEST = 2.0, 104.0
"""Inches: longest side of what is taken for paper; twice A0 is 93.6 inches long."""

_FREE_SIDE = 3000.0
"""px: longest side of a drawing that is no paper."""

MILLIMETRE = 1.0 / MM_PER_INCH
"""Inches."""

UNIT_UNKNOWN = Code.PAPER_SIZE_UNKNOWN
"""Code of the note that a file does not say its unit."""


@dataclass(frozen=True)
class Sizing:
    """Resolution of a drawing's raster.

    Attributes:
        scale: px per unit of the drawing.
        pixels_per_inch: of what is drawn, or of its paper; None where its unit is not known.
        on_paper: whether the drawing is as large as paper: the widths of pens are told for that.
    """

    scale: float
    pixels_per_inch: float | None
    on_paper: bool


def size_drawing(width: float, height: float, inches_per_unit: float) -> Sizing:
    """Choose the resolution of a drawing whose unit is known.

    Args:
        width, height: units of the drawing.
        inches_per_unit: that are drawn.
    """
    longest = max(width, height)
    pixels = width * height * (inches_per_unit * VECTOR_DPI) ** 2
    if _SMALLEST <= longest * inches_per_unit <= _LARGEST and pixels <= MAX_PIXELS:
        dpi = paper_dpi(width * inches_per_unit, height * inches_per_unit)
        return Sizing(inches_per_unit * dpi, dpi, on_paper=True)
    scale = _FREE_SIDE / longest
    return Sizing(scale, scale / inches_per_unit, on_paper=False)


def size_without_unit(
    width: float, height: float, guesses: Sequence[float] = (MILLIMETRE, 1.0)
) -> Sizing:
    """Choose the resolution of a drawing that does not say its unit: paper's, if any guess makes it
    as large as paper.

    Args:
        width, height: units of the drawing.
        guesses: inches to the unit, the likeliest first.
    """
    sizings = [size_drawing(width, height, guess) for guess in guesses]
    found = next((sizing for sizing in sizings if sizing.on_paper), sizings[0])
    return replace(found, pixels_per_inch=None)


def paper_dpi(width: float, height: float) -> float:
    """px per inch at which paper of so many inches is drawn."""
    return min(VECTOR_DPI, sqrt(MOST_WORKED_ON / (width * height)))


def notes_on(path: Path, sizing: Sizing) -> tuple[Note, ...]:
    """That a drawing's unit is not known, or that one on paper was drawn at less than usual."""
    dpi = sizing.pixels_per_inch
    if dpi is None:
        return (_no_paper_size(path),)
    if not sizing.on_paper or dpi >= VECTOR_DPI:
        return ()
    message = Message(
        "{name} is so large that it was looked at in {dpi} dpi: its lines are exact, but what is "
        "thin or close may not be distinguished",
        name=path.name,
        dpi=round(dpi),
    )
    return (Note(Code.RESOLUTION_LOWERED, message),)


def _no_paper_size(path: Path) -> Note:
    """That a file does not say how large its paper is."""
    message = Message(
        "{name} does not say how large its paper is: pass --unit, --length or --mm-per-pixel",
        name=path.name,
    )
    return Note(UNIT_UNKNOWN, message)
