"""Corners at which a stroke ends beside one that runs past: a rib's foot, rounded into its base.

Where a line ends in an arc that touches another, the other goes on both ways.  The ink of the two
merges before they touch, so that such an arc has few ridge points of its own, and grows to a wrong
circle or to none.  Each side of the passing line is a corner with the line that ends there.
"""

from collections.abc import Sequence, Set
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.picture_noise import JOINED, ON_LINE, OVERRUN, SHARP
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.corners import Corner, End
from gaussiancad_core.sheet.votes import LARGELY

Floats = npt.NDArray[np.float64]

_LONGEST_TANGENT = 40.0
"""px from the corner to where an arc begins, at most: larger ones are grown."""

_TOUCHES = 2.0
"""px by which the end of an arc that touches the line may lie beside where it does."""


def passing_corners(
    ends: Sequence[End], placed: Sequence[Placed], linetypes: Set[Linetype]
) -> list[Corner]:
    """Both corners between each end and the first line that it comes to, which runs past; those of
    the longest strokes first.

    Args:
        ends: of straight pieces.
        placed: all pieces; px, pixel centres at integers.
        linetypes: of lines that may run past.
    """
    lines = [
        (index, geometry, piece.start, piece.end)
        for index, (geometry, piece) in enumerate(placed)
        if isinstance(geometry, Line) and piece.linetype in linetypes
    ]
    if not lines:
        return []
    indices = np.array([index for index, *_ in lines])
    origins = np.array([line.point for _, line, _, _ in lines])
    ways = np.array([line.direction for _, line, _, _ in lines])
    spans = np.array([(start, end) for *_, start, end in lines])
    found: list[Corner] = []
    for end in ends:
        u, gap = end.inward, end.place - origins
        steep = (np.abs(ways @ u) <= np.cos(SHARP)) & (indices != end.index)
        cross = np.where(steep, u[0] * ways[:, 1] - u[1] * ways[:, 0], 1.0)
        beyond = (gap[:, 0] * ways[:, 1] - gap[:, 1] * ways[:, 0]) / cross
        at = (gap[:, 1] * u[0] - gap[:, 0] * u[1]) / cross
        near = steep & (beyond >= -OVERRUN) & (beyond <= _LONGEST_TANGENT)
        near &= (at > spans[:, 0] + OVERRUN) & (at < spans[:, 1] - OVERRUN)
        if not near.any():
            continue
        k = int(np.flatnonzero(near)[np.argmin(beyond[near])])
        place = end.place - beyond[k] * end.inward
        for sign, room in ((1.0, spans[k, 1] - at[k]), (-1.0, at[k] - spans[k, 0])):
            side = End(int(indices[k]), False, place, sign * ways[k], float(room))
            longest = min(_LONGEST_TANGENT, LARGELY * (end.length + beyond[k]), float(room))
            corner = _open(Corner(end, side, place, longest, passes=True), placed)
            if corner is not None:
                found.append(corner)
    return sorted(found, key=lambda corner: -corner.first.length)


def _open(corner: Corner, placed: Sequence[Placed]) -> Corner | None:
    """The corner with the arcs that begin where its stroke ends and miss the line; nothing where
    an arc touches both, or another curve goes on."""
    missing = []
    for index, (curve, piece) in enumerate(placed):
        if isinstance(curve, Line):
            continue
        places = curve.points_at(np.array([piece.start, piece.end]))
        away = np.hypot(*(places - corner.first.place).T)
        if away.min() >= JOINED:
            continue
        if not isinstance(curve, Circle) or piece.end - piece.start > 2.0 * corner.longest:
            return None
        if _touches(curve, places[int(np.argmax(away))], corner):
            return None
        missing.append(index)
    return replace(corner, instead=tuple(missing))


def _touches(circle: Circle, end: Floats, corner: Corner) -> bool:
    """Whether an arc ends where its circle touches the line that runs past."""
    way = corner.second.inward
    offset = np.array(circle.centre) - corner.place
    off = abs(float(offset[0] * way[1] - offset[1] * way[0]))
    foot = corner.place + float(offset @ way) * way
    return abs(off - circle.radius) <= ON_LINE and np.hypot(*(end - foot)) <= _TOUCHES
