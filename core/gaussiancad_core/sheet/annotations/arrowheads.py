"""Arrowheads that are blots, thicker than any line: they tell dimension lines.

Slim ones, which are no blots, :mod:`gaussiancad_core.sheet.annotations.tapers` tells.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape, points_along
from gaussiancad_core.sheet.annotations.marks import Mark, Mask, values_at
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

_THICK = 0.95
"""Half width of an arrowhead at least, in widths of a line; where two lines cross it is 0.7."""

_THICKEST = 1.4
"""Half width of a blot that is an arrowhead wherever it lies on a line; where three lines meet at
sharp angles it is about one."""

_FROM_TIP = 2.5
"""Distance of other heads' middles from the end of their line at least, in widths of it; leaders
have such heads, and level lines blots where two others cross them."""

_ON_OTHER, _OTHER = 0.6, 6.0
"""Distance of another line from a blot at most, and length of it at least, in widths of a line, for
the blot to be where both meet: the middle of a head lies before the line that it points to."""

_NEARER = 1.5
"""Stroke widths by which another line ends nearer to a blot's middle for it to be that one's head:
dimension lines end at dots beyond which extension lines go on."""

_WRITING = 5.0
"""Distance of a line with one head from its writing at most, in heights of letters."""

_LARGEST = 12.0
"""Length of an arrowhead's thick part at most, in widths of a line."""

_BESIDE = 0.7
"""Distance of an arrowhead's middle from its line at most, in widths of a line."""

_SLANTED = 0.05
"""Sine of the angle between a slanted line and the sheet's axes at least."""

_FLANK = 1.0
"""Distance from a line's middle at which an arrowhead is ink on both sides, in widths of a line."""


@dataclass(frozen=True, eq=False)
class Arrowheads:
    """The thick blots that arrowheads have.

    Attributes:
        middles: (n, 2) px.
        lengths: (n,) px, the longest side of each blot.
        widest: (n,) px, half the width of each blot.
    """

    middles: npt.NDArray[np.float64]
    lengths: npt.NDArray[np.float64]
    widest: npt.NDArray[np.float64]


def arrowheads(ink: Mask, stroke_width: float) -> Arrowheads:
    """Thick blots no larger than the heads of arrows."""
    inside = cv2.distanceTransform(ink.astype(np.uint8), cv2.DIST_L2, 5)
    core = (inside > _THICK * stroke_width).astype(np.uint8)
    count, labels, stats, middles = cv2.connectedComponentsWithStats(core, connectivity=8)
    sides = stats[1:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1).astype(float)
    widest = np.zeros(count)
    np.maximum.at(widest, labels[core > 0], inside[core > 0])
    small = sides <= _LARGEST * stroke_width
    return Arrowheads(middles[1:][small], sides[small], widest[1:][small])


def mark_arrows(
    shapes: list[InkedShape],
    kinds: Kinds,
    heads: Arrowheads,
    ink: Mask,
    stroke_width: float,
    *,
    letters: Sequence[Mark],
) -> None:
    """Mark straight runs with arrowheads on them as dimension lines, in place.

    One alone counts at an end where writing is near, and so do two that are no thicker than where
    three strokes meet on a slanted edge: ink that ran makes blots like them.  A large head has no
    ridge along its middle, so that its line ends behind it; the run then goes on as far as the
    middle of the head.

    Args:
        shapes: lines and circles of a sheet.
        kinds: what each run is known to be.
        heads: the sheet's thick blots.
        ink: (h, w) bool.
        stroke_width: px.
        letters: the sheet's writing.
    """
    if not len(heads.middles):
        return
    near_writing = NearWriting(letters)
    crossed = _lines_through(shapes, heads.middles, stroke_width)
    nearest = _nearest_ends(shapes, heads.middles, stroke_width)
    for index, (shape, own) in enumerate(zip(shapes, kinds, strict=True)):
        if not isinstance(shape.geometry, Line):
            continue
        along, across = shape.geometry.coordinates(heads.middles)
        on_line = np.abs(across) < _BESIDE * stroke_width
        on_line[on_line] = _flanked(shape.geometry, along[on_line], ink, _FLANK * stroke_width)
        near, half = along[on_line], heads.lengths[on_line] / 2
        thick = heads.widest[on_line] >= _THICKEST * stroke_width
        free = crossed[on_line] < 2
        slanted = min(map(abs, shape.geometry.direction)) > _SLANTED
        slack = 2.0 * stroke_width
        runs = list(shape.runs)
        for k, run in enumerate(shape.runs):
            low, high = run.run.start - slack, run.run.end + slack
            reached = (near >= low - half) & (near <= high + half)
            inside = np.minimum(near - run.run.start, run.run.end - near)
            reached &= thick | (slanted & free & (inside > _FROM_TIP * stroke_width))
            reached &= np.abs(inside) <= nearest[on_line] + _NEARER * stroke_width
            on_run = near[reached]
            from_end = np.minimum(on_run - low, high - on_run)
            sure = int((reached & thick).sum()) > 1
            at_end = len(on_run) > 1 or (from_end < _LARGEST * stroke_width).any()
            if own[k] is None and (sure or (at_end and near_writing(shape, run))):
                own[k] = AnnotationKind.DIMENSION
                whole = Run(min(run.run.start, *on_run), max(run.run.end, *on_run))
                runs[k] = InkedRun(whole, run.width)
        shapes[index] = InkedShape(shape.geometry, tuple(runs))


class NearWriting:
    """Whether a run has writing near it, as far as a leader's is from its line."""

    def __init__(self, letters: Sequence[Mark]) -> None:
        boxes = np.array([mark.box for mark in letters], float).reshape(-1, 4)
        self._low, self._high = boxes[:, :2], boxes[:, 2:]
        sides = (self._high - self._low).min(axis=1)
        self._reach = _WRITING * float(np.median(sides)) if len(boxes) else 0.0

    def __call__(self, shape: InkedShape, run: InkedRun) -> bool:
        """Whether some writing is near a run of a shape."""
        if not len(self._low):
            return False
        points = points_along(shape.geometry, run.run, 1.0)[:, None]
        beside = np.maximum(np.maximum(self._low - points, points - self._high), 0.0)
        return bool(np.hypot(beside[..., 0], beside[..., 1]).min() <= self._reach)


def _lines_through(
    shapes: list[InkedShape], places: npt.NDArray[np.float64], stroke_width: float
) -> npt.NDArray[np.int64]:
    """(n,) how many long lines run through places (n, 2), or end at them."""
    count = np.zeros(len(places), dtype=int)
    near = _ON_OTHER * stroke_width
    for shape in shapes:
        if not isinstance(shape.geometry, Line):
            continue
        along, across = shape.geometry.coordinates(places)
        reached = np.zeros(len(places), dtype=bool)
        for own in shape.runs:
            if own.run.length >= _OTHER * stroke_width:
                reached |= (along > own.run.start - near) & (along < own.run.end + near)
        count += reached & (np.abs(across) < near)
    return count


def _nearest_ends(
    shapes: list[InkedShape], places: npt.NDArray[np.float64], stroke_width: float
) -> npt.NDArray[np.float64]:
    """(n,) px along it from places (n, 2) to the end of the line through them that ends nearest.

    It is inf where none but short ones run there, or none ends within a stroke width.
    """
    nearest = np.full(len(places), np.inf)
    for shape in shapes:
        if not isinstance(shape.geometry, Line):
            continue
        along, across = shape.geometry.coordinates(places)
        for own in shape.runs:
            away = np.minimum(np.abs(along - own.run.start), np.abs(along - own.run.end))
            ends = (np.abs(across) < _BESIDE * stroke_width) & (away < stroke_width)
            if own.run.length >= _OTHER * stroke_width:
                nearest = np.where(ends, np.minimum(nearest, away), nearest)
    return nearest


def _flanked(
    line: Line, along: npt.NDArray[np.float64], ink: Mask, away: float
) -> npt.NDArray[np.bool_]:
    """(n,) whether ink lies on both sides of a line at positions along it."""
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    places = np.array(line.point) + along[:, None] * direction
    return values_at(ink, places + away * normal) & values_at(ink, places - away * normal)
