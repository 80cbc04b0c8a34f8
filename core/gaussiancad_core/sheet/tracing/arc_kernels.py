"""Compiled loops that grow arcs; :mod:`.growth_kernels` says of what."""

import numpy as np
from numba import njit

from gaussiancad_core.sheet.picture_noise import LARGEST_RADIUS, SMALLEST_RADIUS
from gaussiancad_core.sheet.tracing.growth_kernels import (
    CONSUMED,
    CONSUMED_COSINE,
    NEARER,
    scratch_of,
    stacked,
    with_room,
)

_CHAINS = (6, 11, 20, 34)
"""px of chain on each side of a point from which an arc is started, in turn."""


@njit(cache=True)
def grow_arcs(tables, limits, fit, neighbour):  # noqa: ANN001, ANN201
    """Arcs from all points that no line has: rows (x, y, r, 0) and members, as for lines.

    ``neighbour`` is each point's distance from the line that has it, infinite where none has.
    """
    points = tables[0]
    count = len(points)
    rows, splits = [np.zeros(4)], [0]
    members = np.empty(0, dtype=np.int64)
    used = 0
    tried = neighbour < np.inf
    scratch = scratch_of(count)
    item = scratch[1]
    unclaimed = np.full(count, np.inf)
    circle = np.zeros(4)
    for seed in range(count):
        if tried[seed]:
            continue
        tried[seed] = True
        for chain in _CHAINS:
            number = _chain(tables, seed, chain, scratch)
            if number < 5 or not _osculating(tables, seed, item, number, circle):
                continue
            good, number = _grow_arc(tables, (limits, fit), seed, circle, (scratch, neighbour))
            if not good:
                continue
            for k in range(number):
                tried[item[k]] = True
            consumed = (limits[0], CONSUMED, CONSUMED_COSINE)
            number, _ = _along_circle(tables, circle, seed, consumed, (scratch, unclaimed))
            members = with_room(members, used, number)
            members[used : used + number] = item[:number]
            used += number
            rows.append(circle.copy())
            splits.append(used)
            break
    return stacked(rows, 4), np.array(splits), members[:used]


@njit(cache=True)
def _chain(tables, seed, length, scratch):  # noqa: ANN001, ANN202
    """Follow the ridge both ways from a point for ``length`` px; the points passed."""
    points, tangents, index = tables
    stamp, item, marks = scratch
    marks[0] += 1
    mark = marks[0]
    height, width = index.shape
    item[0] = seed
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
            item[number] = best
            number += 1
            sign = 1.0 if tangents[best, 0] * dx + tangents[best, 1] * dy > 0.0 else -1.0
            dx, dy = sign * tangents[best, 0], sign * tangents[best, 1]
            at = best
    return number


@njit(cache=True)
def _osculating(tables, seed, item, number, circle):  # noqa: ANN001, ANN202
    """The circle that follows a chain: from the mean turn of the tangents per px, which is steadier
    for short chains than a fit to the points; then a fit where the chain is long enough."""
    points, tangents, _ = tables
    x, y = points[seed, 0], points[seed, 1]
    dx, dy = tangents[seed, 0], tangents[seed, 1]
    moment = turning = 0.0
    for k in range(number):
        i = item[k]
        sign = 1.0 if tangents[i, 0] * dx + tangents[i, 1] * dy > 0.0 else -1.0
        tx, ty = sign * tangents[i, 0], sign * tangents[i, 1]
        turn = np.arctan2(ty * dx - tx * dy, tx * dx + ty * dy)
        ox, oy = points[i, 0] - x, points[i, 1] - y
        way = ox * dx + oy * dy
        along = np.hypot(ox, oy) * (1.0 if way >= 0.0 else -1.0)
        moment += along * along
        turning += along * turn
    if moment < 1e-9 or abs(turning) < moment / LARGEST_RADIUS:
        return False
    radius = moment / turning
    if abs(radius) < SMALLEST_RADIUS:
        return False
    circle[0], circle[1], circle[2] = x - radius * dy, y + radius * dx, abs(radius)
    fits = True
    for _ in range(4):
        fits = fits and _fit_circle(points, item, number, circle)
    return fits


@njit(cache=True)
def _grow_arc(tables, rules, seed, circle, work):  # noqa: ANN001, ANN202
    """Grow an arc in place: whether it is one, and how many points it has."""
    points, item = tables[0], work[0][1]
    limits, fit = rules
    number, before, sweep = 0, -1, 0.0
    for turn in range(12):
        band = 1.8 if turn < 2 else (1.2 if turn < 4 else limits[1])
        looser = (limits[0], band, limits[2])
        number, sweep = _along_circle(tables, circle, seed, looser, work)
        if number < fit[0] or not _fit_circle(points, item, number, circle):
            return False, number
        if turn > 4 and number == before:
            break
        before = number
    square = 0.0
    for k in range(number):
        ox, oy = points[item[k], 0] - circle[0], points[item[k], 1] - circle[1]
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
    (stamp, item, marks), neighbour = work
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
                    if abs(distance - radius) > min(band, neighbour[i] + NEARER) or distance < 1e-9:
                        continue
                    # A point counts where it lies, not where it is first seen from.
                    if abs(ox * sine_here - oy * cosine_here) > 1.0:
                        continue
                    if abs(tangents[i, 1] * ox - tangents[i, 0] * oy) < slack * distance:
                        continue
                    last = angle
                    if stamp[i] != mark:
                        stamp[i] = mark
                        item[number] = i
                        number += 1
            angle += step
        spans[side] = last
        left = max(2 * np.pi - last, 0.0)
    return number, min(spans[0] + spans[1], 2 * np.pi)


@njit(cache=True)
def _fit_circle(points, item, number, circle):  # noqa: ANN001, ANN202
    """One Gauss-Newton step of the geometric fit, in place; whether the circle is still one."""
    normal = np.zeros((3, 3))
    right = np.zeros(3)
    row = np.empty(3)
    for k in range(number):
        ox, oy = points[item[k], 0] - circle[0], points[item[k], 1] - circle[1]
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
    return SMALLEST_RADIUS <= circle[2] <= LARGEST_RADIUS
