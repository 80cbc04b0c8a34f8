"""Symbols: tolerance frames, signs of surfaces, datums, welds, where sections are cut."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import LEFT, RIGHT, Board
from learning.sheets.chains_of_points import (
    Points,
    across,
    circle,
    dashed,
    norm,
    rectangle,
    segment,
    shifted,
    unit,
)
from learning.sheets.view_variants import SheetView

_TOLERANCES = ("0.1", "0.05", "⌀0.2", "0.02", "⌀0.1")
"""In tolerance frames."""

_ROUGHNESSES = ("3.2", "1.6", "Ra 0.8", "6.3", "12.5")
"""At signs of surfaces."""

_WELDS = ("3", "a4", "5", "z6", "6")
"""Sizes of welds."""

_SIGNS: tuple[tuple[tuple[tuple[float, float], ...], ...], ...] = (
    (((0, -1.3), (0, 1.3)), ((-1.3, 0), (1.3, 0))),
    (((-1, 1), (0.2, -1)), ((-0.2, 1), (1, -1))),
    (((-1, 1), (1, 1)), ((0, 1), (0, -1))),
    (((-1, 0.5), (0.6, 0.5), (1, -0.5), (-0.6, -0.5), (-1, 0.5)),),
    (((-1, 1), (1, -1)), ((0.3, -1), (1, -1), (1, -0.3))),
    (),
)
"""Lines of the signs of tolerances: position, parallelism, squareness, flatness, run-out, and
concentricity, which is circles only; y down, the sign's half width is 1."""

_ROUND_SIGNS = {0: (1.0,), 5: (1.0, 0.6)}
"""Circles of some of them, by their radii."""


def tolerance_frame(board: Board, at: npt.ArrayLike) -> Points:
    """A feature control frame; (2,) the middle of its left side.

    Args:
        board: to draw with.
        at: (2,) its upper left corner.
    """
    chance = board.chance
    x, y = np.asarray(at, dtype=np.float64)
    height = board.heights(1.7, 2.2)
    letters = chance.randint(0, 3)
    widths = [height, board.heights(2.2, 4.0)]
    widths += [height * chance.uniform(0.8, 1.1) for _ in range(letters)]
    borders = x + np.concatenate([[0.0], np.cumsum(widths)])
    frame = [rectangle(x, y, borders[-1], y + height)]
    frame += [segment((border, y), (border, y + height)) for border in borders[1:-1]]
    board.thin(frame, InkClass.OTHER)
    middle, size = np.array([x + height / 2.0, y + height / 2.0]), 0.28 * height
    kind = chance.randrange(len(_SIGNS))
    sign: list[npt.NDArray[np.floating]] = [
        middle + size * np.array(items, dtype=np.float64) for items in _SIGNS[kind]
    ]
    sign += [circle(middle, size * value) for value in _ROUND_SIGNS.get(kind, ())]
    board.thin(sign, InkClass.OTHER)
    texts = [chance.choice(_TOLERANCES), *(chance.choice("ABCD") for _ in range(letters))]
    for left, right, text in zip(borders[1:], borders[2:], texts, strict=False):
        centre = (left + right) / 2.0, y + height / 2.0
        board.write(text, centre, look=board.look.times(0.85))
    return np.array([x, y + height / 2.0])


def led_tolerance_frame(board: Board, point: Points) -> None:
    """A feature control frame with a leader to a point (2,)."""
    end = tolerance_frame(board, board.near(point, 3.0, 7.0))
    if not board.likely(0.8):
        return
    knee = [(point[0], end[1])] if board.likely(0.4) else []
    board.thin([np.array([point, *knee, end])])
    board.arrow(point, unit(point - end))


def surface_sign(board: Board, at: npt.ArrayLike) -> None:
    """A sign of a surface's roughness, its tip at a point (2,)."""
    tip, size = np.asarray(at, dtype=np.float64), board.heights(0.8, 1.3)
    lines = [tip + size * np.array([(-0.6, -1.0), (0.0, 0.0), (1.1, -2.0)])]
    if board.likely(0.7):
        lines.append(tip + size * np.array([(-0.6, -1.0), (0.55, -1.0)]))
    if board.likely(0.5):
        lines.append(tip + size * np.array([(1.1, -2.0), (3.5, -2.0)]))
    board.thin(lines, InkClass.OTHER)
    place, anchor = board.chance.choice([(-0.6, RIGHT), (1.3, LEFT)])
    text = board.chance.choice(_ROUGHNESSES)
    board.write(text, tip + size * np.array([place, -1.6]), anchor, look=board.look.times(0.8))


def datum(board: Board, at: npt.ArrayLike, way: Points) -> None:
    """A datum's triangle and letter.

    Args:
        board: to draw with.
        at: (2,) on an edge.
        way: (2,) of length 1, away from the edge.
    """
    foot, size = np.asarray(at, dtype=np.float64), 0.55 * board.style.height
    aside, tip = 0.8 * size * across(way), 1.2 * size * way
    triangle = np.array([foot + aside, foot - aside, foot + tip, foot + aside])
    if board.likely(0.2):
        triangle = np.array([foot, foot + tip + aside, foot + tip - aside, foot])
    if board.likely(0.7):
        board.canvas.fill(triangle, InkClass.OTHER, board.style.darkness.dimension)
    else:
        board.thin([triangle], InkClass.OTHER)
    end = foot + way * (size + board.heights(0.8, 3.0))
    half = 0.9 * board.style.height
    centre = end + way * half
    frame = rectangle(*(centre - half), *(centre + half))
    board.thin([segment(foot + way * size, end), frame], InkClass.OTHER)
    board.write(board.chance.choice("ABCDE"), centre)


def weld(board: Board, at: npt.ArrayLike) -> None:
    """The sign of a weld, led to a point (2,)."""
    tip, height = np.asarray(at, dtype=np.float64), board.style.height
    knee = board.near(tip, 2.0, 6.0)
    if norm(tip - knee) < 4.0:
        return
    sign = 1.0 if knee[0] >= tip[0] else -1.0
    end = shifted(knee, sign * board.heights(3.0, 7.0), 0.0)
    board.arrow(tip, unit(tip - knee))
    board.thin([np.array([tip, knee, end])])
    if board.likely(0.4):
        fork = 0.7 * height * np.array([(sign, -1.0), (0.0, 0.0), (sign, 1.0)])
        board.thin([end + fork])
    if board.likely(0.3):
        board.thin(dashed(segment(shifted(knee, 0.0, 4.0), shifted(end, 0.0, 4.0)), (8.0, 4.0)))
    middle, size = (knee + end) / 2.0, 0.6 * height
    down = board.chance.choice([-1.0, 1.0])
    fillet = [((-1.0, 0.0), (-1.0, 1.6 * down), (0.7, 0.0))]
    groove = [((-1.0, 1.5 * down), (0.0, 0.0), (1.0, 1.5 * down))]
    square = [((value, 0.0), (value, 1.5 * down)) for value in (-0.3, 0.3)]
    every: list[Sequence[Sequence[tuple[float, float]]]] = [fillet, fillet, groove, square]
    lines = board.chance.choice(every)
    board.thin([middle + size * np.array(line) for line in lines], InkClass.OTHER)
    at_text = middle + size * np.array([-2.2, down])
    board.write(board.chance.choice(_WELDS), at_text, look=board.look.times(0.9))
    if board.likely(0.25):
        board.thin([circle(knee, 0.6 * size)], InkClass.OTHER)


def cutting_line(board: Board, view: SheetView) -> None:
    """Where a section is cut: a line through a view, thick at its ends, with arrows."""
    chance, style = board.chance, board.style
    x0, y0, x1, y1 = view.box
    over, axis = board.heights(1.0, 3.0), chance.randrange(2)
    share = chance.uniform(0.3, 0.7) if board.likely(0.5) else 0.5
    if axis == 0:
        level = y0 + share * (y1 - y0)
        ends = segment((x0 - over, level), (x1 + over, level))
    else:
        place = x0 + share * (x1 - x0)
        ends = segment((place, y0 - over), (place, y1 + over))
    along = unit(ends[1] - ends[0])
    way = across(along) * chance.choice([-1, 1])
    line = ends
    if axis == 0 and board.likely(0.15):
        step = np.array([0.0, chance.uniform(10.0, 60.0)])
        middle = ends.mean(axis=0)
        line = np.array([ends[0], middle, middle + step, ends[1] + step])
        ends = segment(line[0], line[-1])
    width = style.widths.visible * chance.choice([style.widths.thin / style.widths.visible, 1, 1.4])
    kind = chance.random()
    if kind < 0.5:
        pattern = chance.choice([style.dashes.phantom, style.dashes.centre])
        pieces = dashed(line, pattern)
        board.thin(pieces, InkClass.OTHER, min(width, style.widths.visible))
    elif kind < 0.65:
        board.thin([line], InkClass.OTHER)
    thick = max(width, style.widths.visible)
    tail = along * board.heights(0.8, 1.8)
    strong = [segment(ends[0], ends[0] + tail), segment(ends[1], ends[1] - tail)]
    board.canvas.lines(strong, InkClass.OTHER, thick, style.darkness.visible)
    letter, look = chance.choice("ABCDE"), board.look.times(chance.uniform(1.0, 1.6))
    for end in ends:
        tip = end + way * board.heights(1.6, 2.2)
        if board.likely(0.5):
            board.thin([segment(end, tip)], InkClass.OTHER)
            board.arrow(tip, way, InkClass.OTHER, size=1.5)
        else:
            board.thin([segment(end - way * 2.0 * style.height, end)], InkClass.OTHER)
            board.arrow(end, way, InkClass.OTHER, size=1.5)
        board.write(letter, tip + way * look.height, look=look)
