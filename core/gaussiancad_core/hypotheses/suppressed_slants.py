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

from gaussiancad_core.coordinates.carrier_curves import LineCurve, Point, line_through
from gaussiancad_core.coordinates.carriers import PartSupports, PlaneSupports
from gaussiancad_core.coordinates.drawn_intervals import Span, Support, nearest_station, stations_on
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Linetype

MOST = 24.0
"""Tolerances up to which a line may have been lost."""

LEAST = 2.0
"""Tolerances from which a line counts."""

SAME = 1.5
"""Tolerances within which two views show the same end, and lines are one."""


_CHANCE = 12
"""Lines of a view that may be lost; where more would be, ends agree by chance."""

_LOOKED_AT = 2000
"""Edges that are looked at for a view."""

_REACH = 3.0
"""Tolerances within which a line ends at another one."""


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


def with_untold_lines(supports: PartSupports) -> PartSupports:
    """The supports with lines that may be drawn; their spans have no confidence."""
    if len(supports.planes) < len(Axis):
        return supports
    most = MOST * supports.tolerance
    planes = {
        axis: _completed(
            plane, islice(slanted_edges(supports, axis, most), _LOOKED_AT), supports.tolerance
        )
        for axis, plane in supports.planes.items()
    }
    return replace(supports, planes=planes)


def slanted_edges(
    supports: PartSupports, shared: Axis, most: float
) -> Iterator[tuple[Point, Point]]:
    """Edges, as the view along an axis should show them, that both other views show over it.

    Args:
        supports: of all planes.
        shared: that axis.
        most: units that such an edge is long in any view, at most.
    """
    near, least = (k * supports.tolerance for k in (SAME, LEAST))
    one, other = (Axis(index) for index in IN_PLANE[shared])
    firsts = _edges(supports.planes[other], shared, most)
    seconds = sorted(_edges(supports.planes[one], shared, most), key=lambda edge: edge.low)
    lows = [edge.low for edge in seconds]
    for first in firsts:
        at = slice(bisect_left(lows, first.low - near), bisect_right(lows, first.low + near))
        for second in seconds[at]:
            start, end = (first.at_low, second.at_low), (first.at_high, second.at_high)
            length = hypot(end[0] - start[0], end[1] - start[1])
            if abs(first.high - second.high) <= near and least < length < most:
                yield start, end


def _edges(plane: PlaneSupports, over: Axis, most: float) -> Iterator[_Edge]:
    """Edges over an axis that rise by no more than ``most``."""
    place = IN_PLANE[plane.normal].index(over.value)
    for support in plane.supports:
        if not isinstance(support.curve, LineCurve) or support.curve.axis is not None:
            continue
        cuts = stations_on(support.curve, [other.curve for other in plane.supports])
        for start, end in support.drawn():
            ends = {start, end, *(at for at in cuts if start < at < end)}
            points = sorted((p[place], p[1 - place]) for p in map(support.curve.at, ends))
            for low, high in combinations(points, 2):
                if abs(high[1] - low[1]) < most:
                    yield _Edge(low[0], high[0], low[1], high[1])


def _completed(
    plane: PlaneSupports, missing: Iterable[tuple[Point, Point]], tolerance: float
) -> PlaneSupports:
    found = list(plane.supports)
    for start, end in missing:
        line = line_through(start, end)
        if line.axis is not None or any(
            shows(support, start, end, SAME * tolerance) for support in found
        ):
            continue
        stations = stations_on(line, [support.curve for support in plane.supports])
        low, high = sorted(
            nearest_station(stations, line.parameter(end), _REACH * tolerance)
            for end in (start, end)
        )
        if high - low < LEAST * tolerance:
            # Both ends belong to one corner.
            continue
        span = Span(low, high, Linetype.HIDDEN, 0.0)
        spans: dict[Role, tuple[Span, ...]] = {role: (span,) for role in plane.roles}
        found.append(Support(line, spans))
        if len(found) > len(plane.supports) + _CHANCE:
            return plane
    return replace(plane, supports=tuple(found))


def shows(support: Support, start: Point, end: Point, near: float) -> bool:
    """Whether a line runs along an edge, so that the edge would be on it."""
    curve = support.curve
    if max(curve.distance(start), curve.distance(end)) > near:
        return False
    middle = curve.parameter(((start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0))
    return any(low - near <= middle <= high + near for low, high in support.drawn())
