"""What parts seldom are: in pieces, or hollow where nothing shows it.

Where hidden lines are not drawn, parts differ that draw the same.  Of these the one is taken that
is in one piece, and that has the most material.
"""

from collections.abc import Sequence
from itertools import product
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.feature_kernels import Crossed, Operation, combine
from gaussiancad_core.proposing.lines_by_plane import Floats, PlaneSheet
from gaussiancad_core.proposing.part_features import Feature, Sights, nothing_crossed

_PIECE = 0.05
"""Share of the lines that another piece of the part counts."""

_HOLLOW = 0.01
"""The same of a part that is nothing but void."""

_ACROSS = 40
"""Lines of sight across the part at least: beside one between each two places."""

_SPECK = 0.005
"""Share of the material that a piece has at least to be one."""

_OF_HABITS = -1
"""Number of these lines of sight, which are no view's."""

_WAYS = ((1, 0), (0, 1), (1, 1), (1, -1))
"""From a line of sight to those beside it."""

Features = Sequence[tuple[Operation, Feature]]


class Habits:
    """Lines of sight through all of a part, by which its pieces and its material are counted.

    Args:
        sheet: its strokes by plane.
        near: mm within which two crossings are one.
    """

    def __init__(self, sheet: PlaneSheet, near: float) -> None:
        self._length, self._box = sheet.length, float(np.prod(sheet.size))
        self._near, self._tolerance = near, sheet.tolerance
        axis = max(Axis, key=lambda each: _count(sheet, each))
        (rows, heights), (columns, widths) = (
            _between(sheet.levels[Axis(index)]) for index in IN_PLANE[axis]
        )
        places = np.stack(np.meshgrid(rows, columns, indexing="ij"), axis=-1)
        self._areas = heights[:, None] * widths[None, :]
        self._sights = Sights(_OF_HABITS, axis, np.ascontiguousarray(places.reshape(-1, 2)))

    def unusual(self, features: Features) -> float:
        """mm of line that what is unusual about a part counts."""
        low, high = self._material(features)
        material = float((self._areas[..., None] * (high - low)).sum()) / self._box
        return self._of_pieces(low, high) + _HOLLOW * self._length * (1.0 - material)

    def of_pieces(self, features: Features) -> float:
        """mm of line that pieces of a part count beyond the first."""
        return self._of_pieces(*self._material(features))

    def _of_pieces(self, low: Floats, high: Floats) -> float:
        count = _pieces(low, high, self._areas, self._tolerance)
        return _PIECE * self._length * max(0, count - 1)

    def _material(self, features: Features) -> tuple[Floats, Floats]:
        """(r, c, k) mm from where to where lines of sight run through material; 0 beyond that."""
        crossed = nothing_crossed(len(self._sights.places))
        for operation, feature in features:
            table = feature.table(self._sights)
            if operation is Operation.MEET:
                rest = np.ones(len(crossed.counts), bool)
                rest[table.rows] = False
                crossed.counts[rest] = 0
            combine(crossed, table, np.array([int(operation)]), self._near)
        return _intervals(crossed, self._areas.shape)


def _count(sheet: PlaneSheet, axis: Axis) -> int:
    """Areas between the places that the plane across an axis has."""
    first, second = (len(sheet.levels[Axis(index)]) for index in IN_PLANE[axis])
    return first * second


def _between(levels: Floats) -> tuple[Floats, Floats]:
    """Places between levels, and on a raster, and the width that each stands for."""
    raster = np.linspace(levels[0], levels[-1], _ACROSS + 1)
    ends = np.unique(np.concatenate([levels, raster]))
    return (ends[1:] + ends[:-1]) / 2.0, np.diff(ends)


def _intervals(crossed: Crossed, shape: tuple[int, ...]) -> tuple[Floats, Floats]:
    counts = crossed.counts // 2
    most = max(1, int(counts.max(initial=1)))
    depth = crossed.depth[:, : 2 * most].reshape(*shape, most, 2)
    is_there = np.arange(most) < counts.reshape(shape)[..., None]
    low, high = (np.where(is_there, depth[..., end], 0.0) for end in (0, 1))
    return low, high


def _pieces(low: Floats, high: Floats, areas: Floats, tolerance: float) -> int:
    """How many pieces hang together, without specks."""
    most, is_there = low.shape[2], high - low > tolerance
    names = np.arange(low.size).reshape(low.shape)
    found = []
    for way in _WAYS:
        (low_1, high_1, name_1), (low_2, high_2, name_2) = (
            [_shifted(each, way, end) for each in (low, high, names)] for end in (0, 1)
        )
        for a, b in product(range(most), repeat=2):
            top = np.minimum(high_1[..., a], high_2[..., b])
            meets = top - np.maximum(low_1[..., a], low_2[..., b]) > tolerance
            found.append(np.stack([name_1[..., a][meets], name_2[..., b][meets]]))
    ends = np.concatenate(found, axis=1)
    graph = coo_array((np.ones(ends.shape[1]), ends), shape=(low.size, low.size))
    _, labels = connected_components(graph, directed=False)
    volumes = np.bincount(labels, (areas[..., None] * (high - low) * is_there).reshape(-1))
    return int((volumes > _SPECK * volumes.sum()).sum())


def _shifted(values: npt.NDArray[Any], way: tuple[int, int], end: int) -> npt.NDArray[Any]:
    """Values of the one lines of sight, or of those that lie beside them in a way."""
    rows, columns = values.shape[:2]
    (down, aside), back = way, way[1] < 0
    first = down if end else 0
    second = (0 if end else 1) if back else (aside if end else 0)
    return values[first : first + rows - down, second : second + columns - abs(aside)]
