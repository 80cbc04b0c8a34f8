"""Where the surfaces of a labelled space are the surface of the part.

A patch is a rectangle of a carrier's surface: a stretch of its curve times a range of depth.  It
holds every place where the labels on both sides differ, and is cut to them later.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise

from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.tolerances import ASIDE, SHORTEST
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, axis_line, meetings
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.solid.labelled_cells import LabelledComplex

Rectangle = tuple[float, float, float, float]
"""Low and high of the first, low and high of the second parameter."""

NARROW = 0.1
"""Units of depth that a difference usually has at least: beside a plane that touches a cylinder, a
narrow strip of the cylinder is seen."""

_LOOKS = (0.03, 0.5, 0.97)
"""Shares of a piece at which the columns beside it are compared."""

_TOUCHING = 1e-4


@dataclass(frozen=True)
class PlanePatch:
    """A rectangle of a plane at right angles to an axis.

    Attributes:
        axis: the plane's normal.
        value: its coordinate.
        rectangle: in the plane's two coordinates.
    """

    axis: Axis
    value: float
    rectangle: Rectangle


@dataclass(frozen=True)
class SweptPatch:
    """A rectangle of the surface that a slanted line or a circle sweeps along an axis.

    Attributes:
        axis: of the sweep.
        curve: in the projection plane of that axis.
        rectangle: parameters of the curve, and depths; on a circle the first one may be negative.
    """

    axis: Axis
    curve: LineOrCircle
    rectangle: Rectangle


Patch = PlanePatch | SweptPatch


def find_patches(space: LabelledComplex, narrow: float = NARROW) -> list[Patch]:
    """Patches that cover the part's surface but for that of the bodies.

    Args:
        space: in units.
        narrow: units of depth that a difference of labels has at least.
    """
    flat: dict[tuple[Axis, float], list[Rectangle]] = defaultdict(list)
    exact: dict[tuple[Axis, float], float] = {}
    patches: list[Patch] = []
    for normal, plane in space.space.planes.items():
        axes = IN_PLANE[normal]
        swept: dict[int, list[Rectangle]] = defaultdict(list)
        for index, low, high in plane.stretches:
            curve = plane.carriers[index].curve
            for rectangle in _differences(space, normal, curve, (low, high), narrow):
                if curve.axis is None:
                    swept[index].append(rectangle)
                    continue
                start, end, near, far = rectangle
                along = 1 - curve.axis
                ends = sorted((curve.at(start)[along], curve.at(end)[along]))
                intervals = {axes[along]: (ends[0], ends[1]), normal.value: (near, far)}
                first, second = IN_PLANE[Axis(axes[curve.axis])]
                value = curve.point[curve.axis]
                key = Axis(axes[curve.axis]), round(value, 6)
                exact.setdefault(key, value)
                flat[key].append((*intervals[first], *intervals[second]))
        for index, rectangles in swept.items():
            curve = plane.carriers[index].curve
            gap = 2.0 * SHORTEST / curve.speed
            # Only slants and circles are swept.
            closed = isinstance(curve, Circle)
            items = _around(united(rectangles, gap), gap) if closed else united(rectangles, gap)
            patches += [SweptPatch(normal, curve, rectangle) for rectangle in items]
    for key, rectangles in flat.items():
        patches += [PlanePatch(key[0], exact[key], r) for r in united(rectangles)]
    return patches


def _differences(
    space: LabelledComplex,
    normal: Axis,
    curve: LineOrCircle,
    stretch: tuple[float, float],
    narrow: float,
) -> Iterator[Rectangle]:
    """Rectangles of a stretch's surface with different labels on its sides."""
    depths = space.space.values[normal]
    for low, high in _pieces(space, normal, curve, stretch):
        found: list[tuple[float, float]] = []
        for share in _LOOKS:
            at = low + share * (high - low)
            (a, b), (da, db) = curve.at(at), curve.normal(at)
            one, other = (
                space.stretches(normal, a + way * da, b + way * db) for way in (-ASIDE, ASIDE)
            )
            found += _unlike(one, other, narrow)
        for near, far in found:
            # Along the piece the range moves, but never over a value of a corner.
            lowest = max((d for d in depths if d <= near), default=near)
            highest = min((d for d in depths if d >= far), default=far)
            yield low, high, _nearest(depths, near, lowest), _nearest(depths, far, highest)


def _nearest(values: list[float], at: float, otherwise: float) -> float:
    """The value that a number is but for the offset of the columns beside a line."""
    nearest = min(values, key=lambda value: abs(value - at), default=otherwise)
    return nearest if abs(nearest - at) <= SHORTEST else otherwise


def _pieces(
    space: LabelledComplex, normal: Axis, curve: LineOrCircle, stretch: tuple[float, float]
) -> Iterator[tuple[float, float]]:
    cuts = {*stretch}
    for coordinate, index in enumerate(IN_PLANE[normal]):
        for value in space.space.values[Axis(index)]:
            line = axis_line(coordinate, value)
            if line != curve:
                cuts.update(curve.parameter(point) for point in meetings(curve, line))
    inside = sorted(t for t in cuts if stretch[0] - 1e-9 <= t <= stretch[1] + 1e-9)
    short = SHORTEST / curve.speed
    for place, (low, high) in enumerate(pairwise(inside)):
        if high - low < short:
            continue
        # Pieces too short to be looked at go with both of their neighbours.
        first, last = place, place + 1
        while first > 0 and inside[first] - inside[first - 1] < short:
            first -= 1
        while last + 1 < len(inside) and inside[last + 1] - inside[last] < short:
            last += 1
        yield inside[first], inside[last]


def _unlike(
    one: list[tuple[float, float]], other: list[tuple[float, float]], narrow: float
) -> list[tuple[float, float]]:
    """Ranges that only one of two lists of ranges covers."""
    ends = sorted({end for stretch in (*one, *other) for end in stretch})
    found = []
    for low, high in pairwise(ends):
        if high - low < narrow:
            continue
        middle = (low + high) / 2.0
        if _covers(one, middle) != _covers(other, middle):
            found.append((low, high))
    return found


def _covers(stretches: list[tuple[float, float]], at: float) -> bool:
    return any(low < at < high for low, high in stretches)


def united(rectangles: Iterable[Rectangle], gap: float = 2.0 * SHORTEST) -> list[Rectangle]:
    """Rectangles that touch as their bounding rectangles, until none touch.

    Args:
        rectangles: of one surface.
        gap: of the first parameter that is closed: pieces too short to be looked at leave it.
    """
    current = list(dict.fromkeys(rectangles))
    while True:
        grown: list[Rectangle] = []
        for rectangle in current:
            for place, other in enumerate(grown):
                if _touch(rectangle, other, gap):
                    grown[place] = (
                        min(rectangle[0], other[0]),
                        max(rectangle[1], other[1]),
                        min(rectangle[2], other[2]),
                        max(rectangle[3], other[3]),
                    )
                    break
            else:
                grown.append(rectangle)
        if len(grown) == len(current):
            return grown
        current = grown


def _around(rectangles: list[Rectangle], gap: float) -> list[Rectangle]:
    """Rectangles of a circle, with those as one that touch where its parameter begins again.

    An intersection that ends at the border of two patches may be found in one of them only.
    """
    current = list(rectangles)
    for last in rectangles:
        before = (last[0] - FULL_TURN, last[1] - FULL_TURN, *last[2:])
        others = [
            r for r in current if r is not last and before[1] >= -gap and _touch(r, before, gap)
        ]
        if last in current and others:
            first = min(others)
            current = [r for r in current if r not in (first, last)]
            ends = min(first[2], last[2]), max(first[3], last[3])
            current.append((before[0], first[1], *ends))
    return current


def _touch(one: Rectangle, other: Rectangle, gap: float) -> bool:
    return (
        one[0] <= other[1] + gap
        and other[0] <= one[1] + gap
        and one[2] <= other[3] + _TOUCHING
        and other[2] <= one[3] + _TOUCHING
    )
