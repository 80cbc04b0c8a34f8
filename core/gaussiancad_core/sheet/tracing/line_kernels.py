"""Compiled loops that grow lines; :mod:`.growth_kernels` says of what."""

import numpy as np
from numba import njit

from gaussiancad_core.sheet.tracing.growth_kernels import (
    CONSUMED,
    CONSUMED_COSINE,
    pixel,
    scratch_of,
    stacked,
    with_room,
)

_BENT_END = 6.0
"""px at either end of a line in which another stroke's ink may bend the ridge."""

_BENT_PX = 0.1
"""px from a parabola at which a point counts by half: the ridge is bent where a stroke crosses."""

_STRAIGHT_PX = 0.08
"""Sagitta up to which one end of a bent line is a line that runs into an arc, no piece of one."""

_STRAIGHT_LENGTH = 14.0
"""px that such an end is long at least."""

_ROUNDS = 6

_FLATTER = 320.0
"""Length of a line in sagittas from which it is no arc: two edges on one line, or an edge and its
extension line, may be drawn half a pixel apart."""


@njit(cache=True)
def grow_lines(tables, limits, fit, most):  # noqa: ANN001, ANN201
    """Lines from all points that no earlier line explains: rows (x, y, dx, dy), the members of row
    k at ``splits[k]`` to ``splits[k + 1]``.

    It ends early where there are more lines, or more members of all, than ``most`` has of each.
    """
    points, tangents, _ = tables
    count = len(points)
    rows, splits = [np.zeros(4)], [0]
    members = np.empty(0, dtype=np.int64)
    used = 0
    tried = np.zeros(count, dtype=np.bool_)
    scratch = scratch_of(count)
    item = scratch[1]
    for seed in range(count):
        if len(rows) - 1 > most[0] or used > most[1]:
            break
        if tried[seed]:
            continue
        tried[seed] = True
        line = np.array([points[seed, 0], points[seed, 1], tangents[seed, 0], tangents[seed, 1]])
        good, number = _grow_line(tables, limits, fit, line, scratch)
        # A bad line that started in a corner must not keep its good neighbours from starting.
        if not good:
            continue
        for k in range(number):
            tried[item[k]] = True
        consumed = (limits[0], CONSUMED, CONSUMED_COSINE)
        number = _along_line(tables, line, 1e9, consumed, scratch)
        members = with_room(members, used, number)
        members[used : used + number] = item[:number]
        used += number
        rows.append(line)
        splits.append(used)
    return stacked(rows, 4), np.array(splits), members[:used]


@njit(cache=True)
def line_worth(points, splits, members, rows, reach):  # noqa: ANN001, ANN201
    """What each member counts for its line, 1 on the centre line, falling to 0 ``reach`` px beside
    it; lines as of :func:`grow_lines`."""
    worth = np.empty(len(members))
    for row in range(len(rows)):
        x, y, dx, dy = rows[row]
        for k in range(splits[row], splits[row + 1]):
            i = members[k]
            across = (points[i, 1] - y) * dx - (points[i, 0] - x) * dy
            worth[k] = max(1.0 - (across / reach) ** 2, 0.0)
    return worth


@njit(cache=True)
def _grow_line(tables, limits, fit, line, scratch):  # noqa: ANN001, ANN202
    """Grow a line in place: whether it is one, and how many points it has."""
    points, item = tables[0], scratch[1]
    reach = 7.0
    number, before, extent = 0, -1, 0.0
    for _ in range(24):
        number = _along_line(tables, line, reach, limits, scratch)
        if number < 3:
            return False, number
        extent = _fit_line(points, item, number, line)
        if number == before and extent < 0.75 * reach:
            break
        before = number
        reach = max(1.6 * extent, reach)
    if number < fit[0]:
        return False, number
    sagitta, rms = _line_quality(points, item, number, line)
    flattest = max(fit[1], min(fit[3], 2.0 * extent / _FLATTER))
    if sagitta > flattest and rms <= fit[2]:
        sagitta = _steady_sagitta(points, item, number, line)
    if sagitta <= flattest and rms <= fit[2]:
        return True, number
    return _straight_part(points, item, number, line, fit)


@njit(cache=True)
def _straight_part(points, item, number, line, fit):  # noqa: ANN001, ANN202
    """Keep a straight end of a bent line, or its middle, in place: whether there is one, and its
    points.

    Where a line passes into an arc as it touches it, it is followed into the arc; where it meets
    others at flat angles at both ends, into these.
    """
    along = np.empty(number)
    for k in range(number):
        along[k] = (points[item[k], 0] - line[0]) * line[2] + (points[item[k], 1] - line[1]) * line[
            3
        ]
    order = item[:number][np.argsort(along)]
    part = np.empty(number, dtype=np.int64)
    for tenth in range(9, 2, -1):
        kept = number * tenth // 10
        for quarter in (0, 4, 2, 1, 3):
            first = (number - kept) * quarter // 4
            part[:kept] = order[first : first + kept]
            if 2.0 * _fit_line(points, part, kept, line) < _STRAIGHT_LENGTH:
                continue
            sagitta, rms = _line_quality(points, part, kept, line)
            if sagitta <= _STRAIGHT_PX and rms <= fit[2] / 2.0:
                item[:kept] = part[:kept]
                return True, kept
    return False, number


@njit(cache=True)
def _along_line(tables, line, reach, limits, scratch):  # noqa: ANN001, ANN202
    """Collect the points along a line up to ``reach`` or a gap both ways from its point."""
    points, tangents, index = tables
    gap, band, cosine = limits
    stamp, item, marks = scratch
    marks[0] += 1
    mark = marks[0]
    height, width = index.shape
    x, y, dx, dy = line
    level = abs(dx) >= abs(dy)
    step = 1.0 / max(abs(dx), abs(dy))
    around = int(np.ceil(band * step)) + 1
    number = 0
    for way in (1.0, -1.0):
        s = last = 0.0
        while s <= reach and s - last <= gap:
            column, row = pixel(x + way * s * dx), pixel(y + way * s * dy)
            for k in range(-around, around + 1):
                cx, cy = (column, row + k) if level else (column + k, row)
                if cx < 0 or cy < 0 or cx >= width or cy >= height:
                    continue
                i = index[cy, cx]
                if i < 0:
                    continue
                if abs((points[i, 1] - y) * dx - (points[i, 0] - x) * dy) > band:
                    continue
                if abs(tangents[i, 0] * dx + tangents[i, 1] * dy) < cosine:
                    continue
                last = s
                if stamp[i] != mark:
                    stamp[i] = mark
                    item[number] = i
                    number += 1
            s += step
    return number


@njit(cache=True)
def _fit_line(points, item, number, line):  # noqa: ANN001, ANN202
    """Total least squares in place; the farthest point's distance from the middle."""
    mx = my = 0.0
    for k in range(number):
        mx += points[item[k], 0]
        my += points[item[k], 1]
    mx, my = mx / number, my / number
    xx = xy = yy = 0.0
    for k in range(number):
        ox, oy = points[item[k], 0] - mx, points[item[k], 1] - my
        xx += ox * ox
        xy += ox * oy
        yy += oy * oy
    angle = 0.5 * np.arctan2(2 * xy, xx - yy)
    line[0], line[1], line[2], line[3] = mx, my, np.cos(angle), np.sin(angle)
    farthest = 0.0
    for k in range(number):
        ox, oy = points[item[k], 0] - mx, points[item[k], 1] - my
        farthest = max(farthest, abs(ox * line[2] + oy * line[3]))
    return farthest


@njit(cache=True)
def _line_quality(points, item, number, line):  # noqa: ANN001, ANN202
    """Sagitta of the parabola through the points, and their rms distance, px.

    Near the ends the ink of other strokes bends the ridge: what lies there is left out.
    """
    half = 0.0
    for k in range(number):
        ox, oy = points[item[k], 0] - line[0], points[item[k], 1] - line[1]
        half = max(half, abs(ox * line[2] + oy * line[3]))
    inner = half - min(_BENT_END, 0.3 * half)
    count = s2 = s4 = a = s2a = square = 0.0
    for k in range(number):
        ox, oy = points[item[k], 0] - line[0], points[item[k], 1] - line[1]
        along, across = ox * line[2] + oy * line[3], oy * line[2] - ox * line[3]
        if abs(along) > inner:
            continue
        count += 1.0
        s2 += along**2
        s4 += along**4
        a += across
        s2a += along**2 * across
        square += across**2
    if count < 3.0:
        return 0.0, 0.0
    spread = s4 - s2**2 / count
    bend = (s2a - s2 * a / count) / spread if spread > 1e-9 else 0.0
    return abs(bend) * half**2, np.sqrt(square / count)


@njit(cache=True)
def _steady_sagitta(points, item, number, line):  # noqa: ANN001, ANN202
    """Sagitta of the parabola through most of the points, px: reweighted least squares with
    Cauchy's weights.  All of an arc lies on one parabola; of a line that an arrowhead bends at one
    place the rest is straight."""
    half = 0.0
    along, across = np.empty(number), np.empty(number)
    for k in range(number):
        ox, oy = points[item[k], 0] - line[0], points[item[k], 1] - line[1]
        along[k], across[k] = ox * line[2] + oy * line[3], oy * line[2] - ox * line[3]
        half = max(half, abs(along[k]))
    design = np.ones((number, 3))
    design[:, 1] = along / half
    design[:, 2] = design[:, 1] ** 2
    weights = np.ones(number)
    bend = 0.0
    for _ in range(_ROUNDS):
        weighted = design * weights.reshape(-1, 1)
        normal = weighted.T @ design + 1e-9 * np.eye(3)
        solution = np.linalg.solve(normal, weighted.T @ across)
        bend = solution[2]
        weights = 1.0 / (1.0 + ((across - design @ solution) / _BENT_PX) ** 2)
    return abs(bend)
