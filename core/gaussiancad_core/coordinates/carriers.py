"""Carriers: the lines and circles that the strokes of a plane's views lie on.

Collinear strokes share one carrier, strokes on one circle too.  A carrier is the trace of a surface
that is seen edge-on: a plane for a line, a cylinder for a circle.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi

import numpy as np

from gaussiancad_core.coordinates.along_circles import arc_along
from gaussiancad_core.coordinates.chords import find_chords
from gaussiancad_core.coordinates.constrained_places import ConstrainedPlaces
from gaussiancad_core.coordinates.coordinate_clustering import (
    CircleReading,
    CoordinateReading,
    Snapped,
    snapped,
    with_lone_values,
)
from gaussiancad_core.coordinates.corner_equations import Slant, crossings
from gaussiancad_core.coordinates.design_step import NominalStep, designed_scale
from gaussiancad_core.coordinates.drawn_intervals import (
    Carrier,
    DrawnInterval,
    carriers_with_intervals,
)
from gaussiancad_core.coordinates.geometric_constraints import (
    Adjusted,
    Facet,
    PlaneReading,
    adjusted,
)
from gaussiancad_core.coordinates.point_chains import Chain, single_runs
from gaussiancad_core.coordinates.roundings import is_quarter, is_rounding
from gaussiancad_core.coordinates.skewed_dashes import without_askew_dashes
from gaussiancad_core.coordinates.split_arcs import is_piece, with_pieces_of_arcs
from gaussiancad_core.coordinates.tangents import touched_circles
from gaussiancad_core.evidence.dimension_constraints import DimensionConstraints
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.points import FULL_TURN, to_point
from gaussiancad_core.geometry.tolerances import APART, SAME_PLACE, TELLING
from gaussiancad_core.geometry.whole_curves import (
    Line,
    LineOrCircle,
    axis_line,
    line_through,
)
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, UNITS, plane_points, role_plane
from gaussiancad_core.model.views import Arc, Linetype, Segment

_SHORT_SLANT, _SHORT_SLANT_READ = 0.2, 2.5
"""Units and tolerances that a slanted segment is long at least to tell a plane; shorter ones are
boundaries."""

_CHAIN_LINKS = 128
"""Links of a chain."""

_END_WEIGHT = 1e-3
"""Weight of a coordinate that only ends of slanted lines tell: all else counts more."""

_WEIGHTY_SWEEP = pi
"""Sweep from which an arc tells its circle well; flatter ones count less, by its fourth power."""


@dataclass(frozen=True)
class PlaneCarriers:
    """What is drawn in one projection plane.

    Attributes:
        normal: axis that the plane's views look along.
        roles: its views.
        carriers: lines and circles.
        chains: drawn curves that are neither: projections of intersection curves and silhouettes;
            (role, points, linetype).
        lost: (number of the carrier, low, high) of stretches that no view draws and one may lack.
    """

    normal: Axis
    roles: tuple[Role, ...]
    carriers: tuple[Carrier, ...]
    chains: tuple[tuple[Role, Chain, Linetype], ...]
    lost: tuple[tuple[int, float, float], ...] = ()


@dataclass(frozen=True)
class PartCarriers:
    """The carriers of all planes.

    Attributes:
        planes: one for each axis that views look along.
        values: of each axis that lines parallel to it have.
        size: (3,) of the part in units.
        scale: units per mm.
        tolerance: units.
        nominal: whether all values and circles are multiples of the step: they are known exactly.
        step: that the part was designed in; None where none is told.
        odd: how many values, and numbers of circles, are no multiples of it, mirror images once.
        moved: units by which values moved, at the mean, that most likely are round but not surely.
        unread: whether values are multiples of the step only as the sheet's dimensions say.
        places: that follow from what these say; None where they say nothing.
    """

    planes: dict[Axis, PlaneCarriers]
    values: dict[Axis, tuple[float, ...]]
    size: tuple[float, float, float]
    scale: float
    tolerance: float
    nominal: bool = False
    step: NominalStep | None = None
    odd: int = 0
    moved: float = 0.0
    unread: bool = False
    places: ConstrainedPlaces | None = None


@dataclass(frozen=True, kw_only=True)
class _Line(Segment):
    role: Role


@dataclass(frozen=True, kw_only=True)
class _Arc(Arc):
    role: Role

    @property
    def weight(self) -> float:
        return min(1.0, self.sweep / _WEIGHTY_SWEEP) ** 4 * self.length


@dataclass
class _Plane:
    """The strokes of a plane by kind."""

    normal: Axis
    roles: list[Role]
    lines: list[_Line]
    arcs: list[_Arc]
    chains: list[tuple[Role, Chain, Linetype]]


def find_carriers(views: DrawnViews, facets: Sequence[Facet] = ()) -> PartCarriers:
    """Supports of the strokes of all views, in shared coordinates.

    Args:
        views: whose strokes are taken.
        facets: faces that are edge-on in no view, as far as they are known.
    """
    scale = UNITS / max(views.size)
    tolerance = views.tolerance * scale
    views = with_pieces_of_arcs(without_askew_dashes(views))
    planes = _sorted_strokes(views, scale, tolerance)
    width, depth, height = views.size
    size = width * scale, depth * scale, height * scale
    apart = None if views.apart is None else views.apart * scale
    noise = views.noise * scale if views.likely else 0.0
    stated = None if views.dimensions is None else views.dimensions.scaled(scale)
    scaled = views.known is not None or stated is not None
    limits = tolerance, apart
    snap = _snap(planes, size, scale, limits, noise=noise, stated=stated, scaled=scaled)
    shown = [
        _plane_reading(plane, tolerance).moved(
            *(-snap.begins.get(Axis(index), 0.0) for index in IN_PLANE[plane.normal])
        )
        for plane in planes.values()
    ]
    lone = [reading for plane in shown for reading in _slant_ends(plane, snap)]
    known = adjusted(with_lone_values(snap, lone), shown, tolerance, facets)
    found = {
        axis: PlaneCarriers(
            axis, tuple(plane.roles), _supports(plane, known, tolerance), tuple(plane.chains)
        )
        for axis, plane in planes.items()
    }
    snapped = known.snap
    if views.known is not None:
        known_size = size[views.known.value], views.size[views.known.value]
        scale = designed_scale(snapped.step, known_size, scale)
    return PartCarriers(
        found,
        snapped.values,
        size,
        scale,
        tolerance,
        snapped.nominal,
        snapped.step,
        snapped.odd_numbers,
        snapped.moved,
        snapped.unread,
        snapped.places,
    )


def _sorted_strokes(views: DrawnViews, scale: float, tolerance: float) -> dict[Axis, _Plane]:
    planes: dict[Axis, _Plane] = {}
    chords = find_chords(views.strokes, views.tolerance)
    for role, strokes in views.strokes.items():
        normal = role_plane(role).normal
        plane = planes.setdefault(normal, _Plane(normal, [], [], [], []))
        plane.roles.append(role)
        followed: set[int] = set()
        for run in chords:
            if run.role is role:
                followed.update(range(run.first, run.last + 1))
                chain = tuple(map(tuple, plane_points(run.points, role, scale).tolist()))
                plane.chains.append((role, chain, strokes[run.first].linetype))
        for number, stroke in enumerate(strokes):
            if number in followed or stroke.length * scale <= tolerance:
                continue
            line = _line(stroke, role, scale) if isinstance(stroke, Segment) else None
            if line is not None and _is_long_enough(line, tolerance):
                plane.lines.append(line)
            elif isinstance(stroke, Arc) and (
                _is_round_enough(stroke, scale, tolerance)
                or is_rounding(stroke, strokes, views.tolerance)
                or is_piece(stroke, strokes, views)
            ):
                plane.arcs.append(_arc(stroke, role, scale))
            else:
                points = plane_points(stroke.sample(stroke.length / _CHAIN_LINKS), role, scale)
                for chain in single_runs(points, max(SAME_PLACE, tolerance)):
                    plane.chains.append((role, chain, stroke.linetype))
    for plane in planes.values():
        _take_arcs(plane, max(APART, tolerance))
    return planes


def _take_arcs(plane: _Plane, near: float) -> None:
    """Make arcs of chains that run along a drawn circle."""
    drawn, chains = [arc.carrier for arc in plane.arcs], plane.chains
    plane.chains = []
    for role, chain, linetype in chains:
        for circle in drawn:
            found = arc_along(chain, circle, near)
            if found is not None:
                plane.arcs.append(_Arc(circle.centre, circle.radius, *found, linetype, role=role))
                break
        else:
            plane.chains.append((role, chain, linetype))


def _line(stroke: Segment, role: Role, scale: float) -> _Line:
    start, end = plane_points(np.array([stroke.start, stroke.end]), role, scale)
    ends = (float(start[0]), float(start[1])), (float(end[0]), float(end[1]))
    return _Line(*ends, stroke.linetype, stroke.confidence, role=role)


def _is_long_enough(line: _Line, tolerance: float) -> bool:
    least = max(_SHORT_SLANT, _SHORT_SLANT_READ * tolerance)
    return line.length >= least or _parallel_axis(line, tolerance) is not None


def _is_round_enough(arc: Arc, scale: float, tolerance: float) -> bool:
    rise = arc.radius * scale * (1.0 - np.cos(min(arc.sweep, FULL_TURN) / 2.0))
    return bool(rise > TELLING * tolerance) or is_quarter(arc, tolerance / scale)


def _arc(arc: Arc, role: Role, scale: float) -> _Arc:
    """An arc in plane coordinates, which turn its angles where the view is mirrored in them."""
    signs = role_plane(role).signs
    (centre,) = plane_points(np.array([arc.centre]), role, scale)
    ends = (arc.start_angle, arc.start_angle + arc.sweep)
    mirrored = signs[0] * signs[1] < 0
    first = ends[1] if mirrored else ends[0]
    low = np.arctan2(signs[1] * np.sin(first), signs[0] * np.cos(first)) % FULL_TURN
    piece = to_point(centre), arc.radius * scale, float(low), min(arc.sweep, FULL_TURN)
    return _Arc(*piece, arc.linetype, arc.confidence, role=role)


def _snap(
    planes: dict[Axis, _Plane],
    size: tuple[float, float, float],
    scale: float,
    limits: tuple[float, float | None],
    *,
    noise: float,
    stated: DimensionConstraints | None,
    scaled: bool,
) -> Snapped:
    """Values and circles, with what lies together made equal."""
    tolerance, apart = limits
    readings = []
    for axis in Axis:
        # The bounding box is where the views were registered; it counts as much as it is long.
        readings += [
            CoordinateReading(axis, 0.0, UNITS),
            CoordinateReading(axis, size[axis.value], UNITS),
        ]
    circles = []
    for plane in planes.values():
        axes = tuple(Axis(index) for index in IN_PLANE[plane.normal])
        for line in plane.lines:
            along = _parallel_axis(line, tolerance)
            if along is not None and line.confidence > 0.0:
                value = (line.start[along] + line.end[along]) / 2.0
                readings.append(
                    CoordinateReading(axes[along], value, line.length * line.confidence)
                )
        circles += [CircleReading(plane.normal, arc.carrier, arc.weight) for arc in plane.arcs]
    return snapped(
        readings, circles, tolerance, apart, scale, noise=noise, stated=stated, scaled=scaled
    )


def _plane_reading(plane: _Plane, tolerance: float) -> PlaneReading:
    ends = [end for line in plane.lines for end in (line.start, line.end)]
    for arc in plane.arcs:
        ends += [to_point(end) for end in arc.extremes()[:2]]
    slants = tuple(_slant(group) for group in _collinear(_slanted(plane, tolerance), tolerance))
    ends += crossings(slants)
    arcs = tuple((arc.carrier, arc.start_angle, arc.sweep) for arc in plane.arcs)
    return PlaneReading(plane.normal, slants, tuple(ends), arcs)


def _slanted(plane: _Plane, tolerance: float) -> list[_Line]:
    return [line for line in plane.lines if _parallel_axis(line, tolerance) is None]


def _slant(group: list[_Line]) -> Slant:
    """The line of collinear strokes, the longest first."""
    rough = line_through(group[0].start, group[0].end)
    ends = sorted((end for line in group for end in (line.start, line.end)), key=rough.parameter)
    return Slant(ends[0], ends[-1], sum(line.length * line.confidence for line in group))


def _slant_ends(plane: PlaneReading, snap: Snapped) -> Iterator[CoordinateReading]:
    """Coordinates of ends of slanted lines, which nothing else may tell.

    Where a line touches a circle there is no corner.
    """
    axes = [Axis(index) for index in IN_PLANE[plane.normal]]
    circles = [circle for normal, circle in snap.circles if normal is plane.normal]
    for slant in plane.slants:
        ends = slant.start, slant.end
        touched = touched_circles(line_through(*ends), ends, circles, snap.reach)
        for end, circle in zip(ends, touched, strict=True):
            if circle is None:
                for axis, coordinate in zip(axes, end, strict=True):
                    yield CoordinateReading(axis, coordinate, _END_WEIGHT, plane.normal)


def _parallel_axis(line: _Line, tolerance: float) -> int | None:
    """The coordinate (0, 1) that is the same along a line, within the tolerance."""
    off = [abs(line.end[index] - line.start[index]) for index in (0, 1)]
    flat = 0 if off[0] < off[1] else 1
    if off[flat] <= min(tolerance, 0.2 * off[1 - flat]):
        return flat
    return None


def _supports(plane: _Plane, known: Adjusted, tolerance: float) -> tuple[Carrier, ...]:
    snap, lines = known.snap, known.lines[plane.normal]
    circles = [(snap.circle(plane.normal, arc.carrier) or arc.carrier, arc) for arc in plane.arcs]
    curves: list[LineOrCircle] = []
    strokes: list[tuple[int, DrawnInterval]] = []
    for circle, stroke in circles:
        if circle not in curves:
            curves.append(circle)
        strokes.append((curves.index(circle), _arc_stretch(stroke)))
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
        strokes.append((curves.index(curve), _line_stretch(curve, line)))
    for group, curve in zip(_collinear(slanted, tolerance), lines, strict=True):
        curves.append(curve)
        strokes += [(len(curves) - 1, _line_stretch(curve, line)) for line in group]
    grid = [axis_line(index, value) for index in (0, 1) for value in snap.values[axes[index]]]
    return carriers_with_intervals(curves, strokes, grid, tolerance)


def _line_stretch(curve: Line, line: _Line) -> DrawnInterval:
    low, high = sorted((curve.parameter(line.start), curve.parameter(line.end)))
    return DrawnInterval(line.role, (low, high), line.linetype, line.confidence)


def _arc_stretch(arc: _Arc) -> DrawnInterval:
    span = arc.start_angle, arc.start_angle + arc.sweep
    return DrawnInterval(arc.role, span, arc.linetype, arc.confidence)


def _collinear(lines: list[_Line], tolerance: float) -> list[list[_Line]]:
    """Slanted strokes in groups that lie on one line."""
    groups: list[tuple[Line, list[_Line]]] = []
    for line in sorted(lines, key=lambda stroke: -stroke.length):
        line_curve, length = line_through(line.start, line.end), line.length
        for curve, group in groups:
            off = max(curve.distance(line.start), curve.distance(line.end))
            (dx, dy), (ex, ey) = curve.direction, line_curve.direction
            if off <= 1.5 * tolerance and abs(dx * ey - dy * ex) * length <= 1.5 * tolerance:
                group.append(line)
                break
        else:
            groups.append((line_curve, [line]))
    return [group for _, group in groups]
