"""Which length on the sheet a dimension's text belongs to (ISO 129-1, ASME Y14.5).

A linear dimension's line runs level or upright, under its text or interrupted by it.  What it
measures lies between the two lines that cross or meet it: extension lines, centre lines, edges.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.files.vectors import StrokeKind, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.picture_noise import OVERSHOOT
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.tracing.level_rules import Rule, rule_of
from gaussiancad_core.writing.dimension_layout import (
    ALONG,
    BESIDE,
    CLOSE,
    IN_LINE,
    LIKELY,
    LOOSELY,
    MISSED,
    POSSIBLE,
)
from gaussiancad_core.writing.sheet_texts import SheetText

_RULES = frozenset({AnnotationKind.EXTENSION, AnnotationKind.DIMENSION, AnnotationKind.CENTRE_LINE})
"""Marks that dimensions are made of."""

_NO_LINES = frozenset({StrokeKind.FILL, StrokeKind.HATCH})

_ACROSS_LINE = 0.8
"""How far beside its middle the line runs that a level text interrupts, in half its width."""


@dataclass(frozen=True)
class Span:
    """A length on the sheet that a text may belong to.

    Attributes:
        level: whether it runs along x.
        low, high: px along.
        weight: 1 for the likeliest reading of a text, less for others.
    """

    level: bool
    low: float
    high: float
    weight: float = 1.0

    @property
    def length(self) -> float:
        """In px."""
        return self.high - self.low


def mark_rules(marks: Iterable[Mark]) -> list[Rule]:
    """The rules among the marks of a sheet."""
    found = [rule_of(*mark.line) for mark in marks if mark.kind in _RULES and mark.line is not None]
    return [rule for rule in found if rule is not None]


def file_lines(
    strokes: Iterable[VectorStroke], turn: Turn
) -> list[tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]]:
    """The ends of the straight strokes of a vector file, px of the upright sheet."""
    return [(start, end) for start, end in _straight(strokes, turn)]


def file_rules(strokes: Iterable[VectorStroke], turn: Turn) -> list[Rule]:
    """The rules among the strokes of a vector file."""
    found = (rule_of(*ends) for ends in _straight(strokes, turn).tolist())
    return [rule for rule in found if rule is not None]


def _straight(strokes: Iterable[VectorStroke], turn: Turn) -> npt.NDArray[np.float64]:
    """(n, 2, 2) ends of the straight strokes of a vector file, px of the upright sheet."""
    lines = [
        (stroke.curve.start, stroke.curve.end)
        for stroke in strokes
        if isinstance(stroke.curve, LineSegment) and stroke.kind not in _NO_LINES
    ]
    return turn.to_upright(np.array(lines).reshape(-1, 2)).reshape(-1, 2, 2)


def spans_of(text: SheetText, rules: Sequence[Rule], edges: Sequence[Rule]) -> tuple[Span, ...]:
    """The lengths that a text may belong to, the likeliest first; none if there is no line.

    Args:
        text: of a dimension.
        rules: the sheet's narrow lines.
        edges: of the part, which dimension lines may end at.
    """
    found: list[Span] = []
    for level in (True, False):
        this_rules = [rule for rule in rules if rule.level is level]
        across = [rule for rule in rules if rule.level is not level]
        for line, weight in _nearby_lines(text, level, this_rules):
            stops = _stops(line, across, _head(text))
            borders = _stops(line, [edge for edge in edges if edge.level is not level], MISSED)
            spans = _spans(text, line, stops, borders)
            found += [replace(span, weight=weight * span.weight) for span in spans]
            found += _from_end_to_end(text, line, across, weight)
            found += _beyond(line, across, _head(text))
            found += _from_outside(text, line, this_rules, across)
    unique: list[Span] = []
    for span in sorted(found, key=lambda span: -span.weight):
        if span.length >= MISSED and not any(_same(span, other) for other in unique):
            unique.append(span)
    return tuple(unique)


def adjacent_extents(text: SheetText, boxes: Iterable[Box]) -> tuple[Span, ...]:
    """The extents of the views that a text stands beside, in the middle of a side: a dimension of
    a few px may be all heads, without a line that could be found.

    Args:
        text: of a dimension.
        boxes: of the views, between the centre lines of their outermost strokes.
    """
    x0, y0, x1, y1 = text.box
    height = y1 - y0 if text.level else x1 - x0
    found = []
    for box in boxes:
        for level in (True, False):
            (low, high), (first, last) = _sides(box, level)
            along, across = _sides(text.box, level)
            off = abs(along[0] + along[1] - low - high) / 2.0
            away = max(across[0] - last, first - across[1])
            if off <= BESIDE * height and 0.0 <= away <= ALONG * height:
                # Less likely than what any line measures.
                found.append(Span(level, low, high, 0.8 * POSSIBLE))
    return tuple(found)


def _same(one: Span, other: Span) -> bool:
    return (
        one.level is other.level
        and abs(one.low - other.low) < IN_LINE
        and abs(one.high - other.high) < IN_LINE
    )


def _sides(box: Box, level: bool) -> tuple[tuple[float, float], tuple[float, float]]:
    """Spans of a box along and across a direction."""
    x, y = (box[0], box[2]), (box[1], box[3])
    return (x, y) if level else (y, x)


def _nearby_lines(text: SheetText, level: bool, rules: Sequence[Rule]) -> list[tuple[Rule, float]]:
    """Lines of a direction that run under, over or through a text, pieces joined, and how likely
    each is its own; the nearest first."""
    if level and not text.level:
        return []
    along, across = _sides(text.box, level)
    height = across[1] - across[0] if text.level is level else along[1] - along[0]
    middle, reach = 0.5 * (across[0] + across[1]), 0.5 * (across[1] - across[0])
    if text.level is level:
        low, high = reach + CLOSE * height, reach + BESIDE * height
    else:
        # A text that does not run along its line stands in it.
        low = high = _ACROSS_LINE * reach
    least, most = across[0] - LOOSELY * height, across[1] + LOOSELY * height
    strict, loose = [], []
    for rule in rules:
        if middle - low <= rule.at <= middle + high:
            strict.append(rule)
        elif least <= rule.at <= most:
            loose.append(rule)
    sides = (along, across)
    found = _lines_at(strict, sides, height)
    return found + [(line, POSSIBLE * value) for line, value in _lines_at(loose, sides, height)]


def _lines_at(
    near: Sequence[Rule], sides: tuple[tuple[float, float], tuple[float, float]], height: float
) -> list[tuple[Rule, float]]:
    """Lines out of pieces near a text that lies along them, and how likely each is its own; the
    nearest first.

    Args:
        near: the pieces.
        sides: interval of the text along and across them, px.
        height: of its letters.
    """
    along, across = sides
    middle, centre = 0.5 * (across[0] + across[1]), 0.5 * (along[0] + along[1])
    near = sorted(near, key=lambda rule: abs(rule.at - middle))
    found: list[tuple[Rule, float]] = []
    while near:
        first = near[0].at
        pieces = [rule for rule in near if abs(rule.at - first) < IN_LINE]
        near = [rule for rule in near if abs(rule.at - first) >= IN_LINE]
        inline = across[0] < pieces[0].at < across[1]
        for line in _joined(pieces, (along[0] - height, along[1] + height) if inline else None):
            apart = max(line.low - along[1], along[0] - line.high)
            if max(line.low - centre, centre - line.high) <= min(0.5 * height, -apart):
                found.append((line, 1.0))
            elif inline and apart <= height:
                found.append((_mirrored(line, centre), POSSIBLE))
            elif max(line.low - centre, centre - line.high) <= 0.5 * height:
                found.append((line, 1.0))
    return found


def _joined(pieces: Sequence[Rule], text: tuple[float, float] | None) -> list[Rule]:
    """Pieces of a line put together over small gaps, and over that of a text."""
    ordered = sorted(pieces, key=lambda rule: rule.low)
    joined = [ordered[0]]
    for rule in ordered[1:]:
        last = joined[-1]
        gap = rule.low - last.high
        filled = text and last.high + OVERSHOOT >= text[0] and rule.low - OVERSHOOT <= text[1]
        if gap <= OVERSHOOT or filled:
            longer = max(last, rule, key=lambda piece: piece.high - piece.low)
            joined[-1] = Rule(last.level, longer.at, last.low, max(last.high, rule.high))
        else:
            joined.append(rule)
    return joined


def _mirrored(line: Rule, centre: float) -> Rule:
    """The whole of a line of which only the half beside a text in its middle was found: short
    pieces with an arrow are easily taken for letters."""
    return replace(
        line, low=min(line.low, 2 * centre - line.high), high=max(line.high, 2 * centre - line.low)
    )


def _head(text: SheetText) -> float:
    """px that an arrowhead takes at the end of a text's line, at most."""
    x0, y0, x1, y1 = text.box
    return MISSED + BESIDE * (y1 - y0 if text.level else x1 - x0)


def _from_outside(
    text: SheetText, line: Rule, rules: Sequence[Rule], across: Sequence[Rule]
) -> Iterator[Span]:
    """What lies between a text's line and another one in line with it, which point at each other:
    where there is no room for arrows inside."""
    along, _ = _sides(text.box, line.level)
    centre, head = 0.5 * (along[0] + along[1]), _head(text)
    others = [rule for rule in rules if abs(rule.at - line.at) < IN_LINE]
    before = max((rule.high for rule in others if rule.high < line.low), default=None)
    after = min((rule.low for rule in others if rule.low > line.high), default=None)
    for low, high in ((before, line.low), (line.high, after)):
        if low is None or high is None or low <= centre <= high:
            continue
        met = Rule(line.level, line.at, low, high)
        stops = _stops(met, across, head)
        ends = [_nearest(stops, end) for end in (low, high) if stops]
        if ends and ends[0] < ends[1] and _meets(ends, met, head):
            yield Span(line.level, ends[0], ends[1], LIKELY)


def _from_end_to_end(
    text: SheetText, line: Rule, across: Sequence[Rule], weight: float
) -> list[Span]:
    """What a text's line measures between the lines near its two ends, which may stop short of
    it; none where there is no line near one of them."""
    stops = _stops(line, across, _head(text), _head(text))
    ends = [_nearest(stops, end, np.inf) for end in (line.low, line.high)]
    if ends[0] >= ends[1] or not _meets(ends, line, _head(text)):
        return []
    return [Span(line.level, ends[0], ends[1], weight * LIKELY)]


def _beyond(line: Rule, across: Sequence[Rule], head: float) -> Iterator[Span]:
    """What lies between an end of a text's line and the next line beyond it, where another arrow
    may point at that from outside, too short to be found as a line."""
    stops = _stops(replace(line, low=-np.inf, high=np.inf), across, 0.0)
    for end, way in ((line.low, -1.0), (line.high, 1.0)):
        met = _nearest(stops, end, np.inf)
        others = [at for at in stops if way * (at - met) > IN_LINE]
        if abs(met - end) <= head and others:
            low, high = sorted((met, min(others, key=lambda at: abs(at - end))))
            yield Span(line.level, low, high, POSSIBLE)


def _nearest(places: Sequence[float], to: float, default: float = 0.0) -> float:
    """Of some places the one nearest to another, the first of several; the default without any."""
    return min(places, key=lambda at: abs(at - to), default=default)


def _stops(line: Rule, across: Sequence[Rule], beyond: float, touch: float = MISSED) -> list[float]:
    """Where other lines cross or meet a line, or lie so many px beyond its ends, in order; each
    once, by its longest piece.  They may end ``touch`` px before it."""
    met = [
        rule
        for rule in across
        if rule.low - touch <= line.at <= rule.high + touch
        and line.low - beyond <= rule.at <= line.high + beyond
    ]
    found: list[float] = []
    for rule in sorted(met, key=lambda rule: rule.low - rule.high):
        if all(abs(rule.at - at) > IN_LINE for at in found):
            found.append(rule.at)
    return sorted(found)


def _spans(
    text: SheetText, line: Rule, stops: Sequence[float], borders: Sequence[float]
) -> list[Span]:
    """What a line may measure: all of it, or what is beside the text."""
    along, across = _sides(text.box, line.level)
    centre = 0.5 * (along[0] + along[1])
    height = min(along[1] - along[0], across[1] - across[0])
    found = _adjacent(line.level, centre, stops, 1.0, ALONG * height)
    ends = [_nearest(stops, end) for end in (line.low, line.high)] if (stops) else []
    if ends and ends[0] < ends[1] and _meets(ends, line, _head(text)):
        found.append(Span(line.level, ends[0], ends[1], 1.0 if not found else 0.8))
    if borders:
        every = sorted([*stops, *borders])
        found += _adjacent(line.level, centre, every, 0.5, ALONG * height)
        ends = [_nearest(every, end) for end in (line.low, line.high)]
        if ends[0] < ends[1] and _meets(ends, line, MISSED):
            found.append(Span(line.level, ends[0], ends[1], 0.7))
    return found


def _meets(ends: Sequence[float], line: Rule, near: float) -> bool:
    return abs(ends[0] - line.low) <= near and abs(ends[1] - line.high) <= near


def _adjacent(
    level: bool, centre: float, stops: Sequence[float], weight: float, reach: float
) -> list[Span]:
    """Between the stops on both sides of a text's middle, or the nearest two on one side."""
    pairs = [Span(level, low, high, weight) for low, high in pairwise(stops)]
    around = [span for span in pairs if span.low <= centre <= span.high]
    if around or not pairs:
        return around
    near = pairs[0] if centre < pairs[0].low else pairs[-1]
    distance = max(near.low - centre, centre - near.high)
    return [near] if distance <= reach else []
