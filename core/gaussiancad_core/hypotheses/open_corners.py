"""Lines and arcs that would lead on from ends of strokes which nothing else meets."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, islice
from math import hypot, pi

from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.whole_curves import (
    Circle,
    Line,
    LineOrCircle,
    axis_line,
    line_through,
)
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

_MOST_ENDS = 40
"""Ends in the open of a view up to which they are led on."""

_MOST_SLANTED = 4
"""Slanted lines of a view that may be lost, the shortest ones."""


@dataclass(frozen=True)
class _End:
    """Where a stroke ends in the open.

    Attributes:
        point: (2,) units.
        way: (2,) unit vector, out of a straight stroke; of any other, none.
    """

    point: Point
    way: Point | None


def joining(
    carriers: PartCarriers, normal: Axis, near: float
) -> Iterator[tuple[LineOrCircle, float, float]]:
    """Curves of a plane, with stretches, that join open ends with each other.

    Straight along the axes; slanted where both other planes draw lines over all of it; by a quarter
    of a circle at a corner and half of one between parallels.

    Args:
        carriers: of all planes.
        normal: of the plane.
        near: units within which coordinates are one.
    """
    plane = carriers.planes[normal]
    ends = _open_ends(plane, near)
    if len(ends) > _MOST_ENDS:
        return
    values = [carriers.values[Axis(index)] for index in IN_PLANE[normal]]
    slanted = []
    # Where more than two end beside each other, it is a straight line that they ended at.
    corners = [end for end in ends if _aligned(end, ends, near) <= 1]
    known = [
        end
        for end in corners
        if all(
            _is_one(at, this_values, near)
            for at, this_values in zip(end.point, values, strict=True)
        )
    ]
    for one, other in combinations(corners, 2):
        yield from _rounded(one, other, near)
    for one, other in combinations(ends, 2):
        interval = [abs(a - b) for a, b in zip(one.point, other.point, strict=True)]
        if min(interval) <= near:
            yield _straight(one.point, other.point, near)
        elif one in known and other in known and _turn(one, other):
            slanted.append((hypot(*interval), one.point, other.point))
    edges = (
        (start, end)
        for _, start, end in sorted(slanted)
        if _is_edge(carriers, normal, start, end, near)
    )
    for start, end in islice(edges, _MOST_SLANTED):
        yield _straight(start, end, near)


def _straight(start: Point, end: Point, near: float) -> tuple[Line, float, float]:
    """The line from point to point; along an axis where it nearly is."""
    off = [abs(a - b) for a, b in zip(start, end, strict=True)]
    coordinate = off.index(min(off))
    if min(off) <= near:
        line = axis_line(coordinate, start[coordinate])
    else:
        line = line_through(start, end)
    low, high = sorted((line.parameter(start), line.parameter(end)))
    return line, low, high


def _open_ends(plane: PlaneCarriers, near: float) -> list[_End]:
    found: list[_End] = []
    for carrier in plane.carriers:
        curve = carrier.curve
        for low, high in carrier.drawn():
            if isinstance(curve, Circle) and high - low > FULL_TURN - 1e-6:
                continue
            for at, sign in ((low, -1.0), (high, 1.0)):
                point = curve.at(at)
                if any(_is_on(other, point, near) for other in plane.carriers if other != carrier):
                    continue
                if _goes_round(carrier, at):
                    continue
                way = None
                if isinstance(curve, Line):
                    way = sign * curve.direction[0], sign * curve.direction[1]
                if all(hypot(*_between(known.point, point)) > near for known in found):
                    found.append(_End(point, way))
    return found


def _goes_round(carrier: Carrier, at: float) -> bool:
    """Whether an arc ends only where angles begin again."""
    if not isinstance(carrier.curve, Circle) or 1e-6 < at < FULL_TURN - 1e-6:
        return False
    drawn = carrier.drawn()
    return any(low < 1e-6 for low, _ in drawn) and any(high > FULL_TURN - 1e-6 for _, high in drawn)


def _is_on(carrier: Carrier, point: Point, near: float) -> bool:
    curve = carrier.curve
    if curve.distance(point) > near:
        return False
    at, slack = curve.parameter(point), near / curve.speed
    turns = (0.0, FULL_TURN, -FULL_TURN) if isinstance(curve, Circle) else (0.0,)
    return any(
        low - slack <= at + turn <= high + slack for low, high in carrier.drawn() for turn in turns
    )


def _between(one: Point, other: Point) -> Point:
    return other[0] - one[0], other[1] - one[1]


def _aligned(end: _End, others: Sequence[_End], near: float) -> int:
    """How many other strokes that run the same way end on the line across its end."""
    if end.way is None:
        return 0
    (x, y), found = end.way, 0
    for other in others:
        if other is not end and other.way is not None:
            a, b = _between(end.point, other.point)
            parallel = abs(x * other.way[0] + y * other.way[1]) > 1.0 - 1e-6
            found += parallel and abs(a * x + b * y) <= near
    return found


def _is_one(coordinate: float, values: Sequence[float], near: float) -> bool:
    return any(abs(coordinate - value) <= near for value in values)


def _turn(one: _End, other: _End) -> bool:
    """Whether both lines lead on towards the other one's end."""
    if one.way is None or other.way is None:
        return False
    x, y = _between(one.point, other.point)
    return one.way[0] * x + one.way[1] * y > 0.0 > other.way[0] * x + other.way[1] * y


def _rounded(one: _End, other: _End, near: float) -> Iterator[tuple[Circle, float, float]]:
    """The arc that both lines lead into."""
    if one.way is None or other.way is None:
        return
    across = _between(one.point, other.point)
    (ax, ay), (bx, by) = one.way, other.way
    cosine = ax * bx + ay * by
    if abs(cosine) < 1e-6:
        forth, back = across[0] * ax + across[1] * ay, across[0] * bx + across[1] * by
        # To the corner of both lines it is as far from either end.
        if forth > near and abs(forth + back) <= near:
            centre = one.point[0] - forth * bx, one.point[1] - forth * by
            yield from _arc(centre, forth, one.point, other.point)
    elif cosine > 1.0 - 1e-6 and abs(across[0] * ax + across[1] * ay) <= near:
        radius = hypot(*across) / 2.0
        centre = one.point[0] + across[0] / 2.0, one.point[1] + across[1] / 2.0
        first = centre[0] + radius * ax, centre[1] + radius * ay
        for end in (one.point, other.point):
            yield from _arc(centre, radius, end, first)


def _arc(
    centre: Point, radius: float, start: Point, end: Point
) -> Iterator[tuple[Circle, float, float]]:
    """The shorter way from a point of a circle to another one, cut where angles begin again."""
    circle = Circle(centre, radius)
    low, high = sorted((circle.parameter(start), circle.parameter(end)))
    if high - low <= pi:
        yield circle, low, high
        return
    if low > 1e-9:
        yield circle, 0.0, low
    if high < FULL_TURN - 1e-9:
        yield circle, high, FULL_TURN


def _is_edge(carriers: PartCarriers, normal: Axis, start: Point, end: Point, near: float) -> bool:
    """Whether both other planes draw a line over all of what two points of a plane span."""
    for coordinate, index in enumerate(IN_PLANE[normal]):
        plane = carriers.planes[Axis(IN_PLANE[normal][1 - coordinate])]
        place = IN_PLANE[plane.normal].index(index)
        low, high = sorted((start[coordinate], end[coordinate]))
        if not any(_covers(carrier, place, low, high, near) for carrier in plane.carriers):
            return False
    return True


def _covers(carrier: Carrier, place: int, low: float, high: float, near: float) -> bool:
    if not isinstance(carrier.curve, Line):
        return False
    for stretch in carrier.drawn():
        first, last = sorted(carrier.curve.at(at)[place] for at in stretch)
        if first <= low + near and high <= last + near:
            return True
    return False
