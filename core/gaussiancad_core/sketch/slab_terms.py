"""What a choice is made of: whether each region is filled in each slab, and what follows from it.

Everything is a literal of one CP-SAT model; what was asked for once is kept.
"""

from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from ortools.sat.python import cp_model

from gaussiancad_core.sketch.plan_regions import OUTSIDE, Border
from gaussiancad_core.sketch.slab_plan import Plan

UNIT = 100
"""Of cost, in a grid step."""

Literal = cp_model.IntVar
Expression = cp_model.LinearExpr | int


class Terms:
    """The literals of a plan, and what they cost.

    Attributes:
        plan: what there is to choose from.
        model: of all.
        filled: of each region and slab.
        fixed: mm that every choice costs.
        costs: in hundredths of a grid step, beside.
    """

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.model = cp_model.CpModel()
        self.filled = [
            [self.model.new_bool_var("") for _ in plan.slabs] for _ in plan.regions.polygons
        ]
        self.fixed = 0.0
        self.costs: list[Expression] = []
        self._open: dict[tuple[tuple[int, ...], int], Expression] = {((), k): 1 for k in plan.slabs}
        self._changes: dict[tuple[tuple[int, ...], int], Literal] = {}
        self._alters: dict[tuple[tuple[int, ...], int], Literal] = {}
        self._ends: dict[tuple[bool, int, int], Literal] = {}
        self._runs: dict[tuple[tuple[int, ...], int], Expression] = {}

    @cached_property
    def heights(self) -> npt.NDArray[np.float64]:
        """(slabs,) mm."""
        return np.diff(self.plan.levels)

    @cached_property
    def roots(self) -> npt.NDArray[np.float64]:
        """(regions,) mm, roots of their areas."""
        return np.sqrt(self.plan.regions.areas)

    def cost(self, mm: float, what: Expression) -> None:
        """So many mm are lost if something holds."""
        units = round(UNIT * mm / self.plan.grid)
        if units:
            self.costs.append(units * what)

    def either(self, drawn: float, undrawn: float, seen: Expression) -> None:
        """What is lost where a line is drawn but not seen, and seen but not drawn; mm."""
        self.fixed += drawn
        self.cost(undrawn, seen)
        self.cost(-drawn, seen)

    def is_open(self, regions: tuple[int, ...], slab: int) -> Expression:
        """Whether all of some regions are void in a slab."""
        key = regions, slab
        if key not in self._open:
            before, last = self.is_open(regions[:-1], slab), self.filled[regions[-1]][slab]
            variable = self.model.new_bool_var("")
            self.model.add(variable <= before)
            self.model.add(variable <= 1 - last)
            self.model.add(variable >= before - last)
            self._open[key] = variable
        return self._open[key]

    def first(self, regions: tuple[int, ...], slab: int) -> list[Expression]:
        """Of each region on a sight line, and of none, whether it is the nearest filled one."""
        opens = [self.is_open(regions[:k], slab) for k in range(len(regions) + 1)]
        return [*(before - after for before, after in pairwise(opens)), opens[-1]]

    def changes_at(self, regions: tuple[int, ...], level: int) -> Expression:
        """Whether the nearest changes at a level."""
        if level in (0, len(self.plan.levels) - 1):
            return 1 - self.is_open(regions, min(level, len(self.plan.levels) - 2))
        key = regions, level
        if key not in self._changes:
            variable = self.model.new_bool_var("")
            for below, above in zip(
                self.first(regions, level - 1), self.first(regions, level), strict=True
            ):
                self.model.add(variable >= below - above)
                self.model.add(variable >= above - below)
                self.model.add(variable <= 2 - below - above)
            self._changes[key] = variable
        return self._changes[key]

    def alters_at(self, regions: tuple[int, ...], level: int) -> Expression:
        """Whether any of some regions is filled on one side of a level only."""
        key = tuple(sorted(set(regions))), level
        if key not in self._alters:
            variable = self.model.new_bool_var("")
            xors = [self.differ(self.filled[r][level - 1], self.filled[r][level]) for r in key[0]]
            for each in xors:
                self.model.add(variable >= each)
            self.model.add(variable <= sum(xors))
            self._alters[key] = variable
        return self._alters[key]

    def all_of(self, what: Sequence[Expression]) -> Literal:
        """A literal that holds only where all of some do."""
        variable = self.model.new_bool_var("")
        for each in what:
            self.model.add(variable <= each)
        return variable

    def differ(self, one: Literal, other: Literal) -> Literal:
        """Whether one of two literals holds, and the other does not."""
        variable = self.model.new_bool_var("")
        self.model.add(variable >= one - other)
        self.model.add(variable >= other - one)
        self.model.add(variable <= one + other)
        self.model.add(variable <= 2 - one - other)
        return variable

    def jump(
        self,
        one: tuple[int, ...],
        other: tuple[int, ...],
        even: npt.NDArray[np.bool_],
        slab: int,
    ) -> Literal:
        """Whether the nearest of two sight lines beside each other is not one face."""
        variable = self.model.new_bool_var("")
        near, far = self.first(one, slab), self.first(other, slab)
        for a, first in enumerate(near):
            for b, second in enumerate(far):
                both_none = a == len(one) and b == len(other)
                if both_none or (a < len(one) and b < len(other) and even[a, b]):
                    self.model.add(variable <= 2 - first - second)
                else:
                    self.model.add(variable >= first + second - 1)
        return variable

    def more_runs(self, one: tuple[int, ...], other: tuple[int, ...], slab: int) -> Literal:
        """Whether two sight lines pass through the part a different number of times."""
        variable = self.model.new_bool_var("")
        a, b = self._runs_of(one, slab), self._runs_of(other, slab)
        self.model.add(a == b).only_enforce_if(variable.negated())
        self.model.add(a != b).only_enforce_if(variable)
        return variable

    def _runs_of(self, regions: tuple[int, ...], slab: int) -> Expression:
        key = regions, slab
        if key not in self._runs:
            starts: list[Expression] = [self.filled[r][slab] for r in regions[:1]]
            for before, after in pairwise(regions):
                variable = self.model.new_bool_var("")
                one, other = self.filled[before][slab], self.filled[after][slab]
                self.model.add(variable <= other)
                self.model.add(variable <= 1 - one)
                self.model.add(variable >= other - one)
                starts.append(variable)
            self._runs[key] = sum(starts)
        return self._runs[key]

    @cached_property
    def tops(self) -> list[list[Literal]]:
        """Of each region and slab, whether that and all above are void."""
        return [self._opened(row[::-1])[::-1] for row in self.filled]

    @cached_property
    def bottoms(self) -> list[list[Literal]]:
        """Of each region and slab, whether that and all below are void."""
        return [self._opened(row) for row in self.filled]

    def _opened(self, row: list[Literal]) -> list[Literal]:
        """Of each of a region's slabs whether it and those before are void."""
        found: list[Literal] = []
        for variable in row:
            opened = self.model.new_bool_var("")
            self.model.add(opened <= 1 - variable)
            if found:
                self.model.add(opened <= found[-1])
                self.model.add(opened >= found[-1] - variable)
            else:
                self.model.add(opened >= 1 - variable)
            found.append(opened)
        return found

    def same(self, opened: list[list[Literal]], border: Border) -> Literal:
        """Whether two regions end at one level."""
        one, is_top = opened[border.one], opened is self.tops
        if border.other == OUTSIDE:
            return one[0] if is_top else one[-1]
        key = is_top, border.one, border.other
        if key in self._ends:
            return self._ends[key]
        variable, other = self.model.new_bool_var(""), opened[border.other]
        self.model.add(sum(one) == sum(other)).only_enforce_if(variable)
        self.model.add(sum(one) != sum(other)).only_enforce_if(variable.negated())
        self._ends[key] = variable
        return variable

    def differs(self, one: int, other: int) -> Literal:
        """Whether two regions are filled in different slabs."""
        variable = self.model.new_bool_var("")
        each = [
            self.differ(a, b) for a, b in zip(self.filled[one], self.filled[other], strict=True)
        ]
        for differ in each:
            self.model.add(variable >= differ)
        self.model.add(variable <= sum(each))
        return variable

    @cached_property
    def neighbours(self) -> dict[int, set[int]]:
        """Regions that have a border with each region."""
        found: dict[int, set[int]] = {r: set() for r in range(len(self.filled))}
        for border in self.plan.regions.borders:
            if border.other != OUTSIDE:
                found[border.one].add(border.other)
                found[border.other].add(border.one)
        return found
