"""Straight pieces that cut a corner: chords of the arc that rounds it, or flanks of a groove."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.picture_noise import AROUND, TOUCHING
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.corners import Corner
from gaussiancad_core.sheet.tracing.ink_runs import Piece

Floats = npt.NDArray[np.float64]


def has_flank(corner: Corner, placed: Sequence[Placed], boxes: Floats) -> bool:
    """Whether a straight piece cuts the corner at both of whose ends a third stroke ends: it is the
    flank of a groove, whose edges are seen, no chord of an arc."""
    neighbours = {corner.first.index, corner.second.index}
    near = (np.abs(boxes - corner.place) <= corner.longest + AROUND).all(axis=(1, 2))
    for index in set(np.flatnonzero(near).tolist()) - neighbours:
        line, piece = placed[index]
        if not isinstance(line, Line) or not is_within(line.points_at(samples(piece)), corner):
            continue
        ends = line.points_at(np.array([piece.start, piece.end]))
        thirds = [
            item.points_at(np.array([part.start, part.end]))
            for k, (item, part) in enumerate(placed)
            if k != index and k not in neighbours
        ]
        tips = np.concatenate([*thirds, np.empty((0, 2))])
        away = np.hypot(*np.moveaxis(tips[:, None] - ends, -1, 0))
        if len(tips) and (away.min(axis=0) < TOUCHING).all():
            return True
    return False


def is_within(points: Floats, corner: Corner) -> bool:
    """Whether a piece lies between the strokes: a chord of the arc that is looked for."""
    a, b = corner.shares(points - corner.place)
    return bool((np.minimum(a, b) > -1.5).all() and (a + b < corner.longest + 3.0).all())


def samples(piece: Piece) -> Floats:
    """(n,) positions along a piece, about a px apart."""
    return np.linspace(piece.start, piece.end, max(2, int(piece.end - piece.start)))
