"""The regions that the lines of a plane bound, and the borders between them."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.coordinates.grid_tolerances import MEETING, STEP
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.sketch.closing_outlines import tidied
from gaussiancad_core.sketch.plane_lines import PlaneLine

OUTSIDE = -1
"""What lies beyond the outline, in a border."""

MOST_CELLS = 200
"""Regions of slabs from which nothing is chosen: of more nothing good was ever found in time, nor
on a coarser grid."""

_SLIVER = 0.7
"""Grid steps that a region is wide at least, on the average; a narrower one belongs to that beside
it."""

_MITRE = 2.0
"""Length of the line in which two edge breaks meet at most, in their width."""

_ELONGATED = 8.0
"""Length of a band's outline at least, in the width of the edge break."""

_SHARED = 0.3
"""Share of a sliver's outline along the region that it belongs to at least."""

_DRAWN = 0.8
"""Grid steps between a border and a line that draws it at most."""

_ARC = 4
"""Chords of a quarter of a circle around the end of a line: within 2 % of the reach."""

_ROUND = 0.97
"""Share of the area of a circle as long around that a round region has at least."""


@dataclass(frozen=True)
class Border:
    """What two regions have in common.

    Attributes:
        one, other: numbers of the regions; ``OUTSIDE`` for what lies around the part.
        length: mm.
        visible, hidden: mm of it that the views from above draw so.
        visible_below, hidden_below: the same of the views from below.
    """

    one: int
    other: int
    length: float
    visible: float
    hidden: float
    visible_below: float
    hidden_below: float


@dataclass(frozen=True, eq=False)
class Regions:
    """The regions of a plane.

    Attributes:
        polygons: mm, without overlaps.
        lines: what bounds them, with ends that meet.
        borders: between them, and with the outside.
        is_inner: (n,) bool, of each whether it is nowhere at the outline.
        is_round: (n,) bool, of each whether it is a disc.
        bands: numbers of those that are as narrow as an edge break.
        alien: mm of line that bounds nothing; half of it where it is hidden.
    """

    polygons: tuple[shapely.Polygon, ...]
    lines: tuple[PlaneLine, ...]
    borders: tuple[Border, ...]
    is_inner: npt.NDArray[np.bool_]
    is_round: npt.NDArray[np.bool_]
    bands: tuple[int, ...] = ()
    alien: float = 0.0

    @property
    def areas(self) -> npt.NDArray[np.float64]:
        """(n,) mm2."""
        return np.array([polygon.area for polygon in self.polygons])


def find_regions(
    from_above: Sequence[PlaneLine],
    from_below: Sequence[PlaneLine],
    grid: float,
    breaks: Collection[float] = (),
    undrawn: Sequence[PlaneLine] = (),
) -> Regions | None:
    """The regions that lines of a plane bound; None where there are more than ``MOST_CELLS``.

    Args:
        from_above: lines of views that look towards smaller coordinates.
        from_below: of those that look towards larger ones.
        grid: mm of a step of the sheet's coordinates.
        breaks: mm, widths of edge breaks: regions as narrow are bands.
        undrawn: lines that divide the plane as well, though no view draws them.
    """
    lines = tidied([*from_above, *from_below, *undrawn], grid)
    polygons = _polygons(lines, grid)
    if len(polygons) > MOST_CELLS:
        return None
    # Where broken edges meet is a mitre, which bounds nothing.
    mitre = _MITRE * max(breaks, default=0.0)
    longer = [line for line in (*from_above, *from_below) if line.length > mitre]
    borders = _borders(polygons, (from_above, from_below), grid)
    around = _near(shapely.union_all(polygons).boundary, 0.5 * grid) if polygons else None
    inner = np.array([not polygon.intersects(around) for polygon in polygons], dtype=bool)
    rounds = np.array([is_disc(polygon) for polygon in polygons], dtype=bool)
    return Regions(
        tuple(polygons),
        tuple(lines),
        tuple(borders),
        inner,
        rounds,
        tuple(_bands(polygons, breaks, grid)),
        _alien(longer, polygons, grid),
    )


def is_disc(polygon: shapely.Polygon) -> bool:
    """Whether a polygon is round and has no hole."""
    if polygon.interiors or not polygon.length:
        return False
    return bool(4.0 * np.pi * polygon.area / polygon.length**2 > _ROUND)


def _polygons(lines: Sequence[PlaneLine], grid: float) -> list[shapely.Polygon]:
    """What lines bound; what is too narrow united with what is beside it, unless there are more of
    the others than anything is chosen from."""
    if not lines:
        return []
    noded = shapely.union_all(
        [shapely.LineString(line.points) for line in lines], grid_size=COMPUTED
    )
    found = list(shapely.get_parts(shapely.polygonize(shapely.get_parts(noded))))
    narrow = [2.0 * item.area / item.length < _SLIVER * grid for item in found]
    kept = [item for item, sliver in zip(found, narrow, strict=True) if not sliver]
    if len(kept) > MOST_CELLS:
        return kept
    slivers = [item for item, sliver in zip(found, narrow, strict=True) if sliver]
    for this_sliver in sorted(slivers, key=lambda sliver: -sliver.area):
        shared = [_common(this_sliver, other) for other in kept]
        best = int(np.argmax(shared)) if shared else 0
        if shared and shared[best] > _SHARED * this_sliver.length:
            united = kept[best].union(this_sliver)
            if united.geom_type == "Polygon":
                kept[best] = united
    return kept


def _alien(lines: Sequence[PlaneLine], polygons: Sequence[shapely.Polygon], grid: float) -> float:
    """mm of lines that bound no polygon; half of it where they are hidden."""
    bounds = _near(shapely.union_all([polygon.boundary for polygon in polygons]), _DRAWN * grid)
    drawn = [(shapely.LineString(line.points), 1.0 if line.is_visible else 0.5) for line in lines]
    return float(sum((line.length - _within(line, bounds)) * share for line, share in drawn))


def _near(lines: shapely.Geometry, reach: float) -> shapely.Geometry:
    """What is within reach of lines; of pieces that go on in each other that takes long."""
    found = shapely.line_merge(lines).buffer(reach, quad_segs=_ARC)
    shapely.prepare(found)
    return found


def _within(line: shapely.Geometry, band: shapely.Geometry | None) -> float:
    """Length of a line in a band; most are within it or outside of it as a whole."""
    if band is None or not band.intersects(line):
        return 0.0
    return float(line.length if band.contains(line) else line.intersection(band).length)


def _bands(
    polygons: Sequence[shapely.Polygon], widths: Collection[float], grid: float
) -> Iterator[int]:
    """Numbers of polygons that are as narrow as an edge break."""
    for number, polygon in enumerate(polygons):
        for width in widths:
            mean = 2.0 * polygon.area / polygon.length
            # The outline of a strip has its ends, too; that of a ring has none.
            strip = polygon.area * width / (polygon.area + width**2)
            fits = strip - STEP * grid <= mean <= width + STEP * grid
            if fits and polygon.length > _ELONGATED * width:
                yield number
                break


def _common(one: shapely.Polygon, other: shapely.Polygon) -> float:
    """mm of border that two polygons share."""
    if one.distance(other) > 0.0:
        return 0.0
    return float(one.boundary.intersection(other.boundary).length)


def _borders(
    polygons: Sequence[shapely.Polygon],
    lines: tuple[Sequence[PlaneLine], Sequence[PlaneLine]],
    grid: float,
) -> list[Border]:
    drawn = [
        _band([plane_line for plane_line in side if plane_line.is_visible is visible], grid)
        for side in lines
        for visible in (True, False)
    ]
    if not polygons:
        return []
    outline = shapely.union_all(polygons).boundary
    tree = shapely.STRtree(list(polygons))
    found = []
    for one, polygon in enumerate(polygons):
        near = [int(k) for k in tree.query(polygon) if k > one]
        shared = [
            (other, polygon.boundary.intersection(polygons[other].boundary)) for other in near
        ]
        shared.append((OUTSIDE, polygon.boundary.intersection(outline)))
        for other, line in shared:
            if line.length < MEETING * grid:
                continue
            withins = (_within(line, band) for band in drawn)
            found.append(Border(one, other, float(line.length), *withins))
    return found


def _band(lines: Sequence[PlaneLine], grid: float) -> shapely.Geometry | None:
    """What is near a line."""
    if not lines:
        return None
    chains = shapely.multilinestrings([shapely.LineString(line.points) for line in lines])
    return _near(chains, _DRAWN * grid)
