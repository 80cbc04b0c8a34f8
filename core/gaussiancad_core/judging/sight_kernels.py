"""Compiled loops over lines of sight: what they meet, how they are compared, cut and changed."""

import numpy as np
from numba import njit

MOST_MET = 96
"""Surfaces that a line of sight meets at most; what lies farther off is not looked at."""

BINS = 64
"""Bins of places along either side of a view."""


@njit(cache=True)
def cross(corners, surfaces, places, bins, met) -> None:  # noqa: ANN001
    """Put what lines of sight meet of triangles into tables, the nearest first.

    Args:
        corners: (m, 3, 3) of the triangles: right, up and along the look.
        surfaces: (m,) of the triangles.
        places: (n, 2) right and up of the lines of sight.
        bins: their numbers by bin, where each bin starts, the least place, a bin's width.
        met: counts (n,), surfaces and depths (n, MOST_MET), filled in.
    """
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
        if right < 0.0 or upper < 0.0 or left > BINS or lower > BINS:
            continue
        first, last = max(0, int(left)), min(BINS - 1, int(right))
        under, over = max(0, int(lower)), min(BINS - 1, int(upper))
        for u in range(first, last + 1):
            for k in range(starts[u * BINS + under], starts[u * BINS + over + 1]):
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
def sign(count, surface, smooth, signs) -> None:  # noqa: ANN001
    """Put into three tables (n,) a number for the surfaces that each line of sight meets, the same
    with smooth ones as one, and the first of these."""
    every, sharp, first = signs
    for i in range(len(count)):
        one = other = 1469598103934665603
        for k in range(count[i]):
            one = (one * 1099511628211) ^ (surface[i, k] + 7)
            other = (other * 1099511628211) ^ (smooth[surface[i, k]] + 7)
        every[i], sharp[i] = one, other
        first[i] = smooth[surface[i, 0]] if count[i] else -1


@njit(cache=True)
def cut(count, surface, depth, at, number) -> None:  # noqa: ANN001
    """Take away in place what lies before a depth; where that cuts material, the cut is met."""
    for i in range(len(count)):
        if np.isnan(at[i]):
            continue
        before = 0
        while before < count[i] and depth[i, before] < at[i]:
            before += 1
        kept = 0
        if before % 2:
            # One crossing at least lay before the plane: there is room for the cut.
            surface[i, 0], depth[i, 0] = number, at[i]
            kept = 1
        for k in range(before, count[i]):
            surface[i, kept], depth[i, kept] = surface[i, k], depth[i, k]
            kept += 1
        count[i] = kept


@njit(cache=True)
def merge(solid, tool, touched, rule, out) -> None:  # noqa: ANN001
    """Add a tool to a solid along lines of sight, or cut it from it.

    Args:
        solid, tool: counts, surfaces and depths of both.
        touched: numbers of the lines of sight that meet the tool.
        rule: 0 to add, 1 to cut; mm within which two crossings are one.
        out: counts, surfaces and depths, those of the solid at first.
    """
    one_count, one_surface, one_depth = solid
    two_count, two_surface, two_depth = tool
    change, same = rule
    count, surface, depth = out
    for q in range(len(touched)):
        r = touched[q]
        i = j = k = 0
        in_one = in_two = inside = False
        while i < one_count[r] or j < two_count[r]:
            if j >= two_count[r] or (
                i < one_count[r] and one_depth[r, i] <= two_depth[r, j] + same
            ):
                # The solid's own surface stands for both where they are one.
                at, number = one_depth[r, i], one_surface[r, i]
            else:
                at, number = two_depth[r, j], two_surface[r, j]
            while i < one_count[r] and one_depth[r, i] <= at + same:
                in_one = not in_one
                i += 1
            while j < two_count[r] and two_depth[r, j] <= at + same:
                in_two = not in_two
                j += 1
            now = (in_one or in_two) if change == 0 else (in_one and not in_two)
            if now != inside:
                if k < MOST_MET:
                    surface[r, k], depth[r, k] = number, at
                    k += 1
                inside = now
        count[r] = k
