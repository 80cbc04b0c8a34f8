"""Rules as clauses over the Booleans of equivalence classes, for CP-SAT."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from math import inf

from ortools.sat.python import cp_model

from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.labelling.equivalence_classes import (
    Form,
    Look,
    NormalisedConstraint,
    NormalisedConstraints,
    find_blocks,
    independent,
)
from gaussiancad_core.labelling.priors import BLIND, LOOSE, NOTED, NOWHERE, ROUND, UNSEEN, Priors
from gaussiancad_core.labelling.visibility_rules import Rule

SURFACES = 10
"""Surfaces that weigh as much as a tenth of a unit of line that is given up."""

Labels = dict[Cell, bool]
"""True is material."""

_UNCOVERED = 0
"""Number of the literal of what nothing lies before."""

Cost = tuple[cp_model.IntVar, int]
"""A literal, and what it costs in surfaces."""

Chosen = Callable[[Rule], bool]
"""Tells some rules from others."""


def none(_: Rule) -> bool:
    """No rule."""
    return False


def every(_: Rule) -> bool:
    """Any rule."""
    return True


def lighter(lightest: float, most: float = inf) -> Chosen:
    """Rules of a weight below one, and of a cost of at most so much."""
    return lambda rule: rule.weight < lightest and SURFACES * points(rule) <= most


class Model:
    """Rules as clauses over the labels of cells.

    Rules that have to hold and say that nothing is drawn are solved beforehand: there are Booleans
    of free cells only (see :mod:`gaussiancad_core.labelling.equivalence_classes`).

    Args:
        rules: to be fulfilled.
        giveable: those that may be given up.

    Attributes:
        model: CP-SAT's.
        given_up: literals that give up rules, by the number of the rule.  Rules that say the same
            share one; those that hold in any case, or say what another one says that has to hold,
            have none.
        cost: of what is given up, ``SURFACES`` for a tenth of a unit of line.
    """

    def __init__(self, rules: Sequence[Rule], giveable: Chosen = none) -> None:
        self.model = cp_model.CpModel()
        self.given_up: dict[int, cp_model.IntVar] = {}
        may_go = [giveable(rule) for rule in rules]
        self._blocks = find_blocks(rules, lambda rule: not giveable(rule))
        self._free = [self.model.new_bool_var("") for _ in self._blocks.free]
        self._false = self.model.new_constant(0)
        self._literals: dict[Form, cp_model.IntVar] = {0: self._false}
        self._literals.update((1 << k, literal) for k, literal in enumerate(self._free))
        # By the depths that are nearer, whether something there is the part's.
        self._covers = [self._false]
        self._behind: dict[tuple[int, tuple[Form, ...]], int] = {}
        self._voids: dict[tuple[Cell, ...], cp_model.IntVar] = {}
        sayings = NormalisedConstraints(self._blocks)
        stated: dict[NormalisedConstraint, list[int]] = {}
        for number, rule in enumerate(rules):
            stated.setdefault(sayings.of(rule), []).append(number)
        escapes: list[cp_model.IntVar] = []
        costs: list[int] = []
        # Literals of differences are those of drawn lines: blank ones need none.
        for said, numbers in sorted(stated.items(), key=lambda pair: pair[0].look is Look.BLANK):
            if said.is_trivial:
                continue
            escape: list[cp_model.IntVar] = []
            if all(may_go[number] for number in numbers):
                escape = [self.model.new_bool_var("")]
                self.given_up.update((number, escape[0]) for number in numbers)
                escapes += escape
                costs.append(SURFACES * sum(points(rules[number]) for number in numbers))
            self._add(said, escape)
        self.cost = cp_model.LinearExpr.weighted_sum(escapes, costs)

    @property
    def cells(self) -> list[Cell]:
        """Those that have labels."""
        return [cell for cell in self._blocks.forms if cell is not None]

    @cached_property
    def surfaces(self) -> cp_model.LinearExpr | int:
        """How many pairs of neighbours differ."""
        counts = self._blocks.surfaces
        literals = [self._literal(form) for form in counts]
        return cp_model.LinearExpr.weighted_sum(literals, list(counts.values()))

    def unusual(self, usual: Priors) -> cp_model.LinearExpr | int:
        """What is not usual, in surfaces."""
        costs = [
            *self._holes_and_voids(usual),
            *self._undrawn(usual),
            *self._unlike(usual),
            *self._not_as_noted(usual),
        ]
        literals, weights = zip(*costs, strict=True) if costs else ((), ())
        return cp_model.LinearExpr.weighted_sum(literals, weights)

    def _holes_and_voids(self, usual: Priors) -> Iterator[Cost]:
        """Holes that do not go through, and voids by what is seen of them."""
        forms = self._blocks.forms
        open_to: defaultdict[Cell, dict[int, cp_model.IntVar]] = defaultdict(dict)
        through: defaultdict[Cell, list[cp_model.IntVar]] = defaultdict(list)
        for hole in usual.holes:
            whole = self._all_void((*hole.cells, *hole.within))
            solid = [self._literal(forms[cell]) for cell in hole.cells if cell in forms]
            if hole.within:
                yield self._unless([whole, *solid]), LOOSE
            if hole.cells[0] in forms:
                yield self._unless([whole, solid[0]]), BLIND + len(hole.cells)
            for cell in hole.cells:
                through[cell].append(whole)
        for cells in usual.sights:
            for last in range(1, len(cells) + 1):
                literal = self._all_void(cells[:last])
                open_to[cells[last - 1]][literal.index] = literal
        for cell, seen in open_to.items():
            if cell not in forms:
                continue
            filled = self._literal(forms[cell])
            usually: list[cp_model.LiteralT] = [filled]
            if cell in usual.corners:
                beyond = forms.get(usual.corners[cell], 0)
                usually.append(~self._literal(beyond))
                if cell in usual.squares:
                    yield self._unless([~filled, self._literal(beyond)]), ROUND
            yield self._unless([*usually, *seen.values()]), UNSEEN
            yield self._unless([*usually, *through[cell]]), usual.bulks.get(cell, 1)

    def _undrawn(self, usual: Priors) -> Iterator[Cost]:
        """Surfaces whose trace no view draws."""
        forms = self._blocks.forms
        for pairs in usual.undrawn:
            found = {forms[a] ^ forms[b] for a, b in pairs if a in forms and b in forms} - {0}
            if found:
                used = self.model.new_bool_var("")
                for form in sorted(found):
                    self.model.add_implication(self._literal(form), used)
                yield used, NOWHERE

    def _unlike(self, usual: Priors) -> Iterator[Cost]:
        """Mirror images that are not alike."""
        forms = self._blocks.forms
        for one, other, weight in usual.mirrored:
            if one in forms and other in forms:
                yield self._literal(forms[one] ^ forms[other]), weight

    def _not_as_noted(self, usual: Priors) -> Iterator[Cost]:
        """Holes that are not as their notes say."""
        forms = self._blocks.forms
        for ways in usual.noted:
            kept = []
            for way in ways:
                chosen = self.model.new_bool_var("")
                for cell in way.void:
                    if cell in forms:
                        self.model.add_implication(chosen, ~self._literal(forms[cell]))
                for cell in way.solid:
                    solid = self._literal(forms[cell]) if cell in forms else self._false
                    self.model.add_implication(chosen, solid)
                kept.append(chosen)
            yield self._unless(kept), NOTED

    def _unless(self, literals: Sequence[cp_model.LiteralT]) -> cp_model.IntVar:
        """A literal that is true where none of some is."""
        found = self.model.new_bool_var("")
        self.model.add_bool_or([found, *literals])
        return found

    def _all_void(self, cells: tuple[Cell, ...]) -> cp_model.IntVar:
        """A literal that is true only where cells are void; those of which no rule speaks are."""
        found = self._voids.get(cells)
        if found is None:
            found = self._voids[cells] = self.model.new_bool_var("")
            if len(cells) > 1:
                self.model.add_implication(found, self._all_void(cells[:-1]))
            form = self._blocks.forms.get(cells[-1])
            if form is not None:
                self.model.add_implication(found, ~self._literal(form))
        return found

    def hint(self, labels: Labels) -> None:
        """Labels to start from."""
        self.model.clear_hints()
        for cell, literal in zip(self._blocks.free, self._free, strict=True):
            self.model.add_hint(literal, labels.get(cell, False))

    def forbid(self, labels: Labels, cells: Sequence[Cell]) -> None:
        """Ask for labels that differ in at least one of some cells."""
        forms = self._blocks.forms
        stated = {forms[cell]: labels[cell] for cell in cells}
        self.model.add_bool_or(
            [
                ~self._literal(form) if stated[form] else self._literal(form)
                for form in independent(stated)
            ]
        )

    def labels(self, solver: cp_model.CpSolver) -> Labels:
        """The labels of a solution."""
        chosen = sum(solver.boolean_value(literal) << k for k, literal in enumerate(self._free))
        return {
            cell: (form & chosen).bit_count() % 2 == 1
            for cell, form in self._blocks.forms.items()
            if cell is not None
        }

    def _literal(self, form: Form) -> cp_model.IntVar:
        """Which is true where a form is 1."""
        found = self._literals.get(form)
        if found is None:
            halves = self._blocks.halves.get(form)
            if halves is None:
                return self._summed(form)
            one, other = halves
            found = self._literals[form] = self._differ(self._literal(one), self._literal(other))
        return found

    def _summed(self, form: Form) -> cp_model.IntVar:
        """The same, made up of free cells."""
        found = self._literals.get(form)
        if found is None:
            last = 1 << form.bit_length() - 1
            rest = self._summed(form ^ last)
            found = self._literals[form] = self._differ(rest, self._literals[last])
        return found

    def _differ(self, one: cp_model.IntVar, other: cp_model.IntVar) -> cp_model.IntVar:
        literal = self.model.new_bool_var("")
        self.model.add_bool_or([~literal, one, other])
        self.model.add_bool_or([~literal, ~one, ~other])
        self.model.add_bool_or([literal, ~one, other])
        self.model.add_bool_or([literal, one, ~other])
        return literal

    def _add(self, said: NormalisedConstraint, escape: list[cp_model.IntVar]) -> None:
        add = self.model.add_bool_or
        if said.look is Look.BLANK:
            for place in said.places:
                for form in place.differs:
                    self._add_void(form, escape)
            return
        if said.look is Look.DRAWN:
            either = [self._literal(form) for place in said.places for form in place.differs]
            add([*either, *escape] or [self._false])
            return
        covered = _UNCOVERED
        seen: list[cp_model.IntVar] = []
        for place in said.places:
            literals = [self._literal(form) for form in place.differs]
            cover = self._covers[covered]
            if said.look in (Look.HIDDEN, Look.UNSEEN):
                for literal in literals:
                    add([~literal, cover, *escape])
            if literals and said.look is not Look.UNSEEN:
                here = self.model.new_bool_var("")
                add([*literals, ~here])
                seen.append(here)
                if said.look is Look.VISIBLE and covered != _UNCOVERED:
                    self.model.add_implication(here, ~cover)
            if place.covers:
                covered = self._covered(covered, place.covers)
        if said.look is not Look.UNSEEN:
            add([*seen, *escape] or [self._false])

    def _add_void(self, form: Form, escape: list[cp_model.IntVar]) -> None:
        """Ask for a form to be 0, without a literal of its own."""
        halves = None if form in self._literals else self._blocks.halves.get(form)
        if halves is None:
            self.model.add_bool_or([~self._literal(form), *escape])
            return
        one, other = map(self._literal, halves)
        self.model.add_bool_or([~one, other, *escape])
        self.model.add_bool_or([one, ~other, *escape])

    def _covered(self, before: int, covers: tuple[Form, ...]) -> int:
        """Number of the literal that tells whether one of these forms is 1, or that of a number is
        true; rules whose nearest depths are the same share it."""
        number = self._behind.get((before, covers))
        if number is None:
            either = [self._literal(form) for form in covers]
            if before != _UNCOVERED:
                either.append(self._covers[before])
            cover = either[0]
            if len(either) > 1:
                cover = self.model.new_bool_var("")
                self.model.add_bool_or([*either, ~cover])
                for literal in either:
                    self.model.add_implication(literal, cover)
            number = self._behind[before, covers] = len(self._covers)
            self._covers.append(cover)
        return number


def points(rule: Rule) -> int:
    """The weight of a rule in tenths of a unit."""
    return points_of(rule.weight)


def points_of(weight: float) -> int:
    """A weight in tenths of a unit of line, at least one."""
    return max(1, round(10.0 * weight))
