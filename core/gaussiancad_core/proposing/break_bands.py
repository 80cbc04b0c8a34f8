"""Bands along outlines and around holes in the view on a face whose edges are broken."""

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.broken_corners import MEET, EdgeBreak
from gaussiancad_core.proposing.lines_by_plane import PlaneLine
from gaussiancad_core.proposing.plane_loops import areas_between, stretched
from gaussiancad_core.proposing.stroke_lines import StrokeLine

_OF_PIECE = 0.4
"""Share of its width that twice its area by its outline is at least, of a piece of a band."""


def without_bands(
    lines: Sequence[StrokeLine], breaks: Sequence[EdgeBreak], tolerance: float
) -> tuple[list[StrokeLine], list[shapely.Polygon]]:
    """The lines of a view without those of bands as narrow as the breaks of faces that it looks on,
    but for the sharp edges, and the holes around which there are bands."""
    near = MEET * tolerance
    holes: list[shapely.Polygon] = []
    kept = [line for line in lines if not _is_mitre(line, lines, breaks, near)]
    for band in _bands(lines, breaks, tolerance):
        sides = [band.exterior, *band.interiors]
        walls = [side for side in sides if any(_reaches(side, each, near) for each in breaks)]
        if not walls:
            # What no view from beside shows is a hole.
            walls = sides[1:]
            holes += [shapely.Polygon(side) for side in walls]
        if walls:
            edge, area = shapely.MultiLineString(walls), band.buffer(near)
            kept = [line for line in kept if not _is_in(line, area, edge, near)]
    return kept, holes


def _is_mitre(
    line: StrokeLine, lines: Sequence[StrokeLine], breaks: Sequence[EdgeBreak], near: float
) -> bool:
    """Whether a line is where two roundings meet: as wide as one in both ways, from a corner to
    where nothing is drawn."""
    size = np.ptp(line.ends, axis=0)
    widths = np.array([each.width for each in breaks if each.is_round])
    if not line.is_straight or not len(widths):
        return False
    if np.abs(size[:, None] - widths).min(axis=1).max() > near:
        return False
    others = [other for other in lines if other is not line]
    return sum(any(other.lies_at(end, near) for other in others) for end in line.ends) == 1


def _bands(
    lines: Sequence[StrokeLine], breaks: Sequence[EdgeBreak], tolerance: float
) -> Iterator[shapely.Polygon]:
    """Areas as narrow as a break, those beside each other as one."""
    curves = [PlaneLine(line.points, True, line.length, is_full=line.is_whole) for line in lines]
    narrow = [
        area
        for area in areas_between(stretched(curves, 0.0, tolerance), tolerance)
        if any(_is_narrow(area, each.width, MEET * tolerance) for each in breaks)
    ]
    for part in shapely.get_parts(shapely.union_all(narrow)):
        # A band goes around: what is narrow elsewhere is a rib, or a slot.
        if part.geom_type == "Polygon" and part.interiors:
            yield part


def _is_narrow(area: shapely.Polygon, width: float, near: float) -> bool:
    # The outline of a short piece has its ends, too; that of a ring has none.
    return bool(_OF_PIECE * width - near <= 2.0 * area.area / area.length <= width + near)


def _reaches(side: shapely.LinearRing, edge_break: EdgeBreak, near: float) -> bool:
    """Whether a side of a band is where a view from beside shows the sharp edge of a break."""
    column = IN_PLANE[edge_break.axis].index(edge_break.across.value)
    ends = side.bounds[column], side.bounds[2 + column]
    return min(abs(end - edge_break.place) for end in ends) <= near


def _is_in(line: StrokeLine, area: shapely.Geometry, edge: shapely.Geometry, near: float) -> bool:
    """Whether a line runs in a band, and not along its sharp edges."""
    points = shapely.points(line.points)
    is_along = bool((shapely.distance(points, edge) <= near).all())
    return not is_along and bool(shapely.covers(area, points).all())
