"""The pens of a coloured picture, and which of them draws the part.

Ink without colour is one pen, each hue that has much ink another.  The part's pen is the one whose
strokes enclose most: outlines are closed, dimensions, notes and centre lines are not.  Areas that
are filled, such as shaded pictorials, are no strokes at all.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.files.content import PAPER_LEVEL

Grey = npt.NDArray[np.uint8]
"""(h, w)"""

Mask = npt.NDArray[np.bool_]

_INK = 200
"""Grey level up to which a pixel has ink."""

_HUES = 180

_REACH = 8
"""Steps of two degrees by which the hue of a pen's ink may differ from its usual one."""

_LEAST = 0.004
"""Share of the ink that a pen draws at least."""

_BROAD, _WIDEST = 3.0, 0.006
"""Width of a stroke at most, in the usual one and over the sheet's longer side: what is wider than
both is filled."""

_SPANS = 0.8
"""Share of the sheet both ways from which a piece of ink is its frame."""

_PAPER = 255

_CROSSED = 1.5
"""Length over which a line hides another one that it crosses at a slant, in its width."""


@dataclass(frozen=True, eq=False)
class ColourPens:
    """A sheet taken apart by the colours of its ink.

    Attributes:
        part: (h, w) uint8, the sheet with the part's pen alone.
        others: (h, w) uint8, the sheet with all other strokes.
    """

    part: Grey
    others: Grey


def colour_pens(grey: Grey, tint: Grey) -> ColourPens | None:
    """Tell the pens of a sheet apart; None where only one draws.

    Args:
        grey: (h, w) uint8, dark ink on light paper.
        tint: (h, w) uint8, hue + 1 of coloured ink, 0 elsewhere.
    """
    ink = grey <= _INK
    filled = _filled(grey < PAPER_LEVEL)
    strokes = ink & ~filled
    pens = _pens(strokes, tint)
    if len(pens) < 2:
        return None
    whole = [_led_through(pen, strokes & ~pen) for pen in pens]
    own = max(whole, key=_enclosed)
    part = pens[next(at for at, pen in enumerate(whole) if pen is own)]
    other = strokes & ~part
    return ColourPens(
        _alone(grey, own, other | filled), _alone(grey, strokes & ~part, part | filled)
    )


def _filled(covered: Mask) -> Mask:
    """(h, w) what is wider than a stroke, with its border."""
    side = round(max(_BROAD * _width(covered), _WIDEST * max(covered.shape)))
    kernel = np.ones((side, side), np.uint8)
    core = cv2.morphologyEx(covered.astype(np.uint8), cv2.MORPH_OPEN, kernel)
    # Arrowheads are as wide as that in one place only.
    _, labels, stats, _ = cv2.connectedComponentsWithStats(core, connectivity=8)
    large = np.flatnonzero(stats[:, cv2.CC_STAT_AREA] > (4 * side) ** 2)
    core = np.isin(labels, large[large > 0])
    return cv2.dilate(core.astype(np.uint8), kernel) > 0


def _pens(strokes: Mask, tint: Grey) -> list[Mask]:
    """The ink of each pen: without colour first, then by hue, the most used one first."""
    least = _LEAST * strokes.sum()
    plain = strokes & (tint == 0)
    pens = [plain] if plain.sum() > least else []
    counts = np.bincount(tint[strokes & (tint > 0)], minlength=_HUES + 1)[1:].astype(float)
    while counts.sum() > least:
        around = sum(np.roll(counts, step) for step in range(-_REACH // 2, _REACH // 2 + 1))
        usual = int(np.argmax(around))
        reach = ((usual + step) % _HUES for step in range(-_REACH, _REACH + 1))
        near = [hue for hue in reach if counts[hue]]
        if counts[near].sum() <= least:
            break
        pens.append(strokes & np.isin(tint, np.array(near) + 1))
        counts[near] = 0.0
    return pens


def _enclosed(pen: Mask) -> int:
    """px that the strokes of a pen enclose, its frame left out."""
    count, labels, stats, _ = cv2.connectedComponentsWithStats(pen.astype(np.uint8), connectivity=8)
    height, width = pen.shape
    spans = (stats[:, cv2.CC_STAT_WIDTH] > _SPANS * width) & (
        stats[:, cv2.CC_STAT_HEIGHT] > _SPANS * height
    )
    kept = np.ones(count, bool)
    kept[0], kept[spans] = False, False
    own = kept[labels].astype(np.uint8)
    contours, _ = cv2.findContours(own, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    area = np.zeros(pen.shape, np.uint8)
    cv2.drawContours(area, contours, -1, 1, cv2.FILLED)
    return int(area.sum() - own.sum())


def _led_through(part: Mask, other: Mask) -> Mask:
    """The part's ink, led through where another pen crosses it."""
    side = 2 * round(_CROSSED * _width(other) / 2.0) + 3
    kernel = np.ones((side, side), np.uint8)
    closed = cv2.morphologyEx(part.astype(np.uint8), cv2.MORPH_CLOSE, kernel) > 0
    return part | (closed & other)


def _width(pen: Mask) -> float:
    """px, the usual width of a pen's strokes."""
    depth = cv2.distanceTransform(pen.astype(np.uint8), cv2.DIST_L2, 3)
    ridge = depth[(depth > 0) & (depth >= cv2.dilate(depth, np.ones((3, 3), np.uint8)))]
    return 2.0 * float(np.median(ridge)) if len(ridge) else 1.0


def _alone(grey: Grey, own: Mask, gone: Mask) -> Grey:
    """The sheet without the ink of others, up to their pale borders."""
    beside = cv2.dilate(own.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    away = cv2.dilate(gone.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0
    return np.where(away & ~beside, np.uint8(_PAPER), grey)
