"""Arrowheads among the strokes of a file: where dimension lines and leaders end (ISO 129-1).

A head is an isosceles triangle, filled or drawn of lines, longer than it is wide; a filled one may
have a corner or a notch at its back.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.files.vectors import StrokeKind, VectorStroke
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.near_points import near_lists

_ONE_PLACE = 1.0
"""px within which the corners of heads are at one place."""

_SHORTEST, _LONGEST = 4.0, 80.0
"""px of a head along its axis: 0.5 to 10 mm at 200 dpi."""

_WIDEST = 0.8
"""Width of a head over the length of its sides at most."""

_NARROWEST = 0.08
"""The same at least."""

_EVEN, _ROUNDED = 0.04, 0.75
"""Share, and px, by which its two sides may differ."""

_BESIDE = 0.06
"""Share of a filled shape's size by which its points may lie beside the triangle's corners."""

_CROWDED = 24
"""Short lines that meet in one place at most: more are no arrowhead."""

_AROUND = 1.1
"""Distance of a head's corners from its tip at most, in its length."""

_ANGLES = np.radians([0.0, 22.5, 45.0, 67.5])

_TURNS = np.array([[[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]] for a in _ANGLES])
"""(4, 2, 2) by which points are turned before boxes are laid around them."""

Point = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Head:
    """An arrowhead.

    Attributes:
        tip: px, where it points.
        way: (2,) of length 1, from the middle of its base to the tip.
        length: px along its axis.
    """

    tip: tuple[float, float]
    way: tuple[float, float]
    length: float


def arrowheads(strokes: Iterable[VectorStroke]) -> tuple[Head, ...]:
    """The heads of a drawing, each once."""
    every = list(strokes)
    found: list[Head] = []
    cells: defaultdict[tuple[int, int], list[Head]] = defaultdict(list)
    for corners in (*_filled(every), *_drawn(every)):
        head = _head(corners)
        if head is None:
            continue
        x, y = round(head.tip[0] / _ONE_PLACE), round(head.tip[1] / _ONE_PLACE)
        near = [
            this_head
            for dx in (-1, 0, 1)
            for dy in (-1, 0, 1)
            for this_head in cells[x + dx, y + dy]
        ]
        if not any(np.dot(this_head.way, head.way) > 0.9 for this_head in near):
            cells[x, y].append(head)
            found.append(head)
    return tuple(found)


def without_heads(strokes: Sequence[VectorStroke], heads: Sequence[Head]) -> list[VectorStroke]:
    """The strokes but for the lines that heads are drawn of."""
    if not heads:
        return list(strokes)
    reach = _AROUND * max(head.length for head in heads)
    short = [
        (number, stroke.curve)
        for number, stroke in enumerate(strokes)
        if isinstance(stroke.curve, LineSegment) and stroke.curve.length <= reach
    ]
    starts = np.array([curve.start for _, curve in short]).reshape(-1, 2)
    near = near_lists(starts, np.array([head.tip for head in heads]), reach)
    of_heads = {
        number
        for (number, curve), around in zip(short, near, strict=True)
        if any(_is_within(curve, heads[index]) for index in around)
    }
    return [stroke for number, stroke in enumerate(strokes) if number not in of_heads]


def _is_within(line: LineSegment, head: Head) -> bool:
    far = max(np.hypot(*np.subtract(end, head.tip)) for end in (line.start, line.end))
    return bool(far <= _AROUND * head.length)


def _filled(strokes: Iterable[VectorStroke]) -> Iterator[Point]:
    """The corners of filled shapes that are triangles."""
    for stroke in strokes:
        if stroke.kind is not StrokeKind.FILL or not isinstance(stroke.curve, Chain):
            continue
        x0, y0, x1, y1 = stroke.curve.box
        size = max(x1 - x0, y1 - y0)
        # Most of what is filled are letters: no place counts twice among their points.
        points = np.array(list(dict.fromkeys(stroke.curve.points)))
        if len(points) < 3 or not _SHORTEST <= size <= _LONGEST:
            continue
        if len(points) == 4 and (corners := _of_kite(points)) is not None:
            yield corners
            continue
        if not _may_be_triangle(points, _BESIDE * size):
            continue
        hull = shapely.get_coordinates(shapely.convex_hull(shapely.MultiPoint(points)))[:-1]
        if len(hull) < 3:
            continue
        corners = _three(hull, _BESIDE * size)
        if corners is not None:
            yield corners


def _of_kite(points: Point) -> Point | None:
    """The tip, and the corners at both sides, of four that are alike to both sides of an axis."""
    sides = np.hypot(*(np.roll(points, -1, axis=0) - points).T)
    for tip in range(4):
        front, back = sides[[tip, tip - 1]], sides[[(tip + 1) % 4, tip - 2]]
        uneven = max(float(np.ptp(front)), float(np.ptp(back)))
        if uneven <= max(_EVEN * float(front.max()), _ROUNDED) and front.min() > back.max():
            return points[[tip, (tip + 1) % 4, tip - 1]]
    return None


def _may_be_triangle(points: Point, near: float) -> bool:
    """Whether the outline of some points may have three corners, as far as boxes around it tell.

    A corner of a triangle lies on two sides of any box around it: in a corner of the box, unless
    two opposite sides are as one.

    Args:
        points: (n, 2) px.
        near: px by which points of the outline may lie beside its corners.
    """
    turned = points @ _TURNS
    low, high = turned.min(axis=1, keepdims=True), turned.max(axis=1, keepdims=True)
    reach = (1.0 + 1e-6) * near
    in_corner = ((turned - low <= reach) | (high - turned <= reach)).all(axis=2).any(axis=1)
    narrow = (high - low).min(axis=(1, 2)) <= 2.0 * reach
    return bool((in_corner | narrow).all())


def _three(hull: Point, near: float) -> Point | None:
    """The three corners of a convex outline, if it has no more."""
    apart = np.hypot(*(hull[:, None] - hull[None]).transpose(2, 0, 1))
    low, high = hull[list(np.unravel_index(int(np.argmax(apart)), apart.shape))]
    along = (high - low) / np.hypot(*(high - low))
    off = np.abs((hull - low) @ np.array([-along[1], along[0]]))
    third = hull[int(np.argmax(off))]
    corners = np.array([low, high, third])
    left = np.min(np.hypot(*(hull[:, None] - corners[None]).transpose(2, 0, 1)), axis=1)
    return corners if left.max() <= near else None


def _drawn(strokes: Iterable[VectorStroke]) -> Iterator[Point]:
    """The corners of triangles of short lines."""
    ends: defaultdict[tuple[int, int], set[tuple[int, int]]] = defaultdict(set)
    places: dict[tuple[int, int], Point] = {}
    for stroke in strokes:
        curve = stroke.curve
        if not isinstance(curve, LineSegment) or not 0.5 <= curve.length <= 1.1 * _LONGEST:
            continue
        keys = []
        for end in (curve.start, curve.end):
            key = round(end[0] / _ONE_PLACE), round(end[1] / _ONE_PLACE)
            places.setdefault(key, np.array(end))
            keys.append(key)
        if keys[0] != keys[1]:
            ends[keys[0]].add(keys[1])
            ends[keys[1]].add(keys[0])
    for tip, others in ends.items():
        if len(others) <= _CROWDED:
            for one, two in combinations(sorted(others), 2):
                if two in ends[one]:
                    yield np.array([places[tip], places[one], places[two]])


def _head(corners: Point) -> Head | None:
    """The head with these corners, if they are those of one."""
    sides = [float(np.hypot(*(corners[i - 1] - corners[i - 2]))) for i in range(3)]
    at = int(np.argmin(sides))
    tip, one, two = corners[at], corners[at - 1], corners[at - 2]
    legs = [float(np.hypot(*(item - tip))) for item in (one, two)]
    long = max(legs)
    if not long or abs(legs[0] - legs[1]) > max(_EVEN * long, _ROUNDED):
        return None
    base = (one + two) / 2.0
    length = float(np.hypot(*(tip - base)))
    if not _NARROWEST * long <= sides[at] <= _WIDEST * long:
        return None
    if not _SHORTEST <= length <= _LONGEST:
        return None
    way = (tip - base) / length
    return Head((float(tip[0]), float(tip[1])), (float(way[0]), float(way[1])), length)
