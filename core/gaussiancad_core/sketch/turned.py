"""Turned parts: outlines that slope are made steps first, and the solid is turned down last.

Seen from beside, the outline of a turned part is its profile.  Slabs are cylinders: where the
outline slopes, they reach out to its larger end, and what lies beyond the slope is taken away from
the solid of the slabs at the end.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import shapely

from gaussiancad_core.coordinates.grid_tolerances import LEAN, MEETING
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import role_plane
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine
from gaussiancad_core.sketch.turned_views import (
    Lines,
    Seen,
    Slope,
    beyond_axis,
    holds,
    is_edge_at,
    is_sloping,
    lies_along,
    moved_to,
    one_way,
    side_views_of,
    step_of,
)

_ON = 0.5
"""Grid steps between a slope and the widest outline at most."""


def without_slopes(
    lines: Lines, axis: Axis, centre: tuple[float, float], grid: float
) -> tuple[dict[Role, list[PlaneLine]], tuple[Slope, ...]]:
    """Views of a turned part with steps in place of outlines that slope, and the slopes.

    Args:
        lines: of each view, mm in its plane.
        axis: that the part is turned about.
        centre: mm in the plane across that, where it is.
        grid: mm of a step of the sheet's coordinates.
    """
    found = {role: list(plane_lines) for role, plane_lines in lines.items()}
    seens = list(side_views_of(lines, axis, centre, grid))
    widest = shapely.union_all([_half(seen, side) for seen in seens for side in (1.0, -1.0)])
    slopes = tuple(_slopes(seens, widest, centre, grid)) if not widest.is_empty else ()
    if not slopes:
        return found, ()
    for this_seen in seens:
        found[this_seen.role] = _stepped(this_seen, slopes, grid)
    for role, item in found.items():
        if role_plane(role).normal is axis:
            found[role] = [each for each in item if not _is_foot(each, centre, slopes, grid)]
    return found, slopes


def _slopes(
    seens: Sequence[Seen],
    widest: shapely.Geometry,
    centre: tuple[float, float],
    grid: float,
) -> Iterator[Slope]:
    """What slopes in a view from beside on both sides of the axis, and is the outline of what all
    views from beside show together, each once."""
    near = MEETING * grid
    sides = [(seen, side) for seen in seens for side in (1.0, -1.0)]
    shown = [list(_sloping(seen, side, grid)) for seen, side in sides]
    walls = [
        seen.away(line.points[[0, -1]], side)
        for seen, side in sides
        for line in seen.lines
        if line.is_visible and line.constant(LEAN * grid) == 1 - seen.along
    ]

    def ends_wall(place: Floats) -> bool:
        return any(np.hypot(*(ends - place).T).min() <= near for ends in walls)

    found: list[PlaneLine] = []
    for line in sorted(
        (plane_line for each in shown for plane_line in each),
        key=lambda plane_line: -plane_line.length,
    ):
        points = line.points
        if any(lies_along(points, other.points, near) for other in found):
            continue
        even = any(
            all(
                any(lies_along(plane_line.points, points, near) for plane_line in each)
                for each in pair
            )
            for pair in zip(shown[::2], shown[1::2], strict=True)
        )
        border = widest.boundary
        if even and all(border.distance(shapely.Point(at)) <= _ON * grid for at in points):
            found.append(line)
    ends = [sorted(plane_line.points[[0, -1]], key=lambda at: float(at[1])) for plane_line in found]
    for line, (small, large) in zip(found, ends, strict=True):
        falling = sum(np.hypot(*(other - small)) <= near for other, _ in ends)
        stated = not ends_wall(small), ends_wall(large), bool(falling > 1)
        yield Slope(centre, small, large, line, *stated)


def _sloping(seen: Seen, side: float, grid: float) -> Iterator[PlaneLine]:
    """Lines along the outline of a view on one side that are along no axis, as far as they are on
    that side; places are along the axis, and away from it."""
    border = seen.outline.boundary
    for line in seen.lines:
        if not line.is_visible or not is_sloping(line, grid):
            continue
        if border.distance(shapely.Point(line.points[len(line.points) // 2])) > MEETING * grid:
            continue
        moved = moved_to(line, seen, side)
        if (points := beyond_axis(moved, MEETING * grid)) is not None:
            yield from one_way(replace(moved, points=points), MEETING * grid)


def _stepped(seen: Seen, slopes: Sequence[Slope], grid: float) -> list[PlaneLine]:
    """Lines of a view with two in place of each that slopes."""
    near = MEETING * grid
    left = list(seen.lines)
    steps: list[PlaneLine] = []
    for side in (1.0, -1.0):
        for slope in slopes:
            small, corner, large = seen.back(
                np.array([slope.small, slope.corner, slope.large]), side
            )
            gone = [
                place
                for place, is_gone in ((small, slope.is_groove), (large, slope.is_plain))
                if is_gone
            ]
            left = [
                line
                for line in left
                if not holds(line, seen.back(slope.line.points, side), near)
                and not (
                    line.is_visible and any(is_edge_at(line, place, seen, grid) for place in gone)
                )
            ]
            # What two slopes fall to is bridged.
            if not slope.is_groove:
                steps += step_of(small, corner, grid)
            steps += step_of(corner, large, grid)
    return [*left, *steps]


def _half(seen: Seen, side: float) -> shapely.Geometry:
    """What a view shows on one side of the axis; places are along the axis, and away from it."""
    points = seen.away(np.array(seen.outline.exterior.coords), side)
    low, high = points[:, 0].min(), points[:, 0].max()
    box = shapely.box(low, 0.0, high, max(0.0, points[:, 1].max()) + 1.0)
    return shapely.Polygon(points).buffer(0.0).intersection(box)


def _is_foot(
    line: PlaneLine, centre: tuple[float, float], slopes: Sequence[Slope], grid: float
) -> bool:
    """Whether a circle of the plan, or an arc, is the smaller end of a slope only."""
    if line.circle is None:
        return False
    near = MEETING * grid
    if max(abs(a - b) for a, b in zip(line.circle.centre, centre, strict=True)) > near:
        return False
    return any(
        slope.is_foot and abs(line.circle.radius - slope.small[1]) <= near for slope in slopes
    )
