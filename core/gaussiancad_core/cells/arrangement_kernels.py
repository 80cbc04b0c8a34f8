"""The regions of many points and lines at once: fast kernels of :mod:`.arrangement`.

Each does what the method of :class:`.arrangement.Arrangement` of the same name does for one.
"""

from math import hypot, sqrt
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from numba import njit

CHAIN = -1
"""Stands for the carrier of a chain's links."""

ROUGH = 0.05
"""Units by which a chain may be off."""

Floats = npt.NDArray[np.float64]
Integers = npt.NDArray[np.int64]


class Table(NamedTuple):
    """An arrangement as arrays.

    Attributes:
        borders: (s + 1,) of its slabs, ascending.
        slabs: (s + 1,) where in ``order`` each slab begins, and the last one ends.
        order: pieces of the slabs, in each from low to high.
        pieces: (n, 7) of a link 0, both ends, and its interval of the first coordinate; of a bow 1,
            centre, radius, side, interval.
        carriers: (n,) of the pieces.
        uprights: (m, 3) first coordinate, lower and upper end.
        upright_supports: (m,).
        regions: of the trapezoids of the slabs, each from low to high.
    """

    borders: Floats
    slabs: Integers
    order: Integers
    pieces: Floats
    carriers: Integers
    uprights: Floats
    upright_supports: Integers
    regions: Integers


class Traces(NamedTuple):
    """What lines parallel to an axis meet, line by line.

    Attributes:
        starts: (n + 1,) where the meetings of each line begin, and the last ones end.
        positions: along the lines, ascending.
        normals: (k, 2) of the curves there.
        carriers: (k,) or ``CHAIN``.
        regions: (k,) behind the meetings.
        first: (n,) regions before the first one.
        chained: (n,) whether a line meets a chain.
    """

    starts: Integers
    positions: Floats
    normals: Floats
    carriers: Integers
    regions: Integers
    first: Integers
    chained: npt.NDArray[np.bool_]


@njit(cache=True)
def _value(piece, a):  # noqa: ANN001, ANN202
    if piece[0] == 0.0:
        return piece[2] + (a - piece[1]) / (piece[3] - piece[1]) * (piece[4] - piece[2])
    square = piece[3] ** 2 - (a - piece[1]) ** 2
    return piece[2] + piece[4] * sqrt(square) if square > 0.0 else piece[2]


@njit(cache=True)
def _normal(piece, a):  # noqa: ANN001, ANN202
    if piece[0] == 0.0:
        da, db = piece[3] - piece[1], piece[4] - piece[2]
        length = hypot(da, db)
        return -db / length, da / length
    return (a - piece[1]) / piece[3], (_value(piece, a) - piece[2]) / piece[3]


@njit(cache=True)
def locate(table, a, b):  # noqa: ANN001, ANN201
    """The region of a point."""
    slab = np.searchsorted(table.borders, a, side="right") - 1
    if slab < 0 or slab >= table.slabs.size - 1:
        return 0
    start, end = table.slabs[slab], table.slabs[slab + 1]
    place = start
    while place < end and _value(table.pieces[table.order[place]], a) < b:
        place += 1
    return table.regions[place + slab]


@njit(cache=True)
def _firsts_at(piece, b, out):  # noqa: ANN001, ANN202
    """How often a piece has a second coordinate; ``out`` gets the first ones."""
    if piece[0] == 0.0:
        if (piece[2] - b) * (piece[4] - b) >= 0.0:
            return 0
        out[0] = piece[1] + (b - piece[2]) / (piece[4] - piece[2]) * (piece[3] - piece[1])
        return 1
    off = b - piece[2]
    if abs(off) >= piece[3] or off * piece[4] <= 0.0:
        return 0
    half = sqrt(piece[3] ** 2 - off**2)
    count = 0
    for a in (piece[1] - half, piece[1] + half):
        if piece[5] - 1e-9 <= a <= piece[6] + 1e-9:
            out[count] = a
            count += 1
    return count


@njit(cache=True)
def _trace_upright(table, a, out):  # noqa: ANN001, ANN202
    """Fills what an upright line meets; how much that is, and the region it starts in."""
    positions, normals, carriers, regions = out
    slab = np.searchsorted(table.borders, a, side="right") - 1
    if slab < 0 or slab >= table.slabs.size - 1:
        return 0, 0
    start, end = table.slabs[slab], table.slabs[slab + 1]
    for k in range(end - start):
        piece = table.order[start + k]
        positions[k] = _value(table.pieces[piece], a)
        normals[k, 0], normals[k, 1] = _normal(table.pieces[piece], a)
        carriers[k] = table.carriers[piece]
        regions[k] = table.regions[start + slab + k + 1]
    return end - start, table.regions[start + slab]


@njit(cache=True)
def _trace_level(table, b, out):  # noqa: ANN001, ANN202
    """The same of a level line."""
    positions, normals, carriers, regions = out
    hits = np.empty(2)
    count = 0
    for piece in range(table.pieces.shape[0]):
        for k in range(_firsts_at(table.pieces[piece], b, hits)):
            positions[count] = hits[k]
            normals[count, 0], normals[count, 1] = _normal(table.pieces[piece], hits[k])
            carriers[count] = table.carriers[piece]
            count += 1
    for upright in range(table.uprights.shape[0]):
        if table.uprights[upright, 1] < b < table.uprights[upright, 2]:
            positions[count] = table.uprights[upright, 0]
            normals[count, 0], normals[count, 1] = 1.0, 0.0
            carriers[count] = table.upright_supports[upright]
            count += 1
    order = np.argsort(positions[:count], kind="mergesort")
    positions[:count] = positions[:count][order]
    normals[:count] = normals[:count][order]
    carriers[:count] = carriers[:count][order]
    for k in range(count - 1):
        regions[k] = locate(table, (positions[k] + positions[k + 1]) / 2.0, b)
    if count:
        regions[count - 1] = 0
    return count, 0


@njit(cache=True)
def _without_slivers(count, out):  # noqa: ANN001, ANN202
    """Leaves out the outside between a chain and a carrier right beside it; how much is left."""
    positions, normals, carriers, regions = out
    kept = 0
    for k in range(count):
        last = kept - 1
        if (
            kept > 0
            and regions[last] == 0
            and positions[k] - positions[last] < ROUGH
            and (carriers[last] == CHAIN) != (carriers[k] == CHAIN)
        ):
            if carriers[last] == CHAIN:
                positions[last] = positions[k]
                normals[last] = normals[k]
                carriers[last] = carriers[k]
            regions[last] = regions[k]
        else:
            positions[kept] = positions[k]
            normals[kept] = normals[k]
            carriers[kept] = carriers[k]
            regions[kept] = regions[k]
            kept += 1
    return kept


@njit(cache=True)
def longer(array, used, size):  # noqa: ANN001, ANN201
    """An array that begins as another one and has a length of ``size``."""
    found = np.empty((size, *array.shape[1:]), array.dtype)
    found[:used] = array[:used]
    return found


@njit(cache=True)
def traces(table, coordinate, values):  # noqa: ANN001, ANN201
    """What the lines meet on which a coordinate (0 or 1) has values, without slivers."""
    room = 2 * table.pieces.shape[0] + table.uprights.shape[0] + 1
    positions, normals = np.empty(room), np.empty((room, 2))
    carriers, regions = np.empty(room, np.int64), np.empty(room, np.int64)
    out = (positions, normals, carriers, regions)
    starts = np.zeros(values.size + 1, np.int64)
    first = np.zeros(values.size, np.int64)
    chained = np.zeros(values.size, np.bool_)
    size = max(16, 8 * values.size)
    all_positions, all_normals = np.empty(size), np.empty((size, 2))
    all_supports, all_regions = np.empty(size, np.int64), np.empty(size, np.int64)
    for line in range(values.size):
        value = values[line]
        if coordinate == 0:
            count, region = _trace_upright(table, value, out)
        else:
            count, region = _trace_level(table, value, out)
        first[line] = region
        for k in range(count):
            chained[line] |= carriers[k] == CHAIN
        if chained[line]:
            count = _without_slivers(count, out)
        start = starts[line]
        end = start + count
        if end > all_positions.size:
            all_positions = longer(all_positions, start, 2 * end)
            all_normals = longer(all_normals, start, 2 * end)
            all_supports = longer(all_supports, start, 2 * end)
            all_regions = longer(all_regions, start, 2 * end)
        all_positions[start:end] = positions[:count]
        all_normals[start:end] = normals[:count]
        all_supports[start:end] = carriers[:count]
        all_regions[start:end] = regions[:count]
        starts[line + 1] = end
    end = starts[values.size]
    return Traces(
        starts,
        all_positions[:end],
        all_normals[:end],
        all_supports[:end],
        all_regions[:end],
        first,
        chained,
    )
