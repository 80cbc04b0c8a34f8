"""A part that is only planned, before the judge: what every line of sight crosses of its features.

The prices of what differs between two lines of sight are the judge's
(:mod:`gaussiancad_core.judging.difference_kinds`).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.proposing.feature_kernels import (
    PAIRS,
    Looks,
    Offers,
    Operation,
    Pairs,
    Scratch,
    Signs,
    Table,
    Tables,
    combine,
    price,
    sign,
    tried,
    tried_all,
)
from gaussiancad_core.proposing.lines_by_plane import Floats, PlaneSheet
from gaussiancad_core.proposing.part_features import (
    Feature,
    Prism,
    Sights,
    between,
    every_sight,
    nothing_crossed,
)
from gaussiancad_core.proposing.part_habits import Habits
from gaussiancad_core.proposing.plane_loops import Numbers
from gaussiancad_core.proposing.planned_views import RASTER, PlannedView, thinned

_NEAR = 1e-6
"""Share of the longest extent within which two crossings are one."""

_AS_NOTED = 3.0
"""Tolerances within which a hole is as deep as a note says."""


class PlannedJudge:
    """The pairs of a sheet for parts that are put together of its surfaces.

    Args:
        sheet: its strokes by plane.
        views: of it.
    """

    def __init__(self, sheet: PlaneSheet, views: Sequence[PlannedView]) -> None:
        self.sheet = sheet
        self.near = _NEAR * sheet.longest
        self.views = tuple(views)
        self.length = sheet.length
        self.habits = Habits(sheet, self.near)
        self.trials = 0
        self.work = 0
        """Steps of the kernels so far: what a search is limited by, the same on every machine."""
        self.roots = sheet.surfaces.roots()
        self._scratch = tuple(_scratch(len(view.sights.places)) for view in self.views)
        self.pairs_of = tuple(map(_pairs_of, self.views))
        """Of each view, where the pairs of each line of sight are, as of :class:`Pairs`."""

    def rough(self, every: int) -> "PlannedJudge":
        """Another one, with one of so many pairs."""
        return PlannedJudge(self.sheet, thinned(self.views, every))

    def refresh(self) -> None:
        """Take up what surfaces were added and joined since."""
        self.roots = self.sheet.surfaces.roots()

    def looks(self, number: int) -> Looks:
        """How a view looks."""
        view = self.views[number]
        shown = view.looks_up, view.draws_hidden, view.draws_tangents
        return Looks(self.roots, view.cut_at, *shown, _AS_NOTED * self.sheet.tolerance)

    def trial(self, number: int) -> tuple[Scratch, int]:
        """Tables for a trial in a view, and its number."""
        self.trials += 1
        return self._scratch[number], self.trials


@dataclass(frozen=True)
class Gain:
    """What an edit changes.

    Attributes:
        mm: of the misfit: less than zero where it explains more.
        broken: mm of new misfit in that.
        changed: lines of sight that it changes.
    """

    mm: float
    broken: float
    changed: int


class PlannedPart:
    """Features in order, and what every line of sight crosses of them.

    Args:
        judge: before which it is planned.

    Attributes:
        features: in order.
        crossed: of each view.
        cost: mm of line that it leaves unexplained.
        touched: squares of each view's raster in which it changed.
    """

    def __init__(self, judge: PlannedJudge) -> None:
        self.judge = judge
        self.features: list[tuple[Operation, Feature]] = []
        counts = [len(view.sights.places) for view in judge.views]
        self.crossed = [nothing_crossed(count) for count in counts]
        self._signs = [_no_signs(count) for count in counts]
        self._pairs = [
            Pairs(
                view.one,
                view.other,
                view.drawn,
                view.weight,
                view.depth,
                np.zeros(len(view.one)),
                *beginnings,
            )
            for view, beginnings in zip(judge.views, judge.pairs_of, strict=True)
        ]
        self.touched = [np.ones(RASTER * RASTER, bool) for _ in judge.views]
        self.cost = 0.0
        self._sign()

    def copy(self) -> "PlannedPart":
        """Another one that is the same so far."""
        return self.followed_by(())

    def followed_by(self, features: Iterable[tuple[Operation, Feature]]) -> "PlannedPart":
        """Another one that has more features after those of this one."""
        made = PlannedPart(self.judge)
        made.features = list(self.features)
        made.crossed = [type(each)(*(table.copy() for table in each)) for each in self.crossed]
        for operation, feature in features:
            made._combine(operation, feature)
        made._sign()
        return made

    @property
    def share(self) -> float:
        """The misfit as a share of the lines."""
        return self.cost / self.judge.length if self.judge.length else 1.0

    def do(self, operation: Operation, feature: Feature) -> "PlannedPart":
        """Add a feature, cut it, or meet with it; the same part."""
        self._combine(operation, feature)
        self._sign()
        return self

    def _combine(self, operation: Operation, feature: Feature) -> None:
        for view, crossed in zip(self.judge.views, self.crossed, strict=True):
            table = feature.table(view.sights)
            if operation is Operation.MEET:
                rest = np.ones(len(crossed.counts), bool)
                rest[table.rows] = False
                crossed.counts[rest] = 0
            combine(crossed, table, np.array([int(operation)]), self.judge.near)
            self.judge.work += len(table.rows)
        self.features.append((operation, feature))

    def gain(self, operation: Operation, feature: Feature) -> Gain:
        """What an edit would change."""
        found = [
            self.gain_in(number, operation, feature) for number in range(len(self.judge.views))
        ]
        return Gain(
            sum(each.mm for each in found),
            sum(each.broken for each in found),
            sum(each.changed for each in found),
        )

    def gain_in(self, number: int, operation: Operation, feature: Feature) -> Gain:
        """The same in one view."""
        state = self.crossed[number], self._signs[number], self._pairs[number]
        table = feature.table(self.judge.views[number].sights)
        trial, looks = self.judge.trial(number), self.judge.looks(number)
        operations = np.array([int(operation)])
        gain = Gain(*tried(state, table, operations, self.judge.near, trial, looks))
        self.judge.work += len(table.rows) + PAIRS * gain.changed
        return gain

    def gains_in(self, number: int, offered: tuple[Tables, Offers], numbers: Numbers) -> Floats:
        """(k, 2, 3) what adding and cutting each of some features would change in a view.

        Args:
            number: of the view.
            offered: the tables of all features in it.
            numbers: (k,) of features.
        """
        state = self.crossed[number], self._signs[number], self._pairs[number]
        scratch, mark = self.judge.trial(number)
        self.judge.trials += 2 * len(numbers)
        looks = self.judge.looks(number)
        found, steps = tried_all(state, offered, numbers, self.judge.near, (scratch, mark), looks)
        self.judge.work += steps
        return np.asarray(found)

    def slab_gain(self, prism: Prism) -> float:
        """mm of misfit that change where the part becomes a prism between its places."""
        total = 0.0
        for number, view in enumerate(self.judge.views):
            table, operations = _slab_table(prism, view.sights)
            state = self.crossed[number], self._signs[number], self._pairs[number]
            trial, looks = self.judge.trial(number), self.judge.looks(number)
            gain, _, changed = tried(state, table, operations, self.judge.near, trial, looks)
            total += gain
            self.judge.work += len(table.rows) + PAIRS * changed
        return total

    def set_slab(self, prism: Prism) -> "PlannedPart":
        """Become a prism between its places; the same part, without a word in its features."""
        for view, crossed in zip(self.judge.views, self.crossed, strict=True):
            table, operations = _slab_table(prism, view.sights)
            combine(crossed, table, operations, self.judge.near)
        self._sign()
        return self

    def misfits(self, number: int) -> Floats:
        """(RASTER^2,) mm of misfit in each square of a view."""
        squares = self.judge.views[number].pair_squares
        costs = self._pairs[number].cost
        return np.bincount(squares, costs, RASTER * RASTER).astype(np.float64)

    def _sign(self) -> None:
        self.cost = 0.0
        for number, view in enumerate(self.judge.views):
            signs = self._signs[number]
            before = signs.every.copy()
            looks = self.judge.looks(number)
            sign(self.crossed[number], looks, signs)
            self.cost += price(self._pairs[number], signs, looks)
            self.judge.work += len(view.squares) + len(self._pairs[number].one)
            self.touched[number][view.squares[before != signs.every]] = True


def _slab_table(prism: Prism, sights: Sights) -> tuple[Table, Numbers]:
    """A prism's table with a row for each line of sight, and what is done along each for the part
    to be the prism between its places."""
    key = ("every", sights.number)
    found = prism.loop.tables.get(key)
    if found is None:
        table, is_inside = every_sight(prism.loop, sights)
        along = np.where(is_inside, int(Operation.ADD), int(Operation.CUT))
        operations = along if table.is_along else np.array([int(Operation.SET)])
        found = prism.loop.tables[key] = table, operations
    table, operations = found
    return between(table, prism), operations


def _pairs_of(view: PlannedView) -> tuple[Numbers, Numbers]:
    ends = np.concatenate([view.one, view.other])
    order = np.argsort(ends, kind="stable")
    count = len(view.sights.places)
    first = np.searchsorted(ends[order], np.arange(count + 1)).astype(np.int64)
    return first, order.astype(np.int64) % max(1, len(view.one))


def _no_signs(count: int) -> Signs:
    every, sharp, first = np.zeros((3, count), np.int64)
    return Signs(every, sharp, first, np.zeros(count))


def _scratch(count: int) -> Scratch:
    return Scratch(np.zeros(count, np.int64), *_no_signs(count))
