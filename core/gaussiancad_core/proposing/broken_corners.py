"""Corners of a view at which an edge may be broken: a short slanted stroke, or an arc, between a
line across each of the part's axes."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.proposing.lines_by_plane import Floats
from gaussiancad_core.proposing.stroke_lines import StrokeLine, led

_MOST = 0.06
"""Share of the part's longest extent that a break takes away at most."""

_LEAST = 3.0
"""Tolerances that it takes away at least."""

_SLOPE = 4.5
"""Ratio of what it takes away in its two ways at most."""

_ROUND = (1.2, 1.9)
"""Radians that a rounding turns."""

_LONGER = 0.6
"""Of what a break takes away, how long the lines that it joins are at least."""

MEET = 3.0
"""Tolerances within which ends of lines meet, and two breaks are at one place."""


@dataclass(frozen=True)
class EdgeBreak:
    """A chamfer or rounding around a face.

    Attributes:
        axis: across the face.
        at: mm along it, of the face.
        width: mm that it takes away across the axis.
        height: mm that it takes away along it; towards lower places where it is negative.
        is_round: whether it is a rounding.
        across: the model's other axis in the view that shows it.
        place: mm along that, of the sharp edge seen there.
    """

    axis: Axis
    at: float
    width: float
    height: float
    is_round: bool
    across: Axis
    place: float


@dataclass(frozen=True, eq=False)
class BrokenCorner:
    """A break in a view.

    Attributes:
        role: of the view.
        stroke: number of its line.
        feet: (2, 2) where it meets the line across the plane's first coordinate, and that across
            its second one.
        joined: for either, numbers of these lines.
        feet_lines: numbers of lines at its feet that are its own.
        is_round: whether it is an arc.
    """

    role: Role
    stroke: int
    feet: Floats
    joined: tuple[tuple[int, ...], tuple[int, ...]]
    feet_lines: tuple[int, ...]
    is_round: bool

    @property
    def sharp(self) -> Floats:
        """(2,) where the sharp edge is."""
        return np.array([self.feet[0, 0], self.feet[1, 1]])

    def around(self, column: int) -> EdgeBreak:
        """It as a break around the face across a coordinate of the plane."""
        axes = IN_PLANE[role_plane(self.role).normal]
        width = abs(self.feet[1 - column, 1 - column] - self.feet[column, 1 - column])
        height = self.feet[1 - column, column] - self.feet[column, column]
        place, at = self.sharp[1 - column], self.sharp[column]
        return EdgeBreak(
            axis=Axis(axes[column]),
            at=float(at),
            width=float(width),
            height=float(height),
            is_round=self.is_round,
            across=Axis(axes[1 - column]),
            place=float(place),
        )


def broken_corners(
    lines: Sequence[StrokeLine], role: Role, views: DrawnViews, near: float
) -> Iterator[BrokenCorner]:
    """What may be a break in a view."""
    most, least = _MOST * max(views.size), _LEAST * views.tolerance
    across = [
        [
            number
            for number, line in enumerate(lines)
            if line.is_straight and np.ptp(line.ends[:, column]) <= near < line.length
        ]
        for column in (0, 1)
    ]
    for number, line in enumerate(lines):
        size = np.ptp(line.ends, axis=0)
        if not _is_break(line, size, (least, most)):
            continue
        for feet in (line.ends, line.ends[::-1]):
            sharp = np.array([feet[0, 0], feet[1, 1]])
            joined = [
                tuple(
                    other
                    for other in across[column]
                    if lines[other].lies_at(feet[column], near)
                    and lines[other].leads(feet[column], sharp)
                )
                for column in (0, 1)
            ]
            long = [max((lines[k].length for k in numbers), default=0.0) for numbers in joined]
            if min(long) < _LONGER * float(size.max()):
                continue
            feet_lines = tuple(
                other
                for column in (0, 1)
                for other in across[1 - column]
                if lines[other].lies_at(feet[column], near)
                and not lines[other].leads(feet[column], feet[1 - column])
            )
            is_round = isinstance(line.stroke, Arc)
            yield BrokenCorner(role, number, feet, (joined[0], joined[1]), feet_lines, is_round)
            break


def _is_break(line: StrokeLine, size: Floats, limits: tuple[float, float]) -> bool:
    least, most = limits
    small, large = sorted(size.tolist())
    if line.stroke.linetype is not Linetype.VISIBLE:
        return False
    if small < least or large > most or large > _SLOPE * small:
        return False
    if isinstance(line.stroke, Arc):
        return _ROUND[0] < line.stroke.sweep < _ROUND[1]
    return line.is_straight


def sharpened(
    lines: Sequence[StrokeLine], corners: Sequence[BrokenCorner], near: float
) -> list[StrokeLine]:
    """Lines led on to the sharp corners; breaks, and what stands at their feet, are gone."""
    found = [line.ends.copy() for line in lines]
    gone: set[int] = set()
    moved: set[int] = set()
    for corner in corners:
        gone |= {corner.stroke, *corner.feet_lines}
        for column, numbers in enumerate(corner.joined):
            for number in numbers:
                away = np.hypot(*(lines[number].ends - corner.feet[column]).T)
                if away.min() <= near:
                    found[number][away.argmin(), 1 - column] = corner.sharp[1 - column]
                    moved.add(number)
    return [
        led(line, ends) if number in moved else line
        for number, (line, ends) in enumerate(zip(lines, found, strict=True))
        if number not in gone - moved
    ]
