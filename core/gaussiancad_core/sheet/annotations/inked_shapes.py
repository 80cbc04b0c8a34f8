"""Shapes of a whole sheet with their runs of ink, and how wide the ink of each run is."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.annotations.short_dashes import with_dots
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import OVERRUN
from gaussiancad_core.sheet.tracing.grown_shapes import Grown
from gaussiancad_core.sheet.tracing.ink_runs import InkField, Run, circle_runs, line_runs
from gaussiancad_core.sheet.tracing.line_widths import run_width
from gaussiancad_core.sheet.tracing.ridges import RidgePoints


@dataclass(frozen=True)
class InkedRun:
    """A run of ink along a shape.

    Attributes:
        run: where it is.
        width: px of ink across it; nothing where other strokes are everywhere beside it.
    """

    run: Run
    width: float | None


@dataclass(frozen=True)
class InkedShape:
    """A line or circle with its runs in order.

    Attributes:
        geometry: in px, centres of pixels at integers.
        runs: of ink.
    """

    geometry: Line | Circle
    runs: tuple[InkedRun, ...]

    @property
    def line(self) -> Line:
        """Its geometry, of a straight one."""
        if not isinstance(self.geometry, Line):
            raise ValueError("the shape is not straight")
        return self.geometry


def inked_shape(
    sheet: CleanSheet, field: InkField, ridges: RidgePoints, grown: Grown
) -> InkedShape:
    """Cut a shape into its runs and measure them."""
    geometry = grown.geometry
    if not isinstance(geometry, Line | Circle):
        raise ValueError("the shape is no line or circle")
    if isinstance(geometry, Line):
        along, _ = geometry.coordinates(ridges.points[grown.members])
        runs = line_runs(field, geometry, along.min() - OVERRUN, along.max() + OVERRUN)
    else:
        runs = circle_runs(field, geometry)
    runs = with_dots(sheet.weight, sheet.stroke_width, geometry, runs)
    widths = [run_width(sheet, geometry, run) for run in runs]
    return InkedShape(
        geometry,
        tuple(
            InkedRun(run, width if np.isfinite(width) else None)
            for run, width in zip(runs, widths, strict=True)
        ),
    )


def points_along(geometry: Line | Circle, run: Run, step: float) -> npt.NDArray[np.float64]:
    """(n, 2) px along a run, both ends included."""
    along = np.linspace(run.start, run.end, max(2, int(np.ceil(run.length / step)) + 1))
    return geometry.points_at(along)
