"""Which cells are material: a constraint problem, solved with CP-SAT.

Every cell is a Boolean.  Rules are hard first.  Where they contradict each other, those of the
least weight are given up: a weighted MaxSAT problem, solved by unsatisfiable cores.  Time is
deterministic, so that the same input ends at the same labels.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf

from ortools.sat.python import cp_model

from gaussiancad_core.reasoning.columns import Cell
from gaussiancad_core.reasoning.rules import Group, Rule, Transition, drawn_under
from gaussiancad_core.reasoning.solvers import (
    FOUND,
    NEVER,
    Deadline,
    relaxing_solver,
    solver_for,
)
from gaussiancad_core.views import Linetype

SLIGHT = 1.0
"""Units of line below which a rule is given up before anything else is.

The shortest pieces lie where curves nearly touch; there the point that stands for a piece may not
tell what is drawn on it.
"""

_STRATA = (SLIGHT, 8.0 * SLIGHT, inf)
"""Weights, in units of line, below which rules may be given up: little is tried first.

Most rules then are clauses that must hold, of which the solver makes far more.
"""

_SURFACES = 10
"""Surfaces that weigh as much as a tenth of a unit of line that is given up."""

_TRADED = 0.5
"""Units of line that may be given up for fewer surfaces."""

_MORE = 0.1
"""Share by which other labels may give up more than the best do."""

_MORE_UNITS = 1.0
"""Units of line that they may give up more at least."""

Labels = dict[Cell, bool]
"""True is material."""


class Model:
    """Rules as clauses over the labels of cells.

    Args:
        rules: to be fulfilled.
        lightest: rules of a weight below this get a literal that gives them up.

    Attributes:
        cells: the Boolean of each cell.
        given_up: those literals, by the number of the rule.
    """

    def __init__(self, rules: Sequence[Rule], *, lightest: float = 0.0) -> None:
        self.model = cp_model.CpModel()
        self.cells: dict[Cell, cp_model.IntVar] = {}
        self.given_up: dict[int, cp_model.IntVar] = {}
        self._false = self.model.new_constant(0)
        self._different: dict[tuple[int, int], cp_model.IntVar] = {}
        self.surfaces: list[cp_model.IntVar] = []
        self._counted: set[tuple[int, int]] = set()
        for number, rule in enumerate(rules):
            escape: list[cp_model.IntVar] = []
            if rule.weight < lightest:
                escape = [self.model.new_bool_var("")]
                self.given_up[number] = escape[0]
            self._add(rule, escape)

        self.cost = sum(
            _SURFACES * _points(rules[number]) * escape for number, escape in self.given_up.items()
        )
        self._weights = {number: rules[number].weight for number in self.given_up}
        self._budget: cp_model.Constraint | None = None

    def allow(self, lightest: float) -> None:
        """Let only rules of a weight below this be given up."""
        for number, literal in self.given_up.items():
            literal.proto.domain[1] = int(self._weights[number] < lightest)

    def spend(self, most: int) -> None:
        """Let what is given up cost no more."""
        if self._budget is None:
            self._budget = self.model.add(self.cost <= most)
        else:
            self._budget.proto.linear.domain[1] = most

    def hint(self, labels: Labels) -> None:
        """Labels to start from."""
        self.model.clear_hints()
        for cell, literal in self.cells.items():
            self.model.add_hint(literal, labels.get(cell, False))

    def cell(self, cell: Cell | None) -> cp_model.IntVar:
        """The Boolean of a cell; void for None."""
        if cell is None:
            return self._false
        if cell not in self.cells:
            self.cells[cell] = self.model.new_bool_var("")
        return self.cells[cell]

    def _surface(self, transition: Transition) -> cp_model.IntVar:
        one, other = self.cell(transition[0]), self.cell(transition[1])
        literal = self._differ(one, other)
        key = min(one.index, other.index), max(one.index, other.index)
        if literal is not self._false and key not in self._counted:
            self._counted.add(key)
            self.surfaces.append(literal)
        return literal

    def _differ(self, one: cp_model.IntVar, other: cp_model.IntVar) -> cp_model.IntVar:
        if one is other:
            return self._false
        if one is self._false:
            return other
        if other is self._false:
            return one
        key = min(one.index, other.index), max(one.index, other.index)
        if key not in self._different:
            literal = self.model.new_bool_var("")
            self.model.add_bool_or([~literal, one, other])
            self.model.add_bool_or([~literal, ~one, ~other])
            self.model.add_bool_or([literal, ~one, other])
            self.model.add_bool_or([literal, one, ~other])
            self._different[key] = literal
        return self._different[key]

    def _discrepancies(self, group: Group) -> list[cp_model.IntVar]:
        found = []
        for one, other in group.pairs:
            literal = self._differ(self._surface(one), self._surface(other))
            if literal is not self._false:
                found.append(literal)
        for transition in group.lone:
            literal = self._surface(transition)
            if literal is not self._false:
                found.append(literal)
        return found

    def _add(self, rule: Rule, escape: list[cp_model.IntVar]) -> None:
        add = self.model.add_bool_or
        if rule.linetype is None:
            for group in rule.groups:
                for literal in self._discrepancies(group):
                    add([~literal, *escape])
            return
        covering: list[cp_model.IntVar] = []
        places: list[cp_model.IntVar] = []
        for group in rule.groups:
            literals = self._discrepancies(group)
            if literals:
                place = self.model.new_bool_var("")
                add([*literals, ~place])
                places.append(place)
                if rule.linetype is Linetype.VISIBLE:
                    for literal in covering:
                        self.model.add_implication(place, ~literal)
                else:
                    for literal in literals:
                        add([~literal, *covering, *escape])
            for transition in group.all:
                literal = self._surface(transition)
                if literal is not self._false and literal not in covering:
                    covering.append(literal)
        add([*places, *escape] or [self._false])

    def forbid(self, labels: Labels, cells: Sequence[Cell]) -> None:
        """Ask for labels that differ in at least one of some cells."""
        self.model.add_bool_or(
            [~self.cells[cell] if labels[cell] else self.cells[cell] for cell in cells]
        )

    def labels(self, solver: cp_model.CpSolver) -> Labels:
        """The labels of a solution."""
        return {cell: bool(solver.value(literal)) for cell, literal in self.cells.items()}


@dataclass(frozen=True)
class Effort:
    """How long to look.

    Attributes:
        hard: deterministic time for the hard problem, and for other labels.
        relaxed: for the least that has to be given up.
        simplest: for the labels with the fewest surfaces.
        workers: threads; more than one still ends at the same labels.
    """

    hard: float = 12.0
    relaxed: float = 6.0
    simplest: float = 5.0
    workers: int = 1


@dataclass(frozen=True)
class Labelling:
    """Labels, and what they leave unexplained.

    Attributes:
        labels: of the cells; None if there are none in time.
        given_up: rules that do not hold.
        complete: whether the search proved what it found: that the rules hold, or that no less can
            be given up.
    """

    labels: Labels | None
    given_up: tuple[Rule, ...]
    complete: bool


@dataclass(frozen=True)
class Others:
    """Further labels under which the same rules hold.

    Attributes:
        labels: each differs from all others in a cell that counts.
        complete: whether there are no more.
    """

    labels: tuple[Labels, ...]
    complete: bool


@dataclass(frozen=True)
class _Given:
    """Labels for which rules were given up.

    Attributes:
        labels: of the cells.
        cost: of those rules.
        is_least: whether no others cost less.
    """

    labels: Labels
    cost: int
    is_least: bool


class Search:
    """Looks for labels under the rules of one part; the clauses are made once.

    Args:
        rules: of the part.
        effort: how long to look.
    """

    def __init__(self, rules: Sequence[Rule], effort: Effort) -> None:
        self._rules = tuple(rules)
        self._effort = effort
        self._model = Model(rules, lightest=SLIGHT)

    def best(self, *, relaxed: bool = True) -> Labelling:
        """Labels under which all rules hold, or, if ``relaxed``, all but the least."""
        found = self.fulfilled()
        return self.least() if found.labels is None and relaxed else found

    def fulfilled(self, deadline: Deadline = NEVER) -> Labelling:
        """Labels under which all rules hold; the simplest of them.

        Simple means few surfaces: of parts that look alike in all views, the drawn one is nearly
        always the one with the fewest.  There are none where the rules contradict each other.
        """
        model = self._model.model
        model.add_assumptions([~escape for escape in self._model.given_up.values()])
        solver = solver_for(self._effort.hard, self._effort.workers, deadline)
        status = solver.solve(model)
        model.clear_assumptions()
        if status in FOUND:
            return self._simplest(solver, deadline)
        return Labelling(None, (), status == cp_model.INFEASIBLE)

    def least(self, deadline: Deadline = NEVER) -> Labelling:
        """Labels that give up rules of the least weight, or of little where time is over."""
        best: _Given | None = None
        for lightest in _STRATA:
            # The clauses alone take seconds.
            if not deadline.left:
                break
            found = self._giving_up(lightest, deadline)
            if found is not None and (best is None or found.cost <= best.cost):
                best = found
            if found is not None and found.cost <= _SURFACES * 10.0 * lightest:
                # No rule that had to hold weighs less, so that there is no better choice.
                break
        if best is None:
            return Labelling(None, (), False)
        labels = self._simpler(best, deadline)
        return Labelling(labels, _broken(self._rules, labels), best.is_least)

    def _giving_up(self, lightest: float, deadline: Deadline) -> "_Given | None":
        """The least that can be given up of rules below a weight."""
        soft = self._softly
        soft.allow(lightest)
        soft.model.minimize(soft.cost)
        solver = relaxing_solver(self._effort.relaxed, deadline)
        status = solver.solve(soft.model)
        if status not in FOUND:
            return None
        cost = round(solver.objective_value)
        return _Given(
            soft.labels(solver),
            cost,
            status == cp_model.OPTIMAL and cost <= _SURFACES * 10.0 * lightest,
        )

    def _simpler(self, found: "_Given", deadline: Deadline) -> Labels:
        """Labels that give up hardly more, with few surfaces."""
        soft = self._softly
        soft.spend(found.cost + _SURFACES * _points_of(_TRADED))
        soft.hint(found.labels)
        soft.model.minimize(soft.cost + sum(soft.surfaces))
        solver = solver_for(self._effort.simplest, deadline=deadline)
        return soft.labels(solver) if solver.solve(soft.model) in FOUND else found.labels

    @cached_property
    def _softly(self) -> Model:
        """Clauses that may all be given up."""
        return Model(self._rules, lightest=inf)

    def _simplest(self, found: cp_model.CpSolver, deadline: Deadline) -> Labelling:
        """Of all labels under which the rules hold those with the fewest surfaces."""
        model = self._model.model
        first = self._model.labels(found)
        self._model.hint(first)
        model.add_assumptions([~escape for escape in self._model.given_up.values()])
        model.minimize(sum(self._model.surfaces))
        solver = solver_for(self._effort.simplest, self._effort.workers, deadline)
        status = solver.solve(model)
        model.clear_objective()
        model.clear_hints()
        model.clear_assumptions()
        return Labelling(self._model.labels(solver) if status in FOUND else first, (), True)

    def others(
        self,
        found: Labelling,
        cells: Sequence[Cell],
        most: int,
        share: float = 1.0,
        deadline: Deadline = NEVER,
    ) -> Others:
        """Other labels that fulfil the rules as well as the found ones do, or nearly so.

        Args:
            found: labels; others may give up as much as they do, and a little more.
            cells: those that count: labels that differ in others only are the same.
            most: how many to look for.
            share: of the deterministic time of ``hard`` that it may take.
            deadline: of the search.
        """
        if found.labels is None or not deadline.left:
            return Others((), False)
        if found.given_up:
            held, solver_of = self._within(found), relaxing_solver
        else:
            held, solver_of = self._strict(), solver_for
        left = share * self._effort.hard
        counting = [cell for cell in cells if cell in held.cells and cell in found.labels]
        if not counting:
            return Others((), True)
        others: list[Labels] = []
        latest = found.labels
        while len(others) < most:
            held.forbid(latest, counting)
            solver = solver_of(left, deadline=deadline)
            status = solver.solve(held.model)
            left -= solver.response_proto.deterministic_time
            if status == cp_model.INFEASIBLE:
                return Others(tuple(others), True)
            if status not in FOUND or left <= 0.0:
                break
            latest = held.labels(solver)
            others.append(latest)
        return Others(tuple(others), False)

    def _strict(self) -> Model:
        """The clauses of all rules; they can be used once."""
        for escape in self._model.given_up.values():
            self._model.model.add(escape == 0)
        return self._model

    def _within(self, found: Labelling) -> Model:
        """Clauses that give up little more than the found labels do; they can be used once."""
        soft = self._softly
        given_up = sum(_points(rule) for rule in found.given_up)
        more = max(_MORE * given_up, _points_of(_MORE_UNITS))
        soft.allow(inf)
        soft.spend(_SURFACES * round(given_up + more))
        soft.model.clear_hints()
        soft.model.minimize(soft.cost)
        return soft


def _points(rule: Rule) -> int:
    return _points_of(rule.weight)


def _points_of(weight: float) -> int:
    return max(1, round(10.0 * weight))


def _broken(rules: Sequence[Rule], labels: Labels) -> tuple[Rule, ...]:
    return tuple(rule for rule in rules if drawn_under(rule, labels) is not rule.linetype)
