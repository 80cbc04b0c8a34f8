"""Chains: drawn curves that are neither lines nor circles, as points.

They are the projections of curves in which round or slanted surfaces meet, and tell no surface by
themselves.  The projection of a closed curve in space often runs out and back along one way.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, line_through, meetings

Chain = tuple[Point, ...]

_TURNING = -0.5
"""Cosine of the angle between two links from which the curve turns back."""


def single_runs(points: npt.NDArray[np.float64], near: float) -> list[Chain]:
    """The runs of a curve between its turning points, without those that repeat earlier ones.

    Args:
        points: (n, 2) along the curve.
        near: how close a run may come to an earlier one and be another.
    """
    links = np.diff(points, axis=0)
    lengths = np.hypot(*links.T)
    kept = np.concatenate([[True], lengths > 1e-9])
    points, links = points[kept], links[lengths > 1e-9]
    if len(points) < 2:
        return []
    units = links / np.hypot(*links.T)[:, None]
    turns = np.flatnonzero((units[1:] * units[:-1]).sum(axis=1) < _TURNING) + 1
    bounds = [0, *(int(turn) for turn in turns), len(points) - 1]
    runs: list[npt.NDArray[np.float64]] = []
    for low, high in pairwise(bounds):
        run = points[low : high + 1]
        if not any(_runs_along(run, other, near) for other in runs):
            runs.append(run)
    if len(bounds) > 2 and np.hypot(*(points[0] - points[-1])) < near and len(runs) > 1:
        # A closed curve may begin amid a run: its first and last runs are parts of one.
        runs = [run for i, run in enumerate(runs) if not _covered(i, runs, near)]
    return [tuple((float(a), float(b)) for a, b in run) for run in runs]


def _runs_along(run: npt.NDArray[np.float64], other: npt.NDArray[np.float64], near: float) -> bool:
    """Whether all of a run lies on another."""
    return bool(chain_distances(other, run).max() < near)


def _covered(number: int, runs: list[npt.NDArray[np.float64]], near: float) -> bool:
    return any(
        other is not runs[number]
        and len(other) > len(runs[number])
        and _runs_along(runs[number], other, near)
        for other in runs
    )


def through_points(
    chain: npt.NDArray[np.float64], targets: npt.NDArray[np.float64], near: float
) -> Chain:
    """The chain with those of (n, 2) targets as further points that lie within ``near`` of it."""
    starts, intervals = chain[:-1], np.diff(chain, axis=0)
    squares = np.maximum((intervals**2).sum(axis=1), 1e-300)
    offsets = targets[:, None, :] - starts[None]
    shares = np.clip((offsets * intervals).sum(axis=2) / squares, 0.0, 1.0)
    away = np.sqrt(((offsets - shares[..., None] * intervals) ** 2).sum(axis=2))
    closest = away.argmin(axis=1)
    rows = np.flatnonzero(away.min(axis=1) < near)
    extra = [
        (closest[row] + shares[row, closest[row]], targets[row])
        for row in rows
        if np.hypot(*(chain - targets[row]).T).min() > 1e-9
    ]
    placed = [(float(i), point) for i, point in enumerate(chain)] + extra
    placed.sort(key=lambda item: item[0])
    return tuple((float(a), float(b)) for _, (a, b) in placed)


def crossings_with_curves(chain: Chain, curves: Sequence[LineOrCircle]) -> list[float]:
    """First coordinates at which a chain crosses whole lines and circles."""
    points = np.array(chain)
    found: list[float] = []
    for curve in curves:
        if isinstance(curve, Circle):
            sides = np.hypot(*(points - np.array(curve.centre)).T) - curve.radius
        else:
            sides = (points - np.array(curve.point)) @ np.array(curve.normal(0.0))
        for link in np.flatnonzero(sides[:-1] * sides[1:] < 0.0):
            start, end = points[link], points[link + 1]
            if np.hypot(*(end - start)) < 1e-12:
                continue
            low, high = sorted((float(start[0]), float(end[0])))
            (x, y), (a, b) = map(float, start), map(float, end)
            line = line_through((x, y), (a, b), 0.0)
            found += [a for a, _ in meetings(line, curve) if low <= a <= high]
    return found


def crossings_with_chain(one: Chain, other: Chain) -> list[float]:
    """First coordinates at which two chains cross."""
    first, second = np.array(one), np.array(other)
    low = np.maximum(first.min(0), second.min(0))
    high = np.minimum(first.max(0), second.max(0))
    if (low > high).any():
        return []
    starts, intervals = first[:-1, None], np.diff(first, axis=0)[:, None]
    others, ways = second[None, :-1], np.diff(second, axis=0)[None]
    sines = intervals[..., 0] * ways[..., 1] - intervals[..., 1] * ways[..., 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        between = others - starts
        along = (between[..., 0] * ways[..., 1] - between[..., 1] * ways[..., 0]) / sines
        across = (between[..., 0] * intervals[..., 1] - between[..., 1] * intervals[..., 0]) / sines
    inside = (along > 0.0) & (along < 1.0) & (across > 0.0) & (across < 1.0)
    rows, columns = np.nonzero(inside)
    return [
        float(first[row, 0] + along[row, column] * (first[row + 1, 0] - first[row, 0]))
        for row, column in zip(rows, columns, strict=True)
    ]


def chain_distances(
    chain: npt.NDArray[np.float64], points: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """(n,) distances of (n, 2) points from a chain of (m, 2) points."""
    starts, intervals = chain[:-1], np.diff(chain, axis=0)
    squares = np.maximum((intervals**2).sum(axis=1), 1e-300)
    offsets = points[:, None, :] - starts[None]
    shares = np.clip((offsets * intervals).sum(axis=2) / squares, 0.0, 1.0)
    nearest = offsets - shares[..., None] * intervals
    return np.sqrt((nearest**2).sum(axis=2).min(axis=1))
