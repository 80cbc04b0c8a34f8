"""Free curves of a file as strokes: arcs where they are as good as round, else straight pieces."""

from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.geometry.chains import Chain, simplified
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.file_noise import DOT, SAME_POINT

Floats = npt.NDArray[np.float64]

_ROUND = 0.25
"""px by which a curve may leave its circle: silhouettes are approximated by CAD systems."""

_BOWED = 20.0
"""Height of an arc over its chord, in what it may be off: flatter ones are not told from others."""


def free_curve(chain: Chain, linetype: Linetype) -> list[Arc | Segment]:
    """The strokes along a chain."""
    points = np.array(chain.points)
    arc = _arc(points, linetype)
    if arc is not None:
        return [arc]
    kept = simplified(points, DOT)
    return [
        Segment((float(a[0]), float(a[1])), (float(b[0]), float(b[1])), linetype)
        for a, b in pairwise(kept)
    ]


def _arc(points: Floats, linetype: Linetype) -> Arc | None:
    """The arc that (n, 2) points follow, or None."""
    if len(points) < 5:
        return None
    centre, radius = circle_through(points)
    offset = points - centre
    if np.abs(np.hypot(*offset.T) - radius).max() > _ROUND:
        return None
    angles = np.unwrap(np.arctan2(offset[:, 1], offset[:, 0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    one_way = (steps >= 0.0).all() or (steps <= 0.0).all()
    height = radius * (1.0 - np.cos(min(abs(sweep) / 2.0, np.pi)))
    if not one_way or height < _BOWED * _ROUND:
        return None
    start = float(np.mod(angles[0] if sweep > 0.0 else angles[-1], 2.0 * np.pi))
    closed = float(np.hypot(*(points[-1] - points[0]))) <= SAME_POINT
    turn = 2.0 * np.pi if closed else min(abs(sweep), 2.0 * np.pi)
    return Arc((float(centre[0]), float(centre[1])), radius, start, turn, linetype)
