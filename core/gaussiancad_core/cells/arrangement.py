"""The regions into which the drawn lines of a plane divide it.

The plane is cut into slabs at the first coordinate of every vertex.  Within a slab the curves do
not meet, so they have an order, and the trapezoids between them join across the slabs' borders
wherever no upright line stands in between.  Region 0 is the outside.

Chains are drawn curves that are traces of no surface (projections of intersection curves).  They
separate the outside from the part, and nothing else.
"""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import hypot, inf, pi, sin, sqrt

import numpy as np

from gaussiancad_core.cells.arrangement_kernels import CHAIN, Table
from gaussiancad_core.coordinates.drawn_intervals import Carrier, merged_intervals
from gaussiancad_core.coordinates.point_chains import (
    Chain,
    crossings_with_chain,
    crossings_with_curves,
)
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import ASIDE, ON_CURVE
from gaussiancad_core.geometry.whole_curves import Circle, Line, meetings

_SAME = 3e-6
"""Coordinates closer than this are one."""

OUTSIDE = 0


@dataclass(frozen=True)
class _Link:
    """A straight piece between two values of the first coordinate."""

    a0: float
    b0: float
    a1: float
    b1: float
    carrier: int

    @property
    def start(self) -> float:
        return self.a0

    @property
    def end(self) -> float:
        return self.a1

    def value(self, a: float) -> float:
        return self.b0 + (a - self.a0) / (self.a1 - self.a0) * (self.b1 - self.b0)

    def normal(self, a: float) -> Point:
        da, db = self.a1 - self.a0, self.b1 - self.b0
        length = hypot(da, db)
        return -db / length, da / length

    def firsts_at(self, b: float) -> list[float]:
        if (self.b0 - b) * (self.b1 - b) >= 0.0:
            return []
        return [self.a0 + (b - self.b0) / (self.b1 - self.b0) * (self.a1 - self.a0)]


@dataclass(frozen=True)
class _Bow:
    """A piece of the upper (side 1) or lower (side -1) half of a circle."""

    x: float
    y: float
    radius: float
    side: int
    start: float
    end: float
    carrier: int

    def value(self, a: float) -> float:
        square = self.radius**2 - (a - self.x) ** 2
        return self.y + self.side * sqrt(square) if square > 0.0 else self.y

    def normal(self, a: float) -> Point:
        return (a - self.x) / self.radius, (self.value(a) - self.y) / self.radius

    def firsts_at(self, b: float) -> list[float]:
        off = b - self.y
        if abs(off) >= self.radius or off * self.side <= 0.0:
            return []
        half = sqrt(self.radius**2 - off**2)
        return [
            a for a in (self.x - half, self.x + half) if self.start - 1e-9 <= a <= self.end + 1e-9
        ]


_Piece = _Link | _Bow


def _row(piece: _Piece) -> tuple[float, ...]:
    if isinstance(piece, _Link):
        return 0.0, piece.a0, piece.b0, piece.a1, piece.b1, piece.start, piece.end
    return 1.0, piece.x, piece.y, piece.radius, piece.side, piece.start, piece.end


@dataclass(frozen=True)
class Trace:
    """What a line parallel to an axis meets in a plane.

    Attributes:
        positions: along the line, ascending.
        normals: of the curves there.
        carriers: their carriers, or ``CHAIN``.
        regions: between the positions; one more than they are.
    """

    positions: tuple[float, ...]
    normals: tuple[Point, ...]
    carriers: tuple[int, ...]
    regions: tuple[int, ...]


class Arrangement:
    """Regions of a plane.

    Args:
        carriers: with what is drawn on them.
        chains: boundaries that are no carriers.
        lost: (carrier, low, high) that bound regions as well, though nothing is drawn there.

    Attributes:
        carriers: as given.
        stretches: (carrier, low, high) that bound regions: all that are drawn.
        corners: points where something ends, meets or turns.
        regions: how many there are, the outside included.
    """

    def __init__(
        self,
        carriers: Sequence[Carrier],
        chains: Sequence[Chain] = (),
        lost: Sequence[tuple[int, float, float]] = (),
    ) -> None:
        self.carriers = tuple(carriers)
        self._chain_ends: list[float] = []
        self.stretches = tuple(
            (index, low, high)
            for index, carrier in enumerate(carriers)
            for low, high in _bounding(carrier, [pair[1:] for pair in lost if pair[0] == index])
        )
        self.corners = self._corners()
        self._pieces, self._uprights = self._monotone()
        curves = [self.carriers[index].curve for index, _, _ in self.stretches]
        for number, chain in enumerate(chains):
            self._add_chain(chain)
            # Pieces must not cross within a slab: they would change their order in it.
            self._chain_ends += crossings_with_curves(chain, curves)
            for other in chains[:number]:
                self._chain_ends += crossings_with_chain(chain, other)
        self._borders = distinct([corner[0] for corner in self.corners] + self._chain_ends)
        self._slabs = self._ordered()
        self._join()
        self._traces: dict[tuple[int, float], Trace] = {}

    def _corners(self) -> tuple[Point, ...]:
        points: list[Point] = []
        boxes = []
        for index, low, high in self.stretches:
            curve = self.carriers[index].curve
            items = [curve.at(low), curve.at(high)]
            if isinstance(curve, Circle):
                quarters = [k * pi / 2.0 for k in range(5)]
                items += [curve.at(t) for t in quarters if low - 1e-7 <= t <= high + 1e-7]
                (x, y), r = curve.centre, curve.radius
                boxes.append((x - r, y - r, x + r, y + r))
            else:
                (x0, y0), (x1, y1) = items
                boxes.append((min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)))
            points += items
        for i, (first, *one) in enumerate(self.stretches):
            for j in range(i):
                second, *other = self.stretches[j]
                a, b = boxes[i], boxes[j]
                apart = a[0] > b[2] + 1e-4 or b[0] > a[2] + 1e-4
                if first == second or apart or a[1] > b[3] + 1e-4 or b[1] > a[3] + 1e-4:
                    continue
                for point in meetings(self.carriers[first].curve, self.carriers[second].curve):
                    if self._on(first, one, point) and self._on(second, other, point):
                        points.append(point)
        return tuple(points)

    def _on(self, index: int, stretch: Sequence[float], point: Point) -> bool:
        curve = self.carriers[index].curve
        at, slack = curve.parameter(point), ON_CURVE / curve.speed
        turns = (0.0, FULL_TURN, -FULL_TURN) if isinstance(curve, Circle) else (0.0,)
        return any(stretch[0] - slack <= at + t <= stretch[1] + slack for t in turns)

    def _monotone(self) -> tuple[list[_Piece], list[tuple[float, float, float, int]]]:
        """Drawn stretches as pieces over the first coordinate, and the upright ones."""
        pieces: list[_Piece] = []
        uprights = []
        for index, low, high in self.stretches:
            curve = self.carriers[index].curve
            if isinstance(curve, Line):
                start, end = curve.at(low), curve.at(high)
                if start[0] == end[0]:
                    # Upright, or slanted and so short that it is no wider than a rounding error.
                    bottom, top = sorted((start[1], end[1]))
                    uprights.append((start[0], bottom, top, index))
                else:
                    pieces.append(_Link(*start, *end, index))
                continue
            cuts = [low, *(k * pi for k in range(3) if low + 1e-7 < k * pi < high - 1e-7), high]
            (x, y), radius = curve.centre, curve.radius
            for first, last in pairwise(cuts):
                side = 1 if sin((first + last) / 2.0) > 0.0 else -1
                left, right = sorted((curve.at(first)[0], curve.at(last)[0]))
                pieces.append(_Bow(x, y, radius, side, left, right, index))
        return pieces, uprights

    def _add_chain(self, chain: Chain) -> None:
        for (a0, b0), (a1, b1) in pairwise(chain):
            self._chain_ends += [a0, a1]
            if a0 == a1:
                self._uprights.append((a0, min(b0, b1), max(b0, b1), CHAIN))
            elif a0 < a1:
                self._pieces.append(_Link(a0, b0, a1, b1, CHAIN))
            else:
                self._pieces.append(_Link(a1, b1, a0, b0, CHAIN))

    def _ordered(self) -> list[list[_Piece]]:
        """The pieces of each slab from low to high."""
        borders = self._borders
        slabs: list[list[_Piece]] = [[] for _ in range(max(0, len(borders) - 1))]
        for piece in self._pieces:
            first, last = _index(borders, piece.start), _index(borders, piece.end)
            if first == last:
                # Too steep for a slab of its own, yet still a wall.
                ends = sorted((piece.value(piece.start), piece.value(piece.end)))
                self._uprights.append((borders[first], ends[0], ends[1], piece.carrier))
            for slab in range(first, last):
                slabs[slab].append(piece)
        for slab, this_slabs in enumerate(slabs):
            middle = (borders[slab] + borders[slab + 1]) / 2.0
            this_slabs.sort(key=lambda piece: piece.value(middle))
        return slabs

    def _join(self) -> None:
        """Number the regions: trapezoids that are open to each other are one."""
        borders, slabs = self._borders, self._slabs
        offsets, total = [], 0
        for this_slabs in slabs:
            offsets.append(total)
            total += len(this_slabs) + 1
        outside = total
        sets = _Sets(total + 1)
        for slab, items in enumerate(slabs):
            sets.join(offsets[slab], outside)
            sets.join(offsets[slab] + len(items), outside)
        standing: dict[int, list[tuple[float, float, float, int]]] = defaultdict(list)
        for upright in self._uprights:
            standing[_index(borders, upright[0])].append(upright)
        for border, at in enumerate(borders):
            # Steep pieces change much over the width of a border: their own ends are exact.
            before = slabs[border - 1] if border > 0 else []
            behind = slabs[border] if border < len(slabs) else []
            left = [
                piece.value(piece.end if _index(borders, piece.end) == border else at)
                for piece in before
            ]
            right = [
                piece.value(piece.start if _index(borders, piece.start) == border else at)
                for piece in behind
            ]
            walls = standing[border]
            marks = sorted([*left, *right, *(b for wall in walls for b in wall[1:3])])
            for low, high in zip([-1e9, *marks], [*marks, 1e9], strict=True):
                if high - low < ASIDE:
                    continue
                middle = (low + high) / 2.0
                if any(wall[1] - 1e-7 < middle < wall[2] + 1e-7 for wall in walls):
                    continue
                one = offsets[border - 1] + sum(b < middle for b in left) if before else outside
                other = offsets[border] + sum(b < middle for b in right) if behind else outside
                sets.join(one, other)
        for one, other in self._over_chains(offsets, sets, outside):
            sets.join(one, other)
        numbers = {sets.root(outside): OUTSIDE}
        self._region = [numbers.setdefault(sets.root(i), len(numbers)) for i in range(total)]
        self._offsets = offsets
        self.regions = len(numbers)

    def _over_chains(
        self, offsets: list[int], sets: "_Sets", outside: int
    ) -> list[tuple[int, int]]:
        """Pairs of trapezoids on both sides of a chain's link, neither of them outside."""
        pairs = [
            (offsets[slab] + place, offsets[slab] + place + 1)
            for slab, slabs in enumerate(self._slabs)
            for place, piece in enumerate(slabs)
            if piece.carrier == CHAIN
        ]
        void = sets.root(outside)
        return [pair for pair in pairs if void not in (sets.root(pair[0]), sets.root(pair[1]))]

    @cached_property
    def table(self) -> Table:
        """The regions as arrays, for the kernels."""
        number = {id(piece): index for index, piece in enumerate(self._pieces)}
        counts = [len(slab) for slab in self._slabs]
        pieces = np.array([_row(piece) for piece in self._pieces]).reshape(-1, 7)
        uprights = np.array([upright[:3] for upright in self._uprights]).reshape(-1, 3)
        return Table(
            np.array(self._borders),
            np.concatenate([[0], np.cumsum(counts, dtype=np.int64)]),
            np.array([number[id(one)] for slab in self._slabs for one in slab], dtype=np.int64),
            pieces,
            np.array([piece.carrier for piece in self._pieces], dtype=np.int64),
            uprights,
            np.array([upright[3] for upright in self._uprights], dtype=np.int64),
            np.array(self._region, dtype=np.int64),
        )

    def locate(self, a: float, b: float) -> int:
        """The region of a point; what lies on a line may be told as either of its sides."""
        slab = bisect_right(self._borders, a) - 1
        if slab < 0 or slab >= len(self._slabs):
            return OUTSIDE
        place = 0
        for piece in self._slabs[slab]:
            if piece.value(a) >= b:
                break
            place += 1
        return self._region[self._offsets[slab] + place]

    def inner_points(self) -> Iterator[tuple[int, Point]]:
        """Regions but the outside, each with a point of one of the trapezoids that make it up."""
        for region, point, _ in self.trapezoids():
            yield region, point

    def trapezoids(self, share: float = 0.5) -> Iterator[tuple[int, Point, float]]:
        """Regions but the outside, each with a point and about the area of a trapezoid of it.

        Args:
            share: of its width and height at which the point lies; the middle by default.
        """
        for slab, slabs in enumerate(self._slabs):
            start, end = self._borders[slab : slab + 2]
            middle = start + share * (end - start)
            for place, (below, above) in enumerate(pairwise(slabs), 1):
                region = self._region[self._offsets[slab] + place]
                if region != OUTSIDE:
                    low, high = below.value(middle), above.value(middle)
                    yield region, (middle, low + share * (high - low)), (end - start) * (high - low)

    def neighbours(self) -> set[tuple[int, int]]:
        """Pairs of regions with a line between them, each both ways."""
        found: set[tuple[int, int]] = set()
        stacks = [
            self._region[offset : offset + len(slabs) + 1]
            for slabs, offset in zip(self._slabs, self._offsets, strict=False)
        ]
        for stack in stacks:
            found.update(pairwise(stack))
        for index, (left, right) in enumerate(pairwise(self._slabs)):
            border = self._borders[index + 1]
            sides = [
                [-inf, *(piece.value(border) for piece in items), inf] for items in (left, right)
            ]
            for one, (low, high) in zip(stacks[index], pairwise(sides[0]), strict=True):
                for other, (start, end) in zip(stacks[index + 1], pairwise(sides[1]), strict=True):
                    if one != other and min(high, end) - max(low, start) > ASIDE:
                        found.add((one, other))
        if stacks:
            ends = [*stacks[0], *stacks[-1]]
            found.update((OUTSIDE, region) for region in ends)
        return {
            (a, b) for one, other in found if one != other for a, b in ((one, other), (other, one))
        }

    def trace(self, coordinate: int, value: float) -> Trace:
        """What the line meets on which a coordinate (0 or 1) has a value."""
        key = (coordinate, round(value, 7))
        if key not in self._traces:
            self._traces[key] = self._upright_trace(value) if coordinate == 0 else self._flat(value)
        return self._traces[key]

    def _upright_trace(self, a: float) -> Trace:
        slab = bisect_right(self._borders, a) - 1
        if slab < 0 or slab >= len(self._slabs):
            return Trace((), (), (), (OUTSIDE,))
        items, offset = self._slabs[slab], self._offsets[slab]
        return Trace(
            tuple(piece.value(a) for piece in items),
            tuple(piece.normal(a) for piece in items),
            tuple(piece.carrier for piece in items),
            tuple(self._region[offset : offset + len(items) + 1]),
        )

    def _flat(self, b: float) -> Trace:
        met: list[tuple[float, Point, int]] = []
        for piece in self._pieces:
            met += [(a, piece.normal(a), piece.carrier) for a in piece.firsts_at(b)]
        for a, bottom, top, carrier in self._uprights:
            if bottom < b < top:
                met.append((a, (1.0, 0.0), carrier))
        met.sort(key=lambda item: item[0])
        positions = [item[0] for item in met]
        between = [self.locate((low + high) / 2.0, b) for low, high in pairwise(positions)]
        regions = (OUTSIDE, *between, OUTSIDE) if met else (OUTSIDE,)
        return Trace(
            tuple(positions),
            tuple(item[1] for item in met),
            tuple(item[2] for item in met),
            regions,
        )


class _Sets:
    """Disjoint sets of numbers."""

    def __init__(self, count: int) -> None:
        self._parent = list(range(count))

    def root(self, item: int) -> int:
        parent = self._parent
        while parent[item] != item:
            parent[item] = parent[parent[item]]
            item = parent[item]
        return item

    def join(self, one: int, other: int) -> None:
        self._parent[self.root(one)] = self.root(other)


def _bounding(carrier: Carrier, lost: list[tuple[float, float]]) -> list[tuple[float, float]]:
    drawn = carrier.drawn()
    return merged_intervals([*drawn, *lost], 1e-4 / carrier.curve.speed) if lost else drawn


def distinct(values: Sequence[float], same: float = _SAME) -> list[float]:
    """Means of clusters of numbers, ascending; ``same`` is the gap within a cluster."""
    clusters: list[list[float]] = []
    for value in sorted(values):
        if clusters and value - clusters[-1][-1] <= same:
            clusters[-1].append(value)
        else:
            clusters.append([value])
    return [sum(cluster) / len(cluster) for cluster in clusters]


def _index(borders: list[float], value: float) -> int:
    """Index of the nearest border."""
    at = bisect_left(borders, value)
    if at >= len(borders) or (at > 0 and value - borders[at - 1] < borders[at] - value):
        return at - 1
    return at
