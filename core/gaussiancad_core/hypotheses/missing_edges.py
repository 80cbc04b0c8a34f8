"""Lines that a view may lack: where two others show an edge, and where strokes end in the open.

Without one line of a view, what lies on both sides of a face is one region, and no labels have all
lines that are there.  An edge parallel to an axis is a line in two views and a corner of lines in
the third; if one of these lines is missing, the other two views tell where it was.  So do strokes
whose end nothing else meets.  Such lines bound regions and are not drawn: that nothing is seen
there is still a rule, and the labels decide which of these rules are wrong.
"""

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, pairwise
from types import MappingProxyType

from gaussiancad_core.cells.arrangement import Arrangement, distinct
from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval, merged_intervals
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import APART, SHORTEST
from gaussiancad_core.geometry.whole_curves import Circle, Line, LineOrCircle, axis_line
from gaussiancad_core.hypotheses.missing_circles import missing_circles, sectioned_circles
from gaussiancad_core.hypotheses.missing_slants import missing_slants
from gaussiancad_core.hypotheses.open_corners import joining
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Linetype

Stretch = tuple[LineOrCircle, float, float]
"""A curve and its parameters from a low to a high one."""


def with_missing_edges(
    carriers: PartCarriers,
    *,
    undrawn: Collection[Role] = (),
    cuts: Collection[tuple[Axis, float]] = (),
    floors: Mapping[Axis, Sequence[float]] = MappingProxyType({}),
) -> PartCarriers:
    """The carriers with stretches that views may lack.

    Where an edge has to be drawn is known of three planes only.

    Args:
        carriers: of the strokes.
        undrawn: views that may lack any line along the axes.
        cuts: cutting planes of sections: the axis that one is across, units along it.
        floors: coordinates in units at which nothing is drawn and a surface may lie.
    """
    near = max(SHORTEST, carriers.tolerance)
    if len(carriers.planes) < len(Axis):
        grids = {
            axis: _divided(
                plane,
                chain(
                    _grid(carriers, axis, (), floors), sectioned_circles(carriers, axis, cuts, near)
                ),
            )
            for axis, plane in carriers.planes.items()
            if all(role in undrawn for role in plane.roles)
        }
        return replace(carriers, planes={**carriers.planes, **grids})
    corners = {axis: Arrangement(plane.carriers).corners for axis, plane in carriers.planes.items()}
    silent = {
        axis
        for axis in Axis
        if all(
            role in undrawn
            for number in IN_PLANE[axis]
            for role in carriers.planes[Axis(number)].roles
        )
    }
    planes = {}
    for axis, plane in carriers.planes.items():
        edges = _edges(carriers, corners, axis, near)
        if all(role in undrawn for role in plane.roles):
            edges = chain(edges, _grid(carriers, axis, silent, floors))
        slanted = missing_slants(carriers, corners[axis], axis, near)
        round_ones = chain(
            missing_circles(carriers, axis, near), sectioned_circles(carriers, axis, cuts, near)
        )
        found = chain(edges, slanted, round_ones, joining(carriers, axis, near))
        planes[axis] = _divided(plane, found)
    return replace(carriers, planes=planes)


@dataclass(frozen=True)
class _Beside:
    """How one of the other planes shows a coordinate of a plane, and its depth.

    Attributes:
        plane: that plane.
        along: place of the coordinate among the plane's.
    """

    plane: PlaneCarriers
    along: int

    @property
    def depth(self) -> int:
        """Place of the depth."""
        return 1 - self.along


def _edges(
    carriers: PartCarriers, corners: dict[Axis, tuple[Point, ...]], normal: Axis, near: float
) -> Iterator[Stretch]:
    """Lines parallel to an axis that show an edge which both other planes show."""
    for coordinate, index in enumerate(IN_PLANE[normal]):
        other = Axis(IN_PLANE[normal][1 - coordinate])
        # The plane in which such an edge is a point, and the one in which it is a line.
        point = _Beside(carriers.planes[other], IN_PLANE[other].index(index))
        line_plane = carriers.planes[Axis(index)]
        line = _Beside(line_plane, IN_PLANE[Axis(index)].index(other.value))
        drawn = _lines_by_depth(line, near)
        for value in distinct([*carriers.values[Axis(index)], *_extremes(point)]):
            depths = _depths_at(point, corners[other], value, near)
            stretches = [stretch for depth in depths for stretch in _at(drawn, depth, near)]
            curve = axis_line(coordinate, value)
            for low, high in merged_intervals(stretches, near):
                yield curve, low, high


def _grid(
    carriers: PartCarriers,
    normal: Axis,
    silent: Collection[Axis],
    floors: Mapping[Axis, Sequence[float]],
) -> Iterator[Stretch]:
    """All lines through a plane at the coordinates that any view shows, or a note tells.

    Along ``silent`` axes, of which only views that may lack lines tell, surfaces may lie anywhere
    between: the middle stands for that.
    """
    for coordinate, index in enumerate(IN_PLANE[normal]):
        along = carriers.values[Axis(IN_PLANE[normal][1 - coordinate])]
        values = sorted(carriers.values[Axis(index)])
        if Axis(index) in silent:
            values += [0.5 * (low + high) for low, high in pairwise(values)]
        for floor in floors.get(Axis(index), ()):
            if all(abs(floor - value) > APART for value in values):
                values.append(floor)
        for value in values:
            yield axis_line(coordinate, value), min(along), max(along)


def _lines_by_depth(neighbour: _Beside, near: float) -> dict[int, list[tuple[float, float]]]:
    """Where lines of one depth are drawn, by multiples of ``near``."""
    found: dict[int, list[tuple[float, float]]] = defaultdict(list)
    for carrier in neighbour.plane.carriers:
        curve = carrier.curve
        if isinstance(curve, Line) and curve.axis == neighbour.depth:
            start = curve.point[neighbour.along]
            at = round(curve.point[neighbour.depth] / near)
            found[at] += [(start + low, start + high) for low, high in carrier.drawn()]
    return found


def _at(
    drawn: dict[int, list[tuple[float, float]]], depth: float, near: float
) -> Iterator[tuple[float, float]]:
    middle = round(depth / near)
    for key in (middle - 1, middle, middle + 1):
        yield from drawn.get(key, ())


def _extremes(neighbour: _Beside) -> Iterator[float]:
    """Where circles reach farthest: in the view across nothing else may be there."""
    for carrier in neighbour.plane.carriers:
        curve = carrier.curve
        if isinstance(curve, Circle):
            yield curve.centre[neighbour.along] - curve.radius
            yield curve.centre[neighbour.along] + curve.radius


def _depths_at(
    neighbour: _Beside, corners: Sequence[Point], value: float, near: float
) -> Iterator[float]:
    """Depths of the corners at a value, and of the sides of circles whose extreme lies there."""
    found = {
        round(corner[neighbour.depth], 6)
        for corner in corners
        if abs(corner[neighbour.along] - value) <= near
    }
    for carrier in neighbour.plane.carriers:
        curve = carrier.curve
        if isinstance(curve, Circle):
            away = abs(curve.centre[neighbour.along] - value)
            if abs(away - curve.radius) <= near:
                # The edge of a cylinder's outline is no line of the view across, its sides are.
                centre = curve.centre[neighbour.depth]
                found |= {centre - curve.radius, centre + curve.radius}
    return iter(sorted(found))


def as_if_drawn(carriers: PartCarriers) -> PartCarriers:
    """The carriers with what views may lack as lines that may be drawn or not."""
    planes = {}
    for axis, plane in carriers.planes.items():
        found = list(plane.carriers)
        for number, low, high in plane.lost:
            carrier = found[number]
            interval = Interval(low, high, Linetype.HIDDEN, 0.0)
            intervals = {role: (*carrier.intervals.get(role, ()), interval) for role in plane.roles}
            found[number] = Carrier(carrier.curve, intervals)
        planes[axis] = replace(plane, carriers=tuple(found), lost=())
    return replace(carriers, planes=planes)


def _divided(plane: PlaneCarriers, found: Iterable[Stretch]) -> PlaneCarriers:
    """The plane with stretches on its carriers, or on new ones, where nothing is drawn yet."""
    carriers = list(plane.carriers)
    lost: list[tuple[int, float, float]] = []
    for curve, low, high in found:
        number = next(
            (n for n, carrier in enumerate(carriers) if _same(carrier.curve, curve)), None
        )
        if number is None:
            carriers.append(Carrier(curve, {}))
            number = len(carriers) - 1
        line_curve = carriers[number].curve
        ends = (low, high)
        if isinstance(line_curve, Line) and isinstance(curve, Line):
            first, last = sorted(line_curve.parameter(curve.at(end)) for end in (low, high))
            ends = first, last
        slack = SHORTEST / line_curve.speed
        drawn = carriers[number].drawn()
        if not any(a - slack <= ends[0] and ends[1] <= b + slack for a, b in drawn):
            lost.append((number, *ends))
    return replace(plane, carriers=tuple(carriers), lost=tuple(lost))


def _same(one: LineOrCircle, other: LineOrCircle) -> bool:
    if isinstance(one, Circle) or isinstance(other, Circle):
        return one == other
    return one.direction == other.direction and one.distance(other.point) < 1e-5
