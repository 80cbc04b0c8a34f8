"""A sheet taken apart by the labels of its lines: the part's ink, and the annotations."""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, Mask, values_at
from gaussiancad_core.sheet.annotations.erase import Told, erased, masked
from gaussiancad_core.sheet.annotations.hatching_runs import find_hatching
from gaussiancad_core.sheet.annotations.inked_shapes import InkedShape, inked_shape, points_along
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet, line_marks
from gaussiancad_core.sheet.annotations.sheet_frame import find_frame
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.labels.class_shares import learnt_shares
from gaussiancad_core.sheet.labels.dash_rhythm_labels import rhythm_odds
from gaussiancad_core.sheet.labels.dashed_rings import dashed_rings
from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from gaussiancad_core.sheet.labels.label_evidence import (
    LabelledLine,
    SheetLabels,
    labelled_curves,
    labelled_lines,
)
from gaussiancad_core.sheet.labels.labels_network import InkLabels, part_odds
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun, SharedInk, labelled_runs
from gaussiancad_core.sheet.labels.line_relations import related
from gaussiancad_core.sheet.labels.pen_colours import Tints, learnt_colours
from gaussiancad_core.sheet.labels.pen_widths import learnt_pens
from gaussiancad_core.sheet.labels.writing_ink import writing_ink
from gaussiancad_core.sheet.labels.writing_lines import written_lines
from gaussiancad_core.sheet.tracing.ink_runs import ink_field
from gaussiancad_core.sheet.tracing.level_rules import rule_of
from gaussiancad_core.sheet.tracing.ridges import ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_shapes

_BLOT = 1.4
"""Widths of a line within which another one shares its ink."""

_NEAR = 1.5
"""Widths of a line from what meets it within which it may end."""

_LEAST_POINT = 0.4
"""Size of a decimal point at least, in widths of a line."""

_KINDS = {
    InkClass.CENTRE: AnnotationKind.CENTRE_LINE,
    InkClass.DIMENSION: AnnotationKind.DIMENSION,
    InkClass.HATCHING: AnnotationKind.HATCHING,
    InkClass.TEXT: AnnotationKind.TEXT,
    InkClass.FRAME: AnnotationKind.FRAME,
    InkClass.PICTORIAL: AnnotationKind.PICTURE,
    InkClass.OTHER: AnnotationKind.SYMBOL,
    InkClass.THIN: AnnotationKind.TANGENT_EDGE,
}
"""What a mark of each class is."""


def separate_by_labels(
    sheet: CleanSheet, labels: InkLabels, tint: Tints | None = None
) -> SeparatedSheet:
    """Take what is no part's off a sheet.

    Args:
        sheet: upright.
        labels: of the same picture.
        tint: of the same; None where it has no colours.
    """
    marks: list[Mark] = []
    frame = find_frame(sheet.ink, sheet.turn)
    if frame is not None:
        sheet = masked(sheet, frame.drawing_area)
        marks += frame.marks
    best = labels.best()
    rings = dashed_rings(sheet.ink & (best == InkClass.TEXT), sheet.stroke_width)
    if rings.any():
        labels = labels.without(InkClass.TEXT, rings)
        best = labels.best()
    text = writing_ink(sheet.ink, labels)
    marks += _text_marks(text, sheet.stroke_width)
    sheet = masked(
        sheet, ~cv2.dilate(text.astype(np.uint8), np.ones((3, 3), np.uint8)).astype(bool)
    )
    ridges = ridge_points(sheet.weight, sheet.stroke_width)
    rules = GrowthRules.of_width(sheet.stroke_width, sheet.dash_gap)
    grown = grow_shapes(ridges, rules)
    field = ink_field(sheet)
    shapes = [inked_shape(sheet, field, ridges, item) for item in grown]
    free = np.ones(len(ridges.points), dtype=bool)
    for entry in grown:
        free[entry.members] = False
    shared = _shared(shapes, sheet, ridges.points[free])
    told_by = [rhythm_odds]
    labelled = [labelled_runs(shape, labels, shared, told_by) for shape in shapes]
    pens = learnt_pens(sheet, shapes, labelled)
    if pens is not None:
        told_by.append(pens.odds)
    colours = tint is not None and learnt_colours(tint, shapes, labelled, sheet.stroke_width)
    if colours:
        told_by.append(colours.odds)
    if labels.is_learnt:
        told_by.append(learnt_shares(labelled, sheet.stroke_width).odds)
    if len(told_by) > 1:
        labelled = [labelled_runs(shape, labels, shared, told_by) for shape in shapes]
    labelled = related(shapes, labelled, sheet.stroke_width)
    unexplained, loose, curves = _free_curves(ridges.points[free], labels, sheet.ink.shape)
    stated = _labels_by_line(shapes, labelled, unexplained, loose)
    part = erased(sheet, stated)
    part = masked(part, ~_stray(part.ink, best, stated))
    marks += line_marks(stated)
    hatched = None
    if any(AnnotationKind.HATCHING in annotation_kinds for annotation_kinds in stated.kinds):
        found = find_hatching(sheet, shapes, ridges, free)
        hatched = found.area if found.marks else None
        marks += found.marks
    decided = SheetLabels((*labelled_lines(shapes, labelled), *curves), sheet.stroke_width)
    askew = sheet.ink & ~part.ink & (best == InkClass.PICTORIAL)
    return SeparatedSheet(part, tuple(marks), hatched, askew, stated, decided)


def _text_marks(text: Mask, stroke_width: float) -> list[Mark]:
    """One mark for each line of writing."""
    _, _, stats, _ = cv2.connectedComponentsWithStats(text.astype(np.uint8), connectivity=8)
    letters = [
        (float(x), float(y), float(x + w), float(y + h))
        for x, y, w, h, _ in stats[1:].tolist()
        if max(w, h) > _LEAST_POINT * stroke_width
    ]
    return [Mark(AnnotationKind.TEXT, box) for box in written_lines(letters)]


def _shared(
    shapes: list[InkedShape], sheet: CleanSheet, free: npt.NDArray[np.float64]
) -> SharedInk:
    """Where lines and circles meet each other, or a curve; (n, 2) points of these."""
    count = np.zeros(sheet.ink.shape, np.uint8)
    width = max(1, round(_BLOT * sheet.stroke_width))
    layer = np.zeros(sheet.ink.shape, np.uint8)
    for shape in shapes:
        boxes = []
        for run in shape.runs:
            path = np.rint(points_along(shape.geometry, run.run, 2.0) * 8).astype(np.int32)
            cv2.polylines(layer, [path], False, 1, width, shift=3)
            low = np.maximum(path.min(axis=0) // 8 - width - 1, 0)
            high = path.max(axis=0) // 8 + width + 2
            boxes.append(np.s_[low[1] : high[1], low[0] : high[0]])
        for box in boxes:
            count[box] += layer[box]
            layer[box] = 0
    shared = count > 1
    met = shared.astype(np.uint8)
    columns, rows = np.rint(free).astype(int).T
    met[rows, columns] = 1
    side = 2 * int(np.ceil(_NEAR * sheet.stroke_width)) + 1
    return SharedInk(shared, cv2.dilate(met, np.ones((side, side), np.uint8)) > 0)


def _free_curves(
    points: npt.NDArray[np.float64], labels: InkLabels, shape: tuple[int, int]
) -> tuple[Mask, Mask, tuple[LabelledLine, ...]]:
    """(h, w) bool each, ridge points of no line or circle: the part's, and annotation; and what
    decided.  Those that hang together are of one kind."""
    columns, rows = np.rint(points).astype(int).T
    curves = np.zeros(shape, np.uint8)
    curves[rows, columns] = 1
    _, chains = cv2.connectedComponents(curves, connectivity=8)
    item = chains[rows, columns]
    log_p = labels.at(points)
    odds = np.bincount(item, weights=part_odds(log_p))
    part = (odds > 0.0)[item]
    unexplained, loose = np.zeros(shape, bool), np.zeros(shape, bool)
    unexplained[rows[part], columns[part]] = True
    loose[rows[~part], columns[~part]] = True
    return unexplained, loose, labelled_curves(points, item, log_p)


def _labels_by_line(
    shapes: list[InkedShape],
    labelled: list[list[LabelledRun]],
    unexplained: Mask,
    loose: Mask,
) -> Told:
    found, kinds = [], []
    for shape, runs in zip(shapes, labelled, strict=True):
        found.append(InkedShape(shape.geometry, tuple(each.run for each in runs)))
        kinds.append([_kind(shape, each) for each in runs])
    return Told(found, kinds, unexplained, loose)


def _kind(shape: InkedShape, run: LabelledRun) -> AnnotationKind | None:
    """What a run is, None for the part's; a slanted dimension line is a leader."""
    if run.is_part:
        return None
    kind = _KINDS[run.ink]
    if kind is AnnotationKind.DIMENSION:
        ends = points_along(shape.geometry, run.run.run, 1e9)
        if rule_of(ends[0].tolist(), ends[-1].tolist()) is None:
            return AnnotationKind.LEADER
    return kind


def _stray(ink: Mask, best: np.ndarray, stated: Told) -> Mask:
    """(h, w) bool, pieces of what is left through which no edge runs and of which most is
    annotation: arrowheads and the like."""
    count, labels = cv2.connectedComponents(ink.astype(np.uint8), connectivity=8)
    part = ink & np.isin(best, PART)
    sizes = np.bincount(labels.ravel(), minlength=count)
    stray = np.bincount(labels[part], minlength=count) < 0.5 * sizes
    for shape, kinds in zip(stated.shapes, stated.kinds, strict=True):
        for run, kind in zip(shape.runs, kinds, strict=True):
            if kind is None:
                stray[values_at(labels, points_along(shape.geometry, run.run, 1.0))] = False
    stray[0] = False
    return stray[labels]
