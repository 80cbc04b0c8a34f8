"""Views from beside of what is turned: places along its axis and away from it, and what slopes.

Slabs are cylinders: a sloping line becomes two steps, one along the axis and one across it, and the
solid of the slabs is turned to the line at the end.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.coordinates.grid_tolerances import LEAN, MEETING, STEP
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.sketch.plan_regions import find_regions
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine, profile_along
from gaussiancad_core.solid.profiles import Profile

_MOST = 0.5
"""Share of a slope that another view shows of it at least."""

_TINY = 1e-9
"""mm within which two places are the same."""

Lines = Mapping[Role, Sequence[PlaneLine]]


@dataclass(frozen=True, eq=False)
class Slope:
    """A sloping piece of a profile; places are mm along the axis, and away from it.

    Attributes:
        centre: mm in the plane across the axis.
        small, large: (2,) its end that is nearer to the axis, and the other one.
        line: along it.
        is_foot: whether no cylinder ends at the smaller end.
        is_plain: whether a cylinder goes on at the larger end: that has no edge then.
        is_groove: whether another slope falls to the same place.
        is_bore: whether the material is beyond it, seen from the axis.
    """

    centre: tuple[float, float]
    small: Floats
    large: Floats
    line: PlaneLine
    is_foot: bool
    is_plain: bool
    is_groove: bool
    is_bore: bool = False

    @property
    def corner(self) -> Floats:
        """(2,) between the steps that stand for it."""
        if self.is_bore:
            return np.array([self.large[0], self.small[1]])
        return np.array([self.small[0], self.large[1]])

    def beyond(self, grid: float) -> Profile:
        """What the steps have more than the slope, with the arc along which it runs.

        Args:
            grid: mm of a step of the sheet's coordinates.
        """
        points = self.line.points
        ring = points if np.hypot(*(points[0] - self.large)) < _TINY else points[::-1]
        return profile_along(shapely.Polygon([*ring, self.corner]), [self.line], grid)


@dataclass(frozen=True, eq=False)
class Seen:
    """A view of a turned part from beside.

    Attributes:
        role: of the view.
        lines: mm in its plane.
        outline: what it shows, without holes.
        along: which of its coordinates runs along the axis.
        middle: mm along the other one, of the axis.
    """

    role: Role
    lines: Sequence[PlaneLine]
    outline: shapely.Polygon
    along: int
    middle: float

    def away(self, points: Floats, side: float) -> Floats:
        """(n, 2) places along the axis, and away from it to one side, of points."""
        return np.stack(
            [points[:, self.along], side * (points[:, 1 - self.along] - self.middle)], axis=1
        )

    def back(self, points: Floats, side: float) -> Floats:
        """(n, 2) points of the view of places along the axis and away from it."""
        found = np.empty_like(points)
        found[:, self.along] = points[:, 0]
        found[:, 1 - self.along] = self.middle + side * points[:, 1]
        return found


def turning_centre(
    lines: Lines, axis: Axis, size: Sequence[float], grid: float
) -> tuple[float, float] | None:
    """Where a circle as wide as the part is drawn."""
    first, second = (size[k] for k in IN_PLANE[axis])
    if abs(first - second) > MEETING * grid:
        return None
    for role, plane_lines in lines.items():
        if role_plane(role).normal is not axis:
            continue
        for each in plane_lines:
            if not each.is_closed or each.circle is None:
                continue
            off = max(abs(each.circle.centre[k] - first / 2.0) for k in (0, 1))
            if max(off, abs(each.circle.radius - first / 2.0)) <= MEETING * grid:
                return each.circle.centre
    return None


def side_views_of(
    lines: Lines, axis: Axis, centre: tuple[float, float], grid: float
) -> Iterator[Seen]:
    """The views of a turned part from beside whose outlines close.

    Args:
        lines: of each view, mm in its plane.
        axis: that the part may be turned about.
        centre: mm in the plane across that, where it is.
        grid: mm of a step of the sheet's coordinates.
    """
    for role, plane_lines in lines.items():
        axes = IN_PLANE[role_plane(role).normal]
        if axis.value not in axes:
            continue
        along = axes.index(axis.value)
        middle = centre[IN_PLANE[axis].index(axes[1 - along])]
        outline = _outline(plane_lines, grid)
        if outline is not None:
            yield Seen(role, plane_lines, outline, along, middle)


def _outline(lines: Sequence[PlaneLine], grid: float) -> shapely.Polygon | None:
    """What a view shows, without holes; None where it is in pieces, or in too many."""
    regions = find_regions([line for line in lines if line.is_visible], (), grid)
    if regions is None:
        return None
    whole = shapely.union_all(regions.polygons)
    return shapely.Polygon(whole.exterior) if whole.geom_type == "Polygon" else None


def is_sloping(line: PlaneLine, grid: float) -> bool:
    """Whether a line is along no axis, and not closed."""
    return not line.is_closed and bool(np.ptp(line.points, axis=0).min() > STEP * grid)


def one_way(line: PlaneLine, near: float) -> Iterator[PlaneLine]:
    """A slope, or the two of an arc that turns back from or to the axis between its ends."""
    points = line.points
    ends = np.sort(points[[0, -1], 1])
    rises = points[:, 1].max() > ends[1] + near
    if line.circle is None or not (rises or points[:, 1].min() < ends[0] - near):
        yield line
        return
    (x, y), radius = line.circle.centre, line.circle.radius
    turn = int(points[:, 1].argmax() if rises else points[:, 1].argmin())
    tip = np.array([x, y + radius if rises else y - radius])
    yield replace(line, points=np.array([*points[:turn], tip]))
    yield replace(line, points=np.array([tip, *points[turn + 1 :]]))


def beyond_axis(line: PlaneLine, near: float) -> Floats | None:
    """(n, 2) the stretch of a line that is on the right side of the axis, from there on; None
    where there is none."""
    points = line.points
    (on,) = np.nonzero(points[:, 1] >= -near)
    if len(on) < 2 or np.ptp(on) + 1 != len(on):
        return None
    found = points[on]
    before = [points[k] for k in (on[0] - 1, on[-1] + 1) if 0 <= k < len(points)]
    if before and line.circle is not None:
        # A dome meets the axis where its circle does.
        (x, y), radius = line.circle.centre, line.circle.radius
        reach = np.sqrt(max(0.0, radius**2 - y**2))
        tip = min((x - reach, x + reach), key=lambda at: abs(at - before[0][0]))
        end = 0 if np.hypot(*(found[0] - before[0])) < np.hypot(*(found[-1] - before[0])) else -1
        found[end] = tip, 0.0
    found[:, 1] = np.where(found[:, 1] < near, 0.0, found[:, 1])
    return found if np.ptp(found[:, 1]) > near else None


def lies_along(points: Floats, other: Floats, near: float) -> bool:
    """Whether a line lies along most of another one."""
    line = shapely.LineString(other)
    on = all(line.distance(shapely.Point(at)) <= near for at in points)
    return on and _length(points) >= _MOST * _length(other)


def holds(line: PlaneLine, points: Floats, near: float) -> bool:
    """Whether a line lies along most of a slope, or holds all of it."""
    if lies_along(line.points, points, near):
        return True
    line_string = shapely.LineString(line.points)
    return not line.is_closed and all(
        line_string.distance(shapely.Point(at)) <= near for at in points
    )


def _length(points: Floats) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def is_edge_at(line: PlaneLine, place: Floats, seen: Seen, grid: float) -> bool:
    """Whether a line across the axis ends at a place."""
    across = line.constant(LEAN * grid) == seen.along
    return across and np.hypot(*(line.points[[0, -1]] - place).T).min() <= MEETING * grid


def step_of(one: Floats, other: Floats, grid: float) -> list[PlaneLine]:
    """The line between two places of a view, if they are apart."""
    is_long = float(np.hypot(*(other - one))) > LEAN * grid
    return [PlaneLine(np.array([one, other]), True)] if is_long else []


def moved_to(line: PlaneLine, seen: Seen, side: float) -> PlaneLine:
    """A line of a view by places along the axis, and away from it to one side."""
    circle = line.circle
    if circle is not None:
        x, y = seen.away(np.array([circle.centre]), side)[0].tolist()
        circle = replace(circle, centre=(x, y))
    return replace(line, points=seen.away(line.points, side), circle=circle)
