"""Where a view's outline is open: a line that bounds nothing, and the gap that makes it so.

Visible lines bound regions of their view.  Where one of the outline is missing, the region beside
it runs into the outside, and the lines around it bound nothing any more.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, islice

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.coordinates.stroke_finder import LINKS
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.tolerances import MEETING
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.work_limits import ENDS

_LEAST_REACH = 0.002
"""The same as a share of the longest extent, at least."""

_MOST_LINES = 200
"""Visible lines of a view up to which it is looked at."""

_MOST_CLOSING = 6
"""Lines that would close a gap, at most."""

_SLANTED = 1.5
"""Times its length that a slanted line counts for."""

_CLOSED = 1.5
"""Reaches of line that may bound nothing in a closed view: where ends miss each other."""


@dataclass(frozen=True, eq=False)
class Gap:
    """A gap in the outline of a view.

    Attributes:
        role: the view.
        closing: straight lines each of which would close it, (2, 2) mm of the view's plane; the
            likeliest first.
    """

    role: Role
    closing: tuple[npt.NDArray[np.float64], ...]


def find_gaps(views: DrawnViews) -> tuple[Gap, ...]:
    """The gap of each view whose outline one straight line closes."""
    reach = max(MEETING * views.tolerance, _LEAST_REACH * max(views.size))
    found = ((role, _closing(strokes, reach)) for role, strokes in views.strokes.items())
    return tuple(Gap(role, closing) for role, closing in found if closing)


def with_closed_outlines(views: DrawnViews) -> DrawnViews | None:
    """The views with the likeliest line that closes each gap; None if no outline is open.

    Such a line bounds regions and may be drawn or not: it has no confidence.
    """
    gaps = {gap.role: gap.closing[0] for gap in find_gaps(views)}
    if not gaps:
        return None
    strokes = {
        role: (*curves, _undrawn(gaps[role])) if role in gaps else curves
        for role, curves in views.strokes.items()
    }
    return replace(views, strokes=strokes)


def _undrawn(ends: npt.NDArray[np.float64]) -> Segment:
    start, end = ((float(x), float(y)) for x, y in ends)
    return Segment(start, end, Linetype.VISIBLE, 0.0)


def _closing(strokes: Sequence[DrawnStroke], reach: float) -> tuple[npt.NDArray[np.float64], ...]:
    lines = [
        _path(stroke)
        for stroke in strokes
        if stroke.length > reach and stroke.linetype is Linetype.VISIBLE
    ]
    if not 0 < len(lines) <= _MOST_LINES or _loose(lines, reach) <= _CLOSED * reach:
        return ()
    candidates = sorted(_candidates(lines, reach), key=lambda ends: _unlikely(ends, reach))
    closing = (
        ends
        for ends in candidates[:ENDS]
        if _loose([*lines, shapely.LineString(ends)], reach) <= _CLOSED * reach
    )
    return tuple(islice(closing, _MOST_CLOSING))


def _path(stroke: DrawnStroke) -> shapely.LineString:
    links = 1 if isinstance(stroke, Segment) else LINKS
    return shapely.LineString(stroke.sample(stroke.length / links * (1.0 + 1e-9)))


def _loose(lines: Sequence[shapely.LineString], reach: float) -> float:
    """Length of line that neither bounds a region nor lies in one."""
    noded = shapely.union_all(list(lines), grid_size=reach / 2.0)
    regions = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    within = shapely.buffer(shapely.union_all(regions), reach)
    return float(shapely.difference(noded, within).length)


def _candidates(
    lines: Sequence[shapely.LineString], reach: float
) -> Iterable[npt.NDArray[np.float64]]:
    """Straight lines from ends at which nothing else is: to other ends, and across to lines.

    Where there are no such ends, straight lines along an axis between any two ends.
    """
    ends = _apart(np.concatenate([shapely.get_coordinates(line)[[0, -1]] for line in lines]), reach)
    tree = shapely.STRtree(lines)
    free = [
        end
        for end in ends
        if len(tree.query(shapely.Point(end), predicate="dwithin", distance=reach)) == 1
    ]
    for one in free:
        for other in [*ends, *_across(one, lines, reach)]:
            if np.hypot(*(other - one)) > reach:
                yield np.array([one, other])
    if not free:
        for one, other in combinations(ends, 2):
            if np.abs(one - other).min() <= reach:
                yield np.array([one, other])


def _across(
    end: npt.NDArray[np.float64], lines: Sequence[shapely.LineString], reach: float
) -> Iterable[npt.NDArray[np.float64]]:
    """Where lines are met first from an end, straight along the axes."""
    everything = shapely.union_all(list(lines))
    x0, y0, x1, y1 = shapely.bounds(everything)
    for direction in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
        way = np.array(direction)
        ray = shapely.LineString([end + 2.0 * reach * way, end + (x1 - x0 + y1 - y0) * way])
        met = shapely.get_coordinates(shapely.intersection(ray, everything))
        if len(met):
            yield met[int(((met - end) @ way).argmin())]


def _unlikely(ends: npt.NDArray[np.float64], reach: float) -> float:
    """Short lines are likely, and lines along an axis more so than slanted ones."""
    interval = np.abs(ends[1] - ends[0])
    return float(np.hypot(*interval)) * (_SLANTED if interval.min() > reach else 1.0)


def _apart(points: npt.NDArray[np.float64], reach: float) -> list[npt.NDArray[np.float64]]:
    """Points of which no two are within reach."""
    kept: list[npt.NDArray[np.float64]] = []
    for point in points:
        if all(np.hypot(*(point - other)) > reach for other in kept):
            kept.append(point)
    return kept
