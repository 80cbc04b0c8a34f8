"""Drawings beside the views: a picture of the part, an enlarged detail."""

from collections.abc import Sequence

import cv2
import numpy as np

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.board import Board
from learning.sheets.chains_of_points import (
    Points,
    circle,
    dashed,
    segment,
    shifted,
    within_circle,
)
from learning.sheets.dimension_marks import dimension_line
from learning.sheets.view_variants import SheetView
from learning.sheets.wording import number
from learning.training_parts import DrawnPart

_CLEARANCE_PX, _TRIES = 20.0, 25
"""px from views at least, and places that are tried."""

_BORDER = 0.06
"""Share of the sheet's width that pictures leave free at its borders."""

_DETAILS = ("DETAIL {} (2:1)", "{} ( 4 : 1 )", "DETAIL {}", "DETAIL {} SCALE 2:1", "{}")
"""What stands under details."""


def draw_picture(board: Board, part: DrawnPart, views: Sequence[SheetView]) -> None:
    """The part in isometric projection: its lines, shaded, or both."""
    chance, canvas, style = board.chance, board.canvas, board.style
    flat = [chain * (1.0, -1.0) for chain in part.picture]
    points = np.concatenate(flat)
    low, extent = points.min(axis=0), np.ptp(points, axis=0)
    side = chance.uniform(0.15, 0.35) * min(canvas.width, canvas.height)
    scale = side / max(float(extent.max()), 1e-3)
    corner = _free_place(board, extent * scale, views)
    if corner is None:
        return
    chains = [(chain - low) * scale + corner for chain in flat]
    kind = chance.random()
    if kind < 0.5:
        points = np.concatenate(chains).astype(np.float32)
        hull = np.asarray(cv2.convexHull(points)[:, 0], dtype=np.float32)
        canvas.tint(hull, *(chance.uniform(15.0, 140.0) for _ in range(2)))
    if kind > 0.15:
        width = chance.choice([style.widths.visible, style.widths.thin, 0.7 * style.widths.visible])
        darkness = style.darkness
        index = chance.choice([darkness.visible, darkness.visible, darkness.dimension])
        canvas.lines(chains, InkClass.PICTORIAL, width, index)
    if board.likely(0.1):
        dimension_line(board, corner, corner + extent * scale * (0.5, 0.3), number(chance))


def draw_detail(board: Board, view: SheetView, views: Sequence[SheetView]) -> None:
    """A circle around some place of a view, and what is in it once more, larger."""
    chance, canvas, style = board.chance, board.canvas, board.style
    centre, radius = chance.choice(view.points).astype(np.float64), chance.uniform(25.0, 90.0)
    ring = circle(centre, radius)
    around = dashed(ring, style.dashes.centre) if board.likely(0.4) else [ring]
    board.thin(around, InkClass.OTHER)
    letter, look = chance.choice("ABCDEZ"), board.look.times(1.2)
    at = centre + np.array([1.0, -1.0]) * (0.75 * radius + style.height)
    board.write(letter, at, look=look)
    factor = chance.uniform(1.6, 4.0)
    large = factor * radius
    if large > 0.3 * min(canvas.width, canvas.height):
        return
    corner = _free_place(board, np.array([2.0 * large, 2.0 * large]), views, anywhere=True)
    if corner is None:
        return
    place = corner + large
    for chain in view.lines.visible:
        pieces = within_circle(chain, centre, radius)
        enlarged = [(piece - centre) * factor + place for piece in pieces]
        canvas.lines(enlarged, InkClass.PICTORIAL, style.widths.visible, style.darkness.visible)
    if board.likely(0.7):
        width = chance.choice([style.widths.thin, style.widths.thin, style.widths.visible])
        board.thin([circle(place, large)], InkClass.OTHER, width)
    text = chance.choice(_DETAILS).format(letter)
    board.write(text, shifted(place, 0.0, large + 1.8 * style.height), look=look)
    if board.likely(0.5):
        start, end = place + large * segment((-0.4, 0.5), (0.3, 0.5))
        dimension_line(board, start, end, number(chance))


def _free_place(
    board: Board, size: Points, views: Sequence[SheetView], *, anywhere: bool = False
) -> Points | None:
    """(2,) the upper left corner of a box between the views, or none.

    Args:
        board: to draw with.
        size: (2,) px of the box.
        views: that it keeps clear of.
        anywhere: whether to look elsewhere than in the sheet's corners first.
    """
    chance, canvas = board.chance, board.canvas
    border = _BORDER * canvas.width
    first = np.array([border, border])
    last = np.maximum(np.array([canvas.width, canvas.height]) - border - size, first + 1.0)
    for attempt in range(_TRIES):
        share = np.array([chance.random(), chance.random()])
        if attempt == 0 and not anywhere:
            share = np.rint(share)
        corner = first + share * (last - first)
        if all(_apart(corner, corner + size, view) for view in views):
            return corner
    # Now and then it stands over a view.
    return corner if not anywhere and board.likely(0.15) else None


def _apart(low: Points, high: Points, view: SheetView) -> bool:
    box = np.array(view.box).reshape(2, 2)
    return bool(((high < box[0] - _CLEARANCE_PX) | (low > box[1] + _CLEARANCE_PX)).any())
