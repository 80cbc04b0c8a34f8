"""Lines of a view made to meet: whatever is meant to be closed, closes.

What was read is off by a grid step here and there, and nothing in this may fail: ends that are near
each other become one, an end that meets none is led on to the next line, and arcs about one centre
that turn nearly once are a circle.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations
from math import radians

import numpy as np
import numpy.typing as npt
import shapely
from scipy.spatial import cKDTree

from gaussiancad_core.coordinates.grid_tolerances import MEETING
from gaussiancad_core.geometry.whole_curves import Circle, meetings
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine, whole_circle

_CLOSE, _REACH = 0.45, 1.6
"""Grid steps between two ends that are one; and of an end that meets no other one."""

_SAME_CENTRE, _SAME_RADIUS = 1.2, 0.8
"""Grid steps between the centres, and radii, of arcs that are pieces of one circle."""

_NEARLY_ROUND = radians(300.0)
"""Turn of such pieces together at least."""

_BEYOND = 0.2
"""Grid steps by which an end that is led on crosses the line it is led to."""


def tidied(lines: Sequence[PlaneLine], grid: float) -> list[PlaneLine]:
    """Lines of a plane whose ends meet.

    Args:
        lines: mm.
        grid: mm of a step of the sheet's coordinates.
    """
    return _with_joined_ends(with_whole_circles(lines, grid), grid)


def with_whole_circles(lines: Sequence[PlaneLine], grid: float) -> list[PlaneLine]:
    """The lines, arcs that are pieces of one circle as this circle.

    Args:
        lines: mm.
        grid: mm of a step of the sheet's coordinates.
    """
    found = [line for line in lines if line.circle is None or line.is_closed]
    left = [line for line in lines if line.circle is not None and not line.is_closed]
    while left:
        first = left[0]
        alike = [line for line in left if _is_same_circle(line.arc, first.arc, grid)]
        turn = sum(line.length / line.arc.radius for line in alike)
        if len(alike) > 1 and turn > _NEARLY_ROUND:
            found.append(_merged(alike))
        else:
            alike = [first]
            found.append(first)
        left = [line for line in left if not any(line is other for other in alike)]
    return found


def _is_same_circle(one: Circle, other: Circle, grid: float) -> bool:
    apart = np.hypot(*np.subtract(one.centre, other.centre))
    return bool(
        apart < _SAME_CENTRE * grid and abs(one.radius - other.radius) < _SAME_RADIUS * grid
    )


def _merged(arcs: Sequence[PlaneLine]) -> PlaneLine:
    weights = [arc.length for arc in arcs]
    x, y = np.average([arc.arc.centre for arc in arcs], axis=0, weights=weights).tolist()
    radius = float(np.average([arc.arc.radius for arc in arcs], weights=weights))
    visible = any(arc.is_visible for arc in arcs)
    return whole_circle(Circle((x, y), radius), visible, arcs[0].stroke)


def _with_joined_ends(lines: Sequence[PlaneLine], grid: float) -> list[PlaneLine]:
    chains = [line.points.copy() for line in lines]
    ends = [(k, end) for k, line in enumerate(lines) if not line.is_closed for end in (0, -1)]
    if not ends:
        return list(lines)
    places = np.array([chains[k][end] for k, end in ends])
    tails: list[PlaneLine] = []
    shapes = np.array([shapely.LineString(chain) for chain in chains])
    owners = [k for k, _ in ends]
    for group in _groups(places, owners, _to_others(places, owners, chains, grid), grid):
        if len(group) > 1:
            middle = _meeting([lines[ends[member][0]] for member in group], places[group], grid)
            for member in group:
                k, end = ends[member]
                chains[k][end] = middle
                shapes[k] = shapely.LineString(chains[k])
        else:
            k, end = ends[group[0]]
            place, adjacent = chains[k][end].copy(), np.delete(shapes, k)
            chains[k][end] = _led_on(chains[k], end, grid)
            shapes[k] = shapely.LineString(chains[k])
            tails += _tail(place, adjacent, lines[k].is_visible, grid)
    moved = [replace(line, points=chain) for line, chain in zip(lines, chains, strict=True)]
    return moved + tails


def _meeting(lines: Sequence[PlaneLine], places: Floats, grid: float) -> Floats:
    """(2,) where lines meet whose ends are one: on two of their curves, if that is near.

    Args:
        lines: longest ones count first.
        places: (n, 2) their ends.
        grid: mm of a step of the sheet's coordinates.
    """
    middle = places.mean(axis=0)
    order = sorted(range(len(lines)), key=lambda k: -lines[k].length)
    curves = [curve for k in order if (curve := lines[k].curve) is not None]
    for one, other in combinations(curves, 2):
        found = np.array(meetings(one, other)).reshape(-1, 2)
        away = np.hypot(*(found - middle).T)
        if len(found) and away.min() < MEETING * grid:
            return found[int(away.argmin())]
    return middle


def _to_others(
    places: Floats, owners: Sequence[int], chains: Sequence[Floats], grid: float
) -> Floats:
    """(n,) mm from each end to where another line runs by, its own ends left out."""
    lines = [shapely.LineString(chain) for chain in chains]
    tree = shapely.STRtree(lines)
    found = np.full(len(places), np.inf)
    for number, (place, owner) in enumerate(zip(places, owners, strict=True)):
        point = shapely.Point(place)
        for other in tree.query(point.buffer(_REACH * grid)):
            line = lines[other]
            along = line.project(point)
            inside = _REACH * grid < along < line.length - _REACH * grid
            if other != owner and (inside or line.is_closed):
                found[number] = min(found[number], line.distance(point))
    return found


def _groups(
    places: Floats, owners: Sequence[int], to_others: Floats, grid: float
) -> list[list[int]]:
    """Numbers of ends that are one: all that are close, and a lone one with what is within reach,
    if no line runs by closer.

    The two ends of a line stay apart.
    """
    groups = {k: [k] for k in range(len(places))}
    of = list(range(len(places)))
    tree = cKDTree(places)
    for reach in (_CLOSE, _REACH):
        pairs = tree.query_pairs(reach * grid)
        for a, b in sorted(pairs, key=lambda pair: np.hypot(*(places[pair[0]] - places[pair[1]]))):
            one, other = of[a], of[b]
            if one == other or {owners[k] for k in groups[one]} & {
                owners[k] for k in groups[other]
            }:
                continue
            if reach == _REACH:
                lone = [k for k in (a, b) if len(groups[of[k]]) == 1]
                apart = np.hypot(*(places[a] - places[b]))
                if not lone or any(to_others[k] < apart for k in lone):
                    continue
            for k in groups[other]:
                of[k] = one
            groups[one] += groups.pop(other)
    return list(groups.values())


def _led_on(chain: Floats, end: int, grid: float) -> Floats:
    """(2,) an end of a chain that goes on a little."""
    way = chain[end] - chain[1 if end == 0 else -2]
    length = float(np.hypot(*way))
    return chain[end] + way / length * _REACH * grid if length > 0.0 else chain[end]


def _tail(
    place: Floats, others: npt.NDArray[np.object_], is_visible: bool, grid: float
) -> list[PlaneLine]:
    """What leads a lone end on to the nearest of the other lines."""
    if not len(others):
        return []
    point = shapely.Point(place)
    away = shapely.distance(others, point)
    nearest = int(away.argmin())
    if not 1e-9 < away[nearest] < _REACH * grid:
        return []
    line = others[nearest]
    at = shapely.get_coordinates(line.interpolate(line.project(point)))[0]
    beyond = at + (at - place) / away[nearest] * _BEYOND * grid
    return [PlaneLine(np.array([place, beyond]), is_visible)]
