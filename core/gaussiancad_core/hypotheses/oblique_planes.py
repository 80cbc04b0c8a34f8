"""Which planes that are edge-on in no view the drawing speaks of.

All edges of a face on such a plane are straight where another plane ends it, and slanted in one
view at least.  Two of them that share a corner span a plane; it may hold a face if edges in it
close a loop.
"""

from collections import defaultdict
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import numpy.typing as npt
from scipy.spatial import ConvexHull

from gaussiancad_core.cells.half_spaces import HalfSpace
from gaussiancad_core.cells.space_corners import SpatialEdges, spatial_edges
from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.geometry.tolerances import SAME_PLACE, TELLING
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.axes import Axis, Vector
from gaussiancad_core.model.projection_planes import IN_PLANE

_MOST = 64
"""Planes that are looked at: each one divides cells."""

SHORT = 10.0
"""Tolerances by which slanted lines may end too early: at sharp angles lines run into each other
before they meet."""

_PARALLEL = 0.01
"""Sine of the angle from which two edges span a plane."""

Points = npt.NDArray[np.float64]
Plane = tuple[npt.NDArray[np.float64], float]
"""Unit normal and offset."""


def find_half_spaces(carriers: PartCarriers) -> tuple[HalfSpace, ...]:
    """Half spaces below the planes in which slanted edges close loops; the largest faces first."""
    near = max(SAME_PLACE, 2.0 * carriers.tolerance)
    shown = spatial_edges(carriers, near, SHORT * carriers.tolerance)
    candidates = _candidates(shown, near)
    candidates.sort(key=lambda candidate: -candidate.area)
    found = _settled([candidate.half_space for candidate in candidates[:_MOST]], carriers)
    flat = _known_planes(carriers)
    return tuple(
        replace(body, creases=tuple(_creases(body, [*flat, *_others(found, body)], near)))
        for body in found
    )


@dataclass(frozen=True)
class _Candidate:
    half_space: HalfSpace
    area: float


def _candidates(shown: SpatialEdges, near: float) -> list[_Candidate]:
    points = shown.points
    at_corner: dict[int, list[int]] = defaultdict(list)
    for one, other in shown.edges:
        at_corner[one].append(other)
        at_corner[other].append(one)
    intervals = []
    for corner, others in at_corner.items():
        for one, other in combinations(others, 2):
            ways = points[[one, other]] - points[corner]
            area = float(np.linalg.norm(np.cross(*ways)))
            if area > _PARALLEL * float(np.prod(np.linalg.norm(ways, axis=1))):
                intervals.append((-area, corner, one, other))
    done: set[tuple[int, int, int]] = set()
    found = []
    for _, corner, one, other in sorted(intervals):
        if (corner, one, other) in done:
            continue
        plane = _fitted(points[[corner, one, other]])
        edges = _edges_in(shown, plane, near)
        corners = sorted({corner for edge in edges for corner in edge} | {corner, one, other})
        inside = set(corners)
        for member in corners:
            ends = [end for end in at_corner[member] if end in inside]
            done.update((member, *pair) for pair in combinations(ends, 2))
        candidate = _candidate(points, edges, near)
        if candidate is not None:
            found.append(candidate)
    return found


def _fitted(points: Points) -> Plane:
    """The plane nearest to points; the normal's last component is positive."""
    middle = points.mean(0)
    normal = np.linalg.svd(points - middle)[2][-1]
    if normal[2] < 0.0:
        normal = -normal
    return normal, float(normal @ middle)


def _edges_in(shown: SpatialEdges, plane: Plane, near: float) -> list[tuple[int, int]]:
    on = np.abs(shown.points @ plane[0] - plane[1]) <= near
    return [edge for edge in shown.edges if on[edge[0]] and on[edge[1]]]


def _candidate(points: Points, edges: list[tuple[int, int]], near: float) -> _Candidate | None:
    """The plane of edges with the hulls of their loops; None without a loop, or edge-on."""
    loops = _loops(edges)
    if not loops:
        return None
    normal, offset = _fitted(points[sorted({corner for loop in loops for corner in loop})])
    hulls, area = [], 0.0
    for loop in loops:
        point = points[loop]
        extent = float(np.ptp(point, axis=0).max())
        if np.abs(normal).min() * extent <= TELLING * near:
            continue
        view = Axis(int(np.abs(normal).argmax()))
        hull = ConvexHull(point[:, IN_PLANE[view]])
        hulls.append(tuple(_vector(point[corner]) for corner in hull.vertices))
        area += float(hull.volume) / float(np.abs(normal).max())
    if not hulls:
        return None
    return _Candidate(HalfSpace(_vector(normal), offset, tuple(hulls)), area)


def _loops(edges: list[tuple[int, int]]) -> list[list[int]]:
    """Corners of each connected set of edges that is left when loose ends are taken off."""
    linked: dict[int, set[int]] = defaultdict(set)
    for one, other in edges:
        linked[one].add(other)
        linked[other].add(one)
    loose = [corner for corner, others in linked.items() if len(others) == 1]
    while loose:
        corner = loose.pop()
        for other in linked.pop(corner, ()):
            linked[other].discard(corner)
            if len(linked[other]) == 1:
                loose.append(other)
    found = []
    left = {corner for corner, others in linked.items() if others}
    while left:
        group, front = set(), [min(left)]
        while front:
            corner = front.pop()
            if corner not in group:
                group.add(corner)
                front += linked[corner]
        left -= group
        found.append(sorted(group))
    return found


def _settled(bodies: list[HalfSpace], carriers: PartCarriers) -> list[HalfSpace]:
    """Half spaces whose corners lie exactly on all planes that meet in them."""
    rows: dict[Vector, list[tuple[Vector, float]]] = defaultdict(list)
    for body in bodies:
        for hull in body.hulls:
            for corner in hull:
                rows[corner].append((body.normal, body.offset))
    settled: dict[Vector, Vector] = {}
    for corner, planes in rows.items():
        for axis in Axis:
            if corner[axis.value] in carriers.values[axis]:
                planes.append((_vector(np.eye(3)[axis.value]), corner[axis.value]))
        normals = np.array([normal for normal, _ in planes])
        missing = np.array([offset for _, offset in planes]) - normals @ np.array(corner)
        settled[corner] = _vector(np.array(corner) + np.linalg.pinv(normals, 1e-3) @ missing)
    return [
        replace(body, hulls=tuple(tuple(settled[c] for c in hull) for hull in body.hulls))
        for body in bodies
    ]


def _known_planes(carriers: PartCarriers) -> list[Plane]:
    """Planes at right angles to an axis, and those that some view sees edge-on."""
    found = []
    for axis in Axis:
        normal = np.eye(3)[axis.value]
        found += [(normal, value) for value in carriers.values[axis]]
    for view, plane in carriers.planes.items():
        for carrier in plane.carriers:
            curve = carrier.curve
            if isinstance(curve, Line) and curve.axis is None:
                normal = np.zeros(3)
                normal[list(IN_PLANE[view])] = curve.normal(0.0)
                point = np.zeros(3)
                point[list(IN_PLANE[view])] = curve.point
                found.append((normal, float(normal @ point)))
    return found


def _others(bodies: list[HalfSpace], body: HalfSpace) -> list[Plane]:
    return [(np.array(other.normal), other.offset) for other in bodies if other is not body]


def _creases(body: HalfSpace, planes: list[Plane], near: float) -> list[tuple[Vector, Vector]]:
    """Where planes cut the hulls of a half space, but for the hulls' own edges."""
    found = []
    for hull in body.hulls:
        corners = np.array(hull)
        following = np.roll(corners, -1, axis=0)
        for normal, offset in planes:
            here = corners @ normal - offset
            here[np.abs(here) < near] = 0.0
            after = np.roll(here, -1)
            if not (here.min() < 0.0 < here.max()):
                continue
            ends = [corners[i] for i in np.flatnonzero(here == 0.0)]
            for i in np.flatnonzero(here * after < 0.0):
                share = here[i] / (here[i] - after[i])
                ends.append(corners[i] + share * (following[i] - corners[i]))
            if len(ends) == 2:
                found.append((_vector(ends[0]), _vector(ends[1])))
    return found


def _vector(point: Points) -> Vector:
    x, y, z = (float(value) for value in point)
    return x, y, z
