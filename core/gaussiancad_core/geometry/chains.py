"""Line segments, and chains of them along free curves."""

from dataclasses import dataclass, replace
from math import ceil, hypot
from typing import Self

import numpy as np

from gaussiancad_core.geometry.points import Box, Point, Points, box_around, to_point
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.geometry.whole_curves import Line


@dataclass(frozen=True)
class LineSegment:
    """A straight piece.

    Attributes:
        start, end: (2,) in the plane of whoever holds the curve.
    """

    start: Point
    end: Point

    is_closed = False
    """It does not end where it begins."""

    @property
    def carrier(self) -> Line:
        """The line that it is a piece of, from start to end, which are two points."""
        (x0, y0), (x1, y1), length = self.start, self.end, self.length
        return Line(self.start, ((x1 - x0) / length, (y1 - y0) / length))

    @property
    def length(self) -> float:
        """Distance between the ends."""
        return hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])

    @property
    def box(self) -> Box:
        """Around it."""
        (x0, y0), (x1, y1) = self.start, self.end
        return min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)

    def extremes(self) -> Points:
        """(2, 2) both ends: it nowhere turns back."""
        return np.array([self.start, self.end])

    def sample(self, step: float) -> Points:
        """(n, 2) even points along the curve, at most ``step`` apart, both ends included."""
        return np.linspace(self.start, self.end, max(2, ceil(self.length / step) + 1))

    def vertices(self, step: float) -> Points:
        """(n, 2) corners of a chain along the curve, at most ``step`` apart, ends included."""
        return self.sample(step)

    def points_at(self, along: Points) -> Points:
        """(n, 2) points at lengths along the curve; before and after it, on its line."""
        start, end = np.array(self.start), np.array(self.end)
        return start + along[:, None] / self.length * (end - start)

    def distances(self, points: Points) -> Points:
        """(n,) distances of (n, 2) points."""
        return chain_distances(points, np.array([self.start, self.end]))

    def part(self, low: float, high: float) -> Self:
        """Between two lengths along it; it is prolonged to those before its start and after its
        end."""
        start, end = (to_point(point) for point in self.points_at(np.array([low, high])))
        return replace(self, start=start, end=end)

    def mapped(self, by: Similarity) -> Self:
        """Its image."""
        return replace(self, start=by.point(self.start), end=by.point(self.end))


@dataclass(frozen=True)
class Chain:
    """Line segments that follow a free curve.

    Attributes:
        points: two or more (2,) points in the plane of whoever holds the curve; a closed one
            repeats its first point at the end.
    """

    points: tuple[Point, ...]

    @property
    def is_closed(self) -> bool:
        """Whether it ends where it begins."""
        return self.points[0] == self.points[-1]

    @property
    def length(self) -> float:
        """Length along the chain."""
        return float(self.along[-1])

    @property
    def along(self) -> Points:
        """(n,) lengths along the chain up to each of its points."""
        steps = np.diff(np.array(self.points), axis=0)
        return np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])

    @property
    def box(self) -> Box:
        """Around it."""
        return box_around(np.array(self.points))

    def sample(self, step: float) -> Points:
        """(n, 2) even points along the curve, at most ``step`` apart, both ends included."""
        length = self.length
        return self.points_at(np.linspace(0.0, length, max(2, ceil(length / step) + 1)))

    def vertices(self, step: float) -> Points:
        """(n, 2) corners of a chain along the curve, at most ``step`` apart: all of its points,
        and points between those."""
        corners = np.array(self.points)
        ways = np.diff(corners, axis=0)
        lengths = np.hypot(ways[:, 0], ways[:, 1])
        counts = np.maximum(np.ceil(lengths / step), 1.0).astype(np.int64)
        if int(counts.max()) == 1:
            return corners
        piece = np.repeat(np.arange(len(ways)), counts)
        number = np.arange(len(piece)) - np.repeat(np.cumsum(counts) - counts, counts)
        points = corners[piece] + number[:, None] * (ways / counts[:, None])[piece]
        return np.concatenate([points, corners[-1:]])

    def points_at(self, along: Points) -> Points:
        """(n, 2) points at lengths along the curve; before and after it, its ends."""
        corners, places = np.array(self.points), self.along
        return np.stack([np.interp(along, places, column) for column in corners.T], axis=1)

    def distances(self, points: Points) -> Points:
        """(n,) distances of (n, 2) points."""
        return chain_distances(points, np.array(self.points))

    def part(self, low: float, high: float) -> Self:
        """Between two lengths along it.

        An open one is prolonged to those before its start and after its end; on a closed one
        lengths before the start lie before its end.
        """
        corners, along = np.array(self.points), self.along
        if low < 0.0 and self.is_closed:
            corners = np.concatenate([corners[:-1], corners])
            along = np.concatenate([along[:-1] - along[-1], along])
        inner = (along > low) & (along < high)
        points = [_on_chain(corners, along, low), *corners[inner], _on_chain(corners, along, high)]
        return replace(self, points=tuple(to_point(point) for point in points))

    def mapped(self, by: Similarity) -> Self:
        """Its image."""
        return replace(self, points=tuple(by.point(point) for point in self.points))


def chain_distances(points: Points, chain: Points) -> Points:
    """(n,) distances of (n, 2) points from the chain of (m, 2) corners."""
    starts, ways = chain[:-1], np.diff(chain, axis=0)
    squares = np.maximum((ways**2).sum(axis=1), 1e-300)
    offsets = points[:, None, :] - starts[None]
    shares = np.clip((offsets * ways).sum(axis=2) / squares, 0.0, 1.0)
    nearest = offsets - shares[..., None] * ways
    return np.sqrt((nearest**2).sum(axis=2).min(axis=1))


def _on_chain(corners: Points, along: Points, at: float) -> Points:
    """(2,) point at a length along a chain; before and after it, on its first and last segment."""
    inside = float(np.clip(at, along[0], along[-1]))
    point = np.array([np.interp(inside, along, column) for column in corners.T])
    if at != inside:
        way = corners[1] - corners[0] if at < inside else corners[-1] - corners[-2]
        # Chains may hold a point twice; they are then not prolonged.
        point += (at - inside) * way / max(float(np.hypot(*way)), 1e-300)
    return point


def simplified(points: Points, slack: float) -> Points:
    """The corners that a chain needs (Douglas and Peucker 1973).

    Args:
        points: (n, 2), the corners that it has.
        slack: distance, above 0, that none of them is further from the new chain.

    Returns:
        (k, 2) some of the points, the first and the last among them.
    """
    kept = np.zeros(len(points), dtype=bool)
    kept[[0, -1]] = True
    stretches = [(0, len(points) - 1)]
    while stretches:
        first, last = stretches.pop()
        distances = _from_segment(points[first + 1 : last], points[first], points[last])
        if (distances > slack).any():
            furthest = first + 1 + int(distances.argmax())
            kept[furthest] = True
            stretches += [(furthest, last), (first, furthest)]
    return points[kept]


def _from_segment(points: Points, start: Points, end: Points) -> Points:
    """(n,) distances of (n, 2) points from a straight piece; its ends may be one."""
    along = end - start
    angle = -np.arctan2(along[0], along[1])
    normal = np.array([np.cos(angle), np.sin(angle)])
    # Points beside an even curve are equally far off: of those rounding decides, so the order of
    # the operations is kept.
    level = start[1] * normal[1] + start[0] * normal[0]
    from_start, from_end = points - start, points - end
    is_opposite = (from_start[:, 0] * along[0] + from_start[:, 1] * along[1] > 0.0) & (
        -from_end[:, 0] * along[0] - from_end[:, 1] * along[1] > 0.0
    )
    across = np.abs(points[:, 0] * normal[0] + points[:, 1] * normal[1] - level)
    outside = np.minimum(
        np.sqrt(from_start[:, 1] ** 2 + from_start[:, 0] ** 2),
        np.sqrt(from_end[:, 1] ** 2 + from_end[:, 0] ** 2),
    )
    return np.where(is_opposite, across, outside)
