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

from gaussiancad_core.coordinates.carrier_curves import (
    TURN,
    CircleCurve,
    LineCurve,
    PlaneCurve,
    Point,
    axis_line,
    meetings,
)
from gaussiancad_core.coordinates.carriers import PartSupports, PlaneSupports
from gaussiancad_core.coordinates.drawn_intervals import Span, Support, stations_on
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Linetype

_NEAR = 3.0
"""Tolerances within which a stroke ends at an edge, and meets others."""

_LEAST_NEAR = 0.02
"""The same in units, at least."""

_TOUCHING = 0.2
"""Share of a circle's radius within which a line that touches it ends at the touching point: small
errors of the line move that by much more."""

_SEAM = 1e-6
"""Angle within which an arc's end is where angles begin again."""


@dataclass(frozen=True)
class _FreeEnd:
    """An end of a stroke that no other stroke meets.

    Attributes:
        support: number of its curve.
        at: parameter there.
        point: (2,) in the plane.
    """

    support: int
    at: float
    point: Point


def with_smooth_edges(supports: PartSupports) -> PartSupports:
    """The supports, with lines without confidence where strokes end at edges that are not drawn."""
    near = max(_NEAR * supports.tolerance, _LEAST_NEAR)
    planes = {}
    for normal, plane in supports.planes.items():
        found = plane
        free = _free_ends(plane, near)
        for along in (0, 1) if free else ():
            for value in _distinct(_smooth(supports, normal, along, near), near):
                found = _with_edge(found, axis_line(along, value), free, near)
        planes[normal] = found
    return replace(supports, planes=planes)


def _distinct(values: Iterator[float], near: float) -> list[float]:
    """Values that are farther apart than ``near``, ascending."""
    found: list[float] = []
    for value in sorted(values):
        if not found or value - found[-1] > near:
            found.append(value)
    return found


def _smooth(supports: PartSupports, normal: Axis, along: int, near: float) -> Iterator[float]:
    """Values of a plane's coordinate at which a rounding passes into a plane that faces us."""
    axis = Axis(IN_PLANE[normal][along])
    other = next(each for each in Axis if each not in (normal, axis))
    if other not in supports.planes:
        return
    facing = IN_PLANE[other].index(normal.value)
    shown = supports.planes[other].supports
    circles = []
    for support in shown:
        curve = support.curve
        if not isinstance(curve, CircleCurve):
            continue
        circles.append(curve)
        if any(
            abs(curve.at(end)[1 - facing] - curve.centre[1 - facing]) < near
            for end in _ends(support)
        ):
            yield curve.centre[1 - facing]
    for support in shown:
        for point in _touching(support, circles, near):
            yield point[1 - facing]


def _touching(support: Support, circles: list[CircleCurve], near: float) -> Iterator[Point]:
    """Where a straight line touches circles that it ends at."""
    line = support.curve
    if not isinstance(line, LineCurve):
        return
    for circle in circles:
        foot = line.parameter(circle.centre)
        room = max(near, _TOUCHING * circle.radius)
        if abs(line.distance(circle.centre) - circle.radius) < near and any(
            abs(end - foot) < room for end in _ends(support)
        ):
            yield line.at(foot)


def _free_ends(plane: PlaneSupports, near: float) -> list[_FreeEnd]:
    found = []
    for number, support in enumerate(plane.supports):
        others = [each for each in plane.supports if each is not support]
        for end in _ends(support):
            point = support.curve.at(end)
            if not any(_reaches(other, point, near) for other in others) and not any(
                hypot(point[0] - corner[0], point[1] - corner[1]) < near
                for _, chain, _ in plane.chains
                for corner in (chain[0], chain[-1])
            ):
                found.append(_FreeEnd(number, end, point))
    return found


def _ends(support: Support) -> list[float]:
    """Where what is drawn on a support ends; a circle's angle only begins again at zero."""
    ends = [end for stretch in support.drawn() for end in stretch]
    round_ones = {end for end in ends if min(end, TURN - end) < _SEAM}
    if isinstance(support.curve, CircleCurve) and len(round_ones) > 1:
        return [end for end in ends if end not in round_ones]
    return ends


def _reaches(support: Support, point: Point, near: float) -> bool:
    """Whether a stroke comes near a point."""
    if support.curve.distance(point) > near:
        return False
    at, slack = support.curve.parameter(point), near / support.curve.speed
    return any(low - slack <= at <= high + slack for low, high in support.drawn())


def _with_edge(
    plane: PlaneSupports, line: PlaneCurve, free: list[_FreeEnd], near: float
) -> PlaneSupports:
    """The plane with the stretches of a line that begin or end where strokes end in the open."""
    ends = [end for end in free if line.distance(end.point) < near]
    if not ends:
        return plane
    found = list(plane.supports)
    places = set()
    for end in ends:
        at = _led_to(found, end, line, near)
        if at is not None:
            places.add(at)
    met = {
        at
        for at in stations_on(line, [support.curve for support in plane.supports])
        if any(
            support.curve.distance(line.at(at)) < 1e-6 and _reaches(support, line.at(at), 1e-4)
            for support in plane.supports
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
    spans = tuple(Span(low, high, Linetype.HIDDEN, 0.0) for low, high in (*between, *lone))
    if not spans:
        return plane
    place = next((k for k, support in enumerate(found) if support.curve == line), None)
    if place is None:
        found.append(Support(line, {role: spans for role in plane.roles}))
    else:
        drawn = found[place].spans
        known = {role: (*drawn.get(role, ()), *spans) for role in plane.roles}
        found[place] = Support(line, known)
    return replace(plane, supports=tuple(found))


def _led_to(supports: list[Support], end: _FreeEnd, line: PlaneCurve, near: float) -> float | None:
    """Where an open end is on a line once its stroke ends there exactly; None if it never does."""
    support = supports[end.support]
    met = [
        point
        for point in meetings(support.curve, line)
        if hypot(point[0] - end.point[0], point[1] - end.point[1]) < near
    ]
    if not met:
        return None
    at = support.curve.parameter(met[0])
    spans = {
        role: tuple(
            replace(
                span,
                low=at if abs(span.low - end.at) < 1e-9 else span.low,
                high=at if abs(span.high - end.at) < 1e-9 else span.high,
            )
            for span in this_spans
        )
        for role, this_spans in support.spans.items()
    }
    supports[end.support] = Support(support.curve, spans)
    return line.parameter(met[0])
