"""What the texts of a sheet may measure: lines, circles, rows of tables."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot

import numpy as np

from gaussiancad_core.model.views import Arc, Segment
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.tracing.level_rules import Rule, rule_of
from gaussiancad_core.structure.arrowheads import without_heads
from gaussiancad_core.writing.arrows import ArrowPair, arrow_pairs, arrow_spans
from gaussiancad_core.writing.callouts import NoteKind, parse_callout
from gaussiancad_core.writing.dimension_layout import LIKELY, POSSIBLE
from gaussiancad_core.writing.dimension_texts import (
    Span,
    adjacent_extents,
    file_lines,
    file_rules,
    mark_rules,
    spans_of,
)
from gaussiancad_core.writing.hole_tables import hole_rows, labelled_circles
from gaussiancad_core.writing.leaders import (
    Leader,
    circles_at,
    leaders_of,
    pointed_lines,
    shelves_of,
)
from gaussiancad_core.writing.note_texts import Targets
from gaussiancad_core.writing.numbers import DimensionText, Sign, parse_dimension
from gaussiancad_core.writing.ordinates import is_zero, ordinate_length
from gaussiancad_core.writing.ruled_cells import ruled_tables
from gaussiancad_core.writing.scale_agreement import Candidate, Dimension
from gaussiancad_core.writing.sheet_texts import MOST_TEXTS, SheetText

_MOST_RULES = 5000
"""Lines of a sheet that are looked at, the longest first: more take too long."""

_CUT = 0.7
"""Distance of a text's beginning from a line across it, in its height, at which the line may have
taken a letter: digits are narrower."""


@dataclass(frozen=True)
class SheetMeasures:
    """What texts may measure.

    Attributes:
        rules: level and upright narrow lines, the longest first.
        edges: level and upright edges of the views.
        arcs: of the views.
        pairs: arrows of one dimension line.
        leaders: slanted narrow lines.
        shelves: level ones, under the texts of leaders.
        boxes: of the views.
    """

    rules: list[Rule]
    edges: list[Rule]
    arcs: list[Arc]
    pairs: tuple[ArrowPair, ...] = ()
    leaders: tuple[Leader, ...] = ()
    shelves: tuple[Leader, ...] = ()
    boxes: tuple[Box, ...] = ()


def measures_of(
    sheet: OpenedSheet,
    texts: Sequence[SheetText],
    found: tuple[Sequence[Mark], Sequence[ReadView]],
) -> SheetMeasures:
    """What texts may measure on a sheet.

    Args:
        sheet: as stored and upright.
        texts: of the sheet.
        found: its annotations, and its views.
    """
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
    shelves = tuple(shelves_of(marks))
    return SheetMeasures(rules, borders, arcs, pairs, tuple(leaders), shelves, boxes)


def with_tables(
    texts: tuple[SheetText, ...], measures: SheetMeasures
) -> tuple[tuple[SheetText, ...], dict[Box, tuple[Arc, ...]]]:
    """The rows of hole tables as call-outs.

    Returns:
        The texts, those in cells of tables, and the labels of holes, as fields, the rows among
        them; and the circles that carry the labels of rows.
    """
    tables = ruled_tables(texts, measures.rules)
    inside = {id(text) for table in tables for text in table.texts}
    if not inside:
        return texts, {}
    rows = [row for table in tables for row in hole_rows(table)]
    free = [text for text in texts if id(text) not in inside]
    circles = labelled_circles(rows, free, measures.arcs)
    labels = {row.label for row in rows}
    marked = (
        replace(text, field=True) if id(text) in inside or text.text.upper() in labels else text
        for text in texts
    )
    return (*marked, *(row.text for row in rows)), circles


def pointed_circles(
    texts: Sequence[SheetText], measures: SheetMeasures
) -> dict[Box, tuple[Arc, ...]]:
    """What the leaders of call-outs point at, by the boxes of their texts."""
    callouts = [text for text in texts if not text.field and parse_callout(text.text)]
    found = (
        (text.box, circles_at(text, measures.leaders, measures.shelves, measures.arcs))
        for text in callouts[:MOST_TEXTS]
    )
    return {box: circles[:1] for box, circles in found if circles}


def dimensions_of(
    texts: Sequence[SheetText],
    measures: SheetMeasures,
    rows: Targets,
    *,
    bare_point_is_inch: bool,
) -> tuple[Dimension, ...]:
    """The numbers among texts, with the lengths that each may tell.

    Args:
        texts: of the sheet.
        measures: what they may measure.
        rows: circles of the texts that are rows of hole tables: these measure nothing else.
        bare_point_is_inch: see :func:`.parse_dimension`.
    """
    zeros = [text for text in texts if is_zero(text)]
    found: list[Dimension] = []
    for text in texts:
        if text.field or len(found) == MOST_TEXTS:
            continue
        circles = rows.get(text.box)
        said = parse_dimension(text.text, bare_point_is_inch=bare_point_is_inch)
        if circles is not None:
            said = _diameter(text.text) or said
        if said is None:
            continue
        if circles is None:
            candidates = _candidates(text, said, measures)
            ordinate = ordinate_length(text, zeros, measures.rules)
            if ordinate and said.sign is Sign.LENGTH:
                candidates = (Candidate(ordinate), *candidates)
        else:
            candidates = _across(circles, said)
        found.append(
            Dimension(text.text, said, text.box, candidates, _is_cut(text, measures.rules))
        )
    return tuple(found)


def _diameter(text: str) -> DimensionText | None:
    """The diameter that a call-out begins with."""
    first = next(iter(parse_callout(text)), None)
    if first is None or first.kind is not NoteKind.DIAMETER or not first.value:
        return None
    return DimensionText(first.value, Sign.DIAMETER, first.unit)


def _about(circles: Sequence[Arc], arcs: Sequence[Arc]) -> list[Arc]:
    """Other whole circles about the centre of a circle: a leader ends at the widest."""
    return [
        arc
        for circle in circles
        for arc in arcs
        if arc.is_full
        and abs(arc.radius - circle.radius) > ONE_PLACE
        and hypot(*np.subtract(arc.centre, circle.centre)) <= ONE_PLACE
    ]


def _across(circles: Sequence[Arc], said: DimensionText) -> tuple[Candidate, ...]:
    """Circles as what a text may tell, the likeliest first: where a sign was not read, a leader
    tells that it is a diameter."""
    times = 1.0 if said.sign is Sign.RADIUS else 2.0
    weights = [LIKELY] + [POSSIBLE] * len(circles)
    return tuple(
        Candidate(times * arc.radius, weight, arc)
        for arc, weight in zip(circles, weights, strict=False)
    )


def _is_cut(text: SheetText, rules: Sequence[Rule]) -> bool:
    """Whether a line runs across a text where it begins, through letters that were not read; a file
    has all letters of its texts."""
    if text.exact:
        return False
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
    text: SheetText, said: DimensionText, measures: SheetMeasures
) -> tuple[Candidate, ...]:
    found = []
    if said.sign is not Sign.RADIUS:
        spans = (*_spans(text, measures), *adjacent_extents(text, measures.boxes))
        found += [Candidate(span.length, span.weight, span) for span in spans]
    circles = circles_at(text, measures.leaders, measures.shelves, measures.arcs)
    found += _across((*circles, *_about(circles[:1], measures.arcs)), said)
    return tuple(sorted(found, key=lambda candidate: -candidate.weight))


def _spans(text: SheetText, measures: SheetMeasures) -> tuple[Span, ...]:
    """Where a sheet has arrowheads they tell what is a dimension line; other lines part it."""
    if not measures.pairs:
        return spans_of(text, measures.rules, measures.edges)
    whole = arrow_spans(text, measures.pairs)
    parts = spans_of(text, measures.rules, measures.edges) if whole else ()
    return (*whole, *(replace(part, weight=POSSIBLE * part.weight) for part in parts))
