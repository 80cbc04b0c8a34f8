"""Shapes of a whole sheet with their runs of ink, and how wide the ink of each run is."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from scipy.ndimage import median_filter

from gaussiancad_core.sheet.annotations.dots import with_dots
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.growth import Grown
from gaussiancad_core.sheet.line_widths import run_width, widths_along
from gaussiancad_core.sheet.ridges import RidgePoints
from gaussiancad_core.sheet.runs import InkField, Run, circle_runs, line_runs

_BEYOND = 3.0
"""px by which a shape is looked at beyond its last ridge point."""

_STEADY = 6
"""px on either side over which a width is made steady."""

_EDGE, _SHORTEST_EDGE = 10.0, 4.0
"""Length from which a wide stretch is an edge and no arrowhead, in widths of a line; and where it
is as wide as edges all along."""

_BLOT, _HEAD = 1.6, 16.0
"""Width of a stretch from which it is no edge, and its length up to which it is an arrowhead, in
widths of edges."""

_STEADY_SHARE, _PARALLEL, _KNOWN = 0.12, 0.8, 0.4
"""Share of an edge's width by which its ink may be wider or narrower, share of the places where its
width is known at which it is not, and share of all places: arrowheads taper."""


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


def inked_shape(
    sheet: CleanSheet, field: InkField, ridges: RidgePoints, grown: Grown
) -> InkedShape:
    """Cut a shape into its runs and measure them."""
    geometry = grown.geometry
    if isinstance(geometry, Line):
        along, _ = geometry.coordinates(ridges.points[grown.members])
        runs = line_runs(field, geometry, along.min() - _BEYOND, along.max() + _BEYOND)
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
    if isinstance(geometry, Line):
        return np.array(geometry.point) + along[:, None] * np.array(geometry.direction)
    angles = along / geometry.radius
    radial = np.stack([np.cos(angles), np.sin(angles)], 1)
    return np.array(geometry.centre) + geometry.radius * radial


def normals_along(geometry: Line | Circle, run: Run, step: float) -> npt.NDArray[np.float64]:
    """(n, 2) unit normals at the points of :func:`points_along`."""
    points = points_along(geometry, run, step)
    if isinstance(geometry, Line):
        normal = np.array([-geometry.direction[1], geometry.direction[0]])
        return np.broadcast_to(normal, points.shape)
    return (points - np.array(geometry.centre)) / geometry.radius


def split_by_width(
    sheet: CleanSheet, shape: InkedShape, limit: float, visible: float
) -> InkedShape:
    """The shape with runs cut where an extension line goes on as an edge.

    Args:
        sheet: the ink.
        shape: with its runs.
        limit: px; there their ink gets wider or narrower than that.
        visible: px, the width of edges.
    """
    runs: list[InkedRun] = []
    for run in shape.runs:
        widths = widths_along(sheet, shape.geometry, run.run)
        known = np.flatnonzero(np.isfinite(widths))
        if len(known) < 2:
            runs.append(run)
            continue
        # Where another stroke is beside it, the run is as wide as next to there.
        filled = np.interp(np.arange(len(widths)), known, widths[known])
        # Reflected, for at its very end a run is half paper.
        smooth = median_filter(filled, 2 * _STEADY + 1, mode="reflect")
        narrow = _without_heads(smooth < limit, widths, limit, visible)
        cuts = np.flatnonzero(np.diff(narrow)) + 0.5
        ends = run.run.start + run.run.length * np.array([0, *cuts, len(widths) - 1]) / (
            len(widths) - 1
        )
        for k in range(len(ends) - 1):
            part = Run(float(ends[k]), float(ends[k + 1]))
            middle = (cuts[k - 1] if k else 0, cuts[k] if k < len(cuts) else len(widths) - 1)
            own = filled[int(np.ceil(middle[0])) : int(np.floor(middle[1])) + 1]
            runs.append(InkedRun(part, float(np.median(own))))
    return InkedShape(shape.geometry, tuple(runs))


def _without_heads(
    narrow: npt.NDArray[np.bool_], widths: npt.NDArray[np.float64], limit: float, visible: float
) -> npt.NDArray[np.bool_]:
    """Narrow places; wide stretches beside them that are shorter than an edge, and not as wide as
    one all along, are arrowheads, and so are longer ones that are far wider.

    Args:
        narrow: (n,) every px along a run.
        widths: (n,) px there, NaN where other strokes are beside it.
        limit, visible: px, as for :func:`split_by_width`.
    """
    result = narrow.copy()
    borders = [0, *(np.flatnonzero(np.diff(narrow)) + 1), len(narrow)]
    if len(borders) == 2:
        return result
    for start, end in pairwise(borders):
        own = widths[start:end]
        own = own[np.isfinite(own)]
        blot = len(own) and np.median(own) > _BLOT * visible and end - start < _HEAD * visible
        if not narrow[start] and blot:
            result[start:end] = True
        elif not narrow[start] and end - start < _EDGE * limit:
            steady = np.abs(own - visible) <= _STEADY_SHARE * visible
            edge = end - start >= _SHORTEST_EDGE * limit and steady.sum() >= _KNOWN * (end - start)
            result[start:end] = not (edge and steady.mean() >= _PARALLEL)
    return result
