"""Which strokes bound a face of the arrangement that they make, and the faces themselves."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely import Polygon

from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, lines_of

GRID = 0.02
"""mm to which places are rounded, so that ends meet."""


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
    whole = shapely.union_all(lines_of(strokes), grid_size=GRID)
    faces, cuts, dangles, _ = shapely.polygonize_full([whole])
    return Faces(tuple(faces.geoms), (*dangles.geoms, *cuts.geoms))


def loose_lengths(strokes: Sequence[PaperStroke]) -> npt.NDArray[np.float64]:
    """(n,) mm of each stroke that bound no face."""
    free = np.zeros(len(strokes))
    loose = faces_of(strokes).dangles
    if loose:
        lines = lines_of(strokes)
        numbers, pieces = shapely.STRtree(loose).query(lines, "dwithin", GRID)
        strips = shapely.buffer(lines, 2.0 * GRID, cap_style="flat")
        along = shapely.intersection(np.array(loose)[pieces], strips[numbers])
        np.add.at(free, numbers, shapely.length(along))
    return free
