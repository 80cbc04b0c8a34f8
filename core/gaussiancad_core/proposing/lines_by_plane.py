"""The strokes of a sheet in the planes of the part's axes, each as the surface that it is edge-on.

Views along one axis share a plane, whose coordinates are the part's own.  Places along an axis at
which strokes lie, or end, are its levels: what lies within the tolerance of one lies there.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.coordinates.agreed_places import Places
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import Circle as WholeCircle
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment
from gaussiancad_core.proposing.edge_on_surfaces import SurfaceKind, SurfaceTable

Floats = npt.NDArray[np.float64]
Circle = tuple[float, float, float]
"""(a, b, radius) mm in a plane."""

ROUND = 96
"""Chords of a full circle."""

_FINEST = 1e-5
"""Share of the longest extent that the tolerance is at least."""

_FREE_STEP = 1.0 / 150.0
"""Chords of a free curve as a share of the longest extent."""

_SMOOTH, _CHORDS = np.cos(np.radians(12.0)), np.cos(np.radians(28.0))
"""Cosines of the turns up to which strokes pass into each other smoothly, and short chords do."""

_SHORT = 1.0 / 40.0
"""Share of the longest extent up to which a straight stroke may be a chord of a curve."""

_TOUCHING = 0.04
"""Cosine of the angle between a radius and a stroke that ends at its circle, along it."""

_CERTAIN, _END = 1e9, 1e-3
"""What a side of the bounding box, and the end of a leaning stroke, counts for a level; a stroke
across counts its length."""

_MEET, _WITHIN = 3.0, 2.0
"""Tolerances within which ends meet, and within which an end lies on another stroke."""

_DIRECTION = 0.2
"""Share of the longest extent that a unit of direction counts among the values of a surface."""


@dataclass(frozen=True, eq=False)
class PlaneLine:
    """A stroke in a plane.

    Attributes:
        points: (n, 2) mm, corners of its chords.
        is_visible: whether it is drawn as a visible edge.
        length: mm.
        surface: number of the surface that it is seen edge-on as.
        circle: that it is a piece of; None where it is none's.
        is_full: whether it is a whole circle.
    """

    points: Floats
    is_visible: bool
    length: float
    surface: int = -1
    circle: Circle | None = None
    is_full: bool = False


@dataclass(frozen=True, eq=False)
class PlaneView:
    """A view in its plane.

    Attributes:
        role: of the view.
        axis: that it looks along.
        looks_up: whether it sees the least coordinate along that first.
        lines: of it.
    """

    role: Role
    axis: Axis
    looks_up: bool
    lines: tuple[PlaneLine, ...]


@dataclass(frozen=True)
class PlaneHole:
    """A hole of which a note speaks.

    Attributes:
        axis: along which it runs.
        looks_up: whether the view that shows it sees the least coordinate along that first.
        centre: (2,) mm in the plane.
        steps: its cylinders, from the smallest diameter to the largest.
    """

    axis: Axis
    looks_up: bool
    centre: tuple[float, float]
    steps: tuple[HoleStep, ...]


@dataclass(frozen=True, eq=False)
class PlaneSheet:
    """All strokes of a sheet in their planes.

    Attributes:
        views: of it, sections among them.
        size: (3,) mm, the part's extent; it starts at the origin.
        tolerance: mm by which strokes may miss where they belong.
        levels: places along each axis, from the least.
        holes: of which notes speak.
        surfaces: of the strokes; what is put together of them adds its own.
    """

    views: tuple[PlaneView, ...]
    size: Floats
    tolerance: float
    levels: Mapping[Axis, Floats]
    holes: tuple[PlaneHole, ...]
    surfaces: SurfaceTable

    @property
    def longest(self) -> float:
        """mm."""
        return float(self.size.max())

    @property
    def length(self) -> float:
        """mm of all strokes."""
        return sum(line.length for view in self.views for line in view.lines)

    def lines(self, axis: Axis) -> tuple[PlaneLine, ...]:
        """Those of all views along an axis."""
        return tuple(line for view in self.views if view.axis is axis for line in view.lines)

    def level(self, axis: Axis, place: float) -> float:
        """The level at a place along an axis, or the place itself."""
        return _at_level(self.levels[axis], place, self.tolerance)

    def across(self, axis: Axis, place: float) -> int:
        """Number of the plane across an axis at a place."""
        return self.surfaces.number(SurfaceKind.ACROSS, axis, place)


def plane_sheet(views: DrawnViews, places: Places) -> PlaneSheet:
    """The strokes of views in the planes of the part's axes.

    Args:
        views: of the part, with what the sheet's numbers say.
        places: where their lines belong.
    """
    size = np.array(places.size, dtype=np.float64)
    longest = float(size.max())
    tolerance = max(views.tolerance, _FINEST * longest)
    drawn = [
        _settled(_view(role, strokes, (longest, tolerance)), places)
        for role, strokes in views.strokes.items()
    ]
    levels = {axis: _levels(drawn, axis, float(size[axis.value]), tolerance) for axis in Axis}
    surfaces = SurfaceTable(tolerance)
    named = tuple(_named(view, levels, surfaces, (longest, tolerance)) for view in drawn)
    holes = tuple(map(_hole, views.holes))
    return PlaneSheet(named, size, tolerance, levels, holes, surfaces)


def _hole(hole: NotedHole) -> PlaneHole:
    plane = role_plane(hole.role)
    x, y = (value * sign for value, sign in zip(hole.centre, plane.signs, strict=True))
    return PlaneHole(plane.normal, plane.looks_up, (x, y), hole.steps)


def _view(role: Role, strokes: Iterable[DrawnStroke], scale: tuple[float, float]) -> PlaneView:
    plane = role_plane(role)
    lines = tuple(_lines(strokes, np.array(plane.signs, np.float64), scale))
    return PlaneView(role, plane.normal, plane.looks_up, lines)


def _settled(view: PlaneView, places: Places) -> PlaneView:
    """A view whose circles and straight lines lie where all views have them."""
    return replace(view, lines=tuple(_placed(line, places, view.axis) for line in view.lines))


def _placed(line: PlaneLine, places: Places, normal: Axis) -> PlaneLine:
    if line.circle is not None:
        *centre, radius = line.circle
        found = places.circle(WholeCircle((centre[0], centre[1]), radius), normal)
        grown = (line.points - centre) * (found.radius / radius)
        circle = *found.centre, found.radius
        return replace(line, points=grown + np.array(found.centre), circle=circle)
    if len(line.points) > 2:
        return line
    return replace(line, points=places.placed(line.points, normal))


def _as_arc(stroke: DrawnStroke, tolerance: float) -> DrawnStroke:
    """A circle that was read as an ellipse, as a circle; all else as it is."""
    if not isinstance(stroke, Ellipse) or stroke.semi_major - stroke.semi_minor > 2.0 * tolerance:
        return stroke
    radius = (stroke.semi_major + stroke.semi_minor) / 2.0
    start = stroke.rotation + stroke.start
    return Arc(stroke.centre, radius, start, stroke.sweep, stroke.linetype, stroke.confidence)


def _lines(
    strokes: Iterable[DrawnStroke], signs: Floats, scale: tuple[float, float]
) -> Iterator[PlaneLine]:
    longest, tolerance = scale
    for stroke in (_as_arc(each, tolerance) for each in strokes):
        circle, is_full = None, False
        if isinstance(stroke, Arc):
            points = _corners(stroke)
            x, y = np.multiply(stroke.centre, signs).tolist()
            circle, is_full = (x, y, stroke.radius), stroke.is_full
        elif isinstance(stroke, Segment):
            points = np.array([stroke.start, stroke.end], np.float64)
        else:
            points = np.asarray(stroke.sample(_FREE_STEP * longest))
        points = points * signs
        length = float(np.hypot(*np.diff(points, axis=0).T).sum())
        if length > 0.0:
            is_visible = stroke.linetype is Linetype.VISIBLE
            yield PlaneLine(points, is_visible, length, circle=circle, is_full=is_full)


def _corners(arc: Arc) -> Floats:
    """(n, 2) points on an arc; those at quarters of its circle are among them."""
    sweep = 2.0 * np.pi if arc.is_full else arc.sweep
    count = max(2, int(np.ceil(sweep / (2.0 * np.pi / ROUND))))
    angles = arc.start_angle + np.linspace(0.0, sweep, count + 1)
    quarter = 0.5 * np.pi
    between = np.arange(np.ceil(angles[0] / quarter), np.floor(angles[-1] / quarter) + 1.0)
    angles = np.unique(np.round(np.concatenate([angles, quarter * between]), 9))
    points = np.array(arc.centre) + arc.radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    if arc.is_full:
        points[-1] = points[0]
    return points


def _levels(views: Iterable[PlaneView], axis: Axis, extent: float, tolerance: float) -> Floats:
    """Places along an axis at which strokes lie or end, one of each that are within the
    tolerance: where the most of their line is."""
    found = [(0.0, _CERTAIN), (extent, _CERTAIN)]
    for view in views:
        if view.axis is not axis:
            column = IN_PLANE[view.axis].index(axis.value)
            for line in view.lines:
                found += _places(line, line.points[:, column], tolerance)
    found.sort()
    groups: list[list[tuple[float, float]]] = []
    for place, weight in found:
        if not groups or place - groups[-1][0][0] > 2.0 * tolerance:
            groups.append([])
        groups[-1].append((place, weight))
    return np.array([max(group, key=lambda each: each[1])[0] for group in groups])


def _places(line: PlaneLine, along: Floats, tolerance: float) -> list[tuple[float, float]]:
    if line.circle is not None:
        places = along[0], along[-1], along.min(), along.max()
        return [(float(place), 1.0) for place in places]
    if np.ptp(along) <= tolerance:
        return [(float(along.mean()), line.length)]
    return [(float(along[0]), _END), (float(along[-1]), _END)]


def _at_level(levels: Floats, place: float, tolerance: float) -> float:
    nearest = float(levels[np.abs(levels - place).argmin()])
    return nearest if abs(nearest - place) <= 2.5 * tolerance else float(place)


def _named(
    view: PlaneView,
    levels: Mapping[Axis, Floats],
    surfaces: SurfaceTable,
    scale: tuple[float, float],
) -> PlaneView:
    """A view whose lines have their surfaces; those that pass into each other are joined."""
    longest, tolerance = scale
    lines = []
    for number, line in enumerate(view.lines):
        if line.circle is not None:
            surface = surfaces.number(SurfaceKind.CYLINDER, view.axis, *line.circle)
            lines.append(replace(line, surface=surface))
        elif len(line.points) > 2:
            name = 10.0 * number * longest
            surface = surfaces.number(SurfaceKind.FREE, view.axis, name)
            lines.append(replace(line, surface=surface))
        else:
            lines.append(_straight(line, view.axis, levels, surfaces, scale))
    named = replace(view, lines=tuple(lines))
    _join(named.lines, surfaces, longest, tolerance)
    return named


def _straight(
    line: PlaneLine,
    axis: Axis,
    levels: Mapping[Axis, Floats],
    surfaces: SurfaceTable,
    scale: tuple[float, float],
) -> PlaneLine:
    longest, tolerance = scale
    for column, shown in enumerate(IN_PLANE[axis]):
        if np.ptp(line.points[:, column]) <= tolerance:
            across = Axis(shown)
            place = _at_level(levels[across], float(line.points[:, column].mean()), tolerance)
            points = line.points.copy()
            points[:, column] = place
            surface = surfaces.number(SurfaceKind.ACROSS, across, place)
            return replace(line, points=points, surface=surface)
    way = (line.points[1] - line.points[0]) / line.length
    way = way if way[0] > 0.0 else -way
    off = float(line.points[0] @ [-way[1], way[0]])
    values = *(_DIRECTION * longest * way).tolist(), off
    return replace(line, surface=surfaces.number(SurfaceKind.ALONG, axis, *values))


@dataclass(frozen=True, eq=False)
class _End:
    """An end of a line, and the way in which it leaves the line there."""

    at: Floats
    way: Floats
    line: PlaneLine


def _join(
    lines: tuple[PlaneLine, ...], surfaces: SurfaceTable, longest: float, tolerance: float
) -> None:
    """Join the surfaces of lines that pass into each other smoothly."""
    ends = [end for line in lines if not line.is_full for end in _ends(line)]
    if not ends:
        return
    points = shapely.points([end.at for end in ends])
    tree = shapely.STRtree(points)
    for i, j in tree.query(points, "dwithin", _MEET * tolerance).T:
        one, other = ends[i], ends[j]
        if i < j and one.line is not other.line:
            chords = all(_is_chord(end.line, longest) for end in (one, other))
            if -float(one.way @ other.way) > (_CHORDS if chords else _SMOOTH):
                surfaces.join(one.line.surface, other.line.surface)
    curves = shapely.STRtree([shapely.LineString(line.points) for line in lines])
    for i, j in curves.query(points, "dwithin", _WITHIN * tolerance).T:
        line, end = lines[j], ends[i]
        if line is not end.line and line.circle is not None:
            away = end.at - np.array(line.circle[:2])
            if abs(float(away @ end.way)) < _TOUCHING * float(np.hypot(*away)):
                surfaces.join(end.line.surface, line.surface)


def _ends(line: PlaneLine) -> Iterator[_End]:
    for last, before in ((line.points[0], line.points[1]), (line.points[-1], line.points[-2])):
        way = last - before
        yield _End(last, way / max(float(np.hypot(*way)), 1e-12), line)


def _is_chord(line: PlaneLine, longest: float) -> bool:
    return len(line.points) == 2 and line.length < _SHORT * longest
