"""Coordinates that several views show of one axis, and the shifts that bring the views together.

A coordinate of the part (a plane, the side of a cylinder) is seen in two views or more, a little
different in each.  Clusters of neighbouring values stand for one coordinate each.  They are runs of
the sorted values, so no average ever changes the order of two coordinates.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]

_WIDEST_REACH = 10.0
"""Times the median disagreement of the views: matches beyond are chance."""

_ROBUST = 3.0
"""Times the median disagreement from which on a match counts less (Huber 1964)."""

_STEPS = 10
"""Steps at most, with the weights of the one before."""

_SETTLED = 1e-10
"""px by which the last step moves a view at most."""


@dataclass(frozen=True, eq=False)
class SeenCoordinates:
    """Coordinates on one axis as the views show them, each view with its own zero.

    Attributes:
        at: (n,) px.
        weight: (n,) one over the variance, of any unit.
        view: (n,) which view shows each.
    """

    at: Floats
    weight: Floats
    view: Ints


@dataclass(frozen=True)
class Limits:
    """How coordinates are told apart, in px.

    Attributes:
        apart: coordinates of one view are two from this distance on.
        reach: coordinates of two views are one up to this distance at most.
        finest: and always up to this distance.
        stretch: extents of two views may differ by this much before a view is stretched.
    """

    apart: float
    reach: float
    finest: float
    stretch: float = 1.5


@dataclass(frozen=True, eq=False)
class AxisFit:
    """The views on a common axis.

    Attributes:
        gain, shift: (views,) common px = gain x own px + shift.
        cluster: (n,) number of each coordinate's cluster, in the order of the axis.
        reach: px, the one that was used.
    """

    gain: Floats
    shift: Floats
    cluster: Ints
    reach: float

    def common(self, seen: SeenCoordinates) -> Floats:
        """(n,) the coordinates on the common axis."""
        return self.gain[seen.view] * seen.at + self.shift[seen.view]


def fit_axis(seen: SeenCoordinates, extents: Floats, limits: Limits) -> AxisFit:
    """Bring the views of an axis together by the coordinates that they share.

    Where the extents agree views are only shifted: a sheet has one scale.  Otherwise each is
    stretched too.

    Args:
        seen: coordinates, 0 at the lower end of each view's extent; both ends are among them.
        extents: (views,) px.
        limits: of matching.
    """
    stretched = bool(np.ptp(extents) > limits.stretch)
    mean = float(extents.mean())
    gain = mean / extents if stretched else np.ones(len(extents))
    shift = (mean - gain * extents) / 2.0
    fit = _matched(seen, AxisFit(gain, shift, np.zeros(len(seen.at), int), limits.reach), limits)
    if len(extents) > 1:
        for _ in range(2):
            fit = _moved(seen, fit, extents, stretched)
            narrow = _WIDEST_REACH * _disagreement(seen, fit)
            reach = float(np.clip(narrow, limits.finest, limits.reach))
            fit = _matched(seen, AxisFit(fit.gain, fit.shift, fit.cluster, reach), limits)
    return fit


def _matched(seen: SeenCoordinates, fit: AxisFit, limits: Limits) -> AxisFit:
    common = fit.common(seen)
    low = max(float(common[seen.view == v].min()) for v in np.unique(seen.view))
    high = min(float(common[seen.view == v].max()) for v in np.unique(seen.view))
    this_limits = Limits(limits.apart, fit.reach, limits.finest)
    cluster = clustered(SeenCoordinates(common, seen.weight, seen.view), this_limits, (low, high))
    return AxisFit(fit.gain, fit.shift, cluster, fit.reach)


def _shared(seen: SeenCoordinates, cluster: Ints) -> npt.NDArray[np.bool_]:
    """(n,) whether another view shows a coordinate too."""
    pairs = np.unique(np.stack([cluster, seen.view]), axis=1)
    views = np.bincount(pairs[0], minlength=int(cluster.max()) + 1)
    return views[cluster] > 1


def averages(values: Floats, weight: Floats, cluster: Ints) -> Floats:
    """(clusters,) weighted averages."""
    total = np.bincount(cluster, weights=weight)
    return np.bincount(cluster, weights=weight * values) / total


def _disagreement(seen: SeenCoordinates, fit: AxisFit) -> float:
    """Median distance in px of shared coordinates from their averages."""
    shared = _shared(seen, fit.cluster)
    if not shared.any():
        return 0.0
    common = fit.common(seen)
    away = common - averages(common, seen.weight, fit.cluster)[fit.cluster]
    return float(np.median(np.abs(away[shared])))


def _moved(seen: SeenCoordinates, fit: AxisFit, extents: Floats, stretched: bool) -> AxisFit:
    """Views fitted to each other by least squares, with the clusters as they are."""
    shared = _shared(seen, fit.cluster)
    if not shared.any():
        return fit
    views = len(extents)
    at, view = seen.at[shared], seen.view[shared]
    cluster = np.unique(fit.cluster[shared], return_inverse=True)[1]
    columns = np.zeros((len(at), 2 * views if stretched else views))
    columns[np.arange(len(at)), view] = 1.0
    if stretched:
        # In units of the extent, so that stretches and shifts are alike.
        columns[np.arange(len(at)), views + view] = at / extents[view]
    gain, shift = fit.gain.copy(), fit.shift.copy()
    limit = max(_ROBUST * _disagreement(seen, fit), 1e-9)
    for _ in range(_STEPS):
        common = gain[view] * at + shift[view]
        weight = seen.weight[shared]
        away = np.abs(common - averages(common, weight, cluster)[cluster])
        weight = weight * np.minimum(1.0, limit / np.maximum(away, limit))
        # What each average takes along is taken off: only differences of the views are left.
        means = [averages(column, weight, cluster)[cluster] for column in columns.T]
        root = np.sqrt(weight)[:, None]
        system = (columns - np.stack(means, axis=1)) * root
        right = (averages(common, weight, cluster)[cluster] - common) * root[:, 0]
        if stretched:
            # Stretched views would shrink to a point: the mean extent is what must stay.
            kept = np.concatenate([np.zeros(views), np.full(views, np.abs(system).sum())])
            system, right = np.vstack([system, kept]), np.append(right, 0.0)
        move = np.linalg.lstsq(system, right, rcond=None)[0]
        shift += move[:views]
        if stretched:
            gain += move[views:] / extents
        if np.abs(move).max() < _SETTLED:
            break
    return AxisFit(gain, shift, fit.cluster, fit.reach)


def clustered(
    seen: SeenCoordinates, limits: Limits, ends: tuple[float, float] = (-np.inf, np.inf)
) -> Ints:
    """(n,) number of the cluster of each coordinate, in the order of the axis.

    The nearest neighbours are united first.  Clusters that one view shows apart stay two.  Once no
    two can be united, each counts as its average, until nothing changes: a second clustering of the
    averages finds the same.

    Args:
        seen: coordinates on the common axis.
        limits: of matching.
        ends: what lies at or before the first is one coordinate, so is what lies at or behind the
            second.
    """
    order = np.argsort(seen.at, kind="stable")
    at, weight, view = seen.at[order], seen.weight[order], seen.view[order]
    starts = _first_starts(at, ends)
    while True:
        runs = _Runs(at, weight, view, starts, limits)
        runs.unite()
        number = np.zeros(len(at), int)
        number[runs.starts] = 1
        number = np.cumsum(number) - 1
        at = averages(at, weight, number)[number]
        if len(runs.starts) == len(starts):
            break
        starts = runs.starts
    labels = np.empty(len(at), int)
    labels[order] = number
    return labels


def _first_starts(at: Floats, ends: tuple[float, float]) -> Ints:
    """Where runs begin before anything is united: equal values are one."""
    new = np.ones(len(at), bool)
    new[1:] = np.diff(at) > 0.0
    low, high = ends
    new[1:] &= at[1:] > low
    new[1:] &= ~((at[:-1] >= high) & (at[1:] >= high))
    return np.flatnonzero(new)


class _Runs:
    """Runs of sorted coordinates while neighbours are united."""

    def __init__(
        self, at: Floats, weight: Floats, view: Ints, starts: Ints, limits: Limits
    ) -> None:
        self.starts = starts
        self._limits = limits
        count = int(view.max()) + 1
        number = np.zeros(len(at), int)
        number[starts] = 1
        number = np.cumsum(number) - 1
        shape = (len(starts), count)
        self._weight = np.zeros(shape)
        self._sum = np.zeros(shape)
        np.add.at(self._weight, (number, view), weight)
        np.add.at(self._sum, (number, view), weight * at)

    def unite(self) -> None:
        """Unite neighbours, the nearest first, until none may be."""
        weight, total = list(self._weight), list(self._sum)
        starts = [int(start) for start in self.starts]
        cost = [self._cost(weight, total, i) for i in range(len(starts) - 1)]
        while cost:
            best = int(np.argmin(cost))
            if not np.isfinite(cost[best]):
                break
            weight[best] = weight[best] + weight.pop(best + 1)
            total[best] = total[best] + total.pop(best + 1)
            del starts[best + 1], cost[best]
            for index in (best - 1, best):
                if 0 <= index < len(cost):
                    cost[index] = self._cost(weight, total, index)
        self.starts = np.array(starts)

    def _cost(self, weight: list[Floats], total: list[Floats], index: int) -> float:
        """Distance of a run from the next; infinite if they must stay two."""
        w0, w1, s0, s1 = (
            weight[index],
            weight[index + 1],
            total[index],
            total[index + 1],
        )
        gap = float(s1.sum() / w1.sum() - s0.sum() / w0.sum())
        if gap > self._limits.reach:
            return float("inf")
        both = (w0 > 0.0) & (w1 > 0.0)
        if both.any():
            apart = s1[both] / w1[both] - s0[both] / w0[both]
            if float(apart.max()) > self._limits.apart:
                return float("inf")
        return gap
