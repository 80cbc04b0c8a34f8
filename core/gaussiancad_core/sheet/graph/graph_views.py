"""The views of a sheet whose file tells its strokes: of the part's pen, without a look at pixels
that annotations left."""

from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.files.vectors import StrokeKind, VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, line_mark
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.graph.cut_areas import cut_areas
from gaussiancad_core.sheet.graph.drawn_letters import drawn_lines_of_writing, filled_letters
from gaussiancad_core.sheet.graph.stroke_chains import with_whole_edges
from gaussiancad_core.sheet.graph.stroke_roles import Label, LabelledDrawing, labelled
from gaussiancad_core.sheet.image.clean_ink import painted_sheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.labels.label_evidence import meets, meets_any
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.principal_views import LayoutRequest
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet.views.view_search import STUB, arranged, lone_view, with_symbol
from gaussiancad_protocol.codes import Code

_MARKS = {
    Label.CENTRE: AnnotationKind.CENTRE_LINE,
    Label.HATCH: AnnotationKind.HATCHING,
    Label.FRAME: AnnotationKind.FRAME,
    Label.DIMENSION: AnnotationKind.EXTENSION,
}


@dataclass(frozen=True, eq=False)
class GraphViews:
    """What the strokes of a file tell of its views.

    Attributes:
        separated: the sheet with the part's strokes alone.
        layout: of its views.
        vectors: the part's strokes.
        doubtful: boxes in px of strokes in other pens that may be the part's.
        is_all: whether all lies in the views but frames and the file's own dimensions.
        frame_guessed: whether the layout's frame may as well be the part's outline.
    """

    separated: SeparatedSheet
    layout: Layout
    vectors: VectorSheet
    doubtful: tuple[Box, ...] = ()
    is_all: bool = False
    frame_guessed: bool = False


def graph_views(
    drawing: VectorDrawing,
    sheet: OpenedSheet,
    given: dict[Role, Box],
    projection: Projection | None,
    symbol: ProjectionSymbol | None = None,
) -> GraphViews | None:
    """The views of a sheet by its strokes; nothing where no pen tells the part, or where what it
    drew is no views that belong together.

    Args:
        drawing: of the file, in px of the sheet as stored.
        sheet: which has to be upright as stored.
        given: boxes that the user named, in px.
        projection: as told by the user, or nothing: then the sheet's symbol tells it.
        symbol: of the sheet, where it was looked for and found.

    Raises:
        UsageError: a given box holds no stroke.
    """
    height, width = sheet.shape
    found = labelled(drawing, (width, height), sheet.heads) if not sheet.turn.angle else None
    if found is None:
        return None
    separated, vectors = _part(found, sheet)
    marks = (*separated.marks, *_writing(found, drawing, sheet))
    separated = replace(separated, marks=marks, has_paper=drawing.has_paper)
    stated_projection = symbol.projection if symbol else projection
    request = LayoutRequest(given, stated_projection, STUB * separated.part.stroke_width)
    try:
        separated, layout = arranged(sheet, separated, request)
    except NoModelError as error:
        alone = None
        if error.code == Code.ONE_VIEW and not given:
            alone = lone_view(sheet, separated, request)
        if alone is None:
            return None
        separated, layout = alone
    separated, layout = with_symbol(separated, layout, symbol)
    askew = tuple(SpecialView(SpecialKind.PICTORIAL, box) for box in found.pictorials)
    edges = [] if drawing.has_paper else [stroke.curve for stroke in found.of(Label.FRAME)]
    frame = bounds(edges) if edges else None
    layout = replace(layout, special=(*layout.special, *askew), frame=frame)
    boxes = [tuple(found.touches.boxes[number].tolist()) for number in found.doubtful]
    used = [box for box in boxes if any(meets(box, view) for view in layout.boxes.values())]
    is_all = _is_all(found, drawing, tuple(layout.boxes.values()))
    return GraphViews(separated, layout, vectors, tuple(used), is_all, found.frame_guessed)


def _is_all(found: LabelledDrawing, drawing: VectorDrawing, views: tuple[Box, ...]) -> bool:
    """Whether what a file draws itself lies in some views, but for frames."""
    plain = [
        tuple(box)
        for box, stroke, label in zip(
            found.touches.boxes.tolist(), found.strokes, found.labels, strict=True
        )
        if label is not Label.FRAME and stroke.kind in (StrokeKind.GEOMETRY, StrokeKind.BLOCK)
    ]
    fills = any(stroke.kind is StrokeKind.FILL for stroke in drawing.strokes)
    inside = all(any(meets(box, view) for view in views) for box in plain)
    return drawing.complete and inside and not fills


def _part(found: LabelledDrawing, sheet: OpenedSheet) -> tuple[SeparatedSheet, VectorSheet]:
    """The sheet with the part's strokes alone, and these."""
    drawing = VectorDrawing(
        (*with_whole_edges(found.of(Label.VISIBLE)), *found.of(Label.HIDDEN)), ()
    )
    part = painted_sheet(drawing, sheet.shape, sheet.turn)
    marks = [
        mark
        for stroke, label in zip(found.strokes, found.labels, strict=True)
        if label in _MARKS and (mark := _mark(stroke, _MARKS[label])) is not None
    ]
    hatched = cut_areas(found.of(Label.HATCH), found.of(Label.CENTRE), part.ink)
    return SeparatedSheet(part, tuple(marks), hatched), VectorSheet(drawing)


def _writing(
    found: LabelledDrawing, drawing: VectorDrawing, sheet: OpenedSheet
) -> tuple[Mark, ...]:
    """The lines of writing that a file draws and has no texts for."""
    height, width = sheet.shape
    annotations = np.array([label is Label.DIMENSION for label in found.labels], dtype=bool)
    filled = filled_letters(drawing.strokes, sheet.heads, (width, height))
    lines = drawn_lines_of_writing(found.touches, annotations, (width, height), filled)
    known = np.array([text.box for text in drawing.texts])
    return tuple(Mark(AnnotationKind.TEXT, box) for box in lines if not meets_any(box, known))


def _mark(stroke: VectorStroke, kind: AnnotationKind) -> Mark | None:
    curve = stroke.curve
    if isinstance(curve, LineSegment):
        return line_mark(kind, curve.start, curve.end)
    return Mark(kind, curve.box)
