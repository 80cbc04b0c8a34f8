"""Where straight lines run within a solid."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from OCP.gp import gp_Dir, gp_Lin, gp_Pnt
from OCP.IntCurvesFace import IntCurvesFace_ShapeIntersector
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.geometry.tolerances import COMPUTED

Points = npt.NDArray[np.float64]

_TOLERANCE = 1e-7
"""Units, of the kernel's intersector."""

_NUDGES = 4
"""Times that a line which touches the solid is moved a little aside."""

_NUDGE = 3.7e-5
"""Units by which it is."""


class Rays:
    """Lines through a solid.

    Args:
        shape: one solid; units.
        reach: units from the origin beyond which there is none of it.
    """

    def __init__(self, shape: TopoDS_Shape, reach: float) -> None:
        self._intersector = IntCurvesFace_ShapeIntersector()
        self._intersector.Load(shape, _TOLERANCE)
        self._reach = reach

    def inside(
        self, point: Points | Sequence[float], direction: Points | Sequence[float]
    ) -> Points | None:
        """(n, 2) stretches of a line within the solid, ascending, units along its direction from a
        point; None where the line, and others close beside it, touch the solid so that crossings
        do not pair."""
        at, aside = np.array(point, dtype=np.float64), np.array([0.577, 0.811, -0.101])
        for number in range(_NUDGES):
            found = self._crossings(at + number * _NUDGE * aside, direction)
            if len(found) % 2 == 0:
                return np.array(found).reshape(-1, 2)
        return None

    def _crossings(self, point: Points, direction: Points | Sequence[float]) -> list[float]:
        line = gp_Lin(gp_Pnt(*point.tolist()), gp_Dir(*map(float, direction)))
        self._intersector.Perform(line, -self._reach, self._reach)
        found = sorted(
            self._intersector.WParameter(k + 1) for k in range(self._intersector.NbPnt())
        )
        crossings: list[float] = []
        for at in found:
            if not crossings or at - crossings[-1] > COMPUTED:
                crossings.append(at)
        return crossings
