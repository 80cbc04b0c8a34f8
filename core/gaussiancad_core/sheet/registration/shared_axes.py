"""One coordinate for each plane of the part: what all views show of an axis, averaged.

The views of a part repeat its coordinates: a face is a line in two views, a hole a circle in one
and two lines in another.  Here the views are brought together by what they share, each coordinate
becomes the average of all that was seen of it, weighted by how exactly, and every stroke is laid
anew: lines along the axes are exactly along them, equal coordinates are the same number in every
view, a circle's centre and radius agree with its sides, and strokes that meet share their ends.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.points import to_point
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Ellipse, Segment, Stroke
from gaussiancad_core.sheet.registration.axis_clusters import (
    AxisFit,
    Limits,
    SeenCoordinates,
    averages,
    clustered,
)
from gaussiancad_core.sheet.registration.axis_residuals import Residual, axis_residual
from gaussiancad_core.sheet.registration.circle_ties import Estimates, Tie, tied
from gaussiancad_core.sheet.registration.seen_coordinates import (
    CoordinateSource,
    PlaneView,
    SeenByViews,
)
from gaussiancad_core.sheet.registration.stroke_carriers import (
    AxisLine,
    CarriedStrokes,
    Round,
    Slant,
    Support,
    supports_of,
)
from gaussiancad_core.sheet.registration.vertices import Grid, settled_strokes

Floats = npt.NDArray[np.float64]

_RADIUS_REACH = 1.5
"""Radii are one up to this many times the finest difference of coordinates."""

_UNSURE_REACH = 2.0
"""The same of arcs too short to tell theirs, in distances that tell coordinates of a view apart."""

_SURELY = 4.0
"""Standard deviations by which a value is wrong at most."""


@dataclass(frozen=True)
class ViewMap:
    """Where a view's own axes lie on the shared ones: ``shared = gain x own + shift``, in px.

    Attributes:
        gain, shift: (2,) of right and up.
    """

    gain: tuple[float, float]
    shift: tuple[float, float]


@dataclass(frozen=True)
class SharedAxes:
    """Views whose coordinates agree.

    Attributes:
        strokes: of each view, px of its plane.
        maps: of each view.
        extents: of the part in px.
        residuals: of the axes that two views or more show.
    """

    strokes: tuple[tuple[Stroke, ...], ...]
    maps: tuple[ViewMap, ...]
    extents: dict[Axis, float]
    residuals: dict[Axis, Residual]


def share_axes(views: Sequence[PlaneView]) -> SharedAxes:
    """Bring views together and let their coordinates agree.

    Args:
        views: at least one; an axis that none shows has no extent.
    """
    supported = [supports_of(view.strokes, view.precision) for view in views]
    seen = SeenByViews(views, supported)
    fits = {axis: seen.fit(axis) for axis in seen.axes}
    maps = tuple(_map(seen, index, fits) for index in range(len(views)))
    unknowns = _Unknowns(seen, fits, maps)
    levels = unknowns.levels
    strokes = tuple(
        _settled(unknowns, view, index, _on_shared(supported[index], view, maps[index]))
        for index, view in enumerate(views)
    )
    shifted = tuple(
        ViewMap(
            view_map.gain,
            (
                view_map.shift[0] - unknowns.zero[view.axes[0][0]],
                view_map.shift[1] - unknowns.zero[view.axes[1][0]],
            ),
        )
        for view_map, view in zip(maps, views, strict=True)
    )
    residuals = {
        axis: found
        for axis in seen.axes
        if (found := axis_residual(seen.on(axis), fits[axis], levels[axis], unknowns.zero[axis]))
    }
    extents = {axis: float(levels[axis][-1]) for axis in seen.axes}
    return SharedAxes(strokes, shifted, extents, residuals)


def _map(seen: SeenByViews, index: int, fits: dict[Axis, AxisFit]) -> ViewMap:
    gain, shift = [], []
    for axis, _ in seen.views[index].axes:
        place = seen.showing(axis).index(index)
        gain.append(float(fits[axis].gain[place]))
        shift.append(float(fits[axis].shift[place]))
    return ViewMap((gain[0], gain[1]), (shift[0], shift[1]))


class _Unknowns:
    """The shared coordinates and radii, numbered, and what the views say about them.

    Attributes:
        levels: for each axis its coordinates, rising from 0.
        zero: for each axis what was taken off for that.
        values: of all unknowns; coordinates without ``zero`` taken off.
    """

    def __init__(
        self, seen: SeenByViews, fits: dict[Axis, AxisFit], maps: Sequence[ViewMap]
    ) -> None:
        self._seen = seen
        self._maps = maps
        self._number: dict[CoordinateSource, int] = {}
        self._chains: dict[Axis, npt.NDArray[np.int64]] = {}
        self._start: list[float] = []
        self._weights: list[float] = []
        for axis, fit in fits.items():
            self._number_axis(axis, fit)
        self._radius: dict[tuple[int, int], int] = {}
        self._number_circles()
        self.values = self._solved()
        if self._attached():
            self.values = self._solved()
        self.levels, self.zero = {}, {}
        for axis, chain in self._chains.items():
            self.zero[axis] = float(self.values[chain[0]])
            self.levels[axis] = self.values[chain] - self.zero[axis]

    def coordinate(self, source: CoordinateSource) -> float | None:
        """px on the shared axis from its zero; None for what lies beside the part."""
        number = self._number.get(source)
        if number is None:
            return None
        axis = self._seen.views[source.view].axes[source.direction][0]
        return float(self.values[number] - self.zero[axis])

    def radius(self, view: int, support: int) -> float:
        """px, of a circle."""
        return float(self.values[self._radius[view, support]])

    def _number_axis(self, axis: Axis, fit: AxisFit) -> None:
        seen = self._seen.on(axis)
        first = len(self._start)
        start = averages(fit.common(seen), seen.weight, fit.cluster)
        self._start += start.tolist()
        self._weights += np.bincount(fit.cluster, weights=seen.weight).tolist()
        self._chains[axis] = np.arange(first, first + len(start))
        for source, cluster in zip(self._seen.sources[axis], fit.cluster, strict=True):
            self._number[source] = first + int(cluster)

    def _number_circles(self) -> None:
        """Uncertain centres are unknowns of their own; radii are clustered as coordinates are."""
        for source in self._seen.loose:
            self._number[source] = len(self._start)
            self._start.append(self._centre(source))
            self._weights.append(1e-3)
        circles = [
            (view, number)
            for view, strokes in enumerate(self._seen.supported)
            for number, support in enumerate(strokes.supports)
            if isinstance(support, Round)
        ]
        values = np.array([self._raw_radius(*circle) for circle in circles])
        weights = np.array([self._radius_weight(*circle) for circle in circles])
        limits = self._seen.limits
        near = _RADIUS_REACH * limits.finest
        far = _UNSURE_REACH * limits.apart
        sure = weights >= 1.0 / limits.finest**2
        for group, reach in ((sure, near), (~sure, max(far, near))):
            row = np.flatnonzero(group)
            if not len(row):
                continue
            of = np.zeros(len(row), int)
            coordinates = SeenCoordinates(values[row], weights[row], of)
            cluster = clustered(coordinates, Limits(reach, reach, reach))
            for index, number in zip(row, cluster, strict=True):
                self._radius[circles[index]] = len(self._start) + int(number)
            self._start += averages(values[row], weights[row], cluster).tolist()
            self._weights += np.bincount(cluster, weights=weights[row]).tolist()

    def _circle(self, view: int, support: int) -> Round:
        found = self._seen.supported[view].supports[support]
        if not isinstance(found, Round):
            raise TypeError("only circles have a centre")
        return found

    def _centre(self, source: CoordinateSource) -> float:
        """Of a circle, on the shared axis as its view has it."""
        sign = self._seen.views[source.view].axes[source.direction][1]
        view_map = self._maps[source.view]
        centre = sign * self._circle(source.view, source.support).centre[source.direction]
        return view_map.gain[source.direction] * centre + view_map.shift[source.direction]

    def _raw_radius(self, view: int, support: int) -> float:
        return self._circle(view, support).radius * float(np.mean(self._maps[view].gain))

    def _radius_weight(self, view: int, support: int) -> float:
        variance = np.linalg.inv(self._circle(view, support).information)[2, 2]
        return float(1.0 / (variance * self._seen.views[view].precision.noise ** 2))

    def _solved(self) -> Floats:
        count = len(self._start)
        start = np.array(self._start)
        information = np.zeros((count, count))
        pull = np.zeros(count)
        self._observe_lines(information, pull)
        for view, support in self._radius:
            self._observe_circle(view, support, information, pull)
        limits = self._seen.limits.reach + _SURELY / np.sqrt(np.array(self._weights))
        known = Estimates(information, start, limits, tuple(self._chains.values()))
        return tied(known, pull, self._ties())

    def _attached(self) -> bool:
        """Whether centres that their circles' sides made certain are coordinates after all."""
        count = len(self._number)
        for source in self._seen.loose:
            axis = self._seen.views[source.view].axes[source.direction][0]
            chain = self._chains[axis]
            away = np.abs(self.values[chain] - self.values[self._number[source]])
            nearest = int(np.argmin(away))
            if away[nearest] <= self._seen.limits.finest:
                self._number[source] = int(chain[nearest])
                count -= 1
        return count < len(self._number)

    def _observe_lines(self, information: Floats, pull: Floats) -> None:
        for axis in self._chains:
            seen = self._seen.on(axis)
            for index, source in enumerate(self._seen.sources[axis]):
                support = (
                    self._seen.supported[source.view].supports[source.support]
                    if source.support >= 0
                    else None
                )
                if not isinstance(support, Round):
                    view_map = self._maps[source.view]
                    at = (
                        view_map.gain[source.direction] * seen.at[index]
                        + view_map.shift[source.direction]
                    )
                    number = self._number[source]
                    information[number, number] += seen.weight[index]
                    pull[number] += seen.weight[index] * at

    def _observe_circle(self, view: int, support: int, information: Floats, pull: Floats) -> None:
        circle, plane_view = self._circle(view, support), self._seen.views[view]
        signs = np.array([plane_view.axes[0][1], plane_view.axes[1][1], 1])
        stated = circle.information * np.outer(signs, signs) / plane_view.precision.noise**2
        sources = [CoordinateSource(view, direction, support) for direction in (0, 1)]
        where = np.array([*(self._number[s] for s in sources), self._radius[view, support]])
        seen = np.array([*(self._centre(s) for s in sources), self._raw_radius(view, support)])
        information[np.ix_(where, where)] += stated
        pull[where] += stated @ seen

    def _ties(self) -> list[Tie]:
        ties = [
            Tie(
                number,
                self._number[replace(source, side=0)],
                self._radius[source.view, source.support],
                source.side,
            )
            for source, number in self._number.items()
            if source.side and source.support >= 0
        ]
        return list(dict.fromkeys(ties))


def _on_shared(strokes: CarriedStrokes, view: PlaneView, place: ViewMap) -> CarriedStrokes:
    """A view's strokes and supports on the shared axes, as its map has them."""
    signs = np.array([sign for _, sign in view.axes], dtype=float)
    gain, shift = np.array(place.gain), signs * np.array(place.shift)
    scale = float(gain.mean())

    def moved(point: tuple[float, float]) -> tuple[float, float]:
        x, y = gain * point + shift
        return float(x), float(y)

    def stroke_moved(stroke: Stroke) -> Stroke:
        if isinstance(stroke, Segment):
            return replace(stroke, start=moved(stroke.start), end=moved(stroke.end))
        return replace(stroke.mapped(Similarity(scale)), centre=moved(stroke.centre))

    def support_moved(support: Support) -> Support:
        if isinstance(support, AxisLine):
            fixed = support.fixed
            return replace(support, at=float(gain[fixed] * support.at + shift[fixed]))
        if isinstance(support, Slant):
            way = gain * support.line.direction
            way = way / np.hypot(*way)
            line = Line(moved(support.line.point), (float(way[0]), float(way[1])))
            return replace(support, line=line)
        return replace(support, centre=moved(support.centre), radius=scale * support.radius)

    return CarriedStrokes(
        tuple(stroke_moved(stroke) for stroke in strokes.strokes),
        tuple(support_moved(support) for support in strokes.supports),
        strokes.of,
    )


def _settled(
    unknowns: _Unknowns, view: PlaneView, index: int, supported_strokes: CarriedStrokes
) -> tuple[Stroke, ...]:
    """The strokes of a view at the shared coordinates."""
    signs = [sign for _, sign in view.axes]
    zeros = np.array([sign * unknowns.zero[axis] for axis, sign in view.axes])

    def at(number: int, direction: int) -> float | None:
        found = unknowns.coordinate(CoordinateSource(index, direction, number))
        return None if found is None else signs[direction] * found

    def support_settled(number: int, support: Support) -> Support:
        if isinstance(support, AxisLine):
            level = at(number, support.fixed)
            level = support.at - float(zeros[support.fixed]) if level is None else level
            return replace(support, at=level)
        if isinstance(support, Slant):
            point = np.array(support.line.point) - zeros
            line = replace(support.line, point=(float(point[0]), float(point[1])))
            return replace(support, line=line)
        x, y = at(number, 0), at(number, 1)
        if x is None or y is None:
            raise ValueError("a circle has no coordinates")
        return replace(support, centre=(x, y), radius=unknowns.radius(index, number))

    levels = tuple(np.sort(sign * unknowns.levels[axis]) for axis, sign in view.axes)
    grid = Grid((levels[0], levels[1]), view.precision)
    back = Similarity(offset=to_point(-zeros))
    settled = CarriedStrokes(
        tuple(stroke.mapped(back) for stroke in supported_strokes.strokes),
        tuple(
            support_settled(number, support)
            for number, support in enumerate(supported_strokes.supports)
        ),
        supported_strokes.of,
    )
    strokes = settled_strokes(settled, grid)
    return tuple(
        _centred(stroke, grid) if isinstance(stroke, Ellipse) else stroke for stroke in strokes
    )


def _centred(stroke: Ellipse, grid: Grid) -> Ellipse:
    """An ellipse with its centre at the coordinates that are near."""
    x, y = (
        grid.snapped(direction, stroke.centre[direction], grid.precision.limits.apart)
        for direction in (0, 1)
    )
    return replace(stroke, centre=(x, y))
