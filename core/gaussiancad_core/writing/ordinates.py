"""Dimensions that count from a common zero, each at the end of its own line (ISO 129-1)."""

import re
from collections.abc import Sequence

from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.tracing.level_rules import Rule
from gaussiancad_core.writing.dimension_layout import ALONG, BESIDE, CLOSE, IN_LINE, LOOSELY, MISSED
from gaussiancad_core.writing.sheet_texts import SheetText

_ZERO = re.compile(r"[0O](?:[.,]0+)?")


def is_zero(text: SheetText) -> bool:
    """Whether a text may be the zero that others count from."""
    return not text.field and _ZERO.fullmatch(text.text) is not None


def ordinate_length(
    text: SheetText, zeros: Sequence[SheetText], rules: Sequence[Rule]
) -> float | None:
    """px from the line of a zero to that of a text in a row with it; nothing if there is none.

    Args:
        text: of a dimension.
        zeros: the texts of the sheet that are zeros.
        rules: its narrow lines.
    """
    for zero in zeros:
        # A lone zero looks the same whichever way it is read.
        if not _in_row(text.box, zero.box, text.level):
            continue
        for reach in (LOOSELY, ALONG):
            line = _line_at_end(text.box, text.level, rules, reach)
            start = _line_at_end(zero.box, text.level, rules, reach)
            if line is None or start is None or start is line:
                continue
            # Lines farther away belong to a row of numbers if they begin or end in one row, too.
            apart = min(abs(line.low - start.low), abs(line.high - start.high))
            if reach == LOOSELY or apart <= MISSED:
                return abs(line.at - start.at)
    return None


def _along(box: Box, level: bool) -> tuple[float, float]:
    return (box[0], box[2]) if level else (box[1], box[3])


def _across(box: Box, level: bool) -> tuple[float, float]:
    return _along(box, not level)


def _in_row(one: Box, two: Box, level: bool) -> bool:
    """Whether two texts start or end together, below each other."""
    reach = BESIDE * (_across(one, level)[1] - _across(one, level)[0])
    (low, high), (start, end) = _along(one, level), _along(two, level)
    return min(abs(low - start), abs(high - end)) <= reach


def _line_at_end(box: Box, level: bool, rules: Sequence[Rule], reach: float) -> Rule | None:
    """The line that runs towards an end of a text, in line with it, so many heights away at most:
    of those that are best in line the nearest."""
    (low, high), (top, bottom) = _along(box, level), _across(box, level)
    height, middle = bottom - top, 0.5 * (top + bottom)
    near = [
        rule
        for rule in rules
        if rule.level is level
        and abs(rule.at - middle) <= CLOSE * height
        and (
            -0.2 * height <= rule.low - high <= reach * height
            or -0.2 * height <= low - rule.high <= reach * height
        )
    ]
    best = min((abs(rule.at - middle) for rule in near), default=0.0)
    return min(
        (rule for rule in near if abs(rule.at - middle) <= best + IN_LINE),
        key=lambda rule: max(rule.low - high, low - rule.high),
        default=None,
    )
