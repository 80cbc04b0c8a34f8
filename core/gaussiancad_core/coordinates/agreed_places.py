"""Lines moved to the places that all views, and the numbers of the sheet, agree on.

Collinear lines of all views, circles about one centre, and what dimensions say, are one system of
equations (:mod:`gaussiancad_core.coordinates.carriers`).  A line that is near one of its solutions
belongs there.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.coordinates.carriers import PartCarriers, find_carriers
from gaussiancad_core.coordinates.grid_tolerances import LEAN, NEAR
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE

Floats = npt.NDArray[np.float64]

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

    def placed(self, points: Floats, normal: Axis) -> Floats:
        """The ends (2, 2) of a straight line of the plane across an axis, at their places."""
        across = np.ptp(points, axis=0)
        column = int(across.argmin())
        constant = column if across[column] <= LEAN * self.grid else None
        found = points.copy()
        for each, index in enumerate(IN_PLANE[normal]):
            if each == constant:
                found[:, each] = self._value(Axis(index), float(points[:, each].mean()), NEAR)
            else:
                near = NEAR if constant is not None else _NEAR_END
                found[:, each] = [
                    self._value(Axis(index), at, near) for at in points[:, each].tolist()
                ]
        return found if np.ptp(found, axis=0).max() > 0.0 else points

    def circle(self, circle: Circle, normal: Axis) -> Circle:
        """A circle of the plane across an axis, at its place."""

        def away(other: Circle) -> float:
            apart = np.hypot(*np.subtract(circle.centre, other.centre))
            return max(float(apart), abs(circle.radius - other.radius))

        nearest = min(self.circles.get(normal, ()), key=away, default=circle)
        return nearest if away(nearest) <= NEAR * self.grid else circle

    def _value(self, axis: Axis, at: float, near: float) -> float:
        known = self.values[axis]
        if not len(known):
            return at
        nearest = float(known[np.abs(known - at).argmin()])
        return nearest if abs(nearest - at) <= near * self.grid else at


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
