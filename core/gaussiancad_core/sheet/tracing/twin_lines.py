"""Two hidden lines so close beside each other that little or no paper shows between their dashes.

All dashes of a sheet are drawn by one pen.  Where those of one line are all wider than the others,
by as much along each of them, they are two lines' dashes.  How much wider tells how far apart they
are while they overlap, and then the second moment of the ink across them: of two like strokes it is
that of one and the square of half their distance.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.dash_noise import FEWEST, LIKE_A_DASH
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import BLANK, COURSE, ONE_PLACE
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.view_shapes import Shape, ViewShapes
from gaussiancad_core.sheet.votes import HALF, LARGELY, MOST

Floats = npt.NDArray[np.float64]

_FEWEST_DASHES = 12
"""Dashes of a sheet from which the width of its pen is known."""

_STEADY_PX = 0.15
"""px from the median within which half of these widths lies at least: on copies they differ by
more."""

_PARALLEL = 0.99
"""Cosine of the angle between lines that run beside each other, at least."""

_REACH = 2.1
"""How far on either side of a line, in stroke widths, only its own ink is."""

_WIDER = 0.9
"""px by which the dashes of two lines are wider than those of one, at least."""

_TOUCHING = 0.95
"""Distance between two lines whose strokes touch, in the pen's widths."""

_NEAREST, _FARTHEST = 1.0, 2.0
"""px between two lines at least; and at most, in the pen's widths: farther apart paper shows."""


def with_twins(views: Sequence[ViewShapes], rhythm: Rhythm) -> list[ViewShapes]:
    """The views, with two lines in the place of one whose dashes are too wide for one.

    Args:
        views: shapes of all views of a sheet.
        rhythm: of the sheet's dashes.
    """
    measured = [[_dashes(view, shape, rhythm) for shape in view.shapes] for view in views]
    pen = _pen(measured)
    if pen is None:
        return list(views)
    return [
        replace(view, shapes=_parted(view, dashes, pen, rhythm))
        for view, dashes in zip(views, measured, strict=True)
    ]


@dataclass(frozen=True)
class DashPen:
    """The pen of a sheet's dashes.

    Attributes:
        ink: px across a dash.
        moment: px squared, the second one of its ink.
    """

    ink: float
    moment: float


def _pen(measured: Sequence[Sequence[Floats]]) -> DashPen | None:
    known = np.concatenate(
        [values for of_view in measured for values in of_view] or [np.empty((0, 3))]
    )
    known = known[np.isfinite(known[:, 0])]
    if len(known) < _FEWEST_DASHES:
        return None
    by_pen = np.abs(known[:, 0] - np.median(known[:, 0])) <= _STEADY_PX
    if by_pen.mean() < HALF:
        return None
    ink, moment, _ = (float(value) for value in np.median(known[by_pen], axis=0))
    return DashPen(ink, moment)


def _parted(
    view: ViewShapes, measured: Sequence[Floats], pen: DashPen, rhythm: Rhythm
) -> tuple[Shape, ...]:
    """The shapes of a view with those that are two lines as two."""
    bands = [_band(dashes, pen) for dashes in measured]
    twins = [_twins(index, bands, pen, view) for index in range(len(bands))]
    gone: set[int] = set()
    for index, found in enumerate(twins):
        if index not in gone:
            gone.update(found.others)
    kept = (found.shapes for k, found in enumerate(twins) if k not in gone)
    return tuple(chain.from_iterable(kept))


def _dashes(view: ViewShapes, shape: Shape, rhythm: Rhythm) -> Floats:
    """(n, 3) of a line's dashes the ink across them, px, its second moment, px squared, and how far
    its middle lies beside the line, px; NaN where other strokes are all along beside one."""
    line = shape.geometry
    if not isinstance(line, Line):
        return np.empty((0, 3))
    dashes = [run for run in shape.runs if abs(run.length / rhythm.dash - 1.0) < LIKE_A_DASH]
    return np.array([_ink_across(view.sheet, line, run) for run in dashes]).reshape(-1, 3)


def _ink_across(sheet: CleanSheet, line: Line, run: Run) -> tuple[float, float, float]:
    reach = _REACH * sheet.stroke_width + 1.0
    offsets = np.arange(-reach, reach + 0.25, 0.5)
    # The ends of a dash are half paper.
    along = np.arange(run.start + 2.0, run.end - 1.5, 1.0)
    unknown = (float("nan"),) * 3
    if not len(along):
        return unknown
    points, (dx, dy) = line.points_at(along), line.direction
    profile = sample(sheet.weight, points[:, :1] - dy * offsets, points[:, 1:] + dx * offsets)
    clear = (profile[:, :2] < BLANK).all(axis=1) & (profile[:, -2:] < BLANK).all(axis=1)
    if not clear.any():
        return unknown
    ink = np.median(profile[clear], axis=0)
    middle = np.average(offsets, weights=ink)
    moment = float(np.average((offsets - middle) ** 2, weights=ink))
    return float(ink.sum() * 0.5), moment, float(middle)


@dataclass(frozen=True)
class _Band:
    """The ink of a line's dashes, which are wider than the pen's.

    Attributes:
        ink: px across it.
        moment: px squared, the second one.
        middle: px beside the line.
    """

    ink: float
    moment: float
    middle: float


@dataclass(frozen=True)
class _Found:
    """A shape, or the two in its place, and the numbers of others that are of the same ink."""

    shapes: tuple[Shape, ...]
    others: tuple[int, ...] = ()


def _band(dashes: Floats, pen: DashPen) -> _Band | None:
    """The band that dashes make; None if they are one line's.

    Args:
        dashes: (n, 3) of a shape, as :func:`_dashes` gives them.
        pen: of dashes of single lines.
    """
    known = dashes[np.isfinite(dashes[:, 0])]
    if len(known) < max(FEWEST, MOST * len(dashes)):
        return None
    ink, moment, middle = (float(value) for value in np.median(known, axis=0))
    even = float(np.abs(known[:, 0] - ink).max()) <= COURSE
    if not even or ink - pen.ink < _WIDER or moment <= pen.moment:
        return None
    return _Band(ink, moment, middle)


def _twins(index: int, bands: Sequence[_Band | None], pen: DashPen, view: ViewShapes) -> _Found:
    """A shape of a view, or the two in its place."""
    shape, band = view.shapes[index], bands[index]
    if band is None:
        return _Found((shape,))
    apart = 2.0 * float(np.sqrt(band.moment - pen.moment))
    # Strokes that overlap are one wide one.
    apart = apart if apart > _TOUCHING * pen.ink else float(band.ink - pen.ink)
    if not _NEAREST <= apart <= _FARTHEST * pen.ink:
        return _Found((shape,))
    # Lines may have been grown along both, but not where they lie: each has the other's ink, too.
    neighbours = list(_parallel_lines(shape, view))
    others = [
        k
        for k, across in neighbours
        if abs(across - 2.0 * band.middle) <= ONE_PLACE and _keeps_pace(view.shapes[k], shape)
    ]
    if len(others) < len(neighbours) or (others and abs(band.middle) < 0.25 * apart):
        return _Found((shape,))
    line = shape.line
    normal = np.array([-line.direction[1], line.direction[0]])
    middle = np.array(line.point) + band.middle * normal
    pair = [
        replace(shape, geometry=Line((float(x), float(y)), line.direction), close=True, twin=True)
        for x, y in (middle - 0.5 * apart * normal, middle + 0.5 * apart * normal)
    ]
    return _Found(tuple(pair), tuple(others))


def _keeps_pace(other: Shape, shape: Shape) -> bool:
    """Whether a line has as many runs as another, as far as it goes: beside an edge it has not."""
    length, its = (
        this_shape.runs[-1].end - this_shape.runs[0].start for this_shape in (shape, other)
    )
    alike = len(other.runs) >= HALF * len(shape.runs)
    return alike and its <= length / LARGELY


def _parallel_lines(shape: Shape, view: ViewShapes) -> Iterator[tuple[int, float]]:
    """The numbers of lines that run so near beside a line that their ink was measured with that of
    most of its dashes, and px from the one to the other, as the ink's middle is counted."""
    line, near = shape.line, (_REACH + 1.0) * view.sheet.stroke_width + 1.0
    pair = shape.runs[0].start, shape.runs[-1].end
    for index, other in enumerate(view.shapes):
        if other is shape or not isinstance(other.geometry, Line) or not other.runs:
            continue
        if abs(float(np.dot(other.geometry.direction, line.direction))) < _PARALLEL:
            continue
        ends = np.array([other.runs[0].start, other.runs[-1].end])
        along, across = line.coordinates(other.geometry.points_at(ends))
        shared = min(along.max(), pair[1]) - max(along.min(), pair[0])
        # What is beside a few of the dashes makes these wider than the others.
        if shared > HALF * (pair[1] - pair[0]) and np.abs(across).min() < near:
            yield index, float(across.mean())
