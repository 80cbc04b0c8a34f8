"""Hidden lines so short that one dash of them is seen, as of a bore through a thin plate.

A narrow line that begins at an edge is an extension line, or the first dash of a hidden line.  An
extension line leads to a dimension line and ends beyond it; a dash ends a gap before the next ink.
Dashes of two edges that go on as each other are as long as extension lines, but touch nothing, and
so do two dashes that meet in a corner of a pocket.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.corner_pieces import is_dash_corner
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape, points_along
from gaussiancad_core.sheet.annotations.lines import Weights
from gaussiancad_core.sheet.annotations.marks import Mask, values_at
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Rhythm, learn_rhythm

Floats = npt.NDArray[np.float64]

_LONGEST = 1.3
"""Length of a dash at most, in the sheet's usual ones: an edge that it meets makes it longer."""

_TWO = 2.2
"""Dashes that a piece of ink is long at most of which one goes on as another."""

_DOT = 0.6
"""Length of a dash at least, in the sheet's usual ones: the dots of centre marks are shorter."""

_LEAN = 1.5
"""Ink of a straight piece at most, in stroke widths times its length."""

_GAP = 1.4
"""Gap before the next ink at most, in the sheet's usual ones."""

_MET_PX = 2.5
"""px between a dash and the axis of an edge that it meets at most, beyond half a stroke."""

_ALONG, _SLANTED = 0.02, 0.3
"""Sine of the angle between a line and the sheet's axes at most, for it to be along one, and at
least, for it to be slanted."""

_ASIDE_PX = 0.5
"""px by which what is along an axis may leave it: of a dash, that is more than such an angle."""

_SLACK_PX = 2.0
"""px by which ink at a run's end may be taken for its own, or not."""


def spare_lone_dashes(
    shapes: Sequence[InkedShape], kinds: Kinds, ink: Mask, weights: Weights, stroke_width: float
) -> None:
    """Take back what was told of dashes that have no others beside them, in place.

    Args:
        shapes: lines and circles of the sheet.
        kinds: what each run is known to be.
        ink: (h, w) bool, of the part as far as it is known.
        weights: of wide and narrow lines.
        stroke_width: px, the mean over the sheet.
    """
    edges = _edge_points(shapes, weights.limit)
    if not len(edges):
        return
    rhythm = _rhythm(shapes, kinds, stroke_width)
    tree = cKDTree(edges)
    corners = _corner_dashes(shapes, kinds, weights.limit, rhythm)
    leaving: list[tuple[int, int]] = []
    for number, (shape, own) in enumerate(zip(shapes, kinds, strict=True)):
        if not isinstance(shape.geometry, Line):
            continue
        for k, run in enumerate(shape.runs):
            # The lines of a centre mark are told by their places, however short they are.
            if own[k] is not AnnotationKind.EXTENSION:
                continue
            lone = _is_lone(shape.runs, k, rhythm)
            if lone and _leads_on(shape.geometry, run, ink, tree, (rhythm, stroke_width)):
                own[k] = None
                continue
            # It seems longer by the ink of the dashes that it meets.
            lone = _is_lone(shape.runs, k, rhythm, stroke_width)
            near = _MET_PX + max(stroke_width, rhythm.gap)
            if lone and _leaves_corner(shape.geometry, run, corners, near):
                leaving.append((number, k))
    _spare_leaving(shapes, kinds, leaving, stroke_width)


def _spare_leaving(
    shapes: Sequence[InkedShape],
    kinds: Kinds,
    leaving: Sequence[tuple[int, int]],
    stroke_width: float,
) -> None:
    """Take back what was told of runs (shape, run) that leave corners of hidden lines, in place,
    where no annotation but these ends beside them: two may leave one corner."""
    if not leaving:
        return
    told = [np.empty((0, 2))]
    for number, (shape, own) in enumerate(zip(shapes, kinds, strict=True)):
        for k, (run, kind) in enumerate(zip(shape.runs, own, strict=True)):
            if kind is not None and (number, k) not in leaving:
                told.append(points_along(shape.geometry, run.run, 1.0))
    others = np.concatenate(told)
    for number, k in leaving:
        shape = shapes[number]
        if _is_clear(shape.geometry, shape.runs[k], others, stroke_width):
            kinds[number][k] = None


def spare_free_dashes(
    shapes: Sequence[InkedShape], kinds: Kinds, ink: Mask, stroke_width: float
) -> None:
    """Take back what was told of pieces of ink that touch nothing, in place.

    They are two dashes long at most: the last one of an edge and the first of the next, or of a
    circle where it closes.  An extension line has a dimension line across it.

    Args:
        shapes: lines and circles of a sheet with dashes.
        kinds: what each run is known to be.
        ink: (h, w) bool, of all that is drawn.
        stroke_width: px, the mean over the sheet.
    """
    rhythm = _rhythm(shapes, kinds, stroke_width)
    dash = rhythm.dash
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    for shape, own in zip(shapes, kinds, strict=True):
        for k, run in enumerate(shape.runs):
            length = run.run.length
            if own[k] is not AnnotationKind.EXTENSION or not _DOT * dash < length <= _TWO * dash:
                continue
            points = points_along(shape.geometry, run.run, 1.0)
            piece = int(values_at(labels, points[len(points) // 2][None])[0])
            whole = stats[piece]
            size = float(np.hypot(whole[cv2.CC_STAT_WIDTH], whole[cv2.CC_STAT_HEIGHT]))
            # Centre marks are crosses, which have twice the ink of either stroke.
            lean = whole[cv2.CC_STAT_AREA] <= _LEAN * stroke_width * length
            free = lean and size <= length + 2.0 * stroke_width + _SLACK_PX
            short = piece and max(whole[2:4]) <= _LONGEST * dash + stroke_width + _SLACK_PX
            if free or (
                short and is_dash_corner(labels, whole, piece, stroke_width, _GAP * rhythm.gap)
            ):
                own[k] = None


def longest_dash(shapes: Sequence[InkedShape], kinds: Kinds, stroke_width: float) -> float:
    """px, the length of a sheet's dashes at most."""
    return _LONGEST * _rhythm(shapes, kinds, stroke_width).dash


def _edge_points(shapes: Sequence[InkedShape], limit: float) -> Floats:
    """(n, 2) px on the axes of wide runs."""
    wide = [
        points_along(shape.geometry, run.run, 1.0)
        for shape in shapes
        for run in shape.runs
        if run.width is not None and run.width >= limit
    ]
    return np.concatenate(wide) if wide else np.empty((0, 2))


def _rhythm(shapes: Sequence[InkedShape], kinds: Kinds, stroke_width: float) -> Rhythm:
    series = [
        [run.run for run, kind in zip(shape.runs, own, strict=True) if kind is None]
        for shape, own in zip(shapes, kinds, strict=True)
    ]
    return learn_rhythm(series, stroke_width)


def _is_lone(runs: Sequence[InkedRun], k: int, rhythm: Rhythm, more: float = 0.0) -> bool:
    """Whether a run is as short as a dash and so many px, and no other of its line is near."""
    run, near = runs[k].run, 2.0 * _GAP * rhythm.gap
    before = k > 0 and run.start - runs[k - 1].run.end < near
    after = k + 1 < len(runs) and runs[k + 1].run.start - run.end < near
    return run.length <= _LONGEST * rhythm.dash + more and not before and not after


def _leads_on(
    line: Line, run: InkedRun, ink: Mask, edges: cKDTree, sizes: tuple[Rhythm, float]
) -> bool:
    """Whether one end of a run meets an edge, and ahead of the other one is ink, or both do."""
    rhythm, stroke_width = sizes
    met = _MET_PX + stroke_width / 2.0
    ends = [(run.run.start, -1.0), (run.run.end, 1.0)]
    meets = [edges.query(np.array(line.at(place)))[0] <= met for place, _ in ends]
    ahead = np.arange(_SLACK_PX, _GAP * rhythm.gap + _SLACK_PX, 0.5)
    inked = [
        _inked(np.array([line.at(place + way * step) for step in ahead]).reshape(-1, 2), ink)
        for place, way in ends
    ]
    return any(meets) and all(one or other for one, other in zip(meets, inked, strict=True))


@dataclass(frozen=True, eq=False)
class _Dashes:
    """The narrow dashes of a sheet along its axes.

    Attributes:
        level, upright: (n, 2) px, where they end.
    """

    level: Floats
    upright: Floats


def _corner_dashes(
    shapes: Sequence[InkedShape], kinds: Kinds, limit: float, rhythm: Rhythm
) -> _Dashes:
    ends = [np.empty((0, 2))], [np.empty((0, 2))]
    for shape, own in zip(shapes, kinds, strict=True):
        if _slant(shape) >= _ALONG:
            continue
        for run, kind in zip(shape.runs, own, strict=True):
            narrow = run.width is not None and run.width < limit
            if kind is None and narrow and run.run.length <= _LONGEST * rhythm.dash:
                upright = abs(shape.geometry.direction[1]) > abs(shape.geometry.direction[0])
                points = points_along(shape.geometry, run.run, run.run.length)[[0, -1]]
                ends[int(upright)].append(points)
    return _Dashes(np.concatenate(ends[0]), np.concatenate(ends[1]))


def _slant(shape: InkedShape) -> float:
    """Sine of the angle between a line and the nearer of the sheet's axes; circles have most."""
    return min(map(abs, shape.geometry.direction)) if isinstance(shape.geometry, Line) else 1.0


def _leaves_corner(line: Line, run: InkedRun, dashes: _Dashes, near: float) -> bool:
    """Whether a run begins so many px from where a hidden line across it ends, or along an axis if
    it is slanted, as that of a countersink is."""
    right, down = (abs(part) for part in line.direction)
    if max(_ALONG, _ASIDE_PX / run.run.length) < min(right, down) < _SLANTED:
        return False
    across = [dashes.upright] * (down < _SLANTED) + [dashes.level] * (right < _SLANTED)
    ends = points_along(line, run.run, run.run.length)[[0, -1]]
    corners = np.concatenate(across or [dashes.level, dashes.upright])
    return bool(len(corners)) and float(cKDTree(corners).query(ends)[0].min()) <= near


def _is_clear(line: Line, run: InkedRun, others: Floats, stroke_width: float) -> bool:
    """Whether none of the annotations, (n, 2) px, is at either end of a run."""
    ends = points_along(line, run.run, run.run.length)[[0, -1]]
    near = _MET_PX + stroke_width
    return not len(others) or float(cKDTree(others).query(ends)[0].min()) > near


def _inked(places: Floats, ink: Mask) -> bool:
    columns, rows = np.rint(places).astype(int).T
    inside = (columns >= 0) & (rows >= 0) & (columns < ink.shape[1]) & (rows < ink.shape[0])
    return bool(ink[rows[inside], columns[inside]].any())
