"""What lines say: each mm costs that is left unexplained, or would show where none is drawn."""

from collections.abc import Iterable

import numpy as np

from gaussiancad_core.sketch.plan_regions import OUTSIDE, Border
from gaussiancad_core.sketch.slab_sights import Sights
from gaussiancad_core.sketch.slab_terms import Expression, Terms

_UPRIGHT_SEEN, _UPRIGHT_DRAWN = 0.7, 0.35
"""What a mm costs of line along the axis that is seen but not drawn, and drawn but not seen: round
walls show none, and edges between faces of one slab are drawn too."""

HIDDEN, _HIDDEN_UPRIGHT = 0.5, 0.35
"""What a mm of hidden line costs, across the axis and along it."""

_KIND = 0.5
"""Share of what a line costs that is seen but not drawn, where it is drawn as a hidden one."""

_HATCHED = 0.15
"""What a grid step squared costs that is hatched and void, or filled and not hatched."""


_Gap = tuple[tuple[int, ...], tuple[int, ...], bytes, int]
"""Regions on the sight lines on both sides of it, which of them go on, and the slab."""


def add_evidence(terms: Terms) -> None:
    """Let a choice cost what it does not explain of the lines of all views."""
    for view in terms.plan.sights:
        _add_levels(terms, view)
        _add_uprights(terms, view)
        _add_hatching(terms, view)
    for border in terms.plan.regions.borders:
        _add_border(terms, border)


def _add_levels(terms: Terms, view: Sights) -> None:
    """Lines across the axis: where the nearest changes from a slab to the next."""
    visible, hidden = view.levels
    groups = _grouped(view.regions)
    for level in range(len(terms.plan.levels)):
        inner = 0 < level < len(terms.plan.levels) - 1
        for regions, chosen in groups.items():
            if not regions:
                terms.fixed += float(view.widths[chosen][visible[chosen, level]].sum())
                continue
            widths = view.widths[chosen]
            solid, dashed = visible[chosen, level], hidden[chosen, level]
            drawn = float(widths[solid].sum())
            blank = float(widths[~solid & ~dashed].sum())
            behind = float(widths[dashed & ~solid].sum())
            seen = terms.changes_at(regions, level)
            terms.either(drawn, blank + _KIND * behind, seen)
            if view.draws_hidden and inner:
                beneath = terms.alters_at(regions, level)
                terms.either(HIDDEN * behind, 0.0, beneath)
                if blank:
                    covered = terms.model.new_bool_var("")
                    terms.model.add(covered >= beneath - seen)
                    terms.cost(HIDDEN * blank, covered)


def _add_uprights(terms: Terms, view: Sights) -> None:
    """Lines along the axis: where the nearest lies deeper on the next sight line."""
    visible, hidden = view.uprights
    count = len(view.places)
    stated: dict[_Gap, list[float]] = {}
    known: dict[_Gap, tuple[Expression, Expression | None]] = {}
    for index, even in enumerate(view.goes_on):
        one, other = (view.met[k].regions if 0 <= k < count else () for k in (index - 1, index))
        for k in terms.plan.slabs:
            key = one, other, even.tobytes(), k
            is_plain = one == other and bool(np.diag(even).all())
            if is_plain and not (visible[index, k] or hidden[index, k]):
                continue
            if key not in known:
                jump: Expression = 0 if is_plain else terms.jump(one, other, even, k)
                beneath: Expression | None = None
                if view.draws_hidden:
                    beneath = 0 if one == other else terms.more_runs(one, other, k)
                known[key] = jump, beneath
                stated[key] = [0.0, 0.0, 0.0]
            height = float(terms.heights[k])
            kind = 0 if visible[index, k] else 1 if hidden[index, k] else 2
            stated[key][kind] += height
    for key, (solid, dashed, blank) in stated.items():
        jump, beneath = known[key]
        lacking = _UPRIGHT_SEEN * (blank + _KIND * dashed)
        terms.either(_UPRIGHT_DRAWN * solid, lacking, jump)
        if beneath is None:
            continue
        if dashed:
            either = terms.model.new_bool_var("")
            terms.model.add(either <= jump + beneath)
            terms.either(_HIDDEN_UPRIGHT * dashed, 0.0, either)
        if blank:
            covered = terms.model.new_bool_var("")
            terms.model.add(covered >= beneath - jump)
            terms.cost(_HIDDEN_UPRIGHT * blank, covered)


def _add_hatching(terms: Terms, view: Sights) -> None:
    """What a section cuts is hatched."""
    if view.hatched is None:
        return
    per_mm2 = _HATCHED / terms.plan.grid
    for k in terms.plan.slabs:
        areas: dict[tuple[int, ...], list[float]] = {}
        for index, regions in enumerate(view.regions):
            cut = tuple(r for r, item in zip(regions, view.met[index].is_cut, strict=True) if item)
            stated = areas.setdefault(cut, [0.0, 0.0])
            stated[0 if view.hatched[index, k] else 1] += float(
                view.widths[index] * terms.heights[k]
            )
        for cut, (hatched, plain) in areas.items():
            if cut:
                void = terms.is_open(cut, k)
                terms.either(per_mm2 * hatched, per_mm2 * plain, 1 - void)


def _add_border(terms: Terms, border: Border) -> None:
    above, below = terms.plan.is_seen
    if above:
        same = terms.same(terms.tops, border)
        lacking = _lacking(border.length, border.visible, border.hidden)
        terms.either(lacking, border.visible, same)
        if terms.plan.draws_hidden and border.other != OUTSIDE:
            beneath = terms.differs(border.one, border.other)
            covered = terms.model.new_bool_var("")
            terms.model.add(covered <= same)
            terms.model.add(covered <= beneath)
            terms.model.add(covered >= same + beneath - 1)
            terms.cost(HIDDEN * max(0.0, border.length - border.hidden), covered)
            terms.cost(HIDDEN * border.hidden, same - covered)
    if below:
        same = terms.same(terms.bottoms, border)
        lacking = _lacking(border.length, border.visible_below, border.hidden_below)
        terms.either(lacking, border.visible_below, same)


def _lacking(length: float, visible: float, hidden: float) -> float:
    """mm that are lost of a line which is seen, by what is drawn of it."""
    blank = max(0.0, length - visible - hidden)
    return blank + _KIND * min(hidden, max(0.0, length - visible))


def _grouped(regions: Iterable[tuple[int, ...]]) -> dict[tuple[int, ...], list[int]]:
    """Sight lines that meet the same regions in the same order."""
    groups: dict[tuple[int, ...], list[int]] = {}
    for index, this_regions in enumerate(regions):
        groups.setdefault(this_regions, []).append(index)
    return groups
