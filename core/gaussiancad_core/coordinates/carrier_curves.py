"""Lines and circles of a plane: the traces of the surfaces that are seen edge-on in a view.

Lengths are in units of a hundredth of the part's longest extent (see
:mod:`gaussiancad_core.model.projection_planes`), so that the tolerances of this room are plain
numbers.
"""

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin, sqrt

from gaussiancad_core.geometry.tolerances import COMPUTED

Point = tuple[float, float]

TURN = 2.0 * pi

_PARALLEL = 1e-7
"""Sine of the angle below which lines do not meet."""

_ONE_POINT = 1e-3
"""Half distance of two meetings of circles below which the circles touch once."""


@dataclass(frozen=True)
class LineCurve:
    """A whole straight line.

    Attributes:
        point: (2,) one of its points; parameters are counted from here.
        direction: (2,) unit vector; first component positive, or (0, 1).
    """

    point: Point
    direction: Point

    speed = 1.0
    """Length per parameter."""

    @property
    def axis(self) -> int | None:
        """Which coordinate is the same all along: 0, 1, or none."""
        if self.direction == (0.0, 1.0):
            return 0
        return 1 if self.direction == (1.0, 0.0) else None

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


@dataclass(frozen=True)
class CircleCurve:
    """A whole circle; parameters are angles from 0 to 2 pi.

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

    def at(self, parameter: float) -> Point:
        """(2,) point."""
        x, y = self.centre
        return x + self.radius * cos(parameter), y + self.radius * sin(parameter)

    def normal(self, parameter: float) -> Point:
        """(2,) unit normal."""
        return cos(parameter), sin(parameter)

    def parameter(self, point: Point) -> float:
        """Parameter of the foot of a point, from 0 to 2 pi."""
        return atan2(point[1] - self.centre[1], point[0] - self.centre[0]) % TURN

    def distance(self, point: Point) -> float:
        """Distance of a point."""
        away = hypot(point[0] - self.centre[0], point[1] - self.centre[1])
        return abs(away - self.radius)


PlaneCurve = LineCurve | CircleCurve


def line_through(start: Point, end: Point, straight: float = 1e-6) -> LineCurve:
    """The line through two distinct points; nearly axis-parallel ones become exactly so.

    Args:
        start, end: (2,).
        straight: direction component below which it is taken for 0.
    """
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = hypot(dx, dy)
    dx, dy = dx / length, dy / length
    if abs(dx) <= straight:
        return LineCurve(start, (0.0, 1.0))
    if abs(dy) <= straight:
        return LineCurve(start, (1.0, 0.0))
    return LineCurve(start, (dx, dy) if dx > 0.0 else (-dx, -dy))


def axis_line(axis: int, value: float) -> LineCurve:
    """The line on which a coordinate (0 or 1) has a value."""
    if axis == 0:
        return LineCurve((value, 0.0), (0.0, 1.0))
    return LineCurve((0.0, value), (1.0, 0.0))


def meetings(one: PlaneCurve, other: PlaneCurve) -> list[Point]:
    """The points that two different curves share; a touching counts once."""
    if isinstance(one, LineCurve):
        if isinstance(other, LineCurve):
            return _lines_meet(one, other)
        return _line_meets_circle(one, other)
    if isinstance(other, LineCurve):
        return _line_meets_circle(other, one)
    return _circles_meet(one, other)


def _lines_meet(one: LineCurve, other: LineCurve) -> list[Point]:
    (x, y), (dx, dy) = one.point, one.direction
    (ox, oy), (ex, ey) = other.point, other.direction
    sine = dx * ey - dy * ex
    if abs(sine) < _PARALLEL:
        return []
    return [one.at(((ox - x) * ey - (oy - y) * ex) / sine)]


def _line_meets_circle(line: LineCurve, circle: CircleCurve) -> list[Point]:
    foot = line.parameter(circle.centre)
    x, y = line.at(foot)
    away = hypot(x - circle.centre[0], y - circle.centre[1])
    if away > circle.radius + COMPUTED:
        return []
    if away > circle.radius - COMPUTED:
        return [(x, y)]
    half = sqrt(circle.radius**2 - away**2)
    return [line.at(foot - half), line.at(foot + half)]


def _circles_meet(one: CircleCurve, other: CircleCurve) -> list[Point]:
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
