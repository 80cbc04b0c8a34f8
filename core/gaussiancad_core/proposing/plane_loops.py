"""Closed areas of a plane: what its lines enclose, with the surface behind each of their edges.

Outlines are often open by a hair, or by a piece that was not read.  Where the lines as they are
enclose less than the same a little longer, the longer ones count; loose ends that are each other's
nearest are bridged, and others to the line that they all but meet.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Any

import numpy as np
import numpy.typing as npt
import shapely
from scipy.spatial import cKDTree

from gaussiancad_core.geometry.near_points import connected_groups
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.lines_by_plane import ROUND, Circle, Floats, PlaneLine, PlaneSheet

Numbers = npt.NDArray[np.int64]

_GRID = 0.5
"""Tolerances of the grid on which corners of areas lie."""

_ONE_END = 2.0
"""Tolerances within which ends of lines are one."""

_LONGER = 3.0
"""Tolerances by which lines are made longer where their outline is open, and within which an end is
none of a loose one."""

_MORE = 1.02
"""Times the area that longer lines have to enclose to count."""

_WHOLE = 4.0
"""Tolerances by which an outline may end beside the sides of its view to be closed."""

_SPECK, _SLIVER = 2.5, 1.0
"""Tolerances: side of the square that is as large as the least area, and the least width."""

_CHORD = 1.2 * 2.0 * np.pi / ROUND
"""Radii that a chord of a circle is long at most."""

_BRIDGE, _TO_LINE = 0.15, 0.03
"""Shares of the longest extent between two loose ends, and from one to a line, at most."""


class LoopKind(Enum):
    """What a closed area is."""

    OUTLINE = "outline"
    """All that a plane's lines enclose, without holes."""

    REGION = "region"
    """What no line divides."""

    FILLED = "filled"
    """A region with its holes filled."""

    SEEN = "seen"
    """What visible lines alone enclose."""

    BEHIND = "behind"
    """What hidden lines enclose with the outline."""

    CIRCLE = "circle"
    """The disc of a circle of which a quarter is drawn."""

    AROUND = "around"
    """Everything outside of another loop."""

    BETWEEN = "between"
    """What lies between one loop and another in it."""

    HALF = "half"
    """A half of a loop that is symmetrical."""

    BOX = "box"
    """A side of the part's box."""


@dataclass(frozen=True, eq=False)
class Loop:
    """A closed area of a plane, with holes or without.

    Attributes:
        axis: across the plane.
        polygon: mm.
        edges: (m, 4) mm, from and to, of one ring after the other.
        surfaces: (m,) numbers of the surfaces behind the edges.
        rings: which edges each ring has, the outer one first.
        kind: what it is.
        tables: where lines of sight of each view meet it, as far as anybody asked.
    """

    axis: Axis
    polygon: shapely.Polygon
    edges: Floats
    surfaces: Numbers
    rings: tuple[slice, ...]
    kind: LoopKind
    tables: dict[Any, Any] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class PlaneLoops:
    """What the lines of a plane enclose.

    Attributes:
        axis: across the plane.
        regions: that no line divides.
        outline: of everything that is enclosed, without holes.
        is_closed: whether the outline reaches all sides of the part's box.
        levels: along each of the plane's coordinates, at which corners lie that are near one.
        near: mm to a level, at most.
        stretch: mm by which lines were made longer at their ends.
        owners: the lines, as they are looked up by place.
        surfaces: (n,) of these.
        circles: of those of them that are cylinders.
    """

    axis: Axis
    regions: tuple[shapely.Polygon, ...]
    outline: shapely.Polygon
    is_closed: bool
    levels: tuple[Floats, Floats]
    near: float
    stretch: float
    owners: shapely.STRtree
    surfaces: Numbers
    circles: Mapping[int, Circle]

    def loop(self, polygon: shapely.Polygon, kind: LoopKind) -> Loop:
        """A closed area whose edges have the surfaces of the lines that they lie on."""
        polygon = shapely.orient_polygons(self._levelled(polygon))
        edges, rings, at = [], [], 0
        for ring in (polygon.exterior, *polygon.interiors):
            corners = np.array(ring.coords)
            edges.append(np.hstack([corners[:-1], corners[1:]]))
            rings.append(slice(at, at + len(corners) - 1))
            at += len(corners) - 1
        found = np.vstack(edges)
        surfaces = self._behind(found)
        for ring in rings:
            surfaces[ring] = self._with_chords(found[ring], surfaces[ring])
        return Loop(self.axis, polygon, found, surfaces, tuple(rings), kind)

    def _behind(self, edges: Floats) -> Numbers:
        """The surfaces of the lines that edges lie on."""
        middles = shapely.points((edges[:, :2] + edges[:, 2:]) / 2.0)
        return np.asarray(self.surfaces[self.owners.nearest(middles)], np.int64)

    def _with_chords(self, edges: Floats, surfaces: Numbers) -> Numbers:
        """The surfaces behind the edges of a ring, where short ones beside an arc that end on its
        circle are the circle's: a line that touches it runs along its last chord, too."""
        named = surfaces.copy()
        lengths = np.hypot(*(edges[:, 2:] - edges[:, :2]).T)
        count = len(edges)
        for k in (*range(count), *range(count - 1, -1, -1)):
            for arc in (named[k - 1], named[(k + 1) % count]):
                circle = self.circles.get(int(arc))
                if circle is None or arc == named[k]:
                    continue
                x, y, radius = circle
                ends = edges[k].reshape(2, 2)
                away = np.abs(np.hypot(*(ends - (x, y)).T) - radius).max()
                if lengths[k] <= _CHORD * radius and away <= self.near:
                    named[k] = arc
        return named

    def _levelled(self, polygon: shapely.Polygon) -> shapely.Polygon:
        """A closed area whose corners lie at the levels that they are near to, but for those
        between two chords of arcs: what two areas have between them is nothing, not a film.  Where
        arcs would cross others then, their ends stay where they are, too."""
        for moves_ends in (True, False):
            rings = [
                self._ring_levelled(np.array(each.coords), moves_ends=moves_ends)
                for each in (polygon.exterior, *polygon.interiors)
            ]
            # A speck has all its corners at one place.
            with suppress(shapely.errors.GEOSException, ValueError):
                found = shapely.remove_repeated_points(shapely.Polygon(rings[0], rings[1:]))
                if found.is_valid and not found.is_empty:
                    return found
        return polygon

    def _ring_levelled(self, ring: Floats, *, moves_ends: bool) -> Floats:
        corners = ring[:-1]
        is_chord = np.isin(self._behind(np.hstack([corners, ring[1:]])), list(self.circles))
        before = np.roll(is_chord, 1)
        is_free = ~(is_chord & before) if moves_ends else ~(is_chord | before)
        places = corners.copy()
        for column, levels in enumerate(self.levels):
            nearest = levels[np.abs(levels - corners[:, column, None]).argmin(axis=1)]
            is_near = np.abs(nearest - corners[:, column]) <= self.near
            places[is_near & is_free, column] = nearest[is_near & is_free]
        return np.vstack([places, places[:1]])


def plane_loops(sheet: PlaneSheet, axis: Axis) -> PlaneLoops | None:
    """What the lines of a plane enclose; None where that is nothing."""
    lines = sheet.lines(axis)
    plain = _enclosed(sheet, axis, lines, 0.0)
    if plain is not None and plain.is_closed:
        return plain
    longer = _enclosed(sheet, axis, lines, _LONGER * sheet.tolerance)
    if plain is None or longer is None:
        return longer or plain
    return longer if longer.outline.area > _MORE * plain.outline.area else plain


def stretched(
    lines: Sequence[PlaneLine], stretch: float, tolerance: float
) -> list[shapely.LineString]:
    """Lines, longer at both ends, on the grid of corners; ends that are near each other are one."""
    found = []
    for line in _meeting(lines, _ONE_END * tolerance):
        points = line.points
        if stretch > 0.0 and not line.is_full and (points[[0, -1]] != points[[1, -2]]).any(1).all():
            first, last = points[0] - points[1], points[-1] - points[-2]
            start = points[0] + stretch * first / np.hypot(*first)
            end = points[-1] + stretch * last / np.hypot(*last)
            points = np.vstack([start, points[1:-1], end])
        found.append(shapely.LineString(points))
    on_grid = shapely.set_precision(found, _GRID * tolerance)
    return [curve if curve.length > 0.0 else shapely.LineString() for curve in on_grid]


def _meeting(lines: Sequence[PlaneLine], near: float) -> list[PlaneLine]:
    """Lines whose ends that are near each other are one: the mean of these."""
    open_lines = [number for number, line in enumerate(lines) if not line.is_full]
    if not open_lines:
        return list(lines)
    ends = np.array([lines[number].points[[0, -1]] for number in open_lines]).reshape(-1, 2)
    pairs = cKDTree(ends).query_pairs(near, output_type="ndarray")
    groups = connected_groups(pairs, len(ends))
    sums = np.zeros((len(ends), 2))
    np.add.at(sums, groups, ends)
    means = sums / np.maximum(np.bincount(groups, minlength=len(ends)), 1)[:, None]
    met = list(lines)
    for row, number in enumerate(open_lines):
        points = lines[number].points.copy()
        points[0], points[-1] = means[groups[2 * row]], means[groups[2 * row + 1]]
        met[number] = replace(lines[number], points=points)
    return met


def areas_between(
    curves: Sequence[shapely.LineString], tolerance: float
) -> tuple[shapely.Polygon, ...]:
    """The areas that curves divide their plane into, without specks and slivers."""
    noded = _noded(curves, _GRID * tolerance)
    found = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    least = (_SPECK * tolerance) ** 2
    return tuple(
        area
        for area in found
        if area.area > least and 2.0 * area.area / area.length > _SLIVER * tolerance
    )


def _noded(curves: Sequence[shapely.LineString], grid: float) -> shapely.Geometry:
    """Curves parted where they meet; on a coarser grid where that of their corners does not do."""
    with suppress(shapely.errors.GEOSException):
        return shapely.union_all(list(curves), grid_size=grid)
    return shapely.union_all(list(curves), grid_size=2.0 * grid)


def _enclosed(
    sheet: PlaneSheet, axis: Axis, lines: Sequence[PlaneLine], stretch: float
) -> PlaneLoops | None:
    tolerance = sheet.tolerance
    curves = stretched(lines, stretch, tolerance)
    kept = [(curve, line) for curve, line in zip(curves, lines, strict=True) if not curve.is_empty]
    if not kept:
        return None
    bridges = shapely.set_precision(list(_bridges(lines, sheet)), _GRID * tolerance)
    curves = [curve for curve, _ in kept] + [each for each in bridges if each.length > 0.0]
    regions = areas_between(curves, tolerance)
    if not regions:
        return None
    outline = _outline(regions, tolerance)
    sides = 0.0, 0.0, *sheet.size[list(IN_PLANE[axis])].tolist()
    apart = float(np.abs(np.subtract(outline.bounds, sides)).max())
    return PlaneLoops(
        axis,
        regions,
        outline,
        apart < _WHOLE * tolerance,
        _levels_of(sheet, axis),
        _ONE_END * tolerance,
        stretch,
        shapely.STRtree([curve for curve, _ in kept]),
        np.array([line.surface for _, line in kept], np.int64),
        {line.surface: line.circle for _, line in kept if line.circle is not None},
    )


def _levels_of(sheet: PlaneSheet, axis: Axis) -> tuple[Floats, Floats]:
    first, second = (sheet.levels[Axis(shown)] for shown in IN_PLANE[axis])
    return first, second


def _outline(regions: Iterable[shapely.Polygon], tolerance: float) -> shapely.Polygon:
    filled = [shapely.Polygon(region.exterior) for region in regions]
    whole = shapely.union_all(filled, grid_size=_GRID * tolerance)
    parts = [shapely.Polygon(part.exterior) for part in shapely.get_parts(whole)]
    return max(parts, key=lambda part: part.area)


def _bridges(lines: Sequence[PlaneLine], sheet: PlaneSheet) -> Iterator[shapely.LineString]:
    """Lines that may be lost: between loose ends that are each other's nearest, else from a loose
    end to the nearest line."""
    curves = [shapely.LineString(line.points) for line in lines]
    loose = list(_loose_ends(lines, curves, _LONGER * sheet.tolerance))
    if len(loose) < 2:
        return
    points = np.array([point for point, _ in loose])
    away = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1))
    np.fill_diagonal(away, np.inf)
    nearest = away.argmin(axis=1)
    for number, (point, owner) in enumerate(loose):
        other = int(nearest[number])
        if nearest[other] == number and away[number, other] < _BRIDGE * sheet.longest:
            if number < other:
                yield shapely.LineString([point, points[other]])
            continue
        others = [curve for k, curve in enumerate(curves) if k != owner]
        line = shapely.shortest_line(shapely.Point(point), shapely.MultiLineString(others))
        if line is not None and 0.0 < line.length < _TO_LINE * sheet.longest:
            yield line


def _loose_ends(
    lines: Sequence[PlaneLine], curves: Sequence[shapely.LineString], near: float
) -> Iterator[tuple[Floats, int]]:
    """Ends of lines that no other line is near to, and whose they are."""
    tree = shapely.STRtree(curves)
    for number, line in enumerate(lines):
        for point in () if line.is_full else (line.points[0], line.points[-1]):
            met = tree.query(shapely.Point(point), "dwithin", near)
            if all(each == number for each in met):
                yield point, number
