"""How many pixels a drawing gets: 200 a paper inch, unless its size is no paper's."""

from dataclasses import dataclass

from gaussiancad_core.sheet.files.content import MAX_PIXELS, VECTOR_DPI

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
        return Sizing(inches_per_unit * VECTOR_DPI, VECTOR_DPI)
    return Sizing(_FREE_SIDE / longest, None)
