"""A part in the making: its operations in order, and a coarse map of where its material is.

The map's cells are cubes of two millimetres, each full, empty, or mixed where a surface runs
through it.  Features ask it for a *site*: a rectangle on a flat piece of surface, how deep the
material below is, and whether a tool reaches the surface from outside.  So features keep their
distance from each other's walls, and the part stays in one piece, without any Boolean until the
end.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, IntEnum
from itertools import groupby

import numpy as np
import numpy.typing as npt
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import subshapes
from gaussiancad_core.model.axes import Axis
from sample_parts.classed.outlines import Outline, combined, sampled
from sample_parts.modelling import Point2, Point3

CELL = 2.0
"""mm of a cell's edge: all coordinates that matter are its multiples."""

BEYOND = 2.0
"""mm by which tools reach out of the part that they cut."""

_ROOM = 30
"""Cells around the body for what is built onto it."""

WALLS = (1, 1)
"""Cells of material that stay between a feature and what is beside it, in both directions."""

Cells = npt.NDArray[np.int8]


class Fill(IntEnum):
    """What is in a cell."""

    EMPTY = 0
    FULL = 1
    MIXED = 2


class Change(Enum):
    """What an operation does with its solid."""

    ADD = "add"
    CUT = "cut"


@dataclass(frozen=True)
class Site:
    """A rectangle on the part's surface on which a feature can stand or sink in.

    Attributes:
        axis: across which it lies.
        sign: +1 where the surface looks towards higher coordinates.
        low, high: (2,) corners in the plane across the axis, mm.
        level: coordinate of the surface along the axis, mm.
        depth: mm of material below it, all over.
        runs: pieces of material that a tool passes on its whole way; 0 where these are not
            equally thick all over.
    """

    axis: Axis
    sign: int
    low: Point2
    high: Point2
    level: float
    depth: float
    runs: int

    @property
    def centre(self) -> Point2:
        """The rectangle's middle."""
        return (self.low[0] + self.high[0]) / 2.0, (self.low[1] + self.high[1]) / 2.0

    @property
    def extent(self) -> Point2:
        """The rectangle's edges, mm."""
        return self.high[0] - self.low[0], self.high[1] - self.low[1]

    def at(self, height: float) -> float:
        """The coordinate along the axis at a height above the surface, negative below."""
        return self.level + self.sign * height

    def span(self, one: float, other: float) -> tuple[float, float]:
        """The interval along the axis between two heights."""
        first, last = sorted((self.at(one), self.at(other)))
        return first, last


class Stock:
    """A part in the making.

    Args:
        size: (3,) mm of the box that the body fills, multiples of the cells; it starts at 0.
    """

    def __init__(self, size: Point3) -> None:
        self.size: Point3 = (float(size[0]), float(size[1]), float(size[2]))
        self._cells: Cells = np.zeros(
            [round(value / CELL) + 2 * _ROOM for value in self.size], dtype=np.int8
        )
        self._operations: list[tuple[Change, TopoDS_Shape]] = []

    def apply(self, change: Change, solid: TopoDS_Shape) -> None:
        """Add or cut a solid; what it does to the map is told by ``mark_...``."""
        self._operations.append((change, solid))

    def mark_box(self, lower: Point3, upper: Point3, fill: Fill) -> None:
        """Fill the cells between two corners on the cells' borders."""
        block = tuple(
            slice(*_cells_over(low, high)) for low, high in zip(lower, upper, strict=True)
        )
        self._cells[block] = fill

    def mark(self, axis: Axis, outline: Outline, span: tuple[float, float], fill: Fill) -> None:
        """Fill the cells of an outline extruded along an axis; those on its border become mixed."""
        shape = np.delete(self._cells.shape, axis.value)
        inside, touched = _rasterised(sampled(outline), shape.tolist())
        block = np.moveaxis(self._cells, axis.value, 0)[slice(*_cells_over(*span))]
        # Nothing changes where material is added to material, or cut from air.
        block[:, touched] = np.where(block[:, touched] == fill, fill, Fill.MIXED)
        block[:, inside] = fill

    def full(self, lower: Point3, upper: Point3) -> bool:
        """Whether there is nothing but material between two corners."""
        block = tuple(
            slice(*_cells_over(low, high)) for low, high in zip(lower, upper, strict=True)
        )
        return bool((self._cells[block] == Fill.FULL).all())

    def site(
        self, axis: Axis, sign: int, low: Point2, high: Point2, walls: tuple[int, int] = WALLS
    ) -> Site | None:
        """The site of a rectangle, if the surface under it is flat, whole and can be reached.

        Args:
            axis: along which the tool comes.
            sign: +1 for a tool from the side of higher coordinates.
            low, high: (2,) corners across the axis, mm.
            walls: cells beside the rectangle, in both directions, that must be like those in it.
        """
        columns = self._columns(axis, sign, low, high, walls)
        if columns is None:
            return None
        occupied = columns != Fill.EMPTY
        tops = np.where(occupied.any(axis=0), occupied.argmax(axis=0), -1)
        top = int(tops.flat[0])
        if top < 0 or (tops != top).any():
            return None
        full = (columns == Fill.FULL)[top:]
        depths = np.where(full.all(axis=0), len(full), (~full).argmax(axis=0))
        depth = int(depths.min())
        if depth == 0:
            return None
        level = (top - _ROOM) * CELL
        if sign > 0:
            level = self.size[axis.value] - level
        return Site(axis, sign, low, high, level, depth * CELL, _runs(columns))

    def _columns(
        self, axis: Axis, sign: int, low: Point2, high: Point2, walls: tuple[int, int]
    ) -> Cells | None:
        """(n, a, b) cells along a tool's way, from outside, or nothing beyond the map."""
        block = np.moveaxis(self._cells, axis.value, 0)
        if sign > 0:
            block = block[::-1]
        ranges = []
        for first, last, wall in zip(low, high, walls, strict=True):
            start, end = _cells_over(first, last)
            ranges.append((start - wall, end + wall))
        (a0, a1), (b0, b1) = ranges
        if min(a0, b0) < 0 or a1 > block.shape[1] or b1 > block.shape[2]:
            return None
        return block[:, a0:a1, b0:b1]

    def solid(self) -> TopoDS_Shape:
        """The part: all operations carried out, faces that continue each other made one."""
        shape: TopoDS_Shape | None = None
        for change, group in groupby(self._operations, key=lambda operation: operation[0]):
            tools = [tool for _, tool in group]
            if shape is None:
                shape, *tools = tools
            if tools:
                kind = BRepAlgoAPI_Fuse if change is Change.ADD else BRepAlgoAPI_Cut
                shape = combined(kind, shape, tools)
        unifier = ShapeUpgrade_UnifySameDomain(shape, True, True, False)
        unifier.Build()
        solids = subshapes(unifier.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)
        return solids[0] if len(solids) == 1 else unifier.Shape()


def _cells_over(low: float, high: float) -> tuple[int, int]:
    """Indices of the cells that an interval touches."""
    return int(np.floor(low / CELL + 1e-6)) + _ROOM, int(np.ceil(high / CELL - 1e-6)) + _ROOM


def _runs(columns: Cells) -> int:
    """Pieces of material along (n, a, b) columns that are all alike, else 0."""
    first = columns[:, 0, 0]
    if (columns != first[:, None, None]).any() or (first == Fill.MIXED).any():
        return 0
    return int((np.diff(first, prepend=Fill.EMPTY) > 0).sum())


def _rasterised(
    points: npt.NDArray[np.float64], shape: Sequence[int]
) -> tuple[npt.NDArray[np.bool_], npt.NDArray[np.bool_]]:
    """Cells within a closed chain, and cells that it runs through; both of ``shape``."""
    touched = np.zeros(shape, dtype=bool)
    steps = np.linspace(0.0, 1.0, 1 + int(np.ceil(np.ptp(points, axis=0).max() / (0.2 * CELL))))
    ends = np.roll(points, -1, axis=0)
    along = points[:, None] + steps[:, None] * (ends - points)[:, None]
    # A chain on a border between cells runs through neither of them.
    near = along.reshape(-1, 2) / CELL + _ROOM
    off = np.abs(near - np.rint(near)) > 1e-6
    kept = near[off.all(axis=1)]
    x, y = np.floor(kept).astype(int).T
    within = (x >= 0) & (y >= 0) & (x < shape[0]) & (y < shape[1])
    touched[x[within], y[within]] = True
    centres = [(np.arange(count) - _ROOM + 0.5) * CELL for count in shape]
    inside = _inside(points, *np.meshgrid(*centres, indexing="ij"))
    return inside & ~touched, touched


def _inside(
    points: npt.NDArray[np.float64], x: npt.NDArray[np.float64], y: npt.NDArray[np.float64]
) -> npt.NDArray[np.bool_]:
    """Whether places lie within a closed chain: even-odd rule."""
    odd = np.zeros(x.shape, dtype=bool)
    for (x0, y0), (x1, y1) in zip(points, np.roll(points, -1, axis=0), strict=True):
        if y0 == y1:
            continue
        spans = (y0 > y) != (y1 > y)
        odd ^= spans & (x < x0 + (y - y0) * (x1 - x0) / (y1 - y0))
    return odd
