"""Round holes that a sheet draws: circles, and pairs of lines on which two views agree."""

from collections.abc import Iterator
from itertools import combinations, product

import numpy as np

from gaussiancad_core.judging.drawn_lines import DrawnSheet, DrawnView
from gaussiancad_core.judging.model_features import Bore
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

_SAME_TOLERANCES, _SAME = 4.0, 2e-3
"""Within which two places are one: tolerances of strokes, and share of the longest extent."""

_WIDEST = 0.6
"""Share of the longest extent that a pair of lines is apart at most."""


def drawn_bores(sheet: DrawnSheet) -> tuple[Bore, ...]:
    """The round holes that a sheet may draw, each once."""
    same = max(_SAME_TOLERANCES * sheet.tolerance, _SAME * sheet.longest)
    found: list[Bore] = []
    for bore in (*_by_lines(sheet, same), *_by_circles(sheet)):
        # A circle tells no depth: where lines do, theirs counts.
        if not any(_is_one(bore, other, same) for other in found):
            found.append(bore)
    return tuple(found)


def _is_one(bore: Bore, other: Bore, same: float) -> bool:
    return (
        bore.axis is other.axis
        and abs(bore.radius - other.radius) <= same
        and bool(np.hypot(*np.subtract(bore.centre, other.centre)) <= same)
    )


def _by_circles(sheet: DrawnSheet) -> Iterator[Bore]:
    for view in sheet.views:
        axis = view.role.frame.look_axis[0]
        for line in view.lines:
            if line.is_circle and not line.is_tangent:
                low, high = line.points.min(axis=0), line.points.max(axis=0)
                centre = _in_plane(view, (low + high) / 2.0)
                radius = float((high - low).mean()) / 2.0
                yield Bore(axis, centre, radius, radius, 0.0, float(sheet.size[axis.value]))


def _in_plane(view: DrawnView, place: np.ndarray) -> tuple[float, float]:
    """A place of a view in the coordinates of the plane that it looks on."""
    frame = view.role.frame
    axes = (frame.right_axis, frame.up_axis)
    by_axis = {axis.value: sign * float(v) for (axis, sign), v in zip(axes, place, strict=True)}
    first, second = IN_PLANE[frame.look_axis[0]]
    return by_axis[first], by_axis[second]


_Pair = tuple[int, float, float, float, float]
"""Axis across, place across, radius, low and high along the bore, mm."""


def _by_lines(sheet: DrawnSheet, same: float) -> Iterator[Bore]:
    for axis in Axis:
        pairs = [pair for view in sheet.views for pair in _pairs(view, axis, sheet, same)]
        across = IN_PLANE[axis]
        sides = [[pair for pair in pairs if pair[0] == other] for other in across]
        for one, two in product(*sides):
            if np.abs(np.subtract(one[2:], two[2:])).max() <= same:
                yield Bore(axis, (one[1], two[1]), one[2], one[2], one[3], one[4])


def _pairs(view: DrawnView, axis: Axis, sheet: DrawnSheet, same: float) -> Iterator[_Pair]:
    """Pairs of straight lines along an axis that start and end together."""
    frame = view.role.frame
    shown = {frame.right_axis[0]: 0, frame.up_axis[0]: 1}
    if axis not in shown:
        return
    along = shown[axis]
    other, sign = (frame.right_axis, frame.up_axis)[1 - along]
    along_sign = (frame.right_axis, frame.up_axis)[along][1]
    straight = []
    for line in view.lines:
        if len(line.points) == 2 and abs(np.ptp(line.points[:, 1 - along])) <= sheet.tolerance:
            low, high = sorted((along_sign * line.points[:, along]).tolist())
            straight.append((sign * float(line.points[:, 1 - along].mean()), low, high))
    for one, two in combinations(straight, 2):
        gap = abs(one[0] - two[0])
        ends = np.abs(np.subtract(one[1:], two[1:])).max()
        if ends <= same < gap < _WIDEST * sheet.longest:
            yield other.value, (one[0] + two[0]) / 2.0, gap / 2.0, one[1], one[2]
