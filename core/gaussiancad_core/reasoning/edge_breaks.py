"""Chamfers that run all around a face, taken off a drawing as a designer puts them on: last.

Seen from above such a chamfer is a second outline, beside the sharp one by its width.  Seen from
beside it is a line at its height, with a short slanted stroke at either end.  Its corners are cones
and its sides slanted planes, most of which no view shows edge-on; without it the part is a simpler
one, whose edges are chamfered once it is solved.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import inf

import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.planes import IN_PLANE, role_plane
from gaussiancad_core.verification.lines import Curve
from gaussiancad_core.views import Arc, Segment

Points = npt.NDArray[np.float64]

_LEAST = 4.0
"""Width and height of a chamfer at least, in tolerances."""

_NARROW = 0.2
"""Width of a chamfer at most, as a share of the face's shorter side."""

_SLOPE = 6.0
"""Ratio of height and width of a chamfer at most, either way."""

_BOTH = 0.9
"""Share of a line of an outline along which the other one runs beside it at least."""

_MITRE = 2.0
"""Length of the edge in which two chamfers meet at most, in their width: the diagonal, and more at
sharp corners."""


@dataclass(frozen=True)
class EdgeBreak:
    """A chamfer around a face.

    Attributes:
        normal: axis across the face.
        depth: mm of the face along it.
        width: mm by which the chamfer takes away from the face.
        height: mm by which it takes away from the sides, with the sign of where these lie.
        contour: the sharp edges, mm in the plane of the axis.
    """

    normal: Axis
    depth: float
    width: float
    height: float
    contour: tuple[Points, ...]


@dataclass(frozen=True)
class SharpViews:
    """Views without the chamfers of some faces.

    Attributes:
        views: as they would be drawn without.
        breaks: the chamfers.
    """

    views: DrawnViews
    breaks: tuple[EdgeBreak, ...]


@dataclass(frozen=True)
class _Loop:
    """Two closed outlines, one beside the other.

    Attributes:
        role: the view.
        outer, inner: its strokes; the outer ones are sharp edges.
        width: mm between them.
        box: (2, 2) mm of the outer outline in the view's plane.
    """

    role: Role
    outer: tuple[Curve, ...]
    inner: tuple[Curve, ...]
    width: float
    box: Points


@dataclass(frozen=True)
class _Profile:
    """Where a view shows a chamfer from beside.

    Attributes:
        depth: mm of the face along the normal.
        side: mm of where the chamfer ends at the sides.
    """

    depth: float
    side: float


def sharp_views(views: DrawnViews) -> SharpViews | None:
    """The views without chamfers that run all around faces; None where there are none."""
    near = max(2.0 * views.tolerance, 1e-6 * max(views.size))
    found: list[EdgeBreak] = []
    strokes = {role: list(own) for role, own in views.strokes.items()}
    for role in views.roles:
        for loop in _loops(role, views.strokes[role], near):
            profiles = _profiles(loop, views, near)
            if not profiles:
                continue
            normal = role_plane(role).normal
            contour = tuple(_in_plane(own.sample(loop.width / 64.0), role) for own in loop.outer)
            for own in profiles:
                found.append(
                    EdgeBreak(normal, own.depth, loop.width, own.side - own.depth, contour)
                )
            for other in views.roles:
                if role_plane(other).normal is normal:
                    strokes[other] = _without_inner(strokes[other], other, loop, near)
                else:
                    strokes[other] = _sharpened(strokes[other], other, loop, profiles, near)
    if not found:
        return None
    kept = {role: tuple(own) for role, own in strokes.items()}
    return SharpViews(replace(views, strokes=kept), tuple(found))


def _in_plane(points: Points, role: Role) -> Points:
    """Points of a view in the plane of its axis."""
    return points * np.array(role_plane(role).signs)


def _loops(role: Role, strokes: Sequence[Curve], near: float) -> Iterator[_Loop]:
    """Pairs of closed outlines, one beside the other at one distance everywhere."""
    curves = [own for own in strokes if isinstance(own, Segment | Arc)]
    pairs = [
        (one, other, apart)
        for one, other in combinations(curves, 2)
        if (apart := _apart(one, other, near)) is not None
    ]
    for width in _widths([apart for _, _, apart in pairs], near):
        own = [(one, other) for one, other, apart in pairs if abs(apart - width) <= near]
        for chain in _closed(own, width, near):
            sides = [tuple(pair[k] for pair in chain) for k in (0, 1)]
            outer, inner = sorted(sides, key=lambda side: -sum(own.length for own in side))
            points = np.concatenate([own.sample(width) for own in outer])
            box = np.array([points.min(axis=0), points.max(axis=0)])
            if width <= _NARROW * float((box[1] - box[0]).min()):
                yield _Loop(role, outer, inner, width, box)


def _apart(one: Curve, other: Curve, near: float) -> float | None:
    """How far a curve runs beside another of its kind; None where it does not."""
    if isinstance(one, Segment) and isinstance(other, Segment):
        longer, shorter = sorted((one, other), key=lambda own: -own.length)
        if shorter.length <= near:
            return None
        start, way = np.array(longer.start), np.subtract(longer.end, longer.start) / longer.length
        off = np.array([shorter.start, shorter.end]) - start
        across = off @ np.array([-way[1], way[0]])
        along = np.sort(off @ way)
        shared = min(along[1], longer.length) - max(along[0], 0.0)
        apart = abs(float(across.mean()))
        beside = abs(float(np.ptp(across))) <= near and shared >= _BOTH * shorter.length
        return apart if beside and apart > _LEAST * near else None
    if isinstance(one, Arc) and isinstance(other, Arc):
        apart = abs(one.radius - other.radius)
        off = float(np.hypot(*np.subtract(one.centre, other.centre)))
        middle = [own.start_angle + own.sweep / 2.0 for own in (one, other)]
        turned = abs((middle[0] - middle[1] + np.pi) % (2.0 * np.pi) - np.pi)
        alike = turned <= 0.1 and min(one.sweep, other.sweep) >= _BOTH * max(one.sweep, other.sweep)
        return apart if off <= near and alike and apart > _LEAST * near else None
    return None


def _widths(distances: Sequence[float], near: float) -> list[float]:
    """Distances that several have, the narrowest first."""
    found: list[list[float]] = []
    for distance in sorted(distances):
        if found and distance - found[-1][-1] <= near:
            found[-1].append(distance)
        else:
            found.append([distance])
    return [float(np.median(own)) for own in found if len(own) >= 2]


_Pair = tuple[Curve, Curve]


def _closed(pairs: Sequence[_Pair], width: float, near: float) -> Iterator[list[_Pair]]:
    """Chains of pairs whose both sides go on in each other, all around.

    The sides of a chain are in one order: the first of each pair is of the one outline.
    """
    left = [pair for pair in pairs if not _is_whole(pair[0])]
    while left:
        chain = [left.pop()]
        start, end = _ends(chain[0], width)
        while (step := _next(left, end, width, near)) is not None:
            pair, index, end = step
            chain.append(pair)
            del left[index]
        if len(chain) > 1 and _meet(start, end, near):
            yield chain


def _is_whole(curve: Curve) -> bool:
    return isinstance(curve, Arc) and curve.sweep > 2.0 * np.pi - 1e-3


def _ends(pair: _Pair, width: float) -> tuple[Points, Points]:
    """(2, 2) of both ends of a pair the points of both sides."""
    one, other = (own.sample(inf)[[0, -1]] for own in pair)
    straight = np.hypot(*(one - other).T).sum()
    if np.hypot(*(one - other[::-1]).T).sum() < straight:
        other = other[::-1]
    return np.array([one[0], other[0]]), np.array([one[1], other[1]])


def _next(
    pairs: Sequence[_Pair], end: Points, width: float, near: float
) -> tuple[_Pair, int, Points] | None:
    """The pair that goes on where one ends, its number, and where that ends."""
    for index, pair in enumerate(pairs):
        for turned in (pair, pair[::-1]):
            ends = _ends(turned, width)
            for here, there in (ends, ends[::-1]):
                if _meet(end, here, near):
                    return turned, index, there
    return None


def _meet(one: Points, other: Points, near: float) -> bool:
    return bool((np.hypot(*(one - other).T) <= 2.0 * near).all())


def _profiles(loop: _Loop, views: DrawnViews, near: float) -> list[_Profile]:
    """Chamfers of the loop's width that views from beside show at both ends of the outline, and all
    of them alike."""
    normal = role_plane(loop.role).normal
    by_view = [
        _seen_beside(loop, role, views.strokes[role], near)
        for role in views.roles
        if role_plane(role).normal is not normal
    ]
    if not by_view:
        return []
    first, *rest = by_view
    return [own for own in first if all(any(_same(own, o, near) for o in more) for more in rest)]


def _same(one: _Profile, other: _Profile, near: float) -> bool:
    return abs(one.depth - other.depth) <= near and abs(one.side - other.side) <= near


def _seen_beside(loop: _Loop, role: Role, strokes: Sequence[Curve], near: float) -> list[_Profile]:
    """The profiles that one view shows at both ends of an outline."""
    frame = _Frame.of(loop, role)
    found: list[list[_Profile]] = [[], []]
    for stroke in strokes:
        if not isinstance(stroke, Segment):
            continue
        ends = frame.of_points(np.array([stroke.start, stroke.end]))
        for index, (sharp, sign) in enumerate(zip(frame.span, (1.0, -1.0), strict=True)):
            for face, side in (ends, ends[::-1]):
                across = abs(face[0] - (sharp + sign * loop.width)), abs(side[0] - sharp)
                height = abs(face[1] - side[1])
                ratio = height / loop.width
                if max(across) <= near and 1.0 / _SLOPE <= ratio <= _SLOPE:
                    found[index].append(_Profile(float(face[1]), float(side[1])))
    return [own for own in found[0] if any(_same(own, other, near) for other in found[1])]


@dataclass(frozen=True)
class _Frame:
    """A view from beside, in terms of a face.

    Attributes:
        signs: (2,) of the plane's coordinates in terms of the view's.
        along, depth: places of the view's coordinates along the face and along its normal.
        span: mm of the sharp outline along the face.
    """

    signs: tuple[int, int]
    along: int
    depth: int
    span: tuple[float, float]

    @classmethod
    def of(cls, loop: _Loop, role: Role) -> "_Frame":
        normal = role_plane(loop.role).normal
        axes = IN_PLANE[role_plane(role).normal]
        depth = axes.index(normal.value)
        axis = axes[1 - depth]
        place = IN_PLANE[normal].index(axis)
        span = np.sort(_in_plane(loop.box, loop.role)[:, place])
        return cls(role_plane(role).signs, 1 - depth, depth, (float(span[0]), float(span[1])))

    def of_points(self, points: Points) -> Points:
        """(n, 2) along the face and along its normal."""
        plane = points * np.array(self.signs)
        return plane[:, [self.along, self.depth]]

    def to_view(self, points: Points) -> Points:
        """(n, 2) in the view's plane again."""
        plane = np.empty_like(points)
        plane[:, [self.along, self.depth]] = points
        return plane * np.array(self.signs)


def _without_inner(strokes: Sequence[Curve], role: Role, loop: _Loop, near: float) -> list[Curve]:
    """A view along the normal without the inner outline, and the mitres between both."""
    step = loop.width / 8.0
    inner, outer = (
        _in_plane(np.concatenate([own.sample(step) for own in side]), loop.role)
        for side in (loop.inner, loop.outer)
    )
    kept: list[Curve] = []
    for stroke in strokes:
        points = _in_plane(stroke.sample(max(stroke.length / 16.0, near)), role)
        beside, sharp = _distances(points, inner), _distances(points, outer)
        is_inner = bool((beside <= near + 0.5 * step).all())
        ends = min(beside[0] + sharp[-1], beside[-1] + sharp[0])
        is_mitre = stroke.length <= _MITRE * loop.width and ends <= 2.0 * (near + step)
        if not is_inner and not (is_mitre and isinstance(stroke, Segment)):
            kept.append(stroke)
    return kept


def _distances(points: Points, others: Points) -> Points:
    from scipy.spatial import cKDTree

    return cKDTree(others).query(points)[0]


def _sharpened(
    strokes: Sequence[Curve],
    role: Role,
    loop: _Loop,
    profiles: Sequence[_Profile],
    near: float,
) -> list[Curve]:
    """A view from beside with sharp corners instead of chamfers."""
    frame = _Frame.of(loop, role)
    kept = list(strokes)
    for own in profiles:
        kept = [
            changed
            for stroke in kept
            if (changed := _sharp(stroke, frame, loop.width, own, near)) is not None
        ]
    return kept


def _sharp(
    stroke: Curve, frame: _Frame, width: float, profile: _Profile, near: float
) -> Curve | None:
    """A stroke as it is without a chamfer; None where it is one of the chamfer's own."""
    if not isinstance(stroke, Segment):
        return stroke
    ends = frame.of_points(np.array([stroke.start, stroke.end]))
    low, high = frame.span
    if not ((ends[:, 0] >= low - near) & (ends[:, 0] <= high + near)).all():
        return stroke
    at_side = np.abs(ends[:, 1] - profile.side) <= near
    at_face = np.abs(ends[:, 1] - profile.depth) <= near
    if at_side.all():
        return None
    if (at_side | at_face).all() and not at_face.all() and np.ptp(ends[:, 0]) > near:
        return None if np.ptp(ends[:, 0]) <= width + near else stroke
    moved = ends.copy()
    moved[at_side, 1] = profile.depth
    if at_face.all():
        for sharp, sign in ((low, 1.0), (high, -1.0)):
            moved[np.abs(ends[:, 0] - (sharp + sign * width)) <= near, 0] = sharp
    if (moved == ends).all():
        return stroke
    start, end = frame.to_view(moved).tolist()
    return replace(stroke, start=tuple(start), end=tuple(end))
