"""Handles: places of a stroke or of a view's box that can be moved, and what they make of it."""

from __future__ import annotations

from math import hypot

from freecad.gaussiancad.canvas.sheet import Box, Point, Shape, Stroke


def handles_of(stroke: Stroke) -> list[Point]:
    """Places of a stroke that can be moved: ends of a line, centre and rim of a circle."""
    name, numbers = stroke.shape
    if name == "line":
        return list(numbers)
    if stroke.circle is not None:
        x, y, radius = stroke.circle
        return [(x, y), (x + radius, y)]
    return []


def with_handle(shape: Shape, index: int, to: Point) -> Shape:
    """The shape of a stroke of which a handle was moved."""
    name, numbers = shape
    if name == "line":
        ends = list(numbers)
        ends[index] = to
        return name, tuple(ends)
    x, y, radius, first, sweep = numbers
    if index == 0:
        return name, (*to, radius, first, sweep)
    return name, (x, y, max(hypot(to[0] - x, to[1] - y), 1.0), first, sweep)


def corners_of(box: Box) -> list[Point]:
    """Corners of a box: top left, top right, bottom right, bottom left on the sheet."""
    x0, y0, x1, y1 = box
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def box_between(one: Point, other: Point) -> Box:
    """The box between two opposite corners."""
    (a, b), (c, d) = one, other
    return min(a, c), min(b, d), max(a, c), max(b, d)


def with_corner(box: Box, index: int, to: Point) -> Box:
    """A box of which a corner was moved."""
    return box_between(corners_of(box)[(index + 2) % 4], to)
