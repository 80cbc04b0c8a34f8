"""Labels of cells that the lines say nothing, or hardly anything, about.

Slim cells between surfaces that nearly touch have no piece of a line beside them, or leave the
choice.  Their labels follow from what surrounds them: a surface that is one of the part's elsewhere
goes on being one, and one that is none goes on being none.
"""

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from math import log

from gaussiancad_core.cells.cell_complex import Cell, CellComplex, Surface
from gaussiancad_core.labelling.clauses import Labels
from gaussiancad_core.labelling.visibility_rules import Rule, holds

_ROUNDS = 3
"""Times that slim cells are looked at: the labels of neighbours may change."""

Neighbours = Mapping[Cell, Sequence[tuple[Cell | None, Surface]]]
"""Of each cell those that columns enter from it, or leave into it, and through which surface."""


def with_unconstrained(
    space: CellComplex, rules: Sequence[Rule], labels: Labels, thickest: float
) -> Labels:
    """Labels for all cells; slim ones changed where all rules hold that held before.

    Args:
        space: the cells.
        rules: what the views say about them.
        labels: of the cells that rules speak of.
        thickest: units of thickness below which a cell that has a label may get another one.
    """
    neighbours = _neighbours(space)
    found = dict(labels)
    left = sorted(cell for cell in neighbours if cell not in found)
    thickness = space.thickness()
    slim = [cell for cell, units in thickness.items() if units < thickest and cell in labels]
    if not left and not slim:
        return found
    odds = _odds(neighbours, found)
    while left:
        known = {c: sum(o is None or o in found for o, _ in neighbours[c]) for c in left}
        cell = max(left, key=lambda c: known[c] / len(neighbours[c]))
        found[cell] = _evidence(neighbours[cell], found, odds) > 0.0
        left.remove(cell)
    said: dict[Cell, list[Rule]] = defaultdict(list)
    chosen = set(slim)
    for rule in rules:
        for cell in {c for group in rule.groups for t in group.all for c in t if c in chosen}:
            said[cell].append(rule)
    for _ in range(_ROUNDS):
        changed = False
        for cell in sorted(slim):
            likely = _evidence(neighbours[cell], found, odds) > 0.0
            if likely != found[cell] and _may_be(cell, likely, found, said[cell]):
                found[cell] = likely
                changed = True
        if not changed:
            break
    return found


def _neighbours(space: CellComplex) -> Neighbours:
    found: dict[Cell, dict[tuple[Cell | None, Surface], None]] = defaultdict(dict)
    for one, other, surface in space.crossed():
        if one is not None:
            found[one][other, surface] = None
        if other is not None:
            found[other][one, surface] = None
    return {cell: tuple(entry) for cell, entry in found.items()}


def _odds(neighbours: Neighbours, labels: Labels) -> dict[Surface, float]:
    """Of each surface the logarithm of the odds that it is one of the part's."""
    there: Counter[Surface] = Counter()
    met: Counter[Surface] = Counter()
    for cell, this_neighbours in neighbours.items():
        for other, surface in this_neighbours:
            if cell in labels and (other is None or other in labels):
                met[surface] += 1
                there[surface] += labels[cell] != (other is not None and labels[other])
    return {s: log((there[s] + 1.0) / (met[s] - there[s] + 1.0)) for s in met}


def _evidence(
    neighbours: Sequence[tuple[Cell | None, Surface]],
    labels: Labels,
    odds: Mapping[Surface, float],
) -> float:
    """How much speaks for material: surfaces of the part towards void, others towards material."""
    found = 0.0
    for other, surface in neighbours:
        if other is None or other in labels:
            solid = other is not None and labels[other]
            found += odds.get(surface, 0.0) * (-1.0 if solid else 1.0)
    return found


def _may_be(cell: Cell, label: bool, labels: Labels, rules: Sequence[Rule]) -> bool:
    """Whether no rule about a cell that holds would be broken by its other label."""
    changed = {**labels, cell: label}
    return all(holds(rule, changed) or not holds(rule, labels) for rule in rules)
