"""The sheet's furniture: border, title block, tables, general notes."""

from itertools import pairwise

import numpy as np

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import LEFT, Board
from learning.sheets.chains_of_points import (
    Points,
    circle,
    dashed,
    rectangle,
    segment,
)
from learning.sheets.symbols import surface_sign
from learning.sheets.wording import han, number, words

Box = tuple[float, float, float, float]
"""x, y, width, height in px."""

_ROW = 1.7
"""Heights of the text from line to line of notes."""

_LOGOS = ("ACME", "TECH", "LAB", "CAD", "MTC")
"""Letters of logos."""


_MARK_PX = 20.0
"""Length of the marks at the middles of the border."""


def furnish(board: Board) -> None:
    """Most of it on most sheets."""
    chance, canvas = board.chance, board.canvas
    if board.likely(0.72):
        margin = chance.uniform(0.01, 0.035) * canvas.width
        _draw_border(board, margin)
    else:
        margin = chance.uniform(0.0, 0.02) * canvas.width
    if board.likely(0.75):
        _draw_title_block(board, margin)
    if board.likely(0.22):
        _draw_corner_table(board, margin)
    if board.likely(0.45):
        _write_notes(board, margin)
    if board.likely(0.2):
        right, height = canvas.width - margin, board.style.height
        surface_sign(board, (right - board.heights(6.0, 12.0), margin + 5.0 * height))
        board.write("( √ )", (right - 3.0 * height, margin + 3.0 * height))


def table(board: Board, box: Box, rows: int, columns: int, width: float) -> None:
    """A table, most of its cells filled in.

    Args:
        board: to draw with.
        box: where.
        rows: of cells.
        columns: of cells; some are joined.
        width: px of its lines.
    """
    chance = board.chance
    x, y, wide, high = box
    levels = np.linspace(y, y + high, rows + 1)
    inner = sorted(x + wide * chance.uniform(0.08, 0.92) for _ in range(columns - 1))
    places = [x, *inner, x + wide]
    lines = [segment((x, this_level), (x + wide, this_level)) for this_level in levels]
    for place in places:
        first, last = 0, rows
        if place in inner and not board.likely(0.6):
            first, last = chance.randint(0, rows // 2), chance.randint(rows // 2 + 1, rows)
        lines.append(segment((place, levels[first]), (place, levels[last])))
    board.thin(lines, InkClass.FRAME, width, board.style.darkness.frame)
    for level in levels[:-1]:
        for left, right in pairwise(places):
            if right - left > board.style.height and board.likely(0.75):
                _write_cell(board, (left, level, right - left, high / rows))


def _write_cell(board: Board, box: Box) -> None:
    chance, style = board.chance, board.style
    x, y, width, height = box
    look = board.look.times(min(chance.uniform(0.5, 1.0), 0.6 * height / style.height))
    if style.han and board.likely(0.6):
        text = han(chance, chance.randint(2, 6))
        board.write(text, (x + 3.0, y + height / 2.0), LEFT, look=look.in_letters(style.han))
        return
    text = words(chance, chance.randint(1, 3)) if board.likely(0.7) else number(chance)
    fitting = max(1, int(width / (0.68 * look.height)))
    board.write(text[:fitting], (x + 3.0, y + height / 2.0), LEFT, look=look)


def _draw_border(board: Board, margin: float) -> None:
    chance, canvas, style = board.chance, board.canvas, board.style
    visible, thin = style.widths.visible, style.widths.thin
    width = chance.choice([visible, 1.3 * visible, thin, 2.0 * visible])
    right, foot = canvas.width - margin, canvas.height - margin
    ring = rectangle(margin, margin, right, foot)
    board.thin([ring], InkClass.FRAME, width, style.darkness.frame)
    if board.likely(0.5):
        _draw_zones(board, margin, margin * chance.uniform(0.3, 0.7))
    if board.likely(0.2):
        middle = np.array([canvas.width, canvas.height]) / 2.0
        marks = [
            segment((margin, middle[1]), (margin + _MARK_PX, middle[1])),
            segment((right, middle[1]), (right - _MARK_PX, middle[1])),
            segment((middle[0], margin), (middle[0], margin + _MARK_PX)),
            segment((middle[0], foot), (middle[0], foot - _MARK_PX)),
        ]
        board.thin(marks, InkClass.FRAME, visible, style.darkness.frame)


def _draw_zones(board: Board, margin: float, breadth: float) -> None:
    """Letters and numbers of zones in a strip around the border."""
    chance, canvas, style = board.chance, board.canvas, board.style
    outer = margin - breadth
    size = np.array([canvas.width, canvas.height], dtype=np.float64)
    lines = [rectangle(outer, outer, *(size - outer))]
    look = board.look.times(min(1.0, 0.7 * breadth / style.height))
    for axis, count in ((0, chance.randint(3, 9)), (1, chance.randint(2, 6))):
        steps = size[axis] / count
        across_it = (outer, margin), (size[1 - axis] - margin, size[1 - axis] - outer)
        for zone in range(count):
            name = str(zone + 1) if axis == 0 else "ABCDEFGH"[zone]
            for first, last in across_it:
                at = np.array([steps * (zone + 0.5), (first + last) / 2.0])
                board.write(name, at if axis == 0 else at[::-1], look=look)
                if zone:
                    line = segment((steps * zone, first), (steps * zone, last))
                    lines.append(line if axis == 0 else line[:, ::-1])
    board.thin(lines, InkClass.FRAME, None, style.darkness.frame)


def _draw_title_block(board: Board, margin: float) -> None:
    chance, canvas, style = board.chance, board.canvas, board.style
    width = min(canvas.width * chance.uniform(0.25, 0.55), 900.0)
    height = min(canvas.height * chance.uniform(0.1, 0.25), 330.0)
    if board.likely(0.1):
        width = canvas.width - 2.0 * margin
    x, y = canvas.width - margin - width, canvas.height - margin - height
    rows = chance.randint(2, 7)
    pen = chance.choice([style.widths.thin, style.widths.visible])
    table(board, (x, y, width, height), rows, chance.randint(2, 6), pen)
    if board.likely(0.4):
        box = x + 0.5 * width, y + 0.3 * height, 0.5 * width, 0.7 * height
        table(board, box, max(2, rows // 2), chance.randint(1, 3), style.widths.thin)
    if board.likely(0.5):
        at = np.array([x + width * chance.uniform(0.1, 0.9), y + height * chance.uniform(0.2, 0.8)])
        _draw_projection_sign(board, at, 0.15 * height)
    if board.likely(0.4):
        at = np.array(
            [x + width * chance.uniform(0.05, 0.9), y + height * chance.uniform(0.3, 0.7)]
        )
        _draw_logo(board, at, height * chance.uniform(0.15, 0.3))


def _draw_projection_sign(board: Board, centre: Points, radius: float) -> None:
    """Two circles and a cone's side."""
    style = board.style
    cone = np.array([(2.0, -1.0), (5.0, -0.5), (5.0, 0.5), (2.0, 1.0), (2.0, -1.0)])
    lines = [circle(centre, radius), circle(centre, 0.5 * radius), centre + radius * cone]
    width = board.chance.choice([style.widths.thin, style.widths.visible])
    board.thin(lines, InkClass.FRAME, width, style.darkness.frame)
    axis = centre + radius * segment((-1.4, 0.0), (5.5, 0.0))
    board.thin(dashed(axis, (9.0, 3.0, 3.0, 3.0)), InkClass.FRAME, None, style.darkness.frame)


def _draw_logo(board: Board, centre: Points, size: float) -> None:
    chance = board.chance
    corners = [
        (chance.uniform(-1.0, 1.0), chance.uniform(-1.0, 1.0)) for _ in range(chance.randint(3, 7))
    ]
    board.canvas.fill(centre + size * np.array(corners), InkClass.OTHER, chance.randint(90, 255))
    look = board.look.times(0.8 * size / board.style.height)
    board.write(chance.choice(_LOGOS), centre, look=look)


def _draw_corner_table(board: Board, margin: float) -> None:
    """A list of parts or of revisions in a corner."""
    chance, canvas = board.chance, board.canvas
    rows = chance.randint(2, 9)
    width, height = canvas.width * chance.uniform(0.18, 0.4), rows * board.heights(1.4, 2.2)
    right, low = chance.choice([(False, False), (True, False), (False, True)])
    x = canvas.width - margin - width if right else margin
    y = canvas.height - margin - height if low else margin
    table(board, (x, y, width, height), rows, chance.randint(2, 5), board.style.widths.thin)


def _write_notes(board: Board, margin: float) -> None:
    chance, canvas, style = board.chance, board.canvas, board.style
    width, height = canvas.width, canvas.height
    left, head = margin + 15.0, margin + 2.0 * style.height
    at = chance.choice(
        [
            (left, height * chance.uniform(0.6, 0.85)),
            (left, head),
            (0.6 * width, head),
            (width * chance.uniform(0.1, 0.6), height * chance.uniform(0.1, 0.8)),
        ]
    )
    for row in range(chance.randint(1, 8)):
        look = board.look
        if style.han:
            text, look = han(chance, chance.randint(4, 16)), look.in_letters(style.han)
        else:
            text = (f"{row}. " if row else "") + words(chance, chance.randint(2, 7))
        board.write(text, (at[0], at[1] + row * _ROW * style.height), LEFT, look=look)
