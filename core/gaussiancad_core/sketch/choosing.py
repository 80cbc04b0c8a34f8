"""Which regions are filled in which slab: what explains the lines best, and is usual.

Nothing here is a rule that has to hold.  Each mm of line that a choice leaves unexplained, or would
show where none is drawn, costs; so does what parts seldom have: hollows that no view sees, blind
holes, pieces that hang in the air.  The cheapest choice of all is found exactly (CP-SAT).
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import floor, isfinite

import numpy as np
import numpy.typing as npt
from ortools.sat.python import cp_model

from gaussiancad_core.reasoning.solvers import FOUND
from gaussiancad_core.sketch.plan import Plan
from gaussiancad_core.sketch.regions import OUTSIDE, Border
from gaussiancad_core.sketch.sights import Sights

_UPRIGHT_SEEN, _UPRIGHT_DRAWN = 0.7, 0.35
"""What a mm costs of line along the axis that is seen but not drawn, and drawn but not seen: round
walls show none, and edges between faces of one slab are drawn too."""

_HIDDEN, _HIDDEN_UPRIGHT = 0.5, 0.35
"""What a mm of hidden line costs, across the axis and along it."""

_KIND = 0.5
"""Share of what a line costs that is seen but not drawn, where it is drawn as a hidden one."""

_RUN = 1.2
"""Grid steps that each stretch of filled slabs of a region costs."""

_MORE_RUNS = 0.1
"""What a further one costs, in the root of the region's area; a grid step more."""

_VOID, _UNSEEN = 0.05, 0.25
"""What a void costs that reaches through the part, in the root of its area; and more where no view
sees it."""

_BODY = 2.0
"""What each body costs beside the largest one, in the root of the area of its shadow along the
axis; where two are drawn, the outlines between them cost twice as much."""

_PARTINGS = 8
"""Times that the bodies of what is cheapest are looked at."""

_BLIND = 0.05
"""The same of a region within the outline that is filled in part; and half a grid step."""

_HATCHED = 0.15
"""What a grid step squared costs that is hatched and void, or filled and not hatched."""

_SEEN = 0.3
"""Share of a region's sight lines in a view from which that sees it."""

_UNIT = 100
"""Of cost, in a grid step."""

_Cell = tuple[int, int]
"""A region's number, and a slab's."""

Literal = cp_model.IntVar
Expression = cp_model.LinearExprT


@dataclass(frozen=True, eq=False)
class Choice:
    """Which regions are filled where.

    Attributes:
        plan: what there was to choose from.
        filled: (regions, slabs) bool.
        energy: mm of line, and what counts as much, that it costs.
        is_proven: whether no other choice costs less.
    """

    plan: Plan
    filled: npt.NDArray[np.bool_]
    energy: float
    is_proven: bool


def choose(plan: Plan, less: float, effort: float) -> tuple[Choice | None, float]:
    """The cheapest choice of a plan, and the units of the solver's work that it took.

    There is no choice where none costs as little, or none was found in time.

    Args:
        plan: with a region and a slab at least.
        less: mm, what it may cost at most.
        effort: units of the solver's work.
    """
    model = _Model(plan)
    if isfinite(less):
        model.bound(less)
    spent = 0.0
    best: Choice | None = None
    for _ in range(_PARTINGS):
        solver = _solver(effort - spent)
        status = solver.solve(model.model)
        spent += solver.response_proto.deterministic_time
        if status not in FOUND:
            break
        filled = np.array([[bool(solver.value(x)) for x in row] for row in model.filled])
        energy = (solver.objective_value / _UNIT) * plan.grid + model.constant
        found = Choice(plan, filled, energy, status == cp_model.OPTIMAL)
        # Bodies are paid for once they are seen: to hold a part together takes many constraints.
        parted = model.price_bodies(filled)
        best = replace(found, energy=energy + parted)
        if not parted or spent >= effort:
            break
    return best, spent


def _solver(effort: float) -> cp_model.CpSolver:
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    # Costs are sums: their relaxation to fractions tells far sooner that nothing is cheaper.
    solver.parameters.linearization_level = 2
    solver.parameters.random_seed = 0
    solver.parameters.max_deterministic_time = effort
    return solver


class _Model:
    """The constraints and costs of a plan.

    Attributes:
        model: with its objective.
        filled: of each region and slab.
        constant: mm that every choice costs.
    """

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.model = cp_model.CpModel()
        self.filled = [
            [self.model.new_bool_var("") for _ in plan.slabs] for _ in plan.regions.polygons
        ]
        self.constant = sum(own.alien for own in plan.sights)
        self._costs: list[Expression] = []
        self._fixed = 0.0
        self._open: dict[tuple[tuple[int, ...], int], Expression] = {((), k): 1 for k in plan.slabs}
        self._changes: dict[tuple[tuple[int, ...], int], Literal] = {}
        self._alters: dict[tuple[tuple[int, ...], int], Literal] = {}
        self._runs: dict[tuple[tuple[int, ...], int], Expression] = {}
        for own in plan.sights:
            self._add_levels(own)
            self._add_uprights(own)
            self._add_hatching(own)
        for border in plan.regions.borders:
            self._add_border(border)
        self._add_habits()
        # The part reaches from its first level to its last one.
        for k in {0, len(plan.levels) - 2}:
            self.model.add_bool_or([row[k] for row in self.filled])
        self.constant += self._fixed
        self._priced: set[frozenset[_Cell]] = set()
        self.model.minimize(sum(self._costs))

    def bound(self, less: float) -> None:
        """Let a choice cost so many mm at most."""
        most = floor((less - self.constant) / self.plan.grid * _UNIT)
        self.model.add(sum(self._costs) <= most)

    def price_bodies(self, filled: npt.NDArray[np.bool_]) -> float:
        """mm that the bodies of a choice cost beside the largest, if they cost nothing yet; from
        now on they do."""
        bodies = _bodies(filled, self._beside)
        fresh = [frozenset(own) for own in bodies[1:] if frozenset(own) not in self._priced]
        total = 0.0
        for own in fresh:
            self._priced.add(own)
            shadow = float(self.plan.regions.areas[sorted({region for region, _ in own})].sum())
            around = {cell for each in own for cell in self._next_to(each)} - own
            is_body = self.model.new_bool_var("")
            inside = sum(1 - self.filled[r][k] for r, k in own)
            outside = sum(self.filled[r][k] for r, k in around)
            self.model.add(inside + outside + is_body >= 1)
            self._cost(_BODY * shadow**0.5, is_body)
            total += _BODY * shadow**0.5
        if fresh:
            self.model.minimize(sum(self._costs))
            self.model.clear_hints()
            for row, own in zip(self.filled, filled, strict=True):
                for x, value in zip(row, own, strict=True):
                    self.model.add_hint(x, bool(value))
        return total

    @cached_property
    def _beside(self) -> dict[int, set[int]]:
        """Regions that have a border with each region."""
        found: dict[int, set[int]] = {r: set() for r in range(len(self.filled))}
        for border in self.plan.regions.borders:
            if border.other != OUTSIDE:
                found[border.one].add(border.other)
                found[border.other].add(border.one)
        return found

    def _next_to(self, cell: _Cell) -> set[_Cell]:
        region, slab = cell
        levels = {(region, k) for k in (slab - 1, slab + 1) if k in self.plan.slabs}
        return levels | {(other, slab) for other in self._beside[region]}

    @cached_property
    def heights(self) -> npt.NDArray[np.float64]:
        """(slabs,) mm."""
        return np.diff(self.plan.levels)

    @cached_property
    def roots(self) -> npt.NDArray[np.float64]:
        """(regions,) mm, roots of their areas."""
        return np.sqrt(self.plan.regions.areas)

    def _cost(self, mm: float, what: Expression) -> None:
        """So many mm are lost if something holds."""
        units = round(_UNIT * mm / self.plan.grid)
        if units:
            self._costs.append(units * what)

    def _either(self, drawn: float, undrawn: float, seen: Expression) -> None:
        """What is lost where a line is drawn but not seen, and seen but not drawn; mm."""
        self._fixed += drawn
        self._cost(undrawn, seen)
        self._cost(-drawn, seen)

    # What is nearest

    def _is_open(self, regions: tuple[int, ...], slab: int) -> Expression:
        """Whether all of some regions are void in a slab."""
        key = regions, slab
        if key not in self._open:
            before, last = self._is_open(regions[:-1], slab), self.filled[regions[-1]][slab]
            own = self.model.new_bool_var("")
            self.model.add(own <= before)
            self.model.add(own <= 1 - last)
            self.model.add(own >= before - last)
            self._open[key] = own
        return self._open[key]

    def _first(self, regions: tuple[int, ...], slab: int) -> list[Expression]:
        """Of each region on a sight line, and of none, whether it is the nearest filled one."""
        opens = [self._is_open(regions[:k], slab) for k in range(len(regions) + 1)]
        return [*(before - after for before, after in pairwise(opens)), opens[-1]]

    def _changes_at(self, regions: tuple[int, ...], level: int) -> Expression:
        """Whether the nearest changes at a level."""
        if level in (0, len(self.plan.levels) - 1):
            return 1 - self._is_open(regions, min(level, len(self.plan.levels) - 2))
        key = regions, level
        if key not in self._changes:
            own = self.model.new_bool_var("")
            for below, above in zip(
                self._first(regions, level - 1), self._first(regions, level), strict=True
            ):
                self.model.add(own >= below - above)
                self.model.add(own >= above - below)
                self.model.add(own <= 2 - below - above)
            self._changes[key] = own
        return self._changes[key]

    def _alters_at(self, regions: tuple[int, ...], level: int) -> Expression:
        """Whether any of some regions is filled on one side of a level only."""
        key = tuple(sorted(set(regions))), level
        if key not in self._alters:
            own = self.model.new_bool_var("")
            xors = [self._differ(self.filled[r][level - 1], self.filled[r][level]) for r in key[0]]
            for each in xors:
                self.model.add(own >= each)
            self.model.add(own <= sum(xors))
            self._alters[key] = own
        return self._alters[key]

    def _differ(self, one: Literal, other: Literal) -> Literal:
        own = self.model.new_bool_var("")
        self.model.add(own >= one - other)
        self.model.add(own >= other - one)
        self.model.add(own <= one + other)
        self.model.add(own <= 2 - one - other)
        return own

    # Lines of views from beside

    def _add_levels(self, view: Sights) -> None:
        """Lines across the axis: where the nearest changes from a slab to the next."""
        visible, hidden = view.levels
        groups = _grouped(view.regions)
        for level in range(len(self.plan.levels)):
            inner = 0 < level < len(self.plan.levels) - 1
            for regions, chosen in groups.items():
                if not regions:
                    self._fixed += float(view.widths[chosen][visible[chosen, level]].sum())
                    continue
                widths = view.widths[chosen]
                solid, dashed = visible[chosen, level], hidden[chosen, level]
                drawn = float(widths[solid].sum())
                blank = float(widths[~solid & ~dashed].sum())
                behind = float(widths[dashed & ~solid].sum())
                seen = self._changes_at(regions, level)
                self._either(drawn, blank + _KIND * behind, seen)
                if view.draws_hidden and inner:
                    beneath = self._alters_at(regions, level)
                    self._either(_HIDDEN * behind, 0.0, beneath)
                    if blank:
                        covered = self.model.new_bool_var("")
                        self.model.add(covered >= beneath - seen)
                        self._cost(_HIDDEN * blank, covered)

    def _add_uprights(self, view: Sights) -> None:
        """Lines along the axis: where the nearest lies deeper on the next sight line."""
        visible, hidden = view.uprights
        count = len(view.places)
        told: dict[tuple[object, ...], list[float]] = {}
        known: dict[tuple[object, ...], tuple[Expression, Expression | None]] = {}
        for index, even in enumerate(view.goes_on):
            one, other = (view.met[k].regions if 0 <= k < count else () for k in (index - 1, index))
            for k in self.plan.slabs:
                key = one, other, even.tobytes(), k
                is_plain = one == other and bool(np.diag(even).all())
                if is_plain and not (visible[index, k] or hidden[index, k]):
                    continue
                if key not in known:
                    jump: Expression = 0 if is_plain else self._jump(one, other, even, k)
                    beneath = None
                    if view.draws_hidden:
                        beneath = 0 if one == other else self._more_runs(one, other, k)
                    known[key] = jump, beneath
                    told[key] = [0.0, 0.0, 0.0]
                height = float(self.heights[k])
                kind = 0 if visible[index, k] else 1 if hidden[index, k] else 2
                told[key][kind] += height
        for key, (solid, dashed, blank) in told.items():
            jump, beneath = known[key]
            lacking = _UPRIGHT_SEEN * (blank + _KIND * dashed)
            self._either(_UPRIGHT_DRAWN * solid, lacking, jump)
            if beneath is None:
                continue
            if dashed:
                either = self.model.new_bool_var("")
                self.model.add(either <= jump + beneath)
                self._either(_HIDDEN_UPRIGHT * dashed, 0.0, either)
            if blank:
                covered = self.model.new_bool_var("")
                self.model.add(covered >= beneath - jump)
                self._cost(_HIDDEN_UPRIGHT * blank, covered)

    def _jump(
        self,
        one: tuple[int, ...],
        other: tuple[int, ...],
        even: npt.NDArray[np.bool_],
        slab: int,
    ) -> Literal:
        """Whether the nearest of two sight lines beside each other is not one face."""
        own = self.model.new_bool_var("")
        near, far = self._first(one, slab), self._first(other, slab)
        for a, first in enumerate(near):
            for b, second in enumerate(far):
                both_none = a == len(one) and b == len(other)
                if both_none or (a < len(one) and b < len(other) and even[a, b]):
                    self.model.add(own <= 2 - first - second)
                else:
                    self.model.add(own >= first + second - 1)
        return own

    def _more_runs(self, one: tuple[int, ...], other: tuple[int, ...], slab: int) -> Literal:
        """Whether two sight lines pass through the part a different number of times."""
        own = self.model.new_bool_var("")
        a, b = self._runs_of(one, slab), self._runs_of(other, slab)
        self.model.add(a == b).only_enforce_if(own.negated())
        self.model.add(a != b).only_enforce_if(own)
        return own

    def _runs_of(self, regions: tuple[int, ...], slab: int) -> Expression:
        key = regions, slab
        if key not in self._runs:
            starts: list[Expression] = [self.filled[r][slab] for r in regions[:1]]
            for before, after in pairwise(regions):
                own = self.model.new_bool_var("")
                one, other = self.filled[before][slab], self.filled[after][slab]
                self.model.add(own <= other)
                self.model.add(own <= 1 - one)
                self.model.add(own >= other - one)
                starts.append(own)
            self._runs[key] = sum(starts)
        return self._runs[key]

    def _add_hatching(self, view: Sights) -> None:
        """What a section cuts is hatched."""
        if view.hatched is None:
            return
        per_mm2 = _HATCHED / self.plan.grid
        for k in self.plan.slabs:
            areas: dict[tuple[int, ...], list[float]] = {}
            for index, regions in enumerate(view.regions):
                cut = tuple(
                    r for r, own in zip(regions, view.met[index].is_cut, strict=True) if own
                )
                told = areas.setdefault(cut, [0.0, 0.0])
                told[0 if view.hatched[index, k] else 1] += float(
                    view.widths[index] * self.heights[k]
                )
            for cut, (hatched, plain) in areas.items():
                if cut:
                    void = self._is_open(cut, k)
                    self._either(per_mm2 * hatched, per_mm2 * plain, 1 - void)

    # Lines of the views along the axis

    @cached_property
    def _tops(self) -> list[list[Literal]]:
        return [self._opened(row[::-1])[::-1] for row in self.filled]

    @cached_property
    def _bottoms(self) -> list[list[Literal]]:
        return [self._opened(row) for row in self.filled]

    def _opened(self, row: list[Literal]) -> list[Literal]:
        """Of each of a region's slabs whether it and those before are void."""
        found: list[Literal] = []
        for own in row:
            opened = self.model.new_bool_var("")
            self.model.add(opened <= 1 - own)
            if found:
                self.model.add(opened <= found[-1])
                self.model.add(opened >= found[-1] - own)
            else:
                self.model.add(opened >= 1 - own)
            found.append(opened)
        return found

    def _add_border(self, border: Border) -> None:
        above, below = self.plan.is_seen
        if above:
            same = self._same(self._tops, border)
            lacking = _lacking(border.length, border.visible, border.hidden)
            self._either(lacking, border.visible, same)
            if self.plan.draws_hidden and border.other != OUTSIDE:
                beneath = self._differs(border.one, border.other)
                covered = self.model.new_bool_var("")
                self.model.add(covered <= same)
                self.model.add(covered <= beneath)
                self.model.add(covered >= same + beneath - 1)
                self._cost(_HIDDEN * max(0.0, border.length - border.hidden), covered)
                self._cost(_HIDDEN * border.hidden, same - covered)
        if below:
            same = self._same(self._bottoms, border)
            lacking = _lacking(border.length, border.visible_below, border.hidden_below)
            self._either(lacking, border.visible_below, same)

    def _same(self, opened: list[list[Literal]], border: Border) -> Literal:
        """Whether two regions end at one level."""
        one = opened[border.one]
        if border.other == OUTSIDE:
            return one[0] if opened is self._tops else one[-1]
        own, other = self.model.new_bool_var(""), opened[border.other]
        self.model.add(sum(one) == sum(other)).only_enforce_if(own)
        self.model.add(sum(one) != sum(other)).only_enforce_if(own.negated())
        return own

    def _differs(self, one: int, other: int) -> Literal:
        """Whether two regions are filled in different slabs."""
        own = self.model.new_bool_var("")
        each = [
            self._differ(a, b) for a, b in zip(self.filled[one], self.filled[other], strict=True)
        ]
        for differ in each:
            self.model.add(own >= differ)
        self.model.add(own <= sum(each))
        return own

    # What is usual

    def _add_habits(self) -> None:
        plan = self.plan
        largest = int(np.argmax(plan.regions.areas))
        shares = self.heights / plan.size[plan.axis.value]
        seen = self._seen_from_beside()
        for r, row in enumerate(self.filled):
            root, runs = float(self.roots[r]), self._column_runs(row)
            self._cost(_RUN * plan.grid, runs)
            more = self.model.new_int_var(0, len(row), "")
            self.model.add(more >= runs - 1)
            self._cost(_MORE_RUNS * root + plan.grid, more)
            for k, own in enumerate(row):
                share = float(shares[k])
                self._cost(_VOID * root * share, 1 - own)
                views = list(seen.get((r, k), ()))
                if plan.is_seen[0]:
                    views.append(self._tops[r][k])
                if plan.is_seen[1]:
                    views.append(self._bottoms[r][k])
                any_view = self.model.new_bool_var("")
                self.model.add(any_view <= sum(views))
                self._cost(_UNSEEN * root * share, 1 - own - any_view)
            if plan.regions.is_inner[r] and r != largest and len(row) > 1:
                blind = self.model.new_bool_var("")
                for one, other in pairwise(row):
                    self.model.add(blind >= one - other)
                    self.model.add(blind >= other - one)
                self._cost(_BLIND * root + 0.5 * plan.grid, blind)

    def _column_runs(self, row: list[Literal]) -> Expression:
        starts: list[Expression] = [row[0]]
        for before, after in pairwise(row):
            own = self.model.new_bool_var("")
            self.model.add(own <= after)
            self.model.add(own <= 1 - before)
            self.model.add(own >= after - before)
            starts.append(own)
        return sum(starts)

    def _seen_from_beside(self) -> Mapping[tuple[int, int], Iterable[Expression]]:
        """Of a region and a slab, ways along which a view from beside looks into it."""
        found: dict[tuple[int, int], list[Expression]] = {}
        for view in self.plan.sights:
            widths: dict[int, float] = {}
            ways: dict[int, dict[tuple[int, ...], float]] = {}
            for regions, width in zip(view.regions, view.widths.tolist(), strict=True):
                for r in set(regions):
                    before = regions[: regions.index(r) + 1]
                    widths[r] = widths.get(r, 0.0) + width
                    own = ways.setdefault(r, {})
                    own[before] = own.get(before, 0.0) + width
            for r, own in ways.items():
                for before, width in own.items():
                    if width >= _SEEN * widths[r]:
                        for k in self.plan.slabs:
                            found.setdefault((r, k), []).append(self._is_open(before, k))
        return found


def _bodies(filled: npt.NDArray[np.bool_], beside: Mapping[int, set[int]]) -> list[set[_Cell]]:
    """The filled cells as bodies, those of most cells first."""
    left = {(int(r), int(k)) for r, k in np.argwhere(filled)}
    found = []
    while left:
        waiting = [left.pop()]
        body = set(waiting)
        while waiting:
            region, slab = waiting.pop()
            near = {(region, slab - 1), (region, slab + 1), *((r, slab) for r in beside[region])}
            near &= left
            left -= near
            body |= near
            waiting += near
        found.append(body)
    return sorted(found, key=len, reverse=True)


def _lacking(length: float, visible: float, hidden: float) -> float:
    """mm that are lost of a line which is seen, by what is drawn of it."""
    blank = max(0.0, length - visible - hidden)
    return blank + _KIND * min(hidden, max(0.0, length - visible))


def _grouped(regions: Iterable[tuple[int, ...]]) -> dict[tuple[int, ...], list[int]]:
    """Sight lines that meet the same regions in the same order."""
    groups: dict[tuple[int, ...], list[int]] = {}
    for index, own in enumerate(regions):
        groups.setdefault(own, []).append(index)
    return groups
