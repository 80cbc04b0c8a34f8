"""Which strokes bound a face of the arrangement that they make, and the faces themselves."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import Polygon

from gaussiancad_core.sheet_model.paper_sheet import PaperStroke

GRID = 0.02
"""mm to which places are rounded, so that ends meet."""

_FREE = 0.5
"""Share of a stroke that bounds nothing from which it is open."""


@dataclass(frozen=True, eq=False)
class Faces:
    """What strokes enclose.

    Attributes:
        faces: between them.
        dangles: pieces with an end in the open, which bound nothing.
    """

    faces: tuple[Polygon, ...]
    dangles: tuple[shapely.Geometry, ...]


def faces_of(strokes: Sequence[PaperStroke]) -> Faces:
    """The faces that strokes enclose, and what bounds none."""
    if not strokes:
        return Faces((), ())
    whole = shapely.union_all([stroke.line for stroke in strokes], grid_size=GRID)
    faces, cuts, dangles, _ = shapely.polygonize_full([whole])
    return Faces(tuple(faces.geoms), (*dangles.geoms, *cuts.geoms))


def are_closed(strokes: Sequence[PaperStroke]) -> np.ndarray:
    """(n,) which strokes bound faces along most of their length."""
    closed = np.ones(len(strokes), dtype=bool)
    loose = faces_of(strokes).dangles
    if not loose:
        return closed
    lines = [stroke.line for stroke in strokes]
    beside = [line.buffer(2.0 * GRID, cap_style="flat") for line in lines]
    numbers, pieces = shapely.STRtree(loose).query(lines, "dwithin", GRID)
    free = np.zeros(len(strokes))
    for number, piece in zip(numbers.tolist(), pieces.tolist(), strict=True):
        free[number] += loose[piece].intersection(beside[number]).length
    lengths = np.array([stroke.length for stroke in strokes])
    return np.asarray(free < _FREE * lengths)
