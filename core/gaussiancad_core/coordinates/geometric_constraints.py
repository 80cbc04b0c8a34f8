"""Corners that lie on lines and circles: what was read nearly so becomes exactly so.

Where a plane cuts a slanted face or a cylinder, the edge between them shows in the other views at
coordinates that follow from the rest.  Each view is read with errors of its own; unless lines,
circles and the corners on them are adjusted together, slivers of space stay between what is one
surface.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.coordinates.circle_constraints import circle_relations
from gaussiancad_core.coordinates.coordinate_clustering import CERTAIN, Snapped
from gaussiancad_core.coordinates.corner_equations import (
    OnCircle,
    OnFacet,
    OnSlant,
    Slant,
    Touches,
    TouchesCircle,
    direction_of,
)
from gaussiancad_core.coordinates.linear_constraints import Linear, Numbers, Relation, solved
from gaussiancad_core.coordinates.tangents import touched_circles, touching_circles
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import COMPUTED, MEETING, MOVED, WELL_READ
from gaussiancad_core.geometry.whole_curves import Circle, Line, line_through
from gaussiancad_core.model.axes import Axis, Vector
from gaussiancad_core.model.projection_planes import IN_PLANE

_ON_LOOSELY = 2.0
"""The same where a value is told by ends of strokes only, or the corner is the line's own end."""

_LOOSE = 0.1
"""Weight below which a value is told by ends of strokes only."""

_FAR = 1.0
"""Tolerances by which well-read numbers move at most."""

_UNROUNDED = 4
"""Times that numbers are looked for which are no multiples of the step."""

_ROUNDED = 0.1 * CERTAIN
"""Weight from which a number was made a multiple of the step."""

_FREE = 1e-3
"""Weight of numbers that nothing tells."""

_EXTREME = 0.02
"""Component of a circle's normal below which a corner is the circle's extreme."""


@dataclass(frozen=True)
class PlaneReading:
    """What the views of a plane show.

    Attributes:
        normal: of the plane.
        slants: its slanted lines.
        ends: of all its strokes.
        arcs: circle, first angle and sweep in radians of those that are no lines; a circle none of
            whose arcs is told counts all around.
    """

    normal: Axis
    slants: tuple[Slant, ...]
    ends: tuple[Point, ...]
    arcs: tuple[tuple[Circle, float, float], ...] = ()

    def moved(self, a: float, b: float) -> "PlaneReading":
        """The same, so many units farther along both coordinates."""

        def at(point: Point) -> Point:
            return point[0] + a, point[1] + b

        return replace(
            self,
            slants=tuple(
                Slant(at(slant.start), at(slant.end), slant.weight) for slant in self.slants
            ),
            ends=tuple(at(end) for end in self.ends),
            arcs=tuple(
                (Circle(at(circle.centre), circle.radius), low, sweep)
                for circle, low, sweep in self.arcs
            ),
        )


@dataclass(frozen=True)
class Facet:
    """A face that is edge-on in no view, as its corners were read.

    Attributes:
        normal: (3,) unit normal.
        corners: (3,) points near its plane.
    """

    normal: Vector
    corners: tuple[Vector, ...]


@dataclass(frozen=True)
class Adjusted:
    """Values, circles and lines with all their incidences.

    Attributes:
        snap: values and circles.
        lines: of the slants of each plane, in their order.
    """

    snap: Snapped
    lines: dict[Axis, tuple[Line, ...]]


def adjusted(
    snap: Snapped,
    planes: Sequence[PlaneReading],
    tolerance: float,
    facets: Sequence[Facet] = (),
) -> Adjusted:
    """Make corners lie on the lines, circles and faces that they were read on.

    Args:
        snap: values and circles.
        planes: what the views show.
        tolerance: units by which a reading may be off.
        facets: faces that are edge-on in no view.
    """
    network = _Network(snap, planes, tolerance)
    relations = [relation for plane in planes for relation in network.relations(plane)]
    relations += [relation for facet in facets for relation in network.on_facet(facet)]
    known = network.known()
    weights = list(network.weights)
    numbers = solved(network.observed, weights, [*known, *relations], network.far)
    for _ in range(_UNROUNDED):
        wrong = network.wrongly_rounded(numbers, weights, relations)
        if not wrong:
            break
        for at in wrong:
            weights[at] /= CERTAIN
        numbers = solved(network.observed, weights, [*known, *relations], network.far)
    return network.result(numbers)


def _side(slant: Slant, point: Point) -> float:
    """+1 where a point lies to the left of a line's way, else -1."""
    (dx, dy), _ = direction_of(slant)
    x, y = point[0] - slant.start[0], point[1] - slant.start[1]
    return 1.0 if y * dx - x * dy > 0.0 else -1.0


class _Network:
    """The numbers of a part, and the equations between them."""

    def __init__(self, snap: Snapped, planes: Sequence[PlaneReading], tolerance: float) -> None:
        self._snap, self._planes, self._tolerance = snap, planes, tolerance
        self.observed: list[float] = []
        self.weights: list[float] = []
        self.far: list[float] = []
        self._rounded: set[int] = set()
        self._values = {axis: self._add_values(axis) for axis in Axis}
        self._circles = [
            self._add([*circle.centre, circle.radius], [weight] * 3, _FAR)
            for (_, circle), weight in zip(snap.circles, snap.circle_weights, strict=True)
        ]
        self._slants = {
            plane.normal: [
                self._add([0.0, 0.0], [slant.weight / 4.0] * 2, MOVED) for slant in plane.slants
            ]
            for plane in planes
        }

    def _add(self, numbers: list[float], weights: list[float], far: float) -> int:
        first = len(self.observed)
        self._rounded.update(first + k for k, w in enumerate(weights) if w > _ROUNDED)
        self.observed += numbers
        self.weights += [max(weight, 1e-6) for weight in weights]
        self.far += [far * self._tolerance] * len(numbers)
        return first

    def _add_values(self, axis: Axis) -> dict[float, int]:
        values = self._snap.values[axis]
        found = {}
        for value in values:
            weight = self._snap.weights[axis, value]
            # The views were lined up by their extents.
            factor = CERTAIN if value in (values[0], values[-1]) else 1.0
            far = MOVED if weight < _LOOSE else _FAR
            found[value] = self._add([value], [weight], far)
            self.weights[-1] *= factor
        return found

    def known(self) -> list[Linear]:
        """The equations between values and circles that hold already."""
        circles = [
            (normal, at, at + 1, at + 2)
            for (normal, _), at in zip(self._snap.circles, self._circles, strict=True)
        ]
        places = {axis: list(value.values()) for axis, value in self._values.items()}
        return circle_relations(self.observed, places, circles, COMPUTED)

    def relations(self, plane: PlaneReading) -> Iterator[Relation]:
        """Corners on the plane's curves, and lines and circles that touch its circles."""
        corners = self._corners(plane.normal, plane.ends)
        circles = {
            circle: at
            for (normal, circle), at in zip(self._snap.circles, self._circles, strict=True)
            if normal is plane.normal
        }
        for slant, first in zip(plane.slants, self._slants[plane.normal], strict=True):
            line = line_through(slant.start, slant.end)
            ends = slant.start, slant.end
            for circle in touched_circles(line, ends, list(circles), self._snap.reach):
                if circle is not None:
                    yield Touches(circles[circle], first, slant, _side(slant, circle.centre))
            low, high = sorted((line.parameter(slant.start), line.parameter(slant.end)))
            room = MEETING * self._tolerance
            this_corners = self._corners(plane.normal, ends)
            for corner in {**corners, **this_corners}.values():
                along = line.parameter(corner.point)
                within = low - room <= along <= high + room
                loose = corner.loose or (corner.a, corner.b) in this_corners
                if within and self._is_on(corner, line, loose=loose):
                    yield OnSlant(corner.a, corner.b, first, slant)
        for one, other, inside in touching_circles(list(circles), plane.ends, self._snap.reach):
            yield TouchesCircle(circles[one], circles[other], inside)
        drawn = self._drawn_arcs(plane)
        for circle, at in circles.items():
            arcs = drawn.get(circle, [])
            for corner in corners.values():
                is_on = self._is_on(corner, circle, loose=corner.loose)
                if (
                    is_on
                    and not _is_extreme(circle, corner.point)
                    and self._is_drawn(arcs, circle, corner.point)
                ):
                    yield OnCircle(corner.a, corner.b, at)

    def _drawn_arcs(self, plane: PlaneReading) -> dict[Circle, list[tuple[float, float]]]:
        """First angles and sweeps of the arcs of each of a plane's circles."""
        found: dict[Circle, list[tuple[float, float]]] = {}
        for read, low, sweep in plane.arcs:
            circle = self._snap.circle(plane.normal, read)
            if circle is not None:
                found.setdefault(circle, []).append((low, sweep))
        return found

    def _is_drawn(self, arcs: Sequence[tuple[float, float]], circle: Circle, point: Point) -> bool:
        """Whether a circle, of which these arcs are told, is drawn right beside a point of it."""
        room = MEETING * self._tolerance / circle.radius
        at = circle.parameter(point)
        return not arcs or any(
            (at - low + room) % FULL_TURN <= sweep + 2.0 * room for low, sweep in arcs
        )

    def on_facet(self, facet: Facet) -> Iterator[Relation]:
        """Its corners on one plane, as far as their coordinates are values."""
        known = {}
        for corner in facet.corners:
            snapped = [self._snap.value(axis, x) for axis, x in zip(Axis, corner, strict=True)]
            values = [value for value in snapped if value is not None]
            if len(values) == len(snapped):
                x, y, z = (self._values[axis][x] for axis, x in zip(Axis, values, strict=True))
                known[x, y, z] = np.array(values)
        if len(known) <= 3:
            return
        normal = np.array(facet.normal)
        along = np.cross(normal, np.eye(3)[int(np.abs(normal).argmin())])
        along /= np.linalg.norm(along)
        frame = np.array([along, np.cross(normal, along), normal])
        first = self._add([0.0, 0.0, 0.0], [_FREE] * 3, MOVED)
        origin = np.mean(list(known.values()), axis=0)
        for places in known:
            yield OnFacet(places, first, frame, origin)

    def _is_on(self, corner: "_Corner", curve: Line | Circle, *, loose: bool) -> bool:
        off = curve.distance(corner.point)
        return off <= (_ON_LOOSELY if loose else WELL_READ) * self._tolerance

    def _corners(self, normal: Axis, ends: Sequence[Point]) -> dict[tuple[int, int], "_Corner"]:
        """Distinct pairs of values at which strokes of a plane end."""
        axes = [Axis(index) for index in IN_PLANE[normal]]
        found: dict[tuple[int, int], _Corner] = {}
        for end in ends:
            snapped = [self._snap.value(axis, x) for axis, x in zip(axes, end, strict=True)]
            values = [value for value in snapped if value is not None]
            if len(values) < len(snapped):
                continue
            weight = min(self._snap.weights[key] for key in zip(axes, values, strict=True))
            a, b = (self._values[axis][x] for axis, x in zip(axes, values, strict=True))
            found[a, b] = _Corner(a, b, (values[0], values[1]), weight < _LOOSE)
        return found

    def wrongly_rounded(
        self, numbers: Numbers, weights: Sequence[float], relations: Sequence[Relation]
    ) -> set[int]:
        """Places of numbers that follow from others, and are near multiples of the step by chance.

        Multiples of the step stay where they are.  Where an equation moves them, the one that the
        least ink tells was none.
        """
        moved = np.abs(numbers - np.array(self.observed)) > COMPUTED
        found = set()
        for relation in relations:
            places = {at for at, _ in relation.at(numbers)[1] if moved[at]} & self._rounded
            held = [at for at in places if weights[at] > _ROUNDED]
            if held:
                found.add(min(held, key=lambda at: (weights[at], at)))
        return found

    def result(self, numbers: Numbers) -> Adjusted:
        """What the numbers stand for."""
        values = {
            axis: tuple(sorted({float(numbers[at]) for at in this_value.values()}))
            for axis, this_value in self._values.items()
        }
        weights: dict[tuple[Axis, float], float] = {}
        for axis, entry in self._values.items():
            for value, at in entry.items():
                key = axis, float(numbers[at])
                weights[key] = weights.get(key, 0.0) + self._snap.weights[axis, value]
        circles = tuple(
            (
                normal,
                Circle((float(numbers[at]), float(numbers[at + 1])), float(numbers[at + 2])),
            )
            for (normal, _), at in zip(self._snap.circles, self._circles, strict=True)
        )
        lines = {
            plane.normal: tuple(
                _moved(slant, float(numbers[at]), float(numbers[at + 1]))
                for slant, at in zip(plane.slants, self._slants[plane.normal], strict=True)
            )
            for plane in self._planes
        }
        snap = replace(self._snap, values=values, weights=weights, circles=circles)
        return Adjusted(snap, lines)


@dataclass(frozen=True)
class _Corner:
    """A pair of values; ``loose`` if only ends of strokes tell one of them."""

    a: int
    b: int
    point: Point
    loose: bool


def _is_extreme(circle: Circle, point: Point) -> bool:
    """Whether a circle runs along an axis at a point: then one coordinate tells nothing of it."""
    return min(abs(component) for component in circle.normal(circle.parameter(point))) < _EXTREME


def _moved(slant: Slant, low: float, high: float) -> Line:
    """The line with offsets at its ends, to the left of its way."""
    (dx, dy), _ = direction_of(slant)
    start = slant.start[0] - dy * low, slant.start[1] + dx * low
    end = slant.end[0] - dy * high, slant.end[1] + dx * high
    return line_through(start, end)
