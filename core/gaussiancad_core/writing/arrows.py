"""What dimension lines measure by their arrowheads: from tip to tip (ISO 129-1).

Two heads on one line point away from each other, and the line runs between them; or, where there
is no room, they point at each other from outside.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.picture_noise import LEVEL
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.tracing.level_rules import Rule
from gaussiancad_core.sheet.votes import HALF
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.writing.dimension_layout import ALONG, BESIDE, IN_LINE
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.sheet_texts import SheetText

_FAR = 12.0
"""Distance of two heads that point at each other from outside, in their length, at most."""

_SURE, _LIKELY = 1.5, 1.1
"""Weights of what the nearest pair of heads measures, and of what others do."""


@dataclass(frozen=True)
class _Tip:
    """A head along one axis of the sheet, px: its tip along and across, its way, its length."""

    along: float
    across: float
    way: float
    length: float


@dataclass(frozen=True)
class ArrowPair:
    """Two heads that belong together.

    Attributes:
        level: whether they lie along x.
        at: px across.
        low, high: px along, of the tips.
        inside: whether the line runs between them.
    """

    level: bool
    at: float
    low: float
    high: float
    inside: bool


def arrow_pairs(
    heads: Sequence[Head], rules: Sequence[Rule], texts: Sequence[SheetText], turn: Turn
) -> tuple[ArrowPair, ...]:
    """Heads of level and upright dimension lines, two and two.

    Args:
        heads: px of the sheet as stored.
        rules: level and upright lines, px of the upright sheet.
        texts: of the sheet: they interrupt dimension lines.
        turn: of the sheet.
    """
    found: list[ArrowPair] = []
    for level in (True, False):
        tips = _tips(heads, level, turn)
        this_rules = [rule for rule in rules if rule.level is level]
        for tip in tips:
            if tip.way > 0:
                continue
            # Of a line between them this is the lower one, and points down.
            other = min(
                (far for far in tips if far.way > 0 and _in_line(tip, far)),
                key=lambda far: far.along,
                default=None,
            )
            if other is not None and _is_drawn(tip, other, this_rules, texts):
                found.append(ArrowPair(level, tip.across, tip.along, other.along, inside=True))
        for tip in tips:
            if tip.way < 0:
                continue
            # From outside the lower one points up.
            other = min(
                (far for far in tips if far.way < 0 and _in_line(tip, far)),
                key=lambda far: far.along,
                default=None,
            )
            if other is not None and other.along - tip.along <= _FAR * max(
                tip.length, other.length
            ):
                found.append(ArrowPair(level, tip.across, tip.along, other.along, inside=False))
    return tuple(found)


def _tips(heads: Sequence[Head], level: bool, turn: Turn) -> list[_Tip]:
    found = []
    for head in heads:
        ends = turn.to_upright(np.array([head.tip, np.add(head.tip, head.way)]))
        way = ends[1] - ends[0]
        way /= np.hypot(*way)
        along, across = (0, 1) if level else (1, 0)
        if abs(way[across]) <= LEVEL:
            tip = ends[0]
            length = head.length / turn.scale
            found.append(
                _Tip(float(tip[along]), float(tip[across]), float(np.sign(way[along])), length)
            )
    return found


def _in_line(tip: _Tip, far: _Tip) -> bool:
    return abs(far.across - tip.across) <= IN_LINE and far.along > tip.along


def _is_drawn(tip: _Tip, far: _Tip, rules: Sequence[Rule], texts: Sequence[SheetText]) -> bool:
    """Whether a line runs between two heads, but for a text in it."""
    low, high = tip.along + tip.length, far.along - far.length
    if high <= low:
        return True
    spans = [(rule.low, rule.high) for rule in rules if abs(rule.at - tip.across) <= IN_LINE]
    level = bool(rules) and rules[0].level
    for text in texts:
        along, across = _sides(text.box, level)
        if across[0] <= tip.across <= across[1]:
            height = min(along[1] - along[0], across[1] - across[0])
            spans.append((along[0] - height, along[1] + height))
    return _covered(spans, low, high) >= HALF * (high - low)


def _covered(spans: Sequence[tuple[float, float]], low: float, high: float) -> float:
    """Length of a stretch that spans cover."""
    covered, reached = 0.0, low
    for start, end in sorted(spans):
        first, last = max(start, reached), min(end, high)
        if last > first:
            covered += last - first
            reached = last
    return covered


def _sides(box: Box, level: bool) -> tuple[tuple[float, float], tuple[float, float]]:
    x, y = (box[0], box[2]), (box[1], box[3])
    return (x, y) if level else (y, x)


def arrow_spans(text: SheetText, pairs: Sequence[ArrowPair]) -> tuple[Span, ...]:
    """What the pairs of heads near a text measure, the likeliest first."""
    near = sorted(_near(text, pairs), key=lambda pair: pair[0])
    return tuple(
        Span(pair.level, pair.low, pair.high, _LIKELY if rank else _SURE)
        for rank, (_, pair) in enumerate(near)
    )


def _near(text: SheetText, pairs: Sequence[ArrowPair]) -> Iterator[tuple[float, ArrowPair]]:
    """Pairs whose line a text may stand at, and how far from the middle of what they measure."""
    for pair in pairs:
        along, across = _sides(text.box, pair.level)
        if pair.level and not text.level:
            continue
        height = across[1] - across[0] if text.level is pair.level else along[1] - along[0]
        centre = (along[0] + along[1]) / 2.0
        off = max(across[0] - pair.at, pair.at - across[1], 0.0)
        past = max(pair.low - centre, centre - pair.high, 0.0)
        if off > BESIDE * height or past > ALONG * height:
            continue
        if past and pair.inside and max(pair.low - along[1], along[0] - pair.high) > height:
            continue
        yield off + past, pair
