"""Where a field on a grid is zero: marching squares (after Lorensen and Cline 1987).

Each square of four nodes has the pieces that its corners' signs ask for, between the places where
the field, linear along the sides, is zero; pieces that meet are joined.  Points, and the order of
lines, are those of ``skimage.measure.find_contours``.
"""

from collections import deque
from collections.abc import Iterator

import numpy as np

from gaussiancad_core.geometry.points import Point, Points

_TOP, _LEFT, _BOTTOM, _RIGHT = range(4)
"""Sides of a square; rows go down, columns to the right."""

_PIECES: dict[int, tuple[tuple[int, int], ...]] = {
    1: ((_TOP, _LEFT),),
    2: ((_RIGHT, _TOP),),
    3: ((_RIGHT, _LEFT),),
    4: ((_LEFT, _BOTTOM),),
    5: ((_TOP, _BOTTOM),),
    6: ((_RIGHT, _TOP), (_LEFT, _BOTTOM)),
    7: ((_RIGHT, _BOTTOM),),
    8: ((_BOTTOM, _RIGHT),),
    9: ((_TOP, _LEFT), (_BOTTOM, _RIGHT)),
    10: ((_BOTTOM, _TOP),),
    11: ((_BOTTOM, _LEFT),),
    12: ((_LEFT, _RIGHT),),
    13: ((_TOP, _RIGHT),),
    14: ((_LEFT, _TOP),),
}
"""Which corners are above zero -> the sides that pieces lead from and to.

Bits: 1 the corner of lower row and column, 2 the one right of it, 4 the one below, 8 the opposite.
What is above zero lies on one hand of a piece all along; of two such corners that face each other
neither is joined with the other.
"""


def zero_lines(field: Points) -> list[Points]:
    """The lines along which a field is zero.

    Args:
        field: (m, n) values at the nodes; NaN where there is none, and no line leads.

    Returns:
        (k, 2) row and column of the points of each; those of a closed line end where they begin.
    """
    return [np.array(line) for line in _joined(_pieces(field))]


def _pieces(field: Points) -> Iterator[tuple[Point, Point]]:
    """From and to, row by row."""
    above = field > 0.0
    kinds = above[:-1, :-1] + 2 * above[:-1, 1:] + 4 * above[1:, :-1] + 8 * above[1:, 1:]
    unknown = np.isnan(field)
    unknown = unknown[:-1, :-1] | unknown[:-1, 1:] | unknown[1:, :-1] | unknown[1:, 1:]
    for row, column in np.argwhere((kinds > 0) & (kinds < 15) & ~unknown).tolist():
        (a, b), (c, d) = field[row : row + 2, column : column + 2].tolist()
        at: tuple[Point, ...] = (
            (float(row), column + _share(a, b)),
            (row + _share(a, c), float(column)),
            (row + 1.0, column + _share(c, d)),
            (row + _share(b, d), column + 1.0),
        )
        for start, end in _PIECES[int(kinds[row, column])]:
            yield at[start], at[end]


def _share(first: float, last: float) -> float:
    """Where between two nodes a field is zero, as a share of the way."""
    return 0.0 if first == last else -first / (last - first)


def _joined(pieces: Iterator[tuple[Point, Point]]) -> list[deque[Point]]:
    """Lines of pieces that meet, in the order in which each was begun."""
    lines: dict[int, deque[Point]] = {}
    starts: dict[Point, int] = {}
    ends: dict[Point, int] = {}
    for number, (start, end) in enumerate(pieces):
        # A corner that is zero itself gives a piece without length.
        if start == end:
            continue
        before, after = ends.pop(start, None), starts.pop(end, None)
        if before is None and after is None:
            lines[number] = deque((start, end))
            starts[start] = ends[end] = number
        elif before is None and after is not None:
            lines[after].appendleft(start)
            starts[start] = after
        elif before is not None and (after is None or after == before):
            lines[before].append(end)
            if after is None:
                ends[end] = before
        elif before is not None and after is not None:
            if before < after:
                lines[before].extend(lines.pop(after))
            else:
                lines[after].extendleft(reversed(lines.pop(before)))
            kept = min(before, after)
            starts[lines[kept][0]] = ends[lines[kept][-1]] = kept
    return [lines[number] for number in sorted(lines)]
