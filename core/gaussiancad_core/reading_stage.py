"""The stages views, lines and masks: a clean sheet to registered views, and what is told of it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from gaussiancad_core.axes import Projection, Role, mutually_orthogonal
from gaussiancad_core.exact_stage import Reading
from gaussiancad_core.job import Job
from gaussiancad_core.modes import Recipe, ResultKind
from gaussiancad_core.projection_choice import both_readings, choose_projection
from gaussiancad_core.report import Unused, ViewReport
from gaussiancad_core.run_notes import RunNotes
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.annotations.separate import SeparatedSheet
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.deskew import Turn
from gaussiancad_core.sheet.graph.views import graph_views
from gaussiancad_core.sheet.layout import Layout, may_be_views
from gaussiancad_core.sheet.options import Box, Finder, ReadingOptions
from gaussiancad_core.sheet.read import SheetImage
from gaussiancad_core.sheet.reading import ReadView, RegisteredSheet, read_views, register_views
from gaussiancad_core.sheet.scale.find import ScaleSource, SheetScale, find_scale
from gaussiancad_core.sheet.special_views.kinds import SpecialView
from gaussiancad_core.sheet.special_views.telling import UNUSED, tellings, why_unused
from gaussiancad_core.sheet.vector_views.vector_views import VectorSheet
from gaussiancad_core.sheet.view_search import find_views
from gaussiancad_core.told_measures import contradicts, trusted

_MOST_PLACES = 5
"""Boxes that one message names at most."""

_WHY_UNUSED = "if they show the part, what they show may be missing"


@dataclass(frozen=True, eq=False)
class SheetFindings:
    """What was read on a sheet.

    Attributes:
        own: the views on shared axes, as they are named; once the readings are weighed, under the
            likelier projection.
        other: the same under the other projection, where that is possible.
        marks: annotations, in px of the upright sheet.
        special: views that are no plain projections.
        symbol: the projection that the sheet's symbol tells, if there is one.
        contradicted: whether the lines fit the other projection better than the symbol's.
    """

    own: Reading
    other: Reading | None
    marks: tuple[Mark, ...]
    special: tuple[SpecialView, ...]
    symbol: Projection | None = None
    contradicted: bool = False


def read_drawing(job: Job, image: SheetImage, clean: CleanSheet, notes: RunNotes) -> SheetFindings:
    """Views, lines and masks of a sheet, on shared axes, under one or two projections.

    Where a solid is asked for, it may tell which of two is right: they are not weighed yet.

    Args:
        job: with what the user says of the sheet.
        image: as stored.
        clean: the same, upright, its ink told from its paper.
        notes: told what is found.

    Raises:
        NoModelError: the sheet has no views that belong together.
    """
    reading = _in_worked_px(job.reading, clean.turn)
    with notes.stage("views"):
        given = {role: clean.turn.box_to_upright(box) for role, box in reading.views}
        separated, layout, vectors = _found_views(image, clean, given, reading, notes)
        _tell_marks(notes, separated.marks, clean.turn)
        _tell_layout(notes, layout, clean.turn)
    with notes.stage("lines"):
        drawn = read_views(separated.part, layout, notes.progress, reading.finder, vectors)
        scale = _sheet_scale(job, image, clean, (separated.marks, drawn), notes)
        options = _scaled(reading, scale, notes)
    with notes.stage("masks"):
        if job.recipe is Recipe.PAPER:
            options = replace(options, open_holes=False)
        if layout.alternatives and not reading.views:
            found = _both(drawn, layout, options, notes)
        else:
            own = Reading(register_views(drawn, options), notes.report.projection)
            found = SheetFindings(own, None, (), ())
        found = _with_measures(found, scale, notes)
        if found.other and job.result is ResultKind.SURFACE:
            found = weigh_readings(found, notes)
        _tell_views(notes, found.own.registered, clean.turn)
        _tell_registration(notes, found.own.registered, clean.turn)
    return replace(found, marks=separated.marks, special=layout.special)


def _in_worked_px(reading: ReadingOptions, turn: Turn) -> ReadingOptions:
    """What was told of px of the sheet as stored, of those that are worked on."""
    if reading.mm_per_pixel is None:
        return reading
    return replace(reading, mm_per_pixel=reading.mm_per_pixel * turn.scale)


def tell_projection(notes: RunNotes, projection: Projection, inferred: bool) -> None:
    """Say which projection was taken, and whether the sheet told it."""
    notes.tell(
        projection=projection,
        projection_source="inferred" if inferred else "default",
        projection_alternatives=() if inferred else (projection.other,),
    )


def tell_symbol(notes: RunNotes, found: SheetFindings, taken: Projection) -> None:
    """Say that the symbol told the projection, or that the lines do not agree with it."""
    symbol = found.symbol
    if symbol is None:
        return
    if taken is symbol:
        notes.tell(projection_source="symbol")
        if not found.contradicted:
            return
    notes.doubt(
        "symbol-contradicts-lines",
        f"the projection symbol says {symbol.value} angle, but the visible and hidden "
        f"lines fit {symbol.other.value} angle better: {taken.value} angle was taken; "
        "tell --projection if it is the other",
    )


def weigh_readings(found: SheetFindings, notes: RunNotes) -> SheetFindings:
    """The same with the likelier of both readings first, by the lines that its hull shows.

    What the sheet's symbol says stays first; the findings then tell whether lines contradict it.
    """
    own, other = found.own, found.other
    choice = choose_projection(own.registered, other.registered, own.projection)
    contradicted = False
    if found.symbol is not None:
        contradicted = choice.inferred and choice.projection is not found.symbol
        choice = choice.told(found.symbol)
    tell_projection(notes, choice.projection, choice.inferred)
    if choice.projection is not own.projection:
        own, other = other, own
    return replace(found, own=own, other=other, contradicted=contradicted)


def _both(
    drawn: tuple[ReadView, ...], layout: Layout, options: ReadingOptions, notes: RunNotes
) -> SheetFindings:
    """The views as they are named, and as the other projection names them where that may be."""
    registered, contrary = both_readings(drawn, options)
    own = Reading(registered, layout.projection)
    other = Reading(contrary, layout.projection.other) if contrary else None
    if other is None:
        tell_projection(notes, own.projection, inferred=True)
    return SheetFindings(own, other, (), (), layout.symbol)


def _sheet_scale(
    job: Job,
    image: SheetImage,
    clean: CleanSheet,
    found: tuple[tuple[Mark, ...], tuple[ReadView, ...]],
    notes: RunNotes,
) -> SheetScale | None:
    """What the sheet's dimensions, paper and notes say; None where nobody asks."""
    if _is_given(job.reading) and job.result is ResultKind.SURFACE:
        return None
    scale = find_scale(image, clean, *found)
    notes.tell(dimensions=scale.dimensions)
    for note in scale.contradictions:
        notes.doubt(note.code, note.message)
    return scale


def _is_given(reading: ReadingOptions) -> bool:
    return reading.length is not None or reading.mm_per_pixel is not None


def _scaled(reading: ReadingOptions, scale: SheetScale | None, notes: RunNotes) -> ReadingOptions:
    """What the user said, with the scale that the sheet tells where they said none."""
    if scale is None or _is_given(reading):
        notes.tell(scale_source=ScaleSource.GIVEN.value)
        return reading
    notes.tell(scale_source=scale.source.value)
    for note in scale.notes:
        notes.warn(note.code, note.message)
    return replace(reading, mm_per_pixel=scale.mm_per_pixel)


def _with_measures(
    found: SheetFindings, scale: SheetScale | None, notes: RunNotes
) -> SheetFindings:
    """The readings with what the dimensions say of lengths, where they fit the scale."""
    if contradicts(found.own.registered, scale):
        notes.doubt(
            "scale-contradicts-dimensions",
            f"the dimensions on the sheet agree on {scale.mm_per_pixel:.4g} mm a pixel, but "
            f"{found.own.registered.mm_per_pixel:.4g} was told: check --length or --mm-per-pixel; "
            "their numbers were not used",
        )
    measured = [
        reading and replace(reading, measures=trusted(reading.registered, scale))
        for reading in (found.own, found.other)
    ]
    return replace(found, own=measured[0], other=measured[1])


def _found_views(
    image: SheetImage,
    clean: CleanSheet,
    given: dict[Role, Box],
    reading: ReadingOptions,
    notes: RunNotes,
) -> tuple[SeparatedSheet, Layout, VectorSheet | None]:
    """The part's ink, its views, and their exact lines where the file has them."""
    drawing = image.vectors if reading.finder is Finder.RIDGES else None
    if drawing is not None:
        told = graph_views(drawing, clean, given, reading.projection)
        if told is not None:
            _tell_doubtful(notes, told.doubtful)
            return told.separated, told.layout, told.vectors
    # Where a file has lines of one width, those of its picture only seem to differ.
    by_weight = not (image.vectors is not None and image.vectors.has_one_width)
    found = find_views(clean, given, reading.projection, by_weight)
    return *found, VectorSheet(drawing, clean) if drawing is not None else None


def _tell_doubtful(notes: RunNotes, boxes: Sequence[Box]) -> None:
    """Say which lines of the views were not used for their pen alone."""
    if boxes:
        places = ", ".join(
            f"({(box[0] + box[2]) / 2.0:.0f}, {(box[1] + box[3]) / 2.0:.0f})"
            for box in boxes[:_MOST_PLACES]
        )
        notes.doubt(
            "unused-view",
            f"{len(boxes)} line(s) run from edge to edge in another pen than the part's and were "
            f"not used, at {places} px: if they show the part, what they show is missing",
        )


def _tell_views(notes: RunNotes, registered: RegisteredSheet, turn: Turn) -> None:
    notes.tell(views={view.role: ViewReport(view.stored_box(turn)) for view in registered.drawn})


def _tell_marks(notes: RunNotes, marks: tuple[Mark, ...], turn: Turn) -> None:
    kinds: dict[str, list[Box]] = {}
    for mark in marks:
        kinds.setdefault(mark.kind.value, []).append(turn.box_to_stored(mark.box))
    notes.tell(annotations=kinds)


def _tell_layout(notes: RunNotes, layout: Layout, turn: Turn) -> None:
    special = tuple(replace(view, box=turn.box_to_stored(view.box)) for view in layout.special)
    notes.tell(
        projection=layout.projection,
        projection_source=layout.source,
        projection_alternatives=layout.alternatives,
        views={role: ViewReport(turn.box_to_stored(box)) for role, box in layout.boxes.items()},
        special_views=special,
    )
    for told in tellings(special):
        (notes.doubt if told.doubt else notes.warn)(told.code, told.message)
    left_out = [turn.box_to_stored(box) for box in layout.left_out]
    view_like = [turn.box_to_stored(box) for box in may_be_views(layout.left_out)]
    if left_out:
        notes.warn(
            "lines-left-out",
            f"{len(left_out)} group(s) of lines belong to no view and were left out: "
            f"{_places(left_out)} px",
        )
    if view_like:
        notes.doubt(
            UNUSED,
            f"{len(view_like)} group(s) of lines at {_places(view_like)} px belong to no view, and "
            f"are large enough to be one: {_WHY_UNUSED}",
        )
    rest = [view for view in special if not view.used]
    notes.tell(
        unused=(
            *(Unused(view.kind.value, view.box, why_unused(view.kind)) for view in rest),
            *(Unused("lines", box, _WHY_UNUSED) for box in view_like),
        )
    )


def _places(boxes: Sequence[Box]) -> str:
    places = ("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in boxes[:_MOST_PLACES])
    return "; ".join(places)


def _tell_registration(notes: RunNotes, registered: RegisteredSheet, turn: Turn) -> None:
    notes.tell(
        scale_mm_per_pixel=registered.mm_per_pixel / turn.scale,
        bounding_box_mm=registered.views.size,
        strokes_source=registered.source.value,
        residuals_px={
            axis.name.lower(): (residual.median, residual.largest)
            for axis, residual in registered.extents.residuals.items()
        },
    )
    if notes.report.scale_source == ScaleSource.DEFAULT.value:
        notes.warn(
            "scale-assumed",
            "the scale is not known: the longest edge was made 100 mm; "
            "tell --length AXIS=MM or --mm-per-pixel",
        )
    for axis in registered.extents.disagreeing:
        spread = registered.extents.spread[axis]
        residual = registered.extents.residuals[axis]
        notes.warn(
            "views-disagree",
            f"the views differ by {spread:.1f} px in the part's extent along {axis.name}, and "
            f"by up to {residual.largest:.1f} px from the coordinates that they share: "
            "their mean was taken",
        )
    if not mutually_orthogonal(registered.views.roles):
        notes.doubt(
            "two-views", "only two directions of view: what a third would show is not known"
        )
