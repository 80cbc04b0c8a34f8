"""Whether sight lines beside each other meet one face: a wall goes on, or there is a step."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

_BEFORE, _AFTER = 0.1, 0.9
"""Grid steps before and after a place where something changes at which depths are compared."""

_SLOPE = 3.0
"""Depth that a wall which is not across may gain between, in the distance."""

_HALVES, _LEFT = 3, 0.6
"""Times that what lies between two places is halved, and share of the depth gained between these
that is left at most if a wall goes on: of a circle's, close to where it ends, a third."""

DEEPER = 0.7
"""Grid steps by which what is nearest lies deeper, at least, for a line to be seen there."""


@dataclass(frozen=True, eq=False)
class Sight:
    """What one sight line meets, the nearest first.

    Attributes:
        regions: numbers of the regions.
        depths: (m,) mm from where the view looks to where it enters these.
        is_cut: (m,) bool, whether the section plane lies within the region.
    """

    regions: tuple[int, ...]
    depths: Floats
    is_cut: Mask


def goes_on(
    met: Sequence[Sight],
    places: Floats,
    edges: Sequence[float],
    look: Callable[[float], Sight],
    grid: float,
) -> Iterator[Mask]:
    """Of each gap between two sight lines beside each other (the first and last lie beside the
    part) a matrix, (m, l) bool, of what the one meets and the other meets: whether the face entered
    is the same one, or as deep.

    Args:
        met: n, what each sight line meets.
        places: (n,) mm across the view.
        edges: mm, places where something may change.
        look: what the sight line at a place meets.
        grid: mm of a step of the sheet's coordinates.
    """
    nothing = Sight((), np.zeros(0), np.zeros(0, bool))
    for index in range(len(met) + 1):
        before, after = (met[k] if 0 <= k < len(met) else nothing for k in (index - 1, index))
        if not 0 < index < len(met):
            yield _even(before, after, DEEPER * grid)
            continue
        between = places[index - 1], places[index]
        edge = next((this_edge for this_edge in edges if between[0] < this_edge < between[1]), None)
        same = before.regions == after.regions
        if edge is None and same:
            yield np.eye(len(before.depths), dtype=bool)
            continue
        if edge is not None:
            close = max(between[0], edge - _BEFORE * grid), min(between[1], edge + _AFTER * grid)
            closer = look(close[0]), look(close[1])
            if (closer[0].regions, closer[1].regions) == (before.regions, after.regions):
                (before, after), between = closer, close
        even = _even(before, after, max(DEEPER * grid, _SLOPE * (between[1] - between[0])))
        if same:
            for number in np.flatnonzero(~np.diag(even)).tolist():
                even[number, number] = _is_smooth(look, between, (before, after), number)
        yield even


def _even(before: Sight, after: Sight, slack: float) -> Mask:
    """(m, l) whether what two sights meet is as deep, but for a slack in mm."""
    return np.abs(before.depths[:, None] - after.depths[None, :]) < slack


def _is_smooth(
    look: Callable[[float], Sight],
    between: tuple[float, float],
    ends: tuple[Sight, Sight],
    number: int,
) -> bool:
    """Whether what is met as the n-th goes on as one steep wall between two places: where there is
    a step, half of the way has all of it, and half of that again.

    Args:
        look: what the sight line at a place meets.
        between: the places, mm.
        ends: what is met there, of the same regions.
        number: n.
    """
    low, high = between
    whole = abs(ends[1].depths[number] - ends[0].depths[number])
    for _ in range(_HALVES):
        middle = look((low + high) / 2.0)
        if middle.regions != ends[0].regions:
            return False
        below, above = (abs(middle.depths[number] - end.depths[number]) for end in ends)
        if below > above:
            high, ends = (low + high) / 2.0, (ends[0], middle)
        else:
            low, ends = (low + high) / 2.0, (middle, ends[1])
    return bool(abs(ends[1].depths[number] - ends[0].depths[number]) < _LEFT * whole)
