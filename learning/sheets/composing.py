"""One sheet: a part's views, all that is written at them, and the sheet's furniture."""

import random
from collections.abc import Sequence
from enum import Enum, auto

from learning.sheets.board import Board
from learning.sheets.canvas import Canvas
from learning.sheets.centre_marks import bend_lines
from learning.sheets.cut_hatching import hatch
from learning.sheets.inset_drawings import draw_detail, draw_picture
from learning.sheets.letter_fonts import system_fonts
from learning.sheets.loose_marks import litter
from learning.sheets.part_lines import (
    TANGENT_ODDS,
    Tangents,
    draw_borders,
    draw_lines,
    shade,
)
from learning.sheets.random_style import random_style
from learning.sheets.rendering import Rendered, rendered
from learning.sheets.sheet_furniture import furnish
from learning.sheets.symbols import cutting_line
from learning.sheets.variants import varied
from learning.sheets.view_annotations import annotate
from learning.sheets.view_choice import laid_out, random_paper
from learning.sheets.view_variants import SheetView
from learning.sheets.wording import caption
from learning.training_parts import DrawnPart

_TRIES = 20
"""Layouts without room for the views, one after the other, from which something is wrong."""

_PICTURED = 0.8
"""Share of the sheets with a picture, where there is one of the part."""

_CAPTIONED = (0.08, 0.08, 0.15, 0.9)
"""Shares of the views that have captions, one of them on each sheet."""


class _Hidden(Enum):
    """On which views hidden lines are drawn."""

    ALL = auto()
    NONE = auto()
    SOME = auto()


_HIDDEN_ODDS = (0.52, 0.3, 0.18)
"""How often each."""


def clean_sheet(chance: random.Random, parts: Sequence[DrawnPart]) -> Rendered:
    """A sheet as it comes from the plotter.

    Args:
        chance: decides all.
        parts: one of which is on it, or something made of one.
    """
    fonts = system_fonts()
    style = random_style(chance, fonts)
    part = varied(chance.choice(parts), chance)
    for _ in range(_TRIES):
        paper = random_paper(chance)
        views = laid_out(part, paper, style.height, chance)
        if views:
            break
    else:
        raise RuntimeError(f"{_TRIES} layouts one after the other had no room for the views")
    board = Board(Canvas(paper.width, paper.height), style, chance, fonts)
    _draw_views(board, views)
    plain = [view for view in views if view.section is None]
    if plain and (len(plain) < len(views) or board.likely(0.1)):
        cutting_line(board, chance.choice(plain))
    if board.likely(0.2):
        draw_detail(board, chance.choice(views), views)
    if part.picture and board.likely(_PICTURED):
        draw_picture(board, part, views)
    furnish(board)
    litter(board, views)
    return rendered(board.canvas, smooth=style.smooth)


def _draw_views(board: Board, views: Sequence[SheetView]) -> None:
    chance = board.chance
    policy = chance.choices(tuple(_Hidden), _HIDDEN_ODDS)[0]
    tangents = chance.choices(tuple(Tangents), TANGENT_ODDS)[0]
    captioned = chance.choice(_CAPTIONED)
    for view in views:
        hidden = view.section is None and policy is not _Hidden.NONE
        hidden = hidden and (policy is _Hidden.ALL or board.likely(0.5))
        draw_lines(board, view, tangents, hidden=hidden)
        draw_borders(board, view)
        hatch(board, view)
        shade(board, view)
        annotate(board, view)
        if not hidden and view.section is None and board.likely(0.045):
            bend_lines(board, view)
        if view.section is not None or board.likely(captioned):
            _write_caption(board, view)


def _write_caption(board: Board, view: SheetView) -> None:
    x0, y0, x1, y1 = view.box
    away = board.heights(1.5, 4.0)
    at = (x0 + x1) / 2.0, y0 - away if board.likely(0.5) else y1 + away
    look = board.other_look() if board.likely(0.33) else board.look
    board.write(caption(board.chance), at, look=look.times(board.chance.uniform(0.8, 1.9)))
