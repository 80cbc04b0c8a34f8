"""A dimension line with its heads and its number, and the extension lines beside it."""

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import LEFT, Board
from learning.sheets.chains_of_points import (
    Points,
    norm,
    rectangle,
    segment,
    shifted,
    unit,
)
from learning.sheets.random_style import TextPosition

_LETTER = 0.62
"""Width of a letter in its height, about."""

_SHORTEST_PX = 2.0
"""px of a dimension line or an extension line, under which there is none."""

_OUTSIDE = 2.4
"""Lengths of a head under which both stand outside of what is measured."""

_LEVEL = 1.0
"""Degrees from level or upright up to which a number is that."""


@dataclass(frozen=True, eq=False)
class _Span:
    """What is measured.

    Attributes:
        start, end: (2,).
        way: (2,) of length 1, from the one to the other.
        above: (2,) of length 1, to where a number above the line stands.
    """

    start: Points
    end: Points
    way: Points
    above: Points

    @property
    def length(self) -> float:
        return norm(self.end - self.start)

    @property
    def middle(self) -> Points:
        return (self.start + self.end) / 2.0


def dimension_line(board: Board, start: npt.ArrayLike, end: npt.ArrayLike, text: str) -> None:
    """A dimension from one point (2,) to another.

    Args:
        board: to draw with.
        start: where it begins.
        end: where it ends.
        text: the number.
    """
    span = _span(np.asarray(start, dtype=np.float64), np.asarray(end, dtype=np.float64))
    if span.length < _SHORTEST_PX:
        return
    heads, width = board.style.heads, _LETTER * len(text) * board.style.height
    position = board.style.numbers.position
    if position is TextPosition.MIXED:
        choices = TextPosition.ABOVE, TextPosition.GAP, TextPosition.ON
        position = board.chance.choice(choices)
    outside = span.length < _OUTSIDE * heads.length
    _draw_heads(board, span, outside)
    room = span.length - (0.0 if outside else 2.0 * heads.length)
    if (width > room or (outside and board.likely(0.3))) and board.likely(0.8):
        middle = _led_out(board, span, width, position, outside)
    else:
        middle = span.middle
        if not outside:
            position = _draw_line(board, span, width, position)
        if position is not TextPosition.GAP and board.likely(0.15):
            middle = middle + span.way * board.chance.uniform(-0.25, 0.25) * span.length
    _write(board, span, text, middle, position)


def extension_line(board: Board, edge: npt.ArrayLike, level: npt.ArrayLike) -> None:
    """From what is measured (2,) to a dimension line (2,) and a little farther."""
    edge, level = np.asarray(edge, dtype=np.float64), np.asarray(level, dtype=np.float64)
    length = norm(level - edge)
    if length < _SHORTEST_PX:
        return
    way, numbers = unit(level - edge), board.style.numbers
    start = edge + way * min(numbers.gap, 0.5 * length)
    board.thin([segment(start, level + way * numbers.over)])


def _span(start: Points, end: Points) -> _Span:
    way = unit(end - start)
    above = np.array([way[1], -way[0]])
    if above[1] > 1e-6 or (abs(above[1]) <= 1e-6 and above[0] > 0.0):
        above = -above
    return _Span(start, end, way, above)


def _draw_heads(board: Board, span: _Span, outside: bool) -> None:
    if not outside:
        board.arrow(span.start, -span.way)
        board.arrow(span.end, span.way)
        return
    tail = span.way * board.style.heads.length * board.chance.uniform(1.3, 3.0)
    board.thin([segment(span.start, span.start - tail), segment(span.end, span.end + tail)])
    if board.likely(0.7):
        board.thin([segment(span.start, span.end)])
    board.arrow(span.start, span.way)
    board.arrow(span.end, -span.way)


def _led_out(
    board: Board, span: _Span, width: float, position: TextPosition, outside: bool
) -> Points:
    """Lead the line out to one side, where the number stands: (2,) its middle."""
    side = board.chance.choice([-1, 1])
    start, way = (span.end if side > 0 else span.start), side * span.way
    heads = 2.0 * board.style.heads.length
    far = heads + (width if position is not TextPosition.GAP and board.likely(0.7) else 0.0)
    board.thin([segment(start, start + way * far)])
    if not outside:
        board.thin([segment(span.start, span.end)])
    return start + way * (heads + 0.55 * width)


def _draw_line(board: Board, span: _Span, width: float, position: TextPosition) -> TextPosition:
    """The line between the heads, with a gap where one is due; the position that comes of it."""
    steep = abs(float(span.way[1])) > 0.3
    upright = board.style.numbers.upright and steep and position is not TextPosition.BESIDE
    if position in (TextPosition.ABOVE, TextPosition.BESIDE) and not (
        upright and board.likely(0.8)
    ):
        board.thin([segment(span.start, span.end)])
        return position
    half = 0.0
    if position is not TextPosition.ON:
        position = TextPosition.GAP
        half = 0.5 * width + 0.3 * board.style.height
        if board.style.numbers.upright:
            lying, standing = np.abs(span.way)
            half = half * lying + 0.8 * board.style.height * standing
    if 2.0 * half < span.length:
        middle, way = span.middle, span.way * half
        board.thin([segment(span.start, middle - way), segment(middle + way, span.end)])
    return position


def _write(board: Board, span: _Span, text: str, middle: Points, position: TextPosition) -> None:
    height, chance = board.style.height, board.chance
    lying, standing = np.abs(span.way)
    if position is TextPosition.ABOVE:
        middle = middle + span.above * board.heights(0.65, 0.95)
    elif position is TextPosition.BESIDE:
        width = _LETTER * len(text) * height
        aside = board.heights(0.55, 0.95) * lying
        aside += (width * chance.uniform(0.45, 0.6) + 2.0) * standing
        middle = middle + span.above * chance.choice([-1, 1]) * aside
    degrees = 0.0
    if position is not TextPosition.BESIDE and not board.style.numbers.upright:
        degrees = _readable(math.degrees(math.atan2(-span.way[1], span.way[0])))
    half = np.array(board.write(text, middle, degrees=degrees)) / 2.0
    if degrees == 0.0 and board.likely(0.06):
        small = board.look.times(0.6)
        for row, limit in enumerate(("+0.02", "-0.01")):
            at = shifted(middle, half[0] + 2.0, (row - 0.5) * 0.7 * height)
            board.write(limit, at, LEFT, look=small)
    if board.likely(0.03):
        low, high = middle - half - 3.0, middle + half + 3.0
        board.thin([rectangle(*low, *high)], InkClass.DIMENSION)


def _readable(degrees: float) -> float:
    """An angle at which a text is read from below or from the right."""
    if degrees > 90.0 + _LEVEL:
        degrees -= 180.0
    elif degrees < -90.0 + _LEVEL:
        degrees += 180.0
    if abs(degrees) < _LEVEL:
        return 0.0
    return 90.0 if abs(abs(degrees) - 90.0) < _LEVEL else degrees
