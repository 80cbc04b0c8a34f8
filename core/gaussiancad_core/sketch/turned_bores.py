"""Bores of turned parts that slope are made steps first, and turned to their slopes last.

A section shows such a bore as the edge of what is hatched, another view by hidden lines.  Slabs
reach in to its smaller end, and what lies between is taken away from the solid at the end.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
import shapely

from gaussiancad_core.coordinates.grid_tolerances import LEAN, MEETING
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import role_plane
from gaussiancad_core.model.section_planes import Cut
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

_ASIDE = 2.0
"""Grid steps beside a slope at which it is asked what is hatched."""

_Side = tuple[Seen, float]
"""A view, and 1 or -1 for one side of the axis in it."""


def without_bore_slopes(
    lines: Lines,
    axis: Axis,
    centre: tuple[float, float],
    grid: float,
    cuts: Mapping[Role, Cut],
) -> tuple[dict[Role, list[PlaneLine]], tuple[Slope, ...]]:
    """Views of a turned part with steps in place of bores that slope, and the slopes.

    Args:
        lines: of each view, mm in its plane.
        axis: that the part is turned about.
        centre: mm in the plane across that, where it is.
        grid: mm of a step of the sheet's coordinates.
        cuts: views that are sections.
    """
    found = {role: list(plane_lines) for role, plane_lines in lines.items()}
    near = MEETING * grid
    sides = [
        (this_seen, side)
        for this_seen in side_views_of(lines, axis, centre, grid)
        for side in (1.0, -1.0)
    ]
    planes = {
        role: this_cut.mapped(role_plane(role).signs, 1.0)
        for role, this_cut in cuts.items()
        if isinstance(role, Role)
    }
    shown = [list(_sloping(this_side, planes.get(this_side[0].role), grid)) for this_side in sides]
    slopes: list[Slope] = []
    for number, (seen, side) in enumerate(sides):
        for line in shown[number]:
            cut, other = planes.get(seen.role), shown[number ^ 1]
            is_even = any(lies_along(plane_line.points, line.points, near) for plane_line in other)
            if not is_even and (cut is None or _is_cut(cut, seen, line, -side)):
                continue
            if not any(lies_along(line.points, slope.line.points, near) for slope in slopes):
                slopes.append(_slope(line, centre))
    for seen, side in sides:
        for this_slope in slopes:
            found[seen.role] = _stepped(found[seen.role], (seen, side), this_slope, grid)
    return found, tuple(slopes)


def _slope(line: PlaneLine, centre: tuple[float, float]) -> Slope:
    small, large = sorted(line.points[[0, -1]], key=lambda at: float(at[1]))
    stated = {"is_foot": False, "is_plain": False, "is_groove": False, "is_bore": True}
    return Slope(centre, small, large, line, **stated)


def _sloping(view: _Side, cut: Cut | None, grid: float) -> Iterator[PlaneLine]:
    """Lines on one side of the axis along no axis that are walls of a bore; places are along the
    axis, and away from it."""
    seen, side = view
    near, border = MEETING * grid, seen.outline.boundary
    for plane_line in seen.lines:
        if plane_line.curve is None or not is_sloping(plane_line, grid):
            continue
        if border.distance(_middle(plane_line)) <= near:
            continue
        # Where holes across meet the outline, there are hidden curves, too.
        if not (
            plane_line.is_visible or plane_line.is_straight or _goes_on(plane_line, seen, grid)
        ):
            continue
        moved = moved_to(plane_line, seen, side)
        if (points := beyond_axis(moved, near)) is None:
            continue
        for line in one_way(replace(moved, points=points), near):
            if not plane_line.is_visible or (
                cut is not None and _is_edge_of(cut, view, line, grid)
            ):
                yield line


def _goes_on(line: PlaneLine, seen: Seen, grid: float) -> bool:
    """Whether a hidden wall along the axis ends where a line does."""
    walls = [plane_line for plane_line in seen.lines if not plane_line.is_visible]
    return any(_ends_wall(wall, end, seen, grid) for wall in walls for end in line.points[[0, -1]])


def _is_edge_of(cut: Cut, view: _Side, line: PlaneLine, grid: float) -> bool:
    """Whether what lies beyond a line from the axis is hatched, and what lies before it is not."""
    if cut.areas is None:
        return False
    middle = np.array(_middle(line).coords[0])
    way = line.points[-1] - line.points[0]
    out = np.array([-way[1], way[0]]) * np.sign(way[0]) / np.hypot(*way)
    seen, side = view
    places = seen.back(np.array([middle + _ASIDE * grid * out, middle - _ASIDE * grid * out]), side)
    beyond, before = shapely.contains_xy(cut.areas, places)
    return bool(beyond and not before)


def _is_cut(cut: Cut, seen: Seen, line: PlaneLine, side: float) -> bool:
    """Whether a view is cut open where a line lies on one side of the axis."""
    middle = np.array(_middle(line).coords)
    (place,) = seen.back(middle, side).tolist()
    return cut.opening((place[0], place[1])) is not None


def _middle(line: PlaneLine) -> shapely.Point:
    return shapely.LineString(line.points).interpolate(0.5, normalized=True)


def _stepped(lines: Sequence[PlaneLine], view: _Side, slope: Slope, grid: float) -> list[PlaneLine]:
    """Lines of a view with two in place of a slope on one side of the axis, where it is drawn."""
    seen, side = view
    near = MEETING * grid
    along = seen.back(slope.line.points, side)
    drawn = [line for line in lines if holds(line, along, near)]
    if not drawn:
        return list(lines)
    small, corner, large = seen.back(np.array([slope.small, slope.corner, slope.large]), side)
    kind = drawn[0].is_visible
    # Where a cylinder goes on at the smaller end the edge between is gone.
    is_plain = any(_ends_wall(line, small, seen, grid) for line in lines)
    left = [
        line
        for line in lines
        if line not in drawn
        and not (is_plain and line.is_visible is kind and is_edge_at(line, small, seen, grid))
    ]
    steps = step_of(corner, large, grid)
    if slope.small[1] > near:
        steps += step_of(small, corner, grid)
    return [*left, *(replace(step, is_visible=kind) for step in steps)]


def _ends_wall(line: PlaneLine, place: Floats, seen: Seen, grid: float) -> bool:
    """Whether a line along the axis ends at a place."""
    runs = line.constant(LEAN * grid) == 1 - seen.along
    return runs and np.hypot(*(line.points[[0, -1]] - place).T).min() <= MEETING * grid
