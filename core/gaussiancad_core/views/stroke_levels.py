"""The levels of a view: where its lines are along each axis of the sheet, and whether two views can
show one axis of the part."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, log

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke
from gaussiancad_core.structure.shaded_pictures import PICTURE
from gaussiancad_core.views.drawn_groups import DrawnView

Places = npt.NDArray[np.float64]
"""(n,) mm from where a view begins, in order."""

_NEAR, _NEAR_SHARE = 0.12, 0.0015
"""mm, and share of an extent besides, by which places are one."""

_ROUGH = 0.45
"""mm by which what was painted is rougher than what was drawn."""

_FARTHEST = 1.6
"""Difference of two extents at most, in what places differ by."""

_FARTHER, _LONGER = 3.0, 2.0
"""The same more, per mm that places are rough; log-odds against each of these."""

_EXTENT = 3.0
"""Log-odds for two views that are as long as each other."""

_APART = 0.05
"""mm from which levels are two."""

_LEVEL, _LONG = 0.01, 0.5
"""Sine of the angle, and mm, up to which a line runs along the sheet, and from which it tells."""

_SHOWN, _MOST_BY_CHANCE = 0.75, 0.9
"""Probability that a line of one view is at a level of the other; by chance, at most."""

_ENOUGH = 8.0
"""Lines beyond which more say no more."""

_WEIGHT_OF_ROUGH = 0.4
"""Share of these log-odds that count where places are rough: they are off together."""

_AGAINST, _FOR = -3.0, 5.0
"""Log-odds by levels at most, either way."""

_UNRELATED = -1.2
"""The same against views in line: where hidden lines are left out, many show other lines than their
neighbours."""


@dataclass(frozen=True, eq=False)
class Levels:
    """A view along one axis of the sheet.

    Attributes:
        extent: mm.
        places: all ends, and both sides of what is round.
        lines: lines across the axis, and both sides of circles.
        rough: mm by which these are rougher than others.
    """

    extent: float
    places: Places
    lines: Places
    rough: float


def levels_of(view: DrawnView) -> tuple[Levels, Levels]:
    """The levels of a view across the sheet and down it."""
    rough = _ROUGH if is_painted(view) else view.rough
    strokes = (*view.edges, *view.hidden)
    across, down = (_levels(strokes, view.box[axis], axis) for axis in (0, 1))
    return Levels(view.size[0], *across, rough), Levels(view.size[1], *down, rough)


def is_painted(view: DrawnView) -> bool:
    """Whether nothing is known of a view but the outline of its picture."""
    return any(edge.pen == PICTURE for edge in view.edges)


def distinct(values: Sequence[float] | Places, apart: float = _APART) -> Places:
    """Values in order, without those that follow others closely."""
    ordered = np.sort(np.asarray(values, dtype=np.float64))
    return ordered[np.diff(ordered, prepend=-inf) > apart]


def _levels(strokes: Sequence[PaperStroke], low: float, axis: int) -> tuple[Places, Places]:
    places, lines = [], []
    for stroke in strokes:
        along = stroke.points[:, axis] - low
        places += [along[0], along[-1]]
        if stroke.is_line:
            if abs(stroke.way[axis]) < _LEVEL and stroke.length > _LONG:
                lines.append(along.mean())
            continue
        sides = [along.min(), along.max()]
        if isinstance(stroke.curve, CircularArc) and stroke.curve.is_closed:
            middle, radius = stroke.curve.centre[axis] - low, stroke.curve.radius
            sides = [middle - radius, middle + radius]
            lines += sides
        places += sides
    return distinct([*places, *lines]), distinct(lines)


def agreement(one: Levels, other: Levels, *, is_turned: bool, is_in_line: bool = False) -> float:
    """Log-odds that two views show one axis: by their extents, then by their levels; minus infinity
    where their extents are apart.

    Args:
        one, other: along that axis.
        is_turned: whether it runs the other way in one of them.
        is_in_line: whether the views begin at one place along it.
    """
    near = _NEAR + _NEAR_SHARE * max(one.extent, other.extent) + max(one.rough, other.rough) / 2.0
    apart = abs(one.extent - other.extent) / near
    rough = max(one.rough, other.rough)
    if apart > _FARTHEST + _FARTHER * rough:
        return -inf
    found = _EXTENT - _LONGER * max(0.0, apart - _FARTHEST)
    for lines, places in ((one.lines, other.places), (other.lines, one.places)):
        inner = lines[(lines > 3.0 * near) & (lines < one.extent - 3.0 * near)]
        if not len(inner) or not len(places):
            continue
        asked = one.extent - places if is_turned else places
        chance = min(_MOST_BY_CHANCE, 2.0 * near * len(asked) / one.extent)
        is_there = np.abs(inner[:, None] - asked[None]).min(axis=1) < near
        hit = log(_SHOWN / chance) if chance < _SHOWN else 0.0
        odds = np.where(is_there, hit, log((1.0 - _SHOWN) / (1.0 - chance)))
        total = float(odds.sum()) * min(1.0, _ENOUGH / len(inner))
        total *= _WEIGHT_OF_ROUGH if rough else 1.0
        found += float(np.clip(total, _UNRELATED if is_in_line else _AGAINST, _FOR))
    return found
