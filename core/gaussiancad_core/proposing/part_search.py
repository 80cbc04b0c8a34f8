"""The search for a part: the best of what edits and changes make of several starts."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.coordinates.agreed_places import Places
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.edit_hints import EditHints
from gaussiancad_core.proposing.equal_loops import patterns_of, turned_patterns
from gaussiancad_core.proposing.feature_kernels import Operation
from gaussiancad_core.proposing.lines_by_plane import plane_sheet
from gaussiancad_core.proposing.loop_places import prisms_of, whole_prism
from gaussiancad_core.proposing.loop_shapes import loops_of
from gaussiancad_core.proposing.part_changes import improved
from gaussiancad_core.proposing.part_edits import Edits, Pool
from gaussiancad_core.proposing.part_features import Feature, Prism, Turned, single_features
from gaussiancad_core.proposing.plane_loops import Loop, LoopKind, plane_loops
from gaussiancad_core.proposing.planned_part import PlannedJudge, PlannedPart
from gaussiancad_core.proposing.planned_views import planned_views
from gaussiancad_core.proposing.slab_starts import slab_start
from gaussiancad_core.proposing.turned_profiles import turned_of

_HABIT = 0.01
"""Share of the lines that an edit as large as the part costs: of two that explain the same the
smaller one."""

_ROUGHLY = 4
"""One of so many pairs of lines of sight tells which edits are worth a look."""

_BLIND = 0.05
"""What an end of a hole within the part costs, in the root of its area: holes go through."""

_FILM = 0.5
"""What a mm around a feature costs that is so thin that no line of sight runs through it."""

_WORTH = 1e-3
"""Share of the lines that an edit has to explain."""

_GOOD, _DONE = 4e-3, 5e-4
"""Shares of the lines left unexplained with which no other start is tried, and no other edit."""

_FIRST_SHARE, _SLAB_SHARE = 0.1, 0.06
"""Shares of the work for each family of starts, and for slabs along one axis."""

_MAIN = 0.3
"""Share of the outline that a region with holes has from which the part may be that."""

_ALL_OF_SIDE = 0.97
"""Share of a view's side that an outline reaches from which it is a prism of the part."""

_MOST_TURNED = 20


@dataclass(frozen=True, eq=False)
class Start:
    """What a search begins with.

    Attributes:
        family: of its kind.
        part: as it is then.
    """

    family: str
    part: PlannedPart


class PartSearch:
    """The search for the part of a sheet.

    Args:
        views: of the part, with what the sheet's numbers say.
        places: where their lines belong.
        work: steps of the kernels, as the judge counts them, for all of it.
    """

    def __init__(self, views: DrawnViews, places: Places, work: float) -> None:
        self._work = work
        self._aside = drawn_sheet(views).aside
        self.sheet = plane_sheet(views, places)
        found = {axis: plane_loops(self.sheet, axis) for axis in Axis}
        self._planes = {axis: plane for axis, plane in found.items() if plane is not None}
        self._loops = {axis: loops_of(self.sheet, plane) for axis, plane in self._planes.items()}
        turned = list(turned_of(self.sheet, self._planes, self._loops))
        self._pool: list[Feature] = [
            made
            for loops in self._loops.values()
            for loop in loops
            for made in prisms_of(self.sheet, loop)
        ]
        self._pool += turned
        self._pool += patterns_of(self.sheet, self._loops)
        self._pool += turned_patterns(turned, self.sheet.tolerance)
        outlines = list(self._outlines())
        self.judge = PlannedJudge(
            self.sheet, tuple(planned_views(views, self.sheet, self._planes.values()))
        )
        self._least = _WORTH * self.judge.length
        self._draws_hidden = any(view.draws_hidden for view in self.judge.views)
        self._rough = self.judge.rough(_ROUGHLY)
        self._offers = Pool.of(self._pool, self._price_of, self._rough) if self._pool else None
        self._hints = EditHints(self._pool, self.judge) if self._pool else None
        self._starts = self._by_family(list(self._all_starts(outlines, turned)))

    def best(self) -> PlannedPart | None:
        """The part that explains most; None where nothing tells a start."""
        tried: list[PlannedPart] = []
        families = len({start.family for start in self._starts})
        for start in self._starts[:families]:
            tried.append(self._edited(start.part, _FIRST_SHARE * self._work))
            # Without hidden lines several parts explain all: the most usual one counts.
            if self._is_good(tried[-1]) and self._draws_hidden:
                break
        if not tried:
            return None
        tried.sort(key=_weighed)
        best = tried[0]
        rest = [start.part for start in self._starts[families:]]
        for part in tried + rest:
            if self._is_good(best) or self.work > self._work:
                break
            further = self._edited(part, self._work)
            if _weighed(further) < _weighed(best):
                best = further
        return best

    @property
    def work(self) -> int:
        """Steps of the kernels so far."""
        return self.judge.work + self._rough.work

    def _is_good(self, part: PlannedPart) -> bool:
        return part.cost + self.judge.habits.of_pieces(part.features) < _GOOD * self.judge.length

    def _outlines(self) -> Iterator[Prism]:
        """The outlines of the views as prisms."""
        for axis, plane in self._planes.items():
            x0, y0, x1, y1 = plane.outline.bounds
            width, height = self.sheet.size[list(IN_PLANE[axis])].tolist()
            if x1 - x0 > _ALL_OF_SIDE * width and y1 - y0 > _ALL_OF_SIDE * height:
                outline = next(each for each in self._loops[axis] if each.kind is LoopKind.OUTLINE)
                yield whole_prism(self.sheet, outline)

    def _all_starts(self, outlines: Sequence[Prism], turned: Sequence[Turned]) -> Iterator[Start]:
        met = self._met(PlannedPart(self.judge), outlines, first=Operation.ADD)
        if met.features:
            yield Start("outlines", met)
            for loop in self._mains():
                rest = [outline for outline in outlines if outline.axis is not loop.axis]
                main = [whole_prism(self.sheet, loop), *rest]
                yield Start("main region", self._met(PlannedPart(self.judge), main, Operation.ADD))
        for axis, plane in self._planes.items():
            until = self.judge.work + _SLAB_SHARE * self._work
            slabs = slab_start(self.judge, plane, self._loops[axis], until)
            if slabs is not None:
                yield Start("slabs", slabs)
                rest = [outline for outline in outlines if outline.axis is not axis]
                yield Start("slabs", self._met(slabs.copy(), rest, first=Operation.MEET))
        for made in [each for each in turned if self._is_whole(each)][:_MOST_TURNED]:
            yield Start("turned", PlannedPart(self.judge).do(Operation.ADD, made))

    @staticmethod
    def _met(part: PlannedPart, outlines: Sequence[Prism], first: Operation) -> PlannedPart:
        for number, outline in enumerate(outlines):
            part.do(first if number == 0 else Operation.MEET, outline)
        return part

    def _mains(self) -> Iterator[Loop]:
        """Large regions with holes: all that is left of the part if every hole goes through."""
        for axis, plane in self._planes.items():
            for loop in self._loops[axis]:
                is_large = loop.polygon.area > _MAIN * plane.outline.area
                if loop.kind is not LoopKind.AROUND and loop.polygon.interiors and is_large:
                    yield loop

    def _is_whole(self, turned: Turned) -> bool:
        """Whether a turned profile is as large as the part."""
        size, axis = self.sheet.size, turned.axis.value
        across = float(np.delete(size, axis).min())
        reaches = turned.low <= self.sheet.tolerance
        reaches &= turned.high >= float(size[axis]) - self.sheet.tolerance
        return reaches and 2.0 * turned.radius > _ALL_OF_SIDE * across

    @staticmethod
    def _by_family(starts: list[Start]) -> list[Start]:
        """The best of each family, then all others, the best first."""
        starts.sort(key=lambda start: start.part.cost)
        first: dict[str, Start] = {}
        for start in starts:
            first.setdefault(start.family, start)
        return [*first.values(), *(start for start in starts if start not in first.values())]

    def _edited(self, part: PlannedPart, work: float) -> PlannedPart:
        """A part with edits, as long as one explains more."""
        until = min(self._work, self.work + work)
        while True:
            self._with_edits(part, until)
            if self.work > until or part.cost <= _DONE * self.judge.length:
                return part
            changed = improved(part, self._price_of, self._least, until - self._rough.work)
            if changed is None:
                return part
            part = changed

    def _price_of(self, operation: Operation, feature: Feature) -> float:
        """mm that a feature costs; what lies all around an area is only cut."""
        if operation is not Operation.CUT and _is_around(feature):
            return np.inf
        whole = float(np.prod(self.sheet.size))
        price = _HABIT * self.judge.length * min(1.0, feature.volume / whole)
        price += sum(self._film(each) for each in single_features(feature))
        if operation is Operation.CUT:
            price += sum(self._blind_ends(each) for each in single_features(feature))
        return price

    def _film(self, feature: Prism | Turned) -> float:
        """mm that a prism costs in which nothing is seen: lines of sight keep as far from strokes
        on either side as they look beside them."""
        if not isinstance(feature, Prism) or feature.high - feature.low > 2.0 * self._aside:
            return 0.0
        return _FILM * float(feature.loop.polygon.exterior.length)

    def _blind_ends(self, feature: Prism | Turned) -> float:
        """mm that the ends of a hole cost that lie in the part."""
        if not isinstance(feature, Prism):
            return 0.0
        sides = 0.0, float(self.sheet.size[feature.axis.value])
        inside = (feature.low > sides[0]) + (feature.high < sides[1])
        return _BLIND * float(feature.loop.polygon.area) ** 0.5 * inside

    def _with_edits(self, part: PlannedPart, until: float) -> None:
        """Do the best edits, as long as one explains more."""
        if self._hints is None or self._offers is None:
            return
        rough = PlannedPart(self._rough).followed_by(part.features)
        edits = Edits(part, rough, self._offers, self._least, until)
        while not edits.is_over and part.cost > _DONE * self.judge.length:
            edits.forget(self._hints.stale(part))
            worth = self._hints.reach(part) > self._least
            order = np.argsort(
                -self._hints.of(part) + self._offers.price.min(axis=1), kind="stable"
            )
            if not edits.some_done(order[worth[order]]):
                break


def _weighed(part: PlannedPart) -> float:
    """mm of line that a part leaves unexplained, and what is unusual about it."""
    return part.cost + part.judge.habits.unusual(part.features)


def _is_around(feature: Feature) -> bool:
    return isinstance(feature, Prism) and feature.loop.kind is LoopKind.AROUND
