"""Letters to lines of writing, level or up the sheet."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from gaussiancad_core.sheet.reading_options import Box

Floats = npt.NDArray[np.float64]

_SPACE = 0.65
"""Gap between two letters of one line at most, in the height of the larger one."""

_COMMON = 0.6
"""Share of the smaller one's height that lies beside the larger one at least."""

_SAME = 2.2
"""Ratio of their heights at most, unless one is a point."""

_POINT, _LOW = 0.35, 0.6
"""Size of a point at most, and how low it stands at least, in the height of a letter beside it."""

_MOST = 2500
"""Letters that are looked at, the largest first."""


def written_lines(letters: Sequence[Box], pitch: float = 0.0) -> list[Box]:
    """The boxes of lines of writing.

    What stands in no level line may stand in one that runs up the sheet.

    Args:
        letters: boxes of letters, signs and points, px.
        pitch: distance of two letters' middles, in the height of the larger one, up to which they
            may stand in one line whatever gap is between them: where all letters have the same
            space, narrow ones stand apart.
    """
    groups = written_groups(letters, pitch)
    return [_around(np.array([letters[k] for k in this_groups])) for this_groups in groups]


def written_groups(letters: Sequence[Box], pitch: float = 0.0) -> list[list[int]]:
    """For each line of writing the numbers of its letters; some stand alone.

    Args:
        letters: as for :func:`written_lines`.
        pitch: as there.
    """
    if not letters:
        return []
    boxes = np.array(letters, dtype=np.float64)
    sizes = (boxes[:, 2:] - boxes[:, :2]).max(axis=1)
    looked = np.argsort(-sizes, kind="stable")[:_MOST]
    level = _groups(boxes[looked], pitch)
    alone = np.bincount(level)[level] == 1
    turned = looked[alone]
    ways = ((looked[~alone], level[~alone]), (turned, _groups(_turned(boxes[turned]), pitch)))
    return [
        numbers[groups == item].tolist() for numbers, groups in ways for item in np.unique(groups)
    ]


def _groups(boxes: Floats, pitch: float) -> npt.NDArray[np.int32]:
    """(n,) the number of the level line that each box stands in."""
    x0, y0, x1, y1 = boxes.T
    heights, widths = y1 - y0, x1 - x0
    gap = np.maximum(x0[:, None], x0) - np.minimum(x1[:, None], x1)
    common = np.minimum(y1[:, None], y1) - np.maximum(y0[:, None], y0)
    smaller, larger = np.minimum(heights[:, None], heights), np.maximum(heights[:, None], heights)
    middles = (x0 + x1) / 2.0
    near = gap <= _SPACE * larger
    near |= np.abs(middles[:, None] - middles) <= pitch * larger
    letters = (common >= _COMMON * smaller) & (larger <= _SAME * smaller)
    # A point is flat and low; beside it, a letter of any height.
    size = np.maximum(heights, widths)
    point = (size[:, None] <= _POINT * heights) & (y0[:, None] >= y0 + _LOW * heights)
    point &= y0[:, None] <= y1 + _POINT * heights
    linked = near & (letters | point | point.T)
    rows, columns = np.nonzero(linked)
    graph = coo_array((np.ones(len(rows)), (rows, columns)), shape=linked.shape)
    return connected_components(graph, directed=False)[1]


def _around(boxes: Floats) -> Box:
    """The box around some others (n, 4)."""
    low, high = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def _turned(boxes: Floats) -> Floats:
    """Boxes turned so that what runs up the sheet runs level."""
    x0, y0, x1, y1 = boxes.T
    return np.stack([-y1, x0, -y0, x1], axis=1)
