"""The views of a sheet whose file tells its strokes."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.errors import UsageError
from gaussiancad_core.file_reading.paper_of_file import paper_of_file
from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.file_layout import doubtful_lines, layout_of, scaled_box
from gaussiancad_core.recognition.stroke_reading import StrokeReading, read_strokes
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, line_mark
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.inked_sheet import painted_sheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.special_views.cut_areas import cut_areas
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.vector_views.stroke_chains import with_whole_edges
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet
from gaussiancad_core.sheet.views.sheet_layout import Layout, ProjectionSource, may_be_views
from gaussiancad_core.sheet_model.labelled_strokes import Label
from gaussiancad_core.sheet_model.paper_sheet import PaperSheet, PaperStroke
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.role_search import Arrangement, Placed, any_in_line, arranged_views
from gaussiancad_protocol.codes import Code

_GIVEN, _SAID = 1e3, 4.0
"""Log-odds for the projection that the user says, which nothing outvotes, and for that of the
sheet's words or symbol."""

_BY_LINES = 3.0
"""Log-odds over the other projection from which the lines tell it."""

_HABIT = 2.5
"""Log-odds for the projection of the standard by which a program names its layers."""

_ISO, _ANSI = re.compile(r"\((?:ISO|DIN)\)"), re.compile(r"\(ANSI\)")

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
        doubtful: boxes in px of lines that run from edge to edge and are no edges for their pen.
        is_all: whether no other drawing, and no picture, lies beside the views.
        frame_guessed: whether the layout's frame may as well be the part's outline.
    """

    separated: SeparatedSheet
    layout: Layout
    vectors: VectorSheet
    doubtful: tuple[Box, ...] = ()
    is_all: bool = False
    frame_guessed: bool = False


def file_views(
    drawing: VectorDrawing,
    sheet: OpenedSheet,
    given: Mapping[Role, Box],
    projection: Projection | None,
    symbol: ProjectionSymbol | None,
) -> FileViews | None:
    """The views of a sheet by the strokes of its file; nothing where these tell none.

    Args:
        drawing: of the file, in px of the sheet, which has to be upright as stored.
        sheet: that.
        given: boxes that the user named, px.
        projection: as told by the user, or nothing.
        symbol: of the sheet, where it has one.

    Raises:
        UsageError: a given box holds no stroke.
    """
    if sheet.turn.angle:
        return None
    third = _third_angle(drawing, projection, symbol)
    symbols = [symbol.mark.box] if symbol is not None else []
    reading, scale = strokes_of_file(drawing, sheet, third, symbols)
    reading, fixed = _with_given(reading, given, scale)
    best = _best(reading, third, fixed, projection)
    if best is None:
        return None
    upright = {number: placed for number, placed in best.placed.items() if not placed.turn}
    if not upright:
        return None
    file = _File(drawing, sheet, reading, scale)
    return _found(file, replace(best, placed=upright), projection, symbol)


def strokes_of_file(
    drawing: VectorDrawing,
    sheet: OpenedSheet,
    third_angle: float = 0.0,
    symbols: Sequence[Box] = (),
) -> tuple[StrokeReading, float]:
    """What the strokes of a file stand for, in mm of paper, and px of the sheet per mm.

    Args:
        drawing: of the file, in px of the sheet, which has to be upright as stored.
        sheet: that.
        third_angle: log-odds for third angle by what it says of its projection.
        symbols: boxes of signs that are known, px.
    """
    paper = _paper(drawing, sheet)
    scale = paper.px_per_mm
    heads = [
        Head((head.tip[0] / scale, head.tip[1] / scale), head.way, head.length / scale)
        for head in sheet.heads
    ]
    signs = [scaled_box(box, 1.0 / scale) for box in symbols]
    return read_strokes(paper, heads, third_angle, signs), scale


def part_of_file(reading: StrokeReading, scale: float) -> VectorDrawing:
    """The part's strokes, px: whole visible edges, and hidden ones.

    Args:
        reading: of the file.
        scale: px per mm.
    """
    to_px = Similarity(scale)
    edges = [_in_px(stroke, to_px, scale) for stroke in reading.labelled.of(Label.EDGE)]
    hidden = [_in_px(stroke, to_px, scale) for stroke in reading.labelled.of(Label.HIDDEN)]
    return VectorDrawing((*with_whole_edges(edges), *hidden), ())


def _best(
    reading: StrokeReading,
    third: float,
    fixed: Mapping[int, Role],
    projection: Projection | None,
) -> Arrangement | None:
    """The views in their roles: two and more that the user named are taken as they are."""
    if len(fixed) > 1:
        placed = {number: Placed(role) for number, role in fixed.items()}
        return Arrangement(placed, projection or Projection.THIRD, 0.0)
    ranking = arranged_views(reading.views, third, fixed) if fixed else reading.ranking
    if ranking is None:
        return None
    boxes = [reading.views[number].box for number in ranking.best.placed]
    # Where nothing is in line a layout of the file may bring the views together.
    return ranking.best if len(boxes) == 1 or fixed or any_in_line(boxes) else None


def _paper(drawing: VectorDrawing, sheet: OpenedSheet) -> PaperSheet:
    grey = sheet.image.grey
    paper = paper_of_file(drawing, sheet.shape, sheet.image.pixels_per_inch)

    def paint(box: Box) -> npt.NDArray[np.uint8]:
        x0, y0, x1, y1 = (max(0, round(value * paper.px_per_mm)) for value in box)
        return grey[y0:y1, x0:x1]

    return replace(paper, paint=paint)


def _third_angle(
    drawing: VectorDrawing, projection: Projection | None, symbol: ProjectionSymbol | None
) -> float:
    """Log-odds for third angle by what the user, the sheet and its layers say."""
    if projection is not None:
        return _GIVEN if projection is Projection.THIRD else -_GIVEN
    if symbol is not None:
        return _SAID if symbol.projection is Projection.THIRD else -_SAID
    layers = " ".join({stroke.layer for stroke in drawing.strokes})
    if _ISO.search(layers):
        return -_HABIT
    return _HABIT if _ANSI.search(layers) else 0.0


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
        inside = [view for view in views if _is_middle_in(view.box, around)]
        if not inside:
            raise UsageError(
                Code.EMPTY_VIEW_BOX,
                "--view {view}: there are no lines in the box {box}",
                view=role,
                box="{:g},{:g},{:g},{:g}".format(*box),
            )
        views = [view for view in views if view not in inside]
        fixed.append((_merged(inside), role))
    views += [view for view, _ in fixed]
    first = len(views) - len(fixed)
    roles = {first + index: role for index, (_, role) in enumerate(fixed)}
    return replace(reading, views=tuple(views)), roles


def _is_middle_in(box: Box, around: Box) -> bool:
    x, y = (box[0] + box[2]) / 2.0, (box[1] + box[3]) / 2.0
    return around[0] <= x <= around[2] and around[1] <= y <= around[3]


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


@dataclass(frozen=True, eq=False)
class _File:
    """A file, and what its strokes tell; px of the sheet per mm."""

    drawing: VectorDrawing
    sheet: OpenedSheet
    reading: StrokeReading
    scale: float


def _found(
    file: _File,
    best: Arrangement,
    projection: Projection | None,
    symbol: ProjectionSymbol | None,
) -> FileViews:
    drawing, sheet, reading, scale = file.drawing, file.sheet, file.reading, file.scale
    labelled = reading.labelled
    to_px = Similarity(scale)
    part = part_of_file(reading, scale)
    painted = painted_sheet(part, sheet.shape, sheet.turn)
    centres = [_in_px(stroke, to_px, scale) for stroke in labelled.of(Label.CENTRE)]
    hatches = [_in_px(stroke, to_px, scale) for stroke in labelled.of(Label.HATCH)]
    hatched = cut_areas(hatches, centres, painted.ink)
    marks = [
        mark
        for stroke, label in zip(labelled.strokes, labelled.labels, strict=True)
        if label in _MARKS and (mark := _mark(stroke, _MARKS[label], to_px)) is not None
    ]
    texts = {text.box for text in drawing.texts}
    words = (scaled_box(box, scale) for box in reading.words)
    marks += [Mark(AnnotationKind.TEXT, box) for box in words if box not in texts]
    layout = layout_of(reading, best, hatched, scale)
    source: ProjectionSource = "default"
    if projection is not None:
        source = "given"
    elif symbol is not None:
        # Corners may overrule it: then the sheet contradicts itself, which is said.
        source = "inferred"
        marks.append(symbol.mark)
        layout = replace(layout, symbol=symbol.projection)
    elif _is_told_by_lines(reading, best):
        source = "inferred"
    alternatives = () if projection is not None else (best.projection.other,)
    layout = replace(layout, source=source, alternatives=alternatives)
    separated = SeparatedSheet(painted, tuple(marks), hatched, has_paper=drawing.has_paper)
    is_all = drawing.complete and not may_be_views(layout.left_out)
    area = reading.area
    guessed = area.is_framed and not area.is_certain
    if area.is_framed and not drawing.has_paper:
        layout = replace(layout, frame=scaled_box(area.polygon.bounds, scale))
    doubtful = doubtful_lines(reading, best, scale)
    return FileViews(separated, layout, VectorSheet(part), doubtful, is_all, guessed)


def _is_told_by_lines(reading: StrokeReading, best: Arrangement) -> bool:
    """Whether the lines themselves tell the projection."""
    ranking = reading.ranking
    is_ranked = ranking is not None and ranking.best.projection is best.projection
    return is_ranked and ranking is not None and ranking.other_projection >= _BY_LINES


def _in_px(stroke: PaperStroke, to_px: Similarity, scale: float) -> VectorStroke:
    pen = stroke.pen
    return VectorStroke(
        stroke.curve.mapped(to_px),
        pen.width * scale or None,
        tuple(length * scale for length in stroke.dashes),
        stroke.role,
        pen.layer,
        stroke.kind,
        pen.colour,
        stroke.step * scale,
    )


def _mark(stroke: PaperStroke, kind: AnnotationKind, to_px: Similarity) -> Mark | None:
    curve = stroke.curve.mapped(to_px)
    if isinstance(curve, LineSegment):
        return line_mark(kind, curve.start, curve.end)
    return Mark(kind, curve.box)
