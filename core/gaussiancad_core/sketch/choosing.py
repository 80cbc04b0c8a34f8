"""Which regions are filled in which slab: what explains the lines best, and is usual.

Nothing here is a rule that has to hold.  Each mm of line that a choice leaves unexplained, or would
show where none is drawn, costs; so does what parts seldom have: hollows that no view sees, blind
holes, several bodies.  The cheapest choice of all is found exactly (CP-SAT).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import floor, inf, isfinite, pi, sqrt

import numpy as np
import numpy.typing as npt
from ortools.sat.python import cp_model

from gaussiancad_core.labelling.solvers import FOUND
from gaussiancad_core.sketch.line_costs import add_evidence
from gaussiancad_core.sketch.shape_priors import add_habits, add_notes
from gaussiancad_core.sketch.slab_plan import Plan
from gaussiancad_core.sketch.slab_terms import UNIT, Terms
from gaussiancad_core.sketch.sloping_rims import SunkRim, add_bands, add_rims, rings_of

_BODY = 2.0
"""What each body costs beside the largest one, in the root of the area of its shadow along the
axis; where two are drawn, the outlines between them cost twice as much."""

_CROSS = 0.5
"""What a hole across the slabs costs, in the root of its area; and a grid step."""

_SAME = 1e-6
"""Share of it by which an energy is known."""

_PARTINGS = 8
"""Times that the bodies of what is cheapest are looked at."""

_Cell = tuple[int, int]
"""A region's number, and a slab's."""


@dataclass(frozen=True, eq=False)
class Choice:
    """Which regions are filled where.

    Attributes:
        plan: what there was to choose from.
        filled: (regions, slabs) bool.
        sunk: rings whose surface is a cone.
        energy: mm of line, and what counts as much, that it costs.
        at_least: mm that every choice of the plan costs.
    """

    plan: Plan
    filled: npt.NDArray[np.bool_]
    sunk: tuple[SunkRim, ...]
    energy: float
    at_least: float

    @property
    def is_proven(self) -> bool:
        """Whether no other choice costs less."""
        return self.at_least >= self.energy * (1.0 - _SAME)


def choose(plan: Plan, less: float, effort: float) -> tuple[Choice | None, float, float]:
    """The cheapest choice of a plan, mm that each costs at least, and the units of the solver's
    work that it took.

    There is no choice where none costs as little, or none was found in time.

    Args:
        plan: with a region and a slab at least.
        less: mm, what it may cost at most.
        effort: units of the solver's work.
    """
    model = _Model(plan)
    model.reach()
    if isfinite(less):
        model.bound(less)
    spent, at_least = 0.0, plan.alien
    best: Choice | None = None
    for _ in range(_PARTINGS):
        solver = _solver(effort - spent)
        status = solver.solve(model.terms.model)
        spent += solver.response_proto.deterministic_time
        at_least = inf if status == cp_model.INFEASIBLE else model.mm(solver.best_objective_bound)
        if status not in FOUND:
            break
        filled = np.array([[bool(solver.value(x)) for x in row] for row in model.terms.filled])
        sunk = tuple(rim for rim, is_sunk in model.rims.items() if solver.value(is_sunk))
        # Bodies are paid for once they are seen: to hold a part together takes many constraints.
        parted = model.price_bodies(filled)
        best = Choice(plan, filled, sunk, model.mm(solver.objective_value) + parted, at_least)
        if not parted or spent >= effort:
            break
    return best, at_least, spent


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
        terms: with its objective.
        constant: mm that every choice costs.
        rims: of each end of each ring, whether it is sunk.
    """

    def __init__(self, plan: Plan) -> None:
        self.terms = terms = Terms(plan)
        add_evidence(terms)
        add_habits(terms)
        add_notes(terms)
        self.rims = add_rims(terms, rings_of(plan))
        add_bands(terms)
        self.constant = terms.fixed + plan.alien + _habit(plan)
        self._priced: set[frozenset[_Cell]] = set()
        terms.model.minimize(sum(terms.costs))

    def mm(self, objective: float) -> float:
        """What a choice costs by the value of the solver's objective."""
        return (objective / UNIT) * self.terms.plan.grid + self.constant

    def reach(self) -> None:
        """Let the part reach from its first level to its last one."""
        for k in {0, len(self.terms.plan.levels) - 2}:
            self.terms.model.add_bool_or([row[k] for row in self.terms.filled])

    def bound(self, less: float) -> None:
        """Let a choice cost so many mm at most."""
        most = floor((less - self.constant) / self.terms.plan.grid * UNIT)
        self.terms.model.add(sum(self.terms.costs) <= most)

    def price_bodies(self, filled: npt.NDArray[np.bool_]) -> float:
        """mm that the bodies of a choice cost beside the largest, if they cost nothing yet; from
        now on they do."""
        bodies = _bodies(filled, self.terms.neighbours)
        fresh = [
            frozenset(this_bodies)
            for this_bodies in bodies[1:]
            if frozenset(this_bodies) not in self._priced
        ]
        total = 0.0
        for items in fresh:
            self._priced.add(items)
            shadow = float(
                self.terms.plan.regions.areas[sorted({region for region, _ in items})].sum()
            )
            around = {cell for each in items for cell in self._next_to(each)} - items
            is_body = self.terms.model.new_bool_var("")
            inside = sum(1 - self.terms.filled[r][k] for r, k in items)
            outside = sum(self.terms.filled[r][k] for r, k in around)
            self.terms.model.add(inside + outside + is_body >= 1)
            self.terms.cost(_BODY * shadow**0.5, is_body)
            total += _BODY * shadow**0.5
        if fresh:
            self.terms.model.minimize(sum(self.terms.costs))
            self.terms.model.clear_hints()
            for row, entries in zip(self.terms.filled, filled, strict=True):
                for x, value in zip(row, entries, strict=True):
                    self.terms.model.add_hint(x, bool(value))
        return total

    def _next_to(self, cell: _Cell) -> set[_Cell]:
        region, slab = cell
        levels = {(region, k) for k in (slab - 1, slab + 1) if k in self.terms.plan.slabs}
        return levels | {(other, slab) for other in self.terms.neighbours[region]}


def _habit(plan: Plan) -> float:
    """mm that the holes across the slabs cost: most holes of a part are along its slabs' axis."""
    return sum(plan.grid + _CROSS * sqrt(pi) * hole.circle.radius for hole in plan.cross_holes)


def _bodies(filled: npt.NDArray[np.bool_], adjacent: Mapping[int, set[int]]) -> list[set[_Cell]]:
    """The filled cells as bodies, those of most cells first."""
    left = {(int(r), int(k)) for r, k in np.argwhere(filled)}
    found = []
    while left:
        waiting = [left.pop()]
        body = set(waiting)
        while waiting:
            region, slab = waiting.pop()
            near = {(region, slab - 1), (region, slab + 1), *((r, slab) for r in adjacent[region])}
            near &= left
            left -= near
            body |= near
            waiting += near
        found.append(body)
    return sorted(found, key=len, reverse=True)
