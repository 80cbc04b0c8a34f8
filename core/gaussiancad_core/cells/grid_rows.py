"""The lines of a plane's grid along which pieces say something, and how many pieces they have.

The grid has a line wherever a coordinate has a value of some corner.  Most pieces of a part lie on
it, so that large models are known before they are made.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.cells.arrangement_kernels import CHAIN, traces
from gaussiancad_core.cells.cell_complex import CellComplex
from gaussiancad_core.coordinates.drawn_intervals import Carrier
from gaussiancad_core.geometry.tolerances import ASIDE, ON_CURVE, SHORTEST
from gaussiancad_core.geometry.whole_curves import Line, LineOrCircle
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE


@dataclass(frozen=True)
class Row:
    """A line of the grid of values that may show something.

    Attributes:
        coordinate: which one is the same all along.
        value: of that.
        carrier: that the plane has there.
        cuts: of the other coordinate, ascending: between two of them nothing changes.
    """

    coordinate: int
    value: float
    carrier: Carrier | None
    cuts: tuple[float, ...]

    def pieces(self) -> Iterator[tuple[float, float]]:
        """Ends of its pieces."""
        for low, high in pairwise(self.cuts):
            if high - low >= SHORTEST:
                yield low, high


def find_rows(space: CellComplex, normal: Axis) -> list[Row]:
    """The lines of a plane's grid along which pieces say something."""
    plane = space.planes[normal]
    values = [space.values[Axis(index)] for index in IN_PLANE[normal]]
    rows = []
    for coordinate in (0, 1):
        on_axis = [s for s in plane.carriers if s.curve.axis == coordinate]
        changes = _changes(space, normal, coordinate, values[coordinate])
        for value, change in zip(values[coordinate], changes, strict=True):
            carrier = next((s for s in on_axis if _is_at(s.curve, coordinate, value)), None)
            if carrier is None and not change:
                continue
            slanted = [
                position
                for position, number in _met(plane, coordinate, value)
                if number != CHAIN and plane.carriers[number].curve.axis is None
            ]
            cuts = tuple(sorted([*values[1 - coordinate], *slanted]))
            rows.append(Row(coordinate, value, carrier, cuts))
    return rows


def count_pieces(rows: Sequence[Row]) -> int:
    """How many pieces lines of a grid have."""
    return sum(int(np.count_nonzero(np.diff(row.cuts) >= SHORTEST)) for row in rows)


def _met(plane: Arrangement, coordinate: int, value: float) -> Iterator[tuple[float, int]]:
    """Where a line of the grid meets carriers, and which."""
    trace = plane.trace(coordinate, value)
    return zip(trace.positions, trace.carriers, strict=True)


def _changes(
    space: CellComplex, normal: Axis, coordinate: int, values: Sequence[float]
) -> list[bool]:
    """Of values whether columns differ on both sides, be there no line of the plane itself.

    Of the planes beside, only the one that shows this coordinate can tell the sides apart.
    """
    if any(body.outlines(normal) is None for body in space.bodies):
        return [True] * len(values)
    axis = Axis(IN_PLANE[normal][coordinate])
    adjacent_plane = next(plane for plane in Axis if plane not in (normal, axis))
    place = IN_PLANE[adjacent_plane].index(axis.value)
    sides = np.array(values)[:, None] + np.array([-ASIDE, ASIDE])
    found = traces(space.planes[adjacent_plane].table, place, sides.ravel())
    slices = [slice(low, high) for low, high in pairwise(found.starts.tolist())]
    return [
        found.first[k] != found.first[k + 1]
        or not np.array_equal(found.carriers[slices[k]], found.carriers[slices[k + 1]])
        or not np.array_equal(found.regions[slices[k]], found.regions[slices[k + 1]])
        for k in range(0, len(slices), 2)
    ]


def _is_at(curve: LineOrCircle, coordinate: int, value: float) -> bool:
    return isinstance(curve, Line) and abs(curve.point[coordinate] - value) < ON_CURVE
