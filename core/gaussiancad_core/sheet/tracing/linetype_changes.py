"""Where a line goes from visible to hidden: only where another stroke meets it.

An edge is hidden from where another one covers it.  The last dash of a hidden line runs into the
visible one that goes on from there, so that its ink looks like the beginning of that; and dashes of
two lines that leave each other at a small angle look like a visible stretch of one of them.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.explained_ink import path_points
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm

_REACH = 3.0
"""px beyond half a line's width within which strokes meet."""

_ACROSS = 0.25
"""Sine of the angle at which a stroke crosses a line at least; others run along it."""

_DASH = 1.2
"""Length of a hidden line's last dash at most, in the sheet's usual ones."""

_LONGEST = 3.0
"""Dashes that a stretch is long at most that two lines' dashes make."""

_DASHED = 2.0
"""Dashes that the hidden stretch beside it is long at least."""


def with_changes_at_junctions(
    pieces: Sequence[Placed], rhythm: Rhythm, stroke_width: float
) -> list[Placed]:
    """The pieces with each change of linetype along a line where another stroke meets it.

    Args:
        pieces: of a view, px; all lines of one width.
        rhythm: of the sheet's dashes.
        stroke_width: px.
    """
    changed = list(pieces)
    gone: set[int] = set()
    for index, (line, visible) in enumerate(pieces):
        if not isinstance(line, Line) or visible.linetype is not Linetype.VISIBLE:
            continue
        ks = [
            k
            for k, (other, piece) in enumerate(pieces)
            if other == line and piece.linetype is Linetype.HIDDEN
        ]
        if not ks:
            continue
        others = [piece for k, piece in enumerate(pieces) if k != index and k not in ks]
        met = _meetings(line, others, 0.5 * stroke_width + _REACH)
        for k in ks:
            if k in gone or index in gone:
                continue
            both = _changed(changed[index][1], changed[k][1], met, rhythm, stroke_width)
            if both is None:
                continue
            seen, hidden = both
            changed[k] = line, hidden
            if seen is None:
                gone.add(index)
            else:
                changed[index] = line, seen
    return [pair for k, pair in enumerate(changed) if k not in gone]


def _changed(
    visible: Piece,
    hidden: Piece,
    met: npt.NDArray[np.float64],
    rhythm: Rhythm,
    stroke_width: float,
) -> tuple[Piece | None, Piece] | None:
    """Both pieces, where the change between them has to lie elsewhere; no visible one if that is
    dashes altogether; None where they may stay as they are."""
    reach = 0.5 * stroke_width + _REACH
    ends = [
        (abs(visible.start - hidden.end), visible.start, 1.0),
        (abs(visible.end - hidden.start), visible.end, -1.0),
    ]
    apart, at, way = min(ends)
    if apart > rhythm.gap:
        return None
    # The change lies anywhere between what is visible and what is hidden.
    if (np.abs(met - at) <= reach + apart).any():
        return None
    inwards = np.sort(way * (met - at))
    inwards = inwards[(inwards > 0.0) & (inwards <= _DASH * rhythm.dash)]
    length = visible.end - visible.start
    if len(inwards) and inwards[0] < length - reach:
        place = float(at + way * inwards[0])
        if way > 0.0:
            return replace(visible, start=place), replace(hidden, end=place)
        return replace(visible, end=place), replace(hidden, start=place)
    dashed = hidden.end - hidden.start >= _DASHED * rhythm.dash
    if length <= _LONGEST * rhythm.dash and dashed:
        start, end = min(visible.start, hidden.start), max(visible.end, hidden.end)
        return None, replace(hidden, start=start, end=end)
    return None


def _meetings(line: Line, others: Sequence[Placed], reach: float) -> npt.NDArray[np.float64]:
    """(n,) positions on a line at which other strokes cross it, or end on it from aside."""
    found: list[float] = []
    for geometry, piece in others:
        points = path_points(geometry, piece.start, piece.end)
        along, across = line.coordinates(points)
        steps = np.diff(points, axis=0)
        lengths = np.maximum(np.hypot(steps[:, 0], steps[:, 1]), 1e-9)
        steep = np.abs(np.diff(across)) / lengths >= _ACROSS
        near = np.minimum(np.abs(across[:-1]), np.abs(across[1:])) <= reach
        crossed = (across[:-1] * across[1:] <= 0.0) & steep
        found += along[:-1][crossed].tolist()
        for end, step in ((0, 0), (-1, -1)):
            if near[step] and abs(across[end]) <= reach and steep[step]:
                found.append(float(along[end]))
    return np.array(found)
