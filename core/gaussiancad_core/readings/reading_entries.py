"""Entries of a reading as the sheet's stages take them: scale, notes, dimensions, sections."""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.readings.reading_schema import (
    DimensionEntry,
    NoteEntry,
    SectionEntry,
    SheetReading,
    StrokeEntry,
    ViewEntry,
)
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, line_mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import Ring
from gaussiancad_core.writing.callouts import Callout
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.note_texts import SheetNote
from gaussiancad_core.writing.numbers import Sign, Unit
from gaussiancad_core.writing.scale_agreement import Measure, ReadDimension
from gaussiancad_core.writing.section_titles import NamedSection, Trace
from gaussiancad_core.writing.sheet_scale import ScaleSource, SheetScale
from gaussiancad_core.writing.titles import Title, TitleKind
from gaussiancad_protocol.reading_kinds import StrokeKind

ROLES = {role.value: role for role in Role}
"""Roles by the names that readings give them."""

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


def upright_ring(ring: Sequence[tuple[float, float]], turn: Turn) -> Ring:
    """A ring of points, px of the sheet as stored, on the upright sheet."""
    if not ring:
        return ()
    return tuple((float(x), float(y)) for x, y in turn.to_upright(np.array(ring)).tolist())


def strokes_source(view: ViewEntry) -> StrokesSource:
    """Where a view's strokes come from; the picture where the reading names nothing known."""
    try:
        return StrokesSource(view.source)
    except ValueError:
        return StrokesSource.RASTER


def mark_of(stroke: StrokeEntry, turn: Turn) -> Mark | None:
    """What a stroke that is no edge is on the upright sheet; None of an edge."""
    kind = _MARKS.get(stroke.kind)
    if kind is None:
        return None
    if stroke.line is not None:
        (start, end) = turn.to_upright(np.array(stroke.line)).tolist()
        return line_mark(kind, tuple(start), tuple(end))
    return Mark(kind, turn.box_to_upright(stroke.box)) if stroke.box else None


def scale_of(reading: SheetReading, turn: Turn) -> SheetScale:
    """The scale, with the dimensions that tell it."""
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


def note_of(note_entry: NoteEntry, turn: Turn) -> SheetNote:
    """A note at a feature."""
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
    pointed = tuple(_circle(each, turn) for each in note_entry.points_at)
    return SheetNote(
        note_entry.text, box, callout, note_entry.value_mm, note_entry.depth_mm, circle, pointed
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


def section_of(section_entry: SectionEntry, turn: Turn) -> NamedSection:
    """A section, with the line along which it cuts."""
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
    cut_in = ROLES.get(section_entry.in_view.value) if section_entry.in_view else None
    looks = ROLES.get(section_entry.looks.value) if section_entry.looks else None
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
