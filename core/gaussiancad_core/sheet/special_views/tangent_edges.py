"""Lines where faces meet smoothly: some programs draw them, though nothing is bent there.

Such a line runs in its view from one place to another where an arc goes over into a line or an arc
without a corner.  Or it stands where another view that shows the same axis has such a place; an
edge stands where that one has a corner.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.near_points import connected_groups, near_lists
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Ellipse, Segment, Stroke
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.votes import MOST

_SMOOTH = 0.03
"""Sine of the angle between two strokes that go over into each other, at most."""

_NEAR, _NEAR_STEPS, _NEAR_COARSE = 0.3, 1.8, 1.0
"""px within which ends meet, and coordinates of two views are one, of exact strokes; steps of the
grid of a file that was rounded by which that is more; px of strokes of pictures, and at most."""

_LEVEL = 0.3
"""px by which the ends of a line along the sheet may differ across."""

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]


@dataclass(frozen=True)
class _Junctions:
    """Coordinates along an axis of the part, px from its lower end.

    Attributes:
        smooth: where an arc goes over into a line, or another arc, along the axis or at a slant.
        corners: where strokes end otherwise, or go over into each other square to the axis.
        outer: those of the smooth ones that the view's outline has.
    """

    smooth: Floats
    corners: Floats
    outer: Floats

    def tells(self, at: float, near: float) -> bool | None:
        """Whether faces meet smoothly there; None where the view does not tell."""
        if _has(self.corners, at, near):
            return False
        return True if _has(self.smooth, at, near) else None


def _near(view: ReadView) -> float:
    """px within which ends of strokes of a view meet."""
    if view.source is StrokesSource.RASTER:
        return _NEAR_COARSE
    return min(_NEAR + _NEAR_STEPS * view.step, _NEAR_COARSE)


def without_tangent_edges(
    drawn: Sequence[ReadView],
) -> tuple[tuple[ReadView, ...], tuple[Segment, ...]]:
    """Views without the lines where faces meet smoothly, and these, px of the upright sheet."""
    near = max(_near(view) for view in drawn)
    between = [_between_smooth(view, near) for view in drawn]
    plain = [_less(view, segments) for view, segments in zip(drawn, between, strict=True)]
    known = {
        (view.role, axis): _junctions(view, axis, near)
        for view in plain
        for axis in (view.role.frame.right_axis[0], view.role.frame.up_axis[0])
    }
    across = [
        [
            stroke
            for stroke in view.strokes
            if isinstance(stroke, Segment) and _is_tangent(stroke, view, known, near)
        ]
        for view in plain
    ]
    if not _are_drawn(plain, across, known, near):
        across = [[] for _ in plain]
    views = tuple(_less(view, items) for view, items in zip(plain, across, strict=True))
    return views, tuple(stroke for item in (*between, *across) for stroke in item)


def _are_drawn(
    views: Sequence[ReadView],
    found: Sequence[Sequence[Segment]],
    known: dict[tuple[Role, Axis], _Junctions],
    near: float,
) -> bool:
    """Whether a sheet draws such lines: then most places have theirs, or it was an edge."""
    drawn = places = 0
    for view, segments in zip(views, found, strict=True):
        for axis in (view.role.frame.right_axis[0], view.role.frame.up_axis[0]):
            wanted = [
                at
                for (role, shown), junctions in known.items()
                if shown is axis and role is not view.role
                for at in _distinct(junctions.outer, near)
                if near < at < _extent(view, axis) - near and junctions.tells(at, near)
            ]
            seen = [place for line in segments if (place := _place(line, view, axis)) is not None]
            places += len(wanted)
            drawn += sum(_has(np.array(seen), at, near) for at in wanted)
    return drawn >= MOST * max(places, 1)


def _distinct(places: Floats, near: float) -> list[float]:
    """Places that are apart, in order."""
    found: list[float] = []
    for place in np.sort(places).tolist():
        if not found or place - found[-1] > near:
            found.append(place)
    return found


def _less(view: ReadView, gone: Sequence[Stroke]) -> ReadView:
    dropped = set(map(id, gone))
    return replace(
        view, strokes=tuple(stroke for stroke in view.strokes if id(stroke) not in dropped)
    )


def _between_smooth(view: ReadView, near: float) -> list[Segment]:
    """Lines from one place to another where, without them, an arc goes over into what follows."""
    ends, ways = _ends(view.strokes)
    if not len(ends):
        return []
    groups = near_lists(ends, ends, near)

    def is_passed(end: int) -> bool:
        others = [item for item in groups[end] if item // 2 != end // 2]
        return (
            len(others) == 2
            and not any(_goes_on(ways[end], ways[other]) for other in others)
            and _goes_on(ways[others[0]], ways[others[1]])
            and any(_is_round(view.strokes, other) for other in others)
        )

    return [
        stroke
        for number, stroke in enumerate(view.strokes)
        if isinstance(stroke, Segment) and is_passed(2 * number) and is_passed(2 * number + 1)
    ]


def _is_tangent(
    stroke: Segment, view: ReadView, known: dict[tuple[Role, Axis], _Junctions], near: float
) -> bool:
    for axis in (view.role.frame.right_axis[0], view.role.frame.up_axis[0]):
        at = _place(stroke, view, axis)
        if at is None or not near < at < _extent(view, axis) - near:
            continue
        tellses = [
            junctions.tells(at, near)
            for (role, shown), junctions in known.items()
            if shown is axis and role is not view.role
        ]
        if True in tellses and False not in tellses:
            return True
    return False


def _place(stroke: Segment, view: ReadView, axis: Axis) -> float | None:
    """px along an axis at which a line stands that runs square to it; None if it does not."""
    (x0, y0), (x1, y1) = stroke.start, stroke.end
    upright, level = abs(x1 - x0) <= _LEVEL, abs(y1 - y0) <= _LEVEL
    is_right = view.role.frame.right_axis[0] is axis
    if upright == level or upright is not is_right:
        return None
    point = np.array([[(x0 + x1) / 2.0, (y0 + y1) / 2.0]])
    return float(_along(view, axis, point)[0])


def _junctions(view: ReadView, axis: Axis, near: float) -> _Junctions:
    """Where strokes of a view end, along an axis that it shows."""
    ends, ways = _ends(view.strokes)
    if not len(ends):
        return _Junctions(*(np.empty(0) for _ in range(3)))
    groups = near_lists(ends, ends, near)
    places = _along(view, axis, ends)
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
                outer.append(places[number])
    return _Junctions(np.array(smooth), np.array(corners), np.array(outer))


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


def _ends(strokes: Sequence[Stroke]) -> tuple[Floats, Floats]:
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
    return len(others) == 1 and _goes_on(ways[number], ways[others[0]])


def _goes_on(one: Floats, two: Floats) -> bool:
    cross = abs(float(one[0] * two[1] - one[1] * two[0]))
    return float(one @ two) < 0.0 and cross <= _SMOOTH


def _is_round(strokes: Sequence[Stroke], end: int) -> bool:
    return isinstance(strokes[end // 2], Arc | Ellipse)


def _along(view: ReadView, axis: Axis, points: Floats) -> Floats:
    """(n,) px along an axis of the part from its lower end, of points of a view."""
    x0, y0, x1, y1 = view.box
    frame = view.role.frame
    if frame.right_axis[0] is axis:
        return points[:, 0] - x0 if frame.right_axis[1] > 0 else x1 - points[:, 0]
    return y1 - points[:, 1] if frame.up_axis[1] > 0 else points[:, 1] - y0


def _extent(view: ReadView, axis: Axis) -> float:
    x0, y0, x1, y1 = view.box
    return x1 - x0 if view.role.frame.right_axis[0] is axis else y1 - y0


def _has(places: Floats, at: float, near: float) -> bool:
    return bool((np.abs(places - at) <= near).any())
