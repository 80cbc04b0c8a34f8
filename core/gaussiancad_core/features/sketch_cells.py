"""The cells into which the edges of a solid, seen along a direction, divide the plane; where in
each of them the material lies."""

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle

Points = npt.NDArray[np.float64]

_BESIDE = 1e-3
"""Units beside a curve at which the cells on its two sides are found."""

_ON_CURVE = 1e-4
"""Units within which a corner is on a curve."""

OFF_CENTRE = 0.4382
"""Share of a cell's width and height at which it is looked at: a line through its middle often runs
along an edge of the solid."""

_MOST_PLACES = 3
"""Pieces of a cell at which it is looked at."""


@dataclass(frozen=True)
class Piece:
    """A piece of a curve between two cells.

    Attributes:
        curve: that it lies on; units.
        support: number of the curve in the arrangement.
        low, high: its parameters.
        left, right: the cells on the side of its normal, and on the other one.
    """

    curve: LineOrCircle
    support: int
    low: float
    high: float
    left: int
    right: int


class Cells:
    """The cells of a plane.

    Args:
        arrangement: of its curves; units.
        shares: of its width and height at which each cell is looked at.

    Attributes:
        arrangement: as given.
        pieces: between two different cells.
        places: (n, 2) units, points within cells.
        cell_of: (n,) the cell of each place.
    """

    def __init__(self, arrangement: Arrangement, shares: Sequence[float] = (OFF_CENTRE,)) -> None:
        self.arrangement = arrangement
        self.pieces = tuple(self._pieces())
        self.places, self.cell_of = _places(arrangement, shares)
        self._beside: dict[int, set[int]] = {}
        for piece in self.pieces:
            self._beside.setdefault(piece.left, set()).add(piece.right)
            self._beside.setdefault(piece.right, set()).add(piece.left)

    @property
    def count(self) -> int:
        """How many cells there are, the outside (cell 0) included."""
        return self.arrangement.regions

    def locate(self, points: Points) -> npt.NDArray[np.int64]:
        """(n,) cells of (n, 2) points, units."""
        found = [self.arrangement.locate(float(a), float(b)) for a, b in points]
        return np.array(found, dtype=np.int64)

    def components(self, cells: Collection[int]) -> list[frozenset[int]]:
        """Cells in groups that hang together along curves."""
        left, found = set(cells), []
        while left:
            group, reached = set(), [left.pop()]
            while reached:
                cell = reached.pop()
                group.add(cell)
                near = self._beside.get(cell, set()) & left
                left -= near
                reached.extend(near)
            found.append(frozenset(group))
        return found

    def filled(self, cells: frozenset[int]) -> frozenset[int]:
        """Cells with those that they enclose."""
        others = set(range(self.count)) - cells
        around = next(group for group in self.components(others) if OUTSIDE in group)
        return frozenset(range(self.count)) - around

    def border(self, cells: Collection[int]) -> list[Piece]:
        """The pieces between cells and the others."""
        inside = set(cells)
        return [piece for piece in self.pieces if (piece.left in inside) != (piece.right in inside)]

    def _pieces(self) -> Iterable[Piece]:
        for support, low, high in _pieces_of(self.arrangement):
            curve = self.arrangement.carriers[support].curve
            at = low + 0.438 * (high - low)
            (a, b), (da, db) = curve.at(at), curve.normal(at)
            left, right = (
                self.arrangement.locate(a + way * da, b + way * db) for way in (_BESIDE, -_BESIDE)
            )
            if left != right:
                yield Piece(curve, support, low, high, left, right)

    def by_cell(self, values: Points, combine: np.ufunc) -> Points:
        """(cells, m) of (places, m) values: those of each cell's places combined; 0 of cells that
        have no place."""
        found = np.zeros((self.count, values.shape[1]))
        starts = np.flatnonzero(np.diff(self.cell_of, prepend=-1))
        if len(starts):
            found[self.cell_of[starts]] = combine.reduceat(values, starts, axis=0)
        return found


def _pieces_of(arrangement: Arrangement) -> Iterator[tuple[int, float, float]]:
    """(carrier, low, high) of what is drawn, cut where anything meets it."""
    corners = np.array(arrangement.corners).reshape(-1, 2)
    for index, low, high in arrangement.stretches:
        curve = arrangement.carriers[index].curve
        cuts = {low, high}
        for corner in corners[_on(curve, corners)]:
            at = curve.parameter((float(corner[0]), float(corner[1])))
            turns = (0.0, FULL_TURN, -FULL_TURN) if isinstance(curve, Circle) else (0.0,)
            cuts.update(at + turn for turn in turns if low < at + turn < high)
        for start, end in pairwise(sorted(cuts)):
            if (end - start) * curve.speed > _ON_CURVE:
                yield index, start, end


def _on(curve: LineOrCircle, points: Points) -> npt.NDArray[np.bool_]:
    """(n,) which of (n, 2) points lie on a curve."""
    if isinstance(curve, Circle):
        away = np.hypot(*(points - np.array(curve.centre)).T) - curve.radius
    else:
        away = (points - np.array(curve.point)) @ np.array(curve.normal(0.0))
    return np.abs(away) < _ON_CURVE


def _places(
    arrangement: Arrangement, shares: Sequence[float]
) -> tuple[Points, npt.NDArray[np.int64]]:
    found: list[tuple[int, tuple[float, float]]] = []
    for share in shares:
        by_cell: dict[int, list[tuple[float, tuple[float, float]]]] = {}
        for cell, point, area in arrangement.trapezoids(share):
            by_cell.setdefault(cell, []).append((area, point))
        for cell, pieces in by_cell.items():
            largest = sorted(pieces, reverse=True)[:_MOST_PLACES]
            found += [(cell, point) for _, point in largest]
    found.sort(key=lambda place: place[0])
    points = np.array([point for _, point in found]).reshape(-1, 2)
    return points, np.array([cell for cell, _ in found], dtype=np.int64)


def edge_count(border: Iterable[Piece]) -> int:
    """How many edges a border has, where pieces that go on in each other are one."""
    by_curve: dict[int, list[tuple[float, float]]] = {}
    for piece in border:
        by_curve.setdefault(piece.support, []).append((piece.low, piece.high))
    count = 0
    for stretches in by_curve.values():
        ordered = sorted(stretches)
        count += 1 + sum(after[0] - before[1] > 1e-6 for before, after in pairwise(ordered))
    return count


def length_of(border: Iterable[Piece]) -> float:
    """Units that a border is long."""
    return sum((piece.high - piece.low) * piece.curve.speed for piece in border)
