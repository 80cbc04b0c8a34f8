"""Smooth edges that a drawing leaves out, where other lines end at them.

Where a rounding passes into a plane many programs draw no line.  The edges of a notch that ends
there end in the open, so that nothing could bound it.  Between such ends the edge is added, as a
line that may be drawn or not.  The web of a crank's arm touches its bosses so as well, which are
drawn all around: there the edge stands where the web's outline touches the circle.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from math import hypot

from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval, stations_on
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import COMPUTED, MEETING, SAME_PLACE
from gaussiancad_core.geometry.whole_curves import Circle, Line, LineOrCircle, axis_line, meetings
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Linetype

_TOUCHING = 0.2
"""Share of a circle's radius within which a line that touches it ends at the touching point: small
errors of the line move that by much more."""


@dataclass(frozen=True)
class _FreeEnd:
    """An end of a stroke that no other stroke meets.

    Attributes:
        carrier: number of its curve.
        at: parameter there.
        point: (2,) in the plane.
    """

    carrier: int
    at: float
    point: Point


def with_smooth_edges(carriers: PartCarriers) -> PartCarriers:
    """The carriers, with lines without confidence where strokes end at edges that are not drawn."""
    near = max(MEETING * carriers.tolerance, SAME_PLACE)
    planes = {}
    for normal, plane in carriers.planes.items():
        found = plane
        free = _free_ends(plane, near)
        for along in (0, 1) if free else ():
            for value in _distinct(_smooth(carriers, normal, along, near), near):
                found = _with_edge(found, axis_line(along, value), free, near)
        planes[normal] = found
    return replace(carriers, planes=planes)


def _distinct(values: Iterator[float], near: float) -> list[float]:
    """Values that are farther apart than ``near``, ascending."""
    found: list[float] = []
    for value in sorted(values):
        if not found or value - found[-1] > near:
            found.append(value)
    return found


def _smooth(carriers: PartCarriers, normal: Axis, along: int, near: float) -> Iterator[float]:
    """Values of a plane's coordinate at which a rounding passes into a plane that faces us."""
    axis = Axis(IN_PLANE[normal][along])
    other = next(each for each in Axis if each not in (normal, axis))
    if other not in carriers.planes:
        return
    facing = IN_PLANE[other].index(normal.value)
    shown = carriers.planes[other].carriers
    circles = []
    for carrier in shown:
        curve = carrier.curve
        if not isinstance(curve, Circle):
            continue
        circles.append(curve)
        if any(
            abs(curve.at(end)[1 - facing] - curve.centre[1 - facing]) < near
            for end in _ends(carrier)
        ):
            yield curve.centre[1 - facing]
    for carrier in shown:
        for point in _touching(carrier, circles, near):
            yield point[1 - facing]


def _touching(carrier: Carrier, circles: list[Circle], near: float) -> Iterator[Point]:
    """Where a straight line touches circles that it ends at."""
    line = carrier.curve
    if not isinstance(line, Line):
        return
    for circle in circles:
        foot = line.parameter(circle.centre)
        room = max(near, _TOUCHING * circle.radius)
        if abs(line.distance(circle.centre) - circle.radius) < near and any(
            abs(end - foot) < room for end in _ends(carrier)
        ):
            yield line.at(foot)


def _free_ends(plane: PlaneCarriers, near: float) -> list[_FreeEnd]:
    found = []
    for number, carrier in enumerate(plane.carriers):
        others = [each for each in plane.carriers if each is not carrier]
        for end in _ends(carrier):
            point = carrier.curve.at(end)
            if not any(_reaches(other, point, near) for other in others) and not any(
                hypot(point[0] - corner[0], point[1] - corner[1]) < near
                for _, chain, _ in plane.chains
                for corner in (chain[0], chain[-1])
            ):
                found.append(_FreeEnd(number, end, point))
    return found


def _ends(carrier: Carrier) -> list[float]:
    """Where what is drawn on a carrier ends; a circle's angle only begins again at zero."""
    ends = [end for stretch in carrier.drawn() for end in stretch]
    round_ones = {end for end in ends if min(end, FULL_TURN - end) < COMPUTED}
    if isinstance(carrier.curve, Circle) and len(round_ones) > 1:
        return [end for end in ends if end not in round_ones]
    return ends


def _reaches(carrier: Carrier, point: Point, near: float) -> bool:
    """Whether a stroke comes near a point."""
    if carrier.curve.distance(point) > near:
        return False
    at, slack = carrier.curve.parameter(point), near / carrier.curve.speed
    return any(low - slack <= at <= high + slack for low, high in carrier.drawn())


def _with_edge(
    plane: PlaneCarriers, line: LineOrCircle, free: list[_FreeEnd], near: float
) -> PlaneCarriers:
    """The plane with the stretches of a line that begin or end where strokes end in the open."""
    ends = [end for end in free if line.distance(end.point) < near]
    if not ends:
        return plane
    found = list(plane.carriers)
    places = set()
    for end in ends:
        at = _led_to(found, end, line, near)
        if at is not None:
            places.add(at)
    met = {
        at
        for at in stations_on(line, [carrier.curve for carrier in plane.carriers])
        if any(
            carrier.curve.distance(line.at(at)) < 1e-6 and _reaches(carrier, line.at(at), 1e-4)
            for carrier in plane.carriers
        )
    }
    stretches = [
        (low, high)
        for low, high in pairwise(sorted(places | met))
        if (low in places or high in places) and high - low > near
    ]
    # Between two open ends the edge is certain; beyond them it goes on only where one end is alone.
    between = [stretch for stretch in stretches if places.issuperset(stretch)]
    paired = {at for stretch in between for at in stretch}
    lone = [stretch for stretch in stretches if not paired.intersection(stretch)]
    intervals = tuple(Interval(low, high, Linetype.HIDDEN, 0.0) for low, high in (*between, *lone))
    if not intervals:
        return plane
    place = next((k for k, carrier in enumerate(found) if carrier.curve == line), None)
    if place is None:
        found.append(Carrier(line, {role: intervals for role in plane.roles}))
    else:
        drawn = found[place].intervals
        known = {role: (*drawn.get(role, ()), *intervals) for role in plane.roles}
        found[place] = Carrier(line, known)
    return replace(plane, carriers=tuple(found))


def _led_to(
    carriers: list[Carrier], end: _FreeEnd, line: LineOrCircle, near: float
) -> float | None:
    """Where an open end is on a line once its stroke ends there exactly; None if it never does."""
    carrier = carriers[end.carrier]
    met = [
        point
        for point in meetings(carrier.curve, line)
        if hypot(point[0] - end.point[0], point[1] - end.point[1]) < near
    ]
    if not met:
        return None
    at = carrier.curve.parameter(met[0])
    intervals = {
        role: tuple(
            replace(
                interval,
                low=at if abs(interval.low - end.at) < 1e-9 else interval.low,
                high=at if abs(interval.high - end.at) < 1e-9 else interval.high,
            )
            for interval in this_spans
        )
        for role, this_spans in carrier.intervals.items()
    }
    carriers[end.carrier] = Carrier(carrier.curve, intervals)
    return line.parameter(met[0])
