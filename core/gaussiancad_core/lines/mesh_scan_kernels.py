"""Triangles to pixels: which rays through the pixels' centres cross which triangle, and where.

Both triangles at an edge weigh a pixel on it by the same numbers with opposite signs, so that no
ray slips through between them; one that runs through the edge itself crosses both.
"""

import numpy as np
from numba import njit

_NARROW = 8
"""px of a triangle's width below which all its pixels are looked at."""


@njit(cache=True, error_model="numpy")
def scan_first(corners, depth, triangle, weights):  # noqa: ANN001, ANN201
    """Find the nearest triangle at each pixel.

    Args:
        corners: (m, 3, 3) px right and down from the first pixel's centre, and depth in mm.
        depth: (h, w) float64, infinite; receives mm.
        triangle: (h, w) int64, -1; receives the triangle.
        weights: (h, w, 3) float32; receives the barycentric weights of its corners.
    """
    height, width = depth.shape
    for number in range(len(corners)):
        corner = corners[number]
        left, right, top, bottom = _bounds(corner, width, height)
        if left > right or top > bottom:
            continue
        area = _edge(corner, 0, 1, corner[2, 0], corner[2, 1])
        if area == 0.0:
            continue
        for y in range(top, bottom + 1):
            begin, end = _span(corner, area, left, right, y)
            for x in range(begin, end + 1):
                first = _edge(corner, 1, 2, x, y) / area
                second = _edge(corner, 2, 0, x, y) / area
                third = _edge(corner, 0, 1, x, y) / area
                if first < 0.0 or second < 0.0 or third < 0.0:
                    continue
                there = _depth(corner, first, second, third)
                if there < depth[y, x]:
                    depth[y, x] = there
                    triangle[y, x] = number
                    weights[y, x, 0] = first
                    weights[y, x, 1] = second
                    weights[y, x, 2] = third


@njit(cache=True, error_model="numpy")
def scan_all(corners, height, width):  # noqa: ANN001, ANN201
    """Find all triangles at each pixel.

    Args:
        corners: (m, 3, 3) as above.
        height, width: px.

    Returns:
        (n,) int64 pixels, row by row; (n,) float32 mm of depth; (n,) int64 triangles; in the order
        of the triangles.
    """
    count = _cross(corners, height, width, None)
    hits = (
        np.empty(count, dtype=np.int64),
        np.empty(count, dtype=np.float32),
        np.empty(count, dtype=np.int64),
    )
    _cross(corners, height, width, hits)
    return hits


@njit(cache=True, error_model="numpy")
def _cross(corners, height, width, hits):  # noqa: ANN001, ANN202
    """Number of crossings; they are written down where there is room for them."""
    count = 0
    for number in range(len(corners)):
        corner = corners[number]
        left, right, top, bottom = _bounds(corner, width, height)
        if left > right or top > bottom:
            continue
        area = _edge(corner, 0, 1, corner[2, 0], corner[2, 1])
        if area == 0.0:
            continue
        for y in range(top, bottom + 1):
            begin, end = _span(corner, area, left, right, y)
            for x in range(begin, end + 1):
                first = _edge(corner, 1, 2, x, y) / area
                second = _edge(corner, 2, 0, x, y) / area
                third = _edge(corner, 0, 1, x, y) / area
                if first < 0.0 or second < 0.0 or third < 0.0:
                    continue
                if hits is not None:
                    hits[0][count] = y * width + x
                    hits[1][count] = _depth(corner, first, second, third)
                    hits[2][count] = number
                count += 1
    return count


@njit(cache=True, error_model="numpy")
def _bounds(corner, width, height):  # noqa: ANN001, ANN202
    """First and last column, first and last row of the pixels that a triangle may cover."""
    left = max(0, int(np.ceil(min(corner[0, 0], corner[1, 0], corner[2, 0]))))
    right = min(width - 1, int(np.floor(max(corner[0, 0], corner[1, 0], corner[2, 0]))))
    top = max(0, int(np.ceil(min(corner[0, 1], corner[1, 1], corner[2, 1]))))
    bottom = min(height - 1, int(np.floor(max(corner[0, 1], corner[1, 1], corner[2, 1]))))
    return left, right, top, bottom


@njit(cache=True, error_model="numpy")
def _span(corner, area, left, right, y):  # noqa: ANN001, ANN202
    """First and last column of a row that a triangle may cover, at most a pixel too many."""
    if right - left < _NARROW:
        return left, right
    begin, end = left, right
    for start in range(3):
        stop = (start + 1) % 3
        first = _edge(corner, start, stop, left, y) / area
        last = _edge(corner, start, stop, right, y) / area
        if first < 0.0 and last < 0.0:
            return right, left
        if first < 0.0:
            begin = max(begin, left + int((right - left) * (first / (first - last))) - 1)
        elif last < 0.0:
            end = min(end, left + int((right - left) * (first / (first - last))) + 2)
    return begin, end


@njit(cache=True, error_model="numpy")
def _edge(corner, start, end, x, y):  # noqa: ANN001, ANN202
    """Twice the area between an edge and a point; of either direction the same but for its sign."""
    ax, ay, bx, by = corner[start, 0], corner[start, 1], corner[end, 0], corner[end, 1]
    if ax < bx or (ax == bx and ay < by):
        return (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    return -((ax - bx) * (y - by) - (ay - by) * (x - bx))


@njit(cache=True, error_model="numpy")
def _depth(corner, first, second, third):  # noqa: ANN001, ANN202
    """mm; within those of the corners, whatever the rounding."""
    deep = first * corner[0, 2] + second * corner[1, 2] + third * corner[2, 2]
    least = min(corner[0, 2], corner[1, 2], corner[2, 2])
    most = max(corner[0, 2], corner[1, 2], corner[2, 2])
    return min(max(deep, least), most)
