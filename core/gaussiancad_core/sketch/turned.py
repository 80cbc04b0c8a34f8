"""Turned parts: outlines that slope are made steps first, and the solid is turned down last.

Seen from beside, the outline of a turned part is its profile.  Slabs are cylinders: where the
outline slopes, they reach out to its larger end, and what lies beyond the slope is taken away from
the solid of the slabs at the end.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.planes import IN_PLANE, role_plane
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine, profile_along
from gaussiancad_core.sketch.regions import find_regions
from gaussiancad_core.solid.profiles import Profile

_NEAR = 1.5
"""Grid steps within which places are one."""

_STRAIGHT = 0.4
"""Grid steps by which a line along an axis may lean."""

_MOST = 0.5
"""Share of a slope that another view shows of it at least."""

_ON = 0.5
"""Grid steps between a slope and the widest outline at most."""

_TINY = 1e-9
"""mm within which two places are the same."""

_LEAST = 1.0
"""Grid steps that an outline slopes by at least, along either coordinate."""

_Lines = Mapping[Role, Sequence[PlaneLine]]


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
    """

    centre: tuple[float, float]
    small: Floats
    large: Floats
    line: PlaneLine
    is_foot: bool
    is_plain: bool
    is_groove: bool

    def beyond(self, grid: float) -> Profile:
        """What the step has more than the slope, with the arc along which it runs.

        Args:
            grid: mm of a step of the sheet's coordinates.
        """
        corner = np.array([self.small[0], self.large[1]])
        points = self.line.points
        ring = points if np.hypot(*(points[0] - self.large)) < _TINY else points[::-1]
        return profile_along(shapely.Polygon([*ring, corner]), [self.line], grid)


def without_slopes(
    lines: _Lines,
    axis: Axis,
    size: Sequence[float],
    grid: float,
    middle: tuple[float, float] | None = None,
) -> tuple[dict[Role, list[PlaneLine]], tuple[Slope, ...]]:
    """Views of a turned part with steps in place of what slopes, and the slopes: none where it is
    no turned part.

    Args:
        lines: of each view, mm in its plane.
        axis: that the part may be turned about.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
        middle: mm in the plane across the axis, of what it is turned about; None where a circle
            has to tell that.
    """
    found = {role: list(own) for role, own in lines.items()}
    centre = middle or _centre(lines, axis, size, grid)
    if centre is None:
        return found, ()
    beside = []
    for role, own in lines.items():
        axes = IN_PLANE[role_plane(role).normal]
        if axis.value not in axes:
            continue
        along = axes.index(axis.value)
        middle = centre[IN_PLANE[axis].index(axes[1 - along])]
        outline = _outline(own, grid)
        if outline is not None:
            beside.append(_Seen(role, own, outline, along, middle))
    widest = shapely.union_all([_half(own, side) for own in beside for side in (1.0, -1.0)])
    slopes = tuple(_slopes(beside, widest, centre, grid)) if not widest.is_empty else ()
    if not slopes:
        return found, ()
    for own in beside:
        found[own.role] = _stepped(own, slopes, grid)
    for role, own in found.items():
        if role_plane(role).normal is axis:
            found[role] = [each for each in own if not _is_foot(each, centre, slopes, grid)]
    return found, slopes


@dataclass(frozen=True, eq=False)
class _Seen:
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


def _centre(
    lines: _Lines, axis: Axis, size: Sequence[float], grid: float
) -> tuple[float, float] | None:
    """Where a circle as wide as the part is drawn."""
    first, second = (size[k] for k in IN_PLANE[axis])
    if abs(first - second) > _NEAR * grid:
        return None
    for role, own in lines.items():
        if role_plane(role).normal is not axis:
            continue
        for each in own:
            if not each.is_closed or each.circle is None:
                continue
            off = max(abs(each.circle.centre[k] - first / 2.0) for k in (0, 1))
            if max(off, abs(each.circle.radius - first / 2.0)) <= _NEAR * grid:
                return each.circle.centre
    return None


def _outline(lines: Sequence[PlaneLine], grid: float) -> shapely.Polygon | None:
    """What a view shows, without holes; None where it is in pieces."""
    regions = find_regions([own for own in lines if own.is_visible], (), grid)
    whole = shapely.union_all(regions.polygons)
    return shapely.Polygon(whole.exterior) if whole.geom_type == "Polygon" else None


def _slopes(
    beside: Sequence[_Seen],
    widest: shapely.Geometry,
    centre: tuple[float, float],
    grid: float,
) -> Iterator[Slope]:
    """What slopes in a view from beside on both sides of the axis, and is the outline of what all
    views from beside show together, each once."""
    near = _NEAR * grid
    sides = [(own, side) for own in beside for side in (1.0, -1.0)]
    shown = [list(_sloping(own, side, grid)) for own, side in sides]
    walls = [
        own.away(line.points[[0, -1]], side)
        for own, side in sides
        for line in own.lines
        if line.is_visible and line.constant(_STRAIGHT * grid) == 1 - own.along
    ]

    def ends_wall(place: Floats) -> bool:
        return any(np.hypot(*(ends - place).T).min() <= near for ends in walls)

    found: list[PlaneLine] = []
    for line in sorted((own for each in shown for own in each), key=lambda own: -own.length):
        points = line.points
        if any(_lies_along(points, other.points, near) for other in found):
            continue
        even = any(
            all(any(_lies_along(own.points, points, near) for own in each) for each in pair)
            for pair in zip(shown[::2], shown[1::2], strict=True)
        )
        border = widest.boundary
        if even and all(border.distance(shapely.Point(at)) <= _ON * grid for at in points):
            found.append(line)
    ends = [sorted(own.points[[0, -1]], key=lambda at: float(at[1])) for own in found]
    for line, (small, large) in zip(found, ends, strict=True):
        falling = sum(np.hypot(*(other - small)) <= near for other, _ in ends)
        told = not ends_wall(small), ends_wall(large), bool(falling > 1)
        yield Slope(centre, small, large, line, *told)


def _sloping(seen: _Seen, side: float, grid: float) -> Iterator[PlaneLine]:
    """Lines along the outline of a view on one side that are along no axis, as far as they are on
    that side; places are along the axis, and away from it."""
    border = seen.outline.boundary
    for own in seen.lines:
        is_sloping = np.ptp(own.points, axis=0).min() > _LEAST * grid
        if not own.is_visible or own.is_closed or not is_sloping:
            continue
        if border.distance(shapely.Point(own.points[len(own.points) // 2])) > _NEAR * grid:
            continue
        moved = _moved(own, seen, side)
        if (points := _beyond_axis(moved, _NEAR * grid)) is not None:
            yield from _one_way(replace(moved, points=points), _NEAR * grid)


def _one_way(line: PlaneLine, near: float) -> Iterator[PlaneLine]:
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


def _beyond_axis(line: PlaneLine, near: float) -> Floats | None:
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


def _length(points: Floats) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def _holds(line: PlaneLine, points: Floats, near: float) -> bool:
    """Whether a line lies along most of a slope, or holds all of it."""
    if _lies_along(line.points, points, near):
        return True
    own = shapely.LineString(line.points)
    return not line.is_closed and all(own.distance(shapely.Point(at)) <= near for at in points)


def _lies_along(points: Floats, other: Floats, near: float) -> bool:
    """Whether a line lies along most of another one."""
    line = shapely.LineString(other)
    on = all(line.distance(shapely.Point(at)) <= near for at in points)
    return on and _length(points) >= _MOST * _length(other)


def _stepped(seen: _Seen, slopes: Sequence[Slope], grid: float) -> list[PlaneLine]:
    """Lines of a view with two in place of each that slopes."""
    near = _NEAR * grid
    left = list(seen.lines)
    steps: list[PlaneLine] = []
    for side in (1.0, -1.0):
        for own in slopes:
            small, corner, large = seen.back(
                np.array([own.small, (own.small[0], own.large[1]), own.large]), side
            )
            gone = [
                place
                for place, is_gone in ((small, own.is_groove), (large, own.is_plain))
                if is_gone
            ]
            left = [
                line
                for line in left
                if not _holds(line, seen.back(own.line.points, side), near)
                and not any(_is_edge_at(line, place, seen, grid) for place in gone)
            ]
            # What two slopes fall to is bridged.
            if not own.is_groove:
                steps += _step(small, corner, grid)
            steps += _step(corner, large, grid)
    return [*left, *steps]


def _is_edge_at(line: PlaneLine, place: Floats, seen: _Seen, grid: float) -> bool:
    """Whether a visible line across the axis ends at a place."""
    across = line.is_visible and line.constant(_STRAIGHT * grid) == seen.along
    return across and np.hypot(*(line.points[[0, -1]] - place).T).min() <= _NEAR * grid


def _step(one: Floats, other: Floats, grid: float) -> list[PlaneLine]:
    is_long = float(np.hypot(*(other - one))) > _STRAIGHT * grid
    return [PlaneLine(np.array([one, other]), True)] if is_long else []


def _half(seen: _Seen, side: float) -> shapely.Geometry:
    """What a view shows on one side of the axis; places are along the axis, and away from it."""
    points = seen.away(np.array(seen.outline.exterior.coords), side)
    low, high = points[:, 0].min(), points[:, 0].max()
    box = shapely.box(low, 0.0, high, max(0.0, points[:, 1].max()) + 1.0)
    return shapely.Polygon(points).buffer(0.0).intersection(box)


def _moved(line: PlaneLine, seen: _Seen, side: float) -> PlaneLine:
    circle = line.circle
    if circle is not None:
        x, y = seen.away(np.array([circle.centre]), side)[0].tolist()
        circle = replace(circle, centre=(x, y))
    return replace(line, points=seen.away(line.points, side), circle=circle)


def _is_foot(
    line: PlaneLine, centre: tuple[float, float], slopes: Sequence[Slope], grid: float
) -> bool:
    """Whether a circle of the plan, or an arc, is the smaller end of a slope only."""
    if line.circle is None:
        return False
    near = _NEAR * grid
    if max(abs(a - b) for a, b in zip(line.circle.centre, centre, strict=True)) > near:
        return False
    return any(own.is_foot and abs(line.circle.radius - own.small[1]) <= near for own in slopes)
