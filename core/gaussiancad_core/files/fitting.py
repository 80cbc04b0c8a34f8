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
from gaussiancad_core.geometry.ellipses import LEAST_SWEEP, LONGEST_CHORD
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped


def circle_through(points: npt.NDArray[np.float64]) -> tuple[Vector, float]:
    """Centre and radius of the circle nearest to (n, 2) points by its equation (Kåsa's fit)."""
    middle = points.mean(axis=0)
    local = points - middle
    scale = float(np.abs(local).max()) or 1.0
    local = local / scale
    system = np.column_stack([2.0 * local, np.ones(len(local))])
    solution = np.linalg.lstsq(system, (local**2).sum(axis=1), rcond=None)[0]
    radius = float(np.sqrt(max(solution[2] + solution[:2] @ solution[:2], 0.0)))
    return middle + solution[:2] * scale, radius * scale


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
    middle = points.mean(axis=0)
    size = float(np.abs(points - middle).max())
    x, y = ((points - middle) / size).T
    conic = np.linalg.svd(np.column_stack([x * x, x * y, y * y, x, y, np.ones_like(x)]))[2][-1]
    form = np.array([[conic[0], conic[1] / 2.0], [conic[1] / 2.0, conic[2]]])
    values, axes = np.linalg.eigh(form)
    if values.prod() <= 1e-6 * np.abs(values).max() ** 2:
        return None
    centre = np.linalg.solve(form, -conic[3:5] / 2.0)
    level = centre @ form @ centre - conic[5]
    halves = level / values
    if (halves <= 0.0).any():
        return None
    u, v = (axes[:, index] * np.sqrt(halves[index]) * size for index in (0, 1))
    centre = middle + centre * size
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
