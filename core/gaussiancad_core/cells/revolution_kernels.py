"""Where lines of sight meet bodies: fast kernels.

The plain code is in :mod:`.surfaces_of_revolution` and :mod:`.half_spaces`.

A body is a row of numbers: its kind; of a half space its normal and offset; of a body of revolution
its axis, centre, the ends and numbers of its profile, its sector, and whether it lies beyond it.
"""

from math import hypot, sqrt

import numpy as np
from numba import njit

from gaussiancad_core.geometry.tolerances import FAR, UNIT_VECTOR

HALF_SPACE, CONE, ROUND = 0.0, 1.0, 2.0

MOST = 8
"""Crossings of a line with a body, at most."""

PLACES = 16

KIND, ALONG, CENTRE, LOW, HIGH, PROFILE, SECTOR, BEYOND = 0, 1, 2, 4, 5, 6, 10, 15
"""Where in a row the numbers of a body of revolution are: of the profile four, of the sector
whether there is one and the normals of both sides."""


@njit(cache=True)
def _radius(body, z):  # noqa: ANN001, ANN202
    if body[KIND] == CONE:
        share = (z - body[LOW]) / (body[HIGH] - body[LOW])
        return body[PROFILE] + share * (body[PROFILE + 1] - body[PROFILE])
    square = body[PROFILE + 2] ** 2 - (z - body[PROFILE]) ** 2
    return body[PROFILE + 1] + body[PROFILE + 3] * sqrt(max(square, 0.0))


@njit(cache=True)
def _heights(body, r, out):  # noqa: ANN001, ANN202
    low, high = body[LOW], body[HIGH]
    if body[KIND] == CONE:
        at_low, at_high = body[PROFILE], body[PROFILE + 1]
        if at_high == at_low:
            return 0
        share = (r - at_low) / (at_high - at_low)
        out[0] = low + share * (high - low)
        return 1 if 0.0 < share < 1.0 else 0
    off = (r - body[PROFILE + 1]) * body[PROFILE + 3]
    if off < 0.0 or off >= body[PROFILE + 2]:
        return 0
    half = sqrt(body[PROFILE + 2] ** 2 - off**2)
    count = 0
    for z in (body[PROFILE] - half, body[PROFILE] + half):
        if low < z < high:
            out[count] = z
            count += 1
    return count


@njit(cache=True)
def _leaving(body, z):  # noqa: ANN001, ANN202
    """Unit normal (along r, along z) that leaves the space below the profile."""
    if body[KIND] == CONE:
        along = body[HIGH] - body[LOW]
        across = body[PROFILE + 1] - body[PROFILE]
        length = hypot(along, across)
        return along / length, -across / length
    radius, side = body[PROFILE + 2], body[PROFILE + 3]
    along_r = (_radius(body, z) - body[PROFILE + 1]) / radius * side
    return along_r, (z - body[PROFILE]) / radius * side


@njit(cache=True)
def _first(normal):  # noqa: ANN001, ANN202
    return 1 if normal == 0 else 0


@njit(cache=True)
def _second(normal):  # noqa: ANN001, ANN202
    return 1 if normal == 2 else 2


@njit(cache=True)
def _put(out, count, depth, axis, direction):  # noqa: ANN001, ANN202
    depths, normals = out
    depths[count] = depth
    normals[count, _first(axis)] = direction[0]
    normals[count, _second(axis)] = direction[1]
    normals[count, axis] = direction[2]
    return count + 1


@njit(cache=True)
def crossings(body, normal, at, out):  # noqa: ANN001, ANN201
    """How often the line through a point of a plane meets a body; the arrays get where."""
    a, b = at
    depths, normals = out
    if body[KIND] == HALF_SPACE:
        rest = body[4] - body[1 + _first(normal)] * a - body[1 + _second(normal)] * b
        far = -FAR if body[1 + normal] > 0.0 else FAR
        depth = rest / body[1 + normal]
        depths[0], depths[1] = min(depth, far), max(depth, far)
        normals[:2] = body[1:4]
        return 2
    axis = int(body[ALONG])
    if axis == normal:
        a, b = a - body[CENTRE], b - body[CENTRE + 1]
        if body[SECTOR] and not (
            a * body[SECTOR + 1] + b * body[SECTOR + 2] > 0.0
            and a * body[SECTOR + 3] + b * body[SECTOR + 4] > 0.0
        ):
            return 0
        return _met_along(body, (a, b), out)
    return _met_across(body, normal, at, out)


@njit(cache=True)
def _met_along(body, at, out):  # noqa: ANN001, ANN202
    a, b = at
    axis = int(body[ALONG])
    r = max(hypot(a, b), UNIT_VECTOR)
    count = 0
    for z in (body[LOW], body[HIGH]):
        if (r > _radius(body, z)) == bool(body[BEYOND]):
            count = _put(out, count, z, axis, (0.0, 0.0, 1.0))
    heights = np.empty(2)
    for k in range(_heights(body, r, heights)):
        along_r, along_z = _leaving(body, heights[k])
        away = (0.0, 0.0) if r <= UNIT_VECTOR else (a / r, b / r)
        direction = (along_r * away[0], along_r * away[1], along_z)
        count = _put(out, count, heights[k], axis, direction)
    return count


@njit(cache=True)
def _met_across(body, normal, at, out):  # noqa: ANN001, ANN202
    a, b = at
    axis = int(body[ALONG])
    z, other = (a, b) if _first(normal) == axis else (b, a)
    if not body[LOW] < z < body[HIGH]:
        return 0
    place = 0 if _first(axis) == normal else 1
    off = other - body[CENTRE + 1 - place]
    r = _radius(body, z)
    half = sqrt(r * r - off * off) if r > abs(off) else 0.0
    if body[SECTOR]:
        return _met_sector(body, (place, off, z, r, half), out)
    count = 0
    if half > 0.0:
        for way in (-half, half):
            count = _put_round(body, (place, off, z, r), way, out, count)
    if body[BEYOND]:
        for way in (-FAR, FAR):
            count = _put(out, count, way, axis, (1.0, 0.0, 0.0))
    return count


@njit(cache=True)
def _put_round(body, at, way, out, count):  # noqa: ANN001, ANN202
    place, off, z, r = at
    along_r, along_z = _leaving(body, z)
    along, across = along_r * (way / r), along_r * (off / r)
    direction = (along, across, along_z) if place == 0 else (across, along, along_z)
    return _put(out, count, body[CENTRE + place] + way, int(body[ALONG]), direction)


@njit(cache=True)
def _met_sector(body, at, out):  # noqa: ANN001, ANN202
    """Crossings with what of the sector lies beyond the profile's circle, or in it."""
    place, off, z, r, half = at
    low, high = -FAR, FAR
    low_side = high_side = -1
    for side in range(2):
        inward = (body[SECTOR + 1 + 2 * side], body[SECTOR + 2 + 2 * side])
        slope, rest = inward[place], inward[1 - place] * off
        if abs(slope) < UNIT_VECTOR:
            if rest <= 0.0:
                return 0
            continue
        where = -rest / slope
        if slope > 0.0 and where > low:
            low, low_side = where, side
        elif slope < 0.0 and where < high:
            high, high_side = where, side
    if low >= high:
        return 0
    middle = body[CENTRE + place]
    count = 0
    for end, side in ((low, low_side), (high, high_side)):
        below = half > 0.0 and -half < end < half
        if below != bool(body[BEYOND]):
            direction = (1.0, 0.0, 0.0)
            if side >= 0:
                direction = (body[SECTOR + 1 + 2 * side], body[SECTOR + 2 + 2 * side], 0.0)
            count = _put(out, count, middle + end, int(body[ALONG]), direction)
    if half > 0.0:
        for way in (-half, half):
            if low < way < high:
                count = _put_round(body, (place, off, z, r), way, out, count)
    return count
