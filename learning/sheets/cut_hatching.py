"""Cut material: parallel lines across areas, in many ways, or grey."""

import math
from enum import Enum, auto

import numpy as np

from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import Board
from learning.sheets.chains_of_points import Points, dashed
from learning.sheets.view_variants import SheetView
from learning.training_parts import Chain

_ANGLES_DEG = (45, 45, 45, 45, -45, -45, 135, 30, 60, 0, 90, 15, 75)
"""Of the lines, the usual ones more often."""

_MOST_LINES = 900
"""Across an area."""

_SHORTEST_PX = 0.8
"""px of a line at least."""


class Hatching(Enum):
    """How cut material is shown."""

    PLAIN = auto()
    FILLED = auto()
    GREY = auto()
    CROSSED = auto()
    TWICE = auto()
    PAIRED = auto()
    DASHED = auto()


_ODDS = (0.68, 0.02, 0.06, 0.06, 0.06, 0.06, 0.06)
"""Shares of the sections that are hatched in each way."""

_LEVELS = {Hatching.FILLED: 230.0, Hatching.GREY: 60.0}
"""Darkness of areas without lines."""


def hatch(board: Board, view: SheetView) -> None:
    """Hatch the areas of a section."""
    chance, style = board.chance, board.style
    if not view.lines.areas:
        return
    degrees = chance.choice([*_ANGLES_DEG, chance.uniform(0.0, 180.0)])
    pitch = max(style.widths.thin * chance.uniform(2.2, 8.0), 3.2)
    if board.likely(0.25):
        pitch = chance.uniform(12.0, 45.0)
    width = style.widths.thin if board.likely(0.85) else style.widths.visible
    kind = chance.choices(tuple(Hatching), _ODDS)[0]
    for area in view.lines.areas:
        if kind in _LEVELS:
            board.canvas.tint(area[0], _LEVELS[kind], _LEVELS[kind])
            continue
        if board.likely(0.12):
            degrees += 90.0
        pair = pitch * chance.uniform(0.2, 0.4) if kind is Hatching.PAIRED else 0.0
        start = chance.uniform(0.2, 1.0)
        lines = hatch_lines(area, degrees, (pitch, start * pitch), pair)
        if kind is Hatching.DASHED:
            pattern = chance.choice([style.dashes.centre, style.dashes.hidden])
            lines = [
                dash for line in lines for dash in dashed(line, pattern, chance.uniform(0.0, 30.0))
            ]
        if kind is Hatching.CROSSED:
            lines += hatch_lines(area, degrees + 90.0, (pitch, start * pitch))
        if kind is Hatching.TWICE:
            between = hatch_lines(area, degrees, (pitch, (start - 0.5) % 1.0 * pitch))
            lines += [dash for values in between for dash in dashed(values, style.dashes.hidden)]
        board.canvas.lines(lines, InkClass.HATCHING, width, style.darkness.hatching)
        if view.section is SectionKind.BROKEN_OUT:
            board.thin(area[:1], InkClass.OTHER)


def hatch_lines(
    area: tuple[Chain, ...], degrees: float, pitch: tuple[float, float], pair: float = 0.0
) -> list[Points]:
    """Lines across an area, each (2, 2).

    Args:
        area: closed rings, the outer one first.
        degrees: of the lines.
        pitch: px from line to line, and from the area's border to the first one.
        pair: px from each line to a second one; 0, there is none.
    """
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    turn = np.array([[cosine, sine], [-sine, cosine]])
    rings = [ring @ turn.T for ring in area]
    starts = np.concatenate([ring[:-1] for ring in rings])
    ends = np.concatenate([ring[1:] for ring in rings])
    heights = np.arange(starts[:, 1].min() + pitch[1], starts[:, 1].max(), pitch[0])[:_MOST_LINES]
    if pair:
        heights = np.sort(np.concatenate([heights, heights + pair]))
    lines = []
    for height in heights:
        crossed = (starts[:, 1] <= height) != (ends[:, 1] <= height)
        first, last = starts[crossed], ends[crossed]
        share = (height - first[:, 1]) / (last[:, 1] - first[:, 1])
        places = np.sort(first[:, 0] + share * (last[:, 0] - first[:, 0]))
        for left, right in zip(places[0::2], places[1::2], strict=False):
            if right - left > _SHORTEST_PX:
                lines.append(np.array([[left, height], [right, height]]) @ turn)
    return lines
