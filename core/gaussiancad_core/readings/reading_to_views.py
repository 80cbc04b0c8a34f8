"""A reading instead of reading: views and strokes of ``reading.json`` as those of a sheet.

Outlines come from the visible strokes alone: they are drawn, and filled as ink would be.
"""

from dataclasses import replace

from gaussiancad_core.errors import NoModelError, UnreadableError, UsageError
from gaussiancad_core.messages import filled
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Linetype, Stroke
from gaussiancad_core.readings.boxed_views import Reread
from gaussiancad_core.readings.correcting import is_unseen
from gaussiancad_core.readings.reading_entries import (
    ROLES,
    mark_of,
    note_of,
    scale_of,
    section_of,
    strokes_source,
    upright_ring,
)
from gaussiancad_core.readings.reading_schema import (
    GIVEN,
    LINES,
    SheetReading,
    StrokeEntry,
    ViewEntry,
)
from gaussiancad_core.readings.reading_shapes import stroke_of
from gaussiancad_core.readings.stroke_anchors import box_of
from gaussiancad_core.readings.stroke_certainty import entry_labels
from gaussiancad_core.recognition.label_doubts import DOUBTFUL, tell_doubtful_labels
from gaussiancad_core.recognition.views_and_lines import (
    SheetLines,
    in_worked_px,
    tell_layout,
    tell_marks,
    tell_notes,
    tell_scale,
)
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.labels.label_evidence import SheetLabels
from gaussiancad_core.sheet.registration.view_masks import supersampling_for
from gaussiancad_core.sheet.sheet_stages import ReadView, check_amount
from gaussiancad_core.sheet.special_views.tangent_edges import without_tangent_edges
from gaussiancad_core.sheet.special_views.tangent_policy import SheetTangents
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.views.painted_strokes import painted, view_by_strokes, visible_bounds
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.reading_kinds import DRAWN, StrokeKind, ViewRole

_CARRIED = (
    Code.OTHER_PEN_LINES,
    Code.DIMENSIONS_DISAGREE,
    Code.UNIT_CONTRADICTS_NOTE,
    Code.SIZE_CONTRADICTS_UNIT,
    Code.FULL_SCALE_ASSUMED,
)
"""Codes of what only reading itself can tell."""

_BEYOND = 1.0
"""The sheet's longer side by which strokes may run beyond it."""


def taken_lines(
    job: Job, sheet: OpenedSheet, reading: SheetReading, notes: RunNotes, reread: Reread
) -> SheetLines:
    """The views and lines of a reading.

    Args:
        job: with what the user says: a projection and a scale go before those of the reading.
        sheet: that was read.
        reading: of it.
        notes: told what is found.
        reread: for views that the reading has no strokes of.

    Raises:
        UnreadableError: ``reading-not-read``: a stroke runs far beyond the sheet.
        UsageError: ``reading-of-another-sheet``, ``role-repeated``; a box holds nothing to read.
        NoModelError: ``no-views``, ``empty-view``, ``part-too-complex``.
    """
    image, clean = sheet.image, sheet.clean
    if reading.sheet.sha256 != image.sha256 or reading.sheet.page != job.page:
        raise UsageError(
            Code.READING_OF_ANOTHER_SHEET,
            "the reading belongs to another sheet or page than {sheet}: read that with "
            "`gaussiancad read`",
            sheet=image.path.name,
        )
    _check_places(reading, sheet.size)
    turn = clean.turn
    with notes.stage("views"):
        marks = tuple(
            mark
            for stroke in reading.strokes
            if stroke.kind not in DRAWN
            and not _is_tangent(stroke)
            and (mark := mark_of(stroke, turn)) is not None
        )
        layout = _layout(job, reading, turn)
        tell_marks(notes, marks, turn)
        tell_layout(notes, layout, turn)
    with notes.stage("lines"):
        drawn, tangents = _with_tangents(_drawn(reading, clean, reread), reading)
        notes.tell(tangent_edges=tangents)
        for view in drawn:
            check_amount(view)
        scale = scale_of(reading, turn)
        reading_options = in_worked_px(_with_given_length(job, reading).reading, turn)
        options = tell_scale(reading_options, scale, drawn, notes)
        notes.tell(dimensions=scale.dimensions)
        for problem in reading.problems:
            if problem.code in _CARRIED:
                tell = notes.doubt if problem.severity == "doubt" else notes.warn
                tell(problem.code, filled(problem.message, problem.args))
        found = tuple(note_of(note, turn) for note in reading.notes)
        tell_notes(notes, found, turn)
        sections = tuple(section_of(section, turn) for section in reading.sections)
        views = _adjacent_sections(reading, clean)
        labels = entry_labels(reading.strokes, turn, clean.stroke_width)
        _tell_labels(notes, reading, labels, layout, turn)
    return SheetLines(
        layout,
        drawn,
        marks,
        scale,
        options,
        found,
        sections,
        adjacent_sections=views,
        labels=labels,
        tangents=tangents,
    )


def _with_tangents(
    drawn: tuple[ReadView, ...], reading: SheetReading
) -> tuple[tuple[ReadView, ...], SheetTangents]:
    """The views, and what the sheet does with tangent edges; where a person says that it draws
    them, also without those that were read as edges."""
    read = reading.tangent_edges
    counts = read.drawn, read.thin, read.left_out
    tangents = SheetTangents(TangentPolicy(read.policy), read.source, *counts)
    if read.source != GIVEN or not tangents.policy.draws:
        return drawn, tangents
    found = without_tangent_edges(drawn, given=tangents.policy)
    return found.views, tangents


def _is_tangent(stroke: StrokeEntry) -> bool:
    """Whether a stroke is a tangent edge of a view, and has a shape."""
    has_shape = any(shape is not None for shape in (stroke.line, stroke.arc, stroke.ellipse))
    return stroke.kind is StrokeKind.TANGENT and stroke.view is not None and has_shape


def _check_places(reading: SheetReading, size: tuple[int, int]) -> None:
    """Refuse strokes far from the sheet, which it cannot show: all is done along strokes by px."""
    beyond = _BEYOND * max(size)
    for stroke in reading.strokes:
        box = box_of(stroke) if stroke.kind in DRAWN else None
        if box is not None and (min(box) < -beyond or max(box) > max(size) + beyond):
            raise UnreadableError(
                Code.READING_NOT_READ,
                "{path} was not taken: {reason}; write it with `gaussiancad read`, or mend that "
                "place",
                path="the reading",
                reason=f"the stroke {stroke.id} runs far beyond the sheet",
            )


def _tell_labels(
    notes: RunNotes, reading: SheetReading, labels: SheetLabels, layout: Layout, turn: Turn
) -> None:
    """Say which lines may be edges or annotation: as the reading does, or, where a person
    corrected it, those that are still in doubt."""
    read = next((problem for problem in reading.problems if problem.code == DOUBTFUL), None)
    if read is not None and not reading.corrected:
        notes.doubt(DOUBTFUL, filled(read.message, read.args, read.at))
    else:
        tell_doubtful_labels(notes, labels, layout.boxes, turn)


def _with_given_length(job: Job, reading: SheetReading) -> Job:
    """The job with the length that the reading was told, unless the user tells another scale;
    one that no view shows tells none, and is taken beside it."""
    reading_options, scale = job.reading, reading.scale
    if scale.axis is None or scale.length_mm is None:
        return job
    axis = Axis[scale.axis.upper()]
    is_told = reading_options.lengths or reading_options.mm_per_pixel
    if reading_options.length_along(axis) or (is_told and not is_unseen(reading, scale.axis)):
        return job
    return replace(
        job,
        reading=replace(
            reading_options, lengths=(*reading_options.lengths, (axis, scale.length_mm))
        ),
    )


def _principal(reading: SheetReading) -> dict[Role, ViewEntry]:
    found: dict[Role, ViewEntry] = {}
    for view in reading.views:
        role = ROLES.get(view.role.value)
        if role is None:
            continue
        if role in found:
            raise UsageError(
                Code.ROLE_REPEATED,
                "the reading has two {view} views, {first} and {second}: a part is seen from there "
                "once",
                view=role,
                first=found[role].id,
                second=view.id,
            )
        found[role] = view
    return found


def _layout(job: Job, reading: SheetReading, turn: Turn) -> Layout:
    read_projection = reading.projection
    asked = job.reading.projection
    projection = asked or Projection(read_projection.value)
    alternatives = (
        ()
        if asked
        else tuple(Projection(alternative) for alternative in read_projection.alternatives)
    )
    return Layout(
        boxes={role: turn.box_to_upright(view.box) for role, view in _principal(reading).items()},
        projection=projection,
        source="given"
        if asked
        else "inferred"
        if read_projection.source == "symbol"
        else read_projection.source,
        alternatives=alternatives,
        left_out=tuple(
            turn.box_to_upright(view.box)
            for view in reading.views
            if view.kind == LINES and not _is_settled(view)
        ),
        special=tuple(
            SpecialView(
                SpecialKind(view.kind),
                turn.box_to_upright(view.box),
                view.used,
                turn.box_to_upright(view.cut) if view.cut else None,
                view.looks is not None,
            )
            for view in reading.views
            if view.kind in _SPECIAL and not _is_settled(view)
        ),
        symbol=projection if read_projection.source == "symbol" and not asked else None,
    )


_SPECIAL = {kind.value for kind in SpecialKind}


def _is_settled(view: ViewEntry) -> bool:
    """Whether a person said what a group of lines is: then it is in no doubt."""
    return view.source == "given" or view.role.value in ROLES


def _drawn(reading: SheetReading, clean: CleanSheet, reread: Reread) -> tuple[ReadView, ...]:
    views = _principal(reading)
    if not views:
        raise NoModelError(
            Code.NO_VIEWS,
            "the reading names no view of the part: give each its role, and a box around it",
        )
    strokes = {role: _strokes_of(reading, view, clean.turn) for role, view in views.items()}
    empty = [
        role
        for role, this_strokes in strokes.items()
        if not any(stroke.linetype is Linetype.VISIBLE for stroke in this_strokes)
    ]
    known = {entry.view for entry in reading.strokes}
    for role in empty:
        if views[role].id in known:
            raise NoModelError(
                Code.EMPTY_VIEW,
                "the {view} view at {place} px has no visible line",
                view=role,
                place="({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*views[role].box),
            )
    boxes = tuple((role, view.box) for role, view in views.items())
    found = {view.role: view for view in (reread(boxes) if empty else ())}
    for role in empty:
        strokes[role] = found[role].strokes
    part = painted([item for view in strokes.values() for item in view], clean)
    largest = max(max(x1 - x0, y1 - y0) for x0, y0, x1, y1 in map(visible_bounds, strokes.values()))
    factor = supersampling_for(largest)
    drawn = []
    for role, view in views.items():
        if role in empty:
            drawn.append(found[role])
            continue
        read_view = view_by_strokes(
            role, strokes[role], part, factor, (strokes_source(view), view.dash, view.step)
        )
        labels, tangents = _labels_of(reading, view, clean), _tangents_of(reading, view, clean.turn)
        read_view = replace(read_view, labels=labels, tangents=tangents)
        drawn.append(_cut_open(read_view, view, clean.turn))
    return tuple(drawn)


def _adjacent_sections(reading: SheetReading, clean: CleanSheet) -> tuple[ReadView, ...]:
    """Sections beside plain views."""
    found = []
    for view in reading.views:
        role = ROLES.get(view.looks.value) if view.looks is not None else None
        strokes = _strokes_of(reading, view, clean.turn)
        if role is None or view.role is not ViewRole.SECTION or not strokes:
            continue
        read_view = ReadView(
            role,
            visible_bounds(strokes),
            strokes,
            None,
            strokes_source(view),
            view.dash,
            view.step,
            labels=_labels_of(reading, view, clean),
        )
        found.append(_cut_open(read_view, view, clean.turn))
    return tuple(this_view for this_view in found if this_view.hatched)


def _labels_of(reading: SheetReading, view: ViewEntry, clean: CleanSheet) -> SheetLabels:
    entries = (entry for entry in reading.strokes if entry.view == view.id and entry.kind in DRAWN)
    return entry_labels(entries, clean.turn, clean.stroke_width)


def _strokes_of(reading: SheetReading, view: ViewEntry, turn: Turn) -> tuple[Stroke, ...]:
    return tuple(
        stroke
        for entry in reading.strokes
        if entry.view == view.id
        and entry.kind in DRAWN
        and (stroke := stroke_of(entry, turn)) is not None
    )


def _tangents_of(reading: SheetReading, view: ViewEntry, turn: Turn) -> tuple[Stroke, ...]:
    entries = (entry for entry in reading.strokes if entry.view == view.id and _is_tangent(entry))
    return tuple(stroke for entry in entries if (stroke := stroke_of(entry, turn)) is not None)


def _cut_open(read_view: ReadView, view: ViewEntry, turn: Turn) -> ReadView:
    rings = tuple(upright_ring(ring, turn) for ring in view.hatch if len(ring) > 2)
    return replace(read_view, hatched=rings, opened=upright_ring(view.opened, turn))
