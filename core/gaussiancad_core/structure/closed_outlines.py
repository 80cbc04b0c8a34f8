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

_GAP = 0.12
"""mm that an end may miss what it meets: arcs that are fitted to what a program has written as free
curves end beside their neighbours; a gap that is drawn is as wide as a wide line at least."""

_TURN = 4.0
"""Length of a curve that comes back to where it begins, in that gap, at least."""


@dataclass(frozen=True, eq=False)
class Faces:
    """What strokes enclose.

    Attributes:
        faces: between them.
        dangles: pieces with an end in the open, which bound nothing.
    """

    faces: tuple[Polygon, ...]
    dangles: tuple[shapely.Geometry, ...]

    @property
    def outline(self) -> shapely.Geometry:
        """Of all faces together: they share their edges, whole ones, so that none is searched."""
        return shapely.coverage_union_all(self.faces)


def faces_of(strokes: Sequence[PaperStroke]) -> Faces:
    """The faces that strokes enclose, and what bounds none."""
    if not strokes:
        return Faces((), ())
    lines = lines_of(strokes)
    whole = shapely.union_all([*lines, *_bridges(strokes, lines)], grid_size=GRID)
    faces, cuts, dangles, _ = shapely.polygonize_full([whole])
    return Faces(tuple(faces.geoms), (*dangles.geoms, *cuts.geoms))


def _bridges(
    strokes: Sequence[PaperStroke], lines: npt.NDArray[np.object_]
) -> npt.NDArray[np.object_]:
    """Lines from ends to what they miss by a little; the strokes come as (n,) lines, too."""
    ends = np.concatenate([stroke.ends for stroke in strokes])
    points = shapely.points(ends)
    end, line = shapely.STRtree(lines).query(points, "dwithin", _GAP)
    is_other = end // 2 != line
    end, line = end[is_other], line[is_other]
    met = lines[line]
    gaps = shapely.distance(points[end], met)
    nearest = np.full(len(points), np.inf)
    np.minimum.at(nearest, end, gaps)
    is_gap = (gaps == nearest[end]) & (gaps > 0.0)
    opening = np.hypot(*(ends[::2] - ends[1::2]).T)
    is_all_but_closed = (opening > 0.0) & (opening <= _GAP)
    is_all_but_closed &= shapely.length(lines) > _TURN * _GAP
    return np.concatenate(
        [
            shapely.shortest_line(points[end[is_gap]], met[is_gap]),
            shapely.linestrings(np.stack([ends[::2], ends[1::2]], axis=1)[is_all_but_closed]),
        ]
    )


def loose_lengths(strokes: Sequence[PaperStroke]) -> npt.NDArray[np.float64]:
    """(n,) mm of each stroke that bound no face."""
    free = np.zeros(len(strokes))
    loose = faces_of(strokes).dangles
    if loose:
        lines = lines_of(strokes)
        numbers, pieces = shapely.STRtree(loose).query(lines, "dwithin", GRID)
        strips = shapely.buffer(lines, 2.0 * GRID, cap_style="flat")
        pieces_met = np.array(loose)[pieces]
        along = shapely.length(shapely.intersection(pieces_met, strips[numbers]))
        # What only begins there is another stroke's.
        np.add.at(free, numbers, np.where(along > 0.5 * shapely.length(pieces_met), along, 0.0))
    return free
