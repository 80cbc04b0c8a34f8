"""What is usual of parts: what they seldom have costs a little, as if a line were lacking."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise

import numpy as np

from gaussiancad_core.sketch.noted_depths import NotedStep
from gaussiancad_core.sketch.slab_plan import Plan
from gaussiancad_core.sketch.slab_terms import Expression, Literal, Terms

_RUN = 1.2
"""Grid steps that each stretch of filled slabs of a region costs."""

_MORE_RUNS = 0.1
"""What a further one costs, in the root of the region's area; a grid step more."""

_VOID, _UNSEEN = 0.05, 0.25
"""What a void costs that reaches through the part, in the root of its area; and more where no view
sees it."""

_BLIND = 0.05
"""The same of a region within the outline that is filled in part; and half a grid step."""

_NOTED = 2.0
"""What a hole costs that is not as a note says, in the root of its area."""

_SEEN = 0.3
"""Share of a region's sight lines in a view from which that sees it."""


def add_habits(terms: Terms) -> None:
    """Let a choice cost hollows that no view sees, blind holes, and more runs than one."""
    plan = terms.plan
    largest = int(np.argmax(plan.regions.areas))
    shares = terms.heights / plan.size[plan.axis.value]
    seen = _seen_from_beside(terms)
    for r, row in enumerate(terms.filled):
        root, runs = float(terms.roots[r]), _column_runs(terms, row)
        terms.cost(_RUN * plan.grid, runs)
        more = terms.model.new_int_var(0, len(row), "")
        terms.model.add(more >= runs - 1)
        terms.cost(_MORE_RUNS * root + plan.grid, more)
        for k, variable in enumerate(row):
            share = float(shares[k])
            terms.cost(_VOID * root * share, 1 - variable)
            views = list(seen.get((r, k), ()))
            if plan.is_seen[0]:
                views.append(terms.tops[r][k])
            if plan.is_seen[1]:
                views.append(terms.bottoms[r][k])
            any_view = terms.model.new_bool_var("")
            terms.model.add(any_view <= sum(views))
            terms.cost(_UNSEEN * root * share, 1 - variable - any_view)
        if plan.regions.is_inner[r] and r != largest and len(row) > 1:
            blind = terms.model.new_bool_var("")
            for one, other in pairwise(row):
                terms.model.add(blind >= one - other)
                terms.model.add(blind >= other - one)
            terms.cost(_BLIND * root + 0.5 * plan.grid, blind)


def add_notes(terms: Terms) -> None:
    """Let a choice cost holes that are not as notes say."""
    for step in terms.plan.noted:
        root = float(terms.plan.regions.areas[list(step.regions)].sum()) ** 0.5
        filled, floor = ([terms.filled[r] for r in each] for each in (step.regions, step.rim))
        if step.depth is None:
            for row in filled:
                for k, x in enumerate(row):
                    share = float(terms.heights[k]) / terms.plan.size[terms.plan.axis.value]
                    terms.cost(_NOTED * root * share / len(filled), x)
            continue
        kept = terms.model.new_bool_var("")
        fits = [
            terms.all_of(
                [*(1 - row[k] for row in filled for k in void), *(row[end] for row in floor)]
            )
            for void, end in _blind(terms.plan, step)
        ]
        terms.model.add(kept <= sum(fits))
        terms.cost(_NOTED * root, 1 - kept)


def _blind(plan: Plan, step: NotedStep) -> Iterator[tuple[range, int]]:
    """Slabs that are void, and the filled one beneath, for each face that a hole may begin at."""
    levels = np.array(plan.levels)
    count = len(plan.slabs)
    for face in levels:
        at = face + step.depth if step.looks_up else face - step.depth
        floor = int(np.abs(levels - at).argmin())
        if abs(levels[floor] - at) > plan.grid or not 0 < floor < count:
            continue
        yield (range(floor), floor) if step.looks_up else (range(floor, count), floor - 1)


def _column_runs(terms: Terms, row: list[Literal]) -> Expression:
    starts: list[Expression] = [row[0]]
    for before, after in pairwise(row):
        variable = terms.model.new_bool_var("")
        terms.model.add(variable <= after)
        terms.model.add(variable <= 1 - before)
        terms.model.add(variable >= after - before)
        starts.append(variable)
    return sum(starts)


def _seen_from_beside(terms: Terms) -> Mapping[tuple[int, int], Iterable[Expression]]:
    """Of a region and a slab, ways along which a view from beside looks into it."""
    found: dict[tuple[int, int], list[Expression]] = {}
    for view in terms.plan.sights:
        widths: dict[int, float] = {}
        ways: dict[int, dict[tuple[int, ...], float]] = {}
        for regions, width in zip(view.regions, view.widths.tolist(), strict=True):
            for r in set(regions):
                before = regions[: regions.index(r) + 1]
                widths[r] = widths.get(r, 0.0) + width
                entry = ways.setdefault(r, {})
                entry[before] = entry.get(before, 0.0) + width
        for r, way in ways.items():
            for before, width in way.items():
                if width >= _SEEN * widths[r]:
                    for k in terms.plan.slabs:
                        found.setdefault((r, k), []).append(terms.is_open(before, k))
    return found
