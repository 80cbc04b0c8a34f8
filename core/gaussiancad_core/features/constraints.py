"""Geometric constraints of a sketch: what fixes it fully, and no more.

Constraints are offered in the order in which a person would want them: ends that meet, level and
upright lines, what is concentric, equal or aligned, then dimensions, those of the drawing first.
One is taken if its equations are independent of those that were taken before, by the rank of their
Jacobian; all degrees of freedom are gone at the end, and nothing is fixed twice.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import combinations, pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.sketch_geometry import ORIGIN, Geometry, Reference, Spot
from gaussiancad_core.features.thread_notes import ThreadNote
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.tolerances import COMPUTED

Vector = npt.NDArray[np.float64]


class Kind(Enum):
    """What a constraint demands; the values stand in files."""

    COINCIDENT = "coincident"
    TANGENT = "tangent"
    HORIZONTAL = "horizontal"
    VERTICAL = "vertical"
    EQUAL = "equal"
    DISTANCE_X = "distance-x"
    DISTANCE_Y = "distance-y"
    RADIUS = "radius"
    DIAMETER = "diameter"


class NumberSource(Enum):
    """Where a number is from."""

    SHEET = "sheet"
    MEASURED = "measured"


@dataclass(frozen=True)
class Constraint:
    """A demand on a sketch's geometry.

    Attributes:
        kind: what is demanded.
        of: elements, or points of them.
        value: mm, of a dimension; None of others.
        source: of the value.
    """

    kind: Kind
    of: tuple[Reference, ...]
    value: float | None = None
    source: NumberSource | None = None


@dataclass(frozen=True)
class Numbers:
    """Numbers of a drawing.

    Attributes:
        values: mm.
        near: mm within which a measure is a number.
        threads: that notes tell of holes.
    """

    values: tuple[float, ...] = ()
    near: float = 1e-3
    threads: tuple[ThreadNote, ...] = ()

    def source_of(self, measure: float) -> NumberSource:
        """Whether a measure stands on the drawing."""
        if any(abs(abs(measure) - value) <= self.near for value in self.values):
            return NumberSource.SHEET
        return NumberSource.MEASURED


def constraints_of(loops: Sequence[Loop], numbers: Numbers) -> tuple[Constraint, ...]:
    """Constraints that fix outlines fully.

    Args:
        loops: outlines, mm; the edges of all of them in order are the sketch's elements.
        numbers: of the drawing.
    """
    geometry = Geometry(tuple(edge for loop in loops for edge in loop))
    taken: list[Constraint] = []
    basis = _Basis(geometry.size)
    for offered in _offers(geometry, loops, numbers):
        if basis.free == 0:
            break
        if basis.takes(_gradients(offered, geometry)):
            taken.append(offered)
    return tuple(taken)


class _Basis:
    """Independent directions among the variables of a sketch.

    Args:
        size: how many variables there are.
    """

    def __init__(self, size: int) -> None:
        self._rows: Vector = np.zeros((0, size))
        self._size = size

    @property
    def free(self) -> int:
        """Degrees of freedom that are left."""
        return self._size - len(self._rows)

    def takes(self, gradients: Vector) -> bool:
        """Add the equations of a constraint, if each is independent of all others."""
        rows = self._rows
        for gradient in gradients:
            left = gradient / max(float(np.linalg.norm(gradient)), 1e-12)
            # Twice, as rounding leaves a rest of what is projected away.
            for _ in range(2):
                left = left - rows.T @ (rows @ left)
            length = float(np.linalg.norm(left))
            if length < COMPUTED:
                return False
            rows = np.vstack([rows, left / length])
        self._rows = rows
        return True


def _offers(geometry: Geometry, loops: Sequence[Loop], numbers: Numbers) -> Iterator[Constraint]:
    yield from _joints(geometry, loops)
    yield from _directions(geometry)
    yield from _round_ties(geometry)
    yield from _alignments(geometry)
    yield from _radii(geometry, numbers)
    yield from _sheet_distances(geometry, numbers)
    yield from _distances_from_origin(geometry, numbers)


def _joints(geometry: Geometry, loops: Sequence[Loop]) -> Iterator[Constraint]:
    """Ends that meet; smoothly where the edges go on in each other."""
    first = 0
    for loop in loops:
        count = len(loop)
        for k in range(count if count > 1 else 0):
            one, other = first + k, first + (k + 1) % count
            ends = Reference(one, Spot.END), Reference(other, Spot.START)
            is_arc = geometry.is_arc(one) or geometry.is_arc(other)
            if is_arc and abs(_turn(loop[k], loop[(k + 1) % count])) < COMPUTED:
                yield Constraint(Kind.TANGENT, ends)
            yield Constraint(Kind.COINCIDENT, ends)
        first += count


def _turn(one: OutlineEdge, other: OutlineEdge) -> float:
    """Sine of the angle between two edges where they meet; 2 where they turn back."""
    (ax, ay), (bx, by) = one.heading(at_start=False), other.heading(at_start=True)
    return ax * by - ay * bx if ax * bx + ay * by > 0.0 else 2.0


def _directions(geometry: Geometry) -> Iterator[Constraint]:
    for k, edge in enumerate(geometry.edges):
        if edge.circle is not None:
            continue
        if abs(edge.start[1] - edge.end[1]) < COMPUTED:
            yield Constraint(Kind.HORIZONTAL, (Reference(k),))
        elif abs(edge.start[0] - edge.end[0]) < COMPUTED:
            yield Constraint(Kind.VERTICAL, (Reference(k),))


def _round_ties(geometry: Geometry) -> Iterator[Constraint]:
    """What has the same centre, and what has the same radius."""
    rounds = [(k, edge.circle) for k, edge in enumerate(geometry.edges) if edge.circle is not None]
    for (one, a), (other, b) in combinations(rounds, 2):
        if max(abs(a.centre[0] - b.centre[0]), abs(a.centre[1] - b.centre[1])) < COMPUTED:
            centres = Reference(one, Spot.CENTRE), Reference(other, Spot.CENTRE)
            yield Constraint(Kind.COINCIDENT, centres)
        if abs(a.radius - b.radius) < COMPUTED:
            yield Constraint(Kind.EQUAL, (Reference(one), Reference(other)))


def _alignments(geometry: Geometry) -> Iterator[Constraint]:
    for axis, kind in ((0, Kind.VERTICAL), (1, Kind.HORIZONTAL)):
        for _, group in geometry.columns(axis):
            for one, other in pairwise(group):
                yield Constraint(kind, (one, other))


def _radii(geometry: Geometry, numbers: Numbers) -> Iterator[Constraint]:
    for k, edge in enumerate(geometry.edges):
        if edge.circle is None:
            continue
        radius = edge.circle.radius
        across = 2.0 * radius
        by_radius = numbers.source_of(radius)
        if edge.is_circle or numbers.source_of(across) is NumberSource.SHEET is not by_radius:
            source = numbers.source_of(across)
            yield Constraint(Kind.DIAMETER, (Reference(k),), across, source)
        else:
            yield Constraint(Kind.RADIUS, (Reference(k),), radius, by_radius)


def _sheet_distances(geometry: Geometry, numbers: Numbers) -> Iterator[Constraint]:
    """Distances that stand on the drawing; those from the origin first."""
    for axis, kind in ((0, Kind.DISTANCE_X), (1, Kind.DISTANCE_Y)):
        columns = geometry.columns(axis)
        pairs = sorted(
            combinations(columns, 2), key=lambda pair: ORIGIN not in pair[0][1] + pair[1][1]
        )
        for (low, one), (high, other) in pairs:
            if numbers.source_of(high - low) is NumberSource.SHEET:
                of = one[0], other[0]
                yield Constraint(kind, of, high - low, NumberSource.SHEET)


def _distances_from_origin(geometry: Geometry, numbers: Numbers) -> Iterator[Constraint]:
    for axis, kind in ((0, Kind.DISTANCE_X), (1, Kind.DISTANCE_Y)):
        for value, group in geometry.columns(axis):
            if abs(value) > COMPUTED:
                ends = (ORIGIN, group[0]) if value > 0.0 else (group[0], ORIGIN)
                yield Constraint(kind, ends, abs(value), numbers.source_of(value))


def _gradients(constraint: Constraint, geometry: Geometry) -> Vector:
    """(equations, variables) of a constraint."""
    make: dict[Kind, Callable[[Geometry, tuple[Reference, ...]], list[Vector]]] = {
        Kind.COINCIDENT: _coincidence,
        Kind.TANGENT: _tangency,
        Kind.HORIZONTAL: lambda g, of: [_between(g, of, 1)],
        Kind.DISTANCE_Y: lambda g, of: [_between(g, of, 1)],
        Kind.VERTICAL: lambda g, of: [_between(g, of, 0)],
        Kind.DISTANCE_X: lambda g, of: [_between(g, of, 0)],
        Kind.EQUAL: lambda g, of: [g.radius(of[0].element) - g.radius(of[1].element)],
        Kind.RADIUS: lambda g, of: [g.radius(of[0].element)],
        Kind.DIAMETER: lambda g, of: [g.radius(of[0].element)],
    }
    return np.array(make[constraint.kind](geometry, constraint.of))


def _between(geometry: Geometry, of: tuple[Reference, ...], axis: int) -> Vector:
    """Gradient of the distance along an axis between two points, or the ends of a line."""
    if len(of) == 1:
        of = Reference(of[0].element, Spot.START), Reference(of[0].element, Spot.END)
    return geometry.point(of[1])[axis] - geometry.point(of[0])[axis]


def _coincidence(geometry: Geometry, of: tuple[Reference, ...]) -> list[Vector]:
    return list(geometry.point(of[1]) - geometry.point(of[0]))


def _tangency(geometry: Geometry, of: tuple[Reference, ...]) -> list[Vector]:
    turn = geometry.direction(of[1]) - geometry.direction(of[0])
    return [*_coincidence(geometry, of), turn]
