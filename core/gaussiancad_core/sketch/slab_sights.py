"""What a view from beside looks at: along each of many sight lines, regions of the plan in order.

A view from beside shows a level where what is nearest changes from one slab to the next, and a line
along the axis where it changes from one sight line to the one beside it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.coordinates.grid_tolerances import LEAN, STEP
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, RolePlane, role_plane
from gaussiancad_core.model.section_planes import Cut
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine
from gaussiancad_core.sketch.wall_steps import DEEPER, Sight, goes_on

Mask = npt.NDArray[np.bool_]

_SAMPLES, _MOST_BETWEEN = 160, 12
"""Sight lines over the part's extent, and between two places where something changes, at most."""

_APART = 0.8
"""Grid steps between two such places at least."""


@dataclass(frozen=True, eq=False)
class Sights:
    """The sight lines of a view from beside, in their order across the view.

    Attributes:
        role: of the view.
        places: (n,) mm across the view.
        widths: (n,) mm that each stands for.
        met: n, what each meets.
        goes_on: n + 1, of each gap between two sight lines beside each other (the first and last
            lie beside the part) a matrix, (m, l) bool, of what the one meets and the other meets:
            whether the face entered is the same one, or as deep.
        levels: (n, levels) bool each, where a visible or hidden line is drawn at a level.
        uprights: (n + 1, slabs) bool each, where one is drawn in a gap.
        hatched: (n, slabs) bool, what is hatched; None where the view is no section, or none is.
        draws_hidden: whether the view shows hidden lines.
        alien: mm of line that no slab explains: aslant, or round.
    """

    role: Role
    places: Floats
    widths: Floats
    met: tuple[Sight, ...]
    goes_on: tuple[Mask, ...]
    levels: tuple[Mask, Mask]
    uprights: tuple[Mask, Mask]
    hatched: Mask | None
    draws_hidden: bool
    alien: float

    @property
    def regions(self) -> tuple[tuple[int, ...], ...]:
        """n, what each sight line meets, the nearest first."""
        return tuple(item.regions for item in self.met)


def sights_of(
    view: tuple[Role, Sequence[PlaneLine], Cut | None],
    axis: Axis,
    slabs: tuple[Sequence[shapely.Polygon], Sequence[float]],
    size: Sequence[float],
    grid: float,
    *,
    draws_hidden: bool,
) -> Sights:
    """The sight lines of a view.

    Args:
        view: from beside: its role, its lines in mm of its plane, and where it is cut.
        axis: of the slabs.
        slabs: regions of the plan in mm, and the levels in mm along the axis.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
        draws_hidden: whether the view shows hidden lines.
    """
    polygons, levels = slabs
    role, lines, cut = view
    plane = role_plane(role)
    along = IN_PLANE[plane.normal].index(axis.value)
    across = 1 - along
    column = IN_PLANE[axis].index(IN_PLANE[plane.normal][across])
    extent = size[IN_PLANE[plane.normal][across]]
    edges = _edges(polygons, lines, (column, across), extent, grid)
    places, widths = _samples(edges)
    depth = size[plane.normal.value]

    def look(place: float) -> Sight:
        at = _cut_at(cut, plane, along, (place, levels[-1] / 2.0), depth)
        found = _met(place, polygons, column)
        if not plane.looks_up:
            found = [(depth - high, depth - low, k) for low, high, k in found]
        if at is not None:
            found = [pair for pair in found if pair[1] > at]
        found.sort()
        return Sight(
            tuple(k for _, _, k in found),
            np.array([low if at is None else max(low, at) for low, _, _ in found]),
            np.array([at is not None and low < at for low, _, _ in found], dtype=bool),
        )

    met = tuple(look(place) for place in places)
    drawn = _drawn(lines, (along, across), places, levels, grid)
    alien = sum(
        line.length * (1.0 if line.is_visible else 0.5)
        for line in lines
        if line.constant(DEEPER * grid) is None
    )
    return Sights(
        role,
        places,
        widths,
        met,
        tuple(goes_on(met, places, edges, look, grid)),
        *drawn,
        _hatched(cut, plane.signs, (along, across), places, levels),
        draws_hidden and cut is None,
        alien,
    )


def _cut_at(
    cut: Cut | None, plane: RolePlane, along: int, place: tuple[float, float], depth: float
) -> float | None:
    """mm from the viewer's side at which a view is cut at a place across and along the axis of the
    slabs; None where it is not.  Where a view is broken out, half its height tells for all."""
    if cut is None:
        return None
    x, y = place if along == 1 else place[::-1]
    opening = cut.opening((x * plane.signs[0], y * plane.signs[1]))
    if opening is None:
        return None
    return opening.at if plane.looks_up else depth - opening.at


def _edges(
    polygons: Sequence[shapely.Polygon],
    lines: Sequence[PlaneLine],
    coordinates: tuple[int, int],
    extent: float,
    grid: float,
) -> list[float]:
    """Places across the view where what is met, or drawn, may change, and both ends."""
    column, across = coordinates
    changes = [polygon.bounds[column + end] for polygon in polygons for end in (0, 2)]
    for this_polygon in polygons:
        for ring in this_polygon.interiors:
            changes += [ring.bounds[column], ring.bounds[column + 2]]
    changes += [float(at) for line in lines if line.is_straight for at in line.points[:, across]]
    edges = [0.0]
    for at in sorted(changes):
        if at - edges[-1] > _APART * grid and extent - at > _APART * grid:
            edges.append(at)
    return [*edges, extent]


def _samples(edges: Sequence[float]) -> tuple[Floats, Floats]:
    """(n,) places of the sight lines, and (n,) mm that each stands for."""
    places, widths = [], []
    for low, high in pairwise(edges):
        count = int(np.clip(round((high - low) / edges[-1] * _SAMPLES), 1, _MOST_BETWEEN))
        places += (low + (np.arange(count) + 0.5) * (high - low) / count).tolist()
        widths += [(high - low) / count] * count
    return np.array(places), np.array(widths)


def _met(
    place: float, polygons: Sequence[shapely.Polygon], column: int
) -> list[tuple[float, float, int]]:
    """What a sight line at a place meets: from, to, and number of the region."""
    found = []
    for number, polygon in enumerate(polygons):
        low, high = polygon.bounds[column], polygon.bounds[column + 2]
        if not low < place < high:
            continue
        crossings = np.sort(np.concatenate([_crossed(r, place, column) for r in _rings(polygon)]))
        found += [
            (float(a), float(b), number)
            for a, b in zip(crossings[::2], crossings[1::2], strict=False)
        ]
    return found


def _rings(polygon: shapely.Polygon) -> list[Floats]:
    return [np.array(item.coords) for item in (polygon.exterior, *polygon.interiors)]


def _crossed(ring: Floats, place: float, column: int) -> Floats:
    """Where a ring of points crosses a line at a place of one coordinate, in the other one."""
    at, other = ring[:, column], ring[:, 1 - column]
    beyond = at > place
    (edges,) = np.nonzero(beyond[1:] != beyond[:-1])
    share = (place - at[edges]) / (at[edges + 1] - at[edges])
    return other[edges] + share * (other[edges + 1] - other[edges])


def _drawn(
    lines: Sequence[PlaneLine],
    coordinates: tuple[int, int],
    places: Floats,
    levels: Sequence[float],
    grid: float,
) -> tuple[tuple[Mask, Mask], tuple[Mask, Mask]]:
    """Where lines are drawn at levels, and between sight lines; visible and hidden ones."""
    along, across = coordinates
    heights = np.array(levels)
    middles = (heights[1:] + heights[:-1]) / 2.0
    level_shape, upright_shape = (len(places), len(heights)), (len(places) + 1, len(middles))
    at_level: tuple[Mask, Mask] = np.zeros(level_shape, bool), np.zeros(level_shape, bool)
    upright: tuple[Mask, Mask] = np.zeros(upright_shape, bool), np.zeros(upright_shape, bool)
    for line in lines:
        if not line.is_straight or line.length <= STEP * grid:
            continue
        kind = 0 if line.is_visible else 1
        (low, high), (first, last) = (np.sort(line.points[:, k]) for k in (along, across))
        runs = line.constant(LEAN * grid)
        within = (middles > low) & (middles < high)
        if runs == along:
            level = int(np.abs(heights - line.points[:, along].mean()).argmin())
            if abs(heights[level] - line.points[:, along].mean()) <= STEP * grid:
                chosen = (places > first - 0.3 * grid) & (places < last + 0.3 * grid)
                at_level[kind][chosen, level] = True
        elif runs == across:
            between = int(np.searchsorted(places, line.points[:, across].mean()))
            upright[kind][between, within] = True
        elif line.is_visible:
            # An edge break stands for a step at either end of it.
            for at in (first, last):
                upright[kind][int(np.searchsorted(places, at)), within] = True
    return at_level, upright


def _hatched(
    cut: Cut | None,
    signs: tuple[int, int],
    coordinates: tuple[int, int],
    places: Floats,
    levels: Sequence[float],
) -> Mask | None:
    if cut is None or cut.areas is None:
        return None
    along, across = coordinates
    middles = (np.array(levels[1:]) + np.array(levels[:-1])) / 2.0
    points = np.zeros((len(places), len(middles), 2))
    points[..., across] = places[:, None]
    points[..., along] = middles[None, :]
    points = points * np.array(signs)
    return shapely.contains_xy(cut.areas, points[..., 0], points[..., 1])
