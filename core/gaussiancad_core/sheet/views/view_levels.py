"""The levels of a drawing: the places of its long lines along an axis, and whether two drawings
have the same."""

from dataclasses import dataclass
from math import exp, inf, log

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.views.sheet_layout import alignment_tolerance

Ink = npt.NDArray[np.bool_]
Places = npt.NDArray[np.float64]

_SAME_PX, _SAME = 2.0, 0.01
"""px, and share of an extent, by which places are one."""

_LONG = 0.12
"""Share of a view's width or height that a line along it has, at least, to be asked."""

_SHOWN = 0.8
"""Probability with which a line of one view has one at its place in another that shows its axis
and has more lines."""

_EDITED = 0.05
"""Share of views in line whose extents are up to an editing apart (see
:func:`.alignment_tolerance`)."""

_UNRELATED = 0.3
"""Share of views in line that show other lines than their neighbours, as where hidden lines are
left out."""


@dataclass(frozen=True, eq=False)
class AxisLevels:
    """A drawing along one axis.

    Attributes:
        extent: px.
        places: (n,) px from where it begins to its long lines across the axis, but for its
            outermost, in order.
    """

    extent: float
    places: Places


@dataclass(frozen=True, eq=False)
class Levels:
    """A drawing along both axes of the sheet."""

    across: AxisLevels
    down: AxisLevels

    @classmethod
    def of(cls, box: Box, ink: Ink) -> "Levels":
        """The levels of what is drawn in a box.

        Args:
            box: px.
            ink: (h, w) of the part.
        """
        x0, y0, x1, y1 = box
        window = ink[int(y0) : int(y1), int(x0) : int(x1)]
        return cls(
            AxisLevels(x1 - x0, _places(window.sum(axis=0), window.shape[0])),
            AxisLevels(y1 - y0, _places(window.sum(axis=1), window.shape[1])),
        )

    def along(self, *, level: bool) -> AxisLevels:
        """Across the sheet, or down it."""
        return self.across if level else self.down


def _places(sums: npt.NDArray[np.int64], across: int) -> Places:
    is_long = np.concatenate([[False], sums >= _LONG * across, [False]])
    begins, ends = (np.flatnonzero(np.diff(is_long.astype(int)) == way) for way in (1, -1))
    middles = (begins + ends) / 2.0
    edge = max(_SAME_PX, _SAME * len(sums)) + 2.0
    return middles[(middles > edge) & (middles < len(sums) - edge)]


def agreement(one: AxisLevels, other: AxisLevels, *, is_turned: bool, is_in_line: bool) -> float:
    """Log-odds that two drawings show one axis: by their extents, and by the lines of the one that
    has fewer; minus infinity where their extents are apart.

    Args:
        one, other: along that axis.
        is_turned: whether the axis runs the other way in one of them.
        is_in_line: whether the drawings stand in line.
    """
    near = max(_SAME_PX, _SAME * max(one.extent, other.extent))
    apart = abs(one.extent - other.extent)
    length = (one.extent + other.extent) / 2.0
    if apart > (alignment_tolerance(max(one.extent, other.extent)) if is_in_line else near):
        return -inf
    odds = -log(2.0 * near / length) + (log(_EDITED) if apart > near else 0.0)
    places = one.extent - one.places[::-1] if is_turned else one.places
    lines = _lines(places, other.places, near, length)
    if is_in_line:
        return odds + log(_UNRELATED + (1.0 - _UNRELATED) * exp(min(lines, 50.0)))
    return odds + lines


def _lines(one: Places, other: Places, near: float, length: float) -> float:
    """Log-odds by the places of lines."""
    fewer, more = sorted((one, other), key=len)
    chance = min(len(more) * 2.0 * near / length, _SHOWN)
    odds = 0.0
    for place in fewer:
        is_there = bool((np.abs(more - place) <= near).any())
        odds += log(_SHOWN / chance) if is_there else log((1.0 - _SHOWN) / (1.0 - chance))
    return odds
