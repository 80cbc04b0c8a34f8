"""Lines moved to the places that all views, and the numbers of the sheet, agree on.

Collinear lines of all views, circles about one centre, and what dimensions say, are one system of
equations (:mod:`gaussiancad_core.coordinates.carriers`).  A line that is near one of its solutions
belongs there.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import copysign

import numpy as np

from gaussiancad_core.coordinates.carriers import PartCarriers, find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.sketch.grid_tolerances import LEAN, NEAR
from gaussiancad_core.sketch.plane_lines import Floats, PlaneLine, arc_between, whole_circle

_NEAR_END = 0.8
"""The same of an end of a line that is not along an axis."""


@dataclass(frozen=True, eq=False)
class Places:
    """Where lines may lie.

    Attributes:
        values: mm, of each axis.
        circles: of the plane across each axis, mm.
        size: (3,) mm of the part.
        grid: mm of a step of the sheet's coordinates.
        carriers: from which they come.
    """

    values: Mapping[Axis, Floats]
    circles: Mapping[Axis, Sequence[Circle]]
    size: tuple[float, float, float]
    grid: float
    carriers: PartCarriers

    def settled(self, line: PlaneLine, normal: Axis) -> PlaneLine:
        """A line of the plane across an axis at its place."""
        if line.circle is not None:
            circle = self._circle(line.circle, normal)
            if line.is_closed:
                return whole_circle(circle, line.is_visible, line.stroke)
            points = arc_between(circle, (line.points[0], line.points[-1]), _sweep(line))
            return replace(line, points=points, circle=circle)
        if not line.is_straight:
            return line
        constant = line.constant(LEAN * self.grid)
        points = line.points.copy()
        for column, index in enumerate(IN_PLANE[normal]):
            if column == constant:
                points[:, column] = self._value(Axis(index), float(points[:, column].mean()), NEAR)
            else:
                near = NEAR if constant is not None else _NEAR_END
                points[:, column] = [
                    self._value(Axis(index), at, near) for at in points[:, column].tolist()
                ]
        return line if np.ptp(points, axis=0).max() == 0.0 else replace(line, points=points)

    def _value(self, axis: Axis, at: float, near: float) -> float:
        known = self.values[axis]
        if not len(known):
            return at
        nearest = float(known[np.abs(known - at).argmin()])
        return nearest if abs(nearest - at) <= near * self.grid else at

    def _circle(self, circle: Circle, normal: Axis) -> Circle:
        def away(other: Circle) -> float:
            apart = np.hypot(*np.subtract(circle.centre, other.centre))
            return max(float(apart), abs(circle.radius - other.radius))

        nearest = min(self.circles.get(normal, ()), key=away, default=circle)
        return nearest if away(nearest) <= NEAR * self.grid else circle


def find_places(views: DrawnViews, grid: float) -> Places:
    """Where the lines of views belong.

    Args:
        views: with what the sheet's numbers say.
        grid: mm of a step of the sheet's coordinates.
    """
    carriers = find_carriers(views)
    scale = carriers.scale
    values = {axis: np.array(this_values) / scale for axis, this_values in carriers.values.items()}
    circles = {
        axis: [
            Circle((x / scale, y / scale), curve.radius / scale)
            for carrier in plane.carriers
            if isinstance(curve := carrier.curve, Circle)
            for x, y in [curve.centre]
        ]
        for axis, plane in carriers.planes.items()
    }
    x_size, y_size, z_size = (
        float(values[axis][-1])
        if len(values[axis]) and abs(values[axis][-1] - views.size[axis.value]) < NEAR * grid
        else views.size[axis.value]
        for axis in Axis
    )
    return Places(values, circles, (x_size, y_size, z_size), grid, carriers)


def _sweep(line: PlaneLine) -> float:
    """Radians that an arc turns, negative from the second axis to the first."""
    (x, y), ((a, b), (c, d)) = line.arc.centre, line.points[:2].tolist()
    way = (a - x) * (d - y) - (b - y) * (c - x)
    return copysign(line.length / line.arc.radius, way)
