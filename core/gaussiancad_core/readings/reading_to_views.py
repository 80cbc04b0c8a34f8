"""A reading instead of reading: views and strokes of ``reading.json`` as those of a sheet.

Outlines come from the visible strokes alone: they are drawn, and filled as ink would be.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.errors import NoModelError, UnreadableError, UsageError
from gaussiancad_core.messages import filled
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Stroke
from gaussiancad_core.readings.boxed_views import Reread
from gaussiancad_core.readings.correcting import is_unseen
from gaussiancad_core.readings.reading_schema import (
    LINES,
    DimensionEntry,
    NoteEntry,
    SectionEntry,
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
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, line_mark
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.labels.label_evidence import SheetLabels
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.registration.view_masks import supersampling_for
from gaussiancad_core.sheet.sheet_stages import ReadView, Ring
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.views.painted_strokes import painted, view_by_strokes, visible_bounds
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.writing.callouts import Callout
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.note_texts import SheetNote
from gaussiancad_core.writing.numbers import Sign, Unit
from gaussiancad_core.writing.scale_agreement import Measure, ReadDimension
from gaussiancad_core.writing.section_titles import NamedSection, Trace
from gaussiancad_core.writing.sheet_scale import ScaleSource, SheetScale
from gaussiancad_core.writing.titles import Title, TitleKind
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.reading_kinds import DRAWN, StrokeKind, ViewRole

_CARRIED = (
    Code.OTHER_PEN_LINES,
    Code.DIMENSIONS_DISAGREE,
    Code.UNIT_CONTRADICTS_NOTE,
    Code.SIZE_CONTRADICTS_UNIT,
    Code.FULL_SCALE_ASSUMED,
    Code.DIMENSIONS_NOT_READ,
)
"""Codes of what only reading itself can tell."""

_BEYOND = 1.0
"""The sheet's longer side by which strokes may run beyond it."""

_ROLES = {role.value: role for role in Role}

_MARKS = {
    StrokeKind.CENTRE: AnnotationKind.CENTRE_LINE,
    StrokeKind.CUT: AnnotationKind.CENTRE_LINE,
    StrokeKind.HATCH: AnnotationKind.HATCHING,
    StrokeKind.DIMENSION: AnnotationKind.DIMENSION,
    StrokeKind.EXTENSION: AnnotationKind.EXTENSION,
    StrokeKind.LEADER: AnnotationKind.LEADER,
    StrokeKind.FRAME: AnnotationKind.FRAME,
    StrokeKind.TEXT: AnnotationKind.TEXT,
    StrokeKind.THREAD: AnnotationKind.THREAD,
    StrokeKind.TANGENT: AnnotationKind.TANGENT_EDGE,
    StrokeKind.SYMBOL: AnnotationKind.SYMBOL,
    StrokeKind.PICTURE: AnnotationKind.PICTURE,
}


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
        NoModelError: ``no-views``, ``empty-view``.
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
            if stroke.kind not in DRAWN and (mark := _mark(stroke, turn)) is not None
        )
        layout = _layout(job, reading, turn)
        tell_marks(notes, marks, turn)
        tell_layout(notes, layout, turn)
    with notes.stage("lines"):
        drawn = _drawn(reading, clean, reread)
        scale = _scale(reading, turn)
        reading_options = in_worked_px(_told_axis(job, reading).reading, turn)
        options = tell_scale(reading_options, scale, drawn, notes)
        notes.tell(dimensions=scale.dimensions)
        for problem in reading.problems:
            if problem.code in _CARRIED:
                tell = notes.doubt if problem.severity == "doubt" else notes.warn
                tell(problem.code, filled(problem.message, problem.args))
        found = tuple(_note(note, turn) for note in reading.notes)
        tell_notes(notes, found, turn)
        sections = tuple(_section(section, turn) for section in reading.sections)
        views = _beside(reading, clean)
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
    )


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


def _told_axis(job: Job, reading: SheetReading) -> Job:
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
        role = _ROLES.get(view.role.value)
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
    return view.source == "given" or view.role.value in _ROLES


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
            role, strokes[role], part, factor, (_source(view), view.dash, view.step)
        )
        read_view = replace(read_view, labels=_labels_of(reading, view, clean))
        drawn.append(_cut_open(read_view, view, clean.turn))
    return tuple(drawn)


def _beside(reading: SheetReading, clean: CleanSheet) -> tuple[ReadView, ...]:
    """Sections beside plain views."""
    found = []
    for view in reading.views:
        role = _ROLES.get(view.looks.value) if view.looks is not None else None
        strokes = _strokes_of(reading, view, clean.turn)
        if role is None or view.role is not ViewRole.SECTION or not strokes:
            continue
        read_view = ReadView(
            role,
            visible_bounds(strokes),
            strokes,
            None,
            _source(view),
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


def _cut_open(read_view: ReadView, view: ViewEntry, turn: Turn) -> ReadView:
    rings = tuple(_upright(ring, turn) for ring in view.hatch if len(ring) > 2)
    return replace(read_view, hatched=rings, opened=_upright(view.opened, turn))


def _upright(ring: Sequence[tuple[float, float]], turn: Turn) -> Ring:
    if not ring:
        return ()
    return tuple((float(x), float(y)) for x, y in turn.to_upright(np.array(ring)).tolist())


def _source(view: ViewEntry) -> StrokesSource:
    try:
        return StrokesSource(view.source)
    except ValueError:
        return StrokesSource.RASTER


def _mark(stroke: StrokeEntry, turn: Turn) -> Mark | None:
    kind = _MARKS.get(stroke.kind)
    if kind is None:
        return None
    if stroke.line is not None:
        (start, end) = turn.to_upright(np.array(stroke.line)).tolist()
        return line_mark(kind, tuple(start), tuple(end))
    return Mark(kind, turn.box_to_upright(stroke.box)) if stroke.box else None


def _scale(reading: SheetReading, turn: Turn) -> SheetScale:
    scale = reading.scale
    dimensions = tuple(_dimension(dimension, turn) for dimension in reading.dimensions)
    return SheetScale(
        None if scale.mm_per_px is None else scale.mm_per_px * turn.scale,
        ScaleSource(scale.source),
        dimensions,
        measures=tuple(dimension.measure for dimension in dimensions if dimension.measure),
        unit=Unit(reading.unit.value),
        unit_noted=reading.unit.source in ("sheet", "given"),
    )


def _note(note_entry: NoteEntry, turn: Turn) -> SheetNote:
    callout = Callout(
        note_entry.kind,
        note_entry.value_mm,
        note_entry.count,
        note_entry.depth_mm,
        note_entry.through,
        reference=note_entry.reference,
        unit=Unit.MILLIMETRE,
    )
    box = turn.box_to_upright(note_entry.box)
    circle = None if note_entry.circle is None else _circle(note_entry.circle, turn)
    return SheetNote(
        note_entry.text, box, callout, note_entry.value_mm, note_entry.depth_mm, circle
    )


def _dimension(dimension_entry: DimensionEntry, turn: Turn) -> ReadDimension:
    place = _place(dimension_entry, turn)
    measure = None
    if (
        place is not None
        and dimension_entry.told_mm is not None
        and dimension_entry.digit_mm is not None
    ):
        measure = Measure(place, dimension_entry.told_mm, dimension_entry.digit_mm)
    sign = Sign.LENGTH if dimension_entry.type == "linear" else Sign(dimension_entry.type)
    return ReadDimension(
        dimension_entry.text,
        dimension_entry.value_mm,
        dimension_entry.box,
        dimension_entry.mm_per_px,
        dimension_entry.used,
        sign,
        place,
        measure,
    )


def _section(section_entry: SectionEntry, turn: Turn) -> NamedSection:
    title = Title(TitleKind.SECTION, section_entry.label)
    box = turn.box_to_upright(section_entry.box)
    if section_entry.line is None or section_entry.way is None:
        return NamedSection(title, box)
    tip = np.add(section_entry.line[0], section_entry.way)
    start, end, ahead = turn.to_upright(np.array([*section_entry.line, tip])).tolist()
    away = np.subtract(ahead, start)
    way = tuple((away / np.hypot(*away)).tolist())
    ends = tuple(start), tuple(end)
    path: tuple[tuple[float, float], ...] = ends if section_entry.straight else ()
    if section_entry.path:
        path = tuple(map(tuple, turn.to_upright(np.array(section_entry.path)).tolist()))
    trace = Trace(section_entry.label, ends, way, path)
    cut_in = _ROLES.get(section_entry.in_view.value) if section_entry.in_view else None
    looks = _ROLES.get(section_entry.looks.value) if section_entry.looks else None
    axis = None
    if cut_in is not None:
        frame = cut_in.frame
        axis = (frame.right_axis if abs(way[0]) >= abs(way[1]) else frame.up_axis)[0]
    return NamedSection(title, box, trace, cut_in, looks, axis)


def _place(dimension_entry: DimensionEntry, turn: Turn) -> Span | Arc | None:
    if dimension_entry.measures is None:
        return None
    if dimension_entry.measures.span is not None:
        (x0, y0), (x1, y1) = turn.to_upright(np.array(dimension_entry.measures.span)).tolist()
        level = abs(x1 - x0) > abs(y1 - y0)
        low, high = sorted((x0, x1) if level else (y0, y1))
        return Span(level, low, high)
    if dimension_entry.measures.circle is not None:
        return _circle(dimension_entry.measures.circle, turn)
    return None


def _circle(circle: tuple[float, float, float], turn: Turn) -> Arc:
    x, y, radius = circle
    ((x, y),) = turn.to_upright(np.array([[x, y]])).tolist()
    return Arc((x, y), radius / turn.scale, 0.0, 2.0 * np.pi, Linetype.VISIBLE)
