"""The cell complex, and the cells that a ray crosses.

A cell is the space whose points fall into one region of each projection plane, and which lies on
one side of each extra body.  A line of sight along an axis crosses the surfaces of the carriers of
the two other planes, and those of the bodies; between crossings it is in one cell.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple, Protocol

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement, distinct
from gaussiancad_core.cells.arrangement_kernels import CHAIN, ROUGH
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.geometry.whole_curves import LineOrCircle
from gaussiancad_core.model.axes import Axis, Vector
from gaussiancad_core.model.projection_planes import IN_PLANE

Cell = tuple[int, int, int, int]
"""Region of the X, Y and Z plane, and a bit for each extra body that it lies in; never outside.

The bit of a body is 0 in regions where the body does not count (see :meth:`Body.outlines`).
"""

Surface = tuple[int, int]
"""Which surface: (normal of the plane, carrier) or (BODY, body)."""

BODY = 3

PARALLEL = 1.0 - 2e-4
"""Cosine of the angle within which normals are parallel."""


class Body(Protocol):
    """A surface that is edge-on in no view: the border of a body."""

    def crossings(self, normal: Axis, a: float, b: float) -> list[tuple[float, Vector]]:
        """Depths and unit normals where the line through (a, b) along an axis meets it."""

    def holds(self, point: Vector) -> bool:
        """Whether a point lies in it."""

    def rims(self, normal: Axis) -> list[tuple[LineOrCircle, tuple[float, float]]]:
        """Curves, and stretches of them, along which a view may show the body."""

    def outlines(self, normal: Axis) -> tuple[tuple[Point, ...], ...] | None:
        """Convex polygons of a view outside of which the body does not count; None: it does."""


class Crossing(NamedTuple):
    """Where a column passes from one cell into another.

    Attributes:
        depth: along the axis.
        normal: (3,) unit normal of the surface.
        surface: that is crossed.
        before, after: the cells; None where void by itself.
    """

    depth: float
    normal: Vector
    surface: Surface
    before: Cell | None
    after: Cell | None


_Step = tuple[float, Vector, Surface, int]
"""(depth, normal, surface, the region of the surface's plane behind it; any for a body)."""


def side_views(normal: Axis) -> tuple[tuple[Axis, int], tuple[Axis, int]]:
    """For each coordinate of a plane the other plane that shows it, and its place there.

    Depth runs along that plane's other coordinate.
    """
    found = []
    for axis in IN_PLANE[normal]:
        other = next(Axis(i) for i in range(3) if i not in (axis, normal.value))
        found.append((other, IN_PLANE[other].index(axis)))
    return found[0], found[1]


_BESIDE = {normal: side_views(normal) for normal in Axis}


class SeenColumns(Protocol):
    """Columns along one axis that were looked at."""

    @property
    def normal(self) -> Axis:
        """The axis."""

    def longest(self) -> Iterator[tuple[Cell, float]]:
        """Cells, each with its longest stretch along the axis."""

    def crossed(self) -> Iterator[tuple[Cell | None, Cell | None, Surface]]:
        """Pairs of cells that follow each other, and the surfaces between them."""


class CellComplex:
    """The cells of a part.

    Args:
        planes: arrangement of each projection plane; planes without views hold the box only.
        bodies: extra ones.

    Attributes:
        planes, bodies: as given.
        values: of each axis where an arrangement has a corner, ascending.
        counting: of each plane the bits of the bodies that count in each of its regions.
    """

    def __init__(self, planes: Mapping[Axis, Arrangement], bodies: Sequence[Body] = ()) -> None:
        self.planes = dict(planes)
        self.bodies = tuple(bodies)
        self.values = {axis: self._values(axis) for axis in Axis}
        self.counting = tuple(self._counting_in(axis) for axis in Axis)
        self._columns: dict[tuple[Axis, float, float], tuple[Crossing, ...]] = {}
        self._seen: list[SeenColumns] = []
        self._steps: dict[tuple[Axis, int, float], tuple[int, tuple[_Step, ...], bool]] = {}

    def _values(self, axis: Axis) -> list[float]:
        found = []
        for normal, plane in self.planes.items():
            if normal is not axis:
                place = IN_PLANE[normal].index(axis.value)
                found += [corner[place] for corner in plane.corners]
        return distinct(found)

    def _counting_in(self, normal: Axis) -> list[int]:
        """The bits of the bodies that count in each region of a plane."""
        plane = self.planes[normal]
        always, found = 0, [0] * plane.regions
        points = list(plane.inner_points())
        for number, body in enumerate(self.bodies):
            outlines = body.outlines(normal)
            if outlines is None:
                always |= 1 << number
                continue
            for region, point in points:
                if any(_surrounds(outline, point) for outline in outlines):
                    found[region] |= 1 << number
        return [always | bits for bits in found]

    def _cell(self, regions: list[int], bits: int) -> Cell | None:
        x, y, z = regions
        if OUTSIDE in (x, y, z):
            return None
        if bits:
            by_x, by_y, by_z = self.counting
            bits &= by_x[x] & by_y[y] & by_z[z]
        return x, y, z, bits

    def cell_at(self, point: Vector) -> Cell | None:
        """The cell of a point, or None outside."""
        regions = []
        for normal in Axis:
            first, second = IN_PLANE[normal]
            regions.append(self.planes[normal].locate(point[first], point[second]))
        bits = sum(1 << i for i, body in enumerate(self.bodies) if body.holds(point))
        return self._cell(regions, bits)

    def look_at(self, seen: "SeenColumns") -> None:
        """Columns count as looked at."""
        self._seen.append(seen)

    def thickness(self) -> dict[Cell, float]:
        """Units of each cell in its thinnest direction, as far as columns have met it."""
        longest: dict[Cell, dict[Axis, float]] = {}
        for seen in self._seen:
            for cell, depth in seen.longest():
                entry = longest.setdefault(cell, {})
                entry[seen.normal] = max(entry.get(seen.normal, 0.0), depth)
        for (normal, _, _), column in self._columns.items():
            for one, other in pairwise(column):
                if one.after is not None:
                    entry = longest.setdefault(one.after, {})
                    entry[normal] = max(entry.get(normal, 0.0), other.depth - one.depth)
        return {cell: min(mapping.values()) for cell, mapping in longest.items()}

    def crossed(self) -> Iterator[tuple[Cell | None, Cell | None, Surface]]:
        """From which cells columns that were looked at pass into which, and through what."""
        for seen in self._seen:
            yield from seen.crossed()
        for column in self._columns.values():
            for crossing in column:
                yield crossing.before, crossing.after, crossing.surface

    def column(self, normal: Axis, a: float, b: float) -> tuple[Crossing, ...]:
        """The crossings of the line through (a, b) of a plane, in ascending depth."""
        key = normal, round(a, 7), round(b, 7)
        found = self._columns.get(key)
        if found is None:
            found = self._columns[key] = self._column(normal, a, b)
        return found

    def _column(self, normal: Axis, a: float, b: float) -> tuple[Crossing, ...]:
        locate = self.planes[normal].locate(a, b)
        if locate == OUTSIDE:
            return ()
        regions = [OUTSIDE, OUTSIDE, OUTSIDE]
        regions[normal.value] = locate
        steps: list[_Step] = []
        chained = False
        for (plane, place), coordinate in zip(_BESIDE[normal], (a, b), strict=True):
            first, own_steps, has_chain = self._plane_steps(plane, place, coordinate)
            regions[plane.value] = first
            steps += own_steps
            chained |= has_chain
        bits = 0
        counting = self.counting[normal.value][locate]
        for number, body in enumerate(self.bodies):
            if not counting >> number & 1:
                continue
            for depth, direction in body.crossings(normal, a, b):
                steps.append((depth, direction, (BODY, number), 0))
        steps = _within_chains(steps) if chained else sorted(steps, key=_depth)
        crossings: list[Crossing] = []
        before = self._cell(regions, bits)
        for depth, direction, surface, region in steps:
            if surface[0] == BODY:
                bits ^= 1 << surface[1]
            else:
                regions[surface[0]] = region
            after = self._cell(regions, bits)
            if surface[1] == CHAIN:
                before = after
                continue
            last = crossings[-1] if crossings else None
            if last and abs(last.depth - depth) < COMPUTED and parallel(last.normal, direction):
                crossings[-1] = Crossing(last.depth, last.normal, last.surface, last.before, after)
            else:
                crossings.append(Crossing(depth, direction, surface, before, after))
            before = after
        return tuple(c for c in crossings if c.before != c.after)

    def _plane_steps(
        self, plane: Axis, place: int, coordinate: float
    ) -> tuple[int, tuple[_Step, ...], bool]:
        """The region a column starts in in one of the planes beside it, its steps there, and
        whether one of them is a chain's."""
        key = plane, place, round(coordinate, 7)
        found = self._steps.get(key)
        if found is None:
            trace = self.planes[plane].trace(place, coordinate)
            axes = IN_PLANE[plane]
            steps = []
            for position, flat, carrier, region in zip(
                trace.positions, trace.normals, trace.carriers, trace.regions[1:], strict=True
            ):
                along = [0.0, 0.0, 0.0]
                along[axes[0]], along[axes[1]] = flat
                direction = along[0], along[1], along[2]
                steps.append((position, direction, (plane.value, carrier), region))
            found = trace.regions[0], tuple(_without_slivers(steps)), CHAIN in trace.carriers
            self._steps[key] = found
        return found


def _depth(step: _Step) -> float:
    return step[0]


def _without_slivers(steps: list[_Step]) -> list[_Step]:
    """Steps of a plane, without the outside between a chain and a carrier right beside it.

    Near the corner in which both end they are nearer to each other than a chain is known.
    """
    kept: list[_Step] = []
    for step in steps:
        last = kept[-1] if kept else None
        if (
            last is not None
            and last[3] == OUTSIDE
            and step[0] - last[0] < ROUGH
            and (last[2][1] == CHAIN) != (step[2][1] == CHAIN)
        ):
            carrier = step if last[2][1] == CHAIN else last
            kept[-1] = (*carrier[:3], step[3])
        else:
            kept.append(step)
    return kept


def _within_chains(steps: list[_Step]) -> list[_Step]:
    """Steps in ascending depth, those that lie a hair outside a chain moved inside.

    A chain on the outline is a curve in which two surfaces meet, known roughly.  Beside the curve a
    column meets both surfaces and the chain at nearly one depth: outside there would be none.
    """
    chains = [(step[0], step[3]) for step in steps if step[2][1] == CHAIN]
    moved = []
    for step in steps:
        depth = step[0]
        for at, region in chains if step[2][1] != CHAIN else ():
            if region != OUTSIDE and at - ROUGH < depth <= at:
                depth = at + COMPUTED
            elif region == OUTSIDE and at <= depth < at + ROUGH:
                depth = at - COMPUTED
        moved.append((depth, *step[1:]))
    return sorted(moved, key=_depth)


def parallel(one: Vector, other: Vector) -> bool:
    """Whether unit normals are parallel, whichever way they point."""
    return abs(one[0] * other[0] + one[1] * other[1] + one[2] * other[2]) > PARALLEL


def _surrounds(polygon: Sequence[Point], point: Point) -> bool:
    """Whether a point lies in a convex polygon, whichever way that runs around."""
    a, b = point
    sides = {
        (x1 - x0) * (b - y0) - (y1 - y0) * (a - x0) > 0.0
        for (x0, y0), (x1, y1) in zip(polygon, (*polygon[1:], polygon[0]), strict=True)
    }
    return len(sides) == 1
