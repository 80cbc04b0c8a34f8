"""All parts that boxes of a small grid make up, and which of them look alike.

A part is a set of boxes, told by a number: bit ``x + nx (y + ny z)`` is box (x, y, z).  What each
view shows of every one of the up to 2^18 parts is told by looking along its columns, without the
engine: just beside a line the surfaces that both columns pass are no line, and the first one that
they do not share is one, visible if no shared surface comes before it.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse
from OCP.collections import List_TopoDS_Shape
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import subshapes
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment
from sample_parts.modelling import box

_KINDS = {1: Linetype.VISIBLE, 2: Linetype.HIDDEN}

Codes = npt.NDArray[np.uint8]
Hashes = npt.NDArray[np.uint64]
Bools = npt.NDArray[np.bool_]

Looks = dict[tuple[Role, bool], Hashes]
"""What parts look like in a view, with hidden lines or without."""


@dataclass(frozen=True)
class Grid:
    """A grid of boxes.

    Attributes:
        shape: (3,) boxes along x, y and z.
    """

    shape: tuple[int, int, int]

    @property
    def cells(self) -> int:
        """How many boxes."""
        return int(np.prod(self.shape))

    def boxes(self, parts: npt.NDArray[np.int64]) -> Bools:
        """(k, nx, ny, nz) which boxes some parts have."""
        bits = (parts[:, None] >> np.arange(self.cells)) & 1
        nx, ny, nz = self.shape
        return bits.astype(bool).reshape(-1, nz, ny, nx).transpose(0, 3, 2, 1)


@cache
def sound_parts(grid: Grid) -> npt.NDArray[np.int64]:
    """(k,) numbers of all parts that are sound, of a grid of up to 18 boxes or so."""
    numbers = np.arange(1 << grid.cells)
    return numbers[are_sound(grid, numbers)]


def are_sound(grid: Grid, numbers: npt.NDArray[np.int64]) -> Bools:
    """(k,) whether parts are one solid each, and fill the grid's extents.

    Boxes of one hang together by faces, and nowhere touch by an edge or a corner alone.
    """
    labels = grid.boxes(numbers)
    fine = np.ones(len(labels), bool)
    for axis in range(3):
        others = tuple(1 + k for k in range(3) if k != axis)
        filled = labels.any(axis=others)
        fine &= filled[:, 0] & filled[:, -1]
    padded = np.pad(labels, ((0, 0), (1, 1), (1, 1), (1, 1)))
    nx, ny, nz = (n + 1 for n in grid.shape)
    corner = np.array([_is_fine_corner(code) for code in range(256)])
    for x, y, z in np.ndindex(nx, ny, nz):
        around = padded[:, x : x + 2, y : y + 2, z : z + 2].reshape(-1, 8)
        fine &= corner[around @ (1 << np.arange(8))]
    found = np.flatnonzero(fine)
    fine[found] = _hang_together(grid, numbers[found])
    return fine


def _is_fine_corner(code: int) -> bool:
    """Whether the eight boxes around a corner, a bit each, bound one surface there."""
    around = ((code >> np.arange(8)) & 1).reshape(2, 2, 2).astype(bool)
    for turned in (around, around.transpose(1, 2, 0), around.transpose(2, 0, 1)):
        for square in turned:
            if square[0, 0] == square[1, 1] != square[0, 1] == square[1, 0]:
                return False
    return _is_one(around) and _is_one(~around)


def _is_one(around: Bools) -> bool:
    """Whether the set boxes of 2 x 2 x 2 hang together by faces; none do."""
    left = {tuple(at) for at in np.argwhere(around).tolist()}
    reached = [left.pop()] if left else []
    for at in reached:
        others = {other for other in left if np.abs(np.subtract(at, other)).sum() == 1}
        left -= others
        reached += others
    return not left


def _hang_together(grid: Grid, numbers: npt.NDArray[np.int64]) -> Bools:
    nx, ny, nz = grid.shape
    index = np.arange(grid.cells).reshape(nz, ny, nx)
    neighbour = np.zeros(grid.cells, np.int64)
    for axis in range(3):
        low = np.delete(index, -1, axis=axis).ravel()
        high = np.delete(index, 0, axis=axis).ravel()
        np.bitwise_or.at(neighbour, low, 1 << high)
        np.bitwise_or.at(neighbour, high, 1 << low)
    reached = numbers & -numbers
    while True:
        grown = reached.copy()
        for cell in range(grid.cells):
            touched = (grown & neighbour[cell]) != 0
            grown |= np.where(touched, numbers & (1 << cell), 0)
        if (grown == reached).all():
            return reached == numbers
        reached = grown


@cache
def looks(grid: Grid) -> Looks:
    """What each sound part looks like, of a grid of up to 18 boxes or so."""
    return looks_of(grid, sound_parts(grid))


def looks_of(grid: Grid, numbers: npt.NDArray[np.int64]) -> Looks:
    """(k,) what parts look like in each view, as a number; with hidden lines, or without.

    Parts look alike where the numbers are equal, but for a chance of one in 10^13; numbers of views
    from opposite sides are of one kind.
    """
    labels = grid.boxes(numbers)
    found = {}
    for role in Role:
        random = np.random.default_rng(role.frame.look_axis[0].value)
        whole = seen = np.zeros(len(labels), np.uint64)
        for codes in view_codes(labels, role):
            flat = codes.reshape(len(codes), -1)
            visible, hidden = random.integers(0, 2**64, (2, flat.shape[1]), np.uint64)
            seen = seen + np.where(flat == 1, visible, np.uint64(0)).sum(axis=1, dtype=np.uint64)
            whole = whole + np.where(flat == 2, hidden, np.uint64(0)).sum(axis=1, dtype=np.uint64)
        found[role, False], found[role, True] = seen, whole + seen
    return found


def view_codes(labels: Bools, role: Role) -> tuple[Codes, Codes]:
    """What is drawn on each unit of line in a view: 0 for nothing, 1 visible, 2 hidden.

    Args:
        labels: (k, nx, ny, nz) boxes.
        role: the view.

    Returns:
        (k, nr + 1, nu) of the lines that run up, and (k, nr, nu + 1) of those that run to the
        right; counted rightwards and upwards.
    """
    frame = role.frame
    order = [frame.right_axis, frame.up_axis, frame.look_axis]
    turned = labels.transpose(0, *(1 + axis.value for axis, _ in order))
    turned = turned[(slice(None), *(slice(None, None, sign) for _, sign in order))]
    padded = np.pad(turned, ((0, 0), (0, 0), (0, 0), (1, 1)))
    passed = padded[..., 1:] != padded[..., :-1]
    upright = np.pad(passed, ((0, 0), (1, 1), (0, 0), (0, 0)))
    level = np.pad(passed, ((0, 0), (0, 0), (1, 1), (0, 0)))
    return (
        _codes(upright[:, :-1], upright[:, 1:]),
        _codes(level[:, :, :-1], level[:, :, 1:]),
    )


def _codes(one: Bools, other: Bools) -> Codes:
    """What is drawn between columns that pass surfaces at these depths."""
    codes = np.zeros(one.shape[:-1], np.uint8)
    covered = np.zeros(one.shape[:-1], bool)
    for depth in range(one.shape[-1]):
        first = (one[..., depth] != other[..., depth]) & (codes == 0)
        codes[first & ~covered], codes[first & covered] = 1, 2
        covered |= one[..., depth] & other[..., depth]
    return codes


Places = tuple[tuple[float, ...], tuple[float, ...], tuple[float, ...]]
"""mm along x, y and z at which a grid's boxes begin and end."""


def grid_strokes(grid: Grid, part: int, places: Places, role: Role) -> tuple[Segment, ...]:
    """The lines of a part in a view, in mm of its plane; lines that go on are one."""
    upright, level = view_codes(grid.boxes(np.array([part])), role)
    frame = role.frame
    right, up = (
        sorted(sign * place for place in places[axis.value])
        for axis, sign in (frame.right_axis, frame.up_axis)
    )
    found = []
    for column, at in enumerate(right):
        for low, high, kind in _runs(upright[0, column]):
            found.append(Segment((at, up[low]), (at, up[high]), kind))
    for row, at in enumerate(up):
        for low, high, kind in _runs(level[0, :, row]):
            found.append(Segment((right[low], at), (right[high], at), kind))
    return tuple(found)


def _runs(codes: Codes) -> Iterator[tuple[int, int, Linetype]]:
    """Stretches of one kind of line."""
    borders = [0, *(1 + np.flatnonzero(np.diff(codes))).tolist(), len(codes)]
    for low, high in pairwise(borders):
        if codes[low]:
            yield low, high, _KINDS[int(codes[low])]


def grid_solid(grid: Grid, part: int, places: Places) -> TopoDS_Shape:
    """The solid of a part, mm."""
    boxes = []
    for at in np.argwhere(grid.boxes(np.array([part]))[0]):
        low = tuple(places[k][at[k]] for k in range(3))
        high = tuple(places[k][at[k] + 1] for k in range(3))
        boxes.append(box(low, high))
    if len(boxes) == 1:
        return boxes[0]
    first, others = List_TopoDS_Shape(), List_TopoDS_Shape()
    first.Append(boxes[0])
    for this_box in boxes[1:]:
        others.Append(this_box)
    maker = BRepAlgoAPI_Fuse()
    maker.SetArguments(first)
    maker.SetTools(others)
    maker.Build()
    unifier = ShapeUpgrade_UnifySameDomain(maker.Shape(), True, True, False)
    unifier.Build()
    return subshapes(unifier.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)[0]
