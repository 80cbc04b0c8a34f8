"""Parts of boxes for ``verified``, of which it is known who looks like whom.

Of a small grid all parts are known; of larger ones, parts that differ from one in a box or two.
"""

import itertools
from collections.abc import Iterator, Sequence
from functools import cache

import numpy as np
import numpy.typing as npt

from benchmarks.parts.grid_parts import (
    Grid,
    Hashes,
    Looks,
    Places,
    are_sound,
    grid_solid,
    grid_strokes,
    looks,
    looks_of,
    sound_parts,
)
from benchmarks.run.workers import Row
from benchmarks.sheets.sheet_policies import IN_FIRST, POLICIES, Policy, as_drawn
from benchmarks.tasks.verified_sources import judged
from gaussiancad_core.model.axes import Role

_GRIDS = ((3, 3, 2), (3, 2, 3), (2, 3, 3), (4, 2, 2), (2, 4, 2), (2, 2, 4), (3, 2, 2), (2, 3, 2))
_LARGER = ((3, 3, 3), (4, 3, 3), (3, 4, 3), (3, 3, 4))

_TELLING = 0.5
"""Share of the grids' drawings under other policies for which parts are chosen that look alike."""

_PARTS = 4
"""Parts of a small grid that are solved for one seed."""

_PLAIN = 0.6
"""Share of them that are drawn with all hidden lines."""

_FULL = (0.55, 0.9)
"""Shares of the boxes that larger parts have, from and to."""

_THIN = (0.02, 0.05, 0.1, 0.3)
"""mm, thicknesses of thin boxes."""

_TRIED, _FLIPPED = 1000, 10
"""Sets of boxes that are tried at a time, and sound ones of them whose neighbours are looked at."""

Numbers = npt.NDArray[np.int64]


def grid_cases(seed: int) -> Iterator[Row]:
    """Some parts of a small grid, each under a policy, most with all hidden lines."""
    lot = np.random.default_rng([seed, 11])
    grid = Grid(_GRIDS[seed % len(_GRIDS)])
    numbers = sound_parts(grid)
    policies = [item for item in POLICIES if not item.tangent]
    for _ in range(_PARTS):
        places = _places(grid, lot)
        policy = policies[0 if lot.random() < _PLAIN else int(lot.integers(len(policies)))]
        index = int(lot.integers(len(numbers)))
        if policy is not policies[0] and lot.random() < _TELLING:
            # Most parts are the only ones with their lines: the others are asked more often.
            index = int(lot.choice(confusable(grid, policy)))
        alike = alike_in_grid(grid, places, policy, index)
        yield _judged(grid, int(numbers[index]), places, policy, alike)


def pair_cases(seed: int) -> Iterator[Row]:
    """Two parts of a larger grid that differ in a box or two and have one drawing, hidden lines
    and all; one of them with a fourth view, which may tell them apart; and with a thin box."""
    lot = np.random.default_rng([seed, 13])
    grid = Grid(_LARGER[seed % len(_LARGER)])
    pair = pair_of(grid, POLICIES[0], lot)
    places = _places(grid, lot)
    for part, other in (pair, pair[::-1]):
        yield _judged(grid, part, places, POLICIES[0], [other])
    more = next(item for item in POLICIES if item.name == "four views")
    keys = _keys(looks_of(grid, np.array(pair)), more.roles, more.hidden)
    yield _judged(grid, pair[0], places, more, [pair[1]] if keys[0] == keys[1] else [])
    thin = with_thin_box(grid, pair, places, lot)
    yield _judged(grid, pair[0], thin, POLICIES[0], [pair[1]])


def with_thin_box(
    grid: Grid, pair: tuple[int, int], places: Places, lot: np.random.Generator
) -> Places:
    """Places at which a box that two parts differ in is as thin as many bounds of exact lines."""
    one, other = grid.boxes(np.array(pair))
    box = np.argwhere(one != other)[0]
    axis = int(lot.integers(3))
    steps = [np.diff(place) for place in places]
    steps[axis][box[axis]] = lot.choice(_THIN)
    x, y, z = ((0.0, *np.cumsum(step).tolist()) for step in steps)
    return x, y, z


def _judged(grid: Grid, part: int, places: Places, policy: Policy, alike: Sequence[int]) -> Row:
    drawn = {role: grid_strokes(grid, part, places, role) for role in policy.roles}
    x, y, z = (place[-1] for place in places)
    truth = grid_solid(grid, part, places)
    row = judged(as_drawn(drawn, policy), (x, y, z), policy, truth, unique=not alike)
    stated = {"grid": list(grid.shape), "part": part, "places": [list(place) for place in places]}
    return {**stated, "alike": list(alike), **row}


def _places(grid: Grid, lot: np.random.Generator) -> Places:
    """Where the boxes of a grid begin and end, in whole mm from 0."""
    x, y, z = (
        (0.0, *np.cumsum(lot.integers(3, 25, count)).astype(float).tolist()) for count in grid.shape
    )
    return x, y, z


def pair_of(grid: Grid, policy: Policy, lot: np.random.Generator) -> tuple[int, int]:
    """Two sound parts that look alike."""
    bits = np.array([1 << cell for cell in range(grid.cells)])
    twos = [one | other for one, other in itertools.combinations(bits.tolist(), 2)]
    flips = np.array([0, *bits.tolist(), *twos])
    while True:
        shares = lot.uniform(*_FULL, (_TRIED, 1))
        tried = (lot.random((_TRIED, grid.cells)) < shares) @ bits
        for base in tried[are_sound(grid, tried)][:_FLIPPED].tolist():
            neighbour = base ^ flips
            neighbour = neighbour[are_sound(grid, neighbour)]
            keys = _keys(looks_of(grid, neighbour), policy.roles, policy.hidden)
            _, first, counts = np.unique(keys, return_index=True, return_counts=True)
            for index in first[counts > 1].tolist():
                one, other = neighbour[keys == keys[index]][:2].tolist()
                return one, other


@cache
def confusable(grid: Grid, policy: Policy) -> Numbers:
    """(k,) sound parts by number of their place that look like another one; all, if none does.

    Where there are such, those whose lines are all that another part has: that one would explain
    them as well if nothing had been left out.
    """
    keys = _keys(looks(grid), policy.roles, policy.hidden)
    whole = _keys(looks(grid), policy.roles, frozenset(Role))
    mistaken = np.flatnonzero(np.isin(keys, whole) & (keys != whole))
    if len(mistaken):
        return mistaken
    _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
    common = np.flatnonzero(counts[inverse] > 1)
    return common if len(common) else np.arange(len(keys))


def _keys(seen: Looks, roles: Sequence[Role], hidden: frozenset[Role]) -> Hashes:
    """(k,) what parts look like in some views, as a number in which the views' order counts."""
    views = [seen[role, role in hidden] for role in roles]
    mixed = np.zeros_like(views[0])
    for view in views:
        mixed = mixed * np.uint64(0x9E3779B97F4A7C15) + view
    return mixed


def alike_in_grid(grid: Grid, places: Places, policy: Policy, index: int) -> list[int]:
    """Other parts of the grid with the drawing of one, under either projection if not told."""
    numbers = sound_parts(grid)
    keys = _keys(looks(grid), policy.roles, policy.hidden)
    same = numbers[np.flatnonzero(keys == keys[index])].tolist()
    alike = [part for part in same if part != numbers[index]]
    if not policy.stated:
        others = [IN_FIRST[role] for role in policy.roles]
        shown = frozenset(IN_FIRST[role] for role in policy.roles if role in policy.hidden)
        turned = _keys(looks(grid), others, shown)
        mirrored = _is_mirrored(places[1])
        for part in numbers[np.flatnonzero(turned == keys[index])].tolist():
            # The depths of the other reading run backwards.
            if part != numbers[index] or not mirrored:
                alike.append(part)
    return alike


def _is_mirrored(places: Sequence[float]) -> bool:
    """Whether places are the same from either end."""
    steps = [b - a for a, b in itertools.pairwise(places)]
    return steps == steps[::-1]
