"""Random engineering sheets, of which it is known what each pixel of ink stands for."""

from learning.sheets.composing import clean_sheet
from learning.sheets.cropping import samples
from learning.sheets.letter_fonts import font_names

__all__ = ["clean_sheet", "font_names", "samples"]
