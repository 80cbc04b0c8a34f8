"""The views of a sheet, whatever it is: by the strokes of its file, else by its picture."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Stroke
from gaussiancad_core.recognition.drawn_layout import is_middle_in
from gaussiancad_core.recognition.file_views import FileViews, file_views
from gaussiancad_core.recognition.labelled_file import FileStrokes, strokes_of_file
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.drawing_names import inside
from gaussiancad_core.sheet.special_views.projection_note import noted_projection
from gaussiancad_core.sheet.special_views.projection_symbol import find_symbol
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.writing.sheet_texts import SheetText


@dataclass(frozen=True, eq=False)
class SheetViews:
    """What was found on a sheet before its lines are read.

    Attributes:
        separated: the part's ink, and the annotations.
        layout: where the views are.
        vectors: exact lines of the part, where the file has them.
        texts: all that is written, where it is read already.
        labels_problem: why a picture was read without the labels network; None where it was not.
        other_pens: lines in px, from edge to edge in other pens than the part's, that may be its
            own.
        others: strokes in px within the views that are no edges for their pen.
        frame_guessed: whether the layout's frame may as well be the part's outline.
        of_file: the views by the strokes of a file; None where pixels tell them.
    """

    separated: SeparatedSheet
    layout: Layout
    vectors: VectorSheet | None = None
    texts: tuple[SheetText, ...] | None = None
    labels_problem: Message | None = None
    other_pens: tuple[LineSegment, ...] = ()
    others: tuple[Stroke, ...] = ()
    frame_guessed: bool = False
    of_file: FileViews | None = None


def sheet_views(
    sheet: OpenedSheet,
    given: Mapping[Role, Box] | None = None,
    projection: Projection | None = None,
) -> SheetViews:
    """Find the views of a sheet.

    The strokes of a file tell its views where these belong together; all else is read from the
    picture.

    Args:
        sheet: as stored and upright.
        given: boxes that the user named, in px of the upright sheet.
        projection: as told by the user, or nothing: then the sheet is asked.

    Raises:
        NoModelError: there are fewer than two views that belong together, and not one alone.
        UsageError: a given box holds no ink.
    """
    boxes = dict(given or {})
    symbol = None if projection is not None else find_symbol(sheet) or noted_projection(sheet)
    stated = projection, symbol
    file = strokes_of_file(sheet, projection, symbol)
    try:
        return _found(sheet, boxes, stated, file)
    except NoModelError:
        # A box alone fixes one view; what is found without it stands where it is that view there.
        if len(boxes) != 1:
            raise
        found = _holding(sheet, boxes, stated, file)
        if found is None:
            raise
        return found


def _holding(
    sheet: OpenedSheet,
    given: dict[Role, Box],
    stated: tuple[Projection | None, ProjectionSymbol | None],
    file: FileStrokes | None,
) -> SheetViews | None:
    """What is found without the only given box, if that is one of its views and has its name there,
    or is the only one."""
    try:
        found = _found(sheet, {}, stated, file)
    except NoModelError:
        return None
    ((role, given_box),) = given.items()
    layout = found.layout
    held = [this_role for this_role, box in layout.boxes.items() if is_middle_in(box, given_box)]
    if held == [role]:
        return found
    if not held or len(layout.boxes) != 1:
        return None
    return replace(found, layout=replace(layout, boxes={role: layout.boxes[held[0]]}))


def _found(
    sheet: OpenedSheet,
    boxes: dict[Role, Box],
    stated: tuple[Projection | None, ProjectionSymbol | None],
    file: FileStrokes | None,
) -> SheetViews:
    """The views by the strokes of a file, where they tell them; else by the picture."""
    projection, symbol = stated
    by_strokes = file_views(file, boxes, projection, symbol) if file is not None else None
    if by_strokes is not None and (len(by_strokes.layout.boxes) > 1 or by_strokes.is_all):
        return _of_strokes(by_strokes)
    is_mixed = file is not None and not file.drawing.complete
    if is_mixed and projection is None and symbol is None:
        symbol = find_symbol(sheet, pictured=True)
    # What reads pixels is compiled: a sheet whose strokes tell its views waits for none of it.
    from gaussiancad_core.recognition.picture_views import picture_views

    try:
        seen = picture_views(sheet, boxes, projection, symbol)
    except NoModelError:
        if by_strokes is None:
            raise
        return _of_strokes(by_strokes)
    if by_strokes is not None and _is_one(by_strokes.layout, seen.layout):
        return _of_strokes(by_strokes)
    vectors = VectorSheet(file.part, sheet.clean) if file is not None else None
    return SheetViews(seen.separated, seen.layout, vectors, seen.texts, seen.problem)


def _is_one(alone: Layout, seen: Layout) -> bool:
    """Whether what a picture shows is the one view that the strokes tell, or pieces within it."""
    (whole,) = alone.boxes.values()
    return len(seen.boxes) == 1 or all(inside(box, whole) for box in seen.boxes.values())


def _of_strokes(found: FileViews) -> SheetViews:
    return SheetViews(
        found.separated,
        found.layout,
        found.vectors,
        other_pens=found.doubtful,
        others=found.others,
        frame_guessed=found.frame_guessed,
        of_file=found,
    )
