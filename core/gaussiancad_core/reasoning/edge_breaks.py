"""Chamfers that run all around a face, taken off a drawing as a designer puts them on: last.

Seen from above such a chamfer is a second outline, beside the sharp one by its width.  Seen from
beside it is a line at its height, with a short slanted stroke at either end.  Its corners are cones
and its sides slanted planes, most of which no view shows edge-on; without it the part is a simpler
one, whose edges are chamfered once it is solved.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product
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
        spans: of axes in its plane, mm from where to where the face reaches with sharp edges.
        contour: the sharp edges, mm in the plane of the axis; none where no view shows them, and
            the chamfer goes all around.
    """

    normal: Axis
    depth: float
    width: float
    height: float
    spans: Mapping[Axis, tuple[float, float]]
    contour: tuple[Points, ...] = ()


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
        box: (2, 2) mm around the outer outline in the plane of the view's axis.
    """

    role: Role
    outer: tuple[Curve, ...]
    inner: tuple[Curve, ...]
    width: float
    box: Points


@dataclass(frozen=True)
class _Profile:
    """A face with chamfers at both ends, seen from beside.

    Attributes:
        role: the view.
        normal: axis across the face.
        along: axis along it in the view.
        depth: mm of the face along the normal.
        side: mm of where the chamfers end at the sides.
        low, high: mm of the sharp ends of the face.
        width: mm that a chamfer takes away from it.
    """

    role: Role
    normal: Axis
    along: Axis
    depth: float
    side: float
    low: float
    high: float
    width: float

    def places(self, points: Points) -> Points:
        """(n, 2) along the face and along its normal, of points of the view."""
        return (points * np.array(role_plane(self.role).signs))[:, self._columns]

    def points(self, places: Points) -> Points:
        """(n, 2) points of the view again."""
        found = np.empty_like(places)
        found[:, self._columns] = places
        return found * np.array(role_plane(self.role).signs)

    @property
    def _columns(self) -> list[int]:
        axes = IN_PLANE[role_plane(self.role).normal]
        return [axes.index(self.along.value), axes.index(self.normal.value)]


def sharp_views(views: DrawnViews) -> SharpViews | None:
    """The views without chamfers that run all around faces; None where there are none."""
    near = max(2.0 * views.tolerance, 1e-6 * max(views.size))
    found: list[EdgeBreak] = []
    strokes = {role: list(own) for role, own in views.strokes.items()}
    profiles = [
        own for role, drawn in views.strokes.items() for own in _profiles(role, drawn, near)
    ]
    across = {own.normal for own in profiles}
    loops = [
        loop
        for role, drawn in views.strokes.items()
        if role_plane(role).normal in across
        for loop in _loops(role, drawn, near)
    ]
    for faces in _of_one_face(profiles, views.roles, near):
        first = faces[0]
        spans = {own.along: (own.low, own.high) for own in faces}
        around = [loop for loop in loops if _bounds(loop, first, spans, near)]
        height = first.side - first.depth
        contour = tuple(
            _in_plane(own.sample(first.width / 64.0), loop.role)
            for loop in around[:1]
            for own in loop.outer
        )
        found.append(EdgeBreak(first.normal, first.depth, first.width, height, spans, contour))
        for own in faces:
            changed = (_sharp(stroke, own, near) for stroke in strokes[own.role])
            strokes[own.role] = [stroke for stroke in changed if stroke is not None]
        for loop in around:
            for role in views.roles:
                if role_plane(role).normal is first.normal:
                    strokes[role] = _without_inner(strokes[role], role, loop, near)
    if not found:
        return None
    kept = {role: tuple(own) for role, own in strokes.items()}
    return SharpViews(replace(views, strokes=kept), tuple(found))


def _of_one_face(
    profiles: Sequence[_Profile], roles: Sequence[Role], near: float
) -> Iterator[list[_Profile]]:
    """Profiles that show one face, of every view that shows it from beside."""
    seen: list[_Profile] = []
    for own in profiles:
        if any(_same(own, other, near) for other in seen):
            continue
        beside = [role for role in roles if role_plane(role).normal is not own.normal]
        alike = [
            next((o for o in profiles if o.role is role and _same(own, o, near)), None)
            for role in beside
        ]
        seen.append(own)
        if None not in alike:
            yield alike


def _same(one: _Profile, other: _Profile, near: float) -> bool:
    """Whether two profiles are of one chamfer."""
    alike = abs(one.depth - other.depth) <= near and abs(one.side - other.side) <= near
    spans = one.along is not other.along or (
        abs(one.low - other.low) <= near and abs(one.high - other.high) <= near
    )
    return one.normal is other.normal and alike and spans


def _profiles(role: Role, strokes: Sequence[Curve], near: float) -> Iterator[_Profile]:
    """Faces with chamfers at both ends in one view, across either of its axes."""
    lines = [own for own in strokes if isinstance(own, Segment)]
    axes = [Axis(index) for index in IN_PLANE[role_plane(role).normal]]
    for along, normal in (axes, axes[::-1]):
        blank = _Profile(role, normal, along, 0.0, 0.0, 0.0, 0.0, 0.0)
        ends = [blank.places(np.array([own.start, own.end])) for own in lines]
        level = [own for own in ends if abs(own[1, 1] - own[0, 1]) <= near]
        slanted = [own for own in ends if min(np.ptp(own, axis=0)) > _LEAST * near]
        for face in level:
            low, high = face[np.argsort(face[:, 0])]
            depth = float(face[:, 1].mean())
            before, after = (_others(slanted, end, near) for end in (low, high))
            for one, other in product(before, after):
                width = float(low[0] - one[0])
                even = abs(one[1] - other[1]) <= near
                even &= abs(float(other[0] - high[0]) - width) <= 2.0 * near
                ratio = abs(float(one[1]) - depth) / max(width, 1e-9)
                small = 0.0 < width <= _NARROW * float(other[0] - one[0])
                corners = np.array([(one[0], depth), (other[0], depth)])
                cut = not any(_passes(own, corner, near) for own in ends for corner in corners)
                if even and small and cut and 1.0 / _SLOPE <= ratio <= _SLOPE:
                    side, start, end = float(one[1]), float(one[0]), float(other[0])
                    yield _Profile(role, normal, along, depth, side, start, end, width)


def _passes(line: Points, point: Points, near: float) -> bool:
    """Whether a line runs through a point."""
    way = line[1] - line[0]
    share = float(np.clip((point - line[0]) @ way / max(float(way @ way), 1e-12), 0.0, 1.0))
    return float(np.hypot(*(line[0] + share * way - point))) <= near


def _others(lines: Sequence[Points], point: Points, near: float) -> list[Points]:
    """The other ends of lines that have one at a point."""
    away = [np.hypot(*(line - point).T) for line in lines]
    found = zip(lines, away, strict=True)
    return [line[1 - int(np.argmin(own))] for line, own in found if own.min() <= near]


def _bounds(
    loop: _Loop, face: _Profile, spans: Mapping[Axis, tuple[float, float]], near: float
) -> bool:
    """Whether a double outline is that of a face."""
    plane = role_plane(loop.role)
    if plane.normal is not face.normal or abs(loop.width - face.width) > 2.0 * near:
        return False
    axes = IN_PLANE[plane.normal]
    return all(
        bool((np.abs(loop.box[:, axes.index(axis.value)] - span) <= 2.0 * near).all())
        for axis, span in spans.items()
    )


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
            points = _in_plane(points, role)
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


def _sharp(stroke: Curve, face: _Profile, near: float) -> Curve | None:
    """A stroke of the view as it is without the chamfers of a face; None where it is theirs."""
    if not isinstance(stroke, Segment):
        return stroke
    ends = face.places(np.array([stroke.start, stroke.end]))
    if not ((ends[:, 0] >= face.low - near) & (ends[:, 0] <= face.high + near)).all():
        return stroke
    at_side = np.abs(ends[:, 1] - face.side) <= near
    at_face = np.abs(ends[:, 1] - face.depth) <= near
    between = (at_side != at_face).all() and at_side.any() and at_face.any()
    if at_side.all() or (between and near < np.ptp(ends[:, 0]) <= face.width + near):
        return None
    moved = ends.copy()
    moved[at_side, 1] = face.depth
    if at_face.all():
        for sharp, way in ((face.low, 1.0), (face.high, -1.0)):
            moved[np.abs(ends[:, 0] - (sharp + way * face.width)) <= near, 0] = sharp
    if (moved == ends).all():
        return stroke
    start, end = face.points(moved).tolist()
    return replace(stroke, start=tuple(start), end=tuple(end))
