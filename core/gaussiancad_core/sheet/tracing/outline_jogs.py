"""Jogs: short pieces of an outline between two lines that end with nothing beyond.

A step of a few line widths leaves too little ink between its corners for a line to be grown from.
What tells it are the two lines that end there, and the ink that leads from one end to the other:
straight between lines that are parallel, around one corner between lines at right angles.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import DARK, FREE, INFERRED, LEVEL, LONGEST_SHORT
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.votes import NEARLY_ALL

_LONGEST = 8.0
"""Line widths that a leg of a jog is long at most: longer ones are found as lines."""

_SHORTEST = 1.5
"""Line widths that it is long at least: shorter ones may be a ragged end."""

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class _End:
    """An end of a line with nothing beyond.

    Attributes:
        index: of the piece.
        corner: (2,) px where the line's axis turns: half a stroke inside of where its ink ends.
        outward: (2,) unit vector.
    """

    index: int
    corner: Floats
    outward: Floats


def find_jogs(pieces: Sequence[Placed], sheet: CleanSheet) -> list[Placed]:
    """The legs of jogs.

    Args:
        pieces: of a view, with their ends at junctions.
        sheet: its ink.

    Returns:
        Visible lines, whose ends are the corners.
    """
    ends = list(_free_ends(pieces, sheet.stroke_width))
    longest = max(LONGEST_SHORT, _LONGEST * sheet.stroke_width)
    found: list[Placed] = []
    taken: set[int] = set()
    pairs = [
        (float(np.hypot(*(one.corner - other.corner))), i, k)
        for (i, one), (k, other) in combinations(enumerate(ends), 2)
        if one.index != other.index
    ]
    for away, i, k in sorted(pairs):
        if away > 1.5 * longest or taken & {i, k}:
            continue
        path = _path(ends[i], ends[k], sheet, longest)
        if path is not None:
            taken |= {i, k}
            found += [visible_leg(a, b) for a, b in pairwise(path)]
    return found


def _free_ends(pieces: Sequence[Placed], width: float) -> Iterator[_End]:
    """Ends of visible lines with no other stroke around."""
    tips = [
        (index, np.array(geometry.at(at)), way * np.array(geometry.direction))
        for index, (geometry, piece) in enumerate(pieces)
        if isinstance(geometry, Line) and piece.linetype is Linetype.VISIBLE
        for at, way in ((piece.start, -1.0), (piece.end, 1.0))
    ]
    if not tips:
        return
    away = np.array(
        [distances_to(piece, np.array([tip for _, tip, _ in tips])) for piece in pieces]
    )
    away[[index for index, _, _ in tips], np.arange(len(tips))] = np.inf
    for (index, tip, outward), nearest in zip(tips, away.min(axis=0), strict=True):
        if nearest > FREE * width:
            yield _End(index, tip - outward * width / 2.0, outward)


def distance_to(placed: Placed, point: Floats) -> float:
    """px from a point to a piece."""
    return float(distances_to(placed, point[None])[0])


def distances_to(placed: Placed, points: Floats) -> Floats:
    """(n, 2) points -> (n,) px from each to a piece."""
    geometry, piece = placed
    at = geometry.positions(points)
    if np.isfinite(geometry.around):
        at = piece.start + np.mod(at - piece.start, geometry.around)
        within = at <= piece.end
        ends = geometry.points_at(np.array([piece.start, piece.end]))
        to_ends = np.hypot(*(points[:, None] - ends).transpose(2, 0, 1)).min(1)
        return np.where(within, np.hypot(*(geometry.points_at(at) - points).T), to_ends)
    nearest = geometry.points_at(np.clip(at, piece.start, piece.end))
    return np.hypot(*(nearest - points).T)


def _path(one: _End, other: _End, sheet: CleanSheet, longest: float) -> list[Floats] | None:
    """The corners of a jog from one end to the other; None if no ink leads there."""
    cosine = float(one.outward @ other.outward)
    if abs(cosine) > 1.0 - LEVEL:
        path = _straight(one, other)
    elif abs(cosine) < LEVEL:
        path = _around(one, other)
    else:
        return None
    legs = list(pairwise(path))
    lengths = [float(np.hypot(*(b - a))) for a, b in legs]
    if not all(_SHORTEST * sheet.stroke_width <= length <= longest for length in lengths):
        return None
    return path if all(_is_inked(a, b, sheet) for a, b in legs) else None


def _straight(one: _End, other: _End) -> list[Floats]:
    """One leg, at right angles to both lines, half way between where they seem to end."""
    along = one.outward
    middle = (one.corner + other.corner) @ along / 2.0
    return [end.corner + (middle - end.corner @ along) * along for end in (one, other)]


def _around(one: _End, other: _End) -> list[Floats]:
    """Two legs, each at right angles to the line that it starts from."""
    turn = one.corner + ((other.corner - one.corner) @ other.outward) * other.outward
    return [one.corner, turn, other.corner]


def _is_inked(start: Floats, end: Floats, sheet: CleanSheet) -> bool:
    points = start + np.linspace(0.0, 1.0, 4 * int(np.hypot(*(end - start)) + 2))[:, None] * (
        end - start
    )
    weights = sample(sheet.weight, points[:, :1], points[:, 1:])
    return float((weights > DARK).mean()) >= NEARLY_ALL


def visible_leg(start: Floats, end: Floats) -> Placed:
    """A short visible line from (2,) px to (2,) px."""
    length = float(np.hypot(*(end - start)))
    dx, dy = (end - start) / length
    line = Line((float(start[0]), float(start[1])), (float(dx), float(dy)))
    return line, Piece(0.0, length, Linetype.VISIBLE, INFERRED)
