"""The variables of a sketch, and how its points depend on them."""

from dataclasses import dataclass
from enum import Enum
from math import cos, hypot, sin

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.tolerances import COMPUTED

Vector = npt.NDArray[np.float64]


class Spot(Enum):
    """A point of an element."""

    START = "start"
    END = "end"
    CENTRE = "centre"


@dataclass(frozen=True)
class Reference:
    """An element of a sketch, or a point of it.

    Attributes:
        element: its number; -1 of the sketch's origin.
        spot: which point; None of the whole element.
    """

    element: int
    spot: Spot | None = None


ORIGIN = Reference(-1, Spot.START)


class Geometry:
    """Lines, arcs and circles with their variables.

    A line has the coordinates of its ends, a circle those of its centre and its radius, an arc two
    angles as well, each counted as the length that it moves an end by.

    Args:
        edges: the elements, mm.

    Attributes:
        edges: as given.
        size: how many variables there are.
    """

    def __init__(self, edges: tuple[OutlineEdge, ...]) -> None:
        self.edges = edges
        self._first = []
        self.size = 0
        for edge in edges:
            self._first.append(self.size)
            self.size += 4 if edge.circle is None else 3 if edge.is_circle else 5
        self._columns = [self._sorted(axis) for axis in (0, 1)]

    def is_arc(self, element: int) -> bool:
        """Whether an element is an arc."""
        edge = self.edges[element]
        return edge.circle is not None and not edge.is_circle

    def columns(self, axis: int) -> list[tuple[float, list[Reference]]]:
        """Coordinates along an axis, ascending, each with the points that have it; the origin is
        the first of its own."""
        return self._columns[axis]

    def point(self, reference: Reference) -> Vector:
        """(2, variables) gradients of a point's coordinates."""
        found = np.zeros((2, self.size))
        if reference == ORIGIN:
            return found
        edge, first = self.edges[reference.element], self._first[reference.element]
        if edge.circle is None:
            offset = 0 if reference.spot is Spot.START else 2
            found[0, first + offset] = found[1, first + offset + 1] = 1.0
            return found
        found[0, first] = found[1, first + 1] = 1.0
        if reference.spot is not Spot.CENTRE:
            place = edge.start if reference.spot is Spot.START else edge.end
            angle = edge.circle.parameter(place)
            found[:, first + 2] = cos(angle), sin(angle)
            number = 3 if reference.spot is Spot.START else 4
            found[:, first + number] = -sin(angle), cos(angle)
        return found

    def radius(self, element: int) -> Vector:
        """(variables,) gradient of a radius."""
        found = np.zeros(self.size)
        found[self._first[element] + 2] = 1.0
        return found

    def direction(self, reference: Reference) -> Vector:
        """(variables,) gradient of the angle of an edge's direction at an end."""
        found = np.zeros(self.size)
        edge, first = self.edges[reference.element], self._first[reference.element]
        if edge.circle is None:
            dx, dy = edge.end[0] - edge.start[0], edge.end[1] - edge.start[1]
            length = hypot(dx, dy) ** 2
            found[first : first + 4] = dy / length, -dx / length, -dy / length, dx / length
        else:
            found[first + (3 if reference.spot is Spot.START else 4)] = 1.0 / edge.circle.radius
        return found

    def _sorted(self, axis: int) -> list[tuple[float, list[Reference]]]:
        places: list[tuple[float, Reference]] = [(0.0, ORIGIN)]
        for number, edge in enumerate(self.edges):
            if edge.circle is not None:
                places.append((edge.circle.centre[axis], Reference(number, Spot.CENTRE)))
            if not edge.is_circle:
                places.append((edge.start[axis], Reference(number, Spot.START)))
        found: list[tuple[float, list[Reference]]] = []
        # The origin, where it is among others, is the first of them.
        for value, reference in sorted(places, key=lambda place: place[0]):
            if found and value - found[-1][0] < COMPUTED:
                group = found[-1][1]
                group.insert(0 if reference == ORIGIN else len(group), reference)
            else:
                found.append((value, [reference]))
        return found
