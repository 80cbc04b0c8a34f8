"""Pieces of ink in which the dashes of hidden edges meet square to each other, as in a pocket.

Two dashes make an L, three a U.  Where the edges are too short for dashes beside these, nothing
else tells that they are dashed: an L is a letter, too, and by itself a dash is as narrow as an
extension line.  But each edge goes on a gap farther, or ends there at another one.
"""

import numpy as np
import numpy.typing as npt

_ALONG = 0.85
"""Share of the ink that lies along two or three sides of its box at least."""

_COVERED = 0.8
"""Share of each of these sides that is inked at least."""

_SLIM = 3
"""Length of these sides at least, in what counts as their depth: digits have ink in between."""

_SLACK_PX = 2.0
"""px by which a gap may be wider."""


def is_dash_corner(
    labels: npt.NDArray[np.int32],
    stat: npt.NDArray[np.int32],
    piece: int,
    stroke_width: float,
    gap: float,
) -> bool:
    """Whether a piece of ink is two or three dashes that meet in corners, square to the sheet.

    Args:
        labels: (h, w) numbers of the pieces of ink.
        stat: (4 at least,) x, y, width, height in px of the piece.
        piece: its number.
        stroke_width: px.
        gap: px from where its ends are to the next ink at most.
    """
    x, y, width, height = (int(value) for value in stat[:4])
    side = int(np.ceil(stroke_width + 1.0))
    if min(width, height) < _SLIM * side:
        return False
    reach = int(np.ceil(gap + _SLACK_PX))
    rows = slice(max(y - reach, 0), y + height + reach)
    columns = slice(max(x - reach, 0), x + width + reach)
    before = max(reach - y, 0), max(reach - x, 0)
    window = labels[rows, columns]
    after = (
        height + 2 * reach - window.shape[0] - before[0],
        width + 2 * reach - window.shape[1] - before[1],
    )
    window = np.pad(window, tuple(zip(before, after, strict=True)))
    own, others = window == piece, (window != 0) & (window != piece)
    return any(
        _is_open(np.rot90(own, turn), np.rot90(others, turn), reach, side) for turn in range(4)
    )


def _is_open(
    own: npt.NDArray[np.bool_], others: npt.NDArray[np.bool_], reach: int, side: int
) -> bool:
    """Whether a piece is an L with its corner at the upper left, or a U that is open below, and
    other ink is ahead of both of its ends.

    Args:
        own, others: (h, w) bool, its ink and other ink, up to ``reach`` px around its box.
        reach, side: px, also the depth of a side.
    """
    box = own[reach:-reach, reach:-reach]
    legs = np.zeros_like(box)
    legs[:side] = legs[:, :side] = True
    if min(_covered(box[:side], 0), _covered(box[:, :side], 1)) < _COVERED:
        return False
    below = others[-reach:, reach : reach + side].any()
    if _covered(box[:, -side:], 1) >= _COVERED:
        legs[:, -side:] = True
        ahead = below and others[-reach:, -reach - side : -reach].any()
    else:
        ahead = below and others[reach : reach + side, -reach:].any()
    return bool(ahead) and bool(box[legs].sum() >= _ALONG * box.sum())


def _covered(strip: npt.NDArray[np.bool_], across: int) -> float:
    """Share of a strip's length in which there is ink."""
    return float(strip.any(axis=across).mean())
