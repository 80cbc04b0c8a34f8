"""What parts seldom are: in pieces, or hollow where nothing shows it.

Where hidden lines are not drawn, parts differ that draw the same.  Of these the one is taken that
is in one piece, and that has the most material.
"""

from itertools import product

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from gaussiancad_core.proposing.feature_kernels import Crossed
from gaussiancad_core.proposing.lines_by_plane import Floats
from gaussiancad_core.proposing.planned_part import PlannedPart
from gaussiancad_core.proposing.planned_views import PlannedView

_PIECE = 0.05
"""Share of the lines that another piece of the part counts."""

_HOLLOW = 0.01
"""The same of a part that is nothing but void."""


def unusual(part: PlannedPart) -> float:
    """mm of line that what is unusual about a part counts."""
    view, crossed = _widest(part)
    low, high = _intervals(view, crossed)
    box = float(np.prod(part.judge.sheet.size))
    material = float((view.cells[..., None] * (high - low)).sum()) / box
    return pieces_of(part) + _HOLLOW * part.judge.length * (1.0 - material)


def pieces_of(part: PlannedPart) -> float:
    """mm of line that pieces of a part count beyond the first."""
    count = _pieces(*_intervals(*_widest(part)), part.judge.sheet.tolerance)
    return _PIECE * part.judge.length * max(0, count - 1)


def _widest(part: PlannedPart) -> tuple[PlannedView, Crossed]:
    """The view with the most lines of sight between places, and what they cross."""
    views = part.judge.views
    number = max(range(len(views)), key=lambda k: views[k].cells.size)
    return views[number], part.crossed[number]


def _intervals(view: PlannedView, crossed: Crossed) -> tuple[Floats, Floats]:
    """(r, c, k) mm from where to where lines of sight run through material; 0 beyond that."""
    here = slice(view.raster, view.raster + view.cells.size)
    counts = crossed.counts[here] // 2
    most = max(1, int(counts.max(initial=1)))
    depth = crossed.depth[here, : 2 * most].reshape(*view.cells.shape, most, 2)
    counts = counts.reshape(view.cells.shape)
    is_there = np.arange(most) < counts[..., None]
    low, high = (np.where(is_there, depth[..., end], 0.0) for end in (0, 1))
    return low, high


def _pieces(low: Floats, high: Floats, tolerance: float) -> int:
    """How many pieces hang together."""
    most = low.shape[2]
    names = np.arange(low.size).reshape(low.shape)
    found = []
    for axis in (0, 1):
        size = low.shape[axis]
        one, other = (
            [np.take(each, range(at, size - 1 + at), axis=axis) for each in (low, high, names)]
            for at in (0, 1)
        )
        for a, b in product(range(most), repeat=2):
            common = np.minimum(one[1][..., a], other[1][..., b])
            common = common - np.maximum(one[0][..., a], other[0][..., b])
            meets = common > tolerance
            found.append(np.stack([one[2][..., a][meets], other[2][..., b][meets]]))
    ends = np.concatenate(found, axis=1)
    graph = coo_array((np.ones(ends.shape[1]), ends), shape=(low.size, low.size))
    _, labels = connected_components(graph, directed=False)
    is_there = high - low > tolerance
    return len(np.unique(labels[is_there.reshape(-1)]))
