"""What is left at the ends of dimension lines: arrowheads, and extension lines of their own.

An arrowhead's contour is as good as an arc that runs into its line.  An extension line in line with
an edge that bends is explained by no line, for across the gap it was followed into the bend.  As
far as two dimensions have an extension line in common it is drawn twice, and wider.
"""

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape, inked_shape, points_along
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.annotations.loose import is_free_end
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.growth import Grown, GrowthRules, grow_straight
from gaussiancad_core.sheet.ridges import RidgePoints
from gaussiancad_core.sheet.runs import ink_field

Floats = npt.NDArray[np.float64]

_HEAD = 10.0
"""Length of an arrowhead at most, in stroke widths."""

_UNBROKEN_PX = 2.0
"""Widest stretch without ridge points within ink that runs on."""

_SHORTEST = 5.0
"""Length of an extension line at least, in stroke widths."""

_SQUARE = 0.1
"""Cosine of the angle between a dimension line and its extension lines at most."""

_GOES_ON_PX = 1.0
"""px between a run and what it goes on as at most."""

_DASH = 3.0
"""Length of a dash at most, in the widest gap: what is longer may be the edge, which an extension
line leaves a gap to."""

_MET_PX = 2.5
"""px between a dimension line's end and its extension line at most."""


def mark_heads(shapes: Sequence[InkedShape], kinds: Kinds, stroke_width: float) -> None:
    """Give short arcs that run within the ink of an annotation its kind, in place.

    Args:
        shapes: lines and circles of the sheet.
        kinds: what each run is known to be.
        stroke_width: px.
    """
    lines = list(told_lines(shapes, kinds))
    for shape, own in zip(shapes, kinds, strict=True):
        if not isinstance(shape.geometry, Circle):
            continue
        for k, run in enumerate(shape.runs):
            if own[k] is not None or run.width is not None:
                continue
            if run.run.length > _HEAD * stroke_width:
                continue
            points = points_along(shape.geometry, run.run, 1.0)
            within = (kind for line, at, kind in lines if _covers(line, at, points, stroke_width))
            own[k] = next(within, None)


def mark_doubled(
    shapes: Sequence[InkedShape], kinds: Kinds, ink: Mask, weights: Weights, gap: float
) -> None:
    """Mark runs wider than extension lines that go on as one and end free, in place.

    Where such a run is an edge, others meet it at its end, or it goes on behind them in dashes; it
    is no wider than edges.

    Args:
        shapes: lines and circles of the sheet, cut where their width changes.
        kinds: what each run is known to be.
        ink: (h, w) bool, of the sheet.
        weights: of its lines.
        gap: px between the sheet's dashes at most.
    """
    for shape, own in zip(shapes, kinds, strict=True):
        if not isinstance(shape.geometry, Line):
            continue
        for k, (run, kind) in enumerate(zip(shape.runs, own, strict=True)):
            if kind is not None or run.width is None or run.width > weights.visible:
                continue
            for beside, end, outward in (
                (k + 1, run.run.start, -1.0),
                (k - 1, run.run.end, 1.0),
            ):
                if not 0 <= beside < len(own) or own[beside] is not AnnotationKind.EXTENSION:
                    continue
                near = shape.runs[beside].run
                apart = max(near.start - run.run.end, run.run.start - near.end)
                free = is_free_end(shape.geometry, end, outward, run.width, ink)
                free = free and not _is_dashed_on(shape.runs, 2 * k - beside, end, gap)
                if apart <= _GOES_ON_PX and free:
                    own[k] = AnnotationKind.EXTENSION


def _is_dashed_on(runs: Sequence[InkedRun], beyond: int, end: float, gap: float) -> bool:
    """Whether a run, if there is such a one, is a dash no farther from an end than dashes are."""
    if not 0 <= beyond < len(runs) or runs[beyond].run.length > _DASH * gap:
        return False
    run = runs[beyond].run
    return min(abs(run.start - end), abs(run.end - end)) <= gap


def told_lines(
    shapes: Sequence[InkedShape], kinds: Kinds
) -> Iterator[tuple[Line, InkedRun, AnnotationKind]]:
    """The straight runs that are annotations, and what each is."""
    for shape, own in zip(shapes, kinds, strict=True):
        if isinstance(shape.geometry, Line):
            for run, kind in zip(shape.runs, own, strict=True):
                if kind is not None:
                    yield shape.geometry, run, kind


def _covers(line: Line, run: InkedRun, points: Floats, stroke_width: float) -> bool:
    along, across = line.coordinates(points)
    inside = (along >= run.run.start - stroke_width) & (along <= run.run.end + stroke_width)
    return bool(inside.all() and (np.abs(across) <= stroke_width).all())


def extension_lines(
    sheet: CleanSheet,
    points: tuple[RidgePoints, npt.NDArray[np.bool_]],
    told: tuple[Sequence[InkedShape], Kinds],
    limit: float,
) -> list[InkedShape]:
    """Narrow straight ink of no shape at which the line of an annotation ends squarely.

    Args:
        sheet: with its letters taken off.
        points: all ridge points, and (n,) bool, which of them belong to no shape.
        told: shapes, and what each of their runs is known to be.
        limit: px under which a line is narrow.
    """
    ridges, free = points
    field = ink_field(sheet)
    rules = GrowthRules.of_width(sheet.stroke_width, sheet.dash_gap)
    rules = GrowthRules(
        _UNBROKEN_PX, rules.band, shortest=int(np.ceil(_SHORTEST * sheet.stroke_width))
    )
    ends = [
        (points[k], line.direction)
        for line, run, _ in told_lines(*told)
        for points in [points_along(line, run.run, run.run.length)]
        for k in (0, -1)
    ]
    found = []
    for grown in grow_straight(_only(ridges, free), rules):
        shape = inked_shape(sheet, field, ridges, _among(grown, free))
        narrow = len(shape.runs) == 1 and (shape.runs[0].width or 0.0) < limit
        if narrow and any(_meets(shape, *end) for end in ends):
            found.append(shape)
    return found


def _only(ridges: RidgePoints, chosen: npt.NDArray[np.bool_]) -> RidgePoints:
    """Some of the ridge points."""
    numbers = np.append(np.where(chosen, np.cumsum(chosen) - 1, -1), -1)
    return RidgePoints(
        ridges.points[chosen], ridges.tangents[chosen], numbers[ridges.index].astype(np.int32)
    )


def _among(grown: Grown, chosen: npt.NDArray[np.bool_]) -> Grown:
    """The same with its members numbered among all points."""
    return Grown(grown.geometry, np.flatnonzero(chosen)[grown.members])


def _meets(shape: InkedShape, end: Floats, direction: tuple[float, float]) -> bool:
    line, run = shape.geometry, shape.runs[0].run
    if abs(float(np.dot(line.direction, direction))) > _SQUARE:
        return False
    (along,), (across,) = line.coordinates(end[None])
    return abs(across) < _MET_PX and run.start - _MET_PX < along < run.end + _MET_PX
