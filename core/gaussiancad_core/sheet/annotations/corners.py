"""Corners of a sheet: edges end in them, centre lines end free."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.geometry import Line

_NEAR_PX = 1.5
"""px between ends that meet, beyond half a stroke."""

_TURN = 0.9
"""Cosine of the angle between lines at most, for their ends to make a corner."""


@dataclass(frozen=True, eq=False)
class Corners:
    """The ends of a sheet's straight runs.

    Attributes:
        ends: (n, 2) px.
        ways: (n, 2) unit vectors along the lines.
        near: px between ends that meet.
    """

    ends: npt.NDArray[np.float64]
    ways: npt.NDArray[np.float64]
    near: float

    @classmethod
    def of(cls, shapes: Sequence[InkedShape], stroke_width: float) -> "Corners":
        """Of all lines.

        Args:
            shapes: of the sheet.
            stroke_width: px.
        """
        pairs = [
            (line.at(place), line.direction)
            for shape in shapes
            for line in [shape.geometry]
            if isinstance(line, Line)
            for run in shape.runs
            for place in (run.run.start, run.run.end)
        ]
        ends = np.array([end for end, _ in pairs], float).reshape(-1, 2)
        ways = np.array([way for _, way in pairs], float).reshape(-1, 2)
        return cls(ends, ways, _NEAR_PX + stroke_width / 2.0)

    def has_end(self, line: object, runs: Sequence[InkedRun]) -> bool:
        """Whether runs of a line begin or end where another line ends."""
        if not isinstance(line, Line):
            return False
        tree = cKDTree(self.ends)
        places = [line.at(runs[0].run.start), line.at(runs[-1].run.end)]
        way = np.array(line.direction)
        return any(
            abs(float(self.ways[k] @ way)) < _TURN
            for own in tree.query_ball_point(places, self.near)
            for k in own
        )
