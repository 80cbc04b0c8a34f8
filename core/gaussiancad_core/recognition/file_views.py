"""The views of a sheet whose file tells its strokes."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Stroke
from gaussiancad_core.recognition.drawn_layout import (
    chosen_views,
    doubtful_lines,
    empty_view_box,
    is_middle_in,
    layout_of,
    scaled_box,
    strokes_of_other_pens,
    with_projection,
)
from gaussiancad_core.recognition.labelled_file import FileStrokes
from gaussiancad_core.recognition.shaded_views import (
    ShadedViews,
    shaded_views,
    with_traced_lines,
)
from gaussiancad_core.recognition.stroke_reading import StrokeReading
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, line_mark
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.inked_sheet import painted_sheet
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.cut_views import cut_mask
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet
from gaussiancad_core.sheet.views.sheet_layout import Layout, may_be_views
from gaussiancad_core.sheet_model.labelled_strokes import Label
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke
from gaussiancad_core.structure.cut_faces import cut_faces
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.role_search import Arrangement

_MARKS = {
    Label.CENTRE: AnnotationKind.CENTRE_LINE,
    Label.HATCH: AnnotationKind.HATCHING,
    Label.FRAME: AnnotationKind.FRAME,
    Label.TABLE: AnnotationKind.FRAME,
    Label.DIMENSION: AnnotationKind.EXTENSION,
    Label.EXTENSION: AnnotationKind.EXTENSION,
    Label.OTHER: AnnotationKind.EXTENSION,
}


@dataclass(frozen=True, eq=False)
class FileViews:
    """What the strokes of a file tell of its views.

    Attributes:
        separated: the sheet with the part's strokes alone.
        layout: of its views.
        vectors: the part's strokes.
        doubtful: lines in px that run from edge to edge and are no edges for their pen.
        others: strokes in px within the views that are no edges for their pen, wherever they
            end.
        is_all: whether no other drawing, and no picture, lies beside the views.
        frame_guessed: whether the layout's frame may as well be the part's outline.
        best: the views in their roles.
        shaded: those that are shaded pictures; None where none is.
    """

    separated: SeparatedSheet
    layout: Layout
    vectors: VectorSheet
    doubtful: tuple[LineSegment, ...] = ()
    others: tuple[Stroke, ...] = ()
    is_all: bool = False
    frame_guessed: bool = False
    best: Arrangement | None = None
    shaded: ShadedViews | None = None

    def with_traced_lines(self, drawn: tuple[ReadView, ...]) -> tuple[ReadView, ...]:
        """The views as they were read, shaded ones with the lines that were drawn on them."""
        if self.shaded is None or self.best is None:
            return drawn
        return with_traced_lines(drawn, self.best, self.shaded)


def file_views(
    file: FileStrokes,
    given: Mapping[Role, Box],
    projection: Projection | None,
    symbol: ProjectionSymbol | None,
) -> FileViews | None:
    """The views of a sheet by the strokes of its file; nothing where these tell none.

    Args:
        file: with its strokes.
        given: boxes that the user named, px.
        projection: as told by the user, or nothing.
        symbol: of the sheet, where it has one.

    Raises:
        UsageError: a given box holds no stroke.
    """
    reading, fixed = _with_given(file.reading, given, file.scale)
    best = chosen_views(reading.views, reading.ranking, fixed, file.third)
    if best is None:
        return None
    upright = {number: placed for number, placed in best.placed.items() if not placed.turn}
    if not upright:
        return None
    best = replace(best, placed=upright)
    shaded = shaded_views(reading, best, file.sheet, file.scale)
    found = _found(replace(file, reading=reading), best, projection, symbol)
    return replace(found, best=best, shaded=shaded)


def _with_given(
    reading: StrokeReading, given: Mapping[Role, Box], scale: float
) -> tuple[StrokeReading, dict[int, Role]]:
    """The reading with one drawing in each box, px, that the user named, and their roles.

    Raises:
        UsageError: a box holds no drawing.
    """
    views = list(reading.views)
    fixed = []
    for role, box in given.items():
        around = scaled_box(box, 1.0 / scale)
        inside = [view for view in views if is_middle_in(view.box, around)]
        if not inside:
            raise empty_view_box(role, box)
        views = [view for view in views if view not in inside]
        fixed.append((_merged(inside), role))
    views += [view for view, _ in fixed]
    first = len(views) - len(fixed)
    roles = {first + index: role for index, (_, role) in enumerate(fixed)}
    return replace(reading, views=tuple(views)), roles


def _merged(views: Sequence[DrawnView]) -> DrawnView:
    """Drawings as one plain view."""
    boxes = np.array([view.box for view in views])
    x0, y0 = boxes[:, :2].min(axis=0).tolist()
    x1, y1 = boxes[:, 2:].max(axis=0).tolist()
    cut = any(view.kind is DrawingKind.SECTION for view in views)
    return DrawnView(
        (x0, y0, x1, y1),
        tuple(edge for view in views for edge in view.edges),
        shapely.union_all([view.outline for view in views]),
        tuple(stroke for view in views for stroke in view.hidden),
        tuple(family for view in views for family in view.hatching),
        tuple(stroke for view in views for stroke in view.narrow),
        DrawingKind.SECTION if cut else DrawingKind.PLAIN,
    )


def _found(
    file: FileStrokes,
    best: Arrangement,
    projection: Projection | None,
    symbol: ProjectionSymbol | None,
) -> FileViews:
    drawing, sheet, reading, scale = file.drawing, file.sheet, file.reading, file.scale
    labelled = reading.labelled
    to_px = Similarity(scale)
    part = file.part
    painted = painted_sheet(part, sheet.shape, sheet.turn)
    hatched = cut_mask(cut_faces(labelled), painted, scale)
    marks = [
        mark
        for stroke, label in zip(labelled.strokes, labelled.labels, strict=True)
        if label in _MARKS and (mark := _mark(stroke, _MARKS[label], to_px)) is not None
    ]
    texts = {text.box for text in drawing.texts}
    words = (scaled_box(box, scale) for box in reading.words)
    marks += [Mark(AnnotationKind.TEXT, box) for box in words if box not in texts]
    boxes = [scaled_box(view.box, scale) for view in reading.views]
    layout = layout_of(reading.views, boxes, best, hatched)
    layout = with_projection(layout, reading.ranking, projection, symbol)
    if symbol is not None and projection is None:
        marks.append(symbol.mark)
    separated = SeparatedSheet(painted, tuple(marks), hatched, has_paper=drawing.has_paper)
    is_all = not may_be_views(layout.left_out) and not _shows_more(drawing, reading, scale)
    area = reading.area
    guessed = area.is_framed and not area.is_certain
    if area.is_framed and not drawing.has_paper:
        layout = replace(layout, frame=scaled_box(area.polygon.bounds, scale))
    doubtful = doubtful_lines(reading, best, scale)
    others = strokes_of_other_pens(reading, best, scale)
    return FileViews(separated, layout, VectorSheet(part), doubtful, others, is_all, guessed, best)


def _shows_more(drawing: VectorDrawing, reading: StrokeReading, scale: float) -> bool:
    """Whether a file may show a view besides its strokes: where it does not tell the places of what
    else it shows, or has a picture in the drawing area that is none of its drawings."""
    if drawing.complete or not drawing.pictures:
        return not drawing.complete
    known = [shapely.box(*view.box) for view in reading.views]
    pictures = [shapely.box(*scaled_box(box, 1.0 / scale)) for box in drawing.pictures]
    return any(
        reading.area.polygon.contains(picture.centroid)
        and not any(view.contains(picture.centroid) for view in known)
        for picture in pictures
    )


def _mark(stroke: PaperStroke, kind: AnnotationKind, to_px: Similarity) -> Mark | None:
    curve = stroke.curve.mapped(to_px)
    if isinstance(curve, LineSegment):
        return line_mark(kind, curve.start, curve.end)
    return Mark(kind, curve.box)
