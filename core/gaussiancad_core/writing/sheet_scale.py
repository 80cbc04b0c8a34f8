"""The scale of a sheet: from its dimensions, or from its paper and scale note."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.files.content import Note
from gaussiancad_core.messages import Message
from gaussiancad_core.model.length_units import MM_PER_INCH
from gaussiancad_core.model.views import Arc, Segment
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.labels.label_evidence import meets_any
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.tracing.level_rules import Rule, rule_of
from gaussiancad_core.structure.arrowheads import without_heads
from gaussiancad_core.writing.arrows import ArrowPair, arrow_pairs, arrow_spans
from gaussiancad_core.writing.callouts import parse_callout
from gaussiancad_core.writing.dimension_layout import LIKELY, POSSIBLE
from gaussiancad_core.writing.dimension_texts import (
    Span,
    adjacent_extents,
    file_lines,
    file_rules,
    mark_rules,
    spans_of,
)
from gaussiancad_core.writing.leaders import (
    Leader,
    circles_at,
    leaders_of,
    pointed_lines,
    shelves_of,
)
from gaussiancad_core.writing.number_units import Units, file_unit, noted_unit, other_size
from gaussiancad_core.writing.numbers import DimensionText, Sign, Unit, parse_dimension, parse_scale
from gaussiancad_core.writing.ordinates import is_zero, ordinate_length
from gaussiancad_core.writing.scale_agreement import (
    Agreement,
    Candidate,
    Dimension,
    Measure,
    ReadDimension,
    agree,
    fitting_unit,
    usual_unit,
)
from gaussiancad_core.writing.sheet_texts import (
    MOST_TEXTS,
    SheetText,
    fields_of,
    file_texts,
    framed,
    pixel_texts,
)
from gaussiancad_protocol.codes import Code

_MOST_RULES = 5000
"""Lines of a sheet that are looked at, the longest first: more take too long."""

_MOST_NAMED = 5
"""Numbers that one message names at most."""

_CUT = 0.7
"""Distance of a text's beginning from a line across it, in its height, at which the line may have
taken a letter: digits are narrower."""


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
        targets: circles and arcs that the leaders of call-outs point at, by the boxes of these.
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
    targets: Mapping[Box, Arc] = field(default_factory=dict)


@dataclass(frozen=True)
class _Lines:
    """What dimensions may measure."""

    rules: list[Rule]
    edges: list[Rule]
    arcs: list[Arc]
    pairs: tuple[ArrowPair, ...] = ()
    leaders: tuple[Leader, ...] = ()
    boxes: tuple[Box, ...] = ()


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
    lines = _lines(sheet, texts, (marks, drawn))
    dimensions = _dimensions(texts, marks, lines, bare_point_is_inch=in_file is None)
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
        targets=_targets(texts, marks, lines),
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


def _lines(
    sheet: OpenedSheet,
    texts: Sequence[SheetText],
    found: tuple[Sequence[Mark], Sequence[ReadView]],
) -> _Lines:
    marks, drawn = found
    rules = mark_rules(marks)
    pairs: tuple[ArrowPair, ...] = ()
    leaders = leaders_of(marks)
    drawing = sheet.image.vectors
    if drawing is not None:
        heads = sheet.heads
        this_file_rules = file_rules(without_heads(drawing.strokes, heads), sheet.turn)
        pairs = arrow_pairs(heads, this_file_rules, texts, sheet.turn)
        leaders += pointed_lines(heads, file_lines(drawing.strokes, sheet.turn), sheet.turn)
        # Marks of a file are its strokes, too, those of heads among them.
        rules = this_file_rules if heads else rules + this_file_rules
    rules = sorted(rules, key=lambda rule: rule.low - rule.high)[:_MOST_RULES]
    strokes = [stroke for view in drawn for stroke in view.strokes]
    edges = [rule_of(stroke.start, stroke.end) for stroke in strokes if isinstance(stroke, Segment)]
    arcs = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    borders = [edge for edge in edges if edge is not None]
    boxes = tuple(view.box for view in drawn)
    return _Lines(rules, borders, arcs, pairs, tuple(leaders), boxes)


def _dimensions(
    texts: Sequence[SheetText], marks: Sequence[Mark], lines: _Lines, *, bare_point_is_inch: bool
) -> tuple[Dimension, ...]:
    shelves = shelves_of(marks)
    zeros = [text for text in texts if is_zero(text)]
    parsed = (
        (text, parse_dimension(text.text, bare_point_is_inch=bare_point_is_inch))
        for text in texts
        if not text.field
    )
    numbers = [(text, said) for text, said in parsed if said is not None]
    found = []
    for text, said in numbers[:MOST_TEXTS]:
        circles = circles_at(text, lines.leaders, shelves, lines.arcs)
        candidates = _candidates(text, said, lines, circles)
        ordinate = ordinate_length(text, zeros, lines.rules)
        if ordinate and said.sign is Sign.LENGTH:
            candidates = (Candidate(ordinate), *candidates)
        found.append(Dimension(text.text, said, text.box, candidates, _is_cut(text, lines.rules)))
    return tuple(found)


def _targets(texts: Sequence[SheetText], marks: Sequence[Mark], lines: _Lines) -> dict[Box, Arc]:
    """What the leaders of call-outs point at, by the boxes of their texts."""
    shelves = shelves_of(marks)
    callouts = [text for text in texts if not text.field and parse_callout(text.text)]
    found = (
        (text.box, circles_at(text, lines.leaders, shelves, lines.arcs))
        for text in callouts[:MOST_TEXTS]
    )
    return {box: circles[0] for box, circles in found if circles}


def _is_cut(text: SheetText, rules: Sequence[Rule]) -> bool:
    """Whether a line runs across a text where it begins, through letters that were not read."""
    x0, y0, x1, y1 = text.box
    height = y1 - y0 if text.level else x1 - x0
    start, middle = (x0, (y0 + y1) / 2.0) if text.level else (y1, (x0 + x1) / 2.0)
    return any(
        rule.level is not text.level
        and abs(rule.at - start) <= _CUT * height
        and rule.low <= middle <= rule.high
        for rule in rules
    )


def _candidates(
    text: SheetText, said: DimensionText, lines: _Lines, circles: Sequence[Arc]
) -> tuple[Candidate, ...]:
    found = []
    if said.sign is not Sign.RADIUS:
        spans = (*_spans(text, lines), *adjacent_extents(text, lines.boxes))
        found += [Candidate(span.length, span.weight, span) for span in spans]
    # Where the sign was not read, the leader tells that it is a diameter.
    times = 1.0 if said.sign is Sign.RADIUS else 2.0
    weights = [LIKELY] + [POSSIBLE] * len(circles)
    found += [
        Candidate(times * arc.radius, weight, arc)
        for arc, weight in zip(circles, weights, strict=False)
    ]
    return tuple(sorted(found, key=lambda candidate: -candidate.weight))


def _spans(text: SheetText, lines: _Lines) -> tuple[Span, ...]:
    """Where a sheet has arrowheads they tell what is a dimension line; other lines part it."""
    if not lines.pairs:
        return spans_of(text, lines.rules, lines.edges)
    whole = arrow_spans(text, lines.pairs)
    parts = spans_of(text, lines.rules, lines.edges) if whole else ()
    return (*whole, *(replace(part, weight=POSSIBLE * part.weight) for part in parts))


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
