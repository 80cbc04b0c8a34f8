"""How exactly strokes are known: fitted to pixels, or as a file has them."""

from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.sheet.axis_clusters import Limits


@dataclass(frozen=True)
class Precision:
    """How exactly the strokes of a view are known.

    Attributes:
        noise: px, standard deviation of the place of one px of a stroke.
        level: px by which a stroke along an axis may lean between its ends.
        ends: px between the end of a stroke and where it is meant to end.
        limits: of coordinates that are told apart.
    """

    noise: float
    level: float
    ends: float
    limits: Limits


FROM_PIXELS = Precision(0.3, 0.6, 1.2, Limits(apart=0.5, reach=1.0, finest=0.3))
"""Fitted to ink: lines come out within a tenth of a pixel."""

FROM_VECTORS = Precision(0.01, 0.02, 0.02, Limits(apart=0.02, reach=0.25, finest=0.01))
"""As the file has them."""

FROM_PLOTS = Precision(0.06, 0.2, 0.35, Limits(apart=0.2, reach=0.5, finest=0.1))
"""Rounded by a plotter or printer driver, to 1/1200 inch or so: a sixth of a pixel."""


class StrokesSource(Enum):
    """Where the strokes of a view come from: its picture, the file, a file that was plotted, or
    one that was plotted on a grid as coarse as pixels."""

    RASTER = "raster"
    VECTOR = "vector"
    PLOT = "plot"
    COARSE = "coarse-plot"

    @property
    def precision(self) -> Precision:
        """Of strokes from there."""
        known = {StrokesSource.VECTOR: FROM_VECTORS, StrokesSource.PLOT: FROM_PLOTS}
        return known.get(self, FROM_PIXELS)
