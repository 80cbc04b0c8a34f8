"""Trace the ink that no line or circle explains: ellipses, free curves, small fillets."""

from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.skeletons import skeleton
from gaussiancad_core.model.views import Linetype, Segment

_EPSILON = 0.7
"""Largest distance in px between a traced curve and its segments."""


def trace_remainder(ink: npt.NDArray[np.bool_], stroke_width: float, dash: float) -> list[Segment]:
    """Chains of segments along the components of some ink.

    Args:
        ink: (h, w) bool.
        stroke_width: px; shorter remains are blots at junctions.
        dash: px, the sheet's dash length; components much longer are visible.
    """
    shortest = 1.5 * stroke_width + 3.0
    labels, boxes = _components(skeleton(ink))
    segments: list[Segment] = []
    for label, (x0, y0, w, h, length) in enumerate(boxes, start=1):
        if length < shortest:
            continue
        linetype = Linetype.VISIBLE if length > 1.75 * dash else Linetype.HIDDEN
        pixels = labels[y0 : y0 + h, x0 : x0 + w] == label
        for path in _paths(pixels, shortest):
            chain = (path + np.array([x0, y0])).astype(np.float32)
            corners = cv2.approxPolyDP(chain[:, None], _EPSILON, False)[:, 0]
            for start, end in pairwise(corners):
                ends = (float(start[0]), float(start[1])), (float(end[0]), float(end[1]))
                segments.append(Segment(*ends, linetype, 0.5))
    return segments


def _components(
    pixels: npt.NDArray[np.bool_],
) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]:
    """Labels from 1 of the connected components, and x, y, width, height, area of each."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(pixels.astype(np.uint8), connectivity=8)
    return np.asarray(labels, dtype=np.int32), np.asarray(stats[1:], dtype=np.int32)


def _paths(pixels: npt.NDArray[np.bool_], shortest: float) -> list[npt.NDArray[np.int64]]:
    """Paths that cover a thin component: the longest, then those of what is left beside it.

    A closed loop takes two, as the longest path between two pixels goes half around it.
    """
    paths = []
    todo = [pixels]
    while todo:
        current = todo.pop()
        path = _longest_path(current)
        paths.append(path)
        covered = np.zeros(current.shape, np.uint8)
        cv2.polylines(covered, [path.astype(np.int32)], False, 1, 3)
        labels, boxes = _components(current & (covered == 0))
        todo += [labels == i for i, box in enumerate(boxes, start=1) if box[4] >= shortest]
    return paths


def _longest_path(pixels: npt.NDArray[np.bool_]) -> npt.NDArray[np.int64]:
    """(n, 2) x, y along the longest path of a thin component."""
    ys, xs = np.nonzero(pixels)
    position = {(int(x), int(y)): i for i, (x, y) in enumerate(zip(xs, ys, strict=True))}
    points = list(position)
    far = _walk(points[0], position)[-1]
    path = _walk(far, position)
    return np.array(path, dtype=np.int64)


def _walk(start: tuple[int, int], position: dict[tuple[int, int], int]) -> list[tuple[int, int]]:
    """The path from ``start`` to the pixel furthest from it, breadth first."""
    previous: dict[tuple[int, int], tuple[int, int] | None] = {start: None}
    frontier = [start]
    last = start
    while frontier:
        last = frontier[0]
        following = []
        for x, y in frontier:
            for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)):
                pixel = (x + dx, y + dy)
                if pixel in position and pixel not in previous:
                    previous[pixel] = (x, y)
                    following.append(pixel)
        frontier = following
    path = []
    at: tuple[int, int] | None = last
    while at is not None:
        path.append(at)
        at = previous[at]
    return path
