"""Compiled loops of :mod:`gaussiancad_core.sheet.growth`.

``tables`` are the points (n, 2), tangents (n, 2) and index (h, w) of ridge points; ``limits`` the
gap, the band and the cosine of the largest turn; ``fit`` the least number of points, the largest
sagitta of a line, the largest rms and the least sagitta of an arc; ``scratch`` a stamp for each
point, room for the points found, and the last stamp given.
"""

import numpy as np
from numba import njit

_CONSUMED = 1.3
"""px beside a shape within which points are explained by it."""

_CONSUMED_COSINE = np.cos(np.radians(22.0))

_BENT_END = 6.0
"""px at either end of a line in which another stroke's ink may bend the ridge."""

_NEARER = 0.05
"""px by which a line's point may be nearer to the line than to an arc that has it as well."""

_CHAINS = (6, 11, 20, 34)
"""px of chain on each side of a point from which an arc is started, in turn."""

_SMALLEST, _LARGEST = 3.0, 6_000.0
"""px: radii of arcs that can be told from a blot and from a line."""


@njit(cache=True)
def grow_lines(tables, limits, fit):  # noqa: ANN001, ANN201
    """Lines from all points that no earlier line explains: rows (x, y, dx, dy), the members of row
    k at ``splits[k]`` to ``splits[k + 1]``."""
    points, tangents, _ = tables
    count = len(points)
    rows, splits = [np.zeros(4)], [0]
    members = np.empty(0, dtype=np.int64)
    used = 0
    tried = np.zeros(count, dtype=np.bool_)
    scratch = _scratch(count)
    own = scratch[1]
    for seed in range(count):
        if tried[seed]:
            continue
        tried[seed] = True
        line = np.array([points[seed, 0], points[seed, 1], tangents[seed, 0], tangents[seed, 1]])
        good, number = _grow_line(tables, limits, fit, line, scratch)
        # A bad line that started in a corner must not keep its good neighbours from starting.
        if not good:
            continue
        for k in range(number):
            tried[own[k]] = True
        consumed = (limits[0], _CONSUMED, _CONSUMED_COSINE)
        number = _along_line(tables, line, 1e9, consumed, scratch)
        members = _room(members, used, number)
        members[used : used + number] = own[:number]
        used += number
        rows.append(line)
        splits.append(used)
    return _stacked(rows, 4), np.array(splits), members[:used]


@njit(cache=True)
def _scratch(count):  # noqa: ANN001, ANN202
    return (
        np.zeros(count, dtype=np.int64),
        np.empty(count, dtype=np.int64),
        np.zeros(1, dtype=np.int64),
    )


@njit(cache=True)
def _stacked(rows, width):  # noqa: ANN001, ANN202
    """The rows but the first, which only tells the compiler their type."""
    table = np.empty((len(rows) - 1, width))
    for k in range(1, len(rows)):
        table[k - 1] = rows[k]
    return table


@njit(cache=True)
def _room(members, used, more):  # noqa: ANN001, ANN202
    if used + more <= len(members):
        return members
    grown = np.empty(2 * (used + more), dtype=np.int64)
    grown[:used] = members[:used]
    return grown


@njit(cache=True)
def _grow_line(tables, limits, fit, line, scratch):  # noqa: ANN001, ANN202
    """Grow a line in place: whether it is one, and how many points it has."""
    points, own = tables[0], scratch[1]
    reach = 7.0
    number, before = 0, -1
    for _ in range(24):
        number = _along_line(tables, line, reach, limits, scratch)
        if number < 3:
            return False, number
        extent = _fit_line(points, own, number, line)
        if number == before and extent < 0.75 * reach:
            break
        before = number
        reach = max(1.6 * extent, reach)
    if number < fit[0]:
        return False, number
    sagitta, rms = _line_quality(points, own, number, line)
    return sagitta <= fit[1] and rms <= fit[2], number


@njit(cache=True)
def _along_line(tables, line, reach, limits, scratch):  # noqa: ANN001, ANN202
    """Collect the points along a line up to ``reach`` or a gap both ways from its point."""
    points, tangents, index = tables
    gap, band, cosine = limits
    stamp, own, marks = scratch
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
            column, row = _pixel(x + way * s * dx), _pixel(y + way * s * dy)
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
                    own[number] = i
                    number += 1
            s += step
    return number


@njit(cache=True)
def _pixel(at):  # noqa: ANN001, ANN202
    """The pixel at a coordinate; halves always go up, for rounded to even they would make a level
    line's steps of one pixel miss every other column."""
    return int(np.floor(at + 0.5 + 1e-9))


@njit(cache=True)
def _fit_line(points, own, number, line):  # noqa: ANN001, ANN202
    """Total least squares in place; the farthest point's distance from the middle."""
    mx = my = 0.0
    for k in range(number):
        mx += points[own[k], 0]
        my += points[own[k], 1]
    mx, my = mx / number, my / number
    xx = xy = yy = 0.0
    for k in range(number):
        ox, oy = points[own[k], 0] - mx, points[own[k], 1] - my
        xx += ox * ox
        xy += ox * oy
        yy += oy * oy
    angle = 0.5 * np.arctan2(2 * xy, xx - yy)
    line[0], line[1], line[2], line[3] = mx, my, np.cos(angle), np.sin(angle)
    farthest = 0.0
    for k in range(number):
        ox, oy = points[own[k], 0] - mx, points[own[k], 1] - my
        farthest = max(farthest, abs(ox * line[2] + oy * line[3]))
    return farthest


@njit(cache=True)
def _line_quality(points, own, number, line):  # noqa: ANN001, ANN202
    """Sagitta of the parabola through the points, and their rms distance, px.

    Near the ends the ink of other strokes bends the ridge: what lies there is left out.
    """
    half = 0.0
    for k in range(number):
        ox, oy = points[own[k], 0] - line[0], points[own[k], 1] - line[1]
        half = max(half, abs(ox * line[2] + oy * line[3]))
    inner = half - min(_BENT_END, 0.3 * half)
    count = s2 = s4 = a = s2a = square = 0.0
    for k in range(number):
        ox, oy = points[own[k], 0] - line[0], points[own[k], 1] - line[1]
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
def grow_arcs(tables, limits, fit, beside):  # noqa: ANN001, ANN201
    """Arcs from all points that no line has: rows (x, y, r, 0) and members, as for lines.

    ``beside`` is each point's distance from the line that has it, infinite where none has.
    """
    points = tables[0]
    count = len(points)
    rows, splits = [np.zeros(4)], [0]
    members = np.empty(0, dtype=np.int64)
    used = 0
    tried = beside < np.inf
    scratch = _scratch(count)
    own = scratch[1]
    unclaimed = np.full(count, np.inf)
    circle = np.zeros(4)
    for seed in range(count):
        if tried[seed]:
            continue
        tried[seed] = True
        for chain in _CHAINS:
            number = _chain(tables, seed, chain, scratch)
            if number < 5 or not _osculating(tables, seed, own, number, circle):
                continue
            good, number = _grow_arc(tables, (limits, fit), seed, circle, (scratch, beside))
            if not good:
                continue
            for k in range(number):
                tried[own[k]] = True
            consumed = (limits[0], _CONSUMED, _CONSUMED_COSINE)
            number, _ = _along_circle(tables, circle, seed, consumed, (scratch, unclaimed))
            members = _room(members, used, number)
            members[used : used + number] = own[:number]
            used += number
            rows.append(circle.copy())
            splits.append(used)
            break
    return _stacked(rows, 4), np.array(splits), members[:used]


@njit(cache=True)
def _chain(tables, seed, length, scratch):  # noqa: ANN001, ANN202
    """Follow the ridge both ways from a point for ``length`` px; the points passed."""
    points, tangents, index = tables
    stamp, own, marks = scratch
    marks[0] += 1
    mark = marks[0]
    height, width = index.shape
    own[0] = seed
    stamp[seed] = mark
    number = 1
    for way in (1.0, -1.0):
        at = seed
        dx, dy = way * tangents[seed, 0], way * tangents[seed, 1]
        for _ in range(length):
            column, row = int(np.rint(points[at, 0])), int(np.rint(points[at, 1]))
            best, closest = -1, 0.7
            for cy in range(max(row - 2, 0), min(row + 3, height)):
                for cx in range(max(column - 2, 0), min(column + 3, width)):
                    i = index[cy, cx]
                    if i < 0 or stamp[i] == mark:
                        continue
                    ox, oy = points[i, 0] - points[at, 0], points[i, 1] - points[at, 1]
                    distance = np.hypot(ox, oy)
                    turn = abs(tangents[i, 0] * dx + tangents[i, 1] * dy)
                    ahead = (ox * dx + oy * dy) / max(distance, 1e-9)
                    # Near ones first, of those the straightest.
                    fits = ahead * turn / max(distance, 1.0)
                    if ahead > 0.8 and turn > 0.8 and (best < 0 or fits > closest):
                        best, closest = i, fits
            if best < 0:
                break
            stamp[best] = mark
            own[number] = best
            number += 1
            sign = 1.0 if tangents[best, 0] * dx + tangents[best, 1] * dy > 0.0 else -1.0
            dx, dy = sign * tangents[best, 0], sign * tangents[best, 1]
            at = best
    return number


@njit(cache=True)
def _osculating(tables, seed, own, number, circle):  # noqa: ANN001, ANN202
    """The circle that follows a chain: from the mean turn of the tangents per px, which is steadier
    for short chains than a fit to the points; then a fit where the chain is long enough."""
    points, tangents, _ = tables
    x, y = points[seed, 0], points[seed, 1]
    dx, dy = tangents[seed, 0], tangents[seed, 1]
    moment = turning = 0.0
    for k in range(number):
        i = own[k]
        sign = 1.0 if tangents[i, 0] * dx + tangents[i, 1] * dy > 0.0 else -1.0
        tx, ty = sign * tangents[i, 0], sign * tangents[i, 1]
        turn = np.arctan2(ty * dx - tx * dy, tx * dx + ty * dy)
        ox, oy = points[i, 0] - x, points[i, 1] - y
        way = ox * dx + oy * dy
        along = np.hypot(ox, oy) * (1.0 if way >= 0.0 else -1.0)
        moment += along * along
        turning += along * turn
    if moment < 1e-9 or abs(turning) < moment / _LARGEST:
        return False
    radius = moment / turning
    if abs(radius) < _SMALLEST:
        return False
    circle[0], circle[1], circle[2] = x - radius * dy, y + radius * dx, abs(radius)
    fits = True
    for _ in range(4):
        fits = fits and _fit_circle(points, own, number, circle)
    return fits


@njit(cache=True)
def _grow_arc(tables, rules, seed, circle, work):  # noqa: ANN001, ANN202
    """Grow an arc in place: whether it is one, and how many points it has."""
    points, own = tables[0], work[0][1]
    limits, fit = rules
    number, before, sweep = 0, -1, 0.0
    for turn in range(12):
        band = 1.8 if turn < 2 else (1.2 if turn < 4 else limits[1])
        looser = (limits[0], band, limits[2])
        number, sweep = _along_circle(tables, circle, seed, looser, work)
        if number < fit[0] or not _fit_circle(points, own, number, circle):
            return False, number
        if turn > 4 and number == before:
            break
        before = number
    square = 0.0
    for k in range(number):
        ox, oy = points[own[k], 0] - circle[0], points[own[k], 1] - circle[1]
        square += (np.hypot(ox, oy) - circle[2]) ** 2
    rms = np.sqrt(square / number)
    sagitta = circle[2] * (1.0 - np.cos(min(sweep, 2 * np.pi) / 2))
    # Gaps take away from what speaks for the circle: half of it must be there.
    filled = number >= 0.4 * circle[2] * sweep
    return filled and sagitta >= fit[3] and rms <= fit[2], number


@njit(cache=True)
def _along_circle(tables, circle, seed, limits, work):  # noqa: ANN001, ANN202
    """Collect the points around a circle from the seed's angle to a gap both ways, and the angle
    that they span."""
    points, tangents, index = tables
    gap, band, cosine = limits
    (stamp, own, marks), beside = work
    marks[0] += 1
    mark = marks[0]
    height, width = index.shape
    x, y, radius = circle[0], circle[1], circle[2]
    start = np.arctan2(points[seed, 1] - y, points[seed, 0] - x)
    slack = np.cos(min(np.arccos(cosine) + 1.2 / radius, 1.2))
    step = 1.0 / radius
    around = int(np.ceil(band)) + 1
    number = 0
    spans = np.zeros(2)
    left = 2 * np.pi
    for side in range(2):
        way = 1.0 - 2.0 * side
        angle = last = 0.0
        while angle <= left and (angle - last) * radius <= gap:
            cosine_here, sine_here = np.cos(start + way * angle), np.sin(start + way * angle)
            column = int(np.rint(x + radius * cosine_here))
            row = int(np.rint(y + radius * sine_here))
            for cy in range(max(row - around, 0), min(row + around + 1, height)):
                for cx in range(max(column - around, 0), min(column + around + 1, width)):
                    i = index[cy, cx]
                    if i < 0:
                        continue
                    ox, oy = points[i, 0] - x, points[i, 1] - y
                    distance = np.hypot(ox, oy)
                    # A tangent's points are the tangent's, however near to the arc.
                    if abs(distance - radius) > min(band, beside[i] + _NEARER) or distance < 1e-9:
                        continue
                    # A point counts where it lies, not where it is first seen from.
                    if abs(ox * sine_here - oy * cosine_here) > 1.0:
                        continue
                    if abs(tangents[i, 1] * ox - tangents[i, 0] * oy) < slack * distance:
                        continue
                    last = angle
                    if stamp[i] != mark:
                        stamp[i] = mark
                        own[number] = i
                        number += 1
            angle += step
        spans[side] = last
        left = max(2 * np.pi - last, 0.0)
    return number, min(spans[0] + spans[1], 2 * np.pi)


@njit(cache=True)
def _fit_circle(points, own, number, circle):  # noqa: ANN001, ANN202
    """One Gauss-Newton step of the geometric fit, in place; whether the circle is still one."""
    normal = np.zeros((3, 3))
    right = np.zeros(3)
    row = np.empty(3)
    for k in range(number):
        ox, oy = points[own[k], 0] - circle[0], points[own[k], 1] - circle[1]
        distance = np.hypot(ox, oy)
        if distance < 1e-9:
            return False
        row[0], row[1], row[2] = ox / distance, oy / distance, 1.0
        residual = distance - circle[2]
        for a in range(3):
            right[a] += row[a] * residual
            for b in range(3):
                normal[a, b] += row[a] * row[b]
    for a in range(3):
        normal[a, a] += 1e-9 * number
    change = np.linalg.solve(normal, right)
    if not np.isfinite(change).all() or abs(change[2]) > 0.5 * circle[2] + 3.0:
        return False
    circle[0] += change[0]
    circle[1] += change[1]
    circle[2] += change[2]
    return _SMALLEST <= circle[2] <= _LARGEST
