"""Points and straight edges in space that all three views show.

A corner between two edges that are not parallel is, in each view, a place where lines meet.  Places
of three views that share their coordinates may be one corner; two corners may be ends of an edge if
each view draws the line between them.
"""

from collections import defaultdict
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.coordinates.carriers import PartCarriers, PlaneCarriers
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Line, meetings
from gaussiancad_core.model.axes import Axis

_MOST = 4000
"""Corners that are looked at: parts with more have too many coincidences to tell edges."""


@dataclass(frozen=True)
class SpatialEdges:
    """What the views may show in space.

    Attributes:
        points: (n, 3) corners in units.
        edges: pairs of their indices; no edge passes through another corner.
    """

    points: npt.NDArray[np.float64]
    edges: tuple[tuple[int, int], ...]


class _Places:
    """Places of a plane where drawn curves meet.

    Attributes:
        points: (n, 2).
        lines: of each place the straight carriers that are drawn there.
    """

    def __init__(self, plane: PlaneCarriers, near: float, short: float) -> None:
        self._near = near
        self._short = max(near, short)
        self._curves = [carrier.curve for carrier in plane.carriers]
        self._drawn = [carrier.drawn(near) for carrier in plane.carriers]
        self.points = np.array(_merged(self._meetings(), near)).reshape(-1, 2)
        self.lines: list[set[int]] = [set() for _ in self.points]
        for index, curve in enumerate(self._curves):
            if isinstance(curve, Line):
                for place in np.flatnonzero(self._on_line(index, curve)):
                    self.lines[place].add(index)

    def _on_line(self, index: int, curve: Line) -> npt.NDArray[np.bool_]:
        """Which of the places a line is drawn at."""
        off = self.points - np.array(curve.point)
        (dx, dy), slack = curve.direction, self._slack(index)
        along = off @ np.array(curve.direction)
        drawn = np.zeros(len(off), dtype=np.bool_)
        for low, high in self._drawn[index]:
            drawn |= (low - slack <= along) & (along <= high + slack)
        return drawn & (np.abs(off[:, 1] * dx - off[:, 0] * dy) <= self._near)

    def _meetings(self) -> list[Point]:
        found = []
        for one, other in combinations(range(len(self._curves)), 2):
            for point in meetings(self._curves[one], self._curves[other]):
                if self._is_drawn(one, point) and self._is_drawn(other, point):
                    found.append(point)
        return found

    def _is_drawn(self, index: int, point: Point) -> bool:
        curve = self._curves[index]
        if curve.distance(point) > self._near:
            return False
        at, slack = curve.parameter(point), self._slack(index)
        return any(low - slack <= at <= high + slack for low, high in self._drawn[index])

    def _slack(self, index: int) -> float:
        """By how much a curve may end too early, in its parameter."""
        curve = self._curves[index]
        slanted = isinstance(curve, Line) and curve.axis is None
        return (self._short if slanted else self._near) / curve.speed

    def slanted(self, place: int) -> list[int]:
        """The slanted lines of a place."""
        return [index for index in self.lines[place] if self._curves[index].axis is None]

    def joined(self, one: int, other: int) -> bool:
        """Whether a line is drawn from place to place."""
        for index in self.lines[one] & self.lines[other]:
            curve = self._curves[index]
            low, high = sorted(curve.parameter(tuple(self.points[i])) for i in (one, other))
            slack = self._slack(index)
            for start, end in self._drawn[index]:
                if start - slack <= low and high <= end + slack:
                    return True
        return False


def spatial_edges(carriers: PartCarriers, near: float, short: float = 0.0) -> SpatialEdges:
    """Slanted edges that three views show.

    Args:
        carriers: of all three planes, or there are none.
        near: units within which coordinates are the same.
        short: units by which slanted lines may end too early, where they run into others.
    """
    nothing = SpatialEdges(np.empty((0, 3)), ())
    if len(carriers.planes) < len(Axis) or not _has_slants(carriers):
        return nothing
    planes = [_Places(carriers.planes[axis], near, short) for axis in Axis]
    if any(not len(plane.points) for plane in planes):
        return nothing
    points, places = _corners(planes, near, carriers)
    if not 0 < len(points) <= _MOST:
        return nothing
    pairs: set[tuple[int, int]] = set()
    for axis, plane in zip(Axis, planes, strict=True):
        along: dict[int, list[int]] = defaultdict(list)
        for corner, place in enumerate(places[:, axis.value]):
            for line in plane.slanted(int(place)):
                along[line].append(corner)
        for corners in along.values():
            pairs.update(pair for pair in combinations(corners, 2) if _shown(planes, places, pair))
    return SpatialEdges(points, tuple(_without_corners_between(points, sorted(pairs), near)))


def _has_slants(carriers: PartCarriers) -> bool:
    return any(
        isinstance(carrier.curve, Line) and carrier.curve.axis is None
        for plane in carriers.planes.values()
        for carrier in plane.carriers
    )


def _corners(
    planes: list[_Places], near: float, carriers: PartCarriers
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """(n, 3) points that all views show, and (n, 3) the places that show them."""
    sides, fronts, tops = (plane.points for plane in planes)
    tree = cKDTree(sides)
    by_x = cKDTree(fronts[:, :1])
    found, places = [], []
    for top, (x, y) in enumerate(tops):
        for front in by_x.query_ball_point([x], near):
            x_front, z = fronts[front]
            for side in tree.query_ball_point([y, z], 1.5 * near):
                y_side, z_side = sides[side]
                found.append(((x + x_front) / 2.0, (y + y_side) / 2.0, (z + z_side) / 2.0))
                places.append((side, front, top))
    points = np.array(found).reshape(-1, 3)
    for axis in Axis:
        values = np.array(sorted(carriers.values[axis]))
        if len(values) and len(points):
            nearest = values[np.abs(points[:, axis.value, None] - values).argmin(1)]
            close = np.abs(points[:, axis.value] - nearest) <= near
            points[close, axis.value] = nearest[close]
    return points, np.array(places, dtype=np.int64).reshape(-1, 3)


def _shown(planes: list[_Places], places: npt.NDArray[np.int64], pair: tuple[int, int]) -> bool:
    """Whether all views draw the line between two corners."""
    return all(
        one != other and plane.joined(int(one), int(other))
        for plane, one, other in zip(planes, places[pair[0]], places[pair[1]], strict=True)
    )


def _without_corners_between(
    points: npt.NDArray[np.float64], pairs: list[tuple[int, int]], near: float
) -> list[tuple[int, int]]:
    kept = []
    for one, other in pairs:
        way = points[other] - points[one]
        length = float(np.linalg.norm(way))
        along = (points - points[one]) @ way / length
        off = np.linalg.norm(points - points[one] - np.outer(along / length, way), axis=1)
        if not ((off < 2.0 * near) & (along > 2.0 * near) & (along < length - 2.0 * near)).any():
            kept.append((one, other))
    return kept


def _merged(points: list[Point], near: float) -> list[Point]:
    """Points within reach of each other as their mean."""
    if not points:
        return []
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    every = np.array(points)
    pairs = cKDTree(every).query_pairs(near, output_type="ndarray")
    shape = (len(every), len(every))
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape)
    count, groups = connected_components(graph, directed=False)
    means = [every[groups == group].mean(0) for group in range(count)]
    return [(float(a), float(b)) for a, b in means]
