"""What was read on a sheet -> ``reading.json``."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Literal

import msgspec
import numpy as np

from gaussiancad_core import __version__
from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.messages import args_of, event_fields
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Arc, Stroke
from gaussiancad_core.readings.reading_schema import (
    LARGEST,
    LINES,
    SCHEMA,
    DimensionEntry,
    Measured,
    NoteEntry,
    Problem,
    ReadProjection,
    ReadScale,
    ReadSheet,
    ReadTangentEdges,
    ReadUnit,
    SectionEntry,
    SheetReading,
    StrokeEntry,
    ViewEntry,
)
from gaussiancad_core.readings.reading_shapes import stored_box, stored_points, stored_ring
from gaussiancad_core.readings.stroke_certainty import (
    OF_FILE,
    Certainty,
    mark_certainty,
    read_entry,
    tangent_entry,
    view_certainty,
)
from gaussiancad_core.recognition.one_view import shown_extents
from gaussiancad_core.recognition.views_and_lines import SheetLines
from gaussiancad_core.report.report_entries import Remark
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.note_texts import SheetNote
from gaussiancad_core.writing.numbers import Sign
from gaussiancad_core.writing.scale_agreement import ReadDimension
from gaussiancad_core.writing.section_titles import NamedSection, Trace
from gaussiancad_core.writing.sheet_scale import ScaleSource, SheetScale
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.reading_kinds import StrokeKind, ViewRole

READING_FILE = "reading.json"

_AXES: dict[Axis, Literal["x", "y", "z"]] = {Axis.X: "x", Axis.Y: "y", Axis.Z: "z"}

_SIGNS: dict[Sign, Literal["linear", "diameter", "radius"]] = {
    Sign.LENGTH: "linear",
    Sign.DIAMETER: "diameter",
    Sign.RADIUS: "radius",
}

_ROLES = {
    SpecialKind.SECTION: ViewRole.SECTION,
    SpecialKind.HALF_SECTION: ViewRole.SECTION,
    SpecialKind.PARTIAL_SECTION: ViewRole.SECTION,
    SpecialKind.DETAIL: ViewRole.DETAIL,
    SpecialKind.AUXILIARY: ViewRole.AUXILIARY,
    SpecialKind.PICTORIAL: ViewRole.PICTORIAL,
}
"""What drawings that are no plain views show; others are ignored."""

_KINDS = {
    AnnotationKind.FRAME: StrokeKind.FRAME,
    AnnotationKind.TITLE_BLOCK: StrokeKind.FRAME,
    AnnotationKind.TEXT: StrokeKind.TEXT,
    AnnotationKind.DIMENSION: StrokeKind.DIMENSION,
    AnnotationKind.EXTENSION: StrokeKind.EXTENSION,
    AnnotationKind.LEADER: StrokeKind.LEADER,
    AnnotationKind.CENTRE_LINE: StrokeKind.CENTRE,
    AnnotationKind.CENTRE_MARK: StrokeKind.CENTRE,
    AnnotationKind.SYMMETRY: StrokeKind.CENTRE,
    AnnotationKind.SYMBOL: StrokeKind.SYMBOL,
    AnnotationKind.PICTURE: StrokeKind.PICTURE,
    AnnotationKind.HATCHING: StrokeKind.HATCH,
    AnnotationKind.THREAD: StrokeKind.THREAD,
    AnnotationKind.TANGENT_EDGE: StrokeKind.TANGENT,
}

_OFFERS: dict[str, tuple[str, ...]] = {
    Code.OPEN_OUTLINE: ("draw", "view"),
    Code.SCALE_ASSUMED: ("scale",),
    Code.FULL_SCALE_ASSUMED: ("scale",),
    Code.UNIT_CONTRADICTS_NOTE: ("scale",),
    Code.SIZE_CONTRADICTS_UNIT: ("scale",),
    Code.DIMENSIONS_DISAGREE: ("dimension", "scale"),
    Code.UNUSED_VIEW: ("view",),
    Code.LINES_LEFT_OUT: ("view",),
    Code.OTHER_PEN_LINES: ("kind",),
    Code.LABELS_DOUBTFUL: ("kind",),
    Code.VIEWS_DISAGREE: ("view", "erase"),
    Code.SYMBOL_CONTRADICTS_LINES: ("projection",),
}
"""Corrections that may help, by the code of what is in doubt."""

_NO_VIEWS = ("view",)
"""The same where a sheet was refused for another reason: its views are not where they are."""


def sheet_reading(
    report: Report,
    lines: SheetLines,
    turn: Turn,
    size: tuple[int, int],
    refused: Sequence[Problem] = (),
) -> SheetReading:
    """What was read.

    Args:
        report: so far, with the sheet's hash, the projection and what is in doubt.
        lines: views and strokes, px of the upright sheet.
        turn: of the upright sheet.
        size: width and height of the sheet as stored, px.
        refused: why no part follows, if that is so.
    """
    scale = lines.scale
    stated: tuple[tuple[Sequence[Remark], Literal["doubt", "warning"]], ...] = (
        (report.reasons, "doubt"),
        (report.warnings, "warning"),
    )
    doubts = [
        Problem(
            **event_fields(remark.code, remark.message),
            severity=severity,
            offers=_offers(remark.code),
        )
        for remarks, severity in stated
        for remark in remarks
    ]
    return SheetReading(
        schema=SCHEMA,
        engine=__version__,
        sheet=ReadSheet(
            sha256=report.sheet_sha256,
            page=int(report.settings.get("page", 1)),
            size=size,
            turn=round(float(turn.angle), 8),
        ),
        projection=ReadProjection(
            value=lines.layout.projection.value,
            source=_projection_source(lines.layout),
            alternatives=tuple(alternative.value for alternative in lines.layout.alternatives),
        ),
        unit=_unit(scale),
        scale=_scale(lines, turn),
        views=(
            *(_view(view, turn) for view in lines.drawn),
            *_specials(lines, turn),
            *(_left_out(n, pair, turn) for n, pair in enumerate(lines.layout.left_out, start=1)),
        ),
        strokes=tuple(_strokes(lines, turn)),
        dimensions=tuple(
            _dimension(number, dimension, turn)
            for number, dimension in enumerate(scale.dimensions if scale else (), start=1)
            if dimension.value_mm <= LARGEST
        ),
        notes=tuple(_note(note, turn) for note in lines.notes),
        sections=tuple(_section(section, turn) for section in lines.sections),
        problems=(*refused, *doubts),
        tangent_edges=ReadTangentEdges(
            policy=lines.tangents.policy.value,
            source=lines.tangents.source,
            drawn=lines.tangents.drawn,
            thin=lines.tangents.thin,
            left_out=lines.tangents.left_out,
        ),
        corrected=_corrections(report),
    )


def refusal(code: str, message: str) -> Problem:
    """Why no part follows from a sheet."""
    offers = _offers(code) or _NO_VIEWS
    if code == Code.ONE_VIEW and "axis" in args_of(message):
        # A length along an axis that no view shows is the thickness.
        offers = ("scale", *offers)
    return Problem(**event_fields(code, message), severity="refused", offers=offers)


def _corrections(report: Report) -> int:
    """How often a person corrected what was read."""
    for warning in report.warnings:
        if warning.code == Code.CORRECTED:
            return int(args_of(warning.message).get("count", 0))
    return 0


def write_reading(reading: SheetReading, folder: Path) -> None:
    """Write ``reading.json`` into a folder."""
    (folder / READING_FILE).write_bytes(msgspec.json.encode(reading) + b"\n")


def _offers(code: str) -> tuple[str, ...]:
    return _OFFERS.get(code, ())


def _unit(scale: SheetScale | None) -> ReadUnit:
    if scale is None:
        return ReadUnit()
    text = "sheet" if scale.unit_noted else "dimension" if scale.dimensions else "default"
    return ReadUnit(value=scale.unit.value, source=text)


def _note(note: SheetNote, turn: Turn) -> NoteEntry:
    said = note.callout
    return NoteEntry(
        text=note.text[:1000],
        kind=said.kind,
        box=stored_box(note.box, turn),
        value_mm=note.value_mm if (note.value_mm or 0.0) <= LARGEST else None,
        count=said.count,
        depth_mm=note.depth_mm if (note.depth_mm or 0.0) <= LARGEST else None,
        through=said.through,
        reference=said.reference,
        points_at=tuple(_circle(arc, turn) for arc in note.pointed),
    )


def _section(section: NamedSection, turn: Turn) -> SectionEntry:
    trace = section.trace
    line = way = None
    if trace is not None:
        start, end, tip = stored_points([*trace.ends, np.add(trace.ends[0], trace.way)], turn)
        line = start, end
        away = np.subtract(tip, start)
        way = tuple((away / np.hypot(*away)).round(6).tolist())
    return SectionEntry(
        label=section.title.label,
        box=stored_box(section.box, turn),
        in_view=ViewRole(section.cut_in.value) if section.cut_in else None,
        line=line,
        way=way,
        straight=trace is None or trace.straight,
        path=_corners(trace, turn),
        looks=ViewRole(section.looks.value) if section.looks else None,
    )


def _corners(trace: Trace | None, turn: Turn) -> tuple[tuple[float, float], ...]:
    """Corners of a cutting line in steps; nothing of a straight one, or where none were found."""
    if trace is None or trace.straight or not trace.path:
        return ()
    return tuple(stored_points(trace.path, turn))


def _scale(lines: SheetLines, turn: Turn) -> ReadScale:
    options, scale = lines.options, lines.scale
    given = options.mm_per_pixel is not None or bool(options.lengths)
    source = ScaleSource.GIVEN if given else ScaleSource.DEFAULT
    if scale is not None and options.mm_per_pixel == scale.mm_per_pixel:
        source = scale.source
    per_pixel, lengths = options.mm_per_pixel, options.lengths
    if per_pixel is None and len(lengths) > 1:
        # A reading has one length: that which no view shows, beside the scale that the other tells.
        extents = shown_extents(lines.drawn)
        scaling = options.scaling_length(extents)
        if scaling is not None:
            per_pixel = scaling[1] / extents[scaling[0]]
            lengths = tuple(this_length for this_length in lengths if this_length[0] not in extents)
    axis, length = lengths[0] if lengths else (None, None)
    return ReadScale(
        source=source.value,
        mm_per_px=None if per_pixel is None else per_pixel / turn.scale,
        axis=_AXES[axis] if axis is not None else None,
        length_mm=length,
    )


def _rounded(box: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    """A box to hundredths of a px."""
    x0, y0, x1, y1 = (round(float(value), 2) for value in box)
    return x0, y0, x1, y1


def _view(view: ReadView, turn: Turn) -> ViewEntry:
    return ViewEntry(
        id=view.role.value,
        role=ViewRole(view.role.value),
        box=_rounded(view.stored_box(turn)),
        source=view.source.value,
        hidden_lines="drawn" if view.has_hidden_lines else "none",
        dash=view.dash,
        step=view.step,
        hatch=tuple(stored_ring(items, turn) for items in view.hatched),
        opened=stored_ring(view.opened, turn),
    )


def _specials(lines: SheetLines, turn: Turn) -> Iterator[ViewEntry]:
    views = iter(lines.adjacent_sections)
    for number, special_view in enumerate(lines.layout.special, start=1):
        entry = _special(number, special_view, turn)
        if special_view.adjacent:
            view = _view(next(views), turn)
            more = {
                name: getattr(view, name) for name in ("source", "dash", "step", "hatch", "opened")
            }
            entry = msgspec.structs.replace(entry, box=view.box, looks=view.role, **more)
        yield entry


def _special(number: int, view: SpecialView, turn: Turn) -> ViewEntry:
    kind = view.kind.value
    return ViewEntry(
        id=f"{kind}-{number}",
        role=_ROLES.get(view.kind, ViewRole.IGNORE),
        box=stored_box(view.box, turn),
        kind=kind,
        used=view.used,
        cut=stored_box(view.cut, turn) if view.cut else None,
    )


def _left_out(number: int, box: tuple[float, float, float, float], turn: Turn) -> ViewEntry:
    return ViewEntry(
        id=f"{LINES}-{number}",
        role=ViewRole.IGNORE,
        box=stored_box(box, turn),
        kind=LINES,
        used=False,
    )


def _strokes(lines: SheetLines, turn: Turn) -> Iterator[StrokeEntry]:
    owned: list[tuple[str | None, Certainty, Stroke]] = [
        (view.role.value, sure, stroke)
        for view in lines.drawn
        for stroke, sure in view_certainty(view)
    ]
    names = [special.id for special in _specials(lines, turn) if special.looks is not None]
    owned += [
        (name, sure, stroke)
        for name, view in zip(names, lines.adjacent_sections, strict=True)
        for stroke, sure in view_certainty(view)
    ]
    owned += [(None, OF_FILE, stroke) for stroke in lines.loose]
    for number, (view, sure, stroke) in enumerate(owned, start=1):
        yield read_entry(f"s{number}", view, stroke, turn, sure)
    tangents = [(view, stroke) for view in lines.drawn for stroke in view.tangents]
    for number, (drawn, stroke) in enumerate(tangents, start=1 + len(owned)):
        yield tangent_entry(f"s{number}", drawn, stroke, turn)
    ends = [end for mark in lines.marks if mark.line is not None for end in mark.line]
    stored = iter(stored_points(ends, turn) if ends else ())
    for number, mark in enumerate(lines.marks, start=1 + len(owned) + len(tangents)):
        line = None if mark.line is None else (next(stored), next(stored))
        kind, box = _KINDS.get(mark.kind, StrokeKind.IGNORE), stored_box(mark.box, turn)
        stated = mark_certainty(mark, lines.labels)
        yield StrokeEntry(id=f"s{number}", view=None, kind=kind, line=line, box=box, **stated)


def _dimension(number: int, dimension: ReadDimension, turn: Turn) -> DimensionEntry:
    measure = dimension.measure
    return DimensionEntry(
        id=f"d{number}",
        text=dimension.text[:1000],
        value_mm=dimension.value_mm,
        box=_rounded(dimension.box),
        type=_SIGNS[dimension.sign],
        mm_per_px=dimension.mm_per_pixel if (dimension.mm_per_pixel or 0.0) <= LARGEST else None,
        used=dimension.used,
        measures=_measured(dimension, turn),
        told_mm=measure.value_mm if measure else None,
        digit_mm=measure.digit_mm if measure else None,
    )


def _measured(dimension: ReadDimension, turn: Turn) -> Measured | None:
    place = dimension.place
    if place is None:
        return None
    if isinstance(place, Span):
        x0, y0, x1, y1 = turn.box_to_upright(dimension.box)
        across = (y0 + y1) / 2.0 if place.level else (x0 + x1) / 2.0
        ends = np.array([(at, across) for at in (place.low, place.high)])
        first, last = stored_points(ends if place.level else ends[:, ::-1], turn)
        return Measured(span=(first, last))
    return Measured(circle=_circle(place, turn))


def _circle(arc: Arc, turn: Turn) -> tuple[float, float, float]:
    (centre,) = stored_points([arc.centre], turn)
    return *centre, round(arc.radius * turn.scale, 4)


def _projection_source(layout: Layout) -> Literal["given", "symbol", "inferred", "default"]:
    """What told the projection: a symbol that the lines contradict did not."""
    return "symbol" if layout.symbol is layout.projection else layout.source
