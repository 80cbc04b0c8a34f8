"""Two hidden lines so close beside each other that no paper shows between their dashes.

All dashes of a sheet are drawn by one pen.  Where those of one line are all wider than the others,
by as much along each of them, they are two lines' dashes.  How much wider tells how far apart they
are while they overlap, and then the second moment of the ink across them: of two like strokes it is
that of one and the square of half their distance.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Rhythm, Run
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.sheet.uneven_twins import uneven_twins
from gaussiancad_core.sheet.view_shapes import Shape, ViewShapes

Floats = npt.NDArray[np.float64]

_LIKE_A_DASH = 0.35
"""Share by which a dash may be longer or shorter than the sheet's."""

_FEWEST_DASHES = 12
"""Dashes of a sheet from which the width of its pen is known."""

_STEADY_PX, _STEADY = 0.15, 0.5
"""px from the median within which a share of these widths lies at least: on copies they differ by
more."""

_OF_ONE_LINE, _MEASURED = 3, 0.6
"""Dashes of a line at least, and the share of them whose width is known."""

_EVEN_PX = 0.35
"""px by which the dashes of two lines differ in width at most."""

_PARALLEL = 0.99
"""Cosine of the angle between lines that run beside each other, at least."""

_SAME = 0.5
"""px between two lines that are one."""

_REACH, _BLANK = 1.8, 0.1
"""How far on either side of a line, in stroke widths, only its own ink is; ink of paper."""

_WIDER = 0.9
"""px by which the dashes of two lines are wider than those of one, at least."""

_TOUCHING = 0.95
"""Distance between two lines whose strokes touch, in the pen's widths."""

_NEAREST, _FARTHEST = 1.0, 1.6
"""px between two lines at least; and at most, in the pen's widths: farther apart paper shows."""


def with_twins(views: Sequence[ViewShapes], rhythm: Rhythm) -> list[ViewShapes]:
    """The views, with two lines in the place of one whose dashes are too wide for one.

    Args:
        views: shapes of all views of a sheet.
        rhythm: of the sheet's dashes.
    """
    measured = [[_dashes(view, shape, rhythm) for shape in view.shapes] for view in views]
    known = np.concatenate([own for of_view in measured for own in of_view] or [np.empty((0, 2))])
    known = known[np.isfinite(known[:, 0])]
    if len(known) < _FEWEST_DASHES:
        return list(views)
    by_pen = np.abs(known[:, 0] - np.median(known[:, 0])) <= _STEADY_PX
    if by_pen.mean() < _STEADY:
        return list(views)
    pen = np.median(known[by_pen], axis=0)
    return [
        replace(view, shapes=_parted(view, dashes, pen, rhythm))
        for view, dashes in zip(views, measured, strict=True)
    ]


def _parted(
    view: ViewShapes, measured: Sequence[Floats], pen: Floats, rhythm: Rhythm
) -> tuple[Shape, ...]:
    """The shapes of a view with those that are two lines as two."""
    shapes: list[Shape] = []
    pairs: list[tuple[Shape, Shape]] = []
    for shape, dashes in zip(view.shapes, measured, strict=True):
        for even in _twins(shape, dashes, pen, view):
            pair = uneven_twins(even, view.sheet, float(pen[0]), rhythm)
            # Ink that goes to and fro gives several lines, one of which is enough.
            if pair is None or not any(_is_same(pair, other) for other in pairs):
                shapes += pair or (even,)
            if pair is not None:
                pairs.append(pair)
    return tuple(shapes)


def _is_same(pair: tuple[Shape, Shape], other: tuple[Shape, Shape]) -> bool:
    """Whether two lines are another two."""
    return all(
        any(
            theirs.geometry.distances(
                own.geometry.points_at(np.array([own.runs[0].start, own.runs[-1].end]))
            ).max()
            < _SAME
            for theirs in other
        )
        for own in pair
    )


def _dashes(view: ViewShapes, shape: Shape, rhythm: Rhythm) -> Floats:
    """(n, 2) of a line's dashes the ink across them, px, and its second moment, px squared; NaN
    where other strokes are all along beside one."""
    line = shape.geometry
    if not isinstance(line, Line):
        return np.empty((0, 2))
    dashes = [run for run in shape.runs if abs(run.length / rhythm.dash - 1.0) < _LIKE_A_DASH]
    return np.array([_ink_across(view.sheet, line, run) for run in dashes]).reshape(-1, 2)


def _ink_across(sheet: CleanSheet, line: Line, run: Run) -> tuple[float, float]:
    reach = _REACH * sheet.stroke_width + 1.0
    offsets = np.arange(-reach, reach + 0.25, 0.5)
    # The ends of a dash are half paper.
    along = np.arange(run.start + 2.0, run.end - 1.5, 1.0)
    if not len(along):
        return float("nan"), float("nan")
    points, (dx, dy) = line.points_at(along), line.direction
    profile = sample(sheet.weight, points[:, :1] - dy * offsets, points[:, 1:] + dx * offsets)
    clear = (profile[:, :2] < _BLANK).all(axis=1) & (profile[:, -2:] < _BLANK).all(axis=1)
    if not clear.any():
        return float("nan"), float("nan")
    ink = np.median(profile[clear], axis=0)
    middle = np.average(offsets, weights=ink)
    return float(ink.sum() * 0.5), float(np.average((offsets - middle) ** 2, weights=ink))


def _twins(shape: Shape, dashes: Floats, pen: Floats, view: ViewShapes) -> list[Shape]:
    """The shape, or the two in its place.

    Args:
        shape: of a view.
        dashes: (n, 2) of the shape, as :func:`_dashes` gives them.
        pen: (2,) of dashes of single lines.
        view: of the shape.
    """
    known = dashes[np.isfinite(dashes[:, 0])]
    if len(known) < max(_OF_ONE_LINE, _MEASURED * len(dashes)):
        return [shape]
    ink, moment = np.median(known, axis=0)
    even = float(np.abs(known[:, 0] - ink).max()) <= _EVEN_PX
    if not even or ink - pen[0] < _WIDER or moment <= pen[1]:
        return [shape]
    apart = 2.0 * float(np.sqrt(moment - pen[1]))
    # Strokes that overlap are one wide one.
    apart = apart if apart > _TOUCHING * pen[0] else float(ink - pen[0])
    if not _NEAREST <= apart <= _FARTHEST * pen[0] or _has_neighbour(shape, view):
        return [shape]
    line = shape.geometry
    normal = np.array([-line.direction[1], line.direction[0]])
    middle = np.array(line.point)
    return [
        replace(shape, geometry=Line((float(x), float(y)), line.direction), close=True, twin=True)
        for x, y in (middle - 0.5 * apart * normal, middle + 0.5 * apart * normal)
    ]


def _has_neighbour(shape: Shape, view: ViewShapes) -> bool:
    """Whether another line runs so near beside a line that its ink was measured as well."""
    line, near = shape.geometry, 2.0 * _REACH * view.sheet.stroke_width
    own = shape.runs[0].start, shape.runs[-1].end
    for other in view.shapes:
        if other is shape or not isinstance(other.geometry, Line) or not other.runs:
            continue
        if abs(float(np.dot(other.geometry.direction, line.direction))) < _PARALLEL:
            continue
        ends = np.array([other.runs[0].start, other.runs[-1].end])
        along, across = line.coordinates(other.geometry.points_at(ends))
        if along.max() > own[0] and along.min() < own[1] and np.abs(across).min() < near:
            return True
    return False
