"""Straight strokes two or three pixels beside each other.

Smoothed as widely as single strokes need it, two that nearly touch become one ridge, between them
or on the darker one.  Smoothed less, they are two ridges; only the paper that shows between them
tells them from the edges of one wide stroke.
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import DARK, ON_LINE, PARALLEL, SIDE_BY_SIDE
from gaussiancad_core.sheet.tracing.grown_shapes import Grown
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.ridges import RidgePoints, fine_ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_straight

_NEAREST = 1.9
"""px between two lines that can be told apart, at least."""

_REACH = 2.5
"""px beyond a stroke's width up to which lines are pulled by each other."""

_PALER = 0.88
"""Ink between two lines, as a share of that on the paler one, at most."""


@dataclass(frozen=True, eq=False)
class _Fine:
    """A finely found line with the positions along it between which it has points."""

    line: Line
    start: float
    end: float


def with_close_lines(sheet: CleanSheet, lines: list[Line]) -> tuple[list[Line], set[Line]]:
    """The lines of a view, with those apart that were melted.

    Args:
        sheet: the ink.
        lines: as they were found in ink smoothed as widely as a stroke.

    Returns:
        The lines, without those that run between two, and the missing ones, px, centres of pixels
        at integers; and those of them that have another one beside them.
    """
    width = sheet.stroke_width
    ridges = fine_ridge_points(sheet.weight, width)
    rules = GrowthRules.of_width(width)
    fine = [_fine(grown, ridges) for grown in grow_straight(ridges, rules)]
    pairs = [
        pair
        for pair in combinations(fine, 2)
        if _run_parallel(*pair, width) and _shows(*pair, sheet)
    ]
    kept = list(lines)
    close: set[Line] = set()
    for pair in pairs:
        kept = [line for line in kept if not _is_between(line, *pair)]
        for this_fine in pair:
            same = [line for line in kept if _is_same(line, this_fine)]
            if not same:
                kept.append(this_fine.line)
            close.update(same or [this_fine.line])
    return kept, close.intersection(kept)


def _fine(grown: Grown, ridges: RidgePoints) -> _Fine:
    along = grown.geometry.positions(ridges.points[grown.members])
    return _Fine(grown.line, float(along.min()), float(along.max()))


def _run_parallel(one: _Fine, other: _Fine, width: float) -> bool:
    """Whether two lines run along each other, too close for wide smoothing."""
    a, b = np.array(one.line.direction), np.array(other.line.direction)
    if abs(float(a @ b)) < np.cos(PARALLEL):
        return False
    along = _overlap(one, other)
    if along[1] - along[0] < SIDE_BY_SIDE:
        return False
    away = other.line.distances(one.line.points_at(np.array(along)))
    return bool(away.min() >= _NEAREST and away.max() <= width + _REACH)


def _overlap(one: _Fine, other: _Fine) -> tuple[float, float]:
    """Positions along the first line between which the second one is beside it."""
    ends = one.line.positions(other.line.points_at(np.array([other.start, other.end])))
    return max(one.start, float(ends.min())), min(one.end, float(ends.max()))


def _shows(one: _Fine, other: _Fine, sheet: CleanSheet) -> bool:
    """Whether the paper shows between two lines, wherever either has ink."""
    start, end = _overlap(one, other)
    along = np.arange(start, end + 0.5, 0.5)
    first = one.line.points_at(along)
    second = other.line.points_at(other.line.positions(first))
    dark = [sample(sheet.weight, points[:, :1], points[:, 1:])[:, 0] for points in (first, second)]
    middle = 0.5 * (first + second)
    between = sample(sheet.weight, middle[:, :1], middle[:, 1:])[:, 0]
    for values in dark:
        inked = values > DARK
        if inked.sum() < SIDE_BY_SIDE or between[inked].mean() > _PALER * values[inked].mean():
            return False
    return True


def _is_between(line: Line, one: _Fine, other: _Fine) -> bool:
    """Whether a line is neither of two, but runs in between, or from the one to the other."""
    start, end = _overlap(one, other)
    ends = one.line.points_at(np.array([start, end]))
    if abs(float(np.dot(line.direction, one.line.direction))) < np.cos(np.radians(8.0)):
        return False
    off = line.coordinates(ends)[1]
    adjacent = line.coordinates(other.line.points_at(other.line.positions(ends)))[1]
    inside = (np.minimum(off, adjacent) <= ON_LINE) & (np.maximum(off, adjacent) >= -ON_LINE)
    flag = (np.abs(off) <= ON_LINE).all() or (np.abs(adjacent) <= ON_LINE).all()
    return bool(inside.all()) and not flag


def _is_same(line: Line, fine: _Fine) -> bool:
    ends = fine.line.points_at(np.array([fine.start, fine.end]))
    return bool(line.distances(ends).max() <= 2.0 * ON_LINE)
