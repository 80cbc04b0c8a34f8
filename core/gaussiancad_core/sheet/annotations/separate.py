"""A sheet taken apart: the part's ink, and the annotations."""

from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.arrowheads import arrowheads, mark_arrows
from gaussiancad_core.sheet.annotations.centre_marks import mark_centre_marks
from gaussiancad_core.sheet.annotations.dash_pens import spare_by_pen
from gaussiancad_core.sheet.annotations.erase import Told, erased, masked
from gaussiancad_core.sheet.annotations.frame import find_frame
from gaussiancad_core.sheet.annotations.hatching import find_hatching
from gaussiancad_core.sheet.annotations.inked import (
    InkedShape,
    inked_shape,
    points_along,
    split_by_width,
)
from gaussiancad_core.sheet.annotations.leader_tips import mark_leaders, with_clear_tips
from gaussiancad_core.sheet.annotations.led_out import mark_led_out
from gaussiancad_core.sheet.annotations.left_heads import without_heads
from gaussiancad_core.sheet.annotations.letter_boxes import letter_boxes
from gaussiancad_core.sheet.annotations.lettered_lines import mark_lettered
from gaussiancad_core.sheet.annotations.line_ends import (
    extension_lines,
    mark_doubled,
    mark_heads,
)
from gaussiancad_core.sheet.annotations.lines import (
    Weights,
    kinds_of_runs,
    line_weights,
    widest_gap,
)
from gaussiancad_core.sheet.annotations.lone_dashes import (
    longest_dash,
    spare_free_dashes,
    spare_lone_dashes,
)
from gaussiancad_core.sheet.annotations.lone_marks import mark_lone_marks
from gaussiancad_core.sheet.annotations.loose import (
    LooseRule,
    lettered_boxes,
    split_loose,
)
from gaussiancad_core.sheet.annotations.marks import Mark, Mask, line_mark
from gaussiancad_core.sheet.annotations.short_rows import spare_short_rows
from gaussiancad_core.sheet.annotations.tangent_ends import without_slivers
from gaussiancad_core.sheet.annotations.tapers import mark_tapered
from gaussiancad_core.sheet.annotations.text import find_letters
from gaussiancad_core.sheet.annotations.virtual_corners import mark_virtual_corners
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle
from gaussiancad_core.sheet.growth import Grown, GrowthRules, grow_shapes
from gaussiancad_core.sheet.labels.evidence import NO_LABELS, SheetLabels
from gaussiancad_core.sheet.ridges import RidgePoints, ridge_points
from gaussiancad_core.sheet.runs import ink_field
from gaussiancad_core.sheet.special_views.halves import with_open_sides

_LETTER_SHARE = 0.04
"""Shapes longer than this share of the sheet's longest side are no parts of letters."""

_DIMENSIONS = AnnotationKind.DIMENSION, AnnotationKind.LEADER
"""What extension lines and leaders come with."""

_WHOLE = 0.85
"""Share of a circle that is drawn at least, for it to be one by itself."""

_DASHED = 0.45
"""Share of a dashed shape that is ink at least: a line that meets letters by chance has less."""

_DIRECTIONS = 48
"""Sectors of a circle."""

_LOOP = 0.36
"""Radius of a circle as a share of its piece of ink: a loop of a letter has less."""

_DASHES = 3
"""Pieces of ink from which a shape is dashed."""

_LONGEST_DASH = 8.0
"""Length of a dash at most, in stroke widths."""

_GAPS = 1.2
"""Gap between dashes at most, in the sheet's usual ones."""

_SHORTEST_MARK = 16.0
"""Length of a centre mark that sticks out of a view at least, in stroke widths."""


_WIDEST_FADED = 3.0
"""Half of the gap in a faded outline that does not open it, in stroke widths."""

_CURVE = 6.0
"""Length from which ridge points that no shape explains are a stroke, in widths of it."""

_ROUNDED_PX = 1.25
"""Least difference of wide and narrow lines on sheets without grey: lines of one width have as many
whole px as their places make of it."""

_GREY = (0.15, 0.85)
"""Darkness between paper and ink."""

_LEAST_GREY = 0.05
"""Share of the ink that is grey at least, where edges of strokes are smooth."""


@dataclass(frozen=True, eq=False)
class SeparatedSheet:
    """A sheet without its annotations.

    Attributes:
        part: the sheet with the part's ink alone.
        marks: what was taken off.
        by_weight: whether narrow lines were told from wide ones.
        hatched: (h, w) bool, cut material; nothing where there is none.
        told: the lines and circles, and what each is; nothing where they were not looked at.
        closed: whether outlines were taken to have no gaps.
        labels: what each line was taken for, and how surely; nothing where no labels told it.
    """

    part: CleanSheet
    marks: tuple[Mark, ...]
    by_weight: bool
    hatched: Mask | None = None
    told: Told | None = None
    closed: bool = False
    labels: SheetLabels = NO_LABELS


def separate_annotations(
    sheet: CleanSheet, by_weight: bool = True, closed: bool = True
) -> SeparatedSheet:
    """Take frame, title block, writing, hatching, dimensions and centre lines off a sheet.

    Args:
        sheet: upright.
        by_weight: whether narrow lines may be told from wide ones; without it, and where all lines
            are of one width, dimensions are told by their arrowheads.
        closed: whether outlines of views have no gaps on a plotted sheet, so that there what has
            the paper around the views on both sides is known to be no edge.
    """
    marks: list[Mark] = []
    frame = find_frame(sheet.ink, sheet.turn)
    if frame is not None:
        sheet = masked(sheet, frame.drawing_area)
        marks += frame.marks
    ridges = ridge_points(sheet.weight, sheet.stroke_width)
    grown = grow_shapes(ridges, GrowthRules.of_width(sheet.stroke_width, sheet.dash_gap))
    letters = find_letters(sheet.ink, _explained(ridges, grown, sheet.ink), sheet.stroke_width)
    marks += letters.marks
    if letters.marks:
        grown = [shape for shape in grown if not _in_letters(shape, ridges, letters.mask)]
        sheet = masked(sheet, cv2.dilate(letters.mask.astype(np.uint8), np.ones((5, 5))) == 0)
    field = ink_field(sheet)
    shapes = [inked_shape(sheet, field, ridges, shape) for shape in grown]
    hatching = find_hatching(sheet, shapes, ridges, _free(ridges, grown))
    unexplained = _pixels(ridges, _free(ridges, grown), letters.mask)
    if hatching.marks:
        marks += hatching.marks
        loose = _pixels(ridges, hatching.loose, letters.mask)
        unexplained &= ~loose
        # Beside other strokes, a point of a line may be one of theirs.
        loose &= ~_wide_curves(unexplained, 2.0 * sheet.stroke_width)
        shorter = hatching.shortened(shapes, 0.5 * sheet.stroke_width)
        # Hatching ends at strokes of which no one says yet what they are: all of their width stays.
        curves = unexplained | _wide_curves(unexplained, sheet.stroke_width)
        told = Told(shorter, hatching.kinds(shapes), curves, loose)
        sheet = erased(sheet, told)
        shapes = hatching.others(shapes)
    weights = _weights(sheet, shapes) if by_weight else Weights(sheet.stroke_width, 0.0)
    shapes = _cut(sheet, shapes, weights)
    kinds = kinds_of_runs(shapes, weights, sheet.stroke_width, _GAPS * sheet.dash_gap)
    mark_centre_marks(shapes, kinds, sheet)
    if weights.limit:
        _tell_line_ends(sheet, ridges, Told(shapes, kinds, unexplained), weights, letters.marks)
    part = sheet
    if letters.marks and not weights.limit:
        told, boxes = _told_by_form(
            sheet, Told(shapes, kinds, unexplained), letters.marks, closed and sheet.plotted
        )
        part = masked(part, ~boxes)
    else:
        # Beside wide gaps in a faded outline nothing else is looked for that they could close.
        rule = LooseRule(
            _SHORTEST_MARK * sheet.stroke_width,
            everywhere=False,
            bridge=2 * int(_WIDEST_FADED * sheet.stroke_width) + 1,
            corners=True,
        )
        known = Told(shapes, kinds, unexplained)
        left = with_open_sides(erased(sheet, known).ink, known, sheet.stroke_width)
        told = Told(*split_loose(shapes, kinds, left, rule), unexplained)
    if any(kind for own in told.kinds for kind in own):
        told = with_clear_tips(told, sheet.ink, sheet.stroke_width)
        marks += line_marks(told)
        part = replace(erased(part, told), stroke_width=weights.visible)
        if weights.limit:
            part = without_slivers(without_heads(part, told, weights.visible), told, sheet)
    hatched = hatching.area if hatching.marks else None
    # Where edges were told by their width, nothing was asked of outlines.
    closed = closed and sheet.plotted and not weights.limit
    return SeparatedSheet(part, tuple(marks), bool(weights.limit), hatched, told, closed)


def _weights(sheet: CleanSheet, shapes: list[InkedShape]) -> Weights:
    weights = line_weights(shapes, sheet.stroke_width, _ROUNDED_PX if _is_two_valued(sheet) else 0)
    return weights if weights.limit else Weights(sheet.stroke_width, 0.0)


def _cut(sheet: CleanSheet, shapes: list[InkedShape], weights: Weights) -> list[InkedShape]:
    """The shapes, with runs cut where edges go on as narrow lines."""
    if not weights.limit:
        return shapes
    return [split_by_width(sheet, shape, weights.limit, weights.visible) for shape in shapes]


def _tell_line_ends(
    sheet: CleanSheet,
    ridges: RidgePoints,
    told: Told,
    weights: Weights,
    letters: tuple[Mark, ...],
) -> None:
    """Tell what is left at the ends of dimension lines and of hidden ones, in place."""
    mark_leaders(told.shapes, told.kinds, letters, sheet.ink, sheet.stroke_width)
    mark_heads(told.shapes, told.kinds, sheet.stroke_width)
    widest = widest_gap(sheet.stroke_width, _GAPS * sheet.dash_gap)
    mark_doubled(told.shapes, told.kinds, sheet.ink, weights, widest)
    free = ridges, _at(ridges, told.unexplained)
    more = extension_lines(sheet, free, (told.shapes, told.kinds), weights.limit)
    told.shapes.extend(more)
    told.kinds.extend([AnnotationKind.EXTENSION] for _ in more)
    spare_by_pen(told.shapes, told.kinds, weights, sheet.stroke_width)
    left = erased(sheet, told).ink
    spare_lone_dashes(told.shapes, told.kinds, left, weights, sheet.stroke_width)
    if sheet.dash_gap:
        spare_free_dashes(told.shapes, told.kinds, sheet.ink, sheet.stroke_width)
        pen = sheet.stroke_width
        spare_short_rows(told.shapes, told.kinds, weights, sheet.dash_gap, pen)


def _told_by_form(
    sheet: CleanSheet, told: Told, letters: tuple[Mark, ...], closed: bool
) -> tuple[Told, Mask]:
    """Dimensions by their arrowheads, then what bounds nothing, then boxes around letters."""
    heads = arrowheads(sheet.ink, sheet.stroke_width)
    width = sheet.stroke_width
    mark_arrows(told.shapes, told.kinds, heads, sheet.ink, width, letters=letters)
    mark_lone_marks(told.shapes, told.kinds, sheet.ink, sheet.stroke_width)
    mark_tapered(told.shapes, told.kinds, sheet)
    mark_lettered(told.shapes, told.kinds, letters, sheet.ink, sheet.stroke_width)
    single = letter_boxes(sheet.ink, letters, sheet.stroke_width)
    ink = with_open_sides(erased(sheet, told).ink, told, sheet.stroke_width)
    boxes = lettered_boxes(ink, letters) | single
    faded = 2 * int(_WIDEST_FADED * sheet.stroke_width) + 1
    # Without dimensions there are no extension lines; a crossing with none is an edge's.
    dimensioned = any(kind in _DIMENSIONS for own in told.kinds for kind in own)
    shortest = max(_LONGEST_DASH * width, longest_dash(told.shapes, told.kinds, width))
    rule = LooseRule(shortest, everywhere=dimensioned, faded=faded, closed=closed)
    shapes, kinds = split_loose(told.shapes, told.kinds, ink & ~boxes, rule)
    left = erased(sheet, Told(shapes, kinds, told.unexplained)).ink & ~boxes
    mark_led_out(shapes, kinds, sheet.weight, left, sheet.stroke_width)
    mark_virtual_corners(shapes, kinds, sheet.stroke_width)
    if sheet.dash_gap:
        spare_free_dashes(shapes, kinds, sheet.ink, sheet.stroke_width)
    rest = Told(shapes, kinds, told.unexplained)
    return rest, boxes | lettered_boxes(erased(sheet, rest).ink, letters)


def _wide_curves(points: Mask, width: float) -> Mask:
    """(h, w) bool, strokes of a width around ridge points, where these make a stroke at all: where
    lines meet, a few are left over."""
    side = 2 * int(np.ceil(0.5 * width)) + 1
    wide = cv2.dilate(points.astype(np.uint8), np.ones((side, side), np.uint8))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(wide, connectivity=8)
    long = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) > _CURVE * width
    long[0] = False
    return long[labels]


def _is_two_valued(sheet: CleanSheet) -> bool:
    """Whether every pixel is ink or paper, so that widths are whole numbers of px."""
    inked = sheet.weight > _GREY[0]
    grey = inked & (sheet.weight < _GREY[1])
    return float(grey.sum()) < _LEAST_GREY * max(float(inked.sum()), 1.0)


def _free(ridges: RidgePoints, grown: list[Grown]) -> npt.NDArray[np.bool_]:
    """(n,) ridge points that belong to no line or circle: free curves."""
    free = np.ones(len(ridges.points), dtype=bool)
    for shape in grown:
        free[shape.members] = False
    return free


def _pixels(ridges: RidgePoints, chosen: npt.NDArray[np.bool_], letters: Mask) -> Mask:
    """(h, w) bool, pixels of some of the ridge points beside the letters."""
    columns, rows = np.rint(ridges.points[chosen]).astype(int).T
    mask = np.zeros(letters.shape, dtype=bool)
    mask[rows, columns] = True
    return mask & ~letters


def _at(ridges: RidgePoints, mask: Mask) -> npt.NDArray[np.bool_]:
    """(n,) the ridge points on a mask."""
    columns, rows = np.rint(ridges.points).astype(int).T
    return mask[rows, columns]


def _explained(ridges: RidgePoints, grown: list[Grown], ink: Mask) -> Mask:
    """Pixels near the ridge points of shapes that are no parts of letters: long ones, dashed ones,
    and circles that are most of a piece of ink."""
    longest = _LETTER_SHARE * max(ink.shape)
    _, labels, stats, _ = cv2.connectedComponentsWithStats(ink.astype(np.uint8), connectivity=8)
    mask = np.zeros(ink.shape, np.uint8)
    for own in grown:
        points = ridges.points[own.members]
        columns, rows = np.rint(points).astype(int).T
        pieces = np.unique(labels[rows, columns])
        pieces = pieces[pieces > 0]
        dashed = len(pieces) >= _DASHES
        if isinstance(own.geometry, Circle):
            side = max(stats[piece, 2:4].max() for piece in pieces) if len(pieces) else 0
            told = _turned_through(own.geometry, points) > (_DASHED if dashed else _WHOLE)
            told &= dashed or own.geometry.radius > min(_LOOP * side, longest / 2)
        else:
            length = float(np.hypot(*np.ptp(points, axis=0)))
            told = len(own.members) > _DASHED * length and (dashed or length > longest)
        if told:
            mask[rows, columns] = 1
    return cv2.dilate(mask, np.ones((5, 5), np.uint8)) > 0


def _turned_through(circle: Circle, points: np.ndarray) -> float:
    """Share of a circle's directions in which it has points."""
    offset = points - np.array(circle.centre)
    angles = np.arctan2(offset[:, 1], offset[:, 0])
    return len(np.unique(np.floor(angles * (_DIRECTIONS / (2 * np.pi))))) / _DIRECTIONS


def _in_letters(shape: Grown, ridges: RidgePoints, mask: Mask) -> bool:
    columns, rows = np.rint(ridges.points[shape.members]).astype(int).T
    return bool(mask[rows, columns].mean() > 0.5)


def line_marks(told: Told) -> list[Mark]:
    """One mark for each run that is an annotation, between its ends."""
    marks = []
    for shape, own in zip(told.shapes, told.kinds, strict=True):
        for run, kind in zip(shape.runs, own, strict=True):
            if kind is not None:
                ends = points_along(shape.geometry, run.run, 1e9) + 0.5
                marks.append(line_mark(kind, tuple(ends[0].tolist()), tuple(ends[-1].tolist())))
    return marks
