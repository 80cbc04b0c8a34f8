"""A part that is only planned, before the judge: what every line of sight crosses of its features.

The pairs of lines of sight are the judge's (:mod:`gaussiancad_core.judging.sight_pairs`), and so
are the prices of what differs between them.  One more is asked of a part that is put together:
outside of a closed outline there is nothing.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.opened_views import cut_depths
from gaussiancad_core.judging.sight_pairs import Drawn, SightPairs, sight_pairs
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE, plane_points
from gaussiancad_core.proposing.feature_kernels import (
    Looks,
    Operation,
    Pairs,
    Scratch,
    Signs,
    Table,
    combine,
    price,
    sign,
    tried,
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
from gaussiancad_core.proposing.plane_loops import Numbers, PlaneLoops

RASTER = 48
"""Squares along a view by which places of differences are told."""

_NEAR = 1e-6
"""Share of the longest extent within which two crossings are one."""

_PAIRS = 4
"""Pairs that a line of sight has, about."""

_BEYOND = 0.5
"""What a mm counts beyond a closed outline, beside a stroke, of what it counts there."""


@dataclass(frozen=True, eq=False)
class PlannedView:
    """A view before which parts are planned.

    Attributes:
        sights: its lines of sight.
        one, other, drawn, weight: of its pairs, as of :class:`SightPairs`.
        cut_at: (n,) mm along its axis at which each line of sight is cut open; NaN where it is not.
        looks_up: whether it sees the least coordinate along its axis first.
        draws_hidden: whether what is hidden is drawn.
        draws_tangents: whether lines where faces meet smoothly are.
        squares: (n,) of the raster that lines of sight lie in.
        pair_squares: (p,) the same of the pairs.
    """

    sights: Sights
    one: Numbers
    other: Numbers
    drawn: Numbers
    weight: Floats
    cut_at: Floats
    looks_up: bool
    draws_hidden: bool
    draws_tangents: bool
    squares: Numbers
    pair_squares: Numbers


class PlannedJudge:
    """The pairs of a sheet for parts that are put together of its surfaces.

    Args:
        views: that the sheet was made of.
        sheet: its strokes by plane.
        planes: what these enclose.
    """

    def __init__(self, views: DrawnViews, sheet: PlaneSheet, planes: Iterable[PlaneLoops]) -> None:
        self.sheet = sheet
        self.near = _NEAR * sheet.longest
        closed = {plane.axis: plane.outline for plane in planes if plane.is_closed}
        self.views = tuple(_planned_views(views, sheet, closed))
        self.length = sheet.length
        self.trials = 0
        self.work = 0
        """Steps of the kernels so far: what a search is limited by, the same on every machine."""
        self.roots = sheet.surfaces.roots()
        self._scratch = tuple(_scratch(len(view.sights.places)) for view in self.views)
        self.pairs_of = tuple(map(_pairs_of, self.views))
        """Of each view, where the pairs of each line of sight are, as of :class:`Pairs`."""

    def refresh(self) -> None:
        """Take up what surfaces were added and joined since."""
        self.roots = self.sheet.surfaces.roots()

    def looks(self, number: int) -> Looks:
        """How a view looks."""
        view = self.views[number]
        shown = view.looks_up, view.draws_hidden, view.draws_tangents
        return Looks(self.roots, view.cut_at, *shown)

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
    """

    def __init__(self, judge: PlannedJudge) -> None:
        self.judge = judge
        self.features: list[tuple[Operation, Feature]] = []
        counts = [len(view.sights.places) for view in judge.views]
        self._crossed = [nothing_crossed(count) for count in counts]
        self._signs = [Signs(*(np.zeros(count, np.int64) for _ in range(3))) for count in counts]
        self._pairs = [
            Pairs(
                view.one, view.other, view.drawn, view.weight, np.zeros(len(view.one)), *beginnings
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
        made._crossed = [type(each)(*(table.copy() for table in each)) for each in self._crossed]
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
        for view, crossed in zip(self.judge.views, self._crossed, strict=True):
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
        state = self._crossed[number], self._signs[number], self._pairs[number]
        table = feature.table(self.judge.views[number].sights)
        trial, looks = self.judge.trial(number), self.judge.looks(number)
        operations = np.array([int(operation)])
        gain = Gain(*tried(state, table, operations, self.judge.near, trial, looks))
        self.judge.work += len(table.rows) + _PAIRS * gain.changed
        return gain

    def slab_gain(self, prism: Prism) -> float:
        """mm of misfit that change where the part becomes a prism between its places."""
        total = 0.0
        for number, view in enumerate(self.judge.views):
            table, operations = _slab_table(prism, view.sights)
            state = self._crossed[number], self._signs[number], self._pairs[number]
            trial, looks = self.judge.trial(number), self.judge.looks(number)
            gain, _, changed = tried(state, table, operations, self.judge.near, trial, looks)
            total += gain
            self.judge.work += len(table.rows) + _PAIRS * changed
        return total

    def set_slab(self, prism: Prism) -> "PlannedPart":
        """Become a prism between its places; the same part, without a word in its features."""
        for view, crossed in zip(self.judge.views, self._crossed, strict=True):
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
            sign(self._crossed[number], looks, signs)
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


def _planned_views(
    views: DrawnViews, sheet: PlaneSheet, closed: Mapping[Axis, shapely.Polygon]
) -> Iterator[PlannedView]:
    drawn = drawn_sheet(views)
    by_role = {view.role: view for view in drawn.views}
    for number, plane_view in enumerate(sheet.views):
        axis, view = plane_view.axis, by_role[plane_view.role]
        pairs = sight_pairs(drawn, view)
        places, at = (
            plane_points(points, plane_view.role, 1.0) for points in (pairs.places, pairs.at)
        )
        size = sheet.size[list(IN_PLANE[axis])]
        made = PlannedView(
            Sights(number, axis, np.ascontiguousarray(places)),
            pairs.one,
            pairs.other,
            pairs.drawn,
            pairs.weight,
            plane_view.role.frame.look_axis[1] * cut_depths(view, pairs.places),
            plane_view.looks_up,
            view.draws_hidden,
            view.draws_tangents,
            squares_of(places, size),
            squares_of(at, size),
        )
        if axis in closed:
            made = _with_nothing_beyond(made, pairs, closed[axis], (drawn.aside, size))
        yield made


def _with_nothing_beyond(
    view: PlannedView,
    pairs: SightPairs,
    outline: shapely.Polygon,
    scale: tuple[float, Floats],
) -> PlannedView:
    """A view with pairs of what lies beyond its outline and a line of sight far from any part."""
    aside, size = scale
    places = view.sights.places
    beyond = np.flatnonzero(~shapely.contains_xy(outline.buffer(aside / 2.0), *places.T))
    weights = np.full(len(places), float(np.median(pairs.cells)) if len(pairs.cells) else 1.0)
    at_strokes = pairs.drawn != Drawn.NOTHING
    for ends in (pairs.one, pairs.other):
        weights[ends[at_strokes]] = _BEYOND * pairs.weight[at_strokes]
    far = np.array([[-size.max(), -size.max()]])
    count = len(beyond)
    return replace(
        view,
        sights=replace(view.sights, places=np.ascontiguousarray(np.vstack([places, far]))),
        one=np.concatenate([view.one, beyond]),
        other=np.concatenate([view.other, np.full(count, len(places))]),
        drawn=np.concatenate([view.drawn, np.zeros(count, view.drawn.dtype)]),
        weight=np.concatenate([view.weight, weights[beyond]]),
        cut_at=np.append(view.cut_at, np.nan),
        squares=np.append(view.squares, 0),
        pair_squares=np.concatenate([view.pair_squares, squares_of(places[beyond], size)]),
    )


def squares_of(places: Floats, size: Floats) -> Numbers:
    """(n,) numbers of the squares of a view's raster that places (n, 2) lie in."""
    cells = np.clip((places / size * RASTER).astype(np.int64), 0, RASTER - 1)
    return cells[:, 0] * RASTER + cells[:, 1]


def _pairs_of(view: PlannedView) -> tuple[Numbers, Numbers]:
    ends = np.concatenate([view.one, view.other])
    order = np.argsort(ends, kind="stable")
    count = len(view.sights.places)
    first = np.searchsorted(ends[order], np.arange(count + 1)).astype(np.int64)
    return first, order.astype(np.int64) % max(1, len(view.one))


def _scratch(count: int) -> Scratch:
    return Scratch(*(np.zeros(count, np.int64) for _ in range(4)))


def sums_of(values: Floats) -> Floats:
    """(RASTER + 1, RASTER + 1) sums of a raster's values up to each corner."""
    sums = np.zeros((RASTER + 1, RASTER + 1))
    sums[1:, 1:] = values.reshape(RASTER, RASTER).cumsum(axis=0).cumsum(axis=1)
    return sums


def within_boxes(sums: Floats, boxes: Floats, size: Floats, margin: float) -> Floats:
    """(n,) sums of a raster over boxes (n, 2, 2) mm, so many squares wider."""
    low = np.clip(np.floor(boxes[:, 0] / size * RASTER - margin).astype(np.int64), 0, RASTER)
    high = np.clip(np.ceil(boxes[:, 1] / size * RASTER + margin).astype(np.int64), 0, RASTER)
    return (
        sums[high[:, 0], high[:, 1]]
        - sums[low[:, 0], high[:, 1]]
        - sums[high[:, 0], low[:, 1]]
        + sums[low[:, 0], low[:, 1]]
    )
