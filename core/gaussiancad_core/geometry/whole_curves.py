"""Infinite lines, circles and ellipses of a plane: what segments and arcs are pieces of.

Scalar methods take points as pairs, and parameters: a length along a line, an angle of a circle.
Array methods take (n, 2) points, and positions, which are lengths on every curve: from the point of
a line, from angle 0 of a circle, from the end of an ellipse's major axis.
"""

from dataclasses import dataclass
from math import atan2, cos, hypot, inf, sin, sqrt

import numpy as np

from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.points import FULL_TURN, Point, Points
from gaussiancad_core.geometry.tolerances import COMPUTED

_PARALLEL = 1e-7
"""Sine of the angle below which lines do not meet."""

_ONE_POINT = 1e-3
"""Half distance of two meetings of circles below which the circles touch once."""


@dataclass(frozen=True)
class Line:
    """An infinite line.

    Attributes:
        point: (2,) one of its points; parameters and positions are counted from here.
        direction: (2,) unit vector.
    """

    point: Point
    direction: Point

    speed = 1.0
    """Length per parameter."""

    around = inf
    """Endless."""

    @property
    def axis(self) -> int | None:
        """Which coordinate is the same all along: 0, 1, or none."""
        if self.direction[0] == 0.0:
            return 0
        return 1 if self.direction[1] == 0.0 else None

    def at(self, parameter: float) -> Point:
        """(2,) point."""
        (x, y), (dx, dy) = self.point, self.direction
        return x + parameter * dx, y + parameter * dy

    def normal(self, parameter: float) -> Point:
        """(2,) unit normal."""
        return -self.direction[1], self.direction[0]

    def parameter(self, point: Point) -> float:
        """Parameter of the foot of a point."""
        (x, y), (dx, dy) = self.point, self.direction
        return (point[0] - x) * dx + (point[1] - y) * dy

    def distance(self, point: Point) -> float:
        """Distance of a point."""
        (x, y), (dx, dy) = self.point, self.direction
        return abs((point[1] - y) * dx - (point[0] - x) * dy)

    def coordinates(self, points: Points) -> tuple[Points, Points]:
        """(n, 2) points -> positions along the line and signed distances from it, (n,) each."""
        offset = points - np.array(self.point)
        along = offset @ np.array(self.direction)
        across = offset @ np.array([-self.direction[1], self.direction[0]])
        return along, across

    def distances(self, points: Points) -> Points:
        """(n, 2) points -> (n,) distances from the line."""
        return np.abs(self.coordinates(points)[1])

    def positions(self, points: Points) -> Points:
        """(n, 2) points -> (n,) positions of the nearest points of the line."""
        return self.coordinates(points)[0]

    def points_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) points."""
        return np.array(self.point) + along[:, None] * np.array(self.direction)

    def tangents_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) unit tangents."""
        return np.broadcast_to(np.array(self.direction), (len(along), 2))


@dataclass(frozen=True)
class Circle:
    """A whole circle.

    Attributes:
        centre: (2,).
        radius: positive.
    """

    centre: Point
    radius: float

    axis = None
    """No coordinate is the same all along."""

    @property
    def speed(self) -> float:
        """Length per parameter."""
        return self.radius

    @property
    def around(self) -> float:
        """Its circumference."""
        return FULL_TURN * self.radius

    def at(self, parameter: float) -> Point:
        """(2,) point at an angle."""
        x, y = self.centre
        return x + self.radius * cos(parameter), y + self.radius * sin(parameter)

    def normal(self, parameter: float) -> Point:
        """(2,) unit normal at an angle."""
        return cos(parameter), sin(parameter)

    def parameter(self, point: Point) -> float:
        """Angle of the foot of a point, from 0 to 2 pi."""
        return atan2(point[1] - self.centre[1], point[0] - self.centre[0]) % FULL_TURN

    def distance(self, point: Point) -> float:
        """Distance of a point."""
        away = hypot(point[0] - self.centre[0], point[1] - self.centre[1])
        return abs(away - self.radius)

    def distances(self, points: Points) -> Points:
        """(n, 2) points -> (n,) distances from the circle."""
        offset = points - np.array(self.centre)
        return np.abs(np.hypot(offset[:, 0], offset[:, 1]) - self.radius)

    def positions(self, points: Points) -> Points:
        """(n, 2) points -> (n,) positions of the nearest points, -half to half around."""
        offset = points - np.array(self.centre)
        return np.arctan2(offset[:, 1], offset[:, 0]) * self.radius

    def points_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) points."""
        return np.array(self.centre) + self.radius * self._radial(along)

    def tangents_at(self, along: Points) -> Points:
        """(n,) positions -> (n, 2) unit tangents, the way that positions grow."""
        radial = self._radial(along)
        return np.stack([-radial[:, 1], radial[:, 0]], 1)

    def _radial(self, along: Points) -> Points:
        angles = along / self.radius
        return np.stack([np.cos(angles), np.sin(angles)], 1)


LineOrCircle = Line | Circle

ClosedCurve = Circle | WholeEllipse

WholeCurve = Line | Circle | WholeEllipse
"""Whatever strokes are pieces of, but for chains."""


def line_through(start: Point, end: Point, straight: float = 1e-6) -> Line:
    """The line through two distinct points; nearly axis-parallel ones become exactly so.

    Its direction's first component is positive, or the direction is (0, 1).

    Args:
        start, end: (2,).
        straight: direction component below which it is taken for 0.
    """
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = hypot(dx, dy)
    dx, dy = dx / length, dy / length
    if abs(dx) <= straight:
        return Line(start, (0.0, 1.0))
    if abs(dy) <= straight:
        return Line(start, (1.0, 0.0))
    return Line(start, (dx, dy) if dx > 0.0 else (-dx, -dy))


def axis_line(axis: int, value: float) -> Line:
    """The line on which a coordinate (0 or 1) has a value."""
    if axis == 0:
        return Line((value, 0.0), (0.0, 1.0))
    return Line((0.0, value), (1.0, 0.0))


def meetings(one: LineOrCircle, other: LineOrCircle) -> list[Point]:
    """The points that two different curves share; a touching counts once."""
    if isinstance(one, Line):
        if isinstance(other, Line):
            return _lines_meet(one, other)
        return _line_meets_circle(one, other)
    if isinstance(other, Line):
        return _line_meets_circle(other, one)
    return _circles_meet(one, other)


def _lines_meet(one: Line, other: Line) -> list[Point]:
    (x, y), (dx, dy) = one.point, one.direction
    (ox, oy), (ex, ey) = other.point, other.direction
    sine = dx * ey - dy * ex
    if abs(sine) < _PARALLEL:
        return []
    return [one.at(((ox - x) * ey - (oy - y) * ex) / sine)]


def _line_meets_circle(line: Line, circle: Circle) -> list[Point]:
    foot = line.parameter(circle.centre)
    x, y = line.at(foot)
    away = hypot(x - circle.centre[0], y - circle.centre[1])
    if away > circle.radius + COMPUTED:
        return []
    if away > circle.radius - COMPUTED:
        return [(x, y)]
    half = sqrt(circle.radius**2 - away**2)
    return [line.at(foot - half), line.at(foot + half)]


def _circles_meet(one: Circle, other: Circle) -> list[Point]:
    dx, dy = other.centre[0] - one.centre[0], other.centre[1] - one.centre[1]
    away = hypot(dx, dy)
    if away < COMPUTED:
        return []
    if not abs(one.radius - other.radius) - COMPUTED <= away <= one.radius + other.radius + 1e-6:
        return []
    dx, dy = dx / away, dy / away
    along = (away**2 + one.radius**2 - other.radius**2) / (2.0 * away)
    half = sqrt(max(0.0, one.radius**2 - along**2))
    x, y = one.centre[0] + along * dx, one.centre[1] + along * dy
    if half < _ONE_POINT:
        return [(x, y)]
    return [(x - half * dy, y + half * dx), (x + half * dy, y - half * dx)]
