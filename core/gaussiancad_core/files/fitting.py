"""The line, circle or ellipse that close points of a smooth curve lie on."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.file_curves import (
    FLATNESS,
    SMALLEST_SWEEP,
    STRAIGHT,
    Vector,
    affine_arc,
)
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.ellipses import LEAST_SWEEP, LONGEST_CHORD, ellipse_through
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped

_FLAT = 1e-12
"""Product of the spreads of points along and across, in the square of their sum, under which they
are in line as far as rounding tells."""


def circle_through(points: npt.NDArray[np.float64]) -> tuple[Vector, float]:
    """Centre and radius of the circle nearest to (n, 2) points by its equation (Kåsa's fit)."""
    middle = points.mean(axis=0)
    local = points - middle
    scale = float(np.abs(local).max()) or 1.0
    local = local / scale
    squares = (local**2).sum(axis=1)
    (xx, xy), (_, yy) = (local.T @ local).tolist()
    right = 0.5 * (squares @ local)
    x, y = right.tolist()
    determinant = xx * yy - xy * xy
    if determinant > _FLAT * (xx + yy) ** 2:
        centre = np.array([(x * yy - y * xy) / determinant, (y * xx - x * xy) / determinant])
    else:
        # Of points in line the smallest is taken.
        centre = right / ((xx + yy) or 1.0)
    radius = float(np.sqrt(max(float(squares.mean()) + float(centre @ centre), 0.0)))
    return middle + centre * scale, radius * scale


def circles_through(
    points: npt.NDArray[np.float64],
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """(n, 2) centres and (n,) radii of :func:`circle_through` each of (n, k, 2) points."""
    middles = points.mean(axis=1)
    local = points - middles[:, None]
    scales = np.abs(local).max(axis=(1, 2))
    scales = np.where(scales > 0.0, scales, 1.0)
    x, y = np.moveaxis(local / scales[:, None, None], 2, 0)
    squares = x * x + y * y
    xx, xy, yy = (x * x).sum(axis=1), (x * y).sum(axis=1), (y * y).sum(axis=1)
    right, upward = 0.5 * (squares * x).sum(axis=1), 0.5 * (squares * y).sum(axis=1)
    determinant, spread = xx * yy - xy * xy, np.maximum(xx + yy, 1e-300)
    is_flat = determinant <= _FLAT * spread**2
    under = np.where(is_flat, 1.0, determinant)
    centres = np.stack(
        [
            np.where(is_flat, right / spread, (right * yy - upward * xy) / under),
            np.where(is_flat, upward / spread, (upward * xx - right * xy) / under),
        ],
        axis=1,
    )
    radii = np.sqrt(np.maximum(squares.mean(axis=1) + (centres**2).sum(axis=1), 0.0))
    return middles + centres * scales[:, None], radii * scales


def curve_along(points: npt.NDArray[np.float64]) -> Curve:
    """The line or circular arc that (n, 2) points of a smooth curve lie on, else their chain.

    Args:
        points: px, so close that the curve between two of them is as good as straight.
    """
    ends = to_point(points[0]), to_point(points[-1])
    if len(points) == 2:
        return LineSegment(*ends)
    chord = points[-1] - points[0]
    length = float(np.hypot(*chord))
    if length > STRAIGHT:
        across = np.abs((points - points[0]) @ np.array([-chord[1], chord[0]])) / length
        if across.max() <= STRAIGHT:
            return LineSegment(*ends)
    if len(points) >= 5:
        arc = _arc_along(points) or _ellipse_along(points)
        if arc is not None:
            return arc
    return Chain(tuple(to_point(point) for point in points))


def thinned(curve: Curve) -> Curve:
    """A curve, with fewer corners of a smooth chain where it has more than its flatness asks for.

    Args:
        curve: px.
    """
    if not isinstance(curve, Chain) or len(curve.points) < 4:
        return curve
    points = np.array(curve.points)
    # The distance of a corner from the middle of its neighbours grows by the square of the step.
    bend = float(np.hypot(*np.diff(points, 2, axis=0).T).max()) / 2.0
    step = int(np.sqrt(FLATNESS / max(bend, 1e-12)))
    if step < 2:
        return curve
    return Chain((*curve.points[:-1:step], curve.points[-1]))


def _arc_along(points: npt.NDArray[np.float64]) -> CircularArc | None:
    centre, radius = circle_through(points)
    away = np.abs(np.hypot(*(points - centre).T) - radius)
    if away.max() > STRAIGHT:
        return None
    angles = np.unwrap(np.arctan2(points[:, 1] - centre[1], points[:, 0] - centre[0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    one_way = (steps > 0.0).all() or (steps < 0.0).all()
    if not one_way or np.abs(steps).max() > LONGEST_CHORD or abs(sweep) < SMALLEST_SWEEP:
        return None
    start = float(angles[0] if sweep > 0.0 else angles[-1])
    return CircularArc(to_point(centre), radius, wrapped(start), min(abs(sweep), FULL_TURN))


def _ellipse_along(points: npt.NDArray[np.float64]) -> Curve | None:
    """The ellipse that (n, 2) points lie on, by the conic through them."""
    if len(points) < 9:
        return None
    found = ellipse_through(points)
    if found is None:
        return None
    centre = np.array(found.centre)
    along = np.array([np.cos(found.rotation), np.sin(found.rotation)])
    u, v = found.semi_major * along, found.semi_minor * np.array([-along[1], along[0]])
    unit = (points - centre) @ np.linalg.inv(np.stack([u, v], axis=1)).T
    away = np.abs(np.hypot(*unit.T) - 1.0) * max(np.hypot(*u), np.hypot(*v))
    angles = np.unwrap(np.arctan2(unit[:, 1], unit[:, 0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    one_way = (steps > 0.0).all() or (steps < 0.0).all()
    if away.max() > FLATNESS or not one_way or abs(sweep) < LEAST_SWEEP:
        return None
    if np.abs(steps).max() > LONGEST_CHORD:
        return None
    return affine_arc(centre, u, v, float(angles[0]), sweep)
