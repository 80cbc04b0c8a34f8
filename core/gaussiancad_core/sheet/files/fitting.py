"""The line, circle or ellipse that close points of a smooth curve lie on."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.files.curves import (
    FLATNESS,
    SMALLEST_SWEEP,
    STRAIGHT,
    Vector,
    affine_arc,
    to_point,
    wrapped,
)
from gaussiancad_core.sheet.files.vectors import FULL_TURN, Chain, CircularArc, Curve, Line

_ON_CIRCLE = 5e-3
"""px by which points of a circle may lie beside it."""

_SMALLEST_CONIC_SWEEP = np.radians(20.0)
"""Under this turn, many ellipses fit a curve."""

_LARGEST_STEP = np.radians(15.0)
"""The points of a polygon may lie on a circle too, but turn by more at once."""

_PLOTTED = 0.15
"""px by which plotted points may lie beside their circle: plotters round to 1/1200 inch or so."""

_FEWEST_PLOTTED, _SMALLEST_PLOTTED = 6, np.radians(15.0)
"""Pieces and turn from which a chain of plotted pieces is taken for an arc."""

_MOST_PLOTTED = 1024
"""Pieces of a plotted arc that are looked at."""


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
        return Line(*ends)
    chord = points[-1] - points[0]
    length = float(np.hypot(*chord))
    if length > STRAIGHT:
        across = np.abs((points - points[0]) @ np.array([-chord[1], chord[0]])) / length
        if across.max() <= STRAIGHT:
            return Line(*ends)
    if len(points) >= 5:
        arc = _arc_along(points) or _ellipse_along(points)
        if arc is not None:
            return arc
    return Chain(tuple(to_point(point) for point in points))


def _arc_along(points: npt.NDArray[np.float64]) -> CircularArc | None:
    centre, radius = circle_through(points)
    away = np.abs(np.hypot(*(points - centre).T) - radius)
    if away.max() > _ON_CIRCLE:
        return None
    angles = np.unwrap(np.arctan2(points[:, 1] - centre[1], points[:, 0] - centre[0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    one_way = (steps > 0.0).all() or (steps < 0.0).all()
    if not one_way or np.abs(steps).max() > _LARGEST_STEP or abs(sweep) < SMALLEST_SWEEP:
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
    if away.max() > FLATNESS or not one_way or abs(sweep) < _SMALLEST_CONIC_SWEEP:
        return None
    if np.abs(steps).max() > _LARGEST_STEP:
        return None
    return affine_arc(centre, u, v, float(angles[0]), sweep)


def lines_and_arcs(points: npt.NDArray[np.float64]) -> list[Curve]:
    """Curves along a polygon that a plotter drew: arcs where many short pieces turn alike.

    Args:
        points: (n, 2) px, no two neighbours at the same place.
    """
    ways = np.diff(points, axis=0)
    angles = np.arctan2(ways[:, 1], ways[:, 0])
    turns = np.angle(np.exp(1j * np.diff(angles)))
    curves: list[Curve] = []
    index = 0
    while index < len(ways):
        window = slice(index, index + _MOST_PLOTTED)
        count = _arc_pieces(points[index : index + _MOST_PLOTTED + 2], turns[window])
        arc = _plotted_arc(points[index : index + count + 1]) if count else None
        if arc is None:
            curves.append(Line(to_point(points[index]), to_point(points[index + 1])))
            index += 1
        else:
            curves.append(arc)
            index += count
    return curves


def _arc_pieces(points: npt.NDArray[np.float64], turns: npt.NDArray[np.float64]) -> int:
    """How many pieces from the first on lie on one circle; 0 if too few."""
    if len(turns) < _FEWEST_PLOTTED - 1 or not 0.0 < abs(turns[0]) < _LARGEST_STEP:
        return 0
    alike = (np.abs(turns) < _LARGEST_STEP) & (turns * turns[0] > 0.0)
    most = len(turns) + 1 if alike.all() else int(np.argmin(alike)) + 1
    low, high = 0, most
    # The longest run that still fits, by bisection: an arc's beginning fits where it does.
    while low < high:
        middle = (low + high + 1) // 2
        if _plotted_arc(points[: middle + 1]) is None and middle >= _FEWEST_PLOTTED:
            high = middle - 1
        else:
            low = middle
    return low if low >= _FEWEST_PLOTTED else 0


def _plotted_arc(points: npt.NDArray[np.float64]) -> CircularArc | None:
    """The arc that (n, 2) plotted points follow, or None."""
    if len(points) <= _FEWEST_PLOTTED:
        return None
    centre, radius = circle_through(points)
    away = np.abs(np.hypot(*(points - centre).T) - radius)
    angles = np.unwrap(np.arctan2(points[:, 1] - centre[1], points[:, 0] - centre[0]))
    steps = np.diff(angles)
    sweep = float(angles[-1] - angles[0])
    one_way = (steps > 0.0).all() or (steps < 0.0).all()
    even = np.abs(steps).max() <= 4.0 * np.median(np.abs(steps))
    if away.max() > _PLOTTED or not (one_way and even) or abs(sweep) < _SMALLEST_PLOTTED:
        return None
    if np.abs(steps).max() > _LARGEST_STEP:
        return None
    if np.hypot(*(points[-1] - points[0])) < 1e-6:
        sweep = FULL_TURN
    start = float(angles[0] if sweep > 0.0 else angles[-1])
    return CircularArc(to_point(centre), radius, wrapped(start), min(abs(sweep), FULL_TURN))
