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
    NOTED,
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
from gaussiancad_core.proposing.lines_by_plane import Floats, PlaneHole, PlaneSheet
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

_NOTE, _WAYS, _BESIDE = 2.0, 6, 1.2
"""What a hole costs that is not as a note says, in the root of its area; ways in which it is looked
at around its axis, and radii from that at which what is beside it is."""

_AS_NOTED = 3.0
"""Tolerances within which a hole is as deep as a note says."""

_BEYOND = 0.5
"""What a mm counts beyond a closed outline, beside a stroke, of what it counts there."""


@dataclass(frozen=True, eq=False)
class PlannedView:
    """A view before which parts are planned.

    Attributes:
        sights: its lines of sight.
        one, other, drawn, weight: of its pairs, as of :class:`SightPairs`, or :data:`.NOTED`.
        depth: (p,) mm that a note tells of a pair, as of :class:`.Pairs`; 0 of others.
        cut_at: (n,) mm along its axis at which each line of sight is cut open; NaN where it is not.
        looks_up: whether it sees the least coordinate along its axis first.
        draws_hidden: whether what is hidden is drawn.
        draws_tangents: whether lines where faces meet smoothly are.
        raster: number of its first line of sight that lies between places, not beside a stroke.
        cells: (r, c) mm^2 that each of these stands for, from there on row by row.
        squares: (n,) of the raster that lines of sight lie in.
        pair_squares: (p,) the same of the pairs.
    """

    sights: Sights
    one: Numbers
    other: Numbers
    drawn: Numbers
    weight: Floats
    depth: Floats
    cut_at: Floats
    looks_up: bool
    draws_hidden: bool
    draws_tangents: bool
    raster: int
    cells: Floats
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
        self.judge.work += len(table.rows) + _PAIRS * gain.changed
        return gain

    def slab_gain(self, prism: Prism) -> float:
        """mm of misfit that change where the part becomes a prism between its places."""
        total = 0.0
        for number, view in enumerate(self.judge.views):
            table, operations = _slab_table(prism, view.sights)
            state = self.crossed[number], self._signs[number], self._pairs[number]
            trial, looks = self.judge.trial(number), self.judge.looks(number)
            gain, _, changed = tried(state, table, operations, self.judge.near, trial, looks)
            total += gain
            self.judge.work += len(table.rows) + _PAIRS * changed
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
            np.zeros(len(pairs.one)),
            plane_view.role.frame.look_axis[1] * cut_depths(view, pairs.places),
            plane_view.looks_up,
            view.draws_hidden,
            view.draws_tangents,
            pairs.raster,
            _cells(pairs),
            squares_of(places, size),
            squares_of(at, size),
        )
        if axis in closed:
            made = _with_nothing_beyond(made, pairs, closed[axis], (drawn.aside, size))
        for hole in sheet.holes:
            if hole.axis is axis and hole.looks_up == made.looks_up:
                made = _with_note(made, hole, size)
        yield made


def _cells(pairs: SightPairs) -> Floats:
    rows = len(np.unique(pairs.places[pairs.raster :, 0]))
    return np.square(pairs.cells).reshape(max(1, rows), -1)


def _with_note(view: PlannedView, hole: PlaneHole, size: Floats) -> PlannedView:
    """A view with pairs of a line of sight in a step of a hole and of one beside the hole."""
    turn = np.linspace(0.0, 2.0 * np.pi, _WAYS, endpoint=False)
    ways = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    beside = hole.centre + _BESIDE * hole.steps[-1].diameter / 2.0 * ways
    rings, depths, weights, inner = [beside], [], [], 0.0
    for step in hole.steps:
        radius = step.diameter / 2.0
        rings.append(hole.centre + (inner + radius) / 2.0 * ways)
        depths += [np.inf if step.depth is None else step.depth] * _WAYS
        weights += [_NOTE * np.sqrt(np.pi) * radius / _WAYS] * _WAYS
        inner = radius
    first, count = len(view.sights.places), len(depths)
    places = np.vstack(rings)
    other = first + np.tile(np.arange(_WAYS), len(hole.steps))
    return replace(
        view,
        sights=replace(view.sights, places=np.vstack([view.sights.places, places])),
        one=np.concatenate([view.one, first + _WAYS + np.arange(count)]),
        other=np.concatenate([view.other, other]),
        drawn=np.concatenate([view.drawn, np.full(count, NOTED)]),
        weight=np.concatenate([view.weight, weights]),
        depth=np.concatenate([view.depth, depths]),
        cut_at=np.concatenate([view.cut_at, np.full(len(places), np.nan)]),
        squares=np.concatenate([view.squares, squares_of(places, size)]),
        pair_squares=np.concatenate([view.pair_squares, squares_of(places[_WAYS:], size)]),
    )


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
        depth=np.zeros(len(view.one) + count),
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


def _no_signs(count: int) -> Signs:
    every, sharp, first = np.zeros((3, count), np.int64)
    return Signs(every, sharp, first, np.zeros(count))


def _scratch(count: int) -> Scratch:
    return Scratch(np.zeros(count, np.int64), *_no_signs(count))


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
