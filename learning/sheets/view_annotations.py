"""What is written and drawn at a view beside its lines."""

import numpy as np

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import Board
from learning.sheets.centre_marks import centre_lines
from learning.sheets.chains_of_points import (
    Points,
    across,
    arc,
    dashed,
    norm,
    rectangle,
)
from learning.sheets.leader_marks import balloon, leader
from learning.sheets.symbols import (
    datum,
    led_tolerance_frame,
    surface_sign,
    weld,
)
from learning.sheets.view_dimensions import (
    Levels,
    aligned,
    angle,
    linear,
    round_edge,
    whole_extent,
)
from learning.sheets.view_variants import SheetView
from learning.sheets.wording import note
from learning.training_parts import Circle

_DENSITIES = (0.0, 0.4, 1.0, 1.0, 1.6, 2.4)
"""How much is written at a view, 1 as usual."""

_SMALLEST_PX = 4.0
"""Radius of a circle that is measured."""

_THREADS = (1.12, 1.2, 0.85, 0.8)
"""Radius of a thread's thin circle in that of the hole or the shaft."""

_THREAD_SWEEP = 4.7
"""Radians, about three quarters."""

_SHORTEST_PX = 20.0
"""Edge that is a datum."""


def annotate(board: Board, view: SheetView) -> None:
    """Centre lines, dimensions, leaders, symbols of a view, many or few."""
    chance = board.chance
    density = chance.choice(_DENSITIES)
    if density == 0.0 and board.likely(0.5):
        return
    if board.likely(0.16):
        for axis in (0, 1):
            if board.likely(0.75):
                whole_extent(board, view, axis)
        return
    if board.likely(0.75):
        centre_lines(board, view)
    levels: Levels = {}
    for _ in range(int(chance.randint(2, 7) * density)):
        linear(board, view, levels)
    if board.likely(0.4 * min(1.0, density)):
        aligned(board, view)
    _measure_circles(board, view, density)
    if len(view.segments) > 2:
        _draw_symbols(board, view, density)


def _measure_circles(board: Board, view: SheetView, density: float) -> None:
    chance = board.chance
    circles = [
        this_circle
        for this_circle in view.lines.circles
        if not this_circle.hidden and this_circle.radius > _SMALLEST_PX
    ]
    if not circles:
        return
    for _ in range(int(chance.randint(0, 4) * density)):
        circle = chance.choice(circles)
        round_edge(board, circle)
        if circle.sweep > 5.0 and board.likely(0.12):
            _draw_thread(board, circle)


def _draw_thread(board: Board, circle: Circle) -> None:
    """Three quarters of a thin circle."""
    chance, widths = board.chance, board.style.widths
    radius = circle.radius * chance.choice(_THREADS)
    curve = arc(circle.centre, radius, chance.uniform(0.0, 6.3), _THREAD_SWEEP)
    darkness = board.style.darkness
    board.thin(
        [curve],
        InkClass.THIN,
        chance.choice([widths.thin, widths.thin, 0.5 * widths.visible]),
        chance.choice([darkness.visible, darkness.dimension]),
    )


def _draw_symbols(board: Board, view: SheetView, density: float) -> None:
    chance = board.chance
    for _ in range(int(chance.randint(0, 2) * density)):
        tip = _corner(board, view) if board.likely(0.5) else _edge_point(board, view)
        leader(board, tip, board.near(tip), [note(chance) for _ in range(chance.randint(1, 2))])
    if board.likely(0.1 * density):
        weld(board, _corner(board, view))
    if board.likely(0.15 * density):
        for _ in range(chance.randint(1, 4)):
            balloon(board, _corner(board, view))
    if board.likely(0.25 * density):
        led_tolerance_frame(board, _corner(board, view))
    if board.likely(0.25 * density):
        surface_sign(board, _edge_point(board, view))
    if board.likely(0.2 * density):
        _draw_datum(board, view)
    if board.likely(0.35 * density):
        angle(board, view)
    if board.likely(0.06):
        _draw_neighbour(board, view)


def _corner(board: Board, view: SheetView) -> Points:
    return board.chance.choice(view.points).astype(np.float64)


def _edge_point(board: Board, view: SheetView) -> Points:
    """(2,) on some straight edge."""
    start, end = board.chance.choice(view.segments).astype(np.float64)
    return start + (end - start) * board.chance.random()


def _draw_datum(board: Board, view: SheetView) -> None:
    start, end = board.chance.choice(view.segments).astype(np.float64)
    long = norm(end - start)
    if long > _SHORTEST_PX:
        way = across(end - start) / long * board.chance.choice([-1, 1])
        datum(board, start + (end - start) * board.chance.uniform(0.2, 0.8), way)


def _draw_neighbour(board: Board, view: SheetView) -> None:
    """A part beside it, in phantom."""
    x, y = _corner(board, view)
    width, height = (board.chance.uniform(40.0, 200.0) for _ in range(2))
    ring = rectangle(x, y, x + width, y + height)
    board.thin(dashed(ring, board.style.dashes.phantom), InkClass.OTHER)
