"""The coordinates that views show of the part's axes: lines along them, centres and sides of
circles, and the ends of the views.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Stroke
from gaussiancad_core.sheet.registration.axis_clusters import (
    AxisFit,
    Limits,
    SeenCoordinates,
    fit_axis,
)
from gaussiancad_core.sheet.registration.stroke_carriers import (
    AxisLine,
    CarriedStrokes,
    Round,
    Support,
)
from gaussiancad_core.sheet.registration.stroke_precision import Precision

_BOX_WEIGHT = 1e-3
"""px of ink that an end of a view's box counts for: mostly the strokes there tell it."""

_TANGENT_PX = 2.0
"""px that the end of an arc may be short of where the circle runs along an axis."""


@dataclass(frozen=True)
class PlaneView:
    """A view before the axes are shared.

    Attributes:
        role: of the view.
        strokes: px of the view's plane (right, up), with the part's extent from 0 on each axis, as
            in :mod:`gaussiancad_core.model.views`, but each view with its own extents.
        extents: px along right and up.
        precision: of the strokes.
    """

    role: Role
    strokes: tuple[Stroke, ...]
    extents: tuple[float, float]
    precision: Precision

    @property
    def axes(self) -> tuple[tuple[Axis, int], tuple[Axis, int]]:
        """Axis and sign of right and up."""
        return self.role.frame.right_axis, self.role.frame.up_axis


@dataclass(frozen=True)
class CoordinateSource:
    """What shows a coordinate: a support of a view, for circles its centre or a side.

    Attributes:
        view: number of the view.
        direction: 0 right, 1 up.
        support: its number, -1 for an end of the box.
        side: 0 for a line or centre, -1 or 1 for the lower or upper side on the axis of a circle
            or box.
    """

    view: int
    direction: int
    support: int
    side: int = 0


class SeenByViews:
    """All coordinates that the views show.

    Attributes:
        views: whose they are.
        supported: their strokes.
        limits: of the least exact view.
        sources: of the coordinates of each axis, in the order of :meth:`on`.
        loose: centres too uncertain to be coordinates; circles' sides tell them.
    """

    def __init__(self, views: Sequence[PlaneView], supported: Sequence[CarriedStrokes]) -> None:
        self.views = views
        self.supported = supported
        self.limits = _common_limits(views)
        self.sources: dict[Axis, list[CoordinateSource]] = {axis: [] for axis in Axis}
        self._at: dict[Axis, list[float]] = {axis: [] for axis in Axis}
        self._weight: dict[Axis, list[float]] = {axis: [] for axis in Axis}
        self.loose: list[CoordinateSource] = []
        for index, view in enumerate(views):
            for direction, (axis, _) in enumerate(view.axes):
                for side, at in ((-1, 0.0), (1, view.extents[direction])):
                    self._add(axis, CoordinateSource(index, direction, -1, side), at, _BOX_WEIGHT)
            for number, support in enumerate(supported[index].supports):
                self._take(index, number, support)

    def _take(self, index: int, number: int, support: Support) -> None:
        view = self.views[index]
        if isinstance(support, AxisLine):
            axis, sign = view.axes[support.fixed]
            source = CoordinateSource(index, support.fixed, number)
            self._add_inside(axis, source, sign * support.at, support.weight)
        elif isinstance(support, Round):
            for direction, (axis, sign) in enumerate(view.axes):
                self._take_round(axis, sign, CoordinateSource(index, direction, number), support)

    def _take_round(self, axis: Axis, sign: int, source: CoordinateSource, circle: Round) -> None:
        precision = self.views[source.view].precision
        variance = np.linalg.inv(circle.information)
        centre = sign * circle.centre[source.direction]
        spread = float(variance[source.direction, source.direction])
        sure = precision.noise * np.sqrt(spread) <= precision.limits.finest
        if not (sure and self._add_inside(axis, source, centre, 1.0 / spread)):
            self.loose.append(source)
        for side in (-1, 1):
            # The angle in the plane; its axes may run against the model's.
            angle = source.direction * np.pi / 2 + (0.0 if side * sign > 0 else np.pi)
            gradient = np.zeros(3)
            gradient[source.direction], gradient[2] = sign, side
            spread = float(gradient @ variance @ gradient)
            if circle.shows(angle, _TANGENT_PX) and (
                precision.noise * np.sqrt(spread) <= precision.limits.reach / 2
            ):
                edge = replace(source, side=side)
                self._add_inside(axis, edge, centre + side * circle.radius, 1.0 / spread)

    def _add_inside(self, axis: Axis, source: CoordinateSource, at: float, weight: float) -> bool:
        """Note a coordinate, unless it lies beside the part: leftovers of annotations do."""
        view = self.views[source.view]
        beyond = view.precision.limits.apart
        inside = -beyond <= at <= view.extents[source.direction] + beyond
        if inside:
            self._add(axis, source, at, weight)
        return inside

    def _add(self, axis: Axis, source: CoordinateSource, at: float, weight: float) -> None:
        self.sources[axis].append(source)
        self._at[axis].append(at)
        # In terms of variance, so that views of different precision can be averaged.
        self._weight[axis].append(weight / self.views[source.view].precision.noise ** 2)

    @property
    def axes(self) -> tuple[Axis, ...]:
        """Those that a view shows."""
        return tuple(axis for axis in Axis if self.sources[axis])

    def on(self, axis: Axis) -> SeenCoordinates:
        """The coordinates of an axis; its views are counted as in :meth:`showing`."""
        showing = self.showing(axis)
        number = np.array([showing.index(source.view) for source in self.sources[axis]])
        return SeenCoordinates(np.array(self._at[axis]), np.array(self._weight[axis]), number)

    def showing(self, axis: Axis) -> list[int]:
        """Numbers of the views that show an axis."""
        return sorted({source.view for source in self.sources[axis]})

    def fit(self, axis: Axis) -> AxisFit:
        """The views that show an axis, brought together on it."""
        extents = [
            extent
            for index in self.showing(axis)
            for (this_axis, _), extent in zip(
                self.views[index].axes, self.views[index].extents, strict=True
            )
            if this_axis is axis
        ]
        return fit_axis(self.on(axis), np.array(extents), self.limits)


def _common_limits(views: Sequence[PlaneView]) -> Limits:
    """Limits of the least exact view."""
    names = ("apart", "reach", "finest", "stretch")
    return Limits(*(max(getattr(v.precision.limits, name) for v in views) for name in names))
