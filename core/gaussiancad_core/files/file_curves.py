"""Exact curves under the maps that files apply: ellipses from circles, drawings onto the sheet."""

from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped
from gaussiancad_core.geometry.similarities import Similarity

Vector = npt.NDArray[np.float64]
"""(2,)"""

FLATNESS = 0.02
"""px by which a chain may leave the curve that it follows; nearer places and curves are one."""

STRAIGHT = 5e-3
"""px by which a curve that is a line or a circle may leave it: a quarter of the flatness."""

SMALLEST_SWEEP = np.radians(2.0)
"""Under this turn, the centre of an arc is too uncertain."""

MOST_CHORDS = 1024
"""Chords that stand for one curve at most, whatever its size."""

_ROUND = 1e-4
"""Share of the radius by which the axes of a circle may differ: files round what is in them."""


def affine_arc(centre: Vector, u: Vector, v: Vector, start: float, sweep: float) -> Curve:
    """The arc ``centre + u cos t + v sin t``, ``t`` from ``start`` on, over a signed ``sweep``.

    Any affine image of a circle has this form.  It comes back as a circular arc where it is one,
    as a line where it is seen edge-on, and as an elliptic arc otherwise.
    """
    axes, sizes, turn = np.linalg.svd(np.stack([u, v], axis=1))
    if np.linalg.det(axes) < 0.0:
        axes[:, 1] *= -1.0
        turn[1] *= -1.0
    sweep = float(np.clip(sweep, -FULL_TURN, FULL_TURN))
    low = start if sweep >= 0.0 else start + sweep
    handed = float(np.sign(np.linalg.det(turn)))
    if handed < 0.0:
        low = start + max(sweep, 0.0)
    first = turn @ np.array([np.cos(low), np.sin(low)])
    angle = float(np.arctan2(first[1], first[0]))
    sweep = abs(sweep)
    if sizes[1] <= 1e-9 * sizes[0]:
        reach = np.cos(angle + np.linspace(0.0, sweep, 257)) * sizes[0]
        ends = [centre + axes[:, 0] * value for value in (reach.min(), reach.max())]
        return LineSegment(to_point(ends[0]), to_point(ends[1]))
    tilt = float(np.arctan2(axes[1, 0], axes[0, 0]))
    if sizes[0] - sizes[1] <= _ROUND * sizes[0]:
        radius = float(sizes.mean())
        return CircularArc(to_point(centre), radius, wrapped(angle + tilt), sweep)
    semi_major, semi_minor = to_point(sizes)
    return EllipticArc(to_point(centre), semi_major, semi_minor, tilt, wrapped(angle), sweep)


def polygon_curves(points: npt.NDArray[np.float64]) -> list[Curve]:
    """A line for each piece of (n, 2) points that is longer than nothing."""
    ways = np.diff(points, axis=0)
    long = (np.hypot(ways[:, 0], ways[:, 1]) > 1e-9).tolist()
    corners = [(x, y) for x, y in points.tolist()]
    return [
        LineSegment(*ends) for ends, is_long in zip(pairwise(corners), long, strict=True) if is_long
    ]


def placed(curve: Curve, scale: float, left: float, top: float) -> Curve:
    """A curve of a drawing whose y points up, in px: the point (left, top) becomes the origin."""

    return curve.mapped(Similarity(scale, flip=True, origin=(left, top)))
