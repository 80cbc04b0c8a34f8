"""The scale of a sheet: from its dimensions, or from its paper and scale note."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import Enum

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.files.content import Note
from gaussiancad_core.messages import Message
from gaussiancad_core.model.length_units import MM_PER_INCH
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.labels.label_evidence import meets_any
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.writing.measured_texts import (
    dimensions_of,
    measures_of,
    pointed_circles,
    with_tables,
)
from gaussiancad_core.writing.note_texts import Targets
from gaussiancad_core.writing.number_units import Units, file_unit, noted_unit, other_size
from gaussiancad_core.writing.numbers import Unit, parse_dimension, parse_scale
from gaussiancad_core.writing.scale_agreement import (
    Agreement,
    Measure,
    ReadDimension,
    agree,
    fitting_unit,
    usual_unit,
)
from gaussiancad_core.writing.sheet_texts import (
    SheetText,
    fields_of,
    file_texts,
    framed,
    pixel_texts,
)
from gaussiancad_protocol.codes import Code

_MOST_NAMED = 5
"""Numbers that one message names at most."""


_ON_PAPER = Message(
    "the sheet has no scale note that could be read: its paper was taken to show the part full "
    "scale; pass --length AXIS=MM if it does not"
)
_IN_OWN_SIZE = Message(
    "the file says the unit of its lengths, and no scale: the part was taken to be drawn in its "
    "own size; pass --length AXIS=MM if it is not",
    case="file",
)


class ScaleSource(Enum):
    """What a sheet's scale is taken from; in the report."""

    GIVEN = "given"
    DIMENSION = "dimension"
    SHEET = "sheet"
    DEFAULT = "default"


@dataclass(frozen=True)
class SheetScale:
    """The scale of a sheet.

    Attributes:
        mm_per_pixel: of the part, or nothing where the sheet does not tell.
        source: where it is from.
        dimensions: those that were read; boxes in px of the sheet as stored.
        notes: warnings.
        contradictions: numbers that the drawing contradicts; those that were read from pixels may
            have been misread, and are among the warnings.
        measures: what dimensions that agree say of lengths on the upright sheet.
        texts: all that was read, px of the upright sheet.
        unit: of numbers that do not name theirs.
        unit_noted: whether a note names it.
        targets: circles and arcs that call-outs speak of, by their leaders or by the labels of a
            hole table's rows.
    """

    mm_per_pixel: float | None
    source: ScaleSource
    dimensions: tuple[ReadDimension, ...] = ()
    notes: tuple[Note, ...] = ()
    contradictions: tuple[Note, ...] = ()
    measures: tuple[Measure, ...] = ()
    texts: tuple[SheetText, ...] = ()
    unit: Unit = Unit.MILLIMETRE
    unit_noted: bool = False
    targets: Targets = field(default_factory=dict)


def find_scale(
    sheet: OpenedSheet,
    marks: Sequence[Mark],
    drawn: Sequence[ReadView],
    texts: tuple[SheetText, ...] | None = None,
    *,
    stated_unit: Unit | None = None,
) -> SheetScale:
    """Find the scale of a sheet.

    Args:
        sheet: as stored and upright.
        marks: annotations found on it.
        drawn: its views.
        texts: what was read on it; None where nobody read it yet.
        stated_unit: unit of numbers that do not name theirs, as the user says.
    """
    image = sheet.image
    if texts is None:
        texts = read_texts(sheet, marks)
    paper_scale, assumed = _paper_scale(image, texts)
    in_file = file_unit(image.vectors)
    lines = measures_of(sheet, texts, (marks, drawn))
    texts, rows = with_tables(texts, lines)
    dimensions = dimensions_of(texts, lines, rows, bare_point_is_inch=in_file is None)
    units = Units(
        stated_unit,
        noted_unit(texts),
        in_file,
        fitting_unit(dimensions, paper_scale if in_file or not assumed else None),
    )
    unit = units.taken or usual_unit(dimensions)
    found = agree(dimensions, unit, None if assumed else paper_scale)
    stored = tuple(_as_stored(dimension, sheet.turn) for dimension in found.dimensions)
    found = replace(found, dimensions=stored)
    plain = SheetScale(
        None,
        ScaleSource.DEFAULT,
        stored,
        contradictions=units.contradictions,
        texts=texts,
        unit=unit,
        unit_noted=unit in (units.given, units.noted),
        targets=rows | pointed_circles(texts, lines),
    )
    if found.mm_per_pixel is not None:
        apart = _disagreement(found)
        surely = _has_texts(image)
        notes: tuple[Note, ...] = ()
        if paper_scale is not None:
            notes = other_size(image.vectors, found.mm_per_pixel, paper_scale)
        return replace(
            plain,
            mm_per_pixel=found.mm_per_pixel,
            source=ScaleSource.DIMENSION,
            notes=notes if surely else notes + apart,
            contradictions=units.contradictions + (apart if surely else ()),
            measures=found.measures,
        )
    if paper_scale is None:
        return plain
    notes = ()
    if assumed:
        notes = (Note(Code.FULL_SCALE_ASSUMED, _IN_OWN_SIZE if in_file else _ON_PAPER),)
    return replace(plain, mm_per_pixel=paper_scale, source=ScaleSource.SHEET, notes=notes)


def _as_stored(dimension: ReadDimension, turn: Turn) -> ReadDimension:
    """A dimension with its box, and the scale that it gives, in px of the sheet as stored."""
    scale = None if dimension.mm_per_pixel is None else dimension.mm_per_pixel / turn.scale
    return replace(dimension, box=turn.box_to_stored(dimension.box), mm_per_pixel=scale)


def read_texts(sheet: OpenedSheet, marks: Sequence[Mark]) -> tuple[SheetText, ...]:
    """The texts of a sheet: its file's, and those that its marks show in its pixels where the file
    has no texts, and these are more than the numbers among the file's."""
    texts: tuple[SheetText, ...] = ()
    drawing = sheet.image.vectors
    if drawing is not None and _has_texts(sheet.image):
        height, width = sheet.shape
        fields = fields_of(marks, height * width)
        texts = file_texts(drawing.texts, sheet.turn, fields)
        texts = framed(texts, marks, sheet.shape)
    known = np.array([text.box for text in texts])
    marks = [
        mark
        for mark in marks
        if mark.kind is not AnnotationKind.TEXT or not meets_any(mark.box, known)
    ]
    shown = sum(mark.kind is AnnotationKind.TEXT for mark in marks)
    if shown <= sum(parse_dimension(text.text) is not None for text in texts):
        return texts
    return (*texts, *framed(pixel_texts(sheet.clean, marks), marks, sheet.shape))


def _has_texts(image: SheetImage) -> bool:
    """Whether the file has its texts as such."""
    return image.vectors is not None and bool(image.vectors.texts)


def _paper_scale(image: SheetImage, texts: Sequence[SheetText]) -> tuple[float | None, bool]:
    """mm of the part per px by what the file says of its size, and whether full scale was assumed
    for want of a note."""
    if image.pixels_per_inch is None:
        return None, False
    full = MM_PER_INCH / image.pixels_per_inch
    ratios = _ratios(texts, field=True) or _ratios(texts, field=False)
    if len(ratios) == 1:
        return full / ratios.pop(), False
    # A picture's resolution says little without a note, a vector file has the size it was drawn in.
    return (full, True) if image.vectors is not None else (None, False)


def _ratios(texts: Sequence[SheetText], field: bool) -> set[float]:
    """The scales that notes name, in the title block or beside it."""
    found = (parse_scale(text.text) for text in texts if text.field is field)
    return {ratio for ratio in found if ratio is not None}


def _disagreement(found: Agreement) -> tuple[Note, ...]:
    others = found.disagreeing
    if not others:
        return ()
    places = "; ".join(
        f"{other.text!r} at ({other.box[0]:.0f}, {other.box[1]:.0f})"
        for other in others[:_MOST_NAMED]
    )
    return (
        Note(
            Code.DIMENSIONS_DISAGREE,
            Message(
                "{count} dimension(s) do not fit the scale of the others: {places} px; they may "
                "have been misread, or the drawing is not to scale there",
                boxes=[other.box for other in others],
                count=len(others),
                places=places,
                numbers=", ".join(other.text for other in others[:_MOST_NAMED]),
            ),
        ),
    )
