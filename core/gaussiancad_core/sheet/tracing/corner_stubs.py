"""Corners beside a line: two strokes that meet shortly before a third one end where they meet.

The ink of a corner a few pixels beside a line merges with it, so both strokes seem to reach the
line.  They would have crossed each other before, and ended on it as two short stubs.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.picture_noise import ASLANT, ON_LINE, ONE_PLACE
from gaussiancad_core.sheet.tracing.ink_runs import Piece

Placed = tuple[Line | Circle | WholeEllipse, Piece]
"""A piece and the shape that it is a stretch of."""

_STEEPEST = 0.4
"""Cosine of the angle to the line under which a stub shows beside the line's ink."""


@dataclass(frozen=True)
class _End:
    """An end of a straight piece: its number, whether it is its start, (2,) px, (2,) outward."""

    index: int
    at_start: bool
    place: npt.NDArray[np.float64]
    outward: npt.NDArray[np.float64]


def without_stubs(placed: Sequence[Placed], stroke_width: float) -> list[Placed]:
    """The pieces, those that cross each other right before a line that both end on cut back.

    Args:
        placed: pieces with their ends at junctions; px.
        stroke_width: px.
    """
    from scipy.spatial import cKDTree

    ends = _straight_ends(placed)
    if len(ends) < 2:
        return list(placed)
    cut = list(placed)
    # Two corners of a wedge on the line lie no farther apart than its height leaves them.
    offset = stroke_width + ONE_PLACE
    pairs = cKDTree([end.place for end in ends]).query_pairs(8.0 * offset, output_type="ndarray")
    for i, k in pairs:
        one, other = ends[i], ends[k]
        if one.index == other.index:
            continue
        corner = _crossing(one, other)
        if corner is None:
            continue
        stubs = [float((end.place - corner) @ end.outward) for end in (one, other)]
        if min(stubs) < ON_LINE:
            continue
        thirds = (pair for k, pair in enumerate(placed) if k not in (one.index, other.index))
        if any(_hides(third, corner, (one, other), offset) for third in thirds):
            for end in (one, other):
                cut[end.index] = _ended(cut[end.index], end, corner)
    return cut


def _straight_ends(placed: Sequence[Placed]) -> list[_End]:
    ends = []
    for index, (geometry, piece) in enumerate(placed):
        if isinstance(geometry, Line):
            way = np.array(geometry.direction)
            ends.append(_End(index, True, np.array(geometry.at(piece.start)), -way))
            ends.append(_End(index, False, np.array(geometry.at(piece.end)), way))
    return ends


def _crossing(one: _End, other: _End) -> npt.NDArray[np.float64] | None:
    """(2,) px where the lines of two ends cross."""
    a, b = one.outward, other.outward
    cross = float(a[0] * b[1] - a[1] * b[0])
    if abs(cross) < ASLANT:
        return None
    gap = other.place - one.place
    return one.place + float(gap[0] * b[1] - gap[1] * b[0]) / cross * a


def _hides(
    pair: Placed, corner: npt.NDArray[np.float64], ends: tuple[_End, _End], offset: float
) -> bool:
    """Whether a line has both ends on it, at flat angles, and the corner merges with its ink."""
    geometry, piece = pair
    if not isinstance(geometry, Line):
        return False
    along, across = geometry.coordinates(np.array([corner, *(end.place for end in ends)]))
    within = (along >= piece.start - ON_LINE) & (along <= piece.end + ON_LINE)
    both = bool((np.abs(across[1:]) <= ON_LINE).all() and within[1:].all())
    slopes = [abs(float(np.dot(end.outward, geometry.direction))) for end in ends]
    if min(slopes) < _STEEPEST:
        return False
    # One on either side of the corner's foot: both strokes lead away from the line.
    apart = (along[1] - along[0]) * (along[2] - along[0]) < 0.0
    return both and apart and abs(float(across[0])) <= offset


def _ended(placed: Placed, end: _End, corner: npt.NDArray[np.float64]) -> Placed:
    """The piece with one end at the corner."""
    geometry, piece = placed
    at = float(geometry.positions(corner[None])[0])
    moved = replace(piece, start=at) if end.at_start else replace(piece, end=at)
    return (geometry, moved) if moved.end - moved.start > ON_LINE else placed
