"""Between which places along its axis a closed area may be a feature: what other views show."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.lines_by_plane import PlaneLine, PlaneSheet
from gaussiancad_core.proposing.part_features import Prism
from gaussiancad_core.proposing.plane_loops import Loop

MOST_PLACES = 8
"""Places along its axis between which an area may be a feature."""

_OVERLAP = 0.2
"""Share of a line, or of an area's width, that lies beside the area for the line to tell of it."""

_WALL = 0.3
"""What an end of a wall counts of a line all across an area."""

_NOTED, _SAME = 1.0, 3.0
"""What a place counts that a note tells, and tolerances within which an area is that of a hole."""

_SIDE = 5.0
"""What a side of the part counts more than any line."""


def prisms_of(sheet: PlaneSheet, loop: Loop) -> Iterator[Prism]:
    """Prisms of a closed area between places that lines of other views show."""
    for low, high in combinations(places_of(sheet, loop), 2):
        if high - low > 2.0 * sheet.tolerance:
            yield prism(sheet, loop, low, high)


def places_of(sheet: PlaneSheet, loop: Loop) -> list[float]:
    """Places along its axis at which a prism of a closed area may end, mm, the least first."""
    votes = _votes(sheet, loop)
    sides = 0.0, float(sheet.size[loop.axis.value])
    best = sorted(votes, key=lambda place: -(votes[place] + (_SIDE if place in sides else 0.0)))
    return sorted(best[:MOST_PLACES])


def prism(sheet: PlaneSheet, loop: Loop, low: float, high: float) -> Prism:
    """A closed area as a prism between two places, mm along its axis."""
    return Prism(loop, low, high, (sheet.across(loop.axis, low), sheet.across(loop.axis, high)))


def whole_prism(sheet: PlaneSheet, loop: Loop) -> Prism:
    """A closed area as a prism through all of the part's extent."""
    return prism(sheet, loop, 0.0, float(sheet.size[loop.axis.value]))


def _votes(sheet: PlaneSheet, loop: Loop) -> dict[float, float]:
    """Places along the axis of an area, and by how much of the area's width, in how many views,
    lines show them."""
    x0, y0, x1, y1 = loop.polygon.bounds
    spans = dict(zip(IN_PLANE[loop.axis], ((x0, x1), (y0, y1)), strict=True))
    votes: dict[float, dict[Axis, float]] = defaultdict(lambda: defaultdict(float))
    for view in sheet.views:
        if view.axis is loop.axis:
            continue
        along = IN_PLANE[view.axis].index(loop.axis.value)
        span = spans[IN_PLANE[view.axis][1 - along]]
        for line in view.lines:
            for place, weight in _shown(line, along, span, sheet.tolerance):
                votes[sheet.level(loop.axis, place)][view.axis] += weight
    for side in (0.0, float(sheet.size[loop.axis.value])):
        votes.setdefault(side, defaultdict(float))
    for place in list(_noted(sheet, loop, list(votes))):
        votes[sheet.level(loop.axis, place)][loop.axis] = _NOTED
    return {
        place: sum(min(1.0, each) for each in by_view.values()) for place, by_view in votes.items()
    }


def _noted(sheet: PlaneSheet, loop: Loop, faces: Sequence[float]) -> Iterator[float]:
    """Places at which a hole ends that an area is the section of, by what a note says: so deep
    beneath each of some faces."""
    x0, y0, x1, y1 = loop.polygon.bounds
    near = _SAME * sheet.tolerance
    for hole in sheet.holes:
        middle = np.hypot((x0 + x1) / 2.0 - hole.centre[0], (y0 + y1) / 2.0 - hole.centre[1])
        if hole.axis is not loop.axis or middle > near:
            continue
        for step in hole.steps:
            if step.depth is None or abs(x1 - x0 - step.diameter) > 2.0 * near:
                continue
            for face in faces:
                place = face + step.depth if hole.looks_up else face - step.depth
                if near < place < float(sheet.size[loop.axis.value]) - near:
                    yield place


def _shown(
    line: PlaneLine, along: int, span: tuple[float, float], tolerance: float
) -> Iterator[tuple[float, float]]:
    """Places that a line of another view shows beside an area, and what each counts.

    Args:
        line: of the view.
        along: which of the plane's coordinates runs along the area's axis.
        span: mm that the area takes of the other one.
        tolerance: mm.
    """
    low, high = span
    across = line.points[:, 1 - along]
    first, last = float(across.min()), float(across.max())
    width = last - first
    over = min(last, high) - max(first, low)
    if over < _OVERLAP * min(high - low, width) or (over <= 0.0 and width > tolerance):
        return
    if line.circle is not None:
        return
    places = line.points[:, along]
    if np.ptp(places) <= tolerance:
        yield float(places.mean()), over / max(high - low, 1e-9)
        return
    near = 2.0 * tolerance
    if width > tolerance or last > high + near or first < low - near:
        return
    if min(abs(last - high), abs(first - low), abs(first - high), abs(last - low)) < near:
        yield float(places[0]), _WALL
        yield float(places[-1]), _WALL
