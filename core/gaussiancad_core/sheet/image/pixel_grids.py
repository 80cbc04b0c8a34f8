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

from gaussiancad_core.model.views import Linetype, Segment, Stroke

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
    lines = _lines(views)
    columns, rows = (_places(lines, direction) for direction in (0, 1))
    both = np.concatenate([columns, rows])
    if rounding_step([lines], well_read=well_read):
        return Rounding.TOLD
    spread = well_read and all(
        len(item) >= fewest and all(_concentration(item, step) <= most for step in _STEPS)
        for item, fewest, most in (
            (both, _FEWEST, _FREE),
            (columns, _FEWEST_ALONG, _FREE_ALONG),
            (rows, _FEWEST_ALONG, _FREE_ALONG),
        )
    )
    return Rounding.NONE if spread else Rounding.UNTOLD


def rounding_step(views: Iterable[Sequence[Stroke]], *, well_read: bool) -> float:
    """px of the longest step that the places of lines are multiples of; 0 where none is told.

    Lines of an odd width lie between the pixels where those of an even one lie on them, so that
    visible and hidden ones are counted each from a beginning of their own.

    Args:
        views, well_read: as of :func:`seen_rounding`.
    """
    lines = _lines(views)
    least = _ROUNDED_WELL if well_read else _ROUNDED
    by_kind = [_both_ways([line for line in lines if line.linetype is kind]) for kind in Linetype]
    families = [values for values in by_kind if len(values) >= _FEWEST_ALONG]
    for step in _STEPS:
        if step >= _LEAST_ROUNDED and any(
            _is_rounded(groups, step, least) for groups in ([_both_ways(lines)], families)
        ):
            return step
    return 0.0


def _both_ways(lines: Sequence[Segment]) -> npt.NDArray[np.float64]:
    """(n,) px, the places of lines across both directions of the sheet."""
    return np.concatenate([_places(lines, direction) for direction in (0, 1)])


def _lines(views: Iterable[Sequence[Stroke]]) -> list[Segment]:
    """The lines that are long enough to tell their places."""
    return [
        stroke
        for strokes in views
        for stroke in strokes
        if isinstance(stroke, Segment) and stroke.length >= _SHORTEST
    ]


def _places(lines: Sequence[Segment], direction: int) -> npt.NDArray[np.float64]:
    """(n,) px, distinct coordinates at which lines run across a direction of the sheet."""
    ends = np.array([(line.start[direction], line.end[direction]) for line in lines]).reshape(-1, 2)
    level = np.sort(ends[np.abs(ends[:, 1] - ends[:, 0]) <= _LEVEL].mean(axis=1))
    return level[np.diff(level, prepend=-np.inf) > _SAME]


def _is_rounded(families: Sequence[npt.NDArray[np.float64]], step: float, least: float) -> bool:
    """Whether places are multiples of a step, each family's counted from a beginning of its own,
    and not by chance (Rayleigh's test)."""
    # Of files nobody asks this, and it takes longer to load than most of them to read.
    from scipy.special import gammaincc

    stated = [_concentration(family, step) if len(family) else 0.0 for family in families]
    evidence = sum(len(family) * one**2 for family, one in zip(families, stated, strict=True))
    # The sum of as many exponential variates, by chance.
    chance = float(gammaincc(max(len(families), 1), evidence))
    return min(stated, default=0.0) >= least and chance <= _CHANCE


def _concentration(places: npt.NDArray[np.float64], step: float) -> float:
    return float(np.abs(np.exp(2j * np.pi * places / step).mean()))
