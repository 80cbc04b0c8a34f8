"""Pieces of a sheet, each spoiled in its own way."""

import random
from collections.abc import Iterator, Sequence

import numpy as np

from gaussiancad_core.sheet.labels.ink_classes import PART
from learning.sheets.composing import clean_sheet
from learning.sheets.rendering import Rendered
from learning.sheets.spoiling import spoiled
from learning.training_parts import DrawnPart
from learning.training_samples import Sample

_ON_PART = 0.8
"""Share of the pieces about a line of the part."""

_GRID = 8
"""px between the pixels that are looked at to find such lines."""


def samples(seed: int, parts: Sequence[DrawnPart], size: int, count: int) -> Iterator[Sample]:
    """Pieces of one sheet; the same seed gives the same ones where there are the same fonts.

    Args:
        seed: of the sheet.
        parts: one of which is on it, or something made of one.
        size: px of the sides of a piece.
        count: of pieces at most.
    """
    sheet = _at_least(clean_sheet(random.Random(seed), parts), size)
    rng = np.random.default_rng(seed)
    on_part = np.argwhere(np.isin(sheet.classes[::_GRID, ::_GRID], PART)) * _GRID
    for _ in range(count):
        centre = rng.integers(0, sheet.ink.shape)
        if len(on_part) and rng.random() < _ON_PART:
            centre = on_part[rng.integers(len(on_part))]
            centre = centre + rng.integers(-size // 3, size // 3 + 1, 2)
        last = np.array(sheet.ink.shape) - size
        row, column = np.clip(centre - size // 2, 0, last)
        yield spoiled(_piece(sheet, np.s_[row : row + size, column : column + size]), rng)


def _at_least(sheet: Rendered, size: int) -> Rendered:
    """The sheet, with more paper where it is too small."""
    more = [(0, max(0, size - item)) for item in sheet.ink.shape]
    if not any(pair[1] for pair in more):
        return sheet
    tint = None if sheet.tint is None else np.pad(sheet.tint, more)
    ink, classes, extra = (
        np.pad(values, more) for values in (sheet.ink, sheet.classes, sheet.extra)
    )
    return Rendered(ink, classes, extra, tint)


def _piece(sheet: Rendered, where: tuple[slice, slice]) -> Rendered:
    tint = None if sheet.tint is None else sheet.tint[where]
    ink, classes, extra = (layer[where].copy() for layer in (sheet.ink, sheet.classes, sheet.extra))
    return Rendered(ink, classes, extra, tint)
