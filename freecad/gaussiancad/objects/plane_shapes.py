"""Shapes of lines: from px of a sheet as stored, y down, to a plane in mm, y up.

A shape is its name and its numbers as in ``reading.json``: ``line`` (two points), ``arc`` (x, y,
radius, start, sweep), ``ellipse`` (x, y, semi-axes, rotation, start, sweep).  Angles run from x to
y: on the sheet clockwise to the eye, in a plane against the clock.
"""

from collections.abc import Iterator
from math import atan2, cos, hypot, pi, sin

Point = tuple[float, float]
Shape = tuple[str, tuple]

_FULL_TURN = 2.0 * pi
_WHOLE = 1e-6
"""Radians that a whole turn may lack."""

_ROUND = 1e-9
"""Share of its longer half by which an ellipse may be no circle."""


def turned(shape: Shape, angle: float) -> Shape:
    """A shape turned about the sheet's corner by an angle from x to y."""
    name, numbers = shape
    if not angle:
        return shape
    if name == "line":
        start, end = numbers
        return name, (_turned(start, angle), _turned(end, angle))
    centre, sizes = _turned(numbers[:2], angle), numbers[2:]
    if name == "arc":
        radius, first, sweep = sizes
        return name, (*centre, radius, first + angle, sweep)
    major, minor, rotation, first, sweep = sizes
    return name, (*centre, major, minor, rotation + angle, first, sweep)


def on_plane(shape: Shape, corner: Point, mm_per_px: float, at: Point = (0.0, 0.0)) -> Shape:
    """A shape of the upright sheet on a plane.

    Args:
        shape: px, y down.
        corner: px on the sheet that come to ``at``.
        mm_per_px: of the part.
        at: mm on the plane.
    """

    def place(point: Point) -> Point:
        x = at[0] + mm_per_px * (point[0] - corner[0])
        return x, at[1] + mm_per_px * (corner[1] - point[1])

    name, numbers = shape
    if name == "line":
        return name, (place(numbers[0]), place(numbers[1]))
    centre, sizes = place(numbers[:2]), numbers[2:]
    if name == "arc":
        radius, first, sweep = sizes
        return name, (*centre, mm_per_px * radius, -first - sweep, sweep)
    major, minor, rotation, first, sweep = sizes
    return name, (*centre, mm_per_px * major, mm_per_px * minor, -rotation, -first - sweep, sweep)


def box_of(shape: Shape) -> tuple[float, float, float, float]:
    """(x0, y0, x1, y1) around a shape, exactly."""
    points = list(_outermost(shape))
    xs, ys = [point[0] for point in points], [point[1] for point in points]
    return min(xs), min(ys), max(xs), max(ys)


def ends_of(shape: Shape) -> tuple[Point, Point] | None:
    """Where a shape begins and where it ends; None of a whole turn."""
    name, numbers = shape
    if name == "line":
        return numbers[0], numbers[1]
    if is_whole(shape):
        return None
    first, sweep = numbers[-2:]
    return _along(shape, first), _along(shape, first + sweep)


def is_whole(shape: Shape) -> bool:
    """Whether a curve closes: a circle, a whole ellipse."""
    name, numbers = shape
    return name != "line" and numbers[-1] >= _FULL_TURN - _WHOLE


def length_of_line(shape: Shape) -> float:
    """Between the ends of a line."""
    (x0, y0), (x1, y1) = shape[1]
    return hypot(x1 - x0, y1 - y0)


def as_circle(shape: Shape) -> Shape:
    """An ellipse with equal semi-axes as an arc; everything else as it is."""
    name, numbers = shape
    if name != "ellipse" or abs(numbers[2] - numbers[3]) > _ROUND * numbers[2]:
        return shape
    x, y, radius, _, rotation, first, sweep = numbers
    return "arc", (x, y, radius, rotation + first, sweep)


def _turned(point: Point, angle: float) -> Point:
    x, y = point
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


def _along(shape: Shape, angle: float) -> Point:
    """A point of an arc or an ellipse."""
    x, y, major, minor, rotation = _axes(shape)
    a, b = major * cos(angle), minor * sin(angle)
    return x + a * cos(rotation) - b * sin(rotation), y + a * sin(rotation) + b * cos(rotation)


def _axes(shape: Shape) -> tuple[float, float, float, float, float]:
    name, numbers = shape
    if name == "arc":
        x, y, radius = numbers[:3]
        return x, y, radius, radius, 0.0
    return numbers[:5]


def _outermost(shape: Shape) -> Iterator[Point]:
    """Its ends, and where it runs level or upright."""
    if shape[0] == "line":
        yield from shape[1]
        return
    first, sweep = shape[1][-2:]
    _, _, major, minor, rotation = _axes(shape)
    across = atan2(-minor * sin(rotation), major * cos(rotation))
    down = atan2(minor * cos(rotation), major * sin(rotation))
    for angle in (first, first + sweep):
        yield _along(shape, angle)
    for angle in (across, across + pi, down, down + pi):
        if (angle - first) % _FULL_TURN <= sweep:
            yield _along(shape, angle)
