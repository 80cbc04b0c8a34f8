"""Chamfers of round edges whose own lines are too short to be read.

The mouth of a bore, or the end of a pin, shows two circles about one centre, and beside them the
edges across the axis at both ends of the chamfer.  The slanted lines in between are a dash long; in
a picture they run into their neighbours.  Or one view shows them, as those of a drill's tip, and
the other one does not.  They are added as lines that may be drawn or not.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, permutations
from math import hypot, pi

from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import MOVED, SAME_READ
from gaussiancad_core.geometry.whole_curves import Circle, Line, line_through
from gaussiancad_core.hypotheses.suppressed_slants import LEAST, MOST, MOST_LOST, shows
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Linetype

_WHOLE = 1.5 * pi
"""Angle of a circle that is drawn at least."""

_WIDEST = 14.0
"""Tolerances up to which a chamfer may have been lost in all views."""

_STEEP = 2.0
"""Slope of such a chamfer, or of its counterpart, at most."""


@dataclass(frozen=True)
class _Chamfer:
    """Half of an axial section: from (radius, height) to (radius, height)."""

    axis: Axis
    centre: Point
    inner: tuple[float, float]
    outer: tuple[float, float]


@dataclass(frozen=True)
class _Side:
    """A view beside an axis: where its lines run along that axis and across it."""

    plane: PlaneCarriers
    along: int
    middle: float

    def across(self) -> Iterator[tuple[float, float, float]]:
        """(height, low, high) of the edges across the axis; low and high from the axis."""
        for carrier in self.plane.carriers:
            if carrier.curve.axis == self.along:
                origin = carrier.curve.point[1 - self.along] - self.middle
                for low, high in carrier.drawn():
                    yield carrier.curve.point[self.along], origin + low, origin + high

    def has_along(self, radius: float, height: float, near: float) -> bool:
        """Whether a line along the axis is drawn at a radius, and passes a height."""
        for carrier in self.plane.carriers:
            curve = carrier.curve
            if curve.axis != 1 - self.along:
                continue
            off = abs(curve.point[1 - self.along] - self.middle)
            at = height - curve.point[self.along]
            if abs(off - radius) <= near and any(a < at < b for a, b in carrier.drawn()):
                return True
        return False

    def slants(self) -> Iterator[tuple[Point, Point]]:
        """Both ends of each slanted line: distances from the axis, and heights."""
        for carrier in self.plane.carriers:
            if isinstance(carrier.curve, Line) and carrier.curve.axis is None:
                for stretch in carrier.drawn():
                    one, other = (carrier.curve.at(at) for at in stretch)
                    yield self._seen(one), self._seen(other)

    def _seen(self, point: Point) -> Point:
        return point[1 - self.along] - self.middle, point[self.along]


def with_short_chamfers(carriers: PartCarriers) -> PartCarriers:
    """The carriers with the lines of chamfers that may be drawn; they have no confidence."""
    if len(carriers.planes) < len(Axis):
        return carriers
    near = SAME_READ * carriers.tolerance
    found: list[_Chamfer] = []
    for axis in Axis:
        for chamfer in _chamfers(carriers, axis):
            # Both views may tell it, and a line of one of them once more.
            if not any(_is_same(chamfer, other, near) for other in found):
                found.append(chamfer)
    planes, added = dict(carriers.planes), 0
    for chamfer in found:
        completed = {normal: _completed(plane, chamfer, near) for normal, plane in planes.items()}
        added += completed != planes
        planes = completed
    return replace(carriers, planes=planes) if 0 < added <= MOST_LOST else carriers


def _is_same(one: _Chamfer, other: _Chamfer, near: float) -> bool:
    """Whether two chamfers are one."""
    if one.axis is not other.axis:
        return False
    numbers = zip(
        (*one.centre, *one.inner, *one.outer),
        (*other.centre, *other.inner, *other.outer),
        strict=True,
    )
    return all(abs(a - b) <= near for a, b in numbers)


def _chamfers(carriers: PartCarriers, axis: Axis) -> Iterator[_Chamfer]:
    near, least, lost, most = (k * carriers.tolerance for k in (SAME_READ, LEAST, _WIDEST, MOST))
    for centre, radii in _round_edges(carriers.planes[axis], near):
        sides = [_side(p, axis, centre) for normal, p in carriers.planes.items() if normal != axis]
        for small, large in pairwise(radii):
            if not least < large - small < lost:
                continue
            heightses = {
                heights
                for side in sides
                for heights in _heights(side, (small, large), radii, (least, lost), near)
            }
            for start, end in sorted(heightses):
                chamfer = _Chamfer(axis, centre, (small, start), (large, end))
                if not any(_is_another(chamfer, side, near) for side in sides):
                    yield chamfer
        for side in sides:
            for inner, outer in _shown(side, [0.0, *radii], near):
                if hypot(outer[0] - inner[0], outer[1] - inner[1]) < most:
                    yield _Chamfer(axis, centre, inner, outer)


def _round_edges(plane: PlaneCarriers, near: float) -> Iterator[tuple[Point, list[float]]]:
    """Centres of whole circles, and the radii about each, ascending."""
    left = [
        carrier.curve
        for carrier in plane.carriers
        if isinstance(carrier.curve, Circle)
        and sum(high - low for low, high in carrier.drawn()) > _WHOLE
    ]
    while left:
        (x, y) = left[0].centre
        cs = [c for c in left if max(abs(c.centre[0] - x), abs(c.centre[1] - y)) <= near]
        left = [c for c in left if c not in cs]
        yield (x, y), sorted(circle.radius for circle in cs)


def _side(plane: PlaneCarriers, axis: Axis, centre: Point) -> _Side:
    along = IN_PLANE[plane.normal].index(axis.value)
    other = IN_PLANE[plane.normal][1 - along]
    return _Side(plane, along, centre[IN_PLANE[axis].index(other)])


def _heights(
    side: _Side,
    pair: tuple[float, float],
    radii: Sequence[float],
    reach: tuple[float, float],
    near: float,
) -> Iterator[tuple[float, float]]:
    """Heights of the smaller and of the larger circle of a chamfer.

    The edge across the axis is as long as the one circle is wide, and at the other circle a face
    reaches as far as the chamfer at least: around the mouth of a bore, or beside the undercut of a
    shoulder, where it reaches farther.  No line along the axis is there in between, as at a step:
    but what one view leaves out may be read as such a line in the other one.

    Args:
        side: the view.
        pair: radii of the circles.
        radii: of all circles about the axis.
        reach: least and most of height between them.
        near: within which lines are the same.
    """
    small, large = pair
    edges = list(side.across())
    for (start, *inner), (end, *outer) in permutations(edges, 2):
        steepness = abs(end - start) / (large - small)
        if (
            reach[0] < abs(end - start) < reach[1]
            and 1.0 / _STEEP <= steepness <= _STEEP
            and (
                (_is_across(inner, small, radii, near) and _covers(outer, large - near))
                or (_is_across(outer, large, radii, near) and _covers(inner, large + near))
            )
            and not any(side.has_along(r, (start + end) / 2.0, near) for r in pair)
        ):
            yield start, end


def _is_across(edge: Sequence[float], radius: float, radii: Sequence[float], near: float) -> bool:
    """Whether an edge from ``edge[0]`` to ``edge[1]`` is a circle seen from its side.

    A hidden one ends where the dashes of the chamfer begin: nobody can tell them apart.
    """
    return all(
        abs(end - radius) <= MOVED * near
        and radius == min(radii, key=lambda known: abs(known - end))
        for end in (-edge[0], edge[1])
    )


def _covers(edge: Sequence[float], radius: float) -> bool:
    """Whether an edge reaches as far as a radius on both sides of the axis."""
    return edge[0] <= -radius and edge[1] >= radius


def _is_another(chamfer: _Chamfer, side: _Side, near: float) -> bool:
    """Whether a drawn slanted line ends at one of the chamfer's corners only."""
    corners = chamfer.inner, chamfer.outer
    return any(
        sum(any(hypot(r - abs(a), z - b) <= near for a, b in ends) for r, z in corners) == 1
        for ends in side.slants()
    )


def _shown(side: _Side, radii: list[float], near: float) -> Iterator[tuple[Point, Point]]:
    """Slanted lines on both sides of the axis whose ends have the radii of circles, or none."""
    drawn = list(side.slants())
    for one, other in drawn:
        if min(one[0], other[0]) < -near:
            continue
        ends = []
        for r, z in sorted((one, other)):
            radius = min(radii, key=lambda known: abs(known - r))
            mirrored = any(hypot(r + a, z - b) <= near for pair in drawn for a, b in pair)
            if abs(radius - r) <= near and mirrored:
                ends.append((radius, z))
        if len(ends) == 2 and ends[0][0] < ends[1][0]:
            yield ends[0], ends[1]


def _completed(plane: PlaneCarriers, chamfer: _Chamfer, near: float) -> PlaneCarriers:
    """The plane with those lines of a chamfer that it does not show yet."""
    if plane.normal is chamfer.axis:
        return plane
    carriers = list(plane.carriers)
    side = _side(plane, chamfer.axis, chamfer.centre)
    for way in (-1.0, 1.0):
        start, end = (_placed(side, way * r, z) for r, z in (chamfer.inner, chamfer.outer))
        if not any(shows(carrier, start, end, near) for carrier in carriers):
            line = line_through(start, end)
            low, high = sorted((line.parameter(start), line.parameter(end)))
            interval = Interval(low, high, Linetype.HIDDEN, 0.0)
            intervals: dict[Role, tuple[Interval, ...]] = {
                role: (interval,) for role in plane.roles
            }
            carriers.append(Carrier(line, intervals))
    return (
        plane if len(carriers) == len(plane.carriers) else replace(plane, carriers=tuple(carriers))
    )


def _placed(side: _Side, off: float, height: float) -> Point:
    point = [0.0, 0.0]
    point[side.along], point[1 - side.along] = height, side.middle + off
    return point[0], point[1]
