"""The outline of a part in a projection plane, along the lines that are drawn there.

An outline runs along the drawn lines where they close around what the masks cover; where they do
not, it is the masks' contour as a polygon.  Coordinates are in the units of
:mod:`gaussiancad_core.model.projection_planes`.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.cells.arrangement import OUTSIDE, Arrangement
from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval, merged_intervals
from gaussiancad_core.evidence.mask_outlines import (
    PlaneField,
    padded_mask,
    plane_field,
    signed_distance,
)
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import ASIDE, SHORTEST
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, line_through
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, UNITS, role_plane
from gaussiancad_core.model.views import Linetype, View, ViewSet

_SAMPLES = 120
"""Points along the longest side of a plane at which outlines and masks are compared."""

_CLEAR_PX = 2.0
"""px from a mask's outline from which a point is inside or outside for certain."""

_AGREEING = 0.998
"""Share of those points on which lines must agree with a mask for them to be its outline."""

_CONTOUR_PX = 0.75
"""px by which a polygon may miss a mask's contour."""

_MOST_SIDES = 80
"""Sides of all polygons of a plane; more are made coarser."""

_COARSER = 1.4
_COARSEST_PX = 16.0
"""Steps in which they are, and where that ends."""

_SNAP_PX = 1.5
"""px within which a polygon's corner has the coordinate of a line."""

_ON_CURVE = 1e-4
"""Units within which a corner is on a curve."""

Points = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Outline:
    """The outline of a plane.

    Attributes:
        arrangement: of its lines alone.
        material: the regions that the part covers, ascending.
    """

    arrangement: Arrangement
    material: tuple[int, ...]


class _Shadow:
    """Where the part covers a projection plane, by the masks of all of its views and the box.

    Args:
        views: those that look along the plane's normal.
        size: (3,) of the box in mm.
        scale: units per mm.
    """

    def __init__(
        self, views: Sequence[View], size: tuple[float, float, float], scale: float
    ) -> None:
        self._fields: list[tuple[PlaneField, Points]] = []
        axes = IN_PLANE[role_plane(views[0].role).normal]
        self._extents = np.array([size[index] * scale for index in axes])
        for view in views:
            mask = padded_mask(view, size, True)
            field = plane_field(signed_distance(mask, view.mm_per_pixel), view)
            signs = np.array(role_plane(view.role).signs, dtype=np.float64)
            self._fields.append((field, signs / scale))
        self.pixel = max(view.mm_per_pixel for view in views) * scale
        self._scale = scale

    def depths(self, points: Points) -> Points:
        """(n, 2) units -> (n,) units inside of all outlines; negative outside."""
        found = [field.at(points * factors) for field, factors in self._fields]
        within = np.minimum(points, self._extents - points).min(axis=1)
        return np.minimum(-np.max(found, axis=0).astype(np.float64) * self._scale, within)


def outline_of(axis: Axis, carriers: PartCarriers, views: ViewSet) -> Outline:
    """The outline in the plane across an axis; the box where no view looks along it."""
    first, second = (carriers.size[index] for index in IN_PLANE[axis])
    this_views = [view for view in views.views if role_plane(view.role).normal is axis]
    if not this_views:
        box = [(0.0, 0.0), (first, 0.0), (first, second), (0.0, second)]
        arrangement = Arrangement(_sides([box]))
        return Outline(arrangement, tuple(range(1, arrangement.regions)))
    shadow = _Shadow(this_views, views.size, carriers.scale)
    samples = plane_grid(first, second, UNITS / _SAMPLES)
    lines = carriers.planes[axis].carriers if axis in carriers.planes else ()
    drawn = _bounded(Arrangement(lines), shadow, samples)
    if _agreement(drawn, shadow, samples) >= _AGREEING:
        return drawn
    arrangement = Arrangement(_sides(_contours(axis, carriers, shadow)))
    traced = Outline(arrangement, _material(arrangement, shadow, samples))
    better = _agreement(traced, shadow, samples) > _agreement(drawn, shadow, samples)
    return traced if better else drawn


def plane_grid(first: float, second: float, step: float) -> Points:
    """(n, 2) points all over a plane, a little askew to what is drawn there."""
    a, b = (np.arange(0.4137 * step, extent, step) for extent in (first, second))
    return np.stack(np.meshgrid(a, b, indexing="ij"), axis=-1).reshape(-1, 2)


def _bounded(arrangement: Arrangement, shadow: _Shadow, samples: Points) -> Outline:
    """The lines alone that lie between what is covered and what is not."""
    material = set(_material(arrangement, shadow, samples))
    intervals: dict[int, list[tuple[float, float]]] = {}
    for index, low, high in pieces_of(arrangement):
        curve = arrangement.carriers[index].curve
        at = low + 0.438 * (high - low)
        (a, b), (da, db) = curve.at(at), curve.normal(at)
        sides = [arrangement.locate(a + w * da, b + w * db) in material for w in (-ASIDE, ASIDE)]
        if sides[0] != sides[1]:
            intervals.setdefault(index, []).append((low, high))
    border = []
    for index, this_spans in intervals.items():
        carrier = arrangement.carriers[index]
        role = next(iter(carrier.intervals))
        merged = merged_intervals(this_spans, 1e-9)
        drawn = tuple(Interval(low, high, Linetype.VISIBLE, 1.0) for low, high in merged)
        border.append(Carrier(carrier.curve, {role: drawn}))
    bounded = Arrangement(border)
    return Outline(bounded, _material(bounded, shadow, samples))


def pieces_of(arrangement: Arrangement) -> Iterator[tuple[int, float, float]]:
    """(carrier, low, high) of what is drawn, cut where anything meets it."""
    corners = np.array(arrangement.corners).reshape(-1, 2)
    for index, low, high in arrangement.stretches:
        curve = arrangement.carriers[index].curve
        cuts = {low, high}
        for corner in corners[_on(curve, corners)]:
            at = curve.parameter((float(corner[0]), float(corner[1])))
            turns = (0.0, FULL_TURN, -FULL_TURN) if isinstance(curve, Circle) else (0.0,)
            cuts.update(at + turn for turn in turns if low < at + turn < high)
        for start, end in pairwise(sorted(cuts)):
            if (end - start) * curve.speed > _ON_CURVE:
                yield index, start, end


def _on(curve: LineOrCircle, points: Points) -> npt.NDArray[np.bool_]:
    """(n,) which of (n, 2) points lie on a curve."""
    if isinstance(curve, Circle):
        away = np.hypot(*(points - np.array(curve.centre)).T) - curve.radius
    else:
        away = (points - np.array(curve.point)) @ np.array(curve.normal(0.0))
    return np.abs(away) < _ON_CURVE


def _material(arrangement: Arrangement, shadow: _Shadow, samples: Points) -> tuple[int, ...]:
    """The regions that the masks cover, by a vote of points; those deep inside count most."""
    inner = list(arrangement.inner_points())
    points = np.concatenate([samples, np.array([point for _, point in inner]).reshape(-1, 2)])
    regions = [arrangement.locate(float(a), float(b)) for a, b in samples]
    regions += [region for region, _ in inner]
    most = 8.0 * shadow.pixel
    votes = np.clip(shadow.depths(points), -most, most)
    totals = np.bincount(np.array(regions), weights=votes, minlength=arrangement.regions)
    return tuple(int(r) for r in np.flatnonzero(totals > 0.0) if r != OUTSIDE)


def _agreement(outline: Outline, shadow: _Shadow, samples: Points) -> float:
    """Share of the points that are inside or outside of both an outline and the masks."""
    depths = shadow.depths(samples)
    clear = np.abs(depths) > _CLEAR_PX * shadow.pixel
    material = set(outline.material)
    inside = [outline.arrangement.locate(float(a), float(b)) in material for a, b in samples[clear]]
    return float(np.mean(np.array(inside) == (depths[clear] > 0.0))) if clear.any() else 0.0


def _contours(axis: Axis, carriers: PartCarriers, shadow: _Shadow) -> list[list[Point]]:
    """The masks' contours as polygons whose corners have the coordinates of lines near them."""
    from skimage.measure import approximate_polygon, find_contours

    first, second = IN_PLANE[axis]
    margin = 4.0 * shadow.pixel
    a, b = (
        np.arange(-margin, carriers.size[index] + margin, shadow.pixel) for index in (first, second)
    )
    points = np.stack(np.meshgrid(a, b, indexing="ij"), axis=-1)
    field = shadow.depths(points.reshape(-1, 2)).reshape(points.shape[:2])
    field[[0, -1], :] = field[:, [0, -1]] = -margin
    found = find_contours(field, 0.0)
    slack = _CONTOUR_PX
    while True:
        polygons = [approximate_polygon(contour, slack) for contour in found]
        if sum(len(polygon) - 1 for polygon in polygons) <= _MOST_SIDES or slack > _COARSEST_PX:
            break
        slack *= _COARSER
    reach = _SNAP_PX * shadow.pixel
    values = [_coordinates(carriers, Axis(index), reach) for index in (first, second)]
    return [
        [
            (_nearest(values[0], p, reach), _nearest(values[1], q, reach))
            for p, q in polygon[:-1] * shadow.pixel - margin
        ]
        for polygon in polygons
        if len(polygon) > 3
    ]


def _coordinates(carriers: PartCarriers, axis: Axis, reach: float) -> list[float]:
    """The coordinates of lines, and of the box's sides where no line lies in them."""
    found = list(carriers.values[axis])
    for side in (0.0, carriers.size[axis.value]):
        if all(abs(side - value) > reach for value in found):
            found.append(side)
    return found


def _nearest(values: Sequence[float], at: float, reach: float) -> float:
    """The value that a number is, but for a small distance."""
    nearest = min(values, key=lambda value: abs(value - at), default=at)
    return nearest if abs(nearest - at) <= reach else float(at)


def _sides(polygons: Sequence[Sequence[Point]]) -> list[Carrier]:
    """Polygons as carriers, one a side."""
    found = []
    for polygon in polygons:
        corners: list[Point] = []
        for corner in polygon:
            if not corners or _apart(corner, corners[-1]):
                corners.append(corner)
        while len(corners) > 1 and not _apart(corners[0], corners[-1]):
            corners.pop()
        if len(corners) < 3:
            continue
        for start, end in pairwise([*corners, corners[0]]):
            curve = line_through(start, end)
            low, high = sorted((curve.parameter(start), curve.parameter(end)))
            found.append(
                Carrier(curve, {Role.FRONT: (Interval(low, high, Linetype.VISIBLE, 1.0),)})
            )
    return found


def _apart(one: Point, other: Point) -> bool:
    return float(np.hypot(one[0] - other[0], one[1] - other[1])) >= SHORTEST
