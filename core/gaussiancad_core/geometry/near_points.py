"""Which points lie near each other, and what hangs together by pairs.

Points are sorted into cells as wide as the distance that is asked: a pair lies in one, or in two
that touch.
"""

from itertools import product

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]
Numbers = npt.NDArray[np.int64]

_ALL_AT_ONCE = 1 << 14
"""Pairs up to which all are looked at: cells take longer."""

_MANY = 5000
"""Points from which a tree is quicker, as long as it takes to load."""

_AXES, _CELLS = 3, 1 << 20
"""Coordinates that tell cells, and cells along each, at most: a cell's number has 64 bits."""


def near_pairs(points: Points, reach: float) -> Numbers:
    """(m, 2) numbers of (n, d) points at most so far apart, each pair once and in order."""
    if len(points) <= _MANY:
        pairs = pairs_between(points, points, reach)
        return pairs[pairs[:, 0] < pairs[:, 1]]
    from scipy.spatial import cKDTree

    one, other = cKDTree(points).query_pairs(reach, output_type="ndarray").T
    return np.stack(np.divmod(np.sort(one * len(points) + other), len(points)), axis=1)


def pairs_between(points: Points, others: Points, reach: float) -> Numbers:
    """(m, 2) numbers of (n, d) points and of others that are at most so far from them, in order."""
    if not len(points) or not len(others):
        return np.zeros((0, 2), dtype=np.int64)
    if len(points) * len(others) <= _ALL_AT_ONCE:
        all_pairs = np.indices((len(points), len(others))).reshape(2, -1)
        return _within(points, others, all_pairs, reach)
    first = min(points.shape[1], _AXES)
    low = np.minimum(points.min(axis=0), others.min(axis=0))[:first]
    spread = np.maximum(points.max(axis=0), others.max(axis=0))[:first] - low
    side = max(reach, float(spread.max()) / _CELLS, np.finfo(np.float64).tiny)
    cells, of_others = (
        np.floor((places[:, :first] - low) / side).astype(np.int64) for places in (points, others)
    )
    # One cell more at either side: what lies beyond the last is beside no other row's first.
    widths = np.floor(spread / side).astype(np.int64) + 3
    steps = np.append(np.cumprod(widths[:0:-1])[::-1], 1)
    keys, other_keys = cells @ steps, of_others @ steps
    order = np.argsort(other_keys, kind="stable")
    sorted_keys = other_keys[order]
    found = []
    for offset in product((-1, 0, 1), repeat=first - 1):
        row = keys + int(np.dot(offset, steps[:-1]))
        begins = np.searchsorted(sorted_keys, row - 1, "left")
        counts = np.searchsorted(sorted_keys, row + 1, "right") - begins
        one = np.repeat(np.arange(len(points)), counts)
        place = np.arange(len(one)) - np.repeat(np.cumsum(counts) - counts - begins, counts)
        found.append(_within(points, others, np.stack([one, order[place]]), reach))
    pairs = np.concatenate(found)
    return pairs[np.lexsort(pairs.T[::-1])]


def near_lists(points: Points, others: Points, reach: float) -> list[list[int]]:
    """For each of (n, d) points the numbers of the others that are at most so far from it."""
    pairs = pairs_between(points, others, reach)
    ends = np.cumsum(np.bincount(pairs[:, 0], minlength=len(points))).tolist()
    near = pairs[:, 1].tolist()
    return [near[begin:end] for begin, end in zip([0, *ends], ends, strict=False)]


def connected_groups(pairs: npt.NDArray[np.integer], count: int) -> Numbers:
    """(n,) number of the group of each of so many things, by (m, 2) pairs of these; groups are
    counted by their first members."""
    first = np.arange(count)
    one, other = np.asarray(pairs, dtype=np.int64).reshape(-1, 2).T
    while len(one):
        # Each group's first member goes with the first of those that it touches.
        ends = first[one], first[other]
        np.minimum.at(first, np.maximum(*ends), np.minimum(*ends))
        while not np.array_equal(onward := first[first], first):
            first = onward
        apart = first[one] != first[other]
        one, other = one[apart], other[apart]
    return np.unique(first, return_inverse=True)[1].reshape(-1)


def _within(points: Points, others: Points, pairs: Numbers, reach: float) -> Numbers:
    """(m, 2) those of (2, k) pairs that are at most so far apart."""
    one, other = pairs
    away = ((points[one] - others[other]) ** 2).sum(axis=1)
    return pairs[:, away <= reach * reach].T
