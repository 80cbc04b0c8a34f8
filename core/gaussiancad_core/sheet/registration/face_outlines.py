"""The outline of a view from its exact strokes: the faces that they enclose, as a mask.

Ends that miss each other by little are joined first, the smallest gaps before wider ones; what is
left open then is open.
"""

from collections.abc import Sequence
from itertools import combinations

import cv2
import numpy as np
import numpy.typing as npt
import shapely
from shapely import LineString, Polygon

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet.registration.view_masks import Outline, Region

_GAPS_PX = (1.0, 3.0, 6.0)
"""Gaps that are closed, in turn."""

_GRID_PX = 0.1
"""px to which places are rounded, so that ends meet."""

_BARE_PX, _BARE_SHARE = 10.0, 0.02
"""How far strokes may reach beyond the faces: px, and share of a view's side."""

_SMALLEST_PX = 9.0
"""Area of a blank region at least."""

_MOST_ENDS = 200
"""Loose ends up to which what is missing between them is looked for."""

_MARGIN_PX = 4
"""Around a view."""

_SHIFT = 4
"""Binary digits behind the point in which OpenCV takes places."""


def outline_of_strokes(
    curves: Sequence[npt.NDArray[np.float64]], box: Box, supersampling: int
) -> Outline | None:
    """What the visible strokes of a view enclose; None where that is open.

    Args:
        curves: (n, 2) px along each stroke.
        box: around them, px.
        supersampling: mask px per sheet px.
    """
    lines = [LineString(points) for points in curves if len(points) > 1]
    for gap in _GAPS_PX:
        faces = _faces(lines, gap)
        outer = _filled(faces)
        if not outer.is_empty and _spans(outer.bounds, box):
            return _outline(faces, outer, box, supersampling)
    return None


def outline_as_if_closed(
    curves: Sequence[npt.NDArray[np.float64]], box: Box, supersampling: int
) -> Outline | None:
    """What the visible strokes of a view enclose where what is missing of its outline is straight;
    None where that is nothing.

    Args:
        curves: (n, 2) px along each stroke.
        box: around them, px.
        supersampling: mask px per sheet px.
    """
    lines = [LineString(points) for points in curves if len(points) > 1]
    faces = _faces([*lines, *_between_loose_ends(lines)], _GAPS_PX[-1])
    outer = _filled(faces)
    if outer.is_empty or not _spans(outer.bounds, box):
        outer = shapely.union_all([shapely.MultiLineString(lines).convex_hull, outer])
    return _outline(faces, outer, box, supersampling) if outer.area > _SMALLEST_PX else None


def _between_loose_ends(lines: Sequence[LineString]) -> list[LineString]:
    """From loose ends to others, those nearest to each other first, each once."""
    tree, gap = shapely.STRtree(lines), _GAPS_PX[-1]
    ends = [
        (index, place)
        for index, line in enumerate(lines)
        for place in (line.coords[0], line.coords[-1])
        if line.coords[0] != line.coords[-1]
        and not set(tree.query(shapely.Point(place), "dwithin", gap).tolist()) - {index}
    ]
    if len(ends) > _MOST_ENDS:
        return []
    pairs = sorted(combinations(range(len(ends)), 2), key=lambda pair: _apart(ends, pair))
    left, found = set(range(len(ends))), []
    for one, other in pairs:
        if {one, other} <= left:
            left -= {one, other}
            found.append(LineString([ends[one][1], ends[other][1]]))
    return found


def _apart(ends: Sequence[tuple[int, tuple[float, ...]]], pair: tuple[int, int]) -> float:
    return float(np.hypot(*np.subtract(ends[pair[0]][1], ends[pair[1]][1])[:2]))


def _faces(lines: Sequence[LineString], gap: float) -> list[Polygon]:
    """The faces between lines, ends up to a gap apart joined."""
    whole = shapely.union_all([*lines, *_bridges(lines, gap)], grid_size=_GRID_PX)
    return [face for face in shapely.polygonize([whole]).geoms if face.area > 0.0]


def _bridges(lines: Sequence[LineString], gap: float) -> list[LineString]:
    """From each end that meets nothing to the nearest other line, where that is near."""
    if not lines:
        return []
    tree = shapely.STRtree(lines)
    found = []
    for index, line in enumerate(lines):
        for place in (line.coords[0], line.coords[-1]):
            end = shapely.Point(place)
            near = [n for n in tree.query(end, "dwithin", gap).tolist() if n != index]
            if not near:
                continue
            nearest = min(near, key=lambda n: lines[n].distance(end))
            if lines[nearest].distance(end) > 0.0:
                bridge = shapely.shortest_line(end, lines[nearest])
                found.append(bridge)
    return found


def _filled(faces: Sequence[Polygon]) -> shapely.Geometry:
    return shapely.coverage_union_all(faces)


def _spans(bounds: Box, box: Box) -> bool:
    """Whether what is enclosed is as large as a view: a gap may leave a part of it open."""
    off = np.abs(np.subtract(bounds, box)).reshape(2, 2)
    sides = np.subtract(box[2:], box[:2])
    return bool((off <= np.maximum(_BARE_PX, _BARE_SHARE * sides)).all())


def _outline(faces: Sequence[Polygon], outer: shapely.Geometry, box: Box, factor: int) -> Outline:
    x0, y0 = (int(np.floor(value)) - _MARGIN_PX for value in box[:2])
    x1, y1 = (int(np.ceil(value)) + _MARGIN_PX for value in box[2:])
    shape = (y1 - y0) * factor, (x1 - x0) * factor
    corner = np.array([x0, y0], dtype=np.float64)
    filled = _mask(shapely.get_parts(outer), corner, factor, shape)
    inside = cv2.distanceTransform(filled, cv2.DIST_L2, 5) - 0.5
    outside = cv2.distanceTransform(1 - filled, cv2.DIST_L2, 5) - 0.5
    depth = np.where(filled > 0, inside, -outside).astype(np.float32)
    kept = sorted(faces, key=lambda face: -face.area)
    kept = [face for face in kept if face.area >= _SMALLEST_PX]
    found = [_region(face, corner, factor, shape) for face in kept]
    regions = tuple(
        Region(mask, place, around)
        for (mask, place), around in zip(found, _parents_of(kept), strict=True)
    )
    return Outline(depth, regions, factor, (float(x0), float(y0)))


def _parents_of(faces: Sequence[Polygon]) -> list[tuple[int, ...]]:
    """Numbers of the faces that go around each of some, the innermost first."""
    parents: list[list[int]] = [[] for _ in faces]
    around = [number for number, face in enumerate(faces) if face.interiors]
    filled = np.array([Polygon(faces[number].exterior) for number in around], dtype=object)
    within = shapely.point_on_surface(np.array(faces, dtype=object))
    pairs = shapely.STRtree(within).query(filled, "contains")
    for index, inner in sorted(pairs.T.tolist(), key=lambda pair: filled[pair[0]].area):
        if inner != around[index]:
            parents[inner].append(around[index])
    return [tuple(found) for found in parents]


def _region(
    face: Polygon, corner: npt.NDArray[np.float64], factor: int, shape: tuple[int, int]
) -> tuple[npt.NDArray[np.bool_], tuple[int, int]]:
    """A face's mask, cut out, and where it begins."""
    low, high = np.array(face.bounds[:2]), np.array(face.bounds[2:])
    first = np.maximum(np.floor((low - corner) * factor).astype(int) - 2, 0)
    last = np.minimum(np.ceil((high - corner) * factor).astype(int) + 2, shape[::-1])
    size = int(last[1] - first[1]), int(last[0] - first[0])
    mask = _mask([face], corner + first / factor, factor, size)
    return mask > 0, (int(first[0]), int(first[1]))


def _mask(
    polygons: Sequence[Polygon],
    corner: npt.NDArray[np.float64],
    factor: int,
    shape: tuple[int, int],
) -> npt.NDArray[np.uint8]:
    """(h, w) 1 within polygons, holes left out."""
    mask = np.zeros(shape, np.uint8)
    for polygon in polygons:
        rings = [polygon.exterior, *polygon.interiors]
        places = [
            np.rint(((np.array(ring.coords) - corner) * factor - 0.5) * 2**_SHIFT).astype(np.int32)
            for ring in rings
        ]
        cv2.fillPoly(mask, places, 1, cv2.LINE_8, _SHIFT)
    return mask
