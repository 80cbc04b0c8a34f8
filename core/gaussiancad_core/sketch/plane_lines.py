"""The strokes of views as chains of points in the coordinates of the model's planes.

A plane's coordinates are the model's two other ones in the order x, y, z, in mm from the corner of
the part's bounding box; opposite views share a plane.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import ceil, pi

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, line_through
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.projection_planes import plane_points
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.solid.profiles import Profile

Floats = npt.NDArray[np.float64]

CHORD = 2.0 * pi / 96
"""Radians of an arc between two of its points, at most."""

_ON_ARC = 0.6
"""Grid steps within which a corner lies on an arc."""

_CHORDS = 24
"""Of a curve that is no arc."""


@dataclass(frozen=True, eq=False)
class PlaneLine:
    """A stroke in a plane.

    Attributes:
        points: (n, 2) mm along it; two of a straight one.
        is_visible: whether it is drawn solid.
        circle: that it runs along; None where it is none.
        is_closed: whether it is a whole circle.
        stroke: number of the stroke in its view; None of what is no stroke.
    """

    points: Floats
    is_visible: bool
    circle: Circle | None = None
    is_closed: bool = False
    stroke: int | None = None

    @property
    def length(self) -> float:
        """mm along it."""
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())

    @property
    def is_straight(self) -> bool:
        """Whether it is a segment."""
        return len(self.points) == 2

    @property
    def arc(self) -> Circle:
        """The circle that a round one runs along.

        Raises:
            ValueError: it runs along none.
        """
        if self.circle is None:
            raise ValueError("the line runs along no circle")
        return self.circle

    @property
    def curve(self) -> LineOrCircle | None:
        """The whole line or circle that it runs along; None of another curve."""
        if self.circle is not None:
            return self.circle
        if not self.is_straight:
            return None
        start, end = map(tuple, self.points.tolist())
        return line_through(start, end)

    def constant(self, near: float) -> int | None:
        """The coordinate that does not change along a segment, within so many mm; None if both
        do, or it is none."""
        if not self.is_straight:
            return None
        dx, dy = np.abs(self.points[1] - self.points[0])
        if min(dx, dy) > near:
            return None
        return 0 if dx < dy else 1

    def swapped(self) -> "PlaneLine":
        """The same with the two coordinates exchanged."""
        circle = self.circle and Circle(self.circle.centre[::-1], self.circle.radius)
        return replace(self, points=self.points[:, ::-1].copy(), circle=circle)


def plane_lines(strokes: Iterable[DrawnStroke], role: Role) -> list[PlaneLine]:
    """The strokes of a view in the coordinates of its plane.

    Args:
        strokes: mm in the view's own plane (right, up).
        role: of the view.
    """
    found = []
    for number, stroke in enumerate(strokes):
        if stroke.length <= 0.0:
            continue
        is_visible = stroke.linetype is Linetype.VISIBLE
        points = plane_points(_points(stroke), role, 1.0)
        circle, closed = None, False
        if isinstance(stroke, Arc):
            x, y = plane_points(np.array(stroke.centre), role, 1.0).tolist()
            circle, closed = Circle((x, y), stroke.radius), stroke.is_full
        found.append(PlaneLine(points, is_visible, circle, closed, number))
    return found


def whole_circle(circle: Circle, is_visible: bool, stroke: int | None = None) -> PlaneLine:
    """A circle as a line; its first point is its last."""
    angles = np.linspace(0.0, 2.0 * pi, round(2.0 * pi / CHORD) + 1)
    points = np.array(circle.centre) + circle.radius * np.stack(
        [np.cos(angles), np.sin(angles)], axis=1
    )
    points[-1] = points[0]
    return PlaneLine(points, is_visible, circle, True, stroke)


def arc_between(circle: Circle, ends: tuple[Floats, Floats], sweep: float) -> Floats:
    """(n, 2) points of an arc, the first and last the places of the circle nearest to two ends.

    Args:
        circle: that it runs along.
        ends: (2,) each.
        sweep: radians that it turns, about; negative from the second axis to the first.
    """
    first, last = (circle.parameter(tuple(end.tolist())) for end in ends)
    turn = 2.0 * pi
    sweep = (last - first) + turn * round((sweep - (last - first)) / turn)
    count = max(3, ceil(abs(sweep) / CHORD) + 1)
    angles = first + np.linspace(0.0, sweep, count)
    return np.array(circle.centre) + circle.radius * np.stack([np.cos(angles), np.sin(angles)], 1)


def profile_along(area: shapely.Polygon, lines: Iterable[PlaneLine], grid: float) -> Profile:
    """A piece of a plane with the arcs along which its outline runs.

    Args:
        area: mm.
        lines: that bound it.
        grid: mm of a step of the sheet's coordinates.
    """
    arcs = tuple(
        Arc(line.circle.centre, line.circle.radius, 0.0, 2.0 * pi, Linetype.VISIBLE)
        for line in lines
        if line.circle is not None
    )
    return Profile(shapely.geometry.polygon.orient(area), arcs, _ON_ARC * grid)


def _points(stroke: DrawnStroke) -> Floats:
    if isinstance(stroke, Segment):
        return np.array([stroke.start, stroke.end])
    if isinstance(stroke, Arc):
        if stroke.is_full:
            return whole_circle(Circle(stroke.centre, stroke.radius), True).points
        return stroke.sample(stroke.length / max(2, ceil(stroke.sweep / CHORD)) * (1.0 + 1e-9))
    return stroke.sample(stroke.length / _CHORDS)
