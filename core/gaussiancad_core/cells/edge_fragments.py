"""Pieces of lines, drawn or blank, that say something about the cells beside them.

What a view shows can change only where a coordinate has a value of some corner, along carriers, and
along the curves in which the surfaces of the two other planes meet.  Each such line is cut into
pieces along which nothing changes, and one point stands for each piece.
"""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain, groupby, pairwise, product
from math import hypot

import numpy as np

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.cells.cell_complex import CellComplex
from gaussiancad_core.cells.grid_rows import Row, find_rows
from gaussiancad_core.coordinates.carriers import PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier
from gaussiancad_core.coordinates.point_chains import chain_distances
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import ASIDE, COMPUTED, ON_CURVE, SHORTEST
from gaussiancad_core.geometry.whole_curves import LineOrCircle, axis_line, meetings
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Linetype

SHARE = 0.43819
"""Where in a piece its point lies: at middles symmetric parts have coincidences."""

_LOOSE_ENDS = {Linetype.VISIBLE: 1.5, Linetype.HIDDEN: 4.0}
"""Tolerances by which a stroke may end early or late: a hidden one by a gap of its dashes."""

_DASH = 10.0
"""Tolerances of an outline's length up to which it is taken for a dash of the hidden line that goes
on from it."""

_RIM = 0.01
"""Units within which the rim of a body is a carrier's curve."""

_ON = 2e-3
"""Units within which a curve is a carrier for certain."""

_SAMPLES = 5
"""Points of a curve that is not drawn at which its region is looked up."""

_ALONG = 0.999
"""Cosine of the angle within which curves run along each other and do not cross."""

_STEADY = 1e-3
"""Slope over depth below which a curve of two surfaces is a point in the view."""


@dataclass(frozen=True)
class Piece:
    """A piece of a line in a view.

    Attributes:
        role: the view.
        point: (2,) in its plane.
        across: (2,) unit normal of the line.
        linetype: how it is drawn; None if it is blank.
        length: units.
        confidence: 0 to 1, of the linetype.
    """

    role: Role
    point: Point
    across: Point
    linetype: Linetype | None
    length: float
    confidence: float = 1.0


def find_pieces(
    space: CellComplex,
    planes: dict[Axis, PlaneCarriers],
    near: float,
    tolerance: float = 0.0,
    rows: Mapping[Axis, Sequence[Row]] | None = None,
) -> Iterator[Piece]:
    """All pieces of all views.

    Args:
        space: of the part.
        planes: what is drawn in each plane.
        near: units within which a curve of two surfaces is one that is drawn.
        tolerance: units by which ends of strokes may be off; where they end, shorter pieces say
            nothing.
        rows: of the planes' grids, where they are known.
    """
    for normal, plane in planes.items():
        this_rows = find_rows(space, normal) if rows is None else rows[normal]
        for point, across, carrier, length in _lines(space, normal, this_rows):
            for role in plane.roles:
                if carrier is not None and _may_be_drawn(carrier, role, point, length, tolerance):
                    continue
                linetype, confidence = _drawn(carrier, role, point)
                short = linetype is Linetype.HIDDEN and length <= _DASH * tolerance
                if short and _is_outline(space.planes[normal], point, across):
                    linetype = Linetype.VISIBLE
                yield Piece(role, point, across, linetype, length, confidence)
        finder = _DrawnNear(plane, near)
        meeting = chain(_meeting_curves(space, normal), _meeting_lines(space, normal))
        for point, across, length in chain(_rims(space, normal), meeting):
            for role in plane.roles:
                certain, linetype = finder.linetype(role, point, across)
                if certain and not (linetype and _is_outside(space.planes[normal], point, across)):
                    yield Piece(role, point, across, linetype, length)


def _is_outline(arrangement: Arrangement, point: Point, across: Point) -> bool:
    """Whether the outside begins at a piece: nothing hides it, whatever it looks like."""
    (a, b), (da, db) = point, across
    one, other = (arrangement.locate(a + way * da, b + way * db) for way in (-ASIDE, ASIDE))
    return (one == OUTSIDE) != (other == OUTSIDE)


def _is_outside(arrangement: Arrangement, point: Point, across: Point) -> bool:
    """Whether both sides of a piece are outside the part.

    An outline that is a curve of two surfaces is known as a chain of chords, a hair inside of it.
    """
    (a, b), (da, db) = point, across
    return all(arrangement.locate(a + way * da, b + way * db) == OUTSIDE for way in (-ASIDE, ASIDE))


def _drawn(carrier: Carrier | None, role: Role, point: Point) -> tuple[Linetype | None, float]:
    if carrier is None:
        return None, 1.0
    at = carrier.curve.parameter(point)
    slack = 1e-4 / carrier.curve.speed
    confidence = [
        interval.confidence
        for interval in carrier.intervals.get(role, ())
        if interval.low - slack <= at <= interval.high + slack
    ]
    return carrier.linetype_at(role, at), max(confidence, default=1.0)


def _may_be_drawn(
    carrier: Carrier, role: Role, point: Point, length: float, tolerance: float
) -> bool:
    """Whether a piece may be drawn or not, as one so short and so near to a stroke's end."""
    at = carrier.curve.parameter(point)
    if carrier.is_open_at(role, at):
        return True
    for interval in carrier.intervals.get(role, ()):
        reach = _LOOSE_ENDS[interval.linetype] * tolerance
        away = min(abs(at - interval.low), abs(at - interval.high)) * carrier.curve.speed
        if length <= reach and away <= reach:
            return True
    return False


def _lines(
    space: CellComplex, normal: Axis, rows: Sequence[Row]
) -> Iterator[tuple[Point, Point, Carrier | None, float]]:
    """Pieces of the grid of values, and of the carriers that are not parallel to an axis."""
    plane = space.planes[normal]
    values = [space.values[Axis(index)] for index in IN_PLANE[normal]]
    for row in rows:
        across = (1.0, 0.0) if row.coordinate == 0 else (0.0, 1.0)
        for low, high in row.pieces():
            at = low + SHARE * (high - low)
            point = (row.value, at) if row.coordinate == 0 else (at, row.value)
            yield point, across, row.carrier, high - low
    for index, low, high in plane.stretches:
        carrier = plane.carriers[index]
        if carrier.curve.axis is None:
            yield from _cut(carrier, (low, high), values)


def _cut(
    carrier: Carrier, stretch: tuple[float, float], values: list[list[float]]
) -> Iterator[tuple[Point, Point, Carrier, float]]:
    curve = carrier.curve
    for low, high in _cuts(curve, stretch, values):
        at = low + SHARE * (high - low)
        yield curve.at(at), curve.normal(at), carrier, (high - low) * curve.speed


def _cuts(
    curve: LineOrCircle, stretch: tuple[float, float], values: list[list[float]]
) -> Iterator[tuple[float, float]]:
    """Parts of a stretch between the values of both axes."""
    cuts = {*stretch}
    for coordinate in (0, 1):
        for value in values[coordinate]:
            for point in meetings(curve, axis_line(coordinate, value)):
                cuts.add(curve.parameter(point))
    inside = sorted(t for t in cuts if stretch[0] - 1e-9 <= t <= stretch[1] + 1e-9)
    for low, high in pairwise(inside):
        if (high - low) * curve.speed >= SHORTEST:
            yield low, high


def _runs(
    plane: Arrangement, at: Callable[[float], Point], ends: tuple[float, float]
) -> Iterator[tuple[float, float]]:
    """A parameter in each region that a curve runs through, and its share of the curve."""
    low, high = ends
    parameters = [low + (k + SHARE) / _SAMPLES * (high - low) for k in range(_SAMPLES)]
    for _, run in groupby(parameters, key=lambda t: plane.locate(*at(t))):
        items = list(run)
        yield items[len(items) // 2], len(items) / _SAMPLES


def _rims(space: CellComplex, normal: Axis) -> Iterator[tuple[Point, Point, float]]:
    """Points of the curves along which extra bodies begin, end or turn away."""
    values = [space.values[Axis(index)] for index in IN_PLANE[normal]]
    for body in space.bodies:
        for curve, stretch in body.rims(normal):
            if any(_near_same(curve, carrier.curve) for carrier in space.planes[normal].carriers):
                continue
            for low, high in _cuts(curve, stretch, values):
                for at, share in _runs(space.planes[normal], curve.at, (low, high)):
                    yield curve.at(at), curve.normal(at), share * (high - low) * curve.speed


def _near_same(one: LineOrCircle, other: LineOrCircle) -> bool:
    """Whether curves are one within what pieces can tell."""
    if type(one) is not type(other):
        return False
    return all(other.distance(one.at(t)) < _RIM for t in (0.0, 1.0, 2.5))


@dataclass(frozen=True)
class _Branch:
    """A slanted line's stretch or a part of a circle, as (coordinate, slope) over depth."""

    curve: LineOrCircle
    low: float
    high: float

    def over(self, depth: float, depth_coordinate: int) -> list[tuple[float, float]]:
        """The other coordinate and its change with depth, wherever the depth is met."""
        found = []
        for point in meetings(self.curve, axis_line(depth_coordinate, depth)):
            at = self.curve.parameter(point)
            if not self.low + 1e-6 < at < self.high - 1e-6:
                continue
            normal = self.curve.normal(at)
            along = normal[1 - depth_coordinate]
            if abs(along) > COMPUTED:
                found.append((point[1 - depth_coordinate], -normal[depth_coordinate] / along))
        return found


def _branches(space: CellComplex, normal: Axis) -> list[_Branch]:
    plane = space.planes[normal]
    return [
        _Branch(plane.carriers[index].curve, low, high)
        for index, low, high in plane.stretches
        if plane.carriers[index].curve.axis is None
    ]


def _meeting_curves(space: CellComplex, normal: Axis) -> Iterator[tuple[Point, Point, float]]:
    """Points of the curves in which slanted and round surfaces of the two other planes meet."""
    axes = IN_PLANE[normal]
    # The plane that shows the first coordinate against depth, and the one with the second.
    first, second = Axis(axes[1]), Axis(axes[0])
    one, other = _branches(space, first), _branches(space, second)
    if not one or not other:
        return
    places = [IN_PLANE[plane].index(normal.value) for plane in (first, second)]
    arrangement = space.planes[normal]
    for low, high in pairwise(space.values[normal]):
        # By surfaces and region, since what is told of one says nothing about the other.
        found: dict[tuple[int, int, int], list[tuple[Point, float, float]]] = defaultdict(list)
        for k in range(_SAMPLES):
            depth = low + (k + SHARE) / _SAMPLES * (high - low)
            firsts = _hits(one, depth, places[0])
            seconds = _hits(other, depth, places[1])
            for (i, (a, slope_a)), (j, (b, slope_b)) in product(firsts, seconds):
                if hypot(slope_a, slope_b) > _STEADY:
                    key = i, j, arrangement.locate(a, b)
                    found[key].append(((a, b), slope_a, slope_b))
        for run in found.values():
            point, slope_a, slope_b = run[len(run) // 2]
            steep = hypot(slope_a, slope_b)
            length = (high - low) * len(run) / _SAMPLES * steep
            if length > SHORTEST:
                yield point, (-slope_b / steep, slope_a / steep), length


def _hits(
    branches: list[_Branch], depth: float, coordinate: int
) -> list[tuple[int, tuple[float, float]]]:
    """Numbered meetings of branches with a depth; the two of one circle have different numbers."""
    return [
        (2 * number + place, hit)
        for number, branch in enumerate(branches)
        for place, hit in enumerate(branch.over(depth, coordinate))
    ]


def _meeting_lines(space: CellComplex, normal: Axis) -> Iterator[tuple[Point, Point, float]]:
    """Points of lines parallel to an axis in which slanted and round surfaces meet planes.

    The plane is at right angles to the line of sight.  Where that is so at a corner of a view, the
    line is one of the grid of values, and left out here.
    """
    axes = IN_PLANE[normal]
    for coordinate, axis in enumerate(axes):
        facing, adjacent_axis = Axis(axis), Axis(axes[1 - coordinate])
        branches = _branches(space, adjacent_axis)
        place = IN_PLANE[adjacent_axis].index(normal.value)
        across = (1.0, 0.0) if coordinate == 0 else (0.0, 1.0)
        for depth, drawn in _planes_across(space.planes[facing], facing, normal):
            found = {at for branch in branches for at, _ in branch.over(depth, place)}
            for value in found:
                if any(abs(value - known) < ON_CURVE for known in space.values[facing]):
                    continue
                for low, high in pairwise(space.values[adjacent_axis]):
                    at = low + SHARE * (high - low)
                    if any(start < at < end for start, end in drawn):
                        point = (value, at) if coordinate == 0 else (at, value)
                        yield point, across, high - low


def _planes_across(
    plane: Arrangement, facing: Axis, normal: Axis
) -> Iterator[tuple[float, list[tuple[float, float]]]]:
    """Planes at right angles to an axis that another plane draws: depths, and where it does."""
    place = IN_PLANE[facing].index(normal.value)
    for carrier in plane.carriers:
        if carrier.curve.axis == place:
            depth = carrier.curve.point[place]
            origin = carrier.curve.point[1 - place]
            yield depth, [(origin + low, origin + high) for low, high in carrier.drawn()]


class _DrawnNear:
    """What is drawn within reach of a point, be it on a carrier or along a chain."""

    def __init__(self, plane: PlaneCarriers, near: float) -> None:
        self._plane = plane
        self._near = near
        self._chains = [(role, np.array(chain), linetype) for role, chain, linetype in plane.chains]

    def linetype(self, role: Role, point: Point, across: Point) -> tuple[bool, Linetype | None]:
        """Whether it is certain what is drawn along a curve with a normal at a point, and what.

        Visible comes before hidden.  A line that is drawn close by may be the curve's, or that of
        another surface.
        """
        found: set[Linetype | None] = set()
        linetypes: set[Linetype | None] = set()
        for carrier in self._plane.carriers:
            away = carrier.curve.distance(point)
            if away < self._near:
                at = carrier.curve.parameter(point)
                a, b = carrier.curve.normal(at)
                if abs(a * across[0] + b * across[1]) > _ALONG:
                    known = away < _ON and not carrier.is_unsure_at(role, at)
                    (found if known else linetypes).add(carrier.linetype_at(role, at))
                    if carrier.is_open_at(role, at):
                        linetypes.add(Linetype.HIDDEN)
        for other, drawn, linetype in self._chains:
            if other is role and self._is_near(drawn, point):
                found.add(linetype)
        for linetype in (Linetype.VISIBLE, Linetype.HIDDEN):
            if linetype in found:
                return True, linetype
        return not linetypes & set(Linetype), None

    def _is_near(self, chain: np.ndarray, point: Point) -> bool:
        low, high = chain.min(0) - self._near, chain.max(0) + self._near
        if not (low[0] <= point[0] <= high[0] and low[1] <= point[1] <= high[1]):
            return False
        return bool(chain_distances(chain, np.array([point]))[0] < self._near)
