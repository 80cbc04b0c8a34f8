"""Dimensions of views: linear, in chains, from one edge on, aligned, angles, circles."""

import math
from itertools import pairwise

import numpy as np

from learning.sheets.board import FOOT, LEFT, RIGHT, TOP, Board
from learning.sheets.chains_of_points import (
    Points,
    across,
    arc,
    norm,
    segment,
    shifted,
    unit,
)
from learning.sheets.dimension_marks import dimension_line, extension_line
from learning.sheets.leader_marks import leader
from learning.sheets.view_variants import SheetView
from learning.sheets.wording import note, number
from learning.training_parts import Circle

Levels = dict[tuple[int, int], float]
"""px from a view's border, of the outermost dimension line along an axis at a side of it."""

_TRIES = 8
"""Times that edges are chosen to measure between."""

_NARROWEST_PX = 5.0
"""Between two edges that are measured."""

_FULL_SWEEP = 5.0
"""Radians from which an arc is measured as a circle is."""

_SLANTED_PX = (15.0, 4.0)
"""Length of an edge that is measured along itself, and how far it is from level or upright."""


def linear(board: Board, view: SheetView, levels: Levels) -> None:
    """One to five dimensions along an axis, or coordinates from one edge on.

    Args:
        board: to draw with.
        view: whose edges are measured.
        levels: is brought up to date.
    """
    chance, box = board.chance, view.box
    axis, side, within = chance.randrange(2), chance.randrange(2), board.likely(0.12)
    key = axis, side
    away = levels.get(key, 0.0) + board.heights(1.6, 3.2)
    low, high = box[1 - axis], box[3 - axis]
    level = high + away if side else low - away
    if within:
        level = chance.uniform(low, high)
    else:
        levels[key] = away
    kind = chance.random()
    edges = _edges(board, view, axis, 2 if kind < 0.72 else chance.randint(3, 6))
    if edges is None:
        return
    if kind > 0.93:
        _coordinates(board, edges, axis, (side, level))
        return
    for edge in edges:
        if not within or board.likely(0.7):
            extension_line(board, edge, _at(axis, edge[axis], level))
    for first, second in pairwise(edges):
        text = ("⌀" if board.likely(0.12) else "") + number(chance)
        start, end = (_at(axis, values[axis], level) for values in (first, second))
        dimension_line(board, start, end, text)


def whole_extent(board: Board, view: SheetView, axis: int) -> None:
    """The whole of a view along an axis."""
    first = min(view.points, key=lambda point: point[axis])
    last = max(view.points, key=lambda point: point[axis])
    away, box = board.heights(0.8, 2.2), view.box
    level = box[1 - axis] - away if board.likely(0.35) else box[3 - axis] + away
    for end in (first, last):
        points = [point for point in view.points if abs(point[axis] - end[axis]) < 1.0]
        nearest = min(points, key=lambda values: abs(values[1 - axis] - level))
        extension_line(board, nearest, _at(axis, end[axis], level))
    start, end = (_at(axis, values[axis], level) for values in (first, last))
    dimension_line(board, start, end, number(board.chance))


def aligned(board: Board, view: SheetView) -> None:
    """A slanted edge along itself."""
    length, slant = _SLANTED_PX
    slanted = [
        segment
        for segment in view.segments
        if norm(segment[1] - segment[0]) > length and np.abs(segment[1] - segment[0]).min() > slant
    ]
    if not slanted:
        return
    start, end = board.chance.choice(slanted)
    aside = unit(across(end - start)) * board.chance.choice([-1, 1]) * board.heights(1.2, 4.0)
    for item in (start, end):
        extension_line(board, item, item + aside)
    dimension_line(board, start + aside, end + aside, number(board.chance))


def angle(board: Board, view: SheetView) -> None:
    """An angle at the end of some edge."""
    chance = board.chance
    centre, other = board.chance.choice(view.segments).astype(np.float64)
    start = math.atan2(*(other - centre)[::-1])
    degrees = chance.choice([30, 45, 60, 90, 120, chance.uniform(15.0, 140.0)])
    radius = chance.uniform(30.0, 140.0)
    curve = arc(centre, radius, start, math.radians(degrees) * chance.choice([-1, 1]))
    board.thin([curve])
    board.arrow(curve[0], unit(curve[0] - curve[1]))
    board.arrow(curve[-1], unit(curve[-1] - curve[-2]))
    side = curve[-1] - centre
    board.thin([segment(centre + 0.15 * side, centre + 1.08 * side)])
    middle = curve[len(curve) // 2]
    at = middle + unit(middle - centre) * 1.2 * board.style.height
    board.write(f"{chance.randint(10, 150)}°", at)


def round_edge(board: Board, circle: Circle) -> None:
    """The diameter or the radius of a circle, on it or beside it."""
    chance, style = board.chance, board.style
    centre, radius = np.array(circle.centre), circle.radius
    full = circle.sweep > _FULL_SWEEP
    direction = circle.start + chance.uniform(0.15, 0.85) * circle.sweep
    way = np.array([math.cos(direction), math.sin(direction)])
    text = ("⌀" if full else "R") + number(chance)
    share = chance.random()
    if full and share < 0.35 and radius > 1.5 * style.heads.length:
        if board.likely(0.6):
            dimension_line(board, centre - way * radius, centre + way * radius, text)
        else:
            _diameter_led_out(board, centre, way * radius, text)
    elif not full and share < 0.45 and radius > 2.0 * style.heads.length:
        tip = centre + way * radius
        board.thin([segment(centre, tip)])
        board.arrow(tip, way)
        board.write(text, shifted((centre + tip) / 2.0, 0.0, -0.7 * style.height))
    else:
        knee = centre + way * (radius + board.heights(1.5, 8.0))
        if board.likely(0.3):
            knee = centre - way * radius * chance.uniform(0.2, 0.8)
        texts = [text]
        if board.likely(0.5):
            texts = [note(chance) for _ in range(chance.randint(1, 3))]
        leader(board, centre + way * radius, knee, texts)


def _diameter_led_out(board: Board, centre: Points, radius: Points, text: str) -> None:
    """A line across a circle, and on to the number; the radius is a way (2,)."""
    way, height = unit(radius), board.style.height
    far = centre + radius + way * board.heights(2.0, 6.0)
    shelf = np.array([math.copysign(board.heights(1.0, 4.0), way[0]), 0.0])
    board.thin([np.array([centre - radius, far, far + shelf])])
    board.arrow(centre - radius, -way)
    board.arrow(centre + radius, way)
    board.write(text, shifted(far, math.copysign(2.0 * height, way[0]), -0.8 * height))


def _at(axis: int, along: float, level: float) -> Points:
    """(2,) a point of a dimension line."""
    return np.array([along, level] if axis == 0 else [level, along], dtype=np.float64)


def _edges(board: Board, view: SheetView, axis: int, count: int) -> list[Points] | None:
    """Points to measure between, in order along an axis; None where none are far enough apart."""
    if len(view.points) < 2:
        return None
    for _ in range(_TRIES):
        chosen = [board.chance.choice(view.points) for _ in range(count)]
        if board.likely(0.25):
            chosen[0] = min(view.points, key=lambda point: point[axis])
            chosen[1] = max(view.points, key=lambda point: point[axis])
        chosen.sort(key=lambda values: values[axis])
        if np.diff([values[axis] for values in chosen]).min() > _NARROWEST_PX:
            return chosen
    return None


def _coordinates(board: Board, edges: list[Points], axis: int, border: tuple[int, float]) -> None:
    """Numbers at the ends of extension lines, at a side of the view and a level there."""
    side, level = border
    anchors = {(0, 0): FOOT, (0, 1): TOP, (1, 0): RIGHT, (1, 1): LEFT}
    beyond = (board.style.numbers.over + 3.0) * (1 if side else -1)
    for edge in edges:
        extension_line(board, edge, _at(axis, edge[axis], level))
        at = _at(axis, edge[axis], level + beyond)
        degrees = 90.0 if axis == 0 else 0.0
        board.write(number(board.chance), at, anchors[axis, side], degrees)
