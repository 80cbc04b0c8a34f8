"""Which strokes of a file are hatching (ISO 128-3)."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import StrokeKind, StrokeRole, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.graph.touching_ends import Flags, Ints, Touches
from gaussiancad_core.sheet.line_conventions import HATCHING, UNEVEN
from gaussiancad_core.sheet.picture_noise import ON_LINE
from gaussiancad_core.sheet.votes import MOST

_ALONG, _ROUGH, _LEAN = 1e-2, 0.05, 0.2
"""Sines of angles: up to the first, lines are parallel, up to the second short ones whose ends are
rounded; from the third, they are slanted."""

_IN_VIEW = 2
"""Parallel lines of a hatching among edges that touch, at least."""


def is_named_hatching(stroke: VectorStroke) -> bool:
    """Whether a file says that a stroke is hatching."""
    return stroke.kind is StrokeKind.HATCH or stroke.role is StrokeRole.HATCH


def hatch_lines(
    strokes: Sequence[VectorStroke],
    touches: Touches,
    edges: Flags,
    views: Ints,
    centres: Flags,
) -> Flags:
    """(n,) which lines are hatching: several beside each other, slanted, parallel, from within one
    edge or centre line to within another, and, where the part's pen drew them, evenly apart.

    Args:
        strokes: of the sheet.
        touches: of the strokes.
        edges: (n,) which of them are the part's.
        views: (n,) in which view each lies that may be hatching; -1 of all others.
        centres: (n,) which strokes are centre lines.
    """
    candidates = views >= 0
    ways = np.array([_way(stroke) for stroke in strokes])
    lengths = np.hypot(*(touches.ends[:, 1] - touches.ends[:, 0]).T)
    slanted = np.abs(ways).min(axis=1) > _LEAN
    chosen = np.flatnonzero(candidates & slanted & touches.dividing_by(edges | centres))
    found = np.zeros(len(strokes), dtype=bool)
    # The longest tells the direction best: of short ones it is as rough as the file's numbers.
    for index in chosen[np.argsort(-lengths[chosen], kind="stable")]:
        if found[index]:
            continue
        across = np.array([-ways[index][1], ways[index][0]])
        aside = np.abs((touches.ends[:, 1] - touches.ends[:, 0]) @ across)
        parallel = aside < np.clip(0.5 * ON_LINE, _ALONG * lengths, _ROUGH * lengths)
        along = chosen[parallel[chosen]]
        # A line by itself is none, however many run its way in other views.
        along = along[np.bincount(views[along])[views[along]] >= _IN_VIEW]
        places = np.sort(touches.ends[along, 0] @ across)
        apart = np.diff(places)
        apart = apart[apart > ON_LINE]
        if len(apart) >= HATCHING - 1:
            steps = apart / np.median(apart)
            even = bool((np.abs(steps - np.rint(steps)) < UNEVEN).mean() >= MOST)
            found[along] |= even | ~edges[along]
            if even:
                rest = np.flatnonzero(candidates & slanted & ~found & parallel)
                kept = _between(touches, along, rest, across, float(np.median(apart)))
                found[kept] = True
    return found


def _between(
    touches: Touches,
    hatching: npt.NDArray[np.int64],
    lines: npt.NDArray[np.int64],
    across: npt.NDArray[np.float64],
    pitch: float,
) -> list[int]:
    """Those of some lines that have a line of a hatching one pitch away, or two, on either side:
    they end in a corner, and so do not run from within one edge to within another.  Edges of the
    part have hatching on one side."""
    way = np.array([across[1], -across[0]])
    places = touches.ends[hatching, 0] @ across
    spans = np.sort(touches.ends[hatching] @ way, axis=1)
    found = []
    for index in lines.tolist():
        at = float(touches.ends[index, 0] @ across)
        low, high = np.sort(touches.ends[index] @ way).tolist()
        steps = (places[(spans[:, 0] < high) & (spans[:, 1] > low)] - at) / pitch
        near = np.rint(steps[np.abs(steps - np.rint(steps)) < UNEVEN])
        if np.isin(near, (-2, -1)).any() and np.isin(near, (1, 2)).any():
            found.append(index)
    return found


def _way(stroke: VectorStroke) -> npt.NDArray[np.float64]:
    """(2,) unit vector along a straight stroke; 0 of any other."""
    if not isinstance(stroke.curve, LineSegment):
        return np.zeros(2)
    way = np.subtract(stroke.curve.end, stroke.curve.start)
    return way / max(stroke.curve.length, 1e-12)
