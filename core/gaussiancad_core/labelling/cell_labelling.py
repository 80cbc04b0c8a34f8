"""Which cells are material: a constraint problem, solved with CP-SAT.

Every cell is a Boolean.  Rules are hard first.  Where they contradict each other, those of the
least weight are given up: a weighted MaxSAT problem, solved by unsatisfiable cores.  Time is
deterministic, so that the same input ends at the same labels.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf

from ortools.sat.python import cp_model

from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.labelling.clauses import (
    SURFACES,
    Labels,
    Model,
    lighter,
    points,
    points_of,
)
from gaussiancad_core.labelling.counted_work import NEVER, Deadline
from gaussiancad_core.labelling.priors import Priors
from gaussiancad_core.labelling.solvers import FOUND, relaxing_solver, solver_for
from gaussiancad_core.labelling.visibility_rules import Rule, Says, holds

SLIGHT = 1.0
"""Units of line below which a rule is given up before anything else is.

The shortest pieces lie where curves nearly touch; there the point that stands for a piece may not
tell what is drawn on it.
"""

_STRATA = (SLIGHT, 8.0 * SLIGHT, inf)
"""Weights, in units of line, below which rules may be given up: little is tried first.

Most rules then are clauses that must hold, of which the solver makes far more.
"""

_TRADED = 0.5
"""Units of line that may be given up for fewer surfaces."""

_MUCH = 8.0 * SLIGHT
"""Units of line from which labels that give them up are wrong in more than a place."""

_IN_VAIN = 0.1
"""Share of the time in which the simplest of such labels are looked for."""

_MORE = 0.1
"""Share by which other labels may give up more than the best do."""


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
        effort: deterministic time that telling which rules to give up took.
        unusual: how unusual the labels are, in surfaces; None where nobody asked.
    """

    labels: Labels | None
    given_up: tuple[Rule, ...]
    complete: bool
    effort: float = field(default=0.0, compare=False)
    unusual: float | None = field(default=None, compare=False)


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
        is_proved: whether no others cost less that give up rules as light as these.
    """

    labels: Labels
    cost: int
    is_least: bool
    is_proved: bool


class Search:
    """Looks for labels under the rules of one part; the clauses are made once.

    Args:
        rules: of the part.
        effort: how long to look.
        usual: what is taken for usual where rules leave labels open.
    """

    def __init__(self, rules: Sequence[Rule], effort: Effort, usual: Priors | None = None) -> None:
        self._rules = tuple(rules)
        self._effort = effort
        self._usual = usual

    def best(self, deadline: Deadline = NEVER, *, relaxed: bool = True) -> Labelling:
        """Labels under which all rules hold, or, if ``relaxed``, all but the least."""
        found = self.fulfilled(deadline)
        return self.least(deadline) if found.labels is None and relaxed else found

    def fulfilled(self, deadline: Deadline = NEVER) -> Labelling:
        """Labels under which all rules hold; the simplest of them.

        Simple means few surfaces: of parts that look alike in all views, the drawn one is nearly
        always the one with the fewest.  There are none where the rules contradict each other.
        """
        solver = solver_for(self._effort.hard, self._effort.workers, deadline)
        status = solver.solve(self._strictly.model)
        if status in FOUND:
            return self._simplest(solver, deadline)
        return Labelling(None, (), status == cp_model.INFEASIBLE)

    def relaxed_linetypes(self, deadline: Deadline = NEVER) -> Labelling:
        """Labels under which all rules hold but for linetypes that nothing tells; as few of these
        as possible become the other one."""
        held = self._but_kinds
        if not held.given_up:
            return Labelling(None, (), False)
        solver = solver_for(self._effort.hard, self._effort.workers, deadline)
        if solver.solve(held.model) not in FOUND:
            return Labelling(None, (), False)
        first = held.labels(solver)
        held.hint(first)
        held.model.minimize(held.cost + held.surfaces)
        solver = solver_for(self._effort.hard, self._effort.workers, deadline)
        status = solver.solve(held.model)
        held.model.clear_objective()
        held.model.clear_hints()
        labels = held.labels(solver) if status in FOUND else first
        return Labelling(labels, _broken(self._rules, labels), status == cp_model.OPTIMAL)

    def contradict(self, but: Sequence[int], deadline: Deadline = NEVER) -> bool:
        """Whether rules contradict each other for certain, those of some numbers left out."""
        left_out = set(but)
        rules = [rule for number, rule in enumerate(self._rules) if number not in left_out]
        solver = solver_for(self._effort.hard, deadline=deadline)
        return solver.solve(Model(rules).model) == cp_model.INFEASIBLE

    def least(self, deadline: Deadline = NEVER) -> Labelling:
        """Labels that give up rules of the least weight, or of little where time is over."""
        best: _Given | None = None
        effort = 0.0
        for lightest in _STRATA:
            # The clauses alone take seconds.
            if not deadline.left:
                break
            # What weighs more than all that was given up is not given up for less.
            most = best.cost if best else inf
            found, spent = self._giving_up(lightest, deadline, most)
            effort += spent
            if found is not None and (best is None or found.cost <= best.cost):
                best = found
            if found is not None and found.cost <= SURFACES * 10.0 * lightest:
                # No rule that had to hold weighs less, so that there is no better choice.
                break
            if found is not None and not found.is_proved:
                # The more rules may be given up the longer it takes, and this took too long.
                break
        if best is None:
            return Labelling(None, (), False, effort)
        labels = self._simpler(best, deadline)
        return Labelling(labels, _broken(self._rules, labels), best.is_least, effort)

    def _giving_up(
        self, lightest: float, deadline: Deadline, most: float
    ) -> "tuple[_Given | None, float]":
        """The least that can be given up of rules below a weight and a cost, and the deterministic
        time that it took."""
        soft = Model(self._rules, lighter(lightest, most))
        soft.model.minimize(soft.cost)
        solver = relaxing_solver(self._effort.relaxed, deadline)
        status = solver.solve(soft.model)
        effort = float(solver.response_proto.deterministic_time)
        if status not in FOUND:
            return None, effort
        cost = round(solver.objective_value)
        is_proved = status == cp_model.OPTIMAL
        is_least = is_proved and cost <= SURFACES * 10.0 * lightest
        return _Given(soft.labels(solver), cost, is_least, is_proved), effort

    def _simpler(self, found: "_Given", deadline: Deadline) -> Labels:
        """Labels that give up hardly more, with few surfaces."""
        most = found.cost + SURFACES * points_of(_TRADED)
        soft = Model(self._rules, lighter(inf, most))
        soft.model.add(soft.cost <= most)
        soft.hint(found.labels)
        soft.model.minimize(soft.cost + soft.surfaces)
        much = found.cost > SURFACES * points_of(_MUCH)
        effort = self._effort.simplest * (_IN_VAIN if much else 1.0)
        solver = solver_for(effort, deadline=deadline)
        return soft.labels(solver) if solver.solve(soft.model) in FOUND else found.labels

    @cached_property
    def _strictly(self) -> Model:
        """Clauses of all rules, of which none may be given up."""
        return Model(self._rules)

    @cached_property
    def _unusual(self) -> cp_model.LinearExpr | int:
        """What is not usual, and surfaces."""
        surfaces = self._strictly.surfaces
        return surfaces if self._usual is None else surfaces + self._strictly.unusual(self._usual)

    @cached_property
    def _but_kinds(self) -> Model:
        """The same, but for linetypes that nothing tells."""
        return Model(self._rules, lambda rule: rule.says is Says.KIND)

    def _simplest(self, found: cp_model.CpSolver, deadline: Deadline) -> Labelling:
        """Of all labels under which the rules hold the most usual, with the fewest surfaces."""
        held = self._strictly
        first = held.labels(found)
        held.hint(first)
        if self._usual is None:
            held.model.minimize(held.surfaces)
            solver = solver_for(self._effort.simplest, self._effort.workers, deadline)
        else:
            # Nearly all that is usual holds together, which cores tell tens of times as fast.
            held.model.minimize(self._unusual)
            solver = relaxing_solver(self._effort.simplest, deadline)
        status = solver.solve(held.model)
        held.model.clear_objective()
        held.model.clear_hints()
        if status not in FOUND:
            return Labelling(first, (), True)
        unusual = solver.objective_value if self._usual is not None else None
        return Labelling(held.labels(solver), (), True, unusual=unusual)

    def others(
        self,
        found: Labelling,
        cells: Sequence[Cell],
        most: int,
        share: float = 1.0,
        deadline: Deadline = NEVER,
        *,
        likely: bool = False,
    ) -> Others:
        """Other labels that fulfil the rules as well as the found ones do, or nearly so.

        Args:
            found: labels; others may give up as much as they do, and a little more.
            cells: those that count: labels that differ in others only are the same.
            most: how many to look for.
            share: of the deterministic time of ``hard`` that it may take.
            deadline: of the search.
            likely: whether they are the next ones to the most usual, not any.
        """
        if found.labels is None or not most or not deadline.left:
            return Others((), False)
        if found.given_up and all(rule.says is Says.KIND for rule in found.given_up):
            held, relaxes = self._relaxing(found), False
        elif found.given_up:
            held, relaxes = self._within(found), True
        else:
            held, relaxes = self._strictly, False
            if likely and self._usual is not None:
                # What comes next to the most usual is what may have been meant.
                held.model.minimize(self._unusual)
                relaxes = True
        left = share * self._effort.hard
        known = set(held.cells)
        counting = [cell for cell in cells if cell in known and cell in found.labels]
        if not counting:
            return Others((), True)
        others: list[Labels] = []
        latest = found.labels
        while len(others) < most:
            held.forbid(latest, counting)
            solver = (relaxing_solver if relaxes else solver_for)(left, deadline=deadline)
            status = solver.solve(held.model)
            left -= solver.response_proto.deterministic_time
            if status == cp_model.INFEASIBLE:
                return Others(tuple(others), True)
            if status not in FOUND or left <= 0.0:
                break
            latest = held.labels(solver)
            others.append(latest)
        return Others(tuple(others), False)

    def _relaxing(self, found: Labelling) -> Model:
        """The clauses of all rules but linetypes that nothing tells, of which hardly more may be
        other ones than of the found labels; they can be used once."""
        held = self._but_kinds
        held.model.add(held.cost <= _hardly_more(found))
        return held

    def _within(self, found: Labelling) -> Model:
        """Clauses that give up little more than the found labels do."""
        most = _hardly_more(found)
        soft = Model(self._rules, lighter(inf, most))
        soft.model.add(soft.cost <= most)
        soft.model.minimize(soft.cost)
        return soft


def _hardly_more(found: Labelling) -> int:
    """The cost of what other labels may give up at most."""
    given_up = sum(points(rule) for rule in found.given_up)
    return SURFACES * round(given_up + max(_MORE * given_up, points_of(SLIGHT)))


def _broken(rules: Sequence[Rule], labels: Labels) -> tuple[Rule, ...]:
    return tuple(rule for rule in rules if not holds(rule, labels))
