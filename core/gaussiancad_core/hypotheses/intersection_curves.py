"""Strokes that follow the curve in which two surfaces meet, told from the traces of surfaces.

In a picture a short curve of intersection looks like a straight line or an arc.  Taken for the
trace of a plane or a cylinder it contradicts the other views.  Where two surfaces that other views
show meet on every line of sight along a stroke, the stroke may be their curve.
"""

from collections.abc import Container, Sequence
from dataclasses import replace
from itertools import pairwise
from math import inf, pi
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from gaussiancad_core.cells.cell_complex import BODY
from gaussiancad_core.cells.surfaces_of_revolution import SurfaceOfRevolution
from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.coordinates.curve_ends import with_common_ends
from gaussiancad_core.coordinates.stroke_finder import LINKS
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.tolerances import COMPUTED, SAME_READ, TELLING
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, axis_line, meetings
from gaussiancad_core.hypotheses.revolution_candidates import find_bodies
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.projection_planes import IN_PLANE, plane_points, role_plane
from gaussiancad_core.model.views import Arc, Segment
from gaussiancad_core.sheet.votes import MOST

_LOOKS = 5
"""Places across a stroke, within reach, at which lines of sight are looked along; twice as many,
two and a half times as far, once it is known along which curve."""

_SAMPLES = 9
"""Points of a stroke at which it is compared."""

_ROUND = 1.01 * pi
"""Sweep from which an arc stands for itself: no curve follows a circle that far by chance."""

_STRAIGHT = 0.1
"""Tolerances by which the curve that a straight stroke follows bends, at least: what is straight
may be an edge of a face that is edge-on."""

_STEPS = 12
"""Steps in which a point is led onto the curve."""

Points = npt.NDArray[np.float64]
"""(n, 2) in units of a plane."""

_Key = tuple[int, int, int]
"""A surface, and which of its meetings with a line of sight."""


class _Surface(NamedTuple):
    """A plane or cylinder that another plane shows edge-on.

    Attributes:
        coordinate: of the view, that the other plane shows as well.
        place: of that coordinate in the other plane.
        key: (normal of the plane, carrier).
        curve, drawn: there, and the stretches of it that are drawn.
        reach: (low, high) of the coordinate, where it is drawn.
    """

    coordinate: int
    place: int
    key: tuple[int, int]
    curve: LineOrCircle
    drawn: list[tuple[float, float]]
    reach: tuple[float, float]


def with_followed_curves(views: DrawnViews, carriers: PartCarriers) -> DrawnViews | None:
    """The views with the curves in which surfaces meet instead of strokes that follow them.

    Args:
        views: as they were read.
        carriers: of the views.

    Returns:
        None if no stroke follows such a curve.
    """
    bodies = find_bodies(carriers, lone=True)
    shown = frozenset(find_bodies(carriers))
    strokes = {}
    for role, this_curves in views.strokes.items():
        sights = _Sights(role, carriers, bodies, shown)
        curves = [sights.curve(stroke) or stroke for stroke in this_curves]
        strokes[role] = tuple(with_common_ends(this_curves, curves, views.tolerance))
    if strokes == dict(views.strokes):
        return None
    return replace(views, strokes=strokes)


class _Sights:
    """Lines of sight of a view, and what they meet."""

    def __init__(
        self,
        role: Role,
        carriers: PartCarriers,
        bodies: Sequence[SurfaceOfRevolution],
        shown: Container[SurfaceOfRevolution],
    ) -> None:
        self._role = role
        self._normal = role_plane(role).normal
        self._scale = carriers.scale
        self._tolerance = carriers.tolerance
        self._bodies = bodies
        self._shown = [body in shown for body in bodies]
        self._rims = [[rim for rim, _ in body.rims(self._normal)] for body in bodies]
        reach = SAME_READ * carriers.tolerance
        self._offsets = np.linspace(-reach, reach, _LOOKS)
        self._surfaces = [
            _Surface(
                coordinate,
                place,
                (axis.value, number),
                carrier.curve,
                carrier.drawn(self._tolerance),
                _reach(carrier.curve, carrier.drawn(self._tolerance), place),
            )
            for coordinate, index in enumerate(IN_PLANE[self._normal])
            for axis, plane in carriers.planes.items()
            if axis is not self._normal and index in IN_PLANE[axis]
            for place in [IN_PLANE[axis].index(index)]
            for number, carrier in enumerate(plane.carriers)
            if carrier.curve.axis != place
        ]

        self._levels = [
            [
                carrier.curve.point[place]
                for axis, plane in carriers.planes.items()
                if axis is not self._normal and index in IN_PLANE[axis]
                for place in [IN_PLANE[axis].index(index)]
                for carrier in plane.carriers
                if carrier.curve.axis == place and carrier.drawn()
            ]
            for index in IN_PLANE[self._normal]
        ]
        # Planes meet in straight lines.
        curved = any(isinstance(surface.curve, Circle) for surface in self._surfaces)
        self._any_round = curved or bool(bodies)

    def curve(self, stroke: DrawnStroke) -> Polyline | None:
        """The curve that a stroke follows, if there is one that it may stand for."""
        if not self._may_follow(stroke):
            return None
        points = self._points(stroke, _SAMPLES)
        ks = {k for k, rims in enumerate(self._rims) if self._runs_on(points, rims)}
        if any(self._shown[body] for body in ks):
            return None
        pair = self._pair(points, ks)
        if pair is None:
            return None
        points = self._points(stroke, LINKS)
        led = self._led(points, pair)
        if len(led) < MOST * len(points):
            return None
        if isinstance(stroke, Segment) and _bend(led) < _STRAIGHT * self._tolerance:
            return None
        curve = led * np.array(role_plane(self._role).signs) / self._scale
        return Polyline(tuple(map(tuple, curve.tolist())), stroke.linetype)

    def _may_follow(self, stroke: DrawnStroke) -> bool:
        """Whether a stroke is none that tells its surface by itself."""
        if stroke.length * self._scale < TELLING * self._tolerance:
            return False
        if isinstance(stroke, Arc):
            return stroke.sweep <= _ROUND and not self._is_outlined(stroke)
        if isinstance(stroke, Segment):
            if not self._any_round:
                return False
            rise = np.abs(np.subtract(stroke.end, stroke.start)).min() * self._scale
            return bool(rise > self._tolerance)
        return True

    def _is_outlined(self, arc: Arc) -> bool:
        """Whether another view draws a line where an arc turns back: its cylinder's outline."""
        for levels, values in zip(self._levels, self._points(arc, LINKS).T, strict=True):
            for turn in (float(values.min()), float(values.max())):
                inside = abs(turn - values[[0, -1]]).min() > self._tolerance
                if inside and any(abs(turn - level) <= self._tolerance for level in levels):
                    return True
        return False

    def _points(self, stroke: DrawnStroke, count: int) -> Points:
        points = stroke.sample(stroke.length / count)
        return plane_points(points, self._role, self._scale)

    def _runs_on(self, points: Points, rims: Sequence[LineOrCircle]) -> bool:
        """Whether points lie on one of a body's outlines or circles."""
        return any(
            all(rim.distance((float(a), float(b))) <= self._tolerance for a, b in points)
            for rim in rims
        )

    def _pair(self, points: Points, container: Container[int]) -> tuple[_Key, _Key] | None:
        """The two surfaces that meet along a stroke, the nearest ones.

        Args:
            points: of the stroke.
            container: bodies that the stroke may be an outline of.
        """
        offsets = self._offsets
        found: dict[tuple[_Key, _Key], list[float]] = {}
        for point, way in zip(points, _across(points), strict=True):
            looks = [self._met(*(point + offset * way)) for offset in offsets]
            met = set().union(*looks)
            keys = sorted(key for key in met if not (key[0] == BODY and key[1] in container))
            if len(keys) < 2:
                continue
            depths = np.array([[look.get(key, np.nan) for look in looks] for key in keys])
            gaps = depths[:, None] - depths[None]
            crossed = (gaps[..., :-1] * gaps[..., 1:] <= 0.0) & (gaps[..., :-1] != gaps[..., 1:])
            for one, other in zip(*np.nonzero(crossed.any(axis=2)), strict=True):
                if one < other and _may_meet(keys[one], keys[other]):
                    k = int(np.argmax(crossed[one, other]))
                    left, right = gaps[one, other, k : k + 2]
                    share = left / (left - right)
                    off = offsets[k] + share * (offsets[k + 1] - offsets[k])
                    found.setdefault((keys[one], keys[other]), []).append(abs(off))
        whole = {p: items for p, items in found.items() if len(items) >= MOST * len(points)}
        return min(whole, key=lambda p: float(np.mean(whole[p])), default=None)

    def _led(self, points: Points, pair: tuple[_Key, _Key]) -> Points:
        """The points of the curve beside those of a stroke, as far as both surfaces reach.

        Readers go on to the next line.
        """
        ways = _across(points)
        led = [self._on_curve_near(*at, pair) for at in zip(points, ways, strict=True)]
        found = [number for number, point in enumerate(led) if point is not None]
        if not found:
            return points[:0]
        curve = [led[number] for number in found]
        for end, out, place in ((found[0], -1, 0), (found[-1], 1, len(curve) + 1)):
            if 0 <= end + out < len(points):
                last = self._last(points[end], points[end + out], ways[end], pair)
                if last is not None:
                    curve.insert(place, last)
        return np.array(curve)

    def _last(
        self, inside: Points, outside: Points, way: Points, pair: tuple[_Key, _Key]
    ) -> Points | None:
        """The last point of the curve between a place that has one and a place that has none."""
        last = None
        for _ in range(_STEPS):
            middle = (inside + outside) / 2.0
            point = self._on_curve_near(middle, way, pair)
            if point is None:
                outside = middle
            else:
                inside, last = middle, point
        return last

    def _on_curve_near(self, point: Points, way: Points, pair: tuple[_Key, _Key]) -> Points | None:
        """The point of the curve nearest to one of a stroke, across it; None if there is none."""
        # An arc that was fitted to the curve leaves it most at its ends.
        step = self._offsets[1] - self._offsets[0]
        offsets = step * np.arange(-_LOOKS, _LOOKS + 1)
        gaps = [self._gap(point + off * way, pair) for off in offsets]
        roots = [
            self._root(point, way, pair, (low, before), (high, after))
            for (low, before), (high, after) in pairwise(zip(offsets, gaps, strict=True))
            if before is not None
            and after is not None
            and before * after <= 0.0
            and before != after
        ]
        return point + min(roots, key=abs) * way if roots else None

    def _root(
        self,
        point: Points,
        way: Points,
        pair: tuple[_Key, _Key],
        low: tuple[float, float],
        high: tuple[float, float],
    ) -> float:
        """How far across a stroke its curve is, between two places and the gaps there."""
        middle = (low[0] + high[0]) / 2.0
        for _ in range(_STEPS):
            middle = low[0] + low[1] / (low[1] - high[1]) * (high[0] - low[0])
            gap = self._gap(point + middle * way, pair)
            if not gap:
                break
            if gap * low[1] > 0.0:
                low = middle, gap
            else:
                high = middle, gap
        return middle

    def _gap(self, point: Points, pair: tuple[_Key, _Key]) -> float | None:
        met = self._met(float(point[0]), float(point[1]))
        one, other = (met.get(key) for key in pair)
        return None if one is None or other is None else one - other

    def _met(self, a: float, b: float) -> dict[_Key, float]:
        """Depths at which a line of sight meets surfaces."""
        found: dict[_Key, float] = {}
        at = a, b
        for surface in self._surfaces:
            # Most surfaces are somewhere else.
            if not surface.reach[0] <= at[surface.coordinate] <= surface.reach[1]:
                continue
            curve, place = surface.curve, surface.place
            hits = sorted(
                point[1 - place]
                for point in meetings(curve, axis_line(place, at[surface.coordinate]))
                if _is_on(curve, point, surface.drawn)
            )
            for depth in hits:
                upper = isinstance(curve, Circle) and depth > curve.centre[1 - place]
                found[(*surface.key, int(upper))] = depth
        for index, body in enumerate(self._bodies):
            hits = sorted(depth for depth, _ in body.crossings(self._normal, a, b))
            for number, depth in enumerate(hits):
                found[(BODY, index, number)] = depth
        return found


def _reach(
    curve: LineOrCircle, drawn: Sequence[tuple[float, float]], place: int
) -> tuple[float, float]:
    """The least and the most of a coordinate that stretches of a curve have."""
    if isinstance(curve, Circle):
        return curve.centre[place] - curve.radius, curve.centre[place] + curve.radius
    ends = [curve.at(at)[place] for stretch in drawn for at in stretch]
    return min(ends, default=inf) - COMPUTED, max(ends, default=-inf) + COMPUTED


def _is_on(curve: LineOrCircle, point: tuple[float, float], drawn: Sequence[tuple]) -> bool:
    at = curve.parameter(point)
    return any(low <= at <= high for low, high in drawn)


def _may_meet(one: _Key, other: _Key) -> bool:
    """Whether two surfaces meet in a curve: those of one plane meet in lines across it."""
    return one[:2] != other[:2] and (one[0] != other[0] or one[0] == BODY)


def _across(points: Points) -> Points:
    """Unit normals of a stroke at its points."""
    ways = np.gradient(points, axis=0)
    ways /= np.maximum(np.hypot(*ways.T), 1e-12)[:, None]
    return np.stack([-ways[:, 1], ways[:, 0]], axis=1)


def _bend(points: Points) -> float:
    """How far points lie beside the line through the first and the last, at most."""
    way = points[-1] - points[0]
    off = points - points[0]
    return float(np.abs(off[:, 0] * way[1] - off[:, 1] * way[0]).max() / np.hypot(*way))
