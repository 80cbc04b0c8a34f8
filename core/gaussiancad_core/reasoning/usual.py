"""What an engineer takes for usual where views leave hidden lines out.

Nothing is inside a part that no view shows, and what is seen of a hole goes through.  Neither is a
rule: of the labels that have all lines those are looked for that keep most of it.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, pairwise, product
from math import prod

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.reasoning.columns import Cell, Space, Surface
from gaussiancad_core.reasoning.planes import IN_PLANE, role_plane
from gaussiancad_core.reasoning.rules import Transition
from gaussiancad_core.reasoning.supports import PartSupports

UNSEEN, LOOSE, BLIND = 40, 40, 3
"""Surfaces that weigh as much as a void that no view sees, as what stands by itself in a through
hole, and, beside one for each of its cells, as a hole that is seen and does not go through."""

NOWHERE = 15
"""Surfaces that a surface weighs as much as whose trace no view draws."""

_BULK = 1000.0
"""Surfaces that a void as large as the part's box weighs as much as, if it is no through hole."""

_MOST = 4_000
"""Lines of sight that are followed at most."""


@dataclass(frozen=True)
class Hole:
    """Cells behind a region of a view that the part surrounds.

    Attributes:
        cells: of the region itself, the first that is seen first.
        within: of the regions that it surrounds.
    """

    cells: tuple[Cell, ...]
    within: tuple[Cell, ...] = ()


@dataclass(frozen=True)
class Usual:
    """Columns of cells that tell what is usual.

    Attributes:
        sights: cells along lines of sight, from each viewer on.
        holes: that may be, as seen in views without hidden lines.
        bulks: of each cell, in surfaces, how much a void of its size weighs.
        undrawn: of each surface whose trace no view draws the pairs of cells that it parts.
    """

    sights: tuple[tuple[Cell, ...], ...]
    holes: tuple[Hole, ...]
    bulks: Mapping[Cell, int]
    undrawn: tuple[frozenset[Transition], ...] = ()


def usual_of(
    supports: PartSupports,
    space: Space,
    roles: Iterable[Role],
    undrawn: Iterable[Role],
    cuts: Mapping[Axis, float],
) -> Usual:
    """What is usual in the cells of a part.

    Args:
        supports: of the views.
        space: the cells.
        roles: views that are not cut.
        undrawn: those of them that draw no hidden lines.
        cuts: cutting planes of sections, by the axis that they are across, units along it.  What
            they show behind them is likely to be before them as well.
    """
    silent = {role_plane(role).normal for role in undrawn}
    sights: dict[tuple[Cell, ...], None] = {}
    holes: dict[Hole, None] = {}
    volumes: defaultdict[Cell, list[float]] = defaultdict(lambda: [0.0, 0.0, 0.0])
    for role in roles:
        plane = role_plane(role)
        behind: dict[int, tuple[Cell, ...]] = {}
        for region, point, area in space.planes[plane.normal].trapezoids():
            if len(sights) >= _MOST:
                break
            column = space.column(plane.normal, *point)
            inside = [(c, d.depth - c.depth) for c, d in pairwise(column) if c.after is not None]
            for crossing, depth in inside:
                volumes[crossing.after][plane.normal.value] += max(area * depth, 1e-9)
            cells = tuple(c.after for c, _ in (inside if plane.looks_up else inside[::-1]))
            sights[cells] = None
            if len(cells) > len(behind.get(region, ())):
                behind[region] = cells
        if plane.normal in silent:
            for region, within in _surrounded(space.planes[plane.normal]).items():
                inner = dict.fromkeys(cell for each in within for cell in behind.get(each, ()))
                if region in behind:
                    holes[Hole(behind[region], tuple(inner))] = None
    for normal, at in cuts.items():
        for _, point in islice(space.planes[normal].inner_points(), _MOST):
            column = space.column(normal, *point)
            ends = [(d.depth, c.after) for c, d in pairwise(column) if c.after is not None]
            before = [c.after for c in column if c.after is not None and c.depth <= at]
            beyond = [cell for depth, cell in ends if depth > at]
            sights[tuple(before[::-1])] = sights[tuple(beyond)] = None
    box = prod(values[-1] - values[0] for values in space.values.values())
    bulks = {
        cell: 1 + round(_BULK * min(v for v in own if v) / box) for cell, own in volumes.items()
    }
    seen = tuple(own for own in sights if own)
    return Usual(seen, tuple(holes), bulks, tuple(_undrawn(supports, space)))


def _undrawn(supports: PartSupports, space: Space) -> Iterator[frozenset[Transition]]:
    blank = {
        (normal.value, number)
        for normal, plane in supports.planes.items()
        for number, support in enumerate(plane.supports)
        if not support.spans
    }
    if not blank:
        return
    for normal in Axis:
        # Views look along two axes at times, and across these surfaces along the third.
        first, second = (_middles(space.values[Axis(index)]) for index in IN_PLANE[normal])
        for point in islice(product(first, second), _MOST):
            space.column(normal, *point)
    parted: defaultdict[Surface, set[Transition]] = defaultdict(set)
    for before, after, surface in space.crossed():
        if surface in blank:
            parted[surface].add((before, after))
    yield from map(frozenset, parted.values())


def _middles(values: Iterable[float]) -> list[float]:
    return [0.5 * (low + high) for low, high in pairwise(values)]


def _surrounded(plane: Arrangement) -> dict[int, list[int]]:
    """Regions of a plane that do not touch the outside, each with those that it surrounds."""
    beside: defaultdict[int, set[int]] = defaultdict(set)
    for one, other in plane.neighbours():
        beside[one].add(other)
    inner = sorted(own for own, others in beside.items() if OUTSIDE not in (own, *others))
    return {region: sorted(set(beside) - {region} - _reached(beside, region)) for region in inner}


def _reached(beside: Mapping[int, set[int]], without: int) -> set[int]:
    """Regions that the outside leads to past one of them."""
    found, latest = {OUTSIDE}, [OUTSIDE]
    while latest:
        more = beside[latest.pop()] - found - {without}
        found |= more
        latest += more
    return found
