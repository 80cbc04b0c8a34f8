"""Round holes across the slabs: taken off the views first, and cut out of the solid last.

A hole along another axis than the slabs' is a circle in a view from beside, and a pair of lines
along the hole, mostly hidden ones, in the others.  As levels and regions these lines would divide
everything that they cross.
"""

from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import inf

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.holes import NotedHole
from gaussiancad_core.reasoning.curves import CircleCurve
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.planes import IN_PLANE, RolePlane, role_plane
from gaussiancad_core.sketch.plane_lines import PlaneLine
from gaussiancad_core.sketch.tidy import with_whole_circles

_NEAR = 1.0
"""Grid steps between a circle and the walls of its hole, and between centres that are one."""

_STRAIGHT = 0.4
"""Grid steps by which a line along an axis may lean."""

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
    circle: CircleCurve
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

    A circle is a hole where hidden lines are its walls, or any lines of a section.  On a sheet
    without hidden lines every circle is one, as deep as a note says, or to the next void.

    Args:
        lines: of each view, mm in its plane.
        axis: across the slabs; circles of views along it stay.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
        views: of which they are: what is cut, and holes of which notes speak.
    """
    found = {role: list(own) for role, own in lines.items()}
    draws_hidden = any(not own.is_visible for drawn in lines.values() for own in drawn)
    holes = []
    for role in lines:
        plane = role_plane(role)
        if plane.normal is axis or role in views.cuts:
            continue
        found[role] = whole = with_whole_circles(found[role], grid)
        for own in _circles(found[role], [size[k] for k in IN_PLANE[plane.normal]], grid):
            walls = list(_walls(found, (plane.normal, own.circle), grid, views.cuts))
            intervals = tuple(dict.fromkeys(_shared(walls, grid)))
            depth = None
            if not intervals:
                if draws_hidden:
                    continue
                depth = _depth(views.holes, role, own.circle, grid)
                if depth is None and _is_around(own.circle, whole, grid):
                    continue
                intervals = ((-inf, inf),)
            holes.append(CrossHole(plane.normal, own.circle, intervals, depth, role))
            gone = {id(own), *(id(line) for pair in walls for line in pair)}
            for each, drawn in found.items():
                found[each] = [line for line in drawn if id(line) not in gone]
            _drop_floors(found, holes[-1], grid)
    return found, tuple(_once(holes, grid))


def _circles(lines: Sequence[PlaneLine], size: Sequence[float], grid: float) -> list[PlaneLine]:
    """Whole visible circles that stay away from the outline."""
    return [
        own
        for own in lines
        if own.is_closed
        and own.circle is not None
        and own.is_visible
        and all(
            own.circle.radius + _INSIDE * grid < at < extent - own.circle.radius - _INSIDE * grid
            for at, extent in zip(own.circle.centre, size, strict=True)
        )
    ]


def _walls(
    lines: _Lines, hole: tuple[Axis, CircleCurve], grid: float, cuts: Container[Role]
) -> Iterator[tuple[PlaneLine, ...]]:
    """Of each view from beside, hidden lines along a hole at either side of its circle; of what is
    cut any lines."""
    normal, circle = hole
    for role, drawn in lines.items():
        axes = IN_PLANE[role_plane(role).normal]
        if normal.value not in axes:
            continue
        across = 1 - axes.index(normal.value)
        middle = circle.centre[IN_PLANE[normal].index(axes[across])]
        sides = [
            [
                own
                for own in drawn
                if (role in cuts or not own.is_visible)
                and own.constant(_STRAIGHT * grid) == across
                and abs(own.points[:, across].mean() - middle - side) <= _NEAR * grid
            ]
            for side in (-circle.radius, circle.radius)
        ]
        if all(sides):
            yield tuple(sides[0] + sides[1])


def _shared(walls: Sequence[Sequence[PlaneLine]], grid: float) -> Iterator[_Interval]:
    """From and to along the hole of its walls, in the view that shows most of them."""
    spans = [[_span(own, grid) for own in each] for each in walls]
    yield from max(spans, key=lambda own: sum(b - a for a, b in own), default=[])


def _span(line: PlaneLine, grid: float) -> _Interval:
    along = 1 - (line.constant(_STRAIGHT * grid) or 0)
    low, high = sorted(line.points[:, along].tolist())
    return low, high


def _depth(
    noted: Sequence[NotedHole], role: Role, circle: CircleCurve, grid: float
) -> float | None:
    """How deep a note says that the hole of a circle is, infinite for through; None without one."""
    signs = role_plane(role).signs
    for own in noted:
        centre = [at * sign for at, sign in zip(own.centre, signs, strict=True)]
        off = max(abs(a - b) for a, b in zip(centre, circle.centre, strict=True))
        if own.role is not role or off > _NEAR * grid:
            continue
        for step in own.steps:
            if abs(step.diameter - 2.0 * circle.radius) <= 2.0 * _NEAR * grid:
                return inf if step.depth is None else step.depth
    return None


def _is_around(circle: CircleCurve, lines: Sequence[PlaneLine], grid: float) -> bool:
    """Whether a smaller circle lies about the same centre: nothing tells then how deep it is."""
    return any(
        own.circle is not None
        and own.circle.radius < circle.radius - _NEAR * grid
        and max(abs(a - b) for a, b in zip(own.circle.centre, circle.centre, strict=True))
        <= _NEAR * grid
        for own in lines
    )


def _drop_floors(lines: dict[Role, list[PlaneLine]], hole: CrossHole, grid: float) -> None:
    """Take away hidden lines across a hole at its ends."""
    near = _NEAR * grid
    ends = [at for own in hole.intervals for at in own]
    for role, drawn in list(lines.items()):
        axes = IN_PLANE[role_plane(role).normal]
        if hole.axis.value not in axes:
            continue
        along = axes.index(hole.axis.value)
        middle = hole.circle.centre[IN_PLANE[hole.axis].index(axes[1 - along])]
        lines[role] = [
            own
            for own in drawn
            if own.is_visible
            or own.constant(_STRAIGHT * grid) != along
            or min(abs(own.points[:, along].mean() - at) for at in ends) > near
            or abs(own.points[:, 1 - along] - middle).max() > hole.circle.radius + near
        ]


def _once(holes: Sequence[CrossHole], grid: float) -> Iterator[CrossHole]:
    """Holes of which opposite views both show the circle, once."""
    kept: list[CrossHole] = []
    for own in holes:
        if not any(_is_same(own, other, grid) for other in kept):
            kept.append(own)
    yield from kept


def _is_same(one: CrossHole, other: CrossHole, grid: float) -> bool:
    apart = [abs(a - b) for a, b in zip(one.circle.centre, other.circle.centre, strict=True)]
    sizes = abs(one.circle.radius - other.circle.radius)
    return one.axis is other.axis and max(*apart, sizes) <= _NEAR * grid
