"""Where lines and circles of a view's plane cross or touch."""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.registration.stroke_carriers import Round, Slant

Point = tuple[float, float]

_FLAT = 0.09
"""Sine of the flattest angle at which two lines cross in a point that is known."""


def crossings(slant: Round | Slant, direction: int, value: float, touch: float) -> list[float]:
    """The other coordinates at which a support has ``value`` in a direction.

    A circle that comes within ``touch`` px of the value touches it.
    """
    if isinstance(slant, Slant):
        way = slant.line.direction
        if abs(way[direction]) < _FLAT:
            return []
        along = (value - slant.line.point[direction]) / way[direction]
        return [slant.line.point[1 - direction] + along * way[1 - direction]]
    away, middle = value - slant.centre[direction], slant.centre[1 - direction]
    if abs(abs(away) - slant.radius) <= touch:
        return [middle]
    if abs(away) > slant.radius:
        return []
    half = float(np.sqrt(slant.radius**2 - away**2))
    return [middle - half, middle + half]


def nearest(points: Sequence[Point], place: Point, reach: float) -> Point | None:
    """The point next to a place, if one is within reach."""

    def away(point: Point) -> float:
        return float(np.hypot(point[0] - place[0], point[1] - place[1]))

    best = min(points, key=away, default=None)
    return best if best is not None and away(best) <= reach else None


def meeting(first: Round | Slant, second: Round | Slant, touch: float) -> list[Point]:
    """Where two supports cross, or touch within ``touch`` px."""
    if isinstance(first, Slant) and isinstance(second, Slant):
        return _line_line(first.line, second.line)
    if isinstance(first, Round) and isinstance(second, Round):
        return _circle_circle(first, second, touch)
    if isinstance(first, Slant):
        first, second = second, first
    assert isinstance(first, Round)
    assert isinstance(second, Slant)
    circle, line = first, second.line
    along, across = (float(v[0]) for v in line.coordinates(np.array([circle.centre])))
    if abs(abs(across) - circle.radius) <= touch:
        return [line.at(along)]
    if abs(across) > circle.radius:
        return []
    half = float(np.sqrt(circle.radius**2 - across**2))
    return [line.at(along - half), line.at(along + half)]


def _line_line(a: Line, b: Line) -> list[Point]:
    sine = a.direction[0] * b.direction[1] - a.direction[1] * b.direction[0]
    if abs(sine) < _FLAT:
        return []
    dx, dy = b.point[0] - a.point[0], b.point[1] - a.point[1]
    return [a.at((dx * b.direction[1] - dy * b.direction[0]) / sine)]


def _circle_circle(a: Round, b: Round, touch: float) -> list[Point]:
    way = np.subtract(b.centre, a.centre)
    distance = float(np.hypot(*way))
    if distance <= touch:
        return []
    way = way / distance
    across = np.array([-way[1], way[0]])
    inner = abs(distance - abs(a.radius - b.radius)) <= touch
    if inner or abs(distance - a.radius - b.radius) <= touch:
        side = -1.0 if inner and a.radius < b.radius else 1.0
        halves, along = [0.0], side * a.radius
    else:
        along = (distance**2 + a.radius**2 - b.radius**2) / (2 * distance)
        if abs(along) > a.radius:
            return []
        half = float(np.sqrt(a.radius**2 - along**2))
        halves = [-half, half]
    points = [np.array(a.centre) + along * way + half * across for half in halves]
    return [(float(p[0]), float(p[1])) for p in points]
