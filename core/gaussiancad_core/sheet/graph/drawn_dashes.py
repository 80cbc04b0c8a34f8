"""Dashes that a file draws one by one, as some programs plot hidden lines."""

from collections.abc import Sequence

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.dash_noise import FEWEST, ROW
from gaussiancad_core.sheet.graph.touching_ends import Flags, Floats, Ints, Touches
from gaussiancad_core.sheet.votes import MOST

_GAP = 3.0
"""Gap to the next dash in lengths of the longer of both, at most."""

_ALONG = 0.05
"""Sine of the angle, and share of the gap beside the line, up to which a dash goes on in another;
the curvature of arcs of some dashes is within it."""

_SLACK = 0.3
"""px beside that are allowed besides."""

_SHORT = 0.6
"""Length of a short piece in that of the longer one beside it, at most (ISO 128-2: a fiftieth to a
half)."""

_LEAST_SHORT, _MOST_SHORT = 0.35, 0.85
"""Share of the inner pieces of a chain line that are short."""

_AT_ONCE = 2
"""Short pieces between two long ones at most."""

_NEAREST = 8
"""Ends that are looked at for the next dash."""


def dashes(
    strokes: Sequence[VectorStroke], touches: Touches, numbers: Ints, chosen: Flags
) -> Flags:
    """(n,) which of some strokes are dashes of a pen that draws little else.

    Args:
        strokes: of the sheet.
        touches: of these.
        numbers: (n,) of each stroke's pen.
        chosen: (n,) those that may be dashes.
    """
    found = np.zeros(len(strokes), dtype=bool)
    short = np.array(
        [
            stroke.is_solid and isinstance(stroke.curve, LineSegment | CircularArc)
            for stroke in strokes
        ],
        dtype=bool,
    )
    for pen in np.unique(numbers[chosen]):
        values = np.flatnonzero(chosen & short & (numbers == pen))
        total = int((chosen & (numbers == pen)).sum())
        if len(values) < max(ROW, MOST * total):
            continue
        lengths = np.array([strokes[index].curve.length for index in values.tolist()])
        going_on = _go_on(touches.ends[values], lengths)
        if going_on.sum() >= MOST * total:
            found[values] = True
    return found


def chain_pieces(strokes: Sequence[VectorStroke], touches: Touches, chosen: Flags) -> Flags:
    """(n,) which of some strokes are pieces of chain lines: long and short ones by turns, as centre
    lines are drawn (ISO 128-2, 04 and 05).

    Args:
        strokes: of the sheet.
        touches: of these.
        chosen: (n,) those that may be pieces.
    """
    found = np.zeros(len(strokes), dtype=bool)
    lines = np.array(
        [stroke.is_solid and isinstance(stroke.curve, LineSegment) for stroke in strokes],
        dtype=bool,
    )
    values = np.flatnonzero(chosen & lines)
    if len(values) < FEWEST:
        return found
    ends = touches.ends[values]
    lengths = np.array([strokes[index].curve.length for index in values.tolist()])
    nearest, on = _next_pieces(ends, lengths)
    first = np.argmax(on, axis=1)
    linked = on.any(axis=1)
    pieces = np.arange(len(on)) // 2
    pairs = pieces[linked], nearest[linked, first[linked]] // 2
    size = (len(values), len(values))
    graph = coo_matrix((np.ones(len(pairs[0])), pairs), size)
    _, runs = connected_components(graph, directed=False)
    for run in np.unique(runs[pairs[0]]):
        members = np.flatnonzero(runs == run)
        way = ends[members[0], 1] - ends[members[0], 0]
        along = members[np.argsort(ends[members].mean(axis=1) @ way)]
        if _is_chain(lengths[along]):
            found[values[along]] = True
    return found


def _is_chain(lengths: Floats) -> bool:
    """Whether pieces of so many px along a line are long and short by turns: the first and the last
    may be cut, as the dashes of a hidden line may."""
    if len(lengths) < FEWEST:
        return False
    longest = np.maximum(lengths[:-2], lengths[2:])
    short = lengths[1:-1] <= _SHORT * longest
    share = float(short.mean())
    return share >= _LEAST_SHORT and (share <= _MOST_SHORT or len(short) <= _AT_ONCE)


def _go_on(ends: Floats, lengths: Floats) -> Flags:
    """(n,) which pieces with (n, 2, 2) ends go on, after a gap, in another one."""
    _, on = _next_pieces(ends, lengths)
    return np.any(np.any(on, axis=1).reshape(-1, 2), axis=1)


def _next_pieces(ends: Floats, lengths: Floats) -> tuple[Ints, Flags]:
    """For each end of pieces the nearest ends, (2 n, k), and in which of these it goes on."""
    way = (ends[:, 1] - ends[:, 0]) / np.maximum(lengths, 1e-12)[:, None]
    places = ends.reshape(-1, 2)
    outward = np.stack([-way, way], axis=1).reshape(-1, 2)
    owner = np.repeat(np.arange(len(ends)), 2)
    count = min(_NEAREST, len(places))
    gaps, nearest = cKDTree(places).query(places, k=count)
    reach = places[nearest] - places[:, None]
    ahead = (reach * outward[:, None]).sum(axis=2)
    neighbour = np.abs(reach[..., 0] * outward[:, None, 1] - reach[..., 1] * outward[:, None, 0])
    longer = np.maximum(lengths[owner][:, None], lengths[owner[nearest]])
    facing = (outward[:, None] * outward[nearest]).sum(axis=2) < -np.sqrt(1.0 - _ALONG)
    on = (
        (owner[nearest] != owner[:, None])
        & facing
        & (ahead > 0.0)
        & (gaps <= _GAP * longer)
        & (neighbour <= _ALONG * ahead + _SLACK)
    )
    return nearest, on
