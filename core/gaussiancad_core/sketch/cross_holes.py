"""Round holes across the slabs: taken off the views first, and cut out of the solid last.

A hole along another axis than the slabs' is a circle in a view from beside, and a pair of lines
along the hole, mostly hidden ones, in the others.  As levels and regions these lines would divide
everything that they cross.
"""

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import inf

import numpy as np

from gaussiancad_core.coordinates.grid_tolerances import LEAN, STEP
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.hole_depths import NotedHole
from gaussiancad_core.model.projection_planes import IN_PLANE, RolePlane, role_plane
from gaussiancad_core.sketch.closing_outlines import with_whole_circles
from gaussiancad_core.sketch.plane_lines import PlaneLine

_INSIDE = 2.0
"""Grid steps that a circle stays away from the outline of the part at least."""

_Interval = tuple[float, float]
_Lines = Mapping[Role, Sequence[PlaneLine]]


@dataclass(frozen=True)
class CrossHole:
    """A cylinder that is cut out of the slabs.

    Attributes:
        axis: along the hole.
        circle: mm in the plane across that.
        intervals: mm along it, from and to; infinite at an end that is open.
        depth: mm from where it enters the material, as a note says, infinite for through; None
            where none does.
        role: the view with its circle.
    """

    axis: Axis
    circle: Circle
    intervals: tuple[_Interval, ...]
    depth: float | None
    role: Role

    @property
    def plane(self) -> RolePlane:
        """In which its circle is drawn."""
        return role_plane(self.role)


def without_cross_holes(
    lines: _Lines,
    axis: Axis,
    size: Sequence[float],
    grid: float,
    views: DrawnViews,
) -> tuple[dict[Role, list[PlaneLine]], tuple[CrossHole, ...]]:
    """Views without the holes across an axis, and these.

    A circle inside the outline is a hole where hidden lines are its walls, or any lines of a
    section.  On a sheet without hidden lines it is one unless visible lines show it to be a boss,
    or a smaller circle lies within; it is as deep as a note says, or ends at the next void.

    Args:
        lines: of each view, mm in its plane.
        axis: across the slabs; circles of views along it stay.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
        views: of which they are: what is cut, and holes of which notes speak.
    """
    found = {role: with_whole_circles(plane_lines, grid) for role, plane_lines in lines.items()}
    # No view shows the walls of a hole along which the only view looks.
    draws_hidden = len(lines) > 1 and any(
        not line.is_visible for drawn in lines.values() for line in drawn
    )
    holes: list[CrossHole] = []
    gone: set[int] = set()
    for role, drawn in found.items():
        plane = role_plane(role)
        if plane.normal is axis or role in views.cuts:
            continue
        for line in _circles(drawn, [size[k] for k in IN_PLANE[plane.normal]], grid):
            circle = line.arc
            hole = plane.normal, circle
            walls = list(_walls(found, hole, grid, views.cuts, hidden=True))
            depth, intervals = None, _least(walls, grid)
            if not intervals:
                depth = _depth(views.holes, role, circle, grid)
                is_boss = any(_walls(found, hole, grid, views.cuts, hidden=False))
                is_open = depth is None and (is_boss or _is_around(circle, drawn, grid))
                if draws_hidden or is_open:
                    continue
                intervals = ((-inf, inf),)
            intervals = tuple(_opened(found, hole, each, grid) for each in intervals)
            holes.append(CrossHole(plane.normal, circle, intervals, depth, role))
            # Holes behind each other have walls in common.
            gone |= {id(line), *(id(wall) for pair in walls for wall in pair)}
    for role, drawn in found.items():
        found[role] = [
            line
            for line in drawn
            if id(line) not in gone and not any(_is_floor(line, role, hole, grid) for hole in holes)
        ]
    return found, tuple(_once(holes, grid))


def _circles(lines: Sequence[PlaneLine], size: Sequence[float], grid: float) -> list[PlaneLine]:
    """Whole visible circles that stay away from the outline."""
    return [
        line
        for line in lines
        if line.is_closed
        and line.circle is not None
        and line.is_visible
        and all(
            line.circle.radius + _INSIDE * grid < at < extent - line.circle.radius - _INSIDE * grid
            for at, extent in zip(line.circle.centre, size, strict=True)
        )
    ]


def _walls(
    lines: _Lines,
    hole: tuple[Axis, Circle],
    grid: float,
    cuts: Container[Role],
    *,
    hidden: bool,
) -> Iterator[tuple[PlaneLine, ...]]:
    """Of each view from beside, lines along a hole at either side of its circle: hidden ones, and
    of what is cut any; or visible ones of views that are not cut, as a boss has them."""
    normal, circle = hole
    for role, drawn in lines.items():
        axes = IN_PLANE[role_plane(role).normal]
        if normal.value not in axes or (role in cuts and not hidden):
            continue
        across = 1 - axes.index(normal.value)
        middle = circle.centre[IN_PLANE[normal].index(axes[across])]
        sides = [
            [
                line
                for line in drawn
                if (role in cuts or line.is_visible is not hidden)
                and line.constant(LEAN * grid) == across
                and abs(line.points[:, across].mean() - middle - side) <= STEP * grid
            ]
            for side in (-circle.radius, circle.radius)
        ]
        if all(sides):
            yield tuple(sides[0] + sides[1])


def _least(walls: Sequence[Sequence[PlaneLine]], grid: float) -> tuple[_Interval, ...]:
    """From and to along a hole of its walls, in the view that shows least: others may show walls
    of holes behind as well."""
    intervals = [_united([_span(line, grid) for line in each], grid) for each in walls]
    return min(intervals, key=lambda interval: sum(b - a for a, b in interval), default=())


def _united(intervals: Sequence[_Interval], grid: float) -> tuple[_Interval, ...]:
    """Intervals, those that overlap or nearly meet as one."""
    found: list[_Interval] = []
    for low, high in sorted(intervals):
        if found and low <= found[-1][1] + STEP * grid:
            found[-1] = found[-1][0], max(found[-1][1], high)
        else:
            found.append((low, high))
    return tuple(found)


def _span(line: PlaneLine, grid: float) -> _Interval:
    along = 1 - (line.constant(LEAN * grid) or 0)
    low, high = sorted(line.points[:, along].tolist())
    return low, high


def _depth(noted: Sequence[NotedHole], role: Role, circle: Circle, grid: float) -> float | None:
    """How deep a note says that the hole of a circle is, infinite for through; None without one."""
    signs = role_plane(role).signs
    for hole in noted:
        centre = [at * sign for at, sign in zip(hole.centre, signs, strict=True)]
        off = max(abs(a - b) for a, b in zip(centre, circle.centre, strict=True))
        if hole.role is not role or off > STEP * grid:
            continue
        for step in hole.steps:
            if abs(step.diameter - 2.0 * circle.radius) <= 2.0 * STEP * grid:
                return inf if step.depth is None else step.depth
    return None


def _is_around(circle: Circle, lines: Sequence[PlaneLine], grid: float) -> bool:
    """Whether a smaller circle lies about the same centre: nothing tells then how deep it is."""
    return any(
        line.circle is not None
        and line.circle.radius < circle.radius - STEP * grid
        and max(abs(a - b) for a, b in zip(line.circle.centre, circle.centre, strict=True))
        <= STEP * grid
        for line in lines
    )


def _opened(
    lines: _Lines, hole: tuple[Axis, Circle], interval: _Interval, grid: float
) -> _Interval:
    """An interval, longer by the hole's diameter at an end that no line closes: in round outlines
    walls end where the middle of the hole goes on."""
    normal, circle = hole
    low, high = (
        any(
            _is_across(line, role, (normal, circle, at), grid)
            for role, drawn in lines.items()
            for line in drawn
        )
        for at in interval
    )
    more = 2.0 * circle.radius
    return interval[0] - (0.0 if low else more), interval[1] + (0.0 if high else more)


def _is_floor(line: PlaneLine, role: Role, hole: CrossHole, grid: float) -> bool:
    """Whether a line is hidden, and lies across a hole at one of its ends."""
    near = STEP * grid
    return not line.is_visible and any(
        _is_across(line, role, (hole.axis, hole.circle, at), grid)
        and np.ptp(line.points, axis=0).max() <= 2.0 * (hole.circle.radius + near)
        for interval in hole.intervals
        for at in interval
    )


def _is_across(line: PlaneLine, role: Role, place: tuple[Axis, Circle, float], grid: float) -> bool:
    """Whether a line lies across a hole at a place along it, over most of its width."""
    normal, circle, at = place
    axes = IN_PLANE[role_plane(role).normal]
    if normal.value not in axes:
        return False
    along, near = axes.index(normal.value), STEP * grid
    is_there = abs(line.points[:, along].mean() - at) <= near
    if not is_there or line.constant(LEAN * grid) != along:
        return False
    middle = circle.centre[IN_PLANE[normal].index(axes[1 - along])]
    first, last = np.sort(line.points[:, 1 - along]).tolist()
    return bool(
        min(last, middle + circle.radius) - max(first, middle - circle.radius) > circle.radius
    )


def _once(holes: Sequence[CrossHole], grid: float) -> Iterator[CrossHole]:
    """Holes of which opposite views both show the circle, once."""
    kept: list[CrossHole] = []
    for hole in holes:
        if not any(_is_same(hole, other, grid) for other in kept):
            kept.append(hole)
    yield from kept


def _is_same(one: CrossHole, other: CrossHole, grid: float) -> bool:
    apart = [abs(a - b) for a, b in zip(one.circle.centre, other.circle.centre, strict=True)]
    sizes = abs(one.circle.radius - other.circle.radius)
    # From opposite faces two holes may be as deep as notes say.
    is_noted = any(hole.depth is not None and hole.depth < inf for hole in (one, other))
    if is_noted and one.plane.looks_up is not other.plane.looks_up:
        return False
    return one.axis is other.axis and max(*apart, sizes) <= STEP * grid
