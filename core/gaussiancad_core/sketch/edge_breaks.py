"""Edge breaks taken off first, and put on last: small chamfers and roundings seen from beside.

A chamfer around a face is a short slanted stroke at either end of it in a view from beside, and a
line at its foot; in the plan it is a narrow band along the outline.  As levels and regions of their
own they would make many thin slabs.  So the corners are made sharp, the bands belong to what they
run around, and the edges of the solid are broken at the end.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.coordinates.grid_tolerances import LEAN, MEETING, STEP
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.proposing.broken_corners import EdgeBreak
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine

_MOST = 0.06
"""The same at most, as a share of the part's longest extent."""

_SLOPE = 4.5
"""Ratio of both at most."""

_ROUND = (1.2, 1.9)
"""Radians that a rounding turns."""

_LONGER = 0.6
"""Of what a break takes away, how long the lines that it joins are at least."""


@dataclass(frozen=True)
class _Corner:
    """A break in a view, in coordinates across the axis and along it.

    Attributes:
        stroke: number of its line.
        wall, cap: (2,) where it meets the line along the axis, and that across it.
        walls, caps: numbers of these.
        feet: numbers of the lines at its ends that are its own.
    """

    stroke: int
    wall: Floats
    cap: Floats
    walls: tuple[int, ...]
    caps: tuple[int, ...]
    feet: tuple[int, ...]

    @property
    def sharp(self) -> Floats:
        """(2,) where the sharp edge is."""
        return np.array([self.wall[0], self.cap[1]])


def without_breaks(
    lines: Mapping[Role, Sequence[PlaneLine]], axis: Axis, extent: float, grid: float
) -> tuple[dict[Role, list[PlaneLine]], tuple[EdgeBreak, ...]]:
    """Views with the breaks of edges across an axis made sharp, and these.

    Args:
        lines: of each view, mm in its plane.
        axis: of the slabs; views along it stay.
        extent: mm, the part's longest.
        grid: mm of a step of the sheet's coordinates.
    """
    found: dict[Role, list[PlaneLine]] = {}
    breaks: list[EdgeBreak] = []
    for role, plane_lines in lines.items():
        axes = IN_PLANE[role_plane(role).normal]
        if axis.value not in axes:
            found[role] = list(plane_lines)
            continue
        along = axes.index(axis.value)
        across = Axis(axes[1 - along])
        columns = [1 - along, along]
        corners = list(_corners(plane_lines, columns, _MOST * extent, grid))
        found[role] = _sharpened(plane_lines, corners, columns, grid)
        breaks += [_break(each, plane_lines[each.stroke], axis, across) for each in corners]
    return found, tuple(breaks)


def _break(corner: _Corner, line: PlaneLine, axis: Axis, across: Axis) -> EdgeBreak:
    place, at = corner.sharp.tolist()
    width = abs(float(corner.cap[0] - place))
    height = float(corner.wall[1] - at)
    return EdgeBreak(axis, at, width, height, line.circle is not None, across, place)


def _corners(
    lines: Sequence[PlaneLine], columns: list[int], most: float, grid: float
) -> Iterator[_Corner]:
    near = MEETING * grid
    ends = [line.points[[0, -1]][:, columns] for line in lines]
    walls, caps = (
        [
            number
            for number, line in enumerate(lines)
            if line.constant(LEAN * grid) == columns[kind] and line.length > near
        ]
        for kind in (0, 1)
    )

    def at(numbers: Sequence[int], place: Floats) -> list[int]:
        return [k for k in numbers if np.hypot(*(ends[k] - place).T).min() <= near]

    def leads(number: int, place: Floats, corner: Floats) -> bool:
        """Whether a line leads from a place away from a corner."""
        far = ends[number][np.hypot(*(ends[number] - place).T).argmax()]
        return float((far - place) @ (place - corner)) > 0.0

    for number, plane_line in enumerate(lines):
        size = np.ptp(ends[number], axis=0)
        if (
            not plane_line.is_visible
            or plane_line.is_closed
            or not _is_break(plane_line, size, most, grid)
        ):
            continue
        for wall, cap in (ends[number], ends[number][::-1]):
            sharp = np.array([wall[0], cap[1]])
            joined = [k for k in at(walls, wall) if leads(k, wall, sharp)]
            covered = [k for k in at(caps, cap) if leads(k, cap, sharp)]
            long = [
                max((lines[k].length for k in items), default=0.0) for items in (joined, covered)
            ]
            if min(long) < _LONGER * float(size.max()):
                continue
            feet = (*at(caps, wall), *at(walls, cap))
            yield _Corner(number, wall, cap, tuple(joined), tuple(covered), feet)
            break


def _is_break(line: PlaneLine, size: Floats, most: float, grid: float) -> bool:
    least, longest = sorted(size.tolist())
    if least < STEP * grid or longest > most or longest > _SLOPE * least:
        return False
    if line.circle is None:
        return line.is_straight
    turn = line.length / line.circle.radius
    return _ROUND[0] < turn < _ROUND[1]


def _sharpened(
    lines: Sequence[PlaneLine], corners: Sequence[_Corner], columns: list[int], grid: float
) -> list[PlaneLine]:
    """Lines led on to the sharp corners; breaks, and what stands at their feet, are gone."""
    found = [line.points.copy() for line in lines]
    gone: set[int] = set()
    moved: set[int] = set()
    for corner in corners:
        gone |= {corner.stroke, *corner.feet}
        for numbers, place, kept in ((corner.walls, corner.wall, 1), (corner.caps, corner.cap, 0)):
            for number in numbers:
                ends = lines[number].points[[0, -1]][:, columns]
                away = np.hypot(*(ends - place).T)
                if away.min() <= MEETING * grid:
                    end = 0 if away.argmin() == 0 else -1
                    found[number][end, columns[kept]] = corner.sharp[kept]
                    moved.add(number)
    return [
        replace(line, points=points)
        for number, (line, points) in enumerate(zip(lines, found, strict=True))
        if number not in gone - moved
    ]
