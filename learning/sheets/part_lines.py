"""The part's own lines in a view, and where it ends too soon."""

import math
from collections.abc import Sequence
from enum import Enum, auto

import cv2
import numpy as np

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import Board
from learning.sheets.chains_of_points import Points, across, norm, segment, unit
from learning.sheets.random_style import Pattern
from learning.sheets.view_variants import Border, SheetView

_CLOSED_PX = 1.0
"""Distance between the ends of a line up to which it is closed."""

_CELL_PX = 1.6
"""Ends of lines in one cell of this side meet."""

_SMOOTH = -0.985
"""Cosine between two lines' ways out of a point, up to which it is none."""

_TRACK_OVER_PX, _NARROWEST_PX = 1.0, 3.0
"""By which a hidden line's track is wider than its dashes, and px at least."""


class Tangents(Enum):
    """How smooth edges are drawn."""

    NONE = auto()
    FULL = auto()
    THIN = auto()
    PHANTOM = auto()


TANGENT_ODDS = (1, 1, 2, 1)
"""How often each."""


class Break(Enum):
    """The line at a broken out middle."""

    ZIGZAG = auto()
    WAVE = auto()
    FREEHAND = auto()


def draw_lines(board: Board, view: SheetView, tangents: Tangents, *, hidden: bool) -> None:
    """The lines of the part in a view.

    Args:
        board: to draw with.
        view: which.
        tangents: how smooth edges are drawn.
        hidden: whether hidden lines are.
    """
    style, visible = board.style, view.lines.visible
    board.canvas.lines(visible, InkClass.VISIBLE, style.widths.visible, style.darkness.visible)
    behind = view.lines.hidden if hidden else ()
    if hidden:
        _draw_hidden(board, view)
    if view.lines.tangent:
        _draw_tangents(board, view, tangents)
    corners = corners_of([*visible, *behind])
    for border in view.borders:
        corners = [corner for corner in corners if abs(corner[border.axis] - border.at) > 2.0]
    board.canvas.corners += corners


def draw_borders(board: Board, view: SheetView) -> None:
    """The lines at which a view ends too soon."""
    if not view.borders:
        return
    chance, style = board.chance, board.style
    kind = chance.choices(tuple(Break), (1, 1, 2))[0]
    width = chance.choice([style.widths.thin, style.widths.thin, style.widths.visible])
    for border in view.borders:
        ends = _across_view(view, border)
        if norm(ends[1] - ends[0]) < 4.0:
            continue
        if border.broken:
            board.thin([_break_line(board, ends, kind)], InkClass.OTHER, width)
        else:
            _draw_symmetry(board, ends)


def shade(board: Board, view: SheetView) -> None:
    """Now and then grey on a view."""
    if board.likely(0.07):
        points = np.concatenate(view.lines.visible).astype(np.float32)
        hull = np.asarray(cv2.convexHull(points)[:, 0], dtype=np.float32)
        board.canvas.tint(hull, *(board.chance.uniform(20.0, 120.0) for _ in range(2)))


def corners_of(chains: Sequence[Points]) -> list[Points]:
    """Where lines end and something shows it, each (2,): at corners, junctions and loose ends, not
    at seams nor at smooth joints."""
    cells: dict[tuple[int, int], list[tuple[Points, Points]]] = {}
    for chain in chains:
        if len(chain) > 6 and norm(chain[0] - chain[-1]) < _CLOSED_PX:
            continue
        for end, inner in ((chain[0], chain[1]), (chain[-1], chain[-2])):
            if norm(inner - end) > 1e-3:
                key = round(float(end[0]) / _CELL_PX), round(float(end[1]) / _CELL_PX)
                cells.setdefault(key, []).append((end, unit(inner - end)))
    corners = []
    for ends in cells.values():
        if len(ends) == 2 and float(ends[0][1] @ ends[1][1]) < _SMOOTH:
            continue
        corners.append(np.mean([point for point, _ in ends], axis=0))
    return corners


def _draw_hidden(board: Board, view: SheetView) -> None:
    chance, widths, dashes = board.chance, board.style.widths, board.style.dashes
    darkness = board.style.darkness.hidden
    from_start = board.likely(0.6)
    for chain in view.lines.hidden:
        phase = 0.0 if from_start else _phase(board, dashes.hidden)
        board.dashes(chain, dashes.hidden, phase, InkClass.HIDDEN, (widths.hidden, darkness))
    track = max(widths.hidden + _TRACK_OVER_PX, _NARROWEST_PX)
    board.canvas.track(view.lines.hidden, track)
    if not dashes.under_visible:
        return
    pen = widths.visible * chance.uniform(0.85, 1.35), darkness
    for chain in view.lines.visible:
        if board.likely(0.6):
            phase = _phase(board, dashes.hidden)
            board.dashes(chain, dashes.hidden, phase, InkClass.VISIBLE, pen)


def _phase(board: Board, pattern: Pattern) -> float:
    return board.chance.uniform(0.0, sum(pattern))


def _draw_tangents(board: Board, view: SheetView, tangents: Tangents) -> None:
    chance, widths, darkness = board.chance, board.style.widths, board.style.darkness
    chains = view.lines.tangent
    if tangents is Tangents.FULL:
        board.canvas.lines(chains, InkClass.VISIBLE, widths.visible, darkness.visible)
    elif tangents is Tangents.THIN:
        width = widths.thin if widths.thin < 0.8 * widths.visible else 0.5 * widths.visible
        shade_of_it = chance.choice([darkness.visible, darkness.dimension])
        board.canvas.lines(chains, InkClass.THIN, width, shade_of_it)
    elif tangents is Tangents.PHANTOM:
        pen = chance.choice([widths.thin, widths.visible]), darkness.visible
        for chain in chains:
            board.dashes(chain, board.style.dashes.phantom, 0.0, InkClass.THIN, pen)


def _across_view(view: SheetView, border: Border) -> Points:
    """(2, 2) the border, as long as the view is wide."""
    x0, y0, x1, y1 = view.box
    if border.axis == 0:
        return segment((border.at, y0), (border.at, y1))
    return segment((x0, border.at), (x1, border.at))


def _break_line(board: Board, ends: Points, kind: Break) -> Points:
    """(n, 2) across a view."""
    chance, height = board.chance, board.style.height
    long = norm(ends[1] - ends[0])
    along = unit(ends[1] - ends[0])
    aside = across(along)
    if kind is Break.ZIGZAG:
        size = min(0.12 * long, board.heights(0.4, 0.9))
        middle, over = ends.mean(axis=0), 0.4 * height * along
        steps = np.array([(-1.0, 0.0), (-0.4, 1.0), (0.4, -1.0), (1.0, 0.0)])
        inner = middle + size * (steps[:, :1] * along + steps[:, 1:] * aside)
        return np.concatenate([[ends[0] - over], inner, [ends[1] + over]])
    share = np.linspace(0.0, 1.0, max(40, int(long / 3.0)))
    if kind is Break.WAVE:
        swing = min(0.08 * long, 14.0) * np.sin(2.0 * math.pi * share)
    else:
        waves = [
            chance.uniform(-1.0, 1.0)
            * np.sin((order + 1) * chance.uniform(3.0, 9.0) * share + chance.uniform(0.0, 6.0))
            for order in range(3)
        ]
        swing = chance.uniform(1.0, 4.0) * np.sum(waves, axis=0)
    return ends[0] + share[:, None] * long * along + swing[:, None] * aside


def _draw_symmetry(board: Board, ends: Points) -> None:
    """The centre line that a half view ends at, with two short lines across each of its ends."""
    style = board.style
    along = unit(ends[1] - ends[0])
    over = board.heights(0.4, 1.2)
    line = segment(ends[0] - along * over, ends[1] + along * over)
    pen = style.widths.centre, style.darkness.centre
    board.dashes(line, style.dashes.centre, 0.0, InkClass.CENTRE, pen)
    if not board.likely(0.7):
        return
    half = 0.35 * style.height * across(along)
    for end, sign in ((ends[0], -1.0), (ends[1], 1.0)):
        middle = end + sign * 0.4 * over * along
        for step in (-1.5, 1.5):
            at = middle + step * along
            board.thin([segment(at - half, at + half)], InkClass.OTHER)
