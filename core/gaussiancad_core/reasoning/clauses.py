"""Rules as clauses over the Booleans of cells, for CP-SAT."""

from collections.abc import Iterable, Sequence

from ortools.sat.python import cp_model

from gaussiancad_core.reasoning.columns import Cell
from gaussiancad_core.reasoning.rules import Group, Rule, Says, Transition
from gaussiancad_core.views import Linetype

SURFACES = 10
"""Surfaces that weigh as much as a tenth of a unit of line that is given up."""

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
        # By the identities of literals, which are all kept: their indices take long to look up.
        self._different: dict[tuple[int, int], cp_model.IntVar] = {}
        self._surfaces: dict[Transition, cp_model.IntVar] = {}
        self.surfaces: list[cp_model.IntVar] = []
        self._counted: set[int] = set()
        for number, rule in enumerate(rules):
            escape: list[cp_model.IntVar] = []
            if rule.weight < lightest:
                escape = [self.model.new_bool_var("")]
                self.given_up[number] = escape[0]
            self._add(rule, escape)

        self.cost = sum(
            SURFACES * points(rules[number]) * escape for number, escape in self.given_up.items()
        )
        self._weights = {number: rules[number].weight for number in self.given_up}
        self._budget: cp_model.Constraint | None = None

    def allow(self, lightest: float) -> None:
        """Let only rules of a weight below this be given up."""
        self.allow_only([n for n, weight in self._weights.items() if weight < lightest])

    def allow_only(self, numbers: Iterable[int]) -> None:
        """Let only the rules of these numbers be given up."""
        chosen = set(numbers)
        for number, literal in self.given_up.items():
            literal.proto.domain[1] = int(number in chosen)

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
        literal = self._surfaces.get(transition)
        if literal is None:
            literal = self._differ(self.cell(transition[0]), self.cell(transition[1]))
            self._surfaces[transition] = literal
            if literal is not self._false and id(literal) not in self._counted:
                self._counted.add(id(literal))
                self.surfaces.append(literal)
        return literal

    def _differ(self, one: cp_model.IntVar, other: cp_model.IntVar) -> cp_model.IntVar:
        if one is other:
            return self._false
        if one is self._false:
            return other
        if other is self._false:
            return one
        key = id(one), id(other)
        literal = self._different.get(key)
        if literal is None:
            literal = self.model.new_bool_var("")
            self.model.add_bool_or([~literal, one, other])
            self.model.add_bool_or([~literal, ~one, ~other])
            self.model.add_bool_or([literal, ~one, other])
            self.model.add_bool_or([literal, one, ~other])
            self._different[key] = self._different[key[::-1]] = literal
        return literal

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
        if rule.says is Says.DRAWN:
            either = [d for group in rule.groups for d in self._discrepancies(group)]
            add([*either, *escape] or [self._false])
            return
        covering: dict[int, cp_model.IntVar] = {}
        places: list[cp_model.IntVar] = []
        for group in rule.groups:
            literals = self._discrepancies(group)
            if literals:
                place = self.model.new_bool_var("")
                add([*literals, ~place])
                places.append(place)
                if rule.linetype is Linetype.VISIBLE:
                    for literal in covering.values():
                        self.model.add_implication(place, ~literal)
                else:
                    for literal in literals:
                        add([~literal, *covering.values(), *escape])
            for transition in group.all:
                literal = self._surface(transition)
                if literal is not self._false:
                    covering[id(literal)] = literal
        add([*places, *escape] or [self._false])

    def forbid(self, labels: Labels, cells: Sequence[Cell]) -> None:
        """Ask for labels that differ in at least one of some cells."""
        self.model.add_bool_or(
            [~self.cells[cell] if labels[cell] else self.cells[cell] for cell in cells]
        )

    def labels(self, solver: cp_model.CpSolver) -> Labels:
        """The labels of a solution."""
        return {cell: bool(solver.value(literal)) for cell, literal in self.cells.items()}


def points(rule: Rule) -> int:
    """The weight of a rule in tenths of a unit."""
    return points_of(rule.weight)


def points_of(weight: float) -> int:
    """A weight in tenths of a unit of line, at least one."""
    return max(1, round(10.0 * weight))
