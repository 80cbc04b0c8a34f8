"""Compiled loops over lines of sight through planned features: where they enter and leave, what
adding or cutting changes, and what that costs.

Tables have a row for each line of sight: how many surfaces it crosses, their depths from the least
coordinate along the axis on, and their numbers.
"""

# Types are told to numba by what is passed.
# ruff: noqa: ANN001, ANN201, ANN202, PLR0917

from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numba import njit

from gaussiancad_core.judging.difference_kinds import PRICES, Kind
from gaussiancad_core.judging.sight_pairs import Drawn

MOST = 24
"""Crossings of a line of sight with a part at most."""

PAIRS = 4
"""Pairs that a line of sight has, about."""

FEW = 12
"""Crossings of a line of sight with a feature at most."""


class Operation(IntEnum):
    """What a feature does to a part."""

    ADD = 0
    CUT = 1
    MEET = 2
    SET = 3
    """The part becomes the feature between its two places."""


_CUT, _MEET, _SET = int(Operation.CUT), int(Operation.MEET), int(Operation.SET)
_ADD = int(Operation.ADD)
_MISSING, _MISSING_HIDDEN = PRICES[Kind.MISSING], PRICES[Kind.MISSING_HIDDEN]
_EXTRA, _EXTRA_HIDDEN = PRICES[Kind.EXTRA], PRICES[Kind.EXTRA_HIDDEN]
_LINETYPE, _TANGENT = PRICES[Kind.LINETYPE], PRICES[Kind.TANGENT]

_VISIBLE, _HIDDEN = int(Drawn.VISIBLE), int(Drawn.HIDDEN)
_SMOOTH = int(Drawn.TANGENT)

NOTED = 1 + max(map(int, Drawn))
"""Beside :class:`Drawn`: a pair whose depths a note tells."""


class Crossed(NamedTuple):
    """What lines of sight cross of a part: (n,) counts, (n, MOST) depths in mm and surfaces."""

    counts: np.ndarray
    depth: np.ndarray
    surface: np.ndarray


class Table(NamedTuple):
    """What lines of sight of a view cross of a feature.

    Attributes:
        rows: (k,) numbers of the lines of sight.
        where: (k,) rows of the three that follow, which lines of sight in a row share.
        counts, depth, surface: as of :class:`Crossed`.
        at: (k,) mm along the feature's axis, of lines of sight across it; 0 of those along it.
        low, high: mm along its axis between which the feature lies; -1 and 1 of what is seen along
            it.
        is_along: whether the view looks along the feature's axis.
    """

    rows: np.ndarray
    where: np.ndarray
    counts: np.ndarray
    depth: np.ndarray
    surface: np.ndarray
    at: np.ndarray
    low: float
    high: float
    is_along: bool


class Signs(NamedTuple):
    """(n,) what lines of sight are compared by, as of :class:`.lines_of_sight.Seen`, and mm along
    the axis at which they meet the part first, infinite of those that do not."""

    every: np.ndarray
    sharp: np.ndarray
    first: np.ndarray
    front: np.ndarray


class Pairs(NamedTuple):
    """Pairs of lines of sight.

    Attributes:
        one, other: (p,) numbers of both.
        drawn: (p,) what is drawn between them.
        weight: (p,) mm.
        depth: (p,) mm by which what the first meets lies beneath what the other one does, as a
            note says; infinite where that goes through.
        cost: (p,) what they cost now.
        first: (n + 1,) where the pairs of each line of sight begin among the following.
        of: (2p,) the pairs of the first line of sight, of the second one, and so on.
    """

    one: np.ndarray
    other: np.ndarray
    drawn: np.ndarray
    weight: np.ndarray
    depth: np.ndarray
    cost: np.ndarray
    first: np.ndarray
    of: np.ndarray


class Scratch(NamedTuple):
    """Where a trial keeps its signs: (n,) which trial changed a line of sight last, and how."""

    stamp: np.ndarray
    every: np.ndarray
    sharp: np.ndarray
    first: np.ndarray
    front: np.ndarray


class Looks(NamedTuple):
    """How a view looks: (s,) of each surface the first that it passes into smoothly, (n,) mm along
    the axis at which each line of sight is cut open, NaN where it is not, whether it sees the least
    coordinate first, whether it draws what is hidden and what is smooth, and mm within which a
    depth is as a note says."""

    roots: np.ndarray
    cut_at: np.ndarray
    looks_up: bool
    draws_hidden: bool
    draws_tangents: bool
    near: float


@njit(cache=True)
def inside(edges, x, y):
    """(n,) whether places lie in an area with edges (m, 4): an odd number of them lies to the
    right."""
    found = np.zeros(len(x), np.bool_)
    for i in range(len(x)):
        is_odd = False
        for e in range(len(edges)):
            low, high = edges[e, 1], edges[e, 3]
            if (low <= y[i]) != (high <= y[i]):
                share = (y[i] - low) / (high - low)
                if edges[e, 0] + share * (edges[e, 2] - edges[e, 0]) > x[i]:
                    is_odd = not is_odd
        found[i] = is_odd
    return found


@njit(cache=True)
def across(edges, surfaces, fixed, along):
    """Where lines cross an area's edges.

    Args:
        edges: (m, 4) of the area.
        surfaces: (m,) behind them.
        fixed: (n,) the coordinate that each line keeps.
        along: 0 where lines run along the first coordinate, 1 where along the second.
    """
    n = len(fixed)
    count = np.zeros(n, np.int64)
    depth = np.zeros((n, FEW))
    surface = np.zeros((n, FEW), np.int64)
    kept = 1 - along
    for i in range(n):
        k = 0
        for e in range(len(edges)):
            low, high = edges[e, kept], edges[e, 2 + kept]
            if (low <= fixed[i]) != (high <= fixed[i]) and k < FEW:
                share = (fixed[i] - low) / (high - low)
                place = edges[e, along] + share * (edges[e, 2 + along] - edges[e, along])
                j = k
                while j > 0 and depth[i, j - 1] > place:
                    depth[i, j], surface[i, j] = depth[i, j - 1], surface[i, j - 1]
                    j -= 1
                depth[i, j], surface[i, j] = place, surfaces[e]
                k += 1
        count[i] = k - k % 2
    return count, depth, surface


@njit(cache=True)
def across_turned(edges, surfaces, height, off_axis):
    """Where lines across a turned body cross it.

    Args:
        edges: (m, 4) of its profile: radius and height, twice.
        surfaces: (m,) behind them.
        height: (n,) of each line.
        off_axis: (n,) mm by which each passes the axis.
    """
    n = len(height)
    count = np.zeros(n, np.int64)
    depth = np.zeros((n, FEW))
    surface = np.zeros((n, FEW), np.int64)
    radii, behind = np.zeros(FEW), np.zeros(FEW, np.int64)
    for i in range(n):
        aside, k = abs(off_axis[i]), 0
        for e in range(len(edges)):
            low, high = edges[e, 1], edges[e, 3]
            if (low <= height[i]) != (high <= height[i]) and k < FEW // 2:
                share = (height[i] - low) / (high - low)
                radius = edges[e, 0] + share * (edges[e, 2] - edges[e, 0])
                if radius <= aside:
                    continue
                j = k
                while j > 0 and radii[j - 1] > radius:
                    radii[j], behind[j] = radii[j - 1], behind[j - 1]
                    j -= 1
                radii[j], behind[j] = radius, surfaces[e]
                k += 1
        for j in range(k):
            reach = np.sqrt(radii[j] * radii[j] - aside * aside)
            depth[i, k - 1 - j], surface[i, k - 1 - j] = -reach, behind[j]
            depth[i, k + j], surface[i, k + j] = reach, behind[j]
        count[i] = 2 * k
    return count, depth, surface


# Kernels take plain arrays: taking them out of tuples again for each row costs six times as much as
# all else that is done there.


@njit(cache=True)
def _merge(
    counts, depths, surfaces, i,
    others, other_depths, other_surfaces, w,
    operation, near, made, names,
):  # fmt: skip
    """Put what a line of sight crosses of two bodies under an operation into a table; how many.

    Args:
        counts, depths, surfaces: of the body that is changed, and
        i: the row of the line of sight in them.
        others, other_depths, other_surfaces: of the other one, and
        w: the row there.
        operation: of the other on the one.
        near: mm within which two crossings are one.
        made, names: one row of depths and surfaces, filled in.
    """
    count, other_count = counts[i], others[w]
    if operation == _SET:
        for q in range(other_count):
            made[0, q], names[0, q] = other_depths[w, q], other_surfaces[w, q]
        return other_count
    m = n = k = 0
    in_one = in_other = was_in = False
    while m < count or n < other_count:
        if m < count and (n >= other_count or depths[i, m] <= other_depths[w, n]):
            place, number = depths[i, m], surfaces[i, m]
        else:
            place, number = other_depths[w, n], other_surfaces[w, n]
        while m < count and depths[i, m] <= place + near:
            in_one = not in_one
            m += 1
        while n < other_count and other_depths[w, n] <= place + near:
            in_other = not in_other
            n += 1
        if operation == _ADD:
            is_in = in_one or in_other
        elif operation == _CUT:
            is_in = in_one and not in_other
        else:
            is_in = in_one and in_other
        if is_in != was_in:
            if k < MOST:
                made[0, k], names[0, k] = place, number
                k += 1
            was_in = is_in
    return k


@njit(cache=True)
def _sign(count, depths, surfaces, i, cut_at, looks_up, roots):
    """What a line of sight is compared by.

    Args:
        count: of its crossings.
        depths, surfaces: of them, in their row
        i: of these tables.
        cut_at: mm along the axis where it is cut open; NaN where it is not.
        looks_up: whether the view sees the least coordinate first.
        roots: of each surface the first that it passes into smoothly.
    """
    start, end, is_cut = 0, count, False
    if not np.isnan(cut_at):
        if looks_up:
            while start < count and depths[i, start] < cut_at:
                start += 1
            is_cut = start % 2 == 1
        else:
            while end > 0 and depths[i, end - 1] > cut_at:
                end -= 1
            is_cut = end % 2 == 1
    every = sharp = 1469598103934665603
    for q in range(start, end):
        every = (every * 1099511628211) ^ (surfaces[i, q] + 7)
        sharp = (sharp * 1099511628211) ^ (roots[surfaces[i, q]] + 7)
    first, front = -1, np.inf
    if is_cut:
        # The cut is a surface of its own.
        first = len(roots)
        every = (every * 1099511628211) ^ (first + 7)
        sharp = (sharp * 1099511628211) ^ (first + 7)
        front = cut_at
    elif end > start:
        first = roots[surfaces[i, start if looks_up else end - 1]]
        front = depths[i, start if looks_up else end - 1]
    return every, sharp, first, front


@njit(cache=True)
def combine(crossed, table, operations, near) -> None:
    """Do operations for the lines of sight of a table, in place.

    Args:
        crossed: of the part, changed.
        table: of the feature.
        operations: one for all lines of sight, or (k,) one for each row.
        near: mm within which two crossings are one.
    """
    counts, depths, surfaces = crossed.counts, crossed.depth, crossed.surface
    others, other_depths, other_surfaces = table.counts, table.depth, table.surface
    rows, where, at = table.rows, table.where, table.at
    made, names = np.zeros((1, MOST)), np.zeros((1, MOST), np.int64)
    for q in range(len(rows)):
        i = rows[q]
        operation = operations[q if len(operations) > 1 else 0]
        if table.low < at[q] < table.high:
            counts[i] = _merge(
                counts, depths, surfaces, i,
                others, other_depths, other_surfaces, where[q],
                operation, near, made, names,
            )  # fmt: skip
            for k in range(counts[i]):
                depths[i, k], surfaces[i, k] = made[0, k], names[0, k]
        elif operation == _MEET:
            counts[i] = 0


@njit(cache=True)
def sign(crossed, looks, signs) -> None:
    """Put what all lines of sight are compared by into a table."""
    counts, depths, surfaces = crossed.counts, crossed.depth, crossed.surface
    every, sharp, first, front = signs.every, signs.sharp, signs.first, signs.front
    cut_at, roots = looks.cut_at, looks.roots
    for i in range(len(counts)):
        every[i], sharp[i], first[i], front[i] = _sign(
            counts[i], depths, surfaces, i, cut_at[i], looks.looks_up, roots
        )


@njit(cache=True)
def _price(drawn, weight, depth, one, other, looks):
    """What a pair costs: as of :func:`.difference_kinds.kinds_between`, or by a note."""
    if drawn == NOTED:
        share = _price_noted(depth, one[3], other[3], looks.near)
    elif one[1] == other[1]:
        share = _price_alike(drawn, one[0] != other[0], looks.draws_tangents)
    else:
        share = _price_apart(drawn, one[2] != other[2], looks.draws_hidden)
    return share * weight


@njit(cache=True)
def _price_noted(depth, one, other, near):
    """The price of a hole that is not as a note says: as deep, or through."""
    if np.isinf(depth):
        return 0.0 if np.isinf(one) else 1.0
    if np.isinf(one) or np.isinf(other):
        return 1.0
    return 0.0 if abs(abs(one - other) - depth) <= near else 1.0


@njit(cache=True)
def _price_alike(drawn, is_smooth, draws_tangents):
    """The price of a mm where a part has no sharp edge."""
    price = 0.0
    if is_smooth:
        if (drawn == _VISIBLE or drawn == _HIDDEN) and not draws_tangents:  # noqa: SIM109, PLR1714
            price = _TANGENT
    elif drawn == _VISIBLE:
        price = _MISSING
    elif drawn == _HIDDEN:
        price = _MISSING_HIDDEN
    elif drawn == _SMOOTH:
        price = _TANGENT
    return price


@njit(cache=True)
def _price_apart(drawn, is_shown, draws_hidden):
    """The price of a mm where a part has an edge."""
    price = 0.0
    if is_shown:
        if drawn == _HIDDEN or drawn == _SMOOTH:  # noqa: SIM109, PLR1714
            price = _LINETYPE
        elif drawn != _VISIBLE:
            price = _EXTRA
    elif drawn == _VISIBLE:
        price = _LINETYPE
    elif drawn != _HIDDEN and drawn != _SMOOTH and draws_hidden:  # noqa: PLR1714
        price = _EXTRA_HIDDEN
    return price


@njit(cache=True)
def price(pairs, signs, looks):
    """What all pairs cost, and put it into their table."""
    ones, others, drawn, weight = pairs.one, pairs.other, pairs.drawn, pairs.weight
    every, sharp, first, front = signs.every, signs.sharp, signs.first, signs.front
    depth, costs = pairs.depth, pairs.cost
    total = 0.0
    for p in range(len(ones)):
        i, j = ones[p], others[p]
        one = every[i], sharp[i], first[i], front[i]
        other = every[j], sharp[j], first[j], front[j]
        costs[p] = _price(drawn[p], weight[p], depth[p], one, other, looks)
        total += costs[p]
    return total


@njit(cache=True)
def _changed(rows, signs, scratch, mark, pairs, looks):
    """By how much the cost changes with a trial, and what of that are new costs.

    Args:
        rows: lines of sight that the trial changes.
        signs: of all before it.
        scratch: of those that it changes.
        mark: its number.
        pairs: of all.
        looks: of the view.
    """
    one, other, drawn, weight, known = pairs.one, pairs.other, pairs.drawn, pairs.weight, pairs.cost
    begins, of, depth = pairs.first, pairs.of, pairs.depth
    every, sharp, first, front = signs.every, signs.sharp, signs.first, signs.front
    stamp, new_every, new_sharp = scratch.stamp, scratch.every, scratch.sharp
    new_first, new_front = scratch.first, scratch.front
    gain = broken = 0.0
    for i in rows:
        for at in range(begins[i], begins[i + 1]):
            p = of[at]
            j = other[p]
            is_other = j == i
            if is_other:
                j = one[p]
                if stamp[j] == mark:
                    # Counted with the other end.
                    continue
            changed = new_every[i], new_sharp[i], new_first[i], new_front[i]
            if stamp[j] == mark:
                adjacent = new_every[j], new_sharp[j], new_first[j], new_front[j]
            else:
                adjacent = every[j], sharp[j], first[j], front[j]
            if is_other:
                changed, adjacent = adjacent, changed
            more = _price(drawn[p], weight[p], depth[p], changed, adjacent, looks) - known[p]
            gain += more
            broken += max(0.0, more)
    return gain, broken


@njit(cache=True)
def _try(
    counts, depths, surfaces, rows, where, at, others, other_depths, other_surfaces,
    begin, end, low, high, operation, near, mark, signs, scratch, looks, made, names, changed,
):  # fmt: skip
    """Put the signs after an operation into scratch tables; how many lines of sight change.

    Args:
        counts, depths, surfaces: of the part.
        rows, where, at, others, other_depths, other_surfaces: of features, as of :class:`Table`.
        begin, end: which rows of these are the feature's.
        low, high: between which it lies.
        operation: that is tried.
        near: mm within which two crossings are one.
        mark: number of the trial.
        signs, scratch, looks: of the view.
        made, names: one row of depths and surfaces, for use.
        changed: filled with the lines of sight that change.
    """
    now, cut_at, roots = signs.every, looks.cut_at, looks.roots
    stamp, every, sharp = scratch.stamp, scratch.every, scratch.sharp
    first, front = scratch.first, scratch.front
    count = 0
    for q in range(begin, end):
        i, crossings = rows[q], 0
        if low < at[q] < high:
            if operation == _CUT and counts[i] == 0:
                continue
            crossings = _merge(
                counts, depths, surfaces, i,
                others, other_depths, other_surfaces, where[q],
                operation, near, made, names,
            )  # fmt: skip
        elif operation != _MEET:
            continue
        found = _sign(crossings, made, names, 0, cut_at[i], looks.looks_up, roots)
        if found[0] != now[i]:
            changed[count] = i
            count += 1
            stamp[i] = mark
            every[i], sharp[i], first[i], front[i] = found
    return count


@njit(cache=True)
def tried(state, table, operations, near, trial, looks):
    """By how much the cost changes with operations, what of that is new, and how many lines of
    sight change; nothing else is changed.

    Args:
        state: what is crossed, the signs, and the pairs.
        table: of the feature.
        operations: that are tried, as of :func:`combine`.
        near: mm within which two crossings are one.
        trial: scratch tables and the number of the trial.
        looks: of the view.
    """
    crossed, signs, pairs = state
    scratch, mark = trial
    made, names = np.zeros((1, MOST)), np.zeros((1, MOST), np.int64)
    count, changed = 0, np.empty(len(table.rows), np.int64)
    step = len(table.rows) if len(operations) == 1 else 1
    for begin in range(0, len(table.rows), max(1, step)):
        count += _try(
            crossed.counts, crossed.depth, crossed.surface, table.rows, table.where, table.at,
            table.counts, table.depth, table.surface, begin, begin + step, table.low, table.high,
            operations[0 if len(operations) == 1 else begin], near, mark, signs, scratch, looks,
            made, names, changed[count:],
        )  # fmt: skip
    if count == 0:
        return 0.0, 0.0, 0
    gain, broken = _changed(changed[:count], signs, scratch, mark, pairs, looks)
    return gain, broken, count


class Tables(NamedTuple):
    """What lines of sight of a view cross of many features.

    Attributes:
        begins: (t + 1,) where the rows of each table begin.
        rows, where, at: as of :class:`Table`, of one table after another.
        counts, depth, surface: the same.
        is_along: (t,) whether the view looks along the axis of what has a table.
    """

    begins: np.ndarray
    rows: np.ndarray
    where: np.ndarray
    at: np.ndarray
    counts: np.ndarray
    depth: np.ndarray
    surface: np.ndarray
    is_along: np.ndarray


class Offers(NamedTuple):
    """(n,) features: the number of their table, between which places along their axis they lie, and
    the surfaces there."""

    table: np.ndarray
    low: np.ndarray
    high: np.ndarray
    first: np.ndarray
    last: np.ndarray


@njit(cache=True)
def tried_all(state, offered, numbers, near, trial, looks):
    """What adding and cutting each of some features changes.

    Args:
        state: what is crossed, the signs, and the pairs.
        offered: tables, and features.
        numbers: (k,) of features.
        near: mm within which two crossings are one.
        trial: scratch tables and the number of the first trial.
        looks: of the view.

    Returns:
        (k, 2, 3) by how much the cost changes, what of that is new, and how many lines of sight
        change; and how many steps that took.
    """
    crossed, signs, pairs = state
    (tables, offers), (scratch, mark) = offered, trial
    counts, depths, surfaces = crossed.counts, crossed.depth, crossed.surface
    begins, rows, where, at = tables.begins, tables.rows, tables.where, tables.at
    others, other_depths, other_surfaces = tables.counts, tables.depth, tables.surface
    made, names = np.zeros((1, MOST)), np.zeros((1, MOST), np.int64)
    flat_counts, flat_depths = np.full(1, 2), np.empty((1, 2))
    flat_surfaces = np.empty((1, 2), np.int64)
    changed = np.empty(len(counts), np.int64)
    found, steps = np.zeros((len(numbers), 2, 3)), 0
    for k in range(len(numbers)):
        n = numbers[k]
        t = offers.table[n]
        begin, end = begins[t], begins[t + 1]
        is_along = tables.is_along[t]
        flat_depths[0, 0], flat_depths[0, 1] = offers.low[n], offers.high[n]
        flat_surfaces[0, 0], flat_surfaces[0, 1] = offers.first[n], offers.last[n]
        for operation in (_ADD, _CUT):
            mark += 1
            steps += end - begin
            if is_along:
                count = _try(
                    counts, depths, surfaces, rows, where, at,
                    flat_counts, flat_depths, flat_surfaces, begin, end, -1.0, 1.0,
                    operation, near, mark, signs, scratch, looks, made, names, changed,
                )  # fmt: skip
            else:
                count = _try(
                    counts, depths, surfaces, rows, where, at,
                    others, other_depths, other_surfaces, begin, end, offers.low[n], offers.high[n],
                    operation, near, mark, signs, scratch, looks, made, names, changed,
                )  # fmt: skip
            if count:
                gain = _changed(changed[:count], signs, scratch, mark, pairs, looks)
                found[k, operation, 0], found[k, operation, 1] = gain
                found[k, operation, 2] = count
                steps += PAIRS * count
    return found, steps
