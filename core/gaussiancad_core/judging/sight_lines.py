"""What lines of sight at places of a view meet of a solid, one surface after another.

Between two lines of sight nothing is drawn where both meet the same surfaces in the same order.
Where the first surfaces differ, a visible line runs between them; where later ones do, a hidden
one.
"""

from dataclasses import dataclass

import numpy as np
from numba import njit

from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers
from gaussiancad_core.model.axes import ViewFrame

MOST_MET = 96
"""Surfaces that a line of sight meets at most; what lies farther off is not looked at."""

_BINS = 64
"""Bins of places along either side of a view."""


@dataclass(frozen=True, eq=False)
class Met:
    """What lines of sight meet, the nearest first.

    Attributes:
        count: (n,) crossings of each line of sight.
        surface: (n, MOST_MET) numbers of surfaces.
        depth: (n, MOST_MET) mm along the view's look.
    """

    count: Numbers
    surface: Numbers
    depth: Floats


@dataclass(frozen=True, eq=False)
class Seen:
    """What two lines of sight are compared by.

    Attributes:
        every: (n,) a number for the surfaces in their order.
        sharp: (n,) the same with surfaces as one that pass smoothly into each other.
        first: (n,) the nearest of these; -1 where nothing is met.
    """

    every: Numbers
    sharp: Numbers
    first: Numbers


def crossings(solid: FacetedSolid, frame: ViewFrame, places: Floats) -> Met:
    """What lines of sight meet.

    Args:
        solid: mm.
        frame: of the view.
        places: (n, 2) mm in the view's plane (right, up).
    """
    axes = np.array([frame.right, frame.up, frame.look], dtype=np.float64)
    corners = (solid.vertices @ axes.T)[solid.triangles]
    low, high = places.min(axis=0), places.max(axis=0)
    pitch = np.maximum((high - low) / _BINS, 1e-12)
    bins = np.minimum(((places - low) / pitch).astype(np.int64), _BINS - 1)
    number = bins[:, 0] * _BINS + bins[:, 1]
    order = np.argsort(number, kind="stable")
    starts = np.searchsorted(number[order], np.arange(_BINS * _BINS + 1))
    count = np.zeros(len(places), np.int64)
    surface = np.zeros((len(places), MOST_MET), np.int64)
    depth = np.zeros((len(places), MOST_MET))
    _cross(
        corners,
        solid.surfaces,
        places,
        (order, starts, low, pitch),
        (count, surface, depth),
    )
    return Met(count, surface, depth)


def seen(met: Met, smooth: Numbers) -> Seen:
    """What lines of sight are compared by.

    Args:
        met: by them.
        smooth: of each surface, the first that it passes into smoothly.
    """
    count = len(met.count)
    every, sharp, first = (np.zeros(count, np.int64) for _ in range(3))
    _sign(met.count, met.surface, smooth, (every, sharp, first))
    return Seen(every, sharp, first)


def cut_open(met: Met, at: Floats, cut: int) -> Met:
    """The same with what lies before a plane taken away.

    Args:
        met: by lines of sight.
        at: (n,) mm along the look, where each is cut; NaN where it is not.
        cut: number of the surface that the plane makes where it cuts material.
    """
    count, surface, depth = met.count.copy(), met.surface.copy(), met.depth.copy()
    _cut(count, surface, depth, at, cut)
    return Met(count, surface, depth)


@njit(cache=True)
def _cross(corners, surfaces, places, bins, met):  # noqa: ANN001, ANN202
    order, starts, low, pitch = bins
    count, surface, depth = met
    for t in range(len(corners)):
        ax, ay, az = corners[t, 0]
        bx, by, bz = corners[t, 1]
        cx, cy, cz = corners[t, 2]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area == 0.0:
            continue
        left = (min(ax, bx, cx) - low[0]) / pitch[0]
        right = (max(ax, bx, cx) - low[0]) / pitch[0]
        lower = (min(ay, by, cy) - low[1]) / pitch[1]
        upper = (max(ay, by, cy) - low[1]) / pitch[1]
        if right < 0.0 or upper < 0.0 or left > _BINS or lower > _BINS:
            continue
        first, last = max(0, int(left)), min(_BINS - 1, int(right))
        under, over = max(0, int(lower)), min(_BINS - 1, int(upper))
        for u in range(first, last + 1):
            for k in range(starts[u * _BINS + under], starts[u * _BINS + over + 1]):
                i = order[k]
                x, y = places[i, 0], places[i, 1]
                # A place on an edge belongs to one of its two triangles: crossings of a line to
                # the right of it are counted.
                one = _is_right(ax, ay, bx, by, x, y)
                two = _is_right(bx, by, cx, cy, x, y)
                if one ^ two ^ _is_right(cx, cy, ax, ay, x, y) == 0:
                    continue
                v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
                w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
                z = az + v * (bz - az) + w * (cz - az)
                n = min(count[i], MOST_MET - 1)
                if count[i] == MOST_MET and depth[i, n] <= z:
                    continue
                while n > 0 and depth[i, n - 1] > z:
                    depth[i, n], surface[i, n] = depth[i, n - 1], surface[i, n - 1]
                    n -= 1
                depth[i, n], surface[i, n] = z, surfaces[t]
                count[i] = min(count[i] + 1, MOST_MET)


@njit(cache=True)
def _is_right(ax, ay, bx, by, x, y):  # noqa: ANN001, ANN202, PLR0917
    """1 where an edge crosses the line to the right of a place: the same for both triangles at it,
    whichever way it runs in each."""
    if (ay <= y) == (by <= y):
        return 0
    if ay > by:
        ax, ay, bx, by = bx, by, ax, ay
    return 1 if ax + (y - ay) / (by - ay) * (bx - ax) > x else 0


@njit(cache=True)
def _sign(count, surface, smooth, signs):  # noqa: ANN001, ANN202
    every, sharp, first = signs
    for i in range(len(count)):
        one = other = 1469598103934665603
        for k in range(count[i]):
            one = (one * 1099511628211) ^ (surface[i, k] + 7)
            other = (other * 1099511628211) ^ (smooth[surface[i, k]] + 7)
        every[i], sharp[i] = one, other
        first[i] = smooth[surface[i, 0]] if count[i] else -1


@njit(cache=True)
def _cut(count, surface, depth, at, cut):  # noqa: ANN001, ANN202
    for i in range(len(count)):
        if np.isnan(at[i]):
            continue
        before = 0
        while before < count[i] and depth[i, before] < at[i]:
            before += 1
        kept = 0
        if before % 2:
            # One crossing at least lay before the plane: there is room for the cut.
            surface[i, 0], depth[i, 0] = cut, at[i]
            kept = 1
        for k in range(before, count[i]):
            surface[i, kept], depth[i, kept] = surface[i, k], depth[i, k]
            kept += 1
        count[i] = kept
