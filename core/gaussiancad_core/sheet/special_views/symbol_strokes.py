"""The projection symbol of a file that tells its strokes: two circles and a cone in any pen, with
or without an axis through them."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.files.vectors import StrokeRole, VectorDrawing, VectorStroke
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.near_points import connected_groups, near_lists, near_pairs
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.special_views.symbol_shape import (
    AXES,
    Ends,
    ProjectionSymbol,
    agreed,
    is_around,
    symbol_near_text,
)
from gaussiancad_core.sheet.votes import LARGELY

Floats = npt.NDArray[np.float64]

_SMALLEST = 0.15
"""Length of a symbol at least, as a share of the largest one: 5 mm on paper."""

_ROUND = 0.04
"""The same share by which points of one may lie beside it, in its radius."""

_ON_END = 0.12
"""Distance of a line from the end of a cone that it closes at most, in the circles' radius."""

_BEYOND = 0.3
"""Length by which what closes a cone goes beyond its sides at most, in the circles' radius: the
base of a taper on a part goes on."""

_SLICES = 24
"""Places of an end that are looked at."""


def stroke_symbol(drawing: VectorDrawing, largest: float) -> ProjectionSymbol | None:
    """Find the projection symbol of a sheet; nothing where there is none, or several disagree.

    Args:
        drawing: of the sheet, which lies upright.
        largest: px that a symbol is long at most.
    """
    solid = [stroke for stroke in drawing.strokes if _is_solid(stroke)]
    lines = _lines(solid, largest)
    ways = np.abs(lines[:, 1] - lines[:, 0])
    slanted = lines[ways.min(axis=1) > 0.02 * ways.max(axis=1)] if len(lines) else lines
    if len(slanted) < 2:
        return None
    found = []
    for circle in _ringed(_circles(solid, largest / 2.0)):
        for axis in AXES:
            symbol = symbol_near_text(circle, axis, slanted, lambda ends: _is_closed(ends, lines))
            if symbol is not None and _SMALLEST * largest <= _length(symbol) <= largest:
                found.append(symbol)
    return agreed(found)


def _is_solid(stroke: VectorStroke) -> bool:
    return not stroke.dashes and stroke.role not in (StrokeRole.HIDDEN, StrokeRole.CENTRE)


def _length(symbol: ProjectionSymbol) -> float:
    x0, y0, x1, y1 = symbol.mark.box
    return max(x1 - x0, y1 - y0)


def _lines(strokes: list[VectorStroke], largest: float) -> Floats:
    """(n, 2, 2) ends of the straight pieces that are as short as a symbol's."""
    ends = [
        (stroke.curve.start, stroke.curve.end)
        for stroke in strokes
        if isinstance(stroke.curve, LineSegment)
    ]
    found = np.array(ends, dtype=float).reshape(-1, 2, 2)
    return found[np.hypot(*(found[:, 1] - found[:, 0]).T) <= largest]


def _circles(strokes: list[VectorStroke], largest: float) -> list[Circle]:
    """Whole circles of at most so many px of radius, whatever their file draws them with."""
    arcs = []
    for stroke in strokes:
        arc = _round(stroke.curve)
        if arc is not None and 0.0 < arc[2] <= largest:
            arcs.append(arc)
    if not arcs:
        return []
    places = np.array(arcs)
    groups = connected_groups(near_pairs(places[:, :3], ONE_PLACE), len(places))
    count = int(groups.max()) + 1
    swept = np.bincount(groups, weights=places[:, 3], minlength=count)
    means = [np.bincount(groups, weights=column, minlength=count) for column in places[:, :3].T]
    x, y, radius = np.array(means) / np.bincount(groups, minlength=count)
    return [
        Circle((float(x[i]), float(y[i])), float(radius[i]))
        for i in np.flatnonzero(swept >= LARGELY * FULL_TURN)
    ]


def _round(curve: object) -> tuple[float, float, float, float] | None:
    """Centre, radius and sweep of a curve that is a circle's, or as good as one."""
    if isinstance(curve, CircularArc):
        return (*curve.centre, curve.radius, curve.sweep)
    if isinstance(curve, EllipticArc) and curve.semi_minor > (1.0 - _ROUND) * curve.semi_major:
        return (*curve.centre, (curve.semi_major + curve.semi_minor) / 2.0, curve.sweep)
    if not isinstance(curve, Chain) or len(curve.points) < 5:
        return None
    points = np.array(curve.points)
    centre, radius = circle_through(points)
    away = points - centre
    if radius <= 0.0 or np.abs(np.hypot(*away.T) - radius).max() > _ROUND * radius:
        return None
    turned = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
    return float(centre[0]), float(centre[1]), radius, float(abs(turned[-1] - turned[0]))


def _ringed(circles: list[Circle]) -> list[Circle]:
    """Circles with another one around the same centre in them."""
    if not circles:
        return []
    centres = np.array([circle.centre for circle in circles])
    near = near_lists(centres, centres, max(circle.radius for circle in circles))
    return [
        outer
        for outer, inside in zip(circles, near, strict=True)
        if any(is_around(outer, circles[index]) for index in inside)
    ]


def _is_closed(ends: Ends, lines: Floats) -> bool:
    """Whether each end of a cone is drawn from side to side, and hardly beyond."""
    base = np.stack([ends.axis, ends.crosswise], axis=1)
    places = (lines - np.array(ends.circle.centre)) @ base
    for along, across in zip(ends.along, ends.across, strict=True):
        reach = _ON_END * ends.circle.radius
        item = places[(np.abs(places[:, :, 0] - along) <= reach).all(axis=1)][:, :, 1]
        low, high = item.min(axis=1), item.max(axis=1)
        near = (low <= across.max()) & (high >= across.min())
        low, high = low[near], high[near]
        steps = np.linspace(across.min(), across.max(), _SLICES + 2)[1:-1, None]
        covered = ((low <= steps) & (steps <= high)).any(axis=1)
        beyond = _BEYOND * ends.circle.radius
        if covered.mean() < LARGELY:
            return False
        if low.min() < across.min() - beyond or high.max() > across.max() + beyond:
            return False
    return True
