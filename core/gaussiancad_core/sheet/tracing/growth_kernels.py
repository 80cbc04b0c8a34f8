"""What the compiled loops that grow lines and arcs share: their tables and room.

``tables`` are the points (n, 2), tangents (n, 2) and index (h, w) of ridge points; ``limits`` the
gap, the band and the cosine of the largest turn; ``fit`` the least number of points, the largest
sagitta of a line, the largest rms and the least sagitta of an arc; ``scratch`` a stamp for each
point, room for the points found, and the last stamp given.
"""

import numpy as np
from numba import njit

CONSUMED = 1.3
"""px beside a shape within which points are explained by it."""

CONSUMED_COSINE = np.cos(np.radians(22.0))
"""Cosine of the largest angle between a shape and points that it explains."""

NEARER = 0.05
"""px by which a line's point may be nearer to the line than to a curve that has it as well."""


@njit(cache=True)
def scratch_of(count):  # noqa: ANN001, ANN201
    """Stamps, room for points found, and the last stamp given."""
    return (
        np.zeros(count, dtype=np.int64),
        np.empty(count, dtype=np.int64),
        np.zeros(1, dtype=np.int64),
    )


@njit(cache=True)
def stacked(rows, width):  # noqa: ANN001, ANN201
    """The rows but the first, which only tells the compiler their type."""
    table = np.empty((len(rows) - 1, width))
    for k in range(1, len(rows)):
        table[k - 1] = rows[k]
    return table


@njit(cache=True)
def with_room(members, used, more):  # noqa: ANN001, ANN201
    """The members, moved to a larger array where they would not fit."""
    if used + more <= len(members):
        return members
    grown = np.empty(2 * (used + more), dtype=np.int64)
    grown[:used] = members[:used]
    return grown


@njit(cache=True)
def pixel(at):  # noqa: ANN001, ANN201
    """The pixel at a coordinate; halves always go up, for rounded to even they would make a level
    line's steps of one pixel miss every other column."""
    return int(np.floor(at + 0.5 + 1e-9))
