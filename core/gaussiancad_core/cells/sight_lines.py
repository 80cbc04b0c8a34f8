"""What many pieces of lines say of the cells beside them.

The kernels' side of :mod:`gaussiancad_core.labelling.visibility_rules`.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from math import cos, sin

import numpy as np
import numpy.typing as npt

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.cells.arrangement_kernels import Integers, Traces, traces
from gaussiancad_core.cells.cell_complex import Body, Cell, CellComplex, Surface, side_views
from gaussiancad_core.cells.crossing_kernels import SURFACES, VOID, Frame, Sides, Told, statements
from gaussiancad_core.cells.edge_fragments import Piece
from gaussiancad_core.cells.half_spaces import HalfSpace
from gaussiancad_core.cells.revolution_kernels import (
    BEYOND,
    CONE,
    HALF_SPACE,
    PLACES,
    PROFILE,
    ROUND,
    SECTOR,
)
from gaussiancad_core.cells.surfaces_of_revolution import ArcProfile, SurfaceOfRevolution
from gaussiancad_core.geometry.tolerances import ASIDE
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import role_plane
from gaussiancad_core.model.views import Linetype

_DECIMALS = 7
"""Of units: coordinates that differ by less have one trace."""

_BITS = 62
"""Of the key of a cell at most."""


class Keys:
    """Cells as numbers.

    Args:
        space: of the cells.

    Attributes:
        sizes: (3,) regions of the planes.
        fit: whether all cells have keys.
    """

    def __init__(self, space: CellComplex) -> None:
        self.sizes = np.array([space.planes[axis].regions for axis in Axis], dtype=np.int64)
        self._bodies = len(space.bodies)
        places = int(np.prod([float(size) for size in self.sizes])).bit_length()
        self.fit = places + self._bodies < _BITS
        self._known: dict[int, Cell | None] = {VOID: None}

    def cell(self, key: int) -> Cell | None:
        """The cell of a key; the same object each time."""
        if key not in self._known:
            place, bits = key >> self._bodies, key & (1 << self._bodies) - 1
            rest, z = divmod(place, int(self.sizes[2]))
            x, y = divmod(rest, int(self.sizes[1]))
            self._known[key] = x, y, z, bits
        return self._known[key]


@dataclass(frozen=True)
class Seen:
    """Columns along one axis that the kernels have looked at.

    Attributes:
        normal: the axis.
        crossings: those that the kernels found.
        keys: of the cells.
    """

    normal: Axis
    crossings: Told
    keys: Keys

    def longest(self) -> Iterator[tuple[Cell, float]]:
        """Cells, each with its longest stretch along the axis."""
        found = self.crossings
        inside = found.after != VOID
        # Behind the last crossing of a column there is nothing.
        ends = found.columns[1:][np.diff(found.columns) > 0] - 1
        inside[ends] = False
        places = np.flatnonzero(inside)
        cells, numbers = np.unique(found.after[places], return_inverse=True)
        depths = np.zeros(cells.size)
        np.maximum.at(depths, numbers, found.depths[places + 1] - found.depths[places])
        for key, depth in zip(cells.tolist(), depths.tolist(), strict=True):
            cell = self.keys.cell(key)
            if cell is not None:
                yield cell, depth

    def crossed(self) -> Iterator[tuple[Cell | None, Cell | None, Surface]]:
        """Pairs of cells that follow each other, and the surfaces between them; each once."""
        found = self.crossings
        rows = np.stack([found.before, found.after, found.surfaces], axis=1)
        _, first = np.unique(rows, axis=0, return_index=True)
        for one, other, surface in rows[np.sort(first)].tolist():
            plane, carrier = divmod(surface, SURFACES)
            yield self.keys.cell(one), self.keys.cell(other), (plane, carrier - 1)


class SightLines:
    """Looks at both sides of pieces, many at a time.

    Args:
        space: the cells.

    Attributes:
        keys: of the cells.
        fit: whether the kernels can express all of the space.
    """

    def __init__(self, space: CellComplex) -> None:
        self._space = space
        self.keys = Keys(space)
        bodies = body_table(space.bodies)
        self.fit = self.keys.fit and bodies is not None
        self._bodies = np.zeros((0, PLACES)) if bodies is None else bodies
        counting = np.zeros((3, int(self.keys.sizes.max())), dtype=np.int64)
        for row, items in zip(counting, space.counting, strict=True) if self.fit else ():
            row[: len(items)] = items
        self._counting = counting

    def said(self, pieces: Sequence[Piece]) -> Iterator[tuple[Piece, bytes]]:
        """Pieces that say something, and what: 64-bit integers, group by group.

        Each group is how many pairs, lone and different transitions there are, and then these, by
        the keys of their cells.  Equal bytes are equal groups.
        """
        for normal, run in groupby(pieces, key=lambda piece: role_plane(piece.role).normal):
            this_pieces = list(run)
            found = statements(self._frame(normal), self._sides(normal, this_pieces))
            self._space.look_at(Seen(normal, found, self.keys))
            stream, starts = found.stream.tobytes(), (8 * found.starts).tolist()
            for number in np.flatnonzero(found.says).tolist():
                yield this_pieces[number], stream[starts[number] : starts[number + 1]]

    def _frame(self, normal: Axis) -> Frame:
        planes = [plane.value for plane, _ in side_views(normal)]
        return Frame(
            normal.value,
            np.array(planes, dtype=np.int64),
            self._space.planes[normal].table,
            self._bodies,
            self._counting,
            self.keys.sizes,
        )

    def _sides(self, normal: Axis, pieces: Sequence[Piece]) -> Sides:
        points = np.array([piece.point for piece in pieces])
        across = np.array([piece.across for piece in pieces])
        ways = np.array([-ASIDE, ASIDE])
        at = points[:, None, :] + ways[None, :, None] * across[:, None, :]
        traced = np.empty(at.shape, dtype=np.int64)
        found: list[Traces] = []
        for coordinate, (plane, place) in enumerate(side_views(normal)):
            numbers, lines = self._traces(plane, place, at[:, :, coordinate])
            traced[:, :, coordinate] = numbers
            found.append(lines)
        drawn = np.array([piece.linetype is not None for piece in pieces])
        upward = np.array([role_plane(piece.role).looks_up for piece in pieces])
        return Sides(points, across, drawn, upward, traced, *found)

    def _traces(
        self, plane: Axis, place: int, values: npt.NDArray[np.float64]
    ) -> tuple[Integers, Traces]:
        """Traces of a plane at values of one of its coordinates, and the number of each value's."""
        _, first, numbers = np.unique(
            np.round(values.ravel(), _DECIMALS), return_index=True, return_inverse=True
        )
        lines = traces(self._space.planes[plane].table, place, values.ravel()[first])
        return numbers.reshape(values.shape), lines


def warm_up() -> None:
    """Compile the kernels, or load them from numba's cache, so that the first part is quick."""
    nowhere = CellComplex({axis: Arrangement(()) for axis in Axis})
    piece = Piece(Role.FRONT, (0.0, 0.0), (1.0, 0.0), Linetype.VISIBLE, 1.0)
    for _ in SightLines(nowhere).said([piece]):
        pass


def body_table(bodies: Sequence[Body]) -> npt.NDArray[np.float64] | None:
    """(n, 16) rows of bodies; None if one is of another kind."""
    table = np.zeros((len(bodies), PLACES))
    for row, body in zip(table, bodies, strict=True):
        if isinstance(body, HalfSpace):
            row[:5] = HALF_SPACE, *body.normal, body.offset
        elif isinstance(body, SurfaceOfRevolution):
            profile = body.profile
            row[:PROFILE] = (
                ROUND if isinstance(profile, ArcProfile) else CONE,
                body.axis.value,
                *body.centre,
                profile.low,
                profile.high,
            )
            if isinstance(profile, ArcProfile):
                arc = profile.z, profile.r, profile.radius_of_arc, profile.side
                row[PROFILE : PROFILE + 4] = arc
            else:
                row[PROFILE : PROFILE + 2] = profile.at_low, profile.at_high
            if body.sector is not None:
                start, sweep = body.sector
                end = start + sweep
                inward = -sin(start), cos(start), sin(end), -cos(end)
                row[SECTOR:BEYOND] = 1.0, *inward
            row[BEYOND] = body.is_beyond
        else:
            return None
    return table
