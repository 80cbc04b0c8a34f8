"""What else lies about on sheets: loose texts, tables, scale bars, stamps, remarks by hand."""

import math
import string
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import Board
from learning.sheets.chains_of_points import (
    Points,
    arc,
    circle,
    rectangle,
    segment,
)
from learning.sheets.sheet_furniture import table
from learning.sheets.view_variants import SheetView
from learning.sheets.wording import number, words

_STAMPS = (
    "DRAFT", "CONFIDENTIAL", "COPY", "APPROVED", "SAMPLE", "PRELIMINARY", "VOID",
    "FOR REFERENCE ONLY",
)  # fmt: skip
"""What stamps say."""

_STRAIGHT = "ILTHE1470"
"""Characters that look like lines of a part."""

_CLEARANCE_PX, _TRIES = 8.0, 12
"""px from views at least, and places that are tried."""


def litter(board: Board, views: Sequence[SheetView]) -> None:
    """Some of it on some sheets."""
    if board.likely(0.35):
        for _ in range(board.chance.randint(1, 9)):
            _write_loose(board, views)
    if board.likely(0.12):
        _draw_table(board, views)
    if board.likely(0.06):
        _draw_scale_bar(board, views)
    if board.likely(0.09):
        _stamp(board)
    if board.likely(0.04):
        _square_paper(board)
    if board.likely(0.05):
        box = rectangle(*board.chance.choice(views).box)
        board.canvas.tint(box, *(board.chance.uniform(10.0, 60.0) for _ in range(2)))
    if board.likely(0.06):
        for _ in range(board.chance.randint(1, 3)):
            _scribble(board)
    if board.likely(0.15):
        ends = np.array([_anywhere(board), _anywhere(board)])
        width, darkness = board.chance.uniform(0.7, 2.0), board.chance.randint(60, 200)
        board.thin([ends], InkClass.OTHER, width, darkness)


def _anywhere(board: Board) -> Points:
    """(2,) some place on the sheet."""
    share = board.chance.uniform(0.04, 0.92), board.chance.uniform(0.05, 0.92)
    return np.array([board.canvas.width, board.canvas.height]) * share


def _clear(corner: Points, size: Points, views: Sequence[SheetView]) -> bool:
    """Whether no view is in a box."""
    for view in views:
        box = np.array(view.box).reshape(2, 2)
        low, high = box[0] - _CLEARANCE_PX, box[1] + _CLEARANCE_PX
        if not ((corner + size < low) | (corner > high)).any():
            return False
    return True


def _write_loose(board: Board, views: Sequence[SheetView]) -> None:
    """A letter, a number or a word anywhere, more often near views, upright or turned."""
    chance = board.chance
    text = chance.choice(
        [
            chance.choice(string.ascii_uppercase),
            chance.choice(string.ascii_letters + string.digits),
            number(chance),
            words(chance, 1),
            chance.choice(_STRAIGHT),
        ]
    )
    look = board.other_look().times(chance.uniform(0.6, 2.6))
    at = _anywhere(board)
    if board.likely(0.5):
        x0, y0, x1, y1 = chance.choice(views).box
        around = 3.0 * look.height
        at = np.array(
            [
                chance.uniform(x0 - around, x1 + around),
                chance.uniform(y0 - around, y1 + around),
            ]
        )
    degrees = chance.choice([0.0, 0.0, 0.0, 90.0, 270.0, chance.uniform(-60.0, 60.0)])
    board.write(text, at, degrees=degrees, look=look)


def _draw_table(board: Board, views: Sequence[SheetView]) -> None:
    """A table in the drawing area, where there is room for one."""
    chance, style = board.chance, board.style
    rows = chance.randint(2, 10)
    sheet = np.array([board.canvas.width, board.canvas.height])
    size = np.array([sheet[0] * chance.uniform(0.12, 0.35), rows * board.heights(1.3, 2.4)])
    for _ in range(_TRIES):
        corner = _anywhere(board)
        if _clear(corner, size, views) and (corner + size < sheet).all():
            width = chance.choice([style.widths.thin, style.widths.visible])
            table(board, (*corner, *size), rows, chance.randint(2, 6), width)
            return


def _draw_scale_bar(board: Board, views: Sequence[SheetView]) -> None:
    chance, darkness = board.chance, board.style.darkness.frame
    x, y = _anywhere(board)
    long, high = board.canvas.width * chance.uniform(0.08, 0.3), board.heights(0.3, 0.7)
    if not _clear(np.array([x, y - 2.0 * high]), np.array([long, 4.0 * high]), views):
        return
    steps = chance.randint(2, 10)
    places = x + long * np.linspace(0.0, 1.0, steps + 1)
    if board.likely(0.5):
        for left, right in zip(places[0::2], places[1::2], strict=False):
            board.canvas.fill(rectangle(left, y, right, y + high), InkClass.FRAME, darkness)
        lines = [rectangle(x, y, x + long, y + high)]
    else:
        lines = [segment((x, y), (x + long, y))]
        for step, place in enumerate(places):
            lines.append(segment((place, y), (place, y - high * (1 if step % 5 else 2))))
    board.thin(lines, InkClass.FRAME, None, darkness)
    look = board.look.times(0.7)
    for step in range(0, steps + 1, max(1, steps // 4)):
        board.write(str(10 * step), (places[step], y + 2.2 * high), look=look)


def _stamp(board: Board) -> None:
    """A stamp or a watermark, pale or dark, mostly at a slant."""
    chance = board.chance
    centre, text = _anywhere(board), chance.choice(_STAMPS)
    degrees = chance.choice([0.0, 30.0, 45.0, -30.0, chance.uniform(-50.0, 50.0)])
    darkness = chance.randint(20, 70) if board.likely(0.6) else chance.randint(70, 220)
    factor = chance.uniform(1.5, 6.0)
    look = board.other_look().times(factor)
    ink = InkClass.OTHER if factor > 3.0 else InkClass.TEXT
    board.write(text, centre, degrees=degrees, look=replace(look, darkness=darkness, ink=ink))
    if not board.likely(0.5):
        return
    half = np.array([0.4 * len(text), 0.9]) * look.height
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    turn = np.array([[cosine, -sine], [sine, cosine]])
    lines = [rectangle(*-half, *half) @ turn + centre]
    if board.likely(0.4):
        lines = [circle(centre, half[0]), circle(centre, 0.85 * half[0])]
    board.thin(lines, InkClass.OTHER, chance.uniform(1.0, 4.0), darkness)


def _square_paper(board: Board) -> None:
    """Pale squares on the paper."""
    chance, canvas = board.chance, board.canvas
    pitch, level = chance.uniform(14.0, 60.0), chance.uniform(12.0, 60.0)
    for place in np.arange(chance.uniform(0.0, pitch), canvas.height, pitch):
        canvas.tint(segment((0.0, place), (canvas.width, place)), level, level)
    for place in np.arange(chance.uniform(0.0, pitch), canvas.width, pitch):
        canvas.tint(segment((place, 0.0), (place, canvas.height)), level, level)


def _scribble(board: Board) -> None:
    """What a hand remarked."""
    chance, widths = board.chance, board.style.widths
    at = _anywhere(board)
    steps = [(chance.gauss(0.0, 1.0), chance.gauss(0.0, 1.0)) for _ in range(chance.randint(6, 30))]
    line = at + np.cumsum(steps, axis=0) * chance.uniform(3.0, 14.0)
    width = chance.choice([widths.thin, widths.visible])
    board.thin([line], InkClass.OTHER, width, chance.randint(80, 255))
    if board.likely(0.5):
        sweep = chance.uniform(5.8, 6.8)
        ring = arc((0.0, 0.0), chance.uniform(15.0, 80.0), chance.uniform(0.0, 6.0), sweep)
        oval = at + ring * (1.0, chance.uniform(0.6, 1.4))
        board.thin([oval], InkClass.OTHER, widths.visible, chance.randint(90, 255))
