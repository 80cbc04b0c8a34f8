"""Where a solid and a sheet differ: one place of each line, edge or spot, the worst first."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gaussiancad_core.judging.difference_kinds import KINDS, PRICES, Kind
from gaussiancad_core.judging.drawn_lines import DrawnView
from gaussiancad_core.judging.faceted_solids import Floats, Numbers
from gaussiancad_core.judging.misfits import Misfit, ViewMisfit
from gaussiancad_core.judging.sheet_ink import SheetInk

_ONE_SPOT = 0.05
"""Share of the longest extent within which what differs is one spot."""

_STRAIGHT = 0.01
"""Share of its length by which a straight difference spreads across it at most."""

Point = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Difference:
    """A place at which a solid and a sheet differ.

    Attributes:
        view: of the sheet.
        kind: in what.
        mm: of line.
        pieces: (n, 2, 2) mm in the view's plane (right, up), ends of the pieces of line, or twice
            the same place.
        line: number of the view's line; -1 where it is none's.
        edge: number of the solid's edge; -1 where it is none's.
        on_ink: share of it that lies on ink, 0 to 1; None where nobody looked.
    """

    view: DrawnView
    kind: Kind
    mm: float
    pieces: Floats
    line: int
    edge: int
    on_ink: float | None = None

    @property
    def cost(self) -> float:
        """mm of line at their price."""
        return PRICES[self.kind] * self.mm

    @property
    def ends(self) -> tuple[Point, Point]:
        """mm, its two outermost places."""
        places = self.pieces.reshape(-1, 2)
        along, _ = self._spread
        first, last = places[along.argmin()], places[along.argmax()]
        return (float(first[0]), float(first[1])), (float(last[0]), float(last[1]))

    @property
    def is_straight(self) -> bool:
        """Whether its places lie on one straight line."""
        along, across = self._spread
        return bool(np.ptp(across) <= _STRAIGHT * np.ptp(along))

    @property
    def is_hidden(self) -> bool:
        """Whether it is about a hidden line; where linetypes differ, about one of the sheet's."""
        if self.kind is Kind.LINETYPE and self.line >= 0:
            return not self.view.lines[self.line].is_visible
        return self.kind in (Kind.MISSING_HIDDEN, Kind.EXTRA_HIDDEN)

    @property
    def _spread(self) -> tuple[Floats, Floats]:
        """(2 n,) mm of its places along the way in which they spread most, and across it."""
        places = self.pieces.reshape(-1, 2)
        centre = places - places.mean(axis=0)
        along, across = np.linalg.svd(centre, full_matrices=True)[2]
        return centre @ along, centre @ across


def differences(misfit: Misfit, ink: SheetInk | None = None) -> tuple[Difference, ...]:
    """All places at which a solid and a sheet differ, the worst first.

    Args:
        misfit: of both.
        ink: of the sheet; without it nothing is told of it.
    """
    longest = max((_extent(view) for view in misfit.views), default=0.0)
    found = [
        difference
        for view in misfit.views
        for difference in _in_view(view, _ONE_SPOT * longest, ink)
    ]
    return tuple(sorted(found, key=lambda difference: -difference.cost))


def _extent(view: ViewMisfit) -> float:
    points = [line.points for line in view.view.lines]
    return float(np.ptp(np.concatenate(points), axis=0).max()) if points else 0.0


def _in_view(view: ViewMisfit, spot: float, ink: SheetInk | None) -> Iterator[Difference]:
    for number, kind in enumerate(KINDS):
        of_kind = view.kind == number
        for name in ("line", "edge"):
            values = getattr(view, name)
            for value in np.unique(values[of_kind & (values >= 0)]).tolist():
                chosen = of_kind & (values == value)
                line, edge = (value, -1) if name == "line" else (-1, value)
                yield _difference(view, kind, chosen, (line, edge), ink)
        loose = np.flatnonzero(of_kind & (view.line < 0) & (view.edge < 0))
        # What runs along an edge that is told by itself is told once.
        known = view.at[of_kind & (view.edge >= 0)]
        if len(known) and len(loose):
            loose = loose[cKDTree(known).query(view.at[loose])[0] > spot]
        for group in _spots(view.at[loose], spot):
            chosen = np.zeros(len(view.kind), bool)
            chosen[loose[group]] = True
            yield _difference(view, kind, chosen, (-1, -1), ink)


def _difference(
    view: ViewMisfit,
    kind: Kind,
    chosen: npt.NDArray[np.bool_],
    numbers: tuple[int, int],
    ink: SheetInk | None,
) -> Difference:
    line, edge = numbers
    on_ink = None
    if ink is not None and edge >= 0:
        covered = ink.covers(view.view.role, view.at[chosen])
        on_ink = float(np.average(covered, weights=view.mm[chosen]))
    mm = float(view.mm[chosen].sum())
    at, along = view.at[chosen], view.along[chosen]
    pieces = np.stack([at - along, at + along], axis=1)
    return Difference(view.view, kind, mm, pieces, line, edge, on_ink)


def _spots(places: Floats, reach: float) -> list[Numbers]:
    """Groups of places that are near each other."""
    if not len(places):
        return []
    pairs = cKDTree(places).query_pairs(reach, output_type="ndarray")
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), (len(places),) * 2)
    count, labels = connected_components(graph, directed=False)
    return [np.flatnonzero(labels == group) for group in range(count)]
