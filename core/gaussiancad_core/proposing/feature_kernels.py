"""Compiled loops over lines of sight through planned features: where they enter and leave, what
adding or cutting changes, and what that costs.

Tables have a row for each line of sight: how many surfaces it crosses, their depths from the least
coordinate along the axis on, and their numbers.
"""

from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numba import njit

from gaussiancad_core.judging.difference_kinds import PRICES, Kind
from gaussiancad_core.judging.sight_pairs import Drawn

MOST = 24
"""Crossings of a line of sight with a part at most."""

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
        counts, depth, surface: as of :class:`Crossed`; of a feature along whose axis the view looks
            all are one, and these are not looked at.
        at: (k,) mm along the feature's axis, of lines of sight across it.
        low, high: mm along its axis, of the feature.
        first, last: surfaces there.
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
    first: int
    last: int
    is_along: bool


class Signs(NamedTuple):
    """(n,) what lines of sight are compared by, as of :class:`.lines_of_sight.Seen`."""

    every: np.ndarray
    sharp: np.ndarray
    first: np.ndarray


class Pairs(NamedTuple):
    """Pairs of lines of sight: (p,) numbers of both, what is drawn between them, mm, and what they
    cost now."""

    one: np.ndarray
    other: np.ndarray
    drawn: np.ndarray
    weight: np.ndarray
    cost: np.ndarray


class Scratch(NamedTuple):
    """Where a trial keeps its signs: (n,) which trial changed a line of sight last, and how."""

    stamp: np.ndarray
    every: np.ndarray
    sharp: np.ndarray
    first: np.ndarray


class Looks(NamedTuple):
    """How a view looks: (s,) of each surface the first that it passes into smoothly, (n,) mm along
    the axis at which each line of sight is cut open, NaN where it is not, whether it sees the least
    coordinate first, and whether it draws what is hidden and what is smooth."""

    roots: np.ndarray
    cut_at: np.ndarray
    looks_up: bool
    draws_hidden: bool
    draws_tangents: bool


@njit(cache=True)
def inside(edges, x, y):  # noqa: ANN001, ANN201
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
def across(edges, surfaces, fixed, along):  # noqa: ANN001, ANN201
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
def across_turned(edges, surfaces, height, off_axis):  # noqa: ANN001, ANN201
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


@njit(cache=True)
def _merge(one, other, operation, near, made):  # noqa: ANN001, ANN202
    """Put what a line of sight crosses of two bodies under an operation into a table; how many.

    Args:
        one, other: count, depths and surfaces of each.
        operation: of the other on the one.
        near: mm within which two crossings are one.
        made: depths and surfaces, filled in.
    """
    first_count, first_depth, first_surface = one
    second_count, second_depth, second_surface = other
    depth, surface = made
    if operation == _SET:
        for q in range(second_count):
            depth[q], surface[q] = second_depth[q], second_surface[q]
        return second_count
    i = j = k = 0
    in_one = in_other = was_in = False
    while i < first_count or j < second_count:
        if i < first_count and (j >= second_count or first_depth[i] <= second_depth[j]):
            place, number = first_depth[i], first_surface[i]
        else:
            place, number = second_depth[j], second_surface[j]
        while i < first_count and first_depth[i] <= place + near:
            in_one = not in_one
            i += 1
        while j < second_count and second_depth[j] <= place + near:
            in_other = not in_other
            j += 1
        if operation == _ADD:
            is_in = in_one or in_other
        elif operation == _CUT:
            is_in = in_one and not in_other
        else:
            is_in = in_one and in_other
        if is_in != was_in:
            if k < MOST:
                depth[k], surface[k] = place, number
                k += 1
            was_in = is_in
    return k


@njit(cache=True)
def _sign(count, depth, surface, cut_at, looks):  # noqa: ANN001, ANN202
    """What a line of sight is compared by.

    Args:
        count: of its crossings.
        depth, surface: of them.
        cut_at: mm along the axis where it is cut open; NaN where it is not.
        looks: of the view.
    """
    start, end, is_cut = 0, count, False
    if not np.isnan(cut_at):
        if looks.looks_up:
            while start < count and depth[start] < cut_at:
                start += 1
            is_cut = start % 2 == 1
        else:
            while end > 0 and depth[end - 1] > cut_at:
                end -= 1
            is_cut = end % 2 == 1
    every = sharp = 1469598103934665603
    for q in range(start, end):
        every = (every * 1099511628211) ^ (surface[q] + 7)
        sharp = (sharp * 1099511628211) ^ (looks.roots[surface[q]] + 7)
    first = -1
    if is_cut:
        # The cut is a surface of its own.
        first = len(looks.roots)
        every = (every * 1099511628211) ^ (first + 7)
        sharp = (sharp * 1099511628211) ^ (first + 7)
    elif end > start:
        first = looks.roots[surface[start if looks.looks_up else end - 1]]
    return every, sharp, first


@njit(cache=True)
def _combined(crossed, i, table, q, operation, near, made, flat):  # noqa: ANN001, ANN202, PLR0917
    """What a line of sight crosses after an operation; -1 where it is untouched."""
    part = crossed.counts[i], crossed.depth[i], crossed.surface[i]
    if table.is_along:
        depth, surface = flat
        return _merge(part, (2, depth, surface), operation, near, made)
    if table.low < table.at[q] < table.high:
        w = table.where[q]
        feature = table.counts[w], table.depth[w], table.surface[w]
        return _merge(part, feature, operation, near, made)
    return 0 if operation == _MEET else -1


@njit(cache=True)
def combine(crossed, table, operations, near) -> None:  # noqa: ANN001
    """Do operations for the lines of sight of a table, in place.

    Args:
        crossed: of the part, changed.
        table: of the feature.
        operations: one for all lines of sight, or (k,) one for each row.
        near: mm within which two crossings are one.
    """
    made = np.zeros(MOST), np.zeros(MOST, np.int64)
    flat = np.array([table.low, table.high]), np.array([table.first, table.last])
    for q in range(len(table.rows)):
        i = table.rows[q]
        operation = operations[q if len(operations) > 1 else 0]
        count = _combined(crossed, i, table, q, operation, near, made, flat)
        if count >= 0:
            crossed.counts[i] = count
            for k in range(count):
                crossed.depth[i, k], crossed.surface[i, k] = made[0][k], made[1][k]


@njit(cache=True)
def sign(crossed, looks, signs) -> None:  # noqa: ANN001
    """Put what all lines of sight are compared by into a table."""
    for i in range(len(crossed.counts)):
        count = crossed.counts[i]
        found = _sign(count, crossed.depth[i], crossed.surface[i], looks.cut_at[i], looks)
        signs.every[i], signs.sharp[i], signs.first[i] = found


@njit(cache=True)
def _price(drawn, weight, one, other, looks):  # noqa: ANN001, ANN202
    """What a pair costs: as of :func:`.difference_kinds.kinds_between`."""
    if one[1] == other[1]:
        share = _price_alike(drawn, one[0] != other[0], looks.draws_tangents)
    else:
        share = _price_apart(drawn, one[2] != other[2], looks.draws_hidden)
    return share * weight


@njit(cache=True)
def _price_alike(drawn, is_smooth, draws_tangents):  # noqa: ANN001, ANN202
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
def _price_apart(drawn, is_shown, draws_hidden):  # noqa: ANN001, ANN202
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
def price(pairs, signs, looks):  # noqa: ANN001, ANN201
    """What all pairs cost, and put it into their table."""
    total = 0.0
    for p in range(len(pairs.one)):
        i, j = pairs.one[p], pairs.other[p]
        one = signs.every[i], signs.sharp[i], signs.first[i]
        other = signs.every[j], signs.sharp[j], signs.first[j]
        pairs.cost[p] = _price(pairs.drawn[p], pairs.weight[p], one, other, looks)
        total += pairs.cost[p]
    return total


@njit(cache=True)
def _changed(signs, scratch, mark, pairs, looks):  # noqa: ANN001, ANN202
    """By how much the cost changes with a trial, and what of that are new costs."""
    gain = broken = 0.0
    for p in range(len(pairs.one)):
        i, j = pairs.one[p], pairs.other[p]
        is_one, is_other = scratch.stamp[i] == mark, scratch.stamp[j] == mark
        if is_one or is_other:
            one = signs.every[i], signs.sharp[i], signs.first[i]
            other = signs.every[j], signs.sharp[j], signs.first[j]
            if is_one:
                one = scratch.every[i], scratch.sharp[i], scratch.first[i]
            if is_other:
                other = scratch.every[j], scratch.sharp[j], scratch.first[j]
            cost = _price(pairs.drawn[p], pairs.weight[p], one, other, looks)
            gain += cost - pairs.cost[p]
            if cost > pairs.cost[p]:
                broken += cost - pairs.cost[p]
    return gain, broken


@njit(cache=True)
def tried(state, table, operations, near, trial, looks):  # noqa: ANN001, ANN201, PLR0917
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
    made = np.zeros(MOST), np.zeros(MOST, np.int64)
    flat = np.array([table.low, table.high]), np.array([table.first, table.last])
    count = 0
    for q in range(len(table.rows)):
        i = table.rows[q]
        operation = operations[q if len(operations) > 1 else 0]
        crossings = _combined(crossed, i, table, q, operation, near, made, flat)
        if crossings < 0:
            continue
        every, sharp, first = _sign(crossings, made[0], made[1], looks.cut_at[i], looks)
        if every != signs.every[i]:
            count += 1
            scratch.stamp[i] = mark
            scratch.every[i], scratch.sharp[i], scratch.first[i] = every, sharp, first
    if count == 0:
        return 0.0, 0.0, 0
    gain, broken = _changed(signs, scratch, mark, pairs, looks)
    return gain, broken, count
