"""The stages views and lines: a clean sheet to views with strokes, and what is told of them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from gaussiancad_core.errors import UsageError
from gaussiancad_core.evidence.projection_choice import opposite
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Arc, Linetype, Stroke
from gaussiancad_core.recognition.label_doubts import tell_doubtful_labels, weighed_views
from gaussiancad_core.recognition.one_view import shown_extents, unseen_extent_of
from gaussiancad_core.recognition.sheet_tangents import (
    SheetWithoutTangents,
    sheet_without_tangents,
)
from gaussiancad_core.recognition.sheet_views import SheetViews, sheet_views
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.report_entries import NoteReport, Unused, ViewReport
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, Mask
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.labels.label_evidence import NO_LABELS, SheetLabels
from gaussiancad_core.sheet.reading_options import Box, FileUnit, ReadingOptions
from gaussiancad_core.sheet.sheet_stages import ReadView, read_views
from gaussiancad_core.sheet.special_views.adjacent_sections import adjacent_sections_of
from gaussiancad_core.sheet.special_views.hatched_areas import (
    to_middles,
    with_hatched_areas,
    with_named_sections,
)
from gaussiancad_core.sheet.special_views.special_view_notes import (
    UNUSED,
    special_view_messages,
    why_unused,
)
from gaussiancad_core.sheet.special_views.tangent_policy import UNKNOWN_TANGENTS, SheetTangents
from gaussiancad_core.sheet.special_views.thread_symbols import arcs_of, without_threads
from gaussiancad_core.sheet.special_views.view_kinds import SECTIONS
from gaussiancad_core.sheet.views.sheet_layout import Layout, may_be_views
from gaussiancad_core.writing.dimension_texts import file_lines
from gaussiancad_core.writing.note_texts import SheetNote, notes_of
from gaussiancad_core.writing.number_units import file_unit
from gaussiancad_core.writing.numbers import Unit
from gaussiancad_core.writing.section_titles import NamedSection, named_sections
from gaussiancad_core.writing.sheet_scale import (
    ScaleSource,
    SheetScale,
    find_scale,
)
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import ResultKind

_MOST_PLACES = 5
"""Boxes that one message names at most."""

_WHY_FRAME = "it goes around everything that is drawn: a frame shows no part"
_WHY_UNUSED = "if they show the part, what they show may be missing"


@dataclass(frozen=True, eq=False)
class SheetLines:
    """What was read on a sheet before its views are brought together.

    Attributes:
        layout: where the views are, and what else was drawn.
        drawn: the views with their strokes, in the layout's order.
        marks: annotations, in px of the upright sheet.
        scale: what the sheet says of its scale; None where nobody asks.
        options: what the user says, with the scale that is taken.
        notes: what texts say of features.
        sections: those that have a title.
        loose: lines of the part that belong to no view, where none was found.
        adjacent_sections: sections that stand beside plain views of their directions.
        labels: what the lines of the sheet were taken for; nothing where no labels told it.
        unseen: what is known of the axis that the only view does not show; None of several views,
            and until :func:`with_unseen` asks.
        tangents: what the sheet does with tangent edges.
    """

    layout: Layout
    drawn: tuple[ReadView, ...]
    marks: tuple[Mark, ...]
    scale: SheetScale | None
    options: ReadingOptions
    notes: tuple[SheetNote, ...] = ()
    sections: tuple[NamedSection, ...] = ()
    loose: tuple[Stroke, ...] = ()
    adjacent_sections: tuple[ReadView, ...] = ()
    labels: SheetLabels = NO_LABELS
    unseen: Unseen | None = None
    tangents: SheetTangents = UNKNOWN_TANGENTS


def read_lines(job: Job, sheet: OpenedSheet, notes: RunNotes) -> SheetLines:
    """Views and lines of a sheet.

    Args:
        job: with what the user says of the sheet.
        sheet: as stored and upright.
        notes: told what is found.

    Raises:
        NoModelError: the sheet has no views that belong together.
    """
    turn = sheet.turn
    reading = in_worked_px(job.reading, turn)
    with notes.stage("views"):
        found = _views(sheet, reading, notes)
        tell_marks(notes, found.separated.marks, turn)
    with notes.stage("lines"):
        without, hatched = _strokes_in(sheet, found, reading, notes)
        found, drawn = without.found, without.drawn
        tell_doubtful_labels(notes, found.separated.labels, found.layout.boxes, turn)
        _tell_doubtful(notes, found.other_pens)
        notes.tell(tangent_edges=without.tangents)
        layout, separated = found.layout, found.separated
        scale = _sheet_scale(job, sheet, (found, drawn), notes)
        sections = _sections(sheet, scale, layout) if scale is not None else ()
        layout, drawn = _by_arrows(layout, drawn, sections)
        drawn, layout = with_named_sections(
            drawn, layout, [section.box for section in sections], hatched
        )

        def read(this_layout: Layout) -> tuple[ReadView, ...]:
            more = read_views(separated.part, this_layout, vectors=found.vectors)
            return weighed_views(more, separated.labels)

        looks = [(section.box, section.looks) for section in sections]
        layout, views = adjacent_sections_of(layout, looks, hatched, read)
        said = _notes(sheet.image, scale)
        tell_layout(notes, layout, turn, frame_guessed=found.frame_guessed)
        options = tell_scale(reading, scale, drawn, notes)
        tell_notes(notes, said, turn)
    stated = separated.marks, scale, options, said, sections
    return SheetLines(
        layout,
        drawn,
        *stated,
        adjacent_sections=views,
        labels=separated.labels,
        tangents=without.tangents,
    )


def with_unseen(lines: SheetLines, notes: RunNotes) -> SheetLines:
    """The same with what is known of the axis that the only view does not show.

    Args:
        lines: of the sheet.
        notes: told what is assumed.

    Raises:
        NoModelError: ``one-view`` where nothing tells it.
    """
    unseen = unseen_extent_of(lines.drawn, lines.scale, lines.notes, lines.options, notes)
    return replace(lines, unseen=unseen)


def boxed_views(job: Job, sheet: OpenedSheet, notes: RunNotes) -> tuple[ReadView, ...]:
    """The views that a job names by boxes, with their strokes; nothing else is read.

    Args, Raises: as of :func:`read_lines`.
    """
    reading = in_worked_px(job.reading, sheet.turn)
    found = _views(sheet, reading, notes)
    return _strokes_in(sheet, found, reading, notes)[0].drawn


def _strokes_in(
    sheet: OpenedSheet,
    found: SheetViews,
    reading: ReadingOptions,
    notes: RunNotes,
) -> tuple[SheetWithoutTangents, Mask | None]:
    """What was found, with the strokes of its views, and what is hatched in them."""
    separated, layout = found.separated, found.layout
    drawn = read_views(separated.part, layout, notes.progress, found.vectors)
    if found.of_file is not None:
        drawn = found.of_file.with_traced_lines(drawn)
    if found.vectors is not None:
        arcs = _arcs(sheet.image, sheet.turn)
    else:
        arcs = arcs_of(separated.strokes_known) if separated.strokes_known is not None else []
    drawn, threads = without_threads(drawn, arcs)
    layout = replace(layout, special=(*layout.special, *threads))
    without = sheet_without_tangents(replace(found, layout=layout), drawn)
    found, drawn, separated = without.found, without.drawn, without.found.separated
    drawn = weighed_views(drawn, separated.labels)
    hatched = to_middles(separated.hatched, separated.part.stroke_width)
    drawn = with_hatched_areas(drawn, layout, hatched)
    return replace(without, found=found, drawn=drawn), hatched


def _sections(sheet: OpenedSheet, scale: SheetScale, layout: Layout) -> tuple[NamedSection, ...]:
    drawing = sheet.image.vectors
    strokes = drawing.strokes if drawing is not None else ()
    others = [*(view.box for view in layout.special), *layout.left_out]
    return named_sections(
        scale.texts,
        sheet.heads,
        file_lines(strokes, sheet.turn),
        (layout.boxes, others, [view.box for view in layout.special if view.kind in SECTIONS]),
        sheet.turn,
    )


def _by_arrows(
    layout: Layout, drawn: tuple[ReadView, ...], sections: Sequence[NamedSection]
) -> tuple[Layout, tuple[ReadView, ...]]:
    """The views under the projection that the arrows of sections tell; as they are where they
    tell none, or something else does."""
    if not layout.alternatives or layout.symbol is not None:
        return layout, drawn
    roles = {box: role for role, box in layout.boxes.items()}
    stated = {
        section.looks is role
        for section in sections
        if section.looks is not None
        for role in [_role_at(roles, section.box)]
        if role is not None and section.looks in (role, opposite(role))
    }
    if len(stated) != 1:
        return layout, drawn
    known = replace(layout, source="inferred", alternatives=())
    if stated == {True}:
        return known, drawn
    boxes = {opposite(role): box for role, box in layout.boxes.items()}
    turned = tuple(replace(view, role=opposite(view.role)) for view in drawn)
    return replace(known, boxes=boxes, projection=layout.projection.other), turned


def _role_at(roles: dict[Box, Role], box: Box) -> Role | None:
    """The view that stands where a box is."""
    middle = (box[0] + box[2]) / 2.0, (box[1] + box[3]) / 2.0
    return next(
        (
            role
            for pair, role in roles.items()
            if pair[0] <= middle[0] <= pair[2] and pair[1] <= middle[1] <= pair[3]
        ),
        None,
    )


def _arcs(image: SheetImage, turn: Turn) -> list[Arc]:
    """The arcs of a file, of all pens; none where the sheet lies turned."""
    if turn.angle or image.vectors is None:
        return []
    curves = (stroke.curve for stroke in image.vectors.strokes)
    return [
        Arc(curve.centre, curve.radius, curve.start_angle, curve.sweep, Linetype.VISIBLE)
        for curve in curves
        if isinstance(curve, CircularArc)
    ]


def in_worked_px(reading: ReadingOptions, turn: Turn) -> ReadingOptions:
    """What was told of px of the sheet as stored, of those that are worked on."""
    if reading.mm_per_pixel is None:
        return reading
    return replace(reading, mm_per_pixel=reading.mm_per_pixel * turn.scale)


def _sheet_scale(
    job: Job,
    sheet: OpenedSheet,
    read: tuple[SheetViews, tuple[ReadView, ...]],
    notes: RunNotes,
) -> SheetScale | None:
    """What the sheet's dimensions, paper and notes say; None where nobody asks."""
    found, drawn = read
    if _is_given(job.reading, drawn) and job.result is ResultKind.SURFACE:
        return None
    unit = _number_unit(job.reading.unit)
    scale = find_scale(sheet, found.separated.marks, drawn, found.texts, stated_unit=unit)
    notes.tell(dimensions=scale.dimensions)
    for note in scale.contradictions:
        notes.doubt(note.code, note.message)
    return scale


def _notes(image: SheetImage, scale: SheetScale | None) -> tuple[SheetNote, ...]:
    """What the texts say that were read for the scale."""
    if scale is None:
        return ()
    bare_point_is_inch = file_unit(image.vectors) is None
    return notes_of(scale.texts, scale.unit, scale.targets, bare_point_is_inch=bare_point_is_inch)


def _number_unit(unit: FileUnit | None) -> Unit | None:
    """The unit that numbers are in as the user says; None of units that no dimension is in."""
    return next(
        (this_unit for this_unit in Unit if unit is not None and this_unit.value == unit.value),
        None,
    )


def _is_given(reading: ReadingOptions, drawn: Sequence[ReadView]) -> bool:
    """Whether the user says a scale: an extent that no view shows says none."""
    stated = reading.scaling_length(shown_extents(drawn))
    return stated is not None or reading.mm_per_pixel is not None


def tell_scale(
    reading: ReadingOptions, scale: SheetScale | None, drawn: Sequence[ReadView], notes: RunNotes
) -> ReadingOptions:
    """What the user said, with the scale that the sheet tells where they said none.

    Raises:
        UsageError: the user says it in two ways.
    """
    stated = reading.scaling_length(shown_extents(drawn))
    if reading.mm_per_pixel is not None and stated is not None:
        raise UsageError(
            Code.WRONG_USAGE,
            "--mm-per-pixel and --length along {axis} both set the scale: leave one out",
            axis=stated[0].name.lower(),
        )
    if scale is None or _is_given(reading, drawn):
        notes.tell(scale_source=ScaleSource.GIVEN.value)
        return reading
    notes.tell(scale_source=scale.source.value)
    for note in scale.notes:
        notes.warn(note.code, note.message)
    return replace(reading, mm_per_pixel=scale.mm_per_pixel)


def _views(sheet: OpenedSheet, reading: ReadingOptions, notes: RunNotes) -> SheetViews:
    """The part's ink and its views, with what is in doubt about them told."""
    given = {role: sheet.turn.box_to_upright(box) for role, box in reading.views}
    found = sheet_views(sheet, given, reading.projection)
    if found.labels_problem is not None:
        notes.warn(Code.LABELS_MISSING, found.labels_problem)
    return found


def _tell_doubtful(notes: RunNotes, lines: Sequence[LineSegment]) -> None:
    """Say which lines of the views were not used for their pen alone."""
    if lines:
        boxes = [line.box for line in lines]
        places = ", ".join(
            f"({(box[0] + box[2]) / 2.0:.0f}, {(box[1] + box[3]) / 2.0:.0f})"
            for box in boxes[:_MOST_PLACES]
        )
        notes.doubt(
            Code.OTHER_PEN_LINES,
            Message(
                "{count} line(s) run from edge to edge in another pen than the part's and were not "
                "used, at {places} px: if they show the part, what they show is missing",
                count=len(boxes),
                places=places,
            ),
        )


def tell_marks(notes: RunNotes, marks: tuple[Mark, ...], turn: Turn) -> None:
    """Put the places of annotations into the report."""
    kinds: dict[str, list[Box]] = {}
    for mark in marks:
        kinds.setdefault(mark.kind.value, []).append(turn.box_to_stored(mark.box))
    notes.tell(annotations=kinds)


def tell_notes(notes: RunNotes, found: Sequence[SheetNote], turn: Turn) -> None:
    """Put what texts say of features into the report."""
    reports = tuple(
        NoteReport(
            note.text,
            note.callout.kind.value,
            note.value_mm,
            turn.box_to_stored(note.box),
            note.callout.count,
            note.depth_mm,
            note.callout.through,
        )
        for note in found
    )
    notes.tell(notes=reports)


def tell_layout(
    notes: RunNotes, layout: Layout, turn: Turn, *, frame_guessed: bool = False
) -> None:
    """Put views and all else that was drawn into the report, and what is in doubt for them."""
    special = tuple(replace(view, box=turn.box_to_stored(view.box)) for view in layout.special)
    notes.tell(
        projection=layout.projection,
        projection_source=layout.source,
        projection_alternatives=layout.alternatives,
        views={role: ViewReport(turn.box_to_stored(box)) for role, box in layout.boxes.items()},
        special_views=special,
    )
    for telling in special_view_messages(special):
        (notes.doubt if telling.doubt else notes.warn)(telling.code, telling.message)
    left_out = [turn.box_to_stored(box) for box in layout.left_out]
    view_like = [turn.box_to_stored(box) for box in may_be_views(layout.left_out)]
    if left_out:
        notes.warn(
            Code.LINES_LEFT_OUT,
            Message(
                "{count} group(s) of lines belong to no view and were left out: {places} px",
                boxes=left_out,
                count=len(left_out),
                places=_places(left_out),
            ),
        )
    if view_like:
        notes.doubt(
            UNUSED,
            Message(
                "{count} group(s) of lines at {places} px belong to no view, and are large enough "
                "to be one: {why}",
                boxes=view_like,
                case="lines",
                count=len(view_like),
                places=_places(view_like),
                why=_WHY_UNUSED,
            ),
        )
    frame = [turn.box_to_stored(layout.frame)] if layout.frame is not None else []
    if frame and frame_guessed:
        notes.doubt(
            Code.FRAME_LEFT_OUT,
            Message(
                "the lines around everything at {places} px were taken for a frame; they may be "
                "the part's outline, and what was taken for its view a pocket in it",
                boxes=frame,
                case="guessed",
                places=_places(frame),
            ),
        )
    elif frame:
        notes.warn(
            Code.FRAME_LEFT_OUT,
            Message(
                "the lines around everything at {places} px were taken for a frame, not for the "
                "part's outline",
                boxes=frame,
                places=_places(frame),
            ),
        )
    rest = [view for view in special if not view.used]
    notes.tell(
        unused=(
            *(Unused("frame", box, _WHY_FRAME) for box in frame),
            *(Unused(view.kind.value, view.box, why_unused(view.kind)) for view in rest),
            *(Unused("lines", box, _WHY_UNUSED) for box in view_like),
        )
    )


def _places(boxes: Sequence[Box]) -> str:
    places = ("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in boxes[:_MOST_PLACES])
    return "; ".join(places)
