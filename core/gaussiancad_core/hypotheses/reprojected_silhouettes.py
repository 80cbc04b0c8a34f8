"""Slanted lines drawn again where oblique planes have their edges, and cones their outlines.

A corner of an oblique plane is read in three views, each time a little differently.  Once the plane
is known, the lines of all views follow from it; as they were read they would leave slivers between
the plane and its edges.  The outline of a cone is read twice in each of two views, and may end
early in one of them, where something cuts the cone.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot

from gaussiancad_core.cells.half_spaces import HalfSpace
from gaussiancad_core.cells.surfaces_of_revolution import SurfaceOfRevolution
from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.coordinates.drawn_intervals import (
    Carrier,
    Interval,
    nearest_station,
    stations_on,
)
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import MEETING, ON_CURVE, SAME_READ
from gaussiancad_core.geometry.whole_curves import Line, LineOrCircle, axis_line, line_through
from gaussiancad_core.hypotheses.oblique_planes import SHORT
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE


def retraced(
    carriers: PartCarriers,
    half_spaces: Sequence[HalfSpace],
    bodies: Sequence[SurfaceOfRevolution] = (),
) -> PartCarriers:
    """The carriers with those lines moved that are edges of half spaces, or outlines of bodies."""
    if not half_spaces and not bodies:
        return carriers
    reach = MEETING * carriers.tolerance
    planes = {}
    for axis, plane in carriers.planes.items():
        grid = [
            axis_line(index, value)
            for index, other in enumerate(IN_PLANE[axis])
            for value in carriers.values[Axis(other)]
        ]
        short = max(reach, SHORT * carriers.tolerance)
        outlines = _outlines(plane, bodies, SAME_READ * carriers.tolerance, short)
        lines = {**outlines, **_edges(plane, half_spaces, reach, short)}
        corners = [c for body in half_spaces for hull in body.outlines(axis) for c in hull]
        planes[axis] = _moved(plane, lines, _Ends(grid, corners, reach, short))
    return replace(carriers, planes=planes)


def _edges(
    plane: PlaneCarriers, half_spaces: Sequence[HalfSpace], reach: float, short: float
) -> dict[int, Line]:
    """The longest edge of a half space along each slanted line that misses it a little."""
    longest: dict[int, float] = {}
    found: dict[int, Line] = {}
    for body in half_spaces:
        for outline in body.outlines(plane.normal):
            for start, end in zip(outline, (*outline[1:], outline[0]), strict=True):
                if hypot(end[0] - start[0], end[1] - start[1]) < ON_CURVE:
                    # Seen from its end.
                    continue
                line = line_through(start, end)
                if line.axis is not None:
                    continue
                for index, carrier in enumerate(plane.carriers):
                    length = _length_along(carrier, start, end, reach, short)
                    if length > longest.get(index, 0.0):
                        longest[index], found[index] = length, line
    return _missed(plane, found)


def _outlines(
    plane: PlaneCarriers, bodies: Sequence[SurfaceOfRevolution], near: float, short: float
) -> dict[int, Line]:
    """The nearest outline of a body along each slanted line that misses it a little."""
    nearest: dict[int, float] = {}
    found: dict[int, Line] = {}
    for body in bodies:
        for line, (low, high) in body.rims(plane.normal):
            if not isinstance(line, Line) or line.axis is not None:
                continue
            for index, carrier in enumerate(plane.carriers):
                ends = _ends(carrier)
                if not isinstance(carrier.curve, Line) or not ends:
                    continue
                within = all(low - short <= line.parameter(end) <= high + short for end in ends)
                off = max(line.distance(end) for end in ends)
                if within and off <= nearest.get(index, near):
                    nearest[index], found[index] = off, line
    return _missed(plane, found)


def _missed(plane: PlaneCarriers, lines: dict[int, Line]) -> dict[int, Line]:
    """Those of the lines that carriers miss."""
    return {
        index: line
        for index, line in lines.items()
        if max(line.distance(end) for end in _ends(plane.carriers[index])) > ON_CURVE
    }


def _length_along(carrier: Carrier, start: Point, end: Point, reach: float, short: float) -> float:
    """Length of a segment that a slanted line is drawn along; 0 if it is not."""
    curve = carrier.curve
    if not isinstance(curve, Line) or curve.axis is not None:
        return 0.0
    if max(curve.distance(start), curve.distance(end)) > reach:
        return 0.0
    low, high = sorted((curve.parameter(start), curve.parameter(end)))
    along = any(first - short <= low and high <= last + short for first, last in carrier.drawn())
    return high - low if along else 0.0


def _ends(carrier: Carrier) -> list[Point]:
    return [carrier.curve.at(end) for stretch in carrier.drawn() for end in stretch]


@dataclass(frozen=True)
class _Ends:
    """Where lines of a plane may end.

    Attributes:
        grid: lines of the axes' values.
        corners: of half spaces.
        reach: units within which a line ends at another one.
        short: units by which a line that moved may end too early or too late at a corner.
    """

    grid: Sequence[LineOrCircle]
    corners: Sequence[Point]
    reach: float
    short: float


def _moved(plane: PlaneCarriers, lines: dict[int, Line], ends: _Ends) -> PlaneCarriers:
    """The plane with other lines; whatever ends at a line that moved ends there still."""
    if not lines:
        return plane
    curves = [lines.get(index, carrier.curve) for index, carrier in enumerate(plane.carriers)]
    moved = []
    for index, (carrier, curve) in enumerate(zip(plane.carriers, curves, strict=True)):
        stations = stations_on(curve, [*curves, *ends.grid])
        corners = []
        if index in lines:
            corners = sorted(
                curve.parameter(c) for c in ends.corners if curve.distance(c) < ON_CURVE
            )
        intervals = {
            role: tuple(
                _span(interval, carrier.curve, curve, (corners, stations), ends)
                for interval in this_spans
            )
            for role, this_spans in carrier.intervals.items()
        }
        moved.append(Carrier(curve, intervals))
    return replace(plane, carriers=tuple(moved))


def _span(
    interval: Interval,
    old: LineOrCircle,
    new: LineOrCircle,
    known: tuple[list[float], list[float]],
    ends: _Ends,
) -> Interval:
    """A span between corners of half spaces, or where the line meets others, or as it was."""
    if not isinstance(old, Line):
        # Circles stay; so do the places where their angles begin again.
        return interval
    corners, stations = known
    found = []
    for end in (interval.low, interval.high):
        at = new.parameter(old.at(end))
        corner = nearest_station(corners, at, ends.short)
        found.append(corner if corner in corners else nearest_station(stations, at, ends.reach))
    low, high = sorted(found)
    return replace(interval, low=low, high=high)
