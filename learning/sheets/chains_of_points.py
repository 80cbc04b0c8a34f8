"""Lines as chains of points: circles, dashes, and what is left of a line behind a border.

Coordinates are px of the sheet, x to the right and y down.
"""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.floating]
"""(n, 2) points of a line, or (2,) one point or way."""

_ANGLE_STEP = math.radians(5.0)
"""Of the chain along a circle."""

_LEAST_DASH = 0.6
"""px of a dash under which it is left out."""


def segment(start: npt.ArrayLike, end: npt.ArrayLike) -> Points:
    """(2, 2) a straight line."""
    return np.array([start, end], dtype=np.float64)


def rectangle(x0: float, y0: float, x1: float, y1: float) -> Points:
    """(5, 2) closed."""
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], dtype=np.float64)


def arc(centre: npt.ArrayLike, radius: float, start: float, sweep: float) -> Points:
    """(n, 2) along a circle; angles are radians."""
    count = max(4, int(abs(sweep) / _ANGLE_STEP) + 2)
    angles = start + np.linspace(0.0, sweep, count)
    return np.asarray(centre) + radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def circle(centre: npt.ArrayLike, radius: float) -> Points:
    """(n, 2) closed."""
    return arc(centre, radius, 0.0, 2.0 * math.pi)


def shifted(point: npt.ArrayLike, right: float, down: float) -> Points:
    """(2,) a point some px farther right and down."""
    x, y = np.asarray(point, dtype=np.float64)
    return np.array([x + right, y + down])


def length(chain: Points) -> float:
    """px along it."""
    return float(np.hypot(*np.diff(chain, axis=0).T).sum())


def norm(way: npt.ArrayLike) -> float:
    """Length of a way (2,)."""
    x, y = np.asarray(way, dtype=np.float64)
    return math.hypot(x, y)


def unit(way: npt.ArrayLike) -> Points:
    """(2,) the same way, one px long; no way at all stays none."""
    return np.asarray(way, dtype=np.float64) / max(norm(way), 1e-9)


def across(way: npt.ArrayLike) -> Points:
    """(2,) a way at a right angle."""
    x, y = np.asarray(way, dtype=np.float64)
    return np.array([-y, x])


def dashed(chain: Points, pattern: Sequence[float], phase: float = 0.0) -> list[Points]:
    """The dashes along a line.

    Args:
        chain: (n, 2).
        pattern: px on, off, on, off and so on.
        phase: px of the pattern that are left out at the start.
    """
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(chain, axis=0).T))])
    if along[-1] < 1e-6:
        return []
    repeats = int((along[-1] + phase) / sum(pattern)) + 2
    ends = np.concatenate([[0.0], np.cumsum(np.tile(pattern, repeats))]) - phase
    starts, stops = (np.clip(values, 0.0, along[-1]) for values in (ends[0:-1:2], ends[1::2]))
    long = stops - starts > _LEAST_DASH
    pieces = []
    for start, stop in zip(starts[long], stops[long], strict=True):
        inner = along[(along > start) & (along < stop)]
        at = np.concatenate([[start], inner, [stop]])
        pieces.append(np.stack([np.interp(at, along, chain[:, axis]) for axis in (0, 1)], axis=1))
    return pieces


def beyond(chain: Points, axis: int, border: float, sign: int) -> list[Points]:
    """The pieces of a line on one side of a border.

    Args:
        chain: (n, 2).
        axis: 0, the border is upright; 1, it is level.
        border: its coordinate.
        sign: 1 keeps what has larger coordinates, -1 smaller ones.
    """
    over = sign * (chain[:, axis] - border)
    pieces, current = [], []
    for place, point in enumerate(chain):
        if over[place] >= 0.0:
            current.append(point)
        if place + 1 < len(chain) and (over[place] >= 0.0) != (over[place + 1] >= 0.0):
            share = over[place] / (over[place] - over[place + 1])
            current.append(point + share * (chain[place + 1] - point))
            if over[place] >= 0.0:
                pieces.append(current)
                current = []
    pieces.append(current)
    return [
        np.array(this_pieces, dtype=np.float32) for this_pieces in pieces if len(this_pieces) > 1
    ]


def within_circle(chain: Points, centre: Points, radius: float) -> list[Points]:
    """The pieces of a line inside a circle, at steps of 2 px."""
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(chain, axis=0).T))])
    at = np.linspace(0.0, along[-1], max(2, int(along[-1] / 2.0)))
    points = np.stack([np.interp(at, along, chain[:, axis]) for axis in (0, 1)], axis=1)
    kept = np.hypot(*(points - centre).T) < radius
    borders = np.flatnonzero(np.diff(np.concatenate([[0], kept.astype(np.int8), [0]])))
    pairs = zip(borders[0::2], borders[1::2], strict=True)
    return [points[start:stop] for start, stop in pairs if stop - start > 1]


def inside(ring: Points, x: float, y: float) -> bool:
    """Whether a point is within a closed ring."""
    starts, ends = ring[:-1], ring[1:]
    crossed = (starts[:, 1] <= y) != (ends[:, 1] <= y)
    starts, ends = starts[crossed], ends[crossed]
    share = (y - starts[:, 1]) / (ends[:, 1] - starts[:, 1])
    return bool(np.sum(starts[:, 0] + share * (ends[:, 0] - starts[:, 0]) > x) % 2)
