"""The edges of closed outlines: lines, arcs and circles that meet at their ends."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import atan2, hypot

from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.whole_curves import Circle


@dataclass(frozen=True)
class OutlineEdge:
    """A straight edge, an arc, or a circle.

    Attributes:
        start, end: (2,); equal of a whole circle.
        circle: on which it lies; None of a straight edge.
        is_ccw: whether an arc runs counter-clockwise.
    """

    start: Point
    end: Point
    circle: Circle | None = None
    is_ccw: bool = True

    @property
    def is_circle(self) -> bool:
        """Whether it is a whole circle."""
        return self.circle is not None and self.start == self.end

    @property
    def sweep(self) -> float:
        """Radians that an arc turns, positive; a whole turn of a circle."""
        if self.circle is None:
            return 0.0
        if self.is_circle:
            return FULL_TURN
        (x, y), ends = self.circle.centre, (self.start, self.end)
        first, last = (atan2(point[1] - y, point[0] - x) for point in ends)
        return (last - first) % FULL_TURN if self.is_ccw else (first - last) % FULL_TURN

    @property
    def middle(self) -> Point:
        """(2,) halfway along it."""
        if self.circle is None:
            (x0, y0), (x1, y1) = self.start, self.end
            return (x0 + x1) / 2.0, (y0 + y1) / 2.0
        (x, y), half = self.circle.centre, self.sweep / 2.0
        first = atan2(self.start[1] - y, self.start[0] - x)
        return self.circle.at(first + half if self.is_ccw else first - half)

    def heading(self, at_start: bool) -> Point:
        """Unit vector in which it runs at its start or end."""
        place = self.start if at_start else self.end
        if self.circle is None:
            dx, dy = self.end[0] - self.start[0], self.end[1] - self.start[1]
        else:
            way, (x, y) = 1.0 if self.is_ccw else -1.0, self.circle.centre
            dx, dy = way * (y - place[1]), way * (place[0] - x)
        length = hypot(dx, dy)
        return dx / length, dy / length


def whole_circle(circle: Circle, is_ccw: bool = True) -> OutlineEdge:
    """A circle that starts and ends in the direction of the first axis."""
    start = circle.centre[0] + circle.radius, circle.centre[1]
    return OutlineEdge(start, start, circle, is_ccw)


def enclosed_area(edges: Iterable[OutlineEdge]) -> float:
    """Area within a closed outline; negative where it runs clockwise."""
    total = 0.0
    for edge in edges:
        (x0, y0), (x1, y1) = edge.start, edge.end
        total += (x0 * y1 - x1 * y0) / 2.0
        if edge.circle is not None:
            way, (x, y) = 1.0 if edge.is_ccw else -1.0, edge.circle.centre
            chord = (x0 - x) * (y1 - y) - (x1 - x) * (y0 - y)
            total += (way * edge.sweep * edge.circle.radius**2 - chord) / 2.0
    return total
