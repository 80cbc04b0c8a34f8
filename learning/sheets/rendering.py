"""A canvas as pixels: how dark each is, and what it stands for."""

import math
from dataclasses import dataclass
from functools import reduce

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets.canvas import (
    SUPERSAMPLING,
    Canvas,
    Filled,
    Lines,
    Mark,
    Stamp,
)
from learning.sheets.chains_of_points import Points
from learning.training_samples import (
    EITHER,
    HEAT_MOST,
    HEAT_SHIFT,
    ON_HIDDEN,
    UNKNOWN,
)

Bytes = npt.NDArray[np.uint8]

INK = 70
"""Darkness from which a pixel counts as ink."""

_CLEAN = 12
"""Darkness up to which it counts as paper; what is between is either."""

_ORDER = (
    InkClass.PAPER,
    InkClass.PICTORIAL,
    InkClass.FRAME,
    InkClass.OTHER,
    InkClass.HATCHING,
    InkClass.TEXT,
    InkClass.DIMENSION,
    InkClass.CENTRE,
    InkClass.THIN,
    InkClass.HIDDEN,
    InkClass.VISIBLE,
)
"""Where kinds of ink meet, the later one counts."""

_RANKS = {ink: rank for rank, ink in enumerate(_ORDER)}
"""Place in the order of each kind."""

_CLASS_OF_RANK = np.resize(np.array(_ORDER, np.uint8), 256)
"""(256,) table back from it."""

_TAKEN = 60
"""Darkness of a stamp's mask from which a pixel counts as its own."""

_BITS = 4
"""Of the coordinates that are drawn behind the point."""

_NARROWEST_TRACK = 3
"""px across hidden lines."""

_HEAT_PX, _HEAT_VARIANCE = 5, 2.25
"""px around a corner in which it is warm, and px^2 of the bell of its heat."""


@dataclass(frozen=True, eq=False)
class Rendered:
    """A sheet, clean.

    Attributes:
        ink: (h, w) darkness of what is drawn.
        classes: (h, w) as in :class:`.Sample`.
        extra: (h, w) as in :class:`.Sample`.
        tint: (h, w) float32 darkness of areas that are no ink; None without any.
    """

    ink: Bytes
    classes: Bytes
    extra: Bytes
    tint: npt.NDArray[np.float32] | None


def rendered(canvas: Canvas, *, smooth: bool) -> Rendered:
    """The pixels of a canvas.

    Args:
        canvas: what is drawn.
        smooth: whether edges of lines are.
    """
    size = SUPERSAMPLING * canvas.height, SUPERSAMPLING * canvas.width
    ink, ranks = np.zeros(size, np.uint8), np.zeros(size, np.uint8)
    kind = cv2.LINE_AA if smooth else cv2.LINE_8
    for mark in sorted(canvas.marks, key=lambda this_mark: this_mark.darkness):
        _draw(ink, mark, mark.darkness, kind)
    for mark in sorted(canvas.marks, key=lambda this_mark: _RANKS[this_mark.ink]):
        _claim(ranks, mark)
    size = canvas.width, canvas.height
    ink = np.asarray(cv2.resize(ink, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    classes = _classes(ink, ranks)
    return Rendered(ink, classes, _extra(canvas, classes), _tint(canvas))


def _classes(ink: Bytes, ranks: Bytes) -> Bytes:
    """What pixels stand for, by the foremost rank in each and how dark it is."""
    steps = range(SUPERSAMPLING)
    pixels = [ranks[row::SUPERSAMPLING, column::SUPERSAMPLING] for row in steps for column in steps]
    foremost = np.asarray(cv2.LUT(reduce(np.maximum, pixels), _CLASS_OF_RANK), dtype=np.uint8)
    dark, claimed = ink >= INK, foremost != InkClass.PAPER
    foremost[(dark != claimed) & (ink >= _CLEAN)] = UNKNOWN
    foremost[(~dark & ~claimed) | (ink < _CLEAN)] = InkClass.PAPER
    return foremost


def _fixed(chain: Points, scale: float) -> npt.NDArray[np.int32]:
    """Coordinates as OpenCV takes them, with bits behind the point."""
    return np.rint(chain * (scale * 2**_BITS)).astype(np.int32)


def _draw(image: Bytes, mark: Mark, value: int, kind: int, wider: int = 0) -> None:
    """Draw a mark into supersampled pixels."""
    shape = mark.shape
    if isinstance(shape, Lines):
        chains = [_fixed(chain, SUPERSAMPLING) for chain in shape.chains]
        width = max(1, round(shape.width * SUPERSAMPLING)) + wider
        cv2.polylines(image, chains, False, value, width, kind, _BITS)
    elif isinstance(shape, Filled):
        cv2.fillPoly(image, [_fixed(shape.ring, SUPERSAMPLING)], value, kind, _BITS)
    else:
        seen, mask = _overlap(image, mark)
        np.maximum(seen, (mask.astype(np.uint16) * value // 255).astype(np.uint8), out=seen)


def _claim(ranks: Bytes, mark: Mark) -> None:
    """Give the pixels of a mark its rank; the edges of lines, which are pale, are its own."""
    rank = _RANKS[mark.ink]
    if isinstance(mark.shape, Lines | Filled):
        _draw(ranks, mark, rank, cv2.LINE_8, wider=1)
        return
    seen, mask = _overlap(ranks, mark)
    seen[mask > _TAKEN] = rank


def _overlap(image: Bytes, mark: Mark) -> tuple[Bytes, Bytes]:
    """The part of an image on which a stamp lies, and the part of its mask that lies on it."""
    stamp = mark.shape
    if not isinstance(stamp, Stamp):
        raise ValueError("the mark is no stamp")
    mask, x, y = stamp.mask, stamp.x, stamp.y
    height, width = mask.shape
    rows = slice(min(max(0, y), image.shape[0]), max(0, min(image.shape[0], y + height)))
    columns = slice(min(max(0, x), image.shape[1]), max(0, min(image.shape[1], x + width)))
    seen = image[rows, columns]
    top, left = rows.start - y, columns.start - x
    if not seen.size:
        return seen[:0, :0], mask[:0, :0]
    return seen, mask[top : top + seen.shape[0], left : left + seen.shape[1]]


def _extra(canvas: Canvas, classes: Bytes) -> Bytes:
    """Hidden lines, and the heat of corners."""
    extra = np.zeros(classes.shape, np.uint8)
    half = 0.5 / SUPERSAMPLING
    for track in canvas.tracks:
        chains = [_fixed(chain - half, 1.0) for chain in track.chains if len(chain) > 1]
        width = max(_NARROWEST_TRACK, round(track.width))
        cv2.polylines(extra, chains, False, ON_HIDDEN, width, cv2.LINE_8, _BITS)
    extra[(extra > 0) & (classes == InkClass.VISIBLE)] = EITHER
    return extra | (_heat(canvas) << np.uint8(HEAT_SHIFT))


def _heat(canvas: Canvas) -> Bytes:
    """(h, w) 0 to the most, at a corner."""
    heat = np.zeros((canvas.height + 2 * _HEAT_PX, canvas.width + 2 * _HEAT_PX), np.uint8)
    steps = np.arange(-_HEAT_PX, _HEAT_PX + 1, dtype=np.float32)
    for x, y in canvas.corners:
        column, row = math.floor(x), math.floor(y)
        if not (0 <= column < canvas.width and 0 <= row < canvas.height):
            continue
        right, down = (steps - (item - math.floor(item) - 0.5) for item in (x, y))
        away = right[None] ** 2 + down[:, None] ** 2
        bell = np.rint(HEAT_MOST * np.exp(-away / (2.0 * _HEAT_VARIANCE))).astype(np.uint8)
        around = np.s_[row : row + len(steps), column : column + len(steps)]
        np.maximum(heat[around], bell, out=heat[around])
    return heat[_HEAT_PX:-_HEAT_PX, _HEAT_PX:-_HEAT_PX]


def _tint(canvas: Canvas) -> npt.NDArray[np.float32] | None:
    if not canvas.tints:
        return None
    tint = np.zeros((canvas.height, canvas.width), np.float32)
    for this_tint in canvas.tints:
        ring = [np.rint(this_tint.ring).astype(np.int32)]
        if this_tint.left == this_tint.right:
            cv2.fillPoly(tint, ring, float(this_tint.left))
            continue
        mask = np.zeros(tint.shape, np.uint8)
        cv2.fillPoly(mask, ring, 1)
        levels = np.linspace(this_tint.left, this_tint.right, canvas.width, dtype=np.float32)
        np.copyto(tint, levels[None], where=mask > 0)
    return tint
