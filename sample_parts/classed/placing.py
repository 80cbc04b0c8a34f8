"""Where features go: flat places of the right size, alone, mirrored, or in a row."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.model.axes import Axis
from sample_parts.classed.stock import CELL, WALLS, Site, Stock
from sample_parts.modelling import Point2

_TRIES = 14
"""Places that are looked at for a feature."""


@dataclass(frozen=True)
class Work:
    """What a feature needs to know.

    Attributes:
        stock: the part so far.
        random: where chance comes from.
        sides: (6,) how likely a tool comes along -X, +X, -Y, ...
        scale: mm, a usual size of a feature.
        wanted: faces that the part may still get.
    """

    stock: Stock
    random: np.random.Generator
    sides: tuple[float, ...]
    scale: float
    wanted: int

    def even(self, low: float, high: float) -> float:
        """A multiple of two millimetres from ``low`` to ``high``, or the first above ``low``."""
        first, last = int(np.ceil(low / CELL)), int(np.floor(high / CELL))
        return CELL * float(self.random.integers(first, max(first, last) + 1))

    def sized(self, low: float, high: float) -> float:
        """The same in units of the usual size; at least four millimetres."""
        return self.even(max(4.0, low * self.scale), max(4.0, high * self.scale))

    def chance(self, share: float) -> bool:
        """True in this share of cases."""
        return bool(self.random.random() < share)

    def side(self) -> tuple[Axis, int]:
        """An axis and the sign of the side from which a tool comes."""
        index = int(self.random.choice(6, p=self.sides))
        return Axis(index // 2), 1 if index % 2 else -1


Feature = Callable[[Work], int]
"""Makes something of the part's surface; returns about how many faces it adds, 0 for failed."""

Wanted = Callable[[Site], bool]


def place(work: Work, extent: Point2, wanted: Wanted, turn: bool = True) -> Site | None:
    """A flat place for a rectangle somewhere on the part.

    Args:
        work: the part.
        extent: (2,) mm of the rectangle.
        wanted: what else must hold.
        turn: whether the rectangle may be turned by a right angle.
    """
    for _ in range(_TRIES):
        axis, sign = work.side()
        size = extent[::-1] if turn and work.chance(0.5) else extent
        room = np.delete(np.array(work.stock.size), axis.value) - size
        if (room < 2 * CELL).any():
            continue
        # Half of all features stand in the middle of the part, in one direction at least.
        low = [work.even(CELL, value - CELL) for value in room]
        for index in range(2):
            if work.chance(0.3) and room[index] % (2 * CELL) == 0:
                low[index] = float(room[index] / 2.0)
        high = (low[0] + size[0], low[1] + size[1])
        site = work.stock.site(axis, sign, (low[0], low[1]), high)
        if site is not None and wanted(site):
            return site
    return None


def across(work: Work, width: float, wanted: Wanted) -> tuple[Site, int] | None:
    """A flat strip of a width right across the part; which of its directions is the long one."""
    for _ in range(_TRIES):
        axis, sign = work.side()
        long = int(work.random.integers(2))
        size = np.delete(np.array(work.stock.size), axis.value)
        room = size[1 - long] - width
        if room < 4 * CELL:
            continue
        first = work.even(2 * CELL, room - 2 * CELL)
        low, high = [0.0, 0.0], [0.0, 0.0]
        low[long], high[long] = 0.0, float(size[long])
        low[1 - long], high[1 - long] = first, first + width
        walls = (0, 1) if long == 0 else (1, 0)
        site = work.stock.site(axis, sign, (low[0], low[1]), (high[0], high[1]), walls)
        if site is not None and wanted(site):
            return site, long
    return None


def spread(work: Work, site: Site, faces: int) -> list[Site]:
    """The site and others like it, for a feature that adds some faces.

    Alone, mirrored in the part's middle in one or both directions, or in a row.
    """
    sites = [site]
    most = max(1, work.wanted // max(faces, 1))
    if most == 1 or work.chance(0.1):
        return sites
    for way in work.random.permutation(5):
        for low in _copies(work, site, int(way)):
            high = (low[0] + site.extent[0], low[1] + site.extent[1])
            other = work.stock.site(site.axis, site.sign, low, high, WALLS)
            if other is None:
                continue
            alike = (other.level, other.runs) == (site.level, site.runs)
            alike = alike and other.depth >= site.depth
            if alike and len(sites) < most and all(_apart(other, placed) for placed in sites):
                sites.append(other)
        if len(sites) > 1:
            break
    return sites


def _copies(work: Work, site: Site, way: int) -> Iterator[Point2]:
    """Lower corners of the other places of a pattern: one of five ways."""
    size = np.delete(np.array(work.stock.size), site.axis.value)
    mirrored = size - np.array(site.high)
    if way == 0:
        yield float(mirrored[0]), site.low[1]
        yield site.low[0], float(mirrored[1])
        yield float(mirrored[0]), float(mirrored[1])
    elif way < 3:
        low = list(site.low)
        low[way - 1] = float(mirrored[way - 1])
        yield low[0], low[1]
    else:
        index = way - 3
        pitch = site.extent[index] + work.even(2 * CELL, max(2 * CELL, 0.5 * work.scale))
        for number in (1, 2, 3, 4, 5):
            low = list(site.low)
            low[index] += number * pitch
            yield low[0], low[1]


def _apart(one: Site, other: Site) -> bool:
    """Whether two rectangles keep a wall between them."""
    gaps = np.maximum(
        np.array(one.low) - np.array(other.high), np.array(other.low) - np.array(one.high)
    )
    return bool(gaps.max() >= 2 * CELL - 1e-9)
