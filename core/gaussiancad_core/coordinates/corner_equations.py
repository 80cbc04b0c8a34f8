"""What it means that a corner lies on a line, circle or face, or that two touch, as an equation.

Corners, circles, and what moves lines and faces, are numbers of one list (see
:mod:`.linear_constraints`).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import hypot, sqrt

import numpy as np
import numpy.typing as npt

from gaussiancad_core.coordinates.linear_constraints import Numbers, Terms
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Line, line_through, meetings


@dataclass(frozen=True)
class Slant:
    """A line that is parallel to no axis, as a view shows it.

    Attributes:
        start, end: (2,) in its plane.
        weight: its length by its confidence.
    """

    start: Point
    end: Point
    weight: float


@dataclass(frozen=True)
class OnSlant:
    """A corner on a line, in the line's own frame: along it and across, from its start.

    Attributes:
        a, b: places of the corner's coordinates.
        first: place of the line's offset at its start; that at its end follows.
        slant: as read.
    """

    a: int
    b: int
    first: int
    slant: Slant

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """See :class:`.linear_constraints.Relation`."""
        (dx, dy), length = direction_of(self.slant)
        x, y = numbers[self.a] - self.slant.start[0], numbers[self.b] - self.slant.start[1]
        share = (x * dx + y * dy) / length
        low, high = numbers[self.first], numbers[self.first + 1]
        tilt = (high - low) / length
        value = -x * dy + y * dx - low - (high - low) * share
        return value, [
            (self.a, -dy - tilt * dx),
            (self.b, dx - tilt * dy),
            (self.first, share - 1.0),
            (self.first + 1, -share),
        ]


@dataclass(frozen=True)
class OnCircle:
    """A corner on a circle; the circle's numbers are centre and radius from a place on."""

    a: int
    b: int
    circle: int

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """See :class:`.linear_constraints.Relation`."""
        x, y = numbers[self.a] - numbers[self.circle], numbers[self.b] - numbers[self.circle + 1]
        away = hypot(x, y) or 1.0
        return away - numbers[self.circle + 2], [
            (self.a, x / away),
            (self.b, y / away),
            (self.circle, -x / away),
            (self.circle + 1, -y / away),
            (self.circle + 2, -1.0),
        ]


@dataclass(frozen=True)
class Touches:
    """A line that touches a circle; ``side`` is that of the centre, +1 left of the line."""

    circle: int
    first: int
    slant: Slant
    side: float

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """See :class:`.linear_constraints.Relation`."""
        value, terms = OnSlant(self.circle, self.circle + 1, self.first, self.slant).at(numbers)
        _, length = direction_of(self.slant)
        tilt = (numbers[self.first + 1] - numbers[self.first]) / length
        stretch = sqrt(1.0 + tilt * tilt)
        radius = numbers[self.circle + 2]
        turn = self.side * radius * tilt / (stretch * length)
        return value - self.side * radius * stretch, [
            *terms,
            (self.circle + 2, -self.side * stretch),
            (self.first, turn),
            (self.first + 1, -turn),
        ]


@dataclass(frozen=True)
class TouchesCircle:
    """Two circles that touch; ``inside`` if the other one lies in the one."""

    one: int
    other: int
    inside: bool

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """See :class:`.linear_constraints.Relation`."""
        x = numbers[self.other] - numbers[self.one]
        y = numbers[self.other + 1] - numbers[self.one + 1]
        away = hypot(x, y) or 1.0
        side = -1.0 if self.inside else 1.0
        return away - numbers[self.one + 2] - side * numbers[self.other + 2], [
            (self.other, x / away),
            (self.other + 1, y / away),
            (self.one, -x / away),
            (self.one + 1, -y / away),
            (self.one + 2, -1.0),
            (self.other + 2, -side),
        ]


@dataclass(frozen=True)
class OnFacet:
    """A corner on a plane, which three numbers turn and shift from where it was read.

    Attributes:
        at_axes: places of the corner's coordinates.
        first: place of the plane's two tilts; its shift follows.
        frame: (3, 3) rows: two directions in the plane, and its normal.
        origin: (3,) a point of it.
    """

    at_axes: tuple[int, int, int]
    first: int
    frame: npt.NDArray[np.float64]
    origin: npt.NDArray[np.float64]

    def at(self, numbers: Numbers) -> tuple[float, Terms]:
        """See :class:`.linear_constraints.Relation`."""
        corner = np.array([numbers[at] for at in self.at_axes])
        along, across, out = self.frame @ (corner - self.origin)
        one, other, shift = numbers[self.first : self.first + 3]
        normal = self.frame[2] + one * self.frame[0] + other * self.frame[1]
        return float(out + one * along + other * across - shift), [
            *zip(self.at_axes, normal.tolist(), strict=True),
            (self.first, float(along)),
            (self.first + 1, float(across)),
            (self.first + 2, -1.0),
        ]


def direction_of(slant: Slant) -> tuple[Point, float]:
    """Unit vector from start to end, and the distance."""
    dx, dy = slant.end[0] - slant.start[0], slant.end[1] - slant.start[1]
    length = hypot(dx, dy)
    return (dx / length, dy / length), length


def crossings(slants: Sequence[Slant]) -> Iterator[Point]:
    """Where slants cross within both of them: a tip, if other views have its coordinates."""
    lines = [(line_through(slant.start, slant.end), slant) for slant in slants]
    for (one, first), (other, second) in combinations(lines, 2):
        for point in meetings(one, other):
            if _is_within(one, first, point) and _is_within(other, second, point):
                yield point


def _is_within(line: Line, slant: Slant, point: Point) -> bool:
    low, high = sorted((line.parameter(slant.start), line.parameter(slant.end)))
    return low < line.parameter(point) < high
