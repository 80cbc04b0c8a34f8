"""Cutting lines in steps: from one end along lines at right angles to the other (ISO 128-3)."""

from collections.abc import Sequence
from math import hypot

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.picture_noise import LEVEL, OVERRUN
from gaussiancad_core.writing.leaders import Lines

_GAP = 60.0
"""px between dashes of a line at most."""

_MOST = 12
"""Steps of a cutting line at most."""

Place = tuple[float, float]


def stepped_path(ends: tuple[Place, Place], way: Place, lines: Lines) -> tuple[Place, ...]:
    """The corners of a cutting line; nothing where its steps are not found.

    Args:
        ends: of the line, px.
        way: of its arrows, of length 1: the line runs square to it, and in steps along it.
        lines: straight ones of the sheet, px, dashes as well.
    """
    along = np.array([-way[1], way[0]])
    across = np.array(way)
    start, goal = (np.array([values @ along, values @ across]) for values in map(np.array, ends))
    turned = start[0] > goal[0]
    if turned:
        start, goal = goal, start
    flat, steep = _sorted(lines, along, across)
    corners = [start]
    at, level = float(start[0]), float(start[1])
    for _ in range(_MOST):
        reach = _led(flat, level, at)
        if abs(level - goal[1]) <= OVERRUN and reach >= goal[0] - _GAP:
            corners.append(goal)
            path = [corner[0] * along + corner[1] * across for corner in corners]
            path = path[::-1] if turned else path
            return tuple((float(x), float(y)) for x, y in path)
        step = _step(steep, flat, level, (at, min(reach, float(goal[0]))))
        if step is None:
            return ()
        at, new = step
        corners += [np.array([at, level]), np.array([at, new])]
        level = new
    return ()


Spans = npt.NDArray[np.float64]
"""(n, 3): where a line lies, from where and to where it runs."""


def _sorted(lines: Lines, along: np.ndarray, across: np.ndarray) -> tuple[Spans, Spans]:
    """Lines that run along a cutting line, and those that run square to it."""
    flat, steep = [], []
    for start, end in lines:
        (a, b), (c, d) = ((item @ along, item @ across) for item in (start, end))
        length = hypot(c - a, d - b)
        if abs(d - b) <= LEVEL * length:
            flat.append(((b + d) / 2.0, *sorted((a, c))))
        elif abs(c - a) <= LEVEL * length:
            steep.append(((a + c) / 2.0, *sorted((b, d))))
    return _joined(flat), _joined(steep)


def _joined(pieces: Sequence[tuple[float, float, float]]) -> Spans:
    """Dashes of one line as one: gaps are no longer than the longer dash beside them."""
    found: list[list[float]] = []
    for at, low, high in sorted(pieces, key=lambda piece: piece[1]):
        for items in found:
            gap = min(_GAP, max(items[3], high - low))
            if abs(items[0] - at) <= OVERRUN and low <= items[2] + gap:
                items[2], items[3] = max(items[2], high), max(items[3], high - low)
                break
        else:
            found.append([at, low, high, high - low])
    return np.array(found).reshape(-1, 4)[:, :3]


def _led(spans: Spans, level: float, start: float) -> float:
    """How far dashes at a level lead from a place on."""
    span = spans[np.abs(spans[:, 0] - level) <= OVERRUN]
    reach = start
    for _, low, high in span[np.argsort(span[:, 1])].tolist():
        if low <= reach + _GAP and high > reach:
            reach = high
    return reach


def _step(
    steep: Spans, flat: Spans, level: float, between: tuple[float, float]
) -> tuple[float, float] | None:
    """The last place of a level at which a line leads to another level that goes on, and that."""
    found = []
    for at, low, high in steep.tolist():
        if not between[0] + OVERRUN < at <= between[1] + _GAP:
            continue
        for near, far in ((low, high), (high, low)):
            if abs(near - level) <= _GAP and abs(far - level) > OVERRUN:
                levels = flat[(flat[:, 1] <= at + _GAP) & (flat[:, 2] > at + OVERRUN)][:, 0]
                levels = levels[np.abs(levels - far) <= _GAP]
                levels = levels[np.abs(levels - level) > OVERRUN]
                if len(levels):
                    found.append((at, float(levels[np.argmin(np.abs(levels - far))])))
    return max(found, default=None)
