"""Arcs that may only stand for another curve.

Some systems write the projection of a circle that leans, or of a curve of intersection, as an arc
that follows it.  Such an arc is no trace of a cylinder.  One that is passes smoothly into its
neighbours, has a centre whose coordinates other lines and circles have too, or shows in a view
along another axis with the same radius, as the profile of a body of revolution does.
"""

from collections.abc import Iterator
from dataclasses import replace
from math import cos, hypot, pi, sin

import numpy as np

from gaussiancad_core.coordinates.stroke_finder import LINKS
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.tolerances import LEVEL
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, plane_points, role_plane
from gaussiancad_core.model.views import Arc, Segment

ROUGHLY = 0.1
"""Units by which such an arc may leave the curve that it follows."""

_ROUND = 1.01 * pi
"""Sweep from which an arc stands for itself: no curve follows a circle that far by chance."""

_SMOOTH = 2e-3
"""Sine of the angle within which two strokes pass smoothly into each other."""


def without_rough_arcs(views: DrawnViews) -> DrawnViews | None:
    """The views with curves for all arcs that may be rough; None if there are none."""
    levels = _levels(views)
    strokes = {
        role: tuple(
            _curve(stroke)
            if isinstance(stroke, Arc) and _is_rough(stroke, role, views, levels)
            else stroke
            for stroke in curves
        )
        for role, curves in views.strokes.items()
    }
    return replace(views, strokes=strokes) if strokes != dict(views.strokes) else None


def _curve(arc: Arc) -> Polyline:
    points = arc.sample(arc.length / LINKS)
    return Polyline(tuple(map(tuple, points.tolist())), arc.linetype)


def _is_rough(stroke: Arc, role: Role, views: DrawnViews, levels: dict[Axis, np.ndarray]) -> bool:
    if stroke.sweep > _ROUND:
        return False
    tolerance = views.tolerance
    (centre,) = plane_points(np.array([stroke.centre]), role, 1.0)
    axes = [Axis(index) for index in IN_PLANE[role_plane(role).normal]]
    if all(
        np.abs(levels[axis] - at).min(initial=np.inf) <= tolerance
        for axis, at in zip(axes, centre, strict=True)
    ):
        return False
    here = dict(zip(axes, centre.tolist(), strict=True))
    if any(_is_same(here, stroke.radius, arc, tolerance) for arc in _arcs_elsewhere(role, views)):
        return False
    strokes = views.strokes[role]
    return not (
        _is_concentric(stroke, strokes, tolerance) or _is_smooth(stroke, strokes, tolerance)
    )


def _is_concentric(arc: Arc, strokes: tuple[DrawnStroke, ...], tolerance: float) -> bool:
    """Whether another circle has the same centre."""
    return any(
        isinstance(stroke, Arc)
        and abs(stroke.radius - arc.radius) > tolerance
        and hypot(stroke.centre[0] - arc.centre[0], stroke.centre[1] - arc.centre[1]) <= tolerance
        for stroke in strokes
    )


def _arcs_elsewhere(role: Role, views: DrawnViews) -> Iterator[tuple[dict[Axis, float], float]]:
    """Centres and radii of arcs in views along other axes."""
    for other, curves in views.strokes.items():
        if role_plane(other).normal is role_plane(role).normal:
            continue
        axes = [Axis(index) for index in IN_PLANE[role_plane(other).normal]]
        for stroke in curves:
            if isinstance(stroke, Arc):
                (centre,) = plane_points(np.array([stroke.centre]), other, 1.0)
                yield dict(zip(axes, centre.tolist(), strict=True)), stroke.radius


def _is_same(
    centre: dict[Axis, float],
    radius: float,
    other: tuple[dict[Axis, float], float],
    tolerance: float,
) -> bool:
    """Whether an arc of another view has the same radius, and the same place along both's axis."""
    there, its_radius = other
    return abs(radius - its_radius) <= tolerance and all(
        abs(centre[axis] - there[axis]) <= tolerance for axis in centre if axis in there
    )


def _is_smooth(arc: Arc, strokes: tuple[DrawnStroke, ...], tolerance: float) -> bool:
    """Whether an arc passes smoothly into another stroke at one of its ends."""
    for angle in (arc.start_angle, arc.start_angle + arc.sweep):
        x, y = cos(angle), sin(angle)
        end = arc.centre[0] + arc.radius * x, arc.centre[1] + arc.radius * y
        for stroke in strokes:
            if stroke is arc:
                continue
            for a, b in _ways(stroke, end, tolerance):
                if abs(a * x + b * y) < _SMOOTH:
                    return True
    return False


def _ways(
    stroke: DrawnStroke, end: tuple[float, float], tolerance: float
) -> Iterator[tuple[float, float]]:
    """Unit directions of a line or arc where it ends at a point."""
    if isinstance(stroke, Segment):
        near = min(hypot(end[0] - x, end[1] - y) for x, y in (stroke.start, stroke.end))
        if near <= tolerance and stroke.length > 0.0:
            a, b = np.subtract(stroke.end, stroke.start) / stroke.length
            yield float(a), float(b)
    elif isinstance(stroke, Arc):
        for angle in (stroke.start_angle, stroke.start_angle + stroke.sweep):
            x, y = cos(angle), sin(angle)
            at = stroke.centre[0] + stroke.radius * x, stroke.centre[1] + stroke.radius * y
            if hypot(end[0] - at[0], end[1] - at[1]) <= tolerance:
                yield -y, x


def _levels(views: DrawnViews) -> dict[Axis, np.ndarray]:
    """Coordinates that straight strokes along an axis, and centres of whole circles, have."""
    found: dict[Axis, list[float]] = {axis: [] for axis in Axis}
    for role, curves in views.strokes.items():
        axes = [Axis(index) for index in IN_PLANE[role_plane(role).normal]]
        for stroke in curves:
            if isinstance(stroke, Segment):
                start, end = plane_points(np.array([stroke.start, stroke.end]), role, 1.0)
                for axis, low, high in zip(axes, start, end, strict=True):
                    if abs(high - low) <= LEVEL * stroke.length:
                        found[axis].append(float(low + high) / 2.0)
            elif isinstance(stroke, Arc) and stroke.sweep > _ROUND:
                (centre,) = plane_points(np.array([stroke.centre]), role, 1.0)
                for axis, at in zip(axes, centre, strict=True):
                    found[axis].append(float(at))
    return {axis: np.array(values) for axis, values in found.items()}
