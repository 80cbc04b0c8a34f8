"""Profiles that may be turned: leaning lines about centres of circles, and halves of closed areas.

A cone shows as a leaning line in a view from the side whose ends are at radii of circles that the
view along its axis has.  A turned body, or a groove of one, shows as a closed area that is
symmetrical about the axis, or lies beside it.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.edge_on_surfaces import SurfaceKind
from gaussiancad_core.proposing.lines_by_plane import (
    Circle,
    Floats,
    PlaneLine,
    PlaneSheet,
    PlaneView,
)
from gaussiancad_core.proposing.part_features import Turned
from gaussiancad_core.proposing.plane_loops import Loop, LoopKind, PlaneLoops

_MOST_CENTRES = 12
"""Centres of circles of a plane that profiles are turned about, those with the most line first."""

_ONE_CENTRE = 3.0
"""Tolerances within which two centres are one, two radii, and a profile's sides alike."""

_WHOLE = 6.2
"""Radians of circles about a centre from which a rectangle turned about it tells nothing new."""

_SYMMETRICAL = 0.01
"""Share of an area by which its mirror image may differ."""

_SMOOTH, _CHORDS = np.cos(np.radians(12.0)), np.cos(np.radians(28.0))
_SHORT = 1.0 / 40.0
"""As of strokes: cosines of smooth turns, and share of the longest extent of a chord."""

_DIRECTION = 0.2
"""Share of the longest extent that a unit of direction counts among the values of a surface."""

_FAR = 1e6
"""mm beyond any part."""


@dataclass(frozen=True)
class Centre:
    """A point that circles of a plane are about.

    Attributes:
        at: (2,) mm in the plane.
        radii: mm, of them.
        turn: radians of circles that are drawn about it.
    """

    at: tuple[float, float]
    radii: tuple[float, ...]
    turn: float


def turned_of(
    sheet: PlaneSheet,
    planes: Mapping[Axis, PlaneLoops],
    loops: Mapping[Axis, Sequence[Loop]],
) -> Iterator[Turned]:
    """All profiles that may be turned."""
    for axis in Axis:
        centres = _centres(sheet, axis)
        for centre in centres:
            yield from _cones(sheet, axis, centre)
            yield from _sunk_holes(sheet, axis, centre)
        for centre in sorted(centres, key=lambda each: -each.turn)[:_MOST_CENTRES]:
            for other in Axis:
                if other is axis or other not in planes:
                    continue
                rest = [
                    loop
                    for loop in loops[other]
                    if centre.turn <= _WHOLE or not _is_rectangle(loop, sheet)
                ]
                for made in _halves(sheet, planes[other], axis, centre, rest):
                    apart = min(abs(made.radius - radius) for radius in centre.radii)
                    if apart < _ONE_CENTRE * sheet.tolerance:
                        yield made


def _centres(sheet: PlaneSheet, axis: Axis) -> list[Centre]:
    found: list[tuple[tuple[float, float], list[float], list[float]]] = []
    for line in sheet.lines(axis):
        if line.circle is None:
            continue
        x, y, radius = line.circle
        for at, radii, turns in found:
            if np.hypot(at[0] - x, at[1] - y) < _ONE_CENTRE * sheet.tolerance:
                radii.append(radius)
                turns.append(line.length / radius)
                break
        else:
            found.append(((x, y), [radius], [line.length / radius]))
    return [Centre(at, tuple(radii), sum(turns)) for at, radii, turns in found]


def _cones(sheet: PlaneSheet, axis: Axis, centre: Centre) -> Iterator[Turned]:
    """Cones, and rings of a triangle, of leaning lines whose ends are at radii, or on the axis."""
    done: set[tuple[float, ...]] = set()
    for view in sheet.views:
        if view.axis is axis:
            continue
        for line in view.lines:
            ends = _leaning_ends(sheet, view, line, axis, centre)
            if (
                ends is None
                or (key := tuple(round(value, 3) for end in ends for value in end)) in done
            ):
                continue
            done.add(key)
            (r, z), (s, w) = ends
            yield _turned(sheet, axis, centre.at, [(0.0, z), (r, z), (s, w), (0.0, w)])
            yield _turned(sheet, axis, centre.at, [(r, z), (s, w), (max(r, s), w if r > s else z)])


def _sunk_holes(sheet: PlaneSheet, axis: Axis, centre: Centre) -> Iterator[Turned]:
    """Holes through the part with a countersink of 90 degrees from one circle to another, where no
    view from beside draws a line of them."""
    if any(not line.is_visible for view in sheet.views for line in view.lines):
        return
    near = _ONE_CENTRE * sheet.tolerance
    sides = 0.0, float(sheet.size[axis.value])
    for inner, outer in pairwise(sorted(centre.radii)):
        depth = outer - inner
        if near < depth < sides[1]:
            for face, end, way in ((*sides, 1.0), (*sides[::-1], -1.0)):
                deep = face + way * depth
                corners = [(0.0, face), (outer, face), (inner, deep), (inner, end), (0.0, end)]
                yield _turned(sheet, axis, centre.at, corners)


def _leaning_ends(
    sheet: PlaneSheet, view: PlaneView, line: PlaneLine, axis: Axis, centre: Centre
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """Radius and height of both ends of a line that leans to an axis; None of another one."""
    tolerance = sheet.tolerance
    if line.circle is not None or len(line.points) != 2:
        return None
    if float(np.ptp(line.points, axis=0).min()) <= tolerance:
        return None
    along = IN_PLANE[view.axis].index(axis.value)
    middle = centre.at[IN_PLANE[axis].index(IN_PLANE[view.axis][1 - along])]
    away = line.points[:, 1 - along] - middle
    if float(away.prod()) < -(tolerance**2):
        return None
    known = np.array([0.0, *centre.radii])
    radii = [float(known[np.abs(known - radius).argmin()]) for radius in np.abs(away)]
    if float(np.abs(np.abs(away) - radii).max()) > _ONE_CENTRE * tolerance:
        return None
    if abs(radii[0] - radii[1]) < tolerance:
        return None
    first, last = (sheet.level(axis, float(place)) for place in line.points[:, along])
    return (radii[0], first), (radii[1], last)


def _halves(
    sheet: PlaneSheet, plane: PlaneLoops, axis: Axis, centre: Centre, loops: Sequence[Loop]
) -> Iterator[Turned]:
    """Turned features of areas of a view from the side."""
    along = IN_PLANE[plane.axis].index(axis.value)
    column = 1 - along
    middle = centre.at[IN_PLANE[axis].index(IN_PLANE[plane.axis][column])]
    for loop in loops:
        area = _one_side(shapely.Polygon(loop.polygon.exterior), column, middle, sheet.tolerance)
        if area is None:
            continue
        half = plane.loop(area, LoopKind.HALF)
        radii = half.edges[:, column] - middle
        radii = np.where(np.abs(radii) < 2.0 * sheet.tolerance, 0.0, radii)
        heights = [sheet.level(axis, float(place)) for place in half.edges[:, along]]
        ends = half.edges[:, column + 2] - middle
        circles = [
            _circle_behind(sheet, int(surface), column, middle)
            if max(abs(start), abs(end)) >= 2.0 * sheet.tolerance
            else None
            for surface, start, end in zip(half.surfaces, radii, ends, strict=True)
        ]
        points = list(zip(radii.tolist(), heights, strict=True))
        yield _turned(sheet, axis, centre.at, points, circles)


def _one_side(
    area: shapely.Polygon, column: int, middle: float, tolerance: float
) -> shapely.Polygon | None:
    """An area beside an axis, or the half of one that is symmetrical about it; None of others."""
    corners = np.array(area.exterior.coords)
    away = corners[:, column] - middle
    if away.min() >= -tolerance:
        return area
    if abs(away.min() + away.max()) > _ONE_CENTRE * tolerance:
        return None
    flipped = corners.copy()
    flipped[:, column] = 2.0 * middle - flipped[:, column]
    if shapely.Polygon(flipped).symmetric_difference(area).area > _SYMMETRICAL * area.area:
        return None
    sides = (middle, -_FAR, _FAR, _FAR) if column == 0 else (-_FAR, middle, _FAR, _FAR)
    half = shapely.box(*sides).intersection(area)
    return half if half.geom_type == "Polygon" else None


def _circle_behind(sheet: PlaneSheet, surface: int, column: int, middle: float) -> Circle | None:
    """The circle in radius and height that an edge is a chord of; None of a straight one."""
    behind = sheet.surfaces[surface]
    if behind.kind is not SurfaceKind.CYLINDER:
        return None
    return behind.values[column] - middle, behind.values[1 - column], behind.values[2]


def _turned(
    sheet: PlaneSheet,
    axis: Axis,
    centre: tuple[float, float],
    points: Sequence[tuple[float, float]],
    circles: Sequence[Circle | None] | None = None,
) -> Turned:
    """A closed chain of radius and height as a turned feature; smooth edges are joined."""
    corners = np.array(points, dtype=np.float64)
    kept = np.hypot(*(corners - np.roll(corners, -1, axis=0)).T) > 1e-9
    chords = [
        circle
        for circle, is_kept in zip(circles or [None] * len(corners), kept, strict=True)
        if is_kept
    ]
    corners = corners[kept]
    edges = np.hstack([corners, np.roll(corners, -1, axis=0)])
    surfaces = [
        _surface(sheet, axis, centre, edge, circle)
        for edge, circle in zip(edges, chords, strict=True)
    ]
    for number in range(len(edges)):
        before, after = edges[number - 1], edges[number]
        off_axis = min(before[[0, 2]].max(), after[[0, 2]].max()) > sheet.tolerance
        if off_axis and _is_smooth(before, after, sheet.longest):
            sheet.surfaces.join(surfaces[number - 1], surfaces[number])
    return Turned(axis, centre, edges, np.array(surfaces, np.int64), tuple(chords))


def _surface(
    sheet: PlaneSheet,
    axis: Axis,
    centre: tuple[float, float],
    edge: Floats,
    circle: Circle | None,
) -> int:
    """The surface behind an edge of a turned profile."""
    if circle is not None:
        return sheet.surfaces.number(SurfaceKind.TORUS, axis, *centre, *circle)
    r, z, s, w = edge.tolist()
    if abs(z - w) <= sheet.tolerance:
        return sheet.across(axis, sheet.level(axis, z))
    if abs(r - s) <= sheet.tolerance:
        return sheet.surfaces.number(SurfaceKind.CYLINDER, axis, *centre, r)
    way = np.array([s - r, w - z]) / np.hypot(s - r, w - z)
    way = way if way[0] > 0.0 else -way
    off = float(np.dot((r, z), (-way[1], way[0])))
    values = (*centre, *(_DIRECTION * sheet.longest * way).tolist(), off)
    return sheet.surfaces.number(SurfaceKind.CONE, axis, *values)


def _is_smooth(before: Floats, after: Floats, longest: float) -> bool:
    """Whether two edges pass into each other; chords of a curve may turn by more."""
    ways = [edge[2:] - edge[:2] for edge in (before, after)]
    lengths = [float(np.hypot(*way)) for way in ways]
    cosine = float(ways[0] @ ways[1]) / (lengths[0] * lengths[1])
    return cosine > (_CHORDS if max(lengths) < _SHORT * longest else _SMOOTH)


def _is_rectangle(loop: Loop, sheet: PlaneSheet) -> bool:
    """Whether an area is a rectangle: turned it is a disc's prism, or a ring of two."""
    polygon = loop.polygon
    if polygon.interiors or abs(polygon.envelope.area / polygon.area - 1.0) >= 1e-3:
        return False
    return len(polygon.simplify(sheet.tolerance / 4.0).exterior.coords) == 5
