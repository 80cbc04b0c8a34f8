"""Bodies that a region of a plane sweeps: along the plane's normal, or around an axis in it."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.cells.arrangement import OUTSIDE
from gaussiancad_core.features.frames import Frame
from gaussiancad_core.features.sketch_cells import Cells

Points = npt.NDArray[np.float64]

_ASIDE = np.array([0.00137, 0.00219, -0.00173])
"""Units beside a point at which the same cell is found, where it is clearly in one."""


@dataclass(frozen=True)
class TurnAxis:
    """What a half plane is turned around.

    Attributes:
        point: on the axis; units.
        direction: unit vector.
    """

    point: tuple[float, float, float]
    direction: tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class SweptPlane:
    """A plane whose cells sweep.

    Attributes:
        frame: the plane; of turned bodies one through the axis.
        cells: of it; units.  Of turned bodies the first coordinate runs along the axis, the second
            away from it.
        axis: that it turns around; None of one that moves along its normal.
    """

    frame: Frame
    cells: Cells
    axis: TurnAxis | None = None

    def located(self, points: Points) -> tuple[npt.NDArray[np.int64], Points]:
        """Cells and heights of (n, 3) points; turned bodies have no heights (0)."""
        if self.axis is None:
            seen = self.frame.project(points)
            return self.cells.locate(seen[:, :2]), seen[:, 2]
        away = points - np.array(self.axis.point)
        along = away @ np.array(self.axis.direction)
        radius = np.linalg.norm(away - along[:, None] * np.array(self.axis.direction), axis=1)
        flat = np.stack([along, radius], axis=1)
        return self.cells.locate(flat), np.zeros(len(points))

    def clearly_in(self, points: Points) -> npt.NDArray[np.int64]:
        """(n,) cells of points; -1 of those at a border between two."""
        found = self.located(points)[0]
        for aside in (_ASIDE, -_ASIDE):
            found = np.where(self.located(points + aside)[0] == found, found, -1)
        return found


@dataclass(frozen=True)
class Sweep:
    """Cells of a plane, swept.

    Attributes:
        plane: its number.
        cells: that sweep.
        ends: along the normal; (0, 0) of turned bodies.
        adds: whether it is material, or taken away.
        edges: of its outline.
        border: length of the outline, units; bodies of as many edges, as long, are taken for the
            same one elsewhere.
    """

    plane: int
    cells: frozenset[int]
    ends: tuple[float, float]
    adds: bool
    edges: int
    border: float

    def covers(self, cells: npt.NDArray[np.int64], heights: Points) -> npt.NDArray[np.bool_]:
        """(n,) which points it covers, by their cells and heights in its plane."""
        within = np.isin(cells, list(self.cells))
        if self.ends == (0.0, 0.0):
            return within
        low, high = self.ends
        return within & (heights > low) & (heights < high)


def regions_of(
    cells: Cells, full: npt.NDArray[np.bool_], touched: npt.NDArray[np.bool_]
) -> Iterator[tuple[frozenset[int], bool]]:
    """Regions worth sweeping, and whether they add: what is material all along, what is in part,
    both also with what they enclose; and, to take away, what is void all along.

    Args:
        cells: of the plane.
        full: (cells,) whether a cell sweeps nothing but material.
        touched: (cells,) whether it sweeps some.
    """
    solid = [*_groups(cells, full), *_groups(cells, touched)]
    for group in dict.fromkeys([*solid, *(cells.filled(group) for group in solid)]):
        yield group, True
    for group in _groups(cells, ~touched):
        yield group, False


def _groups(cells: Cells, chosen: npt.NDArray[np.bool_]) -> list[frozenset[int]]:
    return cells.components([int(k) for k in np.flatnonzero(chosen) if k != OUTSIDE])
