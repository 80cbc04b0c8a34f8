"""Arms of centre marks that are no more than dots.

A program draws a cross of one size, leaves a gap as long, and leads an arm beyond the circle by as
much.  Where the circle is as large as the cross, hardly anything is left of the arms: dots on all
sides, twice as far from the centre as the circle.  They tell the cross from edges that end at it.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle

_NEAREST, _FARTHEST = 1.6, 2.2
"""Where dots may be, in radii of the circle."""

_LONGEST = 8.0
"""px of a dot along its side, at most."""

_BLANK = 2.0
"""px before and behind a dot where there is nothing."""

_STEP = 0.5
"""px between places that are looked at."""

_DARK = 0.25
"""Weight of the ink of a dot at least: it is smaller than a pixel, perhaps."""

_BESIDE = 1.0
"""px by which a dot may lie beside its side's line."""

_ALONE = 3.0
"""px from a stroke's edge at which there is nothing on both sides of a dot: a line that crosses
has ink there."""

_EVEN = 2.0
"""px by which the distances of dots may differ."""

_FEWEST = 3
"""Sides that have one: on another one it may lie on an edge."""


def has_dotted_arms(circle: Circle, way: tuple[float, float], sheet: CleanSheet) -> bool:
    """Whether a cross has dots for arms.

    Args:
        circle: as large as the cross.
        way: unit vector along one of the cross's lines.
        sheet: its ink.
    """
    right, down = way
    sides = (right, down), (-down, right), (-right, -down), (down, -right)
    found = [_dots(circle, side, sheet) for side in sides]
    return any(
        sum(bool((np.abs(dots - at) <= _EVEN).any()) for dots in found) >= _FEWEST
        for at in np.concatenate(found)
    )


def _dots(circle: Circle, side: tuple[float, float], sheet: CleanSheet) -> npt.NDArray[np.float64]:
    """(n,) px from the centre at which dots stand by themselves on a side."""
    away = np.arange(_NEAREST * circle.radius, _FARTHEST * circle.radius + _LONGEST, _STEP)
    line = np.array(circle.centre) + away[:, None] * np.array(side)
    across = np.array([-side[1], side[0]])
    dark = np.any([_dark(sheet, line + k * across) for k in (-_BESIDE, 0.0, _BESIDE)], axis=0)
    far = (sheet.stroke_width / 2.0 + _ALONE) * across
    crossed = _dark(sheet, line - far) | _dark(sheet, line + far)
    ends = np.flatnonzero(np.diff(dark.astype(int), prepend=0, append=0)).reshape(-1, 2)
    blank = round(_BLANK / _STEP)
    found = []
    for k, (start, end) in enumerate(ends):
        before = ends[k - 1][1] if k else 0
        after = ends[k + 1][0] if k + 1 < len(ends) else len(away)
        alone = min(start - before, after - end) >= blank and not crossed[start:end].any()
        if alone and (end - start) * _STEP <= _LONGEST:
            found.append((away[start] + away[end - 1]) / 2.0)
    return np.array(found)


def _dark(sheet: CleanSheet, places: npt.NDArray[np.float64]) -> npt.NDArray[np.bool_]:
    """(n,) whether there is ink at (n, 2) px."""
    columns, rows = np.rint(places).astype(int).T
    height, width = sheet.weight.shape
    inside = (columns >= 0) & (rows >= 0) & (columns < width) & (rows < height)
    return inside & (sheet.weight[rows * inside, columns * inside] > _DARK)
