"""Centre lines: crosses of circles, axes of views and features, circles of bolts, bend lines."""

import math
from collections.abc import Iterator
from enum import Enum, auto

import numpy as np

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import Board
from learning.sheets.chains_of_points import Points, across, arc, length, segment
from learning.sheets.random_style import ENDLESS
from learning.sheets.view_variants import SheetView
from learning.training_parts import Circle

_SMALLEST_PX = 3.0
"""Radius of a circle that is given a cross."""

_BENDS = ("UP 90° R{}", "DOWN 90° R {}", "BEND {}", "UP {}°", "90° R{}")
"""What stands at bend lines."""


class Cross(Enum):
    """How the middle of a circle is marked."""

    LONG = auto()
    SMALL = auto()
    ARMS = auto()


def centre_lines(board: Board, view: SheetView) -> None:
    """Centre lines of a view."""
    chance = board.chance
    cross = chance.choices(tuple(Cross), (2, 1, 1))[0]
    over = board.style.widths.visible * chance.uniform(1.5, 7.0)
    least_sweep = chance.choice([1.4, 3.0, 6.0])
    for circle in _to_mark(board, view, least_sweep):
        _mark(board, circle, cross, over)
    if board.likely(0.5):
        _draw_axes(board, view, over)
    elif len(view.points) > 3:
        for _ in range(chance.randint(0, 3)):
            _draw_chance_axis(board, view)
    _draw_bolt_circle(board, view)


def bend_lines(board: Board, view: SheetView) -> None:
    """Lines along which a flat pattern is bent."""
    chance, style = board.chance, board.style
    axis = chance.randrange(2)
    dashes = style.dashes
    pattern = chance.choice([dashes.centre, dashes.phantom, ENDLESS, dashes.hidden])
    for _ in range(chance.randint(1, 5)):
        at = chance.uniform(view.box[axis], view.box[axis + 2])
        ends = sorted(_crossings(view, axis, at))
        if len(ends) < 2:
            continue
        line = np.array([[at, ends[0]], [at, ends[-1]]])
        line = line if axis == 0 else line[:, ::-1]
        pen = style.widths.centre, style.darkness.centre
        board.dashes(line, pattern, 0.0, InkClass.CENTRE, pen)
        if board.likely(0.7):
            aside = (style.height, 0.0) if axis == 0 else (0.0, -style.height)
            text = chance.choice(_BENDS).format(chance.randint(1, 9))
            look = board.look.times(chance.uniform(0.6, 1.0))
            board.write(text, line.mean(axis=0) + aside, degrees=90.0 * (1 - axis), look=look)


def draw_chained(board: Board, chain: Points) -> None:
    """A centre line, mostly with its long dashes at both ends."""
    style = board.style
    pattern = style.dashes.centre
    period = sum(pattern)
    phase = (pattern[0] - (length(chain) % period) / 2.0) % period
    if board.likely(0.4):
        phase = board.chance.uniform(0.0, period)
    pen = style.widths.centre, style.darkness.centre
    board.dashes(chain, pattern, phase, InkClass.CENTRE, pen)


def _draw_plain(board: Board, chain: Points) -> None:
    style = board.style
    board.canvas.lines([chain], InkClass.CENTRE, style.widths.centre, style.darkness.centre)


def _to_mark(board: Board, view: SheetView, least_sweep: float) -> Iterator[Circle]:
    """One circle around each centre, the outermost one."""
    done = set()
    for circle in view.lines.circles:
        hidden = circle.hidden and board.likely(0.5)
        if hidden or circle.sweep < least_sweep or circle.radius < _SMALLEST_PX:
            continue
        key = tuple(round(value) for value in circle.centre)
        if key in done:
            continue
        done.add(key)
        around = [
            this_circle
            for this_circle in view.lines.circles
            if math.dist(this_circle.centre, circle.centre) < 1.0
        ]
        yield max(
            around, key=lambda this_circle: this_circle.radius if this_circle.sweep > 3.0 else 0.0
        )


def _mark(board: Board, circle: Circle, cross: Cross, over: float) -> None:
    centre, radius = np.array(circle.centre), circle.radius
    visible = board.style.widths.visible
    turn = 0.0 if board.likely(0.9) else board.chance.uniform(0.0, 1.5)
    small = min(0.5 * radius, visible * board.chance.uniform(2.0, 4.0))
    first = np.array([math.cos(turn), math.sin(turn)])
    for way in (first, across(first)):
        reach = way * (radius + over)
        if cross is Cross.SMALL:
            _draw_plain(board, segment(centre - way * small, centre + way * small))
        elif cross is Cross.ARMS:
            inner = way * min(0.3 * radius, 2.5 * visible)
            _draw_plain(board, segment(centre - inner, centre + inner))
            for sign in (-1, 1):
                _draw_plain(board, segment(centre + sign * 2.0 * inner, centre + sign * reach))
        elif radius < 0.8 * board.style.dashes.centre[0] and board.likely(0.5):
            _draw_plain(board, segment(centre - reach, centre + reach))
        else:
            draw_chained(board, segment(centre - reach, centre + reach))


def _draw_axes(board: Board, view: SheetView, over: float) -> None:
    """Axes of the whole view, through its middle or that of some circle."""
    x0, y0, x1, y1 = view.box
    for axis in (0, 1):
        if not board.likely(0.45):
            continue
        at = (view.box[axis] + view.box[axis + 2]) / 2.0
        if view.lines.circles and board.likely(0.6):
            at = board.chance.choice(view.lines.circles).centre[axis]
        line = segment((at, y0 - over), (at, y1 + over))
        draw_chained(board, line if axis == 0 else segment((x0 - over, at), (x1 + over, at)))


def _draw_chance_axis(board: Board, view: SheetView) -> None:
    """The axis of some feature: half-way between two corners."""
    chance = board.chance
    middle = (chance.choice(view.points) + chance.choice(view.points)) / 2.0
    reach = np.array([chance.uniform(15.0, 120.0), 0.0])
    reach = reach if board.likely(0.5) else reach[::-1]
    draw_chained(board, segment(middle - reach, middle + reach))


def _draw_bolt_circle(board: Board, view: SheetView) -> None:
    """A circle around one hole, through another one."""
    chance = board.chance
    whole = [circle for circle in view.lines.circles if circle.sweep > 6.0 and not circle.hidden]
    if not whole or not board.likely(0.35 if len(whole) >= 3 else 0.1):
        return
    one, other = chance.choice(whole), chance.choice(whole)
    radius = math.dist(one.centre, other.centre)
    if radius < 12.0:
        radius = chance.uniform(0.6, 1.5) * one.radius + 10.0
    draw_chained(board, arc(one.centre, radius, chance.uniform(0.0, 6.0), 2.0 * math.pi))


def _crossings(view: SheetView, axis: int, at: float) -> Iterator[float]:
    """Where visible lines cross a border, along it."""
    for chain in view.lines.visible:
        over = chain[:, axis] - at
        for place in np.flatnonzero((over[:-1] >= 0.0) != (over[1:] >= 0.0)):
            share = over[place] / (over[place] - over[place + 1])
            step = chain[place + 1, 1 - axis] - chain[place, 1 - axis]
            yield float(chain[place, 1 - axis] + share * step)
