"""The stage masks: views with strokes to views on shared axes, under one or two projections."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from gaussiancad_core.evidence.dimension_evidence import contradicts, trusted
from gaussiancad_core.evidence.hole_notes import hole_notes
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.evidence.projection_choice import both_readings, opposite
from gaussiancad_core.evidence.section_evidence import cuts_of, sections_of
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Projection, mutually_orthogonal
from gaussiancad_core.recognition.views_and_lines import SheetLines
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.report_entries import ViewReport
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.section_report import section_reports
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, register_views
from gaussiancad_core.sheet.special_views.view_kinds import SpecialView
from gaussiancad_core.writing.section_titles import NamedSection
from gaussiancad_core.writing.sheet_scale import ScaleSource, SheetScale
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Recipe, ResultKind


@dataclass(frozen=True, eq=False)
class SheetFindings:
    """What was read on a sheet.

    Attributes:
        assumed: the views on shared axes, as they are named; once the readings are weighed,
            under the likelier projection.
        other: the same under the other projection, where that is possible.
        marks: annotations, in px of the upright sheet.
        special: views that are no plain projections.
        symbol: the projection that the sheet's symbol tells, if there is one.
        contradicted: whether the lines fit the other projection better than the symbol's.
    """

    assumed: ProjectedReading
    other: ProjectedReading | None
    marks: tuple[Mark, ...]
    special: tuple[SpecialView, ...]
    symbol: Projection | None = None
    contradicted: bool = False

    def changed(self, change: Callable[[ProjectedReading], ProjectedReading]) -> "SheetFindings":
        """The same with each reading changed."""
        other = change(self.other) if self.other is not None else None
        return replace(self, assumed=change(self.assumed), other=other)


def registered_lines(job: Job, lines: SheetLines, turn: Turn, notes: RunNotes) -> SheetFindings:
    """Views on shared axes, under one or two projections.

    Where a solid is asked for, it may tell which of two is right: they are not weighed yet.

    Args:
        job: with what is asked for.
        lines: of the sheet.
        turn: of the sheet.
        notes: told what is found.

    Raises:
        NoModelError: the views contradict each other.
    """
    options, layout = lines.options, lines.layout
    with notes.stage("masks"):
        if job.recipe is Recipe.PAPER:
            options = replace(options, open_holes=False)
        if layout.alternatives and not options.views and lines.unseen is None:
            found = _both(lines, options, notes)
        else:
            registered = register_views(lines.drawn, options, lines.unseen)
            reading = ProjectedReading(registered, notes.report.projection)
            found = SheetFindings(reading, None, (), ())
        found = _with_measures(found, lines.scale, notes)
        found = _with_cuts(found, lines)
        policy = lines.tangents.policy
        found = found.changed(lambda reading: replace(reading, tangent_policy=policy))
        found = _with_notes(found, lines, turn, notes)
        if found.other and job.result is ResultKind.SURFACE:
            found = weigh_readings(found, notes)
        _tell_views(notes, found.assumed.registered, turn)
        _tell_registration(notes, found.assumed.registered, turn)
        notes.tell(sections=section_reports(found.assumed, lines.sections, turn))
    return replace(found, marks=lines.marks, special=layout.special)


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
        Code.SYMBOL_CONTRADICTS_LINES,
        Message(
            "the projection symbol says {symbol} angle, but the visible and hidden lines fit "
            "{other} angle better: {taken} angle was taken; pass --projection if it is the other",
            symbol=symbol,
            other=symbol.other,
            taken=taken,
        ),
    )


def weigh_readings(found: SheetFindings, notes: RunNotes) -> SheetFindings:
    """The same with the likelier of both readings first, by what their sketches explain.

    What the sheet's symbol says stays first; the findings then tell whether lines contradict it.
    """
    from gaussiancad_core.sketch.projection_by_sketch import weigh

    reading, other = found.assumed, found.other
    if other is None:
        raise ValueError("there is one reading")
    weighed = weigh((reading, other))
    is_other = weighed.likelier == 1
    contradicted = found.symbol is not None and is_other and weighed.is_clear
    if is_other and found.symbol is None:
        reading, other = other, reading
    tell_projection(notes, reading.projection, weighed.is_clear or found.symbol is not None)
    return replace(found, assumed=reading, other=other, contradicted=contradicted)


def _both(lines: SheetLines, options: ReadingOptions, notes: RunNotes) -> SheetFindings:
    """The views as they are named, and as the other projection names them where that may be."""
    layout = lines.layout
    registered, contrary = both_readings(lines.drawn, options)
    reading = ProjectedReading(registered, layout.projection)
    other = ProjectedReading(contrary, layout.projection.other) if contrary else None
    if other is None:
        tell_projection(notes, reading.projection, inferred=True)
    return SheetFindings(reading, other, (), (), layout.symbol)


def _with_measures(
    found: SheetFindings, scale: SheetScale | None, notes: RunNotes
) -> SheetFindings:
    """The readings with what the dimensions say of lengths, where they fit the scale."""
    if scale is not None and contradicts(found.assumed.registered, scale):
        notes.doubt(
            Code.SCALE_CONTRADICTS_DIMENSIONS,
            Message(
                "the dimensions on the sheet agree on {sheet:.4g} mm a pixel, but {told:.4g} was "
                "given: check --length or --mm-per-pixel; their numbers were not used",
                sheet=scale.mm_per_pixel,
                told=found.assumed.registered.mm_per_pixel,
            ),
        )
    return found.changed(
        lambda reading: replace(reading, measures=trusted(reading.registered, scale))
    )


def _with_cuts(found: SheetFindings, lines: SheetLines) -> SheetFindings:
    """The readings with their sections and the planes of these."""
    return found.changed(lambda reading: _cut(reading, lines))


def _with_notes(
    found: SheetFindings, lines: SheetLines, turn: Turn, notes: RunNotes
) -> SheetFindings:
    """The readings with the holes that notes speak of."""
    dimensions = [
        replace(dimension, box=turn.box_to_upright(dimension.box))
        for dimension in (lines.scale.dimensions if lines.scale is not None else ())
    ]
    stated = hole_notes(found.assumed.registered, lines.notes, dimensions)
    other = found.other
    if other is not None:
        of_other = hole_notes(other.registered, lines.notes, dimensions)
        other = replace(other, holes=of_other.holes)
    for code, message in stated.doubts:
        notes.doubt(code, message)
    return replace(found, assumed=replace(found.assumed, holes=stated.holes), other=other)


def _cut(reading: ProjectedReading, lines: SheetLines) -> ProjectedReading:
    sections = lines.sections
    if reading.projection is not lines.layout.projection:
        sections = tuple(_turned(section) for section in sections)
    return replace(
        reading,
        cuts=cuts_of(reading.registered, sections),
        adjacent_sections=sections_of(reading.registered, lines.adjacent_sections, sections),
    )


def _turned(section: NamedSection) -> NamedSection:
    """The same under the other projection."""
    return replace(section, cut_in=section.cut_in and opposite(section.cut_in))


def _tell_views(notes: RunNotes, registered: RegisteredSheet, turn: Turn) -> None:
    notes.tell(views={view.role: ViewReport(view.stored_box(turn)) for view in registered.drawn})


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
    for view in registered.gaps:
        x0, y0, x1, y1 = view.box
        message = Message(
            "the outline of the {view} view at {place} px is not closed, and was taken to be "
            "straight where it is missing: draw its visible edges without gaps",
            boxes=[view.box],
            view=view.role,
            place=f"({x0:.0f}, {y0:.0f})-({x1:.0f}, {y1:.0f})",
            case="gap",
        )
        notes.doubt(Code.OPEN_OUTLINE, message.moved(turn.box_to_stored))
    if notes.report.scale_source == ScaleSource.DEFAULT.value:
        notes.warn(
            Code.SCALE_ASSUMED,
            "the scale is not known: the longest edge was made 100 mm; "
            "pass --length AXIS=MM or --mm-per-pixel",
        )
    for axis in registered.extents.disagreeing:
        spread = registered.extents.spread[axis]
        residual = registered.extents.residuals[axis]
        notes.warn(
            Code.VIEWS_DISAGREE,
            Message(
                "the views differ by {spread:.1f} px in the part's extent along {axis}, and by up "
                "to {largest:.1f} px from the coordinates that they share: their mean was taken",
                axis=axis.name,
                spread=spread,
                largest=residual.largest,
                spread_mm=round(spread * registered.mm_per_pixel, 2),
            ),
        )
    if registered.unseen is None and not mutually_orthogonal(registered.views.roles):
        notes.doubt(
            Code.TWO_VIEWS, "only two directions of view: what a third would show is not known"
        )
