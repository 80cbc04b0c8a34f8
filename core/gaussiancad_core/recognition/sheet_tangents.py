"""Tangent edges taken off the views of a sheet, a file or a picture."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.recognition.sheet_views import SheetViews
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.labels.label_evidence import SheetLabels
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.inked_widths import InkedWidths
from gaussiancad_core.sheet.special_views.tangent_edges import without_tangent_edges
from gaussiancad_core.sheet.special_views.tangent_policy import SheetTangents

_MARGIN = 3.0
"""px by which a line may reach beyond the box of its view, which runs through middles of ink."""

_THIN = (
    AnnotationKind.TANGENT_EDGE,
    AnnotationKind.DIMENSION,
    AnnotationKind.EXTENSION,
    AnnotationKind.SYMBOL,
)
"""What thin lines of a picture are taken for."""


@dataclass(frozen=True, eq=False)
class SheetWithoutTangents:
    """A sheet whose views have no tangent edges among their strokes.

    Attributes:
        found: what was found on it; lines in other pens that are tangent edges are no others.
        drawn: the views, each with its tangent edges apart.
        tangents: what the sheet does with tangent edges.
    """

    found: SheetViews
    drawn: tuple[ReadView, ...]
    tangents: SheetTangents


def sheet_without_tangents(found: SheetViews, drawn: tuple[ReadView, ...]) -> SheetWithoutTangents:
    """The views of a sheet without their tangent edges.

    Args:
        found: on the sheet, before its lines were read.
        drawn: the views with their strokes, px of the upright sheet.
    """
    others = found.others if found.of_file is not None else _thin_marks(found.separated.marks)
    thin = {
        view.role: [stroke for stroke in others if _holds(view.box, stroke.box)] for view in drawn
    }
    widths = InkedWidths(found.separated.part, drawn)
    edges = without_tangent_edges(drawn, thin, widths.is_thin)
    tangents = [stroke for view in edges.views for stroke in view.tangents]
    known = {(line.start, line.end) for line in tangents if isinstance(line, Segment)}
    marks = tuple(mark for mark in found.separated.marks if mark.line not in known)
    other_pens = tuple(line for line in found.other_pens if (line.start, line.end) not in known)
    labels = _without_lines_along(found.separated.labels, tangents)
    separated = replace(found.separated, marks=marks, labels=labels)
    found = replace(found, separated=separated, other_pens=other_pens)
    return SheetWithoutTangents(found, edges.views, edges.sheet)


def _thin_marks(marks: Iterable[Mark]) -> list[Segment]:
    """The lines of a picture that were taken for dimensions, or for thin lines."""
    return [
        Segment(*mark.line, Linetype.VISIBLE)
        for mark in marks
        if mark.line is not None and mark.kind in _THIN
    ]


def _without_lines_along(labels: SheetLabels, tangents: Sequence[Stroke]) -> SheetLabels:
    """The labels but for those of tangent edges: no doubt is left whether these are edges."""
    if not tangents or not labels.lines:
        return labels
    # A sheet without such lines has no need of it.
    from scipy.spatial import cKDTree

    tree = cKDTree(np.concatenate([stroke.sample(1.0) for stroke in tangents]))
    reach = labels.stroke_width + _MARGIN
    kept = tuple(line for line in labels.lines if tree.query(line.points)[0].max() > reach)
    return replace(labels, lines=kept)


def _holds(box: Box, other: Box) -> bool:
    x0, y0, x1, y1 = box
    return (
        x0 - _MARGIN <= other[0]
        and y0 - _MARGIN <= other[1]
        and other[2] <= x1 + _MARGIN
        and other[3] <= y1 + _MARGIN
    )
