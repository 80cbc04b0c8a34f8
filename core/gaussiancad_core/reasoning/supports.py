"""Supports: the lines and circles that the strokes of a plane's views lie on.

Collinear strokes share one support, strokes on one circle too.  A support is the trace of a surface
that is seen edge-on: a plane for a line, a cylinder for a circle.  Where strokes end is computed
again from the supports that they end at; the ends as read are not used but to choose among those.
"""

from bisect import bisect_left
from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot, pi

import numpy as np

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.chains import Chain, single_runs
from gaussiancad_core.reasoning.curves import (
    TURN,
    CircleCurve,
    LineCurve,
    PlaneCurve,
    Point,
    axis_line,
    line_through,
    meetings,
)
from gaussiancad_core.reasoning.derived import Vertices, with_derived_values
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.planes import IN_PLANE, UNITS, plane_points, role_plane
from gaussiancad_core.reasoning.snapping import CircleReading, Reading, Snapped, snapped
from gaussiancad_core.reasoning.tangents import tangent_line
from gaussiancad_core.views import Arc, Linetype, Segment

_FOLDED = 0.01
"""Units within which the way back of a curve runs along its way out."""

_SHORT = 1.0
"""Tolerances that a stroke is long at least to be taken at all."""

_SHORT_SLANT = 0.5
"""Units that a slanted segment is long at least to tell a plane; shorter ones are boundaries."""

_CHAIN_LINKS = 128
"""Links of a chain."""

_DERIVED = 0.5
"""Tolerances by which a value may miss what it follows from."""

_DROPPED = 0.03
"""Units of line that a drawing may leave out at the ends of strokes."""

_FLAT = 4.0
"""Tolerances of rise that an arc has at least to tell a circle; flatter ones are boundaries."""

_WEIGHTY_SWEEP = pi
"""Sweep from which an arc tells its circle well; flatter ones count less, by its fourth power."""


@dataclass(frozen=True)
class Span:
    """A stretch of a support that a view draws.

    Attributes:
        low, high: parameters of the support's curve; 0 to 2 pi on circles.
        linetype: how it is drawn.
        confidence: 0 to 1.
    """

    low: float
    high: float
    linetype: Linetype
    confidence: float


@dataclass(frozen=True)
class Support:
    """A curve with what the views draw on it.

    Attributes:
        curve: line or circle, in plane units.
        spans: of each view of the plane.
    """

    curve: PlaneCurve
    spans: dict[Role, tuple[Span, ...]]

    def drawn(self, reach: float = 1e-4) -> list[tuple[float, float]]:
        """The stretches that any view draws, merged, ascending."""
        return merged_stretches(
            ((span.low, span.high) for spans in self.spans.values() for span in spans),
            reach / self.curve.speed,
        )

    def linetype_at(self, role: Role, parameter: float, reach: float = 1e-4) -> Linetype | None:
        """What a view draws at a parameter; visible lines hide hidden ones under them."""
        slack = reach / self.curve.speed
        found = None
        for span in self.spans.get(role, ()):
            if span.low - slack <= parameter <= span.high + slack:
                if span.linetype is Linetype.VISIBLE:
                    return Linetype.VISIBLE
                found = Linetype.HIDDEN
        return found


@dataclass(frozen=True)
class PlaneSupports:
    """What is drawn in one projection plane.

    Attributes:
        normal: axis that the plane's views look along.
        roles: its views.
        supports: lines and circles.
        chains: drawn curves that are neither: projections of intersection curves and silhouettes;
            (role, points, linetype).
    """

    normal: Axis
    roles: tuple[Role, ...]
    supports: tuple[Support, ...]
    chains: tuple[tuple[Role, Chain, Linetype], ...]


@dataclass(frozen=True)
class PartSupports:
    """The supports of all planes.

    Attributes:
        planes: one for each axis that views look along.
        values: of each axis that lines parallel to it have.
        size: (3,) of the part in units.
        scale: units per mm.
        tolerance: units.
    """

    planes: dict[Axis, PlaneSupports]
    values: dict[Axis, tuple[float, ...]]
    size: tuple[float, float, float]
    scale: float
    tolerance: float


def merged_stretches(
    stretches: Iterable[tuple[float, float]], slack: float
) -> list[tuple[float, float]]:
    """Intervals that overlap or lie within ``slack`` of each other as one, ascending."""
    merged: list[list[float]] = []
    for low, high in sorted(stretches):
        if merged and low <= merged[-1][1] + slack:
            merged[-1][1] = max(merged[-1][1], high)
        else:
            merged.append([low, high])
    return [(low, high) for low, high in merged]


@dataclass(frozen=True)
class _Line:
    role: Role
    start: Point
    end: Point
    linetype: Linetype
    confidence: float

    @property
    def length(self) -> float:
        return hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])


@dataclass(frozen=True)
class _Circle:
    role: Role
    circle: CircleCurve
    low: float
    sweep: float
    linetype: Linetype
    confidence: float

    @property
    def weight(self) -> float:
        quality = min(1.0, self.sweep / _WEIGHTY_SWEEP) ** 4
        return quality * self.circle.radius * self.sweep


@dataclass
class _Plane:
    """The strokes of a plane by kind."""

    normal: Axis
    roles: list[Role]
    lines: list[_Line]
    circles: list[_Circle]
    chains: list[tuple[Role, Chain, Linetype]]


def find_supports(views: DrawnViews) -> PartSupports:
    """Supports of the strokes of all views, in shared coordinates."""
    scale = UNITS / max(views.size)
    tolerance = views.tolerance * scale
    planes = _sorted_strokes(views, scale, tolerance)
    size = tuple(extent * scale for extent in views.size)
    snap = _snap(planes, size, tolerance)
    found = {
        axis: PlaneSupports(
            axis, tuple(plane.roles), _supports(plane, snap, tolerance), tuple(plane.chains)
        )
        for axis, plane in planes.items()
    }
    return PartSupports(found, snap.values, size, scale, tolerance)


def _sorted_strokes(views: DrawnViews, scale: float, tolerance: float) -> dict[Axis, _Plane]:
    planes: dict[Axis, _Plane] = {}
    for role, strokes in views.strokes.items():
        normal = role_plane(role).normal
        plane = planes.setdefault(normal, _Plane(normal, [], [], [], []))
        plane.roles.append(role)
        for stroke in strokes:
            if stroke.length * scale <= _SHORT * tolerance:
                continue
            line = _line(stroke, role, scale) if isinstance(stroke, Segment) else None
            if line is not None and _tells_line(line, tolerance):
                plane.lines.append(line)
            elif isinstance(stroke, Arc) and _tells_circle(stroke, scale, tolerance):
                plane.circles.append(_circle(stroke, role, scale))
            else:
                points = plane_points(stroke.sample(stroke.length / _CHAIN_LINKS), role, scale)
                for chain in single_runs(points, max(_FOLDED, tolerance)):
                    plane.chains.append((role, chain, stroke.linetype))
    return planes


def _line(stroke: Segment, role: Role, scale: float) -> _Line:
    start, end = plane_points(np.array([stroke.start, stroke.end]), role, scale)
    ends = (float(start[0]), float(start[1])), (float(end[0]), float(end[1]))
    return _Line(role, *ends, stroke.linetype, stroke.confidence)


def _tells_line(line: _Line, tolerance: float) -> bool:
    return line.length >= _SHORT_SLANT or _parallel_axis(line, tolerance) is not None


def _tells_circle(arc: Arc, scale: float, tolerance: float) -> bool:
    rise = arc.radius * scale * (1.0 - np.cos(min(arc.sweep, TURN) / 2.0))
    return bool(rise > _FLAT * tolerance)


def _circle(arc: Arc, role: Role, scale: float) -> _Circle:
    """An arc in plane coordinates, which turn its angles where the view is mirrored in them."""
    signs = role_plane(role).signs
    (centre,) = plane_points(np.array([arc.centre]), role, scale)
    ends = (arc.start_angle, arc.start_angle + arc.sweep)
    mirrored = signs[0] * signs[1] < 0
    first = ends[1] if mirrored else ends[0]
    low = np.arctan2(signs[1] * np.sin(first), signs[0] * np.cos(first)) % TURN
    curve = CircleCurve((float(centre[0]), float(centre[1])), arc.radius * scale)
    return _Circle(role, curve, float(low), min(arc.sweep, TURN), arc.linetype, arc.confidence)


def _snap(
    planes: dict[Axis, _Plane], size: tuple[float, float, float], tolerance: float
) -> Snapped:
    readings = []
    for axis in Axis:
        # The bounding box is where the views were registered; it counts as much as it is long.
        readings += [Reading(axis, 0.0, UNITS), Reading(axis, size[axis.value], UNITS)]
    circles = []
    for plane in planes.values():
        axes = tuple(Axis(index) for index in IN_PLANE[plane.normal])
        for line in plane.lines:
            along = _parallel_axis(line, tolerance)
            if along is not None:
                value = (line.start[along] + line.end[along]) / 2.0
                readings.append(Reading(axes[along], value, line.length * line.confidence))
        circles += [CircleReading(plane.normal, c.circle, c.weight) for c in plane.circles]
    snap = snapped(readings, circles, tolerance)
    return with_derived_values(
        snap, [_vertices(p, snap, tolerance) for p in planes.values()], tolerance
    )


def _vertices(plane: _Plane, snap: Snapped, tolerance: float) -> Vertices:
    curves: list[PlaneCurve] = [c for normal, c in snap.circles if normal is plane.normal]
    points: list[Point] = []
    slanted = []
    for line in plane.lines:
        points += [line.start, line.end]
        if _parallel_axis(line, tolerance) is None:
            slanted.append(line)
    for circle in plane.circles:
        points += [circle.circle.at(circle.low), circle.circle.at(circle.low + circle.sweep)]
    axes = tuple(Axis(index) for index in IN_PLANE[plane.normal])
    known = [curve for curve in curves if isinstance(curve, CircleCurve)]
    curves += [_slanted_line(g, axes, snap, known) for g in _collinear(slanted, tolerance)]
    return Vertices(plane.normal, tuple(curves), tuple(points))


def _parallel_axis(line: _Line, tolerance: float) -> int | None:
    """The coordinate (0, 1) that is the same along a line, within the tolerance."""
    off = [abs(line.end[index] - line.start[index]) for index in (0, 1)]
    flat = 0 if off[0] < off[1] else 1
    if off[flat] <= min(tolerance, 0.2 * off[1 - flat]):
        return flat
    return None


def _supports(plane: _Plane, snap: Snapped, tolerance: float) -> tuple[Support, ...]:
    circles = [(snap.circle(plane.normal, c.circle) or c.circle, c) for c in plane.circles]
    curves: list[PlaneCurve] = []
    strokes: list[tuple[int, _Line | _Circle]] = []
    for circle, stroke in circles:
        if circle not in curves:
            curves.append(circle)
        strokes.append((curves.index(circle), stroke))
    axes = tuple(Axis(index) for index in IN_PLANE[plane.normal])
    slanted = []
    for line in plane.lines:
        along = _parallel_axis(line, tolerance)
        if along is None:
            slanted.append(line)
            continue
        reading = (line.start[along] + line.end[along]) / 2.0
        value = snap.value(axes[along], reading)
        curve = axis_line(along, reading if value is None else value)
        if curve not in curves:
            curves.append(curve)
        strokes.append((curves.index(curve), line))
    known = [circle for circle, _ in circles]
    for group in _collinear(slanted, tolerance):
        curves.append(_slanted_line(group, axes, snap, known))
        strokes += [(len(curves) - 1, line) for line in group]
    grid = [axis_line(index, value) for index in (0, 1) for value in snap.values[axes[index]]]
    return _with_spans(curves, strokes, grid, tolerance)


def _collinear(lines: list[_Line], tolerance: float) -> list[list[_Line]]:
    """Slanted strokes in groups that lie on one line."""
    groups: list[tuple[LineCurve, list[_Line]]] = []
    for line in sorted(lines, key=lambda stroke: -stroke.length):
        for curve, group in groups:
            off = max(curve.distance(line.start), curve.distance(line.end))
            direction = line_through(line.start, line.end).direction
            sine = abs(curve.direction[0] * direction[1] - curve.direction[1] * direction[0])
            if off <= 1.5 * tolerance and sine * line.length <= 1.5 * tolerance:
                group.append(line)
                break
        else:
            groups.append((line_through(line.start, line.end), [line]))
    return [group for _, group in groups]


def _slanted_line(
    group: list[_Line], axes: tuple[Axis, ...], snap: Snapped, circles: list[CircleCurve]
) -> LineCurve:
    """The line of collinear strokes: between values that its ends lie at, or along circles."""
    leader = group[0]
    rough = line_through(leader.start, leader.end)
    ends = sorted((end for line in group for end in (line.start, line.end)), key=rough.parameter)
    first, last = (
        tuple(
            found if (found := snap.value(axis, end[index])) is not None else end[index]
            for index, axis in enumerate(axes)
        )
        for end in (ends[0], ends[-1])
    )
    touching = tangent_line(rough, (first, last), circles, snap.reach)
    return touching or line_through(first, last)


def _with_spans(
    curves: list[PlaneCurve],
    strokes: list[tuple[int, _Line | _Circle]],
    grid: list[PlaneCurve],
    tolerance: float,
) -> tuple[Support, ...]:
    reach = max(3.0 * tolerance, _DROPPED)
    stations = [stations_on(curve, [*curves, *grid]) for curve in curves]
    spans: list[dict[Role, list[Span]]] = [{} for _ in curves]
    for index, stroke in strokes:
        curve = curves[index]
        own = spans[index].setdefault(stroke.role, [])
        slack = reach / curve.speed
        if isinstance(stroke, _Line):
            low, high = sorted((curve.parameter(stroke.start), curve.parameter(stroke.end)))
            pairs = [
                (
                    nearest_station(stations[index], low, slack),
                    nearest_station(stations[index], high, slack),
                )
            ]
        else:
            pairs = _arc_pairs(stroke, stations[index], slack)
        for low, high in pairs:
            if high - low > 1e-9:
                own.append(Span(low, high, stroke.linetype, stroke.confidence))
    return tuple(
        Support(curve, {role: tuple(own) for role, own in by_role.items()})
        for curve, by_role in zip(curves, spans, strict=True)
    )


def _arc_pairs(stroke: _Circle, stations: list[float], slack: float) -> list[tuple[float, float]]:
    """Ends of an arc on its circle, cut where angles begin again."""
    if stroke.sweep >= TURN - slack:
        return [(0.0, TURN)]
    around = [s + turn for turn in (-TURN, 0.0, TURN) for s in stations]
    low = nearest_station(around, stroke.low, slack)
    high = nearest_station(around, stroke.low + stroke.sweep, slack)
    turns = np.floor(low / TURN + 1e-12) * TURN
    low, high = max(0.0, low - turns), high - turns
    if high <= TURN + 1e-12:
        return [(low, min(high, TURN))]
    return [(low, TURN), (0.0, high - TURN)]


def stations_on(curve: PlaneCurve, others: list[PlaneCurve]) -> list[float]:
    """Parameters where a curve meets others, ascending."""
    found = {
        curve.parameter(point)
        for other in others
        if other != curve
        for point in meetings(curve, other)
    }
    return sorted(found)


def nearest_station(stations: list[float], parameter: float, slack: float) -> float:
    """The station nearest to a parameter, or the parameter where none is within ``slack``."""
    at = bisect_left(stations, parameter)
    near = stations[max(0, at - 1) : at + 1]
    best = min(near, key=lambda station: abs(station - parameter), default=parameter)
    return best if abs(best - parameter) <= slack else parameter
