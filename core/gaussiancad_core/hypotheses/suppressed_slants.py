"""Short slanted lines that two views tell and a picture of the third leaves out.

A slanted edge that two views show has its ends in space, and so in the third view.  There its line
may be too short to be read, a dash or two of a hidden edge; without it the plane that stands on it
would be missing.  It is added as a line that may be drawn or not.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import combinations, islice
from math import hypot

from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import (
    Carrier,
    Interval,
    nearest_station,
    stations_on,
)
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import MEETING, SAME_READ
from gaussiancad_core.geometry.whole_curves import Line, line_through
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Linetype

MOST = 24.0
"""Tolerances up to which a line may have been lost."""

LEAST = 2.0
"""Tolerances from which a line counts."""

MOST_LOST = 16
"""Lines of a view that may be lost; where more would be, ends agree by chance."""

EDGES = 4000
"""Edges that are looked at for a view."""


@dataclass(frozen=True)
class _Edge:
    """A slanted stretch between two lines that it meets, over one of its coordinates.

    Attributes:
        low, high: of that coordinate, ascending.
        at_low, at_high: the other coordinate there.
    """

    low: float
    high: float
    at_low: float
    at_high: float


def with_suppressed_slants(carriers: PartCarriers) -> PartCarriers:
    """The carriers with lines that may be drawn; their spans have no confidence."""
    if len(carriers.planes) < len(Axis):
        return carriers
    most = MOST * carriers.tolerance
    planes = {
        axis: _completed(
            plane, islice(slanted_edges(carriers, axis, most), EDGES), carriers.tolerance
        )
        for axis, plane in carriers.planes.items()
    }
    return replace(carriers, planes=planes)


def slanted_edges(
    carriers: PartCarriers, shared: Axis, most: float
) -> Iterator[tuple[Point, Point]]:
    """Edges, as the view along an axis should show them, that both other views show over it.

    Args:
        carriers: of all planes.
        shared: that axis.
        most: units that such an edge is long in any view, at most.
    """
    near, least = (k * carriers.tolerance for k in (SAME_READ, LEAST))
    one, other = (Axis(index) for index in IN_PLANE[shared])
    firsts = _edges(carriers.planes[other], shared, most)
    seconds = sorted(_edges(carriers.planes[one], shared, most), key=lambda edge: edge.low)
    lows = [edge.low for edge in seconds]
    for first in firsts:
        at = slice(bisect_left(lows, first.low - near), bisect_right(lows, first.low + near))
        for second in seconds[at]:
            start, end = (first.at_low, second.at_low), (first.at_high, second.at_high)
            length = hypot(end[0] - start[0], end[1] - start[1])
            if abs(first.high - second.high) <= near and least < length < most:
                yield start, end


def _edges(plane: PlaneCarriers, over: Axis, most: float) -> Iterator[_Edge]:
    """Edges over an axis that rise by no more than ``most``."""
    place = IN_PLANE[plane.normal].index(over.value)
    for carrier in plane.carriers:
        if not isinstance(carrier.curve, Line) or carrier.curve.axis is not None:
            continue
        cuts = stations_on(carrier.curve, [other.curve for other in plane.carriers])
        for start, end in carrier.drawn():
            ends = {start, end, *(at for at in cuts if start < at < end)}
            points = sorted((p[place], p[1 - place]) for p in map(carrier.curve.at, ends))
            for low, high in combinations(points, 2):
                if abs(high[1] - low[1]) < most:
                    yield _Edge(low[0], high[0], low[1], high[1])


def _completed(
    plane: PlaneCarriers, missing: Iterable[tuple[Point, Point]], tolerance: float
) -> PlaneCarriers:
    found = list(plane.carriers)
    for start, end in missing:
        line = line_through(start, end)
        if line.axis is not None or any(
            shows(carrier, start, end, SAME_READ * tolerance) for carrier in found
        ):
            continue
        stations = stations_on(line, [carrier.curve for carrier in plane.carriers])
        low, high = sorted(
            nearest_station(stations, line.parameter(end), MEETING * tolerance)
            for end in (start, end)
        )
        if high - low < LEAST * tolerance:
            # Both ends belong to one corner.
            continue
        interval = Interval(low, high, Linetype.HIDDEN, 0.0)
        intervals: dict[Role, tuple[Interval, ...]] = {role: (interval,) for role in plane.roles}
        found.append(Carrier(line, intervals))
        if len(found) > len(plane.carriers) + MOST_LOST:
            return plane
    return replace(plane, carriers=tuple(found))


def shows(carrier: Carrier, start: Point, end: Point, near: float) -> bool:
    """Whether a line runs along an edge, so that the edge would be on it."""
    curve = carrier.curve
    if max(curve.distance(start), curve.distance(end)) > near:
        return False
    middle = curve.parameter(((start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0))
    return any(low - near <= middle <= high + near for low, high in carrier.drawn())
