"""All labels of a part's cells, enumerated without a solver, beside what the search claims.

Rules of lines that are blank are linear equations over bits: each surface that both columns pass
is there on both sides, or on neither.  Eliminated, they leave a few free bits, all of whose values
are tried; the other rules are asked one by one, for all that is left at once.
"""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from benchmarks.parts.twin_parts import FAMILIES, twins
from benchmarks.run.workers import Row
from benchmarks.sheets.sheet_policies import POLICIES, readings
from benchmarks.verified.verified_sources import Page, part_shape
from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.evidence.projected_reading import drawn_views
from gaussiancad_core.labelling.cell_labelling import Effort, Search
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.labelling.visibility_rules import Rule, Says, Transition, holds
from gaussiancad_core.model.views import Linetype

MOST_FREE = 20
"""Bits up to which all values are tried."""

_COUNTING = 0.15
"""Units of thickness from which a cell makes a different solid."""

_MOST_OTHERS = 8
"""Other labels that the search is asked for."""

_ASKED = 40
"""Labels, of those that are left and of others, for which the rules are asked one by one again."""

Numbers = npt.NDArray[np.int64]
Bools = npt.NDArray[np.bool_]


def cell_cases(kind: str, seed: int) -> Iterator[Row]:
    """Parts of a family or class, under a policy by lot; those with too many free bits say so."""
    lot = np.random.default_rng([seed, *kind.encode()])
    shape = twins(kind, seed)[0] if kind in FAMILIES else part_shape(kind, seed)
    page = Page(shape)
    policies = [item for item in POLICIES if item.stated]
    for policy in (POLICIES[0], policies[int(lot.integers(1, len(policies)))]):
        entry, _ = readings(page.drawn(policy), page.size, policy)
        part = model_part(drawn_views(entry.registered, ()))
        yield {"policy": policy.name, **compared(part, lot)}


def compared(part: PartModel, lot: np.random.Generator) -> Row:
    """What the search claims of a part's labels, beside all that there are.

    Returns:
        ``free`` bits; ``fits``, how many labels that differ in cells that count fulfil all rules;
        ``claimed`` by the search; ``why`` these differ.  Of too many bits nothing but ``free``.
    """
    space = Labels(part.rules)
    row: Row = {"free": space.free, "cells": len(space.cells), "rules": len(part.rules)}
    if space.free > MOST_FREE:
        return row
    left = space.fulfilling(part.rules)
    thickness = part.space.thickness()
    counting = [cell for cell in space.cells if thickness.get(cell, 0.0) > _COUNTING]
    fits = space.distinct(left, counting)
    search = Search(part.rules, Effort())
    found = search.fulfilled()
    claimed, complete = 0, found.complete
    if found.labels is not None:
        counted = [cell for cell, units in thickness.items() if units > _COUNTING]
        others = search.others(found, counted, _MOST_OTHERS)
        claimed, complete = 1 + len(others.labels), others.complete
    row |= {"fits": fits, "claimed": claimed, "complete": complete}
    why = ""
    if not space.agree(part.rules, left, lot):
        why = "the rules say otherwise when asked one by one"
    elif (complete and fits != claimed) or fits < claimed:
        why = f"{fits} labels fulfil the rules, {claimed} are claimed"
    return {**row, "why": why}


class Labels:
    """All labels of the cells of some rules under which those of blank lines hold.

    Args:
        rules: of a part.

    Attributes:
        cells: that rules speak of.
        free: bits that tell the labels.
    """

    def __init__(self, rules: Sequence[Rule]) -> None:
        self.cells = tuple(dict.fromkeys(cell for rule in rules for cell in _cells(rule)))
        index = {cell: number for number, cell in enumerate(self.cells)}
        masks = self._solved(rules, index)
        self.free = len({bit for mask in masks for bit in _bits(mask)})
        order = {bit: n for n, bit in enumerate(sorted({b for m in masks for b in _bits(m)}))}
        self._masks = {
            cell: sum(1 << order[bit] for bit in _bits(masks[number]))
            for cell, number in index.items()
        }

    @staticmethod
    def _solved(rules: Sequence[Rule], index: dict[Cell, int]) -> list[int]:
        """Of each cell the free cells, as bits, of which it is the sum."""
        equations = {
            this_equation
            for rule in rules
            if _is_blank(rule)
            for this_equation in _equations(rule, index)
        }
        pivots: dict[int, int] = {}
        for equation in sorted(equations, key=int.bit_count):
            left = equation
            while left and (top := left.bit_length() - 1) in pivots:
                left ^= pivots[top]
            if left:
                pivots[left.bit_length() - 1] = left
        masks: list[int] = []
        for number in range(len(index)):
            # A pivot is the sum of cells with lower numbers, whose sums are known.
            item = pivots.get(number)
            mask = 1 << number if item is None else 0
            for bit in _bits(item ^ (1 << number)) if item is not None else ():
                mask ^= masks[bit]
            masks.append(mask)
        return masks

    def fulfilling(self, rules: Sequence[Rule]) -> Numbers:
        """(k,) values of the free bits under which all rules hold."""
        left = np.arange(1 << self.free)
        drawn = [rule for rule in rules if not _is_blank(rule)]
        for rule in sorted(drawn, key=lambda item: len(set(_cells(item)))):
            left = left[self._holds(rule, left)]
        return left

    def distinct(self, left: Numbers, counting: Iterable[Cell]) -> int:
        """How many of some labels differ in cells that count."""
        columns = [self._label(cell, left) for cell in counting]
        if not len(left) or not columns:
            return min(len(left), 1)
        return len(np.unique(np.packbits(np.array(columns), axis=0), axis=1).T)

    def agree(self, rules: Sequence[Rule], left: Numbers, lot: np.random.Generator) -> bool:
        """Whether the engine's own reading of the rules is the same, for some labels by lot."""
        kept = set(left.tolist())
        asked = set(lot.choice(left, _ASKED).tolist()) if len(left) else set()
        asked |= set(lot.integers(0, 1 << self.free, _ASKED).tolist())
        for number in asked:
            bits = np.array([number])
            labels = {cell: bool(self._label(cell, bits)[0]) for cell in self.cells}
            if all(holds(rule, labels) for rule in rules) != (number in kept):
                return False
        return True

    def _label(self, cell: Cell | None, left: Numbers) -> Bools:
        mask = 0 if cell is None else self._masks[cell]
        return (np.bitwise_count(left & mask) & 1).astype(bool)

    def _holds(self, rule: Rule, left: Numbers) -> Bools:
        """Whether a rule that is no blank line's holds under labels."""
        drawn = np.zeros(len(left), np.uint8)
        covered = np.zeros(len(left), bool)
        for group in rule.groups:
            surface = {item: self._surface(item, left) for item in group.all}
            differs = np.zeros(len(left), bool)
            for one, other in group.pairs:
                differs |= surface[one] != surface[other]
            for entry in group.lone:
                differs |= surface[entry]
            first = differs & (drawn == 0)
            drawn[first & ~covered], drawn[first & covered] = 1, 2
            for element in surface.values():
                covered = covered | element
        if rule.says is Says.DRAWN:
            return drawn != 0
        return drawn == (1 if rule.linetype is Linetype.VISIBLE else 2)

    def _surface(self, transition: Transition, left: Numbers) -> Bools:
        return self._label(transition[0], left) != self._label(transition[1], left)


def _is_blank(rule: Rule) -> bool:
    return rule.linetype is None


def _cells(rule: Rule) -> Iterator[Cell]:
    for group in rule.groups:
        for item in group.all:
            yield from (cell for cell in item if cell is not None)


def _equations(rule: Rule, index: dict[Cell, int]) -> Iterator[int]:
    """What a blank line asks for: sums of cells that are nothing, as bits."""
    for group in rule.groups:
        for one, other in group.pairs:
            yield _sum(one, index) ^ _sum(other, index)
        for item in group.lone:
            yield _sum(item, index)


def _sum(transition: Transition, index: dict[Cell, int]) -> int:
    total = 0
    for cell in transition:
        total ^= 0 if cell is None else 1 << index[cell]
    return total


def _bits(mask: int) -> Iterator[int]:
    while mask:
        low = mask & -mask
        yield low.bit_length() - 1
        mask ^= low
