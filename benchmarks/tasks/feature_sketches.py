"""The sketch of a feature, solved again after one of its dimensions was changed."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import atan2, cos, pi, remainder, sin, tau

import numpy as np
import numpy.typing as npt

from gaussiancad_core.features.constraints import Constraint, Kind
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.sketch_geometry import ORIGIN, Reference, Spot
from gaussiancad_core.geometry.outline_edges import OutlineEdge, whole_circle
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle

Vector = npt.NDArray[np.float64]

_STEP = 1e-6
"""mm or radians by which variables are moved for the slope of an equation."""

_SOLVED = 1e-8
"""mm or radians up to which an equation holds."""

_ROUNDS = 30
"""Steps of Newton's method."""

_RANK = 1e-7
"""Share of the largest singular value below which one is none."""


class UnsolvedError(Exception):
    """No sketch near the one before has the dimensions."""


@dataclass(frozen=True)
class Freedom:
    """How well constraints fix a sketch.

    Attributes:
        left: degrees of freedom.
        redundant: equations that say what others say.
    """

    left: int
    redundant: int


def freedom(loops: Sequence[Loop], constraints: Sequence[Constraint]) -> Freedom:
    """What constraints leave free, by the slopes of their equations."""
    variables = _Variables(tuple(edge for loop in loops for edge in loop))
    slopes = variables.slopes(constraints, variables.start)
    size = len(variables.start)
    if not len(slopes):
        return Freedom(size, 0)
    slopes = slopes / np.maximum(np.linalg.norm(slopes, axis=1, keepdims=True), 1e-12)
    values = np.linalg.svd(slopes, compute_uv=False)
    rank = int((values > _RANK * values[0]).sum())
    return Freedom(size - rank, len(slopes) - rank)


def solved(loops: Sequence[Loop], constraints: Sequence[Constraint]) -> tuple[Loop, ...]:
    """Outlines near others for which constraints hold.

    Raises:
        UnsolvedError: there are none.
    """
    variables = _Variables(tuple(edge for loop in loops for edge in loop))
    values = variables.start
    for _ in range(_ROUNDS):
        residuals = variables.residuals(constraints, values)
        if float(np.abs(residuals).max(initial=0.0)) < _SOLVED:
            return _loops(loops, variables.edges(values))
        slopes = variables.slopes(constraints, values)
        values = values - np.linalg.lstsq(slopes, residuals, rcond=None)[0]
        if not np.isfinite(values).all():
            break
    raise UnsolvedError


def _loops(loops: Sequence[Loop], edges: Sequence[OutlineEdge]) -> tuple[Loop, ...]:
    left = list(edges)
    found = []
    for loop in loops:
        run, left = left[: len(loop)], left[len(loop) :]
        # Each ends where the next one starts, to the last digit.
        ends = [*(edge.start for edge in run[1:]), run[0].start]
        joined = (replace(e, end=end) for e, end in zip(run, ends, strict=True))
        found.append(tuple(joined))
    return tuple(found)


class _Variables:
    """The variables of elements: ends of lines; centre and radius of circles; two angles of arcs,
    too.

    Args:
        edges: the elements, mm.

    Attributes:
        start: (n,) their values; mm and radians.
    """

    def __init__(self, edges: tuple[OutlineEdge, ...]) -> None:
        self._elements = edges
        self._first: list[int] = []
        values: list[float] = []
        for edge in edges:
            self._first.append(len(values))
            values += _values(edge)
        self._first.append(len(values))
        self.start: Vector = np.array(values)

    def edges(self, values: Vector) -> list[OutlineEdge]:
        """The elements at other values."""
        found = []
        for number, edge in enumerate(self._elements):
            if edge.circle is None:
                start, end = (self._point(Reference(number, s), values) for s in _ENDS)
                found.append(OutlineEdge(start, end))
                continue
            first = self._first[number]
            x, y, radius = (float(value) for value in values[first : first + 3])
            circle = Circle((x, y), radius)
            if edge.is_circle:
                found.append(whole_circle(circle, edge.is_ccw))
                continue
            start, end = (self._point(Reference(number, s), values) for s in _ENDS)
            found.append(OutlineEdge(start, end, circle, edge.is_ccw))
        return found

    def residuals(self, constraints: Sequence[Constraint], values: Vector) -> Vector:
        """(equations,) by how much each equation misses; mm or radians."""
        return np.array([miss for each in constraints for miss in self._misses(each, values)])

    def slopes(self, constraints: Sequence[Constraint], values: Vector) -> Vector:
        """(equations, variables) derivatives of the equations."""
        rows: list[Vector] = []
        for each in constraints:
            numbers = sorted(
                k
                for element in {reference.element for reference in each.of} - {ORIGIN.element}
                for k in range(self._first[element], self._first[element + 1])
            )
            columns = []
            for k in numbers:
                ends = []
                for way in (1.0, -1.0):
                    moved = values.copy()
                    moved[k] += way * _STEP
                    ends.append(np.array(self._misses(each, moved)))
                columns.append((ends[0] - ends[1]) / (2.0 * _STEP))
            block = np.zeros((len(self._misses(each, values)), len(values)))
            block[:, numbers] = np.array(columns).T
            rows.extend(block)
        return np.array(rows).reshape(-1, len(values))

    def _misses(self, constraint: Constraint, values: Vector) -> list[float]:
        kind, of = constraint.kind, constraint.of
        if kind is Kind.EQUAL:
            return [self._radius(of[0], values) - self._radius(of[1], values)]
        if kind in (Kind.RADIUS, Kind.DIAMETER):
            factor = 2.0 if kind is Kind.DIAMETER else 1.0
            return [factor * self._radius(of[0], values) - (constraint.value or 0.0)]
        ends = of if len(of) == 2 else [Reference(of[0].element, spot) for spot in _ENDS]
        (ax, ay), (bx, by) = (self._point(reference, values) for reference in ends)
        if kind is Kind.COINCIDENT:
            return [bx - ax, by - ay]
        if kind is Kind.TANGENT:
            turn = self._heading(of[1], values) - self._heading(of[0], values)
            return [bx - ax, by - ay, remainder(turn, tau)]
        apart = by - ay if kind in (Kind.HORIZONTAL, Kind.DISTANCE_Y) else bx - ax
        return [apart - (constraint.value or 0.0)]

    def _radius(self, reference: Reference, values: Vector) -> float:
        return float(values[self._first[reference.element] + 2])

    def _point(self, reference: Reference, values: Vector) -> Point:
        if reference == ORIGIN:
            return 0.0, 0.0
        first = self._first[reference.element]
        if self._elements[reference.element].circle is None:
            at = first + (0 if reference.spot is Spot.START else 2)
            return float(values[at]), float(values[at + 1])
        x, y, radius = (float(value) for value in values[first : first + 3])
        if reference.spot is Spot.CENTRE:
            return x, y
        angle = float(values[first + (3 if reference.spot is Spot.START else 4)])
        return x + radius * cos(angle), y + radius * sin(angle)

    def _heading(self, reference: Reference, values: Vector) -> float:
        """Radians of the direction in which an element runs at an end."""
        edge, first = self._elements[reference.element], self._first[reference.element]
        if edge.circle is None:
            (ax, ay), (bx, by) = (
                self._point(Reference(reference.element, spot), values) for spot in _ENDS
            )
            return atan2(by - ay, bx - ax)
        angle = float(values[first + (3 if reference.spot is Spot.START else 4)])
        return angle + (pi / 2.0 if edge.is_ccw else -pi / 2.0)


_ENDS = Spot.START, Spot.END


def _values(edge: OutlineEdge) -> list[float]:
    if edge.circle is None:
        return [*edge.start, *edge.end]
    found = [*edge.circle.centre, edge.circle.radius]
    if edge.is_circle:
        return found
    return [*found, edge.circle.parameter(edge.start), edge.circle.parameter(edge.end)]
