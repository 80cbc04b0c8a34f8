"""The crossings of rays on both sides of many pieces of lines, and the groups that they make.

Fast kernels of :meth:`.cell_complex.CellComplex.column` and of
:func:`gaussiancad_core.labelling.visibility_rules.groups_at`.  A cell is one number, its *key*: the
regions of the X, Y and Z plane as digits, then a bit for each body; void is ``VOID``.  A surface is
``SURFACES`` times the normal of its plane, and its carrier plus one.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from numba import njit

from gaussiancad_core.cells.arrangement_kernels import (
    ROUGH,
    Floats,
    Integers,
    Table,
    Traces,
    locate,
    longer,
)
from gaussiancad_core.cells.cell_complex import BODY, PARALLEL
from gaussiancad_core.cells.revolution_kernels import MOST, crossings
from gaussiancad_core.geometry.tolerances import ASIDE, COMPUTED

VOID = -1
"""Key of what is no cell."""

SURFACES = 1 << 32
"""More than any plane has carriers."""

GROUP = 0.06
"""Units of depth within which crossings of both columns are looked at together."""

CLEAR = 2e-3
"""Units around a piece's point within which nothing else may run."""


class Frame(NamedTuple):
    """What all lines of sight through one plane have in common.

    Attributes:
        normal: they run along.
        views: (2,) normals of the planes that show the first and the second coordinate.
        table: the plane's arrangement.
        bodies: (n, 16) rows.
        counting: (3, most regions) bits of the bodies that count in a region of each plane.
        sizes: (3,) regions of the planes.
    """

    normal: int
    views: Integers
    table: Table
    bodies: Floats
    counting: Integers
    sizes: Integers


class Sides(NamedTuple):
    """Pieces, and which traces the columns on both of their sides follow.

    Attributes:
        points, across: (n, 2).
        drawn: (n,) whether pieces are drawn.
        upward: (n,) whether their views look towards larger coordinates.
        traced: (n, 2, 2) by piece, side and coordinate the number of the trace.
        firsts, seconds: traces of the planes that show the first and the second coordinate.
    """

    points: Floats
    across: Floats
    drawn: npt.NDArray[np.bool_]
    upward: npt.NDArray[np.bool_]
    traced: Integers
    firsts: Traces
    seconds: Traces


class Told(NamedTuple):
    """What pieces say, and the crossings of all columns that were looked at.

    Attributes:
        starts: (n + 1,) where in ``stream`` the pieces begin, and the last one ends.
        says: (n,) whether a piece says anything.
        stream: of each piece its groups from the viewer on: how many pairs, lone and different
            transitions, then these, keys of cells throughout.
        columns: (c + 1,) where the crossings of each column begin.
        depths: of the crossings.
        surfaces, before, after: of the crossings.
    """

    starts: Integers
    says: npt.NDArray[np.bool_]
    stream: Integers
    columns: Integers
    depths: Floats
    surfaces: Integers
    before: Integers
    after: Integers


@njit(cache=True)
def _key(frame, regions, bits):  # noqa: ANN001, ANN202
    x, y, z = regions[0], regions[1], regions[2]
    if x == 0 or y == 0 or z == 0:
        return VOID
    bits &= frame.counting[0, x] & frame.counting[1, y] & frame.counting[2, z]
    place = (x * frame.sizes[1] + y) * frame.sizes[2] + z
    return (place << frame.bodies.shape[0]) | bits


@njit(cache=True)
def _parallel(one, other):  # noqa: ANN001, ANN202
    return abs(one[0] * other[0] + one[1] * other[1] + one[2] * other[2]) > PARALLEL


@njit(cache=True)
def _within_chains(count, depths, surfaces, regions):  # noqa: ANN001, ANN202
    """Moves steps that lie a hair outside a chain inside."""
    for k in range(count):
        if surfaces[k] % SURFACES == 0:
            continue
        depth = depths[k]
        for chain in range(count):
            if surfaces[chain] % SURFACES == 0:
                at = depths[chain]
                if regions[chain] != 0 and at - ROUGH < depth <= at:
                    depth = at + COMPUTED
                elif regions[chain] == 0 and at <= depth < at + ROUGH:
                    depth = at - COMPUTED
        depths[k] = depth


@njit(cache=True)
def _steps(frame, sides, which, steps):  # noqa: ANN001, ANN202
    """Fills the steps of a column in ascending depth: how many, and the regions it starts in."""
    piece, side, item = which
    depths, normals, surfaces, behind = steps
    at = _column_point(sides, piece, side)
    regions = np.zeros(3, np.int64)
    regions[frame.normal] = item
    count = 0
    chained = False
    for coordinate in range(2):
        traces = sides.firsts if coordinate == 0 else sides.seconds
        plane = frame.views[coordinate]
        trace = sides.traced[piece, side, coordinate]
        regions[plane] = traces.first[trace]
        chained |= traces.chained[trace]
        one, two = (1, 2) if plane == 0 else ((0, 2) if plane == 1 else (0, 1))
        for k in range(traces.starts[trace], traces.starts[trace + 1]):
            depths[count] = traces.positions[k]
            normals[count, plane] = 0.0
            normals[count, one] = traces.normals[k, 0]
            normals[count, two] = traces.normals[k, 1]
            surfaces[count] = plane * SURFACES + traces.carriers[k] + 1
            behind[count] = traces.regions[k]
            count += 1
    counting = frame.counting[frame.normal, item]
    for body in range(frame.bodies.shape[0]):
        if counting >> body & 1:
            out = (depths[count:], normals[count:])
            found = crossings(frame.bodies[body], frame.normal, at, out)
            for _ in range(found):
                surfaces[count] = BODY * SURFACES + body + 1
                behind[count] = 0
                count += 1
    if chained:
        _within_chains(count, depths, surfaces, behind)
    order = np.argsort(depths[:count], kind="mergesort")
    depths[:count] = depths[:count][order]
    normals[:count] = normals[:count][order]
    surfaces[:count] = surfaces[:count][order]
    behind[:count] = behind[:count][order]
    return count, regions


@njit(cache=True)
def _column(frame, sides, which, steps, column):  # noqa: ANN001, ANN202
    """Fills the crossings of a column; how many."""
    depths, normals, surfaces, before, after = column
    if which[2] == 0:
        return 0
    count, regions = _steps(frame, sides, which, steps)
    bits = 0
    found = 0
    last = _key(frame, regions, bits)
    for k in range(count):
        surface = steps[2][k]
        plane = surface // SURFACES
        if plane == BODY:
            bits ^= 1 << (surface % SURFACES - 1)
        else:
            regions[plane] = steps[3][k]
        key = _key(frame, regions, bits)
        if surface % SURFACES == 0:
            last = key
            continue
        depth, normal = steps[0][k], steps[1][k]
        if (
            found
            and abs(depths[found - 1] - depth) < COMPUTED
            and _parallel(normals[found - 1], normal)
        ):
            after[found - 1] = key
        else:
            depths[found] = depth
            normals[found] = normal
            surfaces[found] = surface
            before[found] = last
            after[found] = key
            found += 1
        last = key
    kept = 0
    for k in range(found):
        if before[k] != after[k]:
            depths[kept], surfaces[kept] = depths[k], surfaces[k]
            before[kept], after[kept] = before[k], after[k]
            normals[kept] = normals[k]
            kept += 1
    return kept


@njit(cache=True)
def _nearest(one, i, other, among, is_same):  # noqa: ANN001, ANN202
    """The nearest crossing that may be a partner among free ones between two; -1 for none."""
    low, high, free = among
    best = -1
    for j in range(low, high):
        if not free[j] or not _parallel(one[1][i], other[1][j]):
            continue
        if is_same and one[2][i] != other[2][j]:
            continue
        if best < 0 or abs(other[0][j] - one[0][i]) < abs(other[0][best] - one[0][i]):
            best = j
    return best


@njit(cache=True)
def _group(one, other, bounds, free, out):  # noqa: ANN001, ANN202
    """Writes a group: its length, and whether different surfaces are partners, and whether both
    columns do the same whatever the labels are."""
    low, high, other_low, other_high = bounds
    free[other_low:other_high] = True
    partner = np.full(high - low, -1)
    pairs = 0
    end = 3
    trivial = True
    doubtful = False
    for is_same in (True, False):
        for i in range(low, high):
            if partner[i - low] >= 0:
                continue
            j = _nearest(one, i, other, (other_low, other_high, free), is_same)
            if j < 0:
                continue
            doubtful |= not is_same
            free[j] = False
            partner[i - low] = j
            out[end], out[end + 1] = one[3][i], one[4][i]
            out[end + 2], out[end + 3] = other[3][j], other[4][j]
            alike = one[3][i] == other[3][j] and one[4][i] == other[4][j]
            crossed = one[3][i] == other[4][j] and one[4][i] == other[3][j]
            trivial &= alike or crossed
            pairs += 1
            end += 4
    lone = 0
    for i in range(low, high):
        if partner[i - low] < 0:
            out[end], out[end + 1] = one[3][i], one[4][i]
            lone += 1
            end += 2
    for j in range(other_low, other_high):
        if free[j]:
            out[end], out[end + 1] = other[3][j], other[4][j]
            lone += 1
            end += 2
    start = end
    for k in range(high - low + other_high - other_low):
        is_one = k < high - low
        column, i = (one, low + k) if is_one else (other, other_low + k - (high - low))
        known = False
        for place in range(start, end, 2):
            known |= out[place] == column[3][i] and out[place + 1] == column[4][i]
        if not known:
            out[end], out[end + 1] = column[3][i], column[4][i]
            end += 2
    out[0], out[1], out[2] = pairs, lone, (end - start) // 2
    return end, doubtful, trivial and lone == 0


@njit(cache=True)
def _by_depth(one, other, counts, bounds):  # noqa: ANN001, ANN202
    """Fills of both columns where the crossings of one depth begin and end; how many depths."""
    i = j = found = 0
    while i < counts[0] or j < counts[1]:
        bounds[found, 0], bounds[found, 2] = i, j
        last = 0.0
        while i < counts[0] or j < counts[1]:
            takes_one = j >= counts[1] or (i < counts[0] and one[0][i] <= other[0][j])
            depth = one[0][i] if takes_one else other[0][j]
            if (i > bounds[found, 0] or j > bounds[found, 2]) and depth - last > GROUP:
                break
            last = depth
            if takes_one:
                i += 1
            else:
                j += 1
        bounds[found, 1], bounds[found, 3] = i, j
        found += 1
    return found


@njit(cache=True)
def _groups(both, counts, looks, scratch, out):  # noqa: ANN001, ANN202
    """Writes the groups of two columns from the viewer on; whether they say anything, and their
    length."""
    one, other = both
    drawn, upward = looks
    free, bounds = scratch
    found = _by_depth(one, other, counts, bounds)
    end = 0
    trivial = True
    for k in range(found):
        depth = bounds[k if upward else found - 1 - k]
        length, doubtful, is_trivial = _group(one, other, depth, free, out[end:])
        if doubtful and drawn:
            # Surfaces that pass smoothly into each other: a line may be drawn there or not.
            return False, 0
        trivial &= is_trivial
        end += length
    return drawn or not trivial, end


@njit(cache=True)
def _is_clear(item, point, across):  # noqa: ANN001, ANN202
    """Whether nothing else runs near a piece's point."""
    (a, b), (da, db) = (point[0], point[1]), (across[0], across[1])
    for way in (-CLEAR, CLEAR):
        here = locate(item, a + 0.01 * way * da, b + 0.01 * way * db)
        for along in (-CLEAR, 0.0, CLEAR):
            if locate(item, a + way * da - along * db, b + way * db + along * da) != here:
                return False
    return True


@njit(cache=True)
def _column_point(sides, piece, side):  # noqa: ANN001, ANN202
    """The point of a column."""
    point, across = sides.points[piece], sides.across[piece]
    way = ASIDE if side else -ASIDE
    return point[0] + way * across[0], point[1] + way * across[1]


@njit(cache=True)
def _most_steps(traces):  # noqa: ANN001, ANN202
    most = 0
    for line in range(traces.first.size):
        most = max(most, traces.starts[line + 1] - traces.starts[line])
    return most


@njit(cache=True)
def _empty_column(room):  # noqa: ANN001, ANN202
    return (
        np.empty(room),
        np.empty((room, 3)),
        np.empty(room, np.int64),
        np.empty(room, np.int64),
        np.empty(room, np.int64),
    )


@njit(cache=True)
def _side_regions(frame, sides, piece):  # noqa: ANN001, ANN202
    """Regions of the plane on both sides of a piece, and whether columns there tell anything."""
    one, other = _column_point(sides, piece, 0), _column_point(sides, piece, 1)
    regions = (locate(frame.table, one[0], one[1]), locate(frame.table, other[0], other[1]))
    tells = sides.drawn[piece] or regions[0] != 0 or regions[1] != 0
    return regions, tells and _is_clear(frame.table, sides.points[piece], sides.across[piece])


@njit(cache=True)
def statements(frame, sides):  # noqa: ANN001, ANN201
    """What pieces of one plane say."""
    pieces = sides.points.shape[0]
    room = _most_steps(sides.firsts) + _most_steps(sides.seconds)
    room += MOST * (frame.bodies.shape[0] + 1)
    steps = _empty_column(room)[:4]
    both = (_empty_column(room), _empty_column(room))
    scratch = (np.empty(room, np.bool_), np.empty((2 * room, 4), np.int64))
    # Each crossing may make a group: three numbers, two as one of a pair, and two among all.
    said = np.empty(14 * room, np.int64)
    starts, says = np.zeros(pieces + 1, np.int64), np.zeros(pieces, np.bool_)
    columns = np.zeros(2 * pieces + 1, np.int64)
    stream = np.empty(64 * pieces, np.int64)
    depths = np.empty(16 * pieces)
    surfaces, before = np.empty(depths.size, np.int64), np.empty(depths.size, np.int64)
    after = np.empty(depths.size, np.int64)
    seen = met = used = 0
    for piece in range(pieces):
        starts[piece + 1] = used
        item, tells = _side_regions(frame, sides, piece)
        if not tells:
            continue
        if met + 2 * room > depths.size:
            size = 2 * (met + 2 * room)
            depths, surfaces = longer(depths, met, size), longer(surfaces, met, size)
            before, after = longer(before, met, size), longer(after, met, size)
        counts = (0, 0)
        for side in range(2):
            column = both[side]
            count = _column(frame, sides, (piece, side, item[side]), steps, column)
            counts = (counts[0], count) if side else (count, 0)
            depths[met : met + count] = column[0][:count]
            surfaces[met : met + count] = column[2][:count]
            before[met : met + count] = column[3][:count]
            after[met : met + count] = column[4][:count]
            met += count
            seen += 1
            columns[seen] = met
        looks = (sides.drawn[piece], sides.upward[piece])
        says[piece], length = _groups(both, counts, looks, scratch, said)
        if not says[piece]:
            continue
        if used + length > stream.size:
            stream = longer(stream, used, 2 * (used + length))
        stream[used : used + length] = said[:length]
        used += length
        starts[piece + 1] = used
    return Told(
        starts,
        says,
        stream[:used].copy(),
        columns[: seen + 1].copy(),
        depths[:met].copy(),
        surfaces[:met].copy(),
        before[:met].copy(),
        after[:met].copy(),
    )
