"""Where the lines of a view pass smoothly into each other, along an axis of the part.

There surfaces meet smoothly that another view of the same axis sees from the side.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.near_points import connected_groups, near_lists
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Arc, Ellipse, Segment, Stroke
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView

_SMOOTH = 0.03
"""Sine of the angle between two strokes that go over into each other, at most."""

_NEAR, _NEAR_STEPS, _NEAR_COARSE = 0.3, 1.8, 1.0
"""px within which ends meet, and coordinates of two views are one, of exact strokes; steps of the
grid of a file that was rounded by which that is more; px of strokes of pictures, and at most."""

_BEFORE = 3.0
"""px by which a line stands before another one at least: widths of lines, and arcs that rise."""

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Junctions:
    """Coordinates along an axis of the part, px from its lower end.

    Attributes:
        smooth: where an arc goes over into a line, or another arc, along the axis or at a slant.
        corners: where strokes end otherwise, or go over into each other square to the axis.
        outer: those of the smooth ones that the view's outline has.
        seen: those of the outer ones that are seen from the low end, and from the high end, of the
            other axis that the view shows.
    """

    smooth: Floats
    corners: Floats
    outer: Floats
    seen: tuple[Floats, Floats]

    def tells(self, at: float, near: float) -> bool | None:
        """Whether faces meet smoothly there; None where the view does not tell."""
        if has_place(self.corners, at, near):
            return False
        return True if has_place(self.smooth, at, near) else None


def meeting_px(view: ReadView) -> float:
    """px within which ends of strokes of a view meet."""
    if view.source is StrokesSource.RASTER:
        return _NEAR_COARSE
    return min(_NEAR + _NEAR_STEPS * view.step, _NEAR_COARSE)


def junctions_along(view: ReadView, axis: Axis, near: float) -> Junctions:
    """Where strokes of a view end, along an axis that it shows."""
    ends, ways = ends_and_ways(view.strokes)
    if not len(ends):
        none = np.empty(0)
        return Junctions(none, none, none, (none, none))
    groups = near_lists(ends, ends, near)
    places = places_along(view, axis, ends)
    is_right = view.role.frame.right_axis[0] is axis
    outline = _on_outline(view, groups, near)
    smooth, corners, outer = [], [], []
    for number, group in enumerate(groups):
        strokes = [view.strokes[member // 2] for member in group]
        if not _is_smooth(number, group, ways):
            corners.append(places[number])
        elif abs(ways[number][0 if is_right else 1]) <= _SMOOTH:
            # Seen from the side the face turns away there: that is an outline.
            corners.append(places[number])
        elif any(isinstance(stroke, Arc | Ellipse) for stroke in strokes) and not _is_one(strokes):
            smooth.append(places[number])
            if outline[number // 2]:
                outer.append(number)
    seen = _seen_from_ends(view, axis, ends[outer], near)
    return Junctions(
        np.array(smooth),
        np.array(corners),
        places[outer],
        (places[outer][seen[:, 0]], places[outer][seen[:, 1]]),
    )


def _seen_from_ends(view: ReadView, axis: Axis, points: Floats, near: float) -> Flags:
    """(n, 2) whether no line of a view stands before points, seen along its other axis from the low
    end and from the high end of that."""
    frame = view.role.frame
    other = next(each for each, _ in (frame.right_axis, frame.up_axis) if each is not axis)
    if not len(points):
        return np.zeros((0, 2), dtype=bool)
    ink = np.concatenate([stroke.sample(max(near / 2.0, 0.25)) for stroke in view.strokes])
    along, depth = places_along(view, axis, ink), places_along(view, other, ink)
    seen = []
    for at, deep in zip(
        places_along(view, axis, points), places_along(view, other, points), strict=True
    ):
        before = depth[np.abs(along - at) <= near]
        seen.append((before.min() >= deep - _BEFORE, before.max() <= deep + _BEFORE))
    return np.array(seen)


def _on_outline(view: ReadView, groups: Sequence[Sequence[int]], near: float) -> Flags:
    """(n,) which strokes hang together with one that reaches the border of the view."""
    pairs = [(number // 2, other // 2) for number, group in enumerate(groups) for other in group]
    labels = connected_groups(np.array(pairs), len(view.strokes))
    low, high = np.array(view.box[:2]) + near, np.array(view.box[2:]) - near
    reach = [
        bool((points < low).any() or (points > high).any())
        for points in (stroke.sample(max(stroke.length / 16.0, near)) for stroke in view.strokes)
    ]
    return np.isin(labels, labels[np.array(reach, dtype=bool)])


def _is_one(strokes: Sequence[Stroke]) -> bool:
    """Whether strokes are pieces of one circle."""
    arcs = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    if len(arcs) < len(strokes):
        return False
    first = arcs[0]
    return all(
        np.hypot(*np.subtract(arc.centre, first.centre)) <= ONE_PLACE
        and abs(arc.radius - first.radius) <= ONE_PLACE
        for arc in arcs
    )


def ends_and_ways(strokes: Sequence[Stroke]) -> tuple[Floats, Floats]:
    """(2n, 2) ends of strokes, and directions of length 1 that lead on beyond them; whole circles
    have none of either: (nan, nan)."""
    ends: list[Floats] = []
    ways: list[Floats] = []
    for stroke in strokes:
        if isinstance(stroke, Segment):
            first, last = np.array(stroke.start), np.array(stroke.end)
            pairs = [(first, first - last), (last, last - first)]
        elif stroke.sweep >= 2.0 * np.pi * (1.0 - 1e-6):
            far = np.full(2, 1e9) + len(ends)
            pairs = [(far, np.array([1.0, 0.0])), (far + 1e6, np.array([1.0, 0.0]))]
        else:
            points = stroke.sample(max(stroke.length / 2000.0, 1e-3))
            pairs = [(points[0], points[0] - points[1]), (points[-1], points[-1] - points[-2])]
        for place, way in pairs:
            ends.append(place)
            ways.append(way / max(float(np.hypot(*way)), 1e-12))
    return np.array(ends).reshape(-1, 2), np.array(ways).reshape(-1, 2)


def _is_smooth(number: int, group: Sequence[int], ways: Floats) -> bool:
    """Whether just one other stroke begins at an end, and goes on in its direction."""
    others = [index for index in group if index != number]
    return len(others) == 1 and goes_on(ways[number], ways[others[0]])


def goes_on(one: Floats, two: Floats) -> bool:
    """Whether a stroke that leads on in one direction goes over into one that does in the other."""
    cross = abs(float(one[0] * two[1] - one[1] * two[0]))
    return float(one @ two) < 0.0 and cross <= _SMOOTH


def places_along(view: ReadView, axis: Axis, points: Floats) -> Floats:
    """(n,) px along an axis of the part from its lower end, of points of a view."""
    x0, y0, x1, y1 = view.box
    frame = view.role.frame
    if frame.right_axis[0] is axis:
        return points[:, 0] - x0 if frame.right_axis[1] > 0 else x1 - points[:, 0]
    return y1 - points[:, 1] if frame.up_axis[1] > 0 else points[:, 1] - y0


def extent_along(view: ReadView, axis: Axis) -> float:
    """px of a view along an axis of the part that it shows."""
    x0, y0, x1, y1 = view.box
    return x1 - x0 if view.role.frame.right_axis[0] is axis else y1 - y0


def has_place(places: Floats, at: float, near: float) -> bool:
    """Whether one of some places is there, all in px."""
    return bool((np.abs(places - at) <= near).any())
