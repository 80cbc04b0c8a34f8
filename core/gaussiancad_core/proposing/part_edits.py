"""Edits of a planned part: all features that may be tried, and the best of them done.

A line tells a difference only: everything around a hole, cut off, draws nearly what the hole does,
and explains all holes at once.  So edits that break hardly anything of what they explain come
first, by how much they explain; only where none is left one that breaks more.  What they would
change is told by a part of the lines of sight; before an edit is done all of them are asked.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.proposing.feature_kernels import Offers, Operation, Tables
from gaussiancad_core.proposing.feature_tables import tables_of
from gaussiancad_core.proposing.lines_by_plane import Floats
from gaussiancad_core.proposing.part_features import Feature
from gaussiancad_core.proposing.plane_loops import Numbers
from gaussiancad_core.proposing.planned_part import PlannedJudge, PlannedPart

Price = Callable[[Operation, Feature], float]
"""mm that a feature costs, added or cut."""

_AT_ONCE = 400
"""Features that are tried before the best of them are taken."""

_HARDLY, _SOME = 0.04, 0.2
"""Shares of what an edit explains that it breaks, for it to break hardly anything, or some."""

_LAST = 2
"""The last tier of edits: what breaks more, or parts the part in pieces."""

_TIERS = (0, 1, _LAST)

_LATE = 4
"""Times so many features that are tried before an edit may break more."""


@dataclass(frozen=True, eq=False)
class Pool:
    """Features that may be tried.

    Attributes:
        features: of all kinds.
        tables: of these in each view of a judge.
        price: (n, 2) mm that each costs, added and cut; infinite of what is not done.
    """

    features: Sequence[Feature]
    tables: tuple[tuple[Tables, Offers], ...]
    price: Floats

    @classmethod
    def of(cls, features: Sequence[Feature], price: Price, judge: PlannedJudge) -> "Pool":
        """Features as a judge looks at them."""
        tables = tuple(tables_of(features, view.sights) for view in judge.views)
        both = Operation.ADD, Operation.CUT
        prices = [[price(operation, each) for operation in both] for each in features]
        return cls(features, tables, np.array(prices))


class Edits:
    """What edits of a part would change, as far as it was tried, before a rough judge.

    Args:
        part: that is edited.
        rough: the same part before that judge.
        pool: features to edit it with, as that judge looks at them.
        least: mm that an edit has to explain.
        until: work of both judges at which it ends.
    """

    def __init__(
        self, part: PlannedPart, rough: PlannedPart, pool: Pool, least: float, until: float
    ) -> None:
        self._part, self._rough, self._pool = part, rough, pool
        self._least, self._until = least, until
        views = len(part.judge.views)
        self._known = np.zeros((len(pool.features), 2, views, 3))
        self._stale = np.ones((len(pool.features), views), bool)
        self._parting = np.zeros((len(pool.features), 2), bool)

    @property
    def is_over(self) -> bool:
        """Whether the work is done."""
        return self._part.judge.work + self._rough.judge.work > self._until

    def forget(self, stale: np.ndarray) -> None:
        """Try again, where it is asked for, what (n, views) says."""
        self._stale |= stale
        self._parting[stale.any(axis=1)] = False

    def some_done(self, order: Numbers) -> int:
        """Do the best edits of some features, in the order in which these are tried; how many."""
        for at in range(0, len(order), _AT_ONCE):
            self._try(order[at : at + _AT_ONCE])
            tiers = (0,) if at < _LATE * _AT_ONCE else _TIERS
            done = self._take(order[: at + _AT_ONCE], tiers)
            if done or self.is_over:
                return done
        return self._take(order, _TIERS)

    def _try(self, numbers: Numbers) -> None:
        for view, offered in enumerate(self._pool.tables):
            asked = numbers[self._stale[numbers, view]]
            if len(asked):
                self._known[asked, :, view] = self._rough.gains_in(view, offered, asked)
                self._stale[asked, view] = False

    def _take(self, rows: Numbers, tiers: Sequence[int]) -> int:
        """Do the best edits of these tiers: all that break hardly anything, or one that does."""
        gain, broken, changed = (self._known[rows][..., k].sum(axis=2) for k in range(3))
        fine = (changed > 0.0) & (gain < -self._least) & np.isfinite(self._pool.price[rows])
        fine &= ~np.any(self._stale[rows], axis=1, keepdims=True)
        found = [
            (
                _LAST if self._parting[rows[i], k] else _tier(gain[i, k], broken[i, k]),
                gain[i, k] + self._pool.price[rows[i], k],
                int(rows[i]),
                int(k),
            )
            for i, k in np.argwhere(fine)
        ]
        done = 0
        for tier, promised, number, operation in sorted(found):
            if tier not in tiers or (tier and done) or (self.is_over and done):
                break
            if self._still(number, Operation(operation), promised, tier):
                for part in (self._part, self._rough):
                    part.do(Operation(operation), self._pool.features[number])
                done += 1
        return done

    def _still(self, number: int, operation: Operation, promised: float, tier: int) -> bool:
        """Whether an edit explains as much before the whole judge, and after others were done."""
        feature = self._pool.features[number]
        for view in range(len(self._part.judge.views)):
            gain = self._part.gain_in(view, operation, feature)
            self._known[number, operation, view] = gain.mm, gain.broken, gain.changed
        mm, broken, changed = self._known[number, operation].sum(axis=0)
        if not changed or mm > -self._least:
            return False
        worth = mm + self._pool.price[number, operation] <= 0.5 * promised
        if not worth or _tier(mm, broken) > tier:
            return False
        if tier == _LAST:
            return True
        habits, features = self._part.judge.habits, self._part.features
        after = habits.of_pieces([*features, (operation, feature)])
        self._parting[number, operation] = after > habits.of_pieces(features)
        return not self._parting[number, operation]


def _tier(gain: float, broken: float) -> int:
    """How much an edit breaks of what it explains: 0 for hardly anything."""
    share = broken / (broken - gain)
    if share < _HARDLY:
        return 0
    return 1 if share < _SOME else _LAST
