"""Whether the program that drew a picture put its lines on whole pixels, or parts of one.

Many programs do: they draw on a raster a few times as fine as the picture and average.  Two views
that stand in a row show a coordinate at the same place of the sheet, so that both are rounded alike
and neither tells by how much.  The places themselves do: rounded ones are multiples of one step,
others are not.
"""

from collections.abc import Iterable, Sequence
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.views import Segment, Stroke

_STEPS = tuple(1.0 / parts for parts in (1, 2, 3, 4, 5, 6, 8, 10))
"""px that programs round to, longest first; a line both of whose sides are rounded lies on halves
of that.  By finer ones lines are misplaced by less than a fortieth of a pixel."""

_SHORTEST = 30.0
"""px of a line that tells its place to a hundredth of a pixel or two."""

_LEVEL = 0.1
"""px that such a line may lean between its ends."""

_SAME = 0.1
"""px up to which lines may be one coordinate that two views show."""

_FEWEST, _FEWEST_ALONG = 8, 3
"""Places that tell anything: in both directions of the sheet together, and in each."""

_ROUNDED, _ROUNDED_WELL, _CHANCE = 0.75, 0.95, 1e-4
"""Length of the mean of unit vectors that stand for places in their steps from which these are
multiples of it, the same where lines are read well, and how likely that may be by chance: then it
is about one over the root of their number."""

_LEAST_ROUNDED = 1.0 / 8.0
"""px of steps by which lines are misplaced more than they may be in any picture."""

_FREE, _FREE_ALONG = 0.8, 0.9
"""The same up to which they are none: of all places, and of those in one direction, which some
programs round alone."""


class Rounding(Enum):
    """What places of lines tell of rounding."""

    TOLD = "told"
    NONE = "none"
    UNTOLD = "untold"


def seen_rounding(views: Iterable[Sequence[Stroke]], *, well_read: bool) -> Rounding:
    """Whether the lines of views are rounded, as far as their places tell.

    Args:
        views: strokes in px of the sheet, as they were fitted to its ink.
        well_read: whether their places are known to a hundredth of a pixel: else it is never
            certain that they are not rounded.
    """
    lines = [
        stroke
        for strokes in views
        for stroke in strokes
        if isinstance(stroke, Segment) and stroke.length >= _SHORTEST
    ]
    columns, rows = (_places(lines, direction) for direction in (0, 1))
    both = np.concatenate([columns, rows])
    least = _ROUNDED_WELL if well_read else _ROUNDED
    if any(_is_rounded(both, step, least) for step in _STEPS if step >= _LEAST_ROUNDED):
        return Rounding.TOLD
    spread = well_read and all(
        len(own) >= fewest and all(_concentration(own, step) <= most for step in _STEPS)
        for own, fewest, most in (
            (both, _FEWEST, _FREE),
            (columns, _FEWEST_ALONG, _FREE_ALONG),
            (rows, _FEWEST_ALONG, _FREE_ALONG),
        )
    )
    return Rounding.NONE if spread else Rounding.UNTOLD


def _places(lines: Sequence[Segment], direction: int) -> npt.NDArray[np.float64]:
    """(n,) px, distinct coordinates at which lines run across a direction of the sheet."""
    ends = np.array([(line.start[direction], line.end[direction]) for line in lines]).reshape(-1, 2)
    level = np.sort(ends[np.abs(ends[:, 1] - ends[:, 0]) <= _LEVEL].mean(axis=1))
    return level[np.diff(level, prepend=-np.inf) > _SAME]


def _is_rounded(places: npt.NDArray[np.float64], step: float, least: float) -> bool:
    """Whether places are multiples of a step, and not by chance (Rayleigh's test)."""
    told = _concentration(places, step) if len(places) else 0.0
    return told >= least and np.exp(-len(places) * told**2) <= _CHANCE


def _concentration(places: npt.NDArray[np.float64], step: float) -> float:
    return float(np.abs(np.exp(2j * np.pi * places / step).mean()))
