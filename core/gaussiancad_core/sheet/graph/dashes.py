"""Dashes that a file draws one by one, as some programs plot hidden lines."""

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.files.vectors import CircularArc, Line, VectorStroke
from gaussiancad_core.sheet.graph.touching import Flags, Floats, Ints, Touches

_GAP = 3.0
"""Gap to the next dash in lengths of the longer of both, at most."""

_ALONG = 0.05
"""Sine of the angle, and share of the gap beside the line, up to which a dash goes on in another;
the curvature of arcs of some dashes is within it."""

_SLACK = 0.3
"""px beside that are allowed besides."""

_MOST = 0.7
"""Share of a pen's strokes that go on in others, where it draws dashes."""

_FEWEST = 4
"""Strokes of such a pen at least."""

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
        [own.is_solid and isinstance(own.curve, Line | CircularArc) for own in strokes], dtype=bool
    )
    for pen in np.unique(numbers[chosen]):
        own = np.flatnonzero(chosen & short & (numbers == pen))
        total = int((chosen & (numbers == pen)).sum())
        if len(own) < max(_FEWEST, _MOST * total):
            continue
        going_on = _go_on(touches.ends[own], np.array([strokes[i].curve.length for i in own]))
        if going_on.sum() >= _MOST * total:
            found[own] = True
    return found


def _go_on(ends: Floats, lengths: Floats) -> Flags:
    """(n,) which pieces with (n, 2, 2) ends go on, after a gap, in another one."""
    way = (ends[:, 1] - ends[:, 0]) / np.maximum(lengths, 1e-12)[:, None]
    places = ends.reshape(-1, 2)
    outward = np.stack([-way, way], axis=1).reshape(-1, 2)
    owner = np.repeat(np.arange(len(ends)), 2)
    count = min(_NEAREST, len(places))
    gaps, nearest = cKDTree(places).query(places, k=count)
    reach = places[nearest] - places[:, None]
    ahead = (reach * outward[:, None]).sum(axis=2)
    beside = np.abs(reach[..., 0] * outward[:, None, 1] - reach[..., 1] * outward[:, None, 0])
    longer = np.maximum(lengths[owner][:, None], lengths[owner[nearest]])
    facing = (outward[:, None] * outward[nearest]).sum(axis=2) < -np.sqrt(1.0 - _ALONG)
    on = (
        (owner[nearest] != owner[:, None])
        & facing
        & (ahead > 0.0)
        & (gaps <= _GAP * longer)
        & (beside <= _ALONG * ahead + _SLACK)
    )
    return on.any(axis=1).reshape(-1, 2).any(axis=1)
