"""At how many pixels a picture is read: so many that its wide lines are three pixels wide.

What reads lines, and the network that says what they stand for, are made for lines of that width.
A screenshot has thinner ones and a scan may have wider ones: both are resampled once, and what is
found is told in px of the sheet as stored.
"""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.paper import PICTURE_REACH, smaller

Runs = tuple[npt.NDArray[np.intp], npt.NDArray[np.intp], npt.NDArray[np.intp]]
"""(n,) each: row, first and last column."""

WORKING_WIDTH = 3.0
"""px of the widest usual lines of a sheet that is read."""

_SAME = 0.08
"""Share by which lines may be wider or narrower and the picture stays as it is."""

_LEAST, _MOST = 0.2, 4.0
"""Factors between which a picture is resampled."""

_INKED = 0.3
"""Darkness from which a pixel belongs to a stroke, in that of full ink."""

_FULL = 95.0
"""Per cent of the dark pixels that are at most as dark as full ink."""

_DARK = 40
"""Grey levels by which a pixel is darker than the paper, to say how dark ink is."""

_LONG = 6.0
"""Length of a straight piece of stroke in its width, from which it says how wide strokes are."""

_LONG_PX = 12
"""The same in px."""

_SHARE = 0.12
"""Share of the strokes' length that a width has at least, to be one of the sheet's pens."""

_WINDOW = 0.13
"""Share by which the widths of one pen differ."""


def working_factor(grey: npt.NDArray[np.uint8]) -> float:
    """Px of the picture that is read per px of a picture; 1 where its lines tell nothing.

    Args:
        grey: (h, w) uint8, dark ink on light paper.
    """
    width = pen_width(grey)
    if width is None:
        return 1.0
    factor = float(np.clip(WORKING_WIDTH / width, _LEAST, _MOST))
    return 1.0 if abs(factor - 1.0) < _SAME else factor


def pen_width(grey: npt.NDArray[np.uint8]) -> float | None:
    """Width in px of a sheet's widest usual pen: that of one eighth of its upright and level
    strokes' length at least; None where there are no such strokes.

    The width of a stroke is its ink across it, so that blur and half pixels change nothing.

    Args:
        grey: (h, w) uint8, dark ink on light paper.
    """
    weight = _darkness(grey)
    if weight is None:
        return None
    turned = np.ascontiguousarray(weight.T)
    level, upright = _runs(weight > _INKED), _runs(turned > _INKED)
    both = [_across(weight, level, upright), _across(turned, upright, level)]
    widths = np.sort(np.concatenate(both))
    if len(widths) < 2 * _LONG_PX:
        return None
    first = np.searchsorted(widths, widths * (1.0 - _WINDOW))
    last = np.searchsorted(widths, widths * (1.0 + _WINDOW), side="right")
    usual = last - first >= _SHARE * len(widths)
    if not usual.any():
        return float(np.median(widths))
    widest = int(np.flatnonzero(usual)[-1])
    return float(np.median(widths[first[widest] : last[widest]]))


def resampled(grey: npt.NDArray[np.uint8], size: tuple[int, int]) -> npt.NDArray[np.uint8]:
    """A picture at another size.

    Args:
        grey: (h, w) uint8.
        size: width and height in px.
    """
    way = cv2.INTER_AREA if size[0] < grey.shape[1] else cv2.INTER_LANCZOS4
    return np.asarray(cv2.resize(grey, size, interpolation=way), dtype=np.uint8)


def _darkness(grey: npt.NDArray[np.uint8]) -> npt.NDArray[np.float32] | None:
    """(h, w) 0 for paper to 1 for ink; None without any ink."""
    height, width = grey.shape
    kernel = np.ones((PICTURE_REACH, PICTURE_REACH), np.uint8)
    paper = cv2.morphologyEx(smaller(grey), cv2.MORPH_CLOSE, kernel)
    light = cv2.resize(paper, (width, height), interpolation=cv2.INTER_LINEAR)
    darkness = cv2.subtract(light, grey)
    dark = darkness[darkness > _DARK]
    if not len(dark):
        return None
    return np.minimum(darkness / np.float32(np.percentile(dark, _FULL)), np.float32(1.0))


def _across(weight: npt.NDArray[np.float32], level: Runs, upright: Runs) -> npt.NDArray[np.float64]:
    """(n,) px of ink across upright strokes, one value for each px of their length.

    Args:
        weight: (h, w) ink.
        level: its runs along the rows.
        upright: those along the columns.
    """
    rows, first, last = level
    height, width = weight.shape
    columns, top, bottom = upright
    # Of the run along its column in which the middle of each lies.
    crossing = np.searchsorted(
        columns * height + top, (first + last) // 2 * height + rows, side="right"
    )
    along = (bottom - top + 1)[crossing - 1]
    straight = along >= np.maximum(_LONG * (last - first + 1), _LONG_PX)
    if not straight.any():
        return np.empty(0)
    rows, first, last = rows[straight], first[straight], last[straight]
    # The ink of a run, with that of its smooth edges.
    before = rows * width + np.maximum(first - 1, 0)
    after = rows * width + np.minimum(last + 2, width)
    borders = np.stack([before, after], axis=1).ravel()
    return np.add.reduceat(np.append(weight, np.float32(0.0)), borders, dtype=np.float64)[::2]


def _runs(inked: npt.NDArray[np.bool_]) -> Runs:
    """Row, first and last column of each unbroken piece of ink along the rows, in order."""
    width = inked.shape[1] + 1
    # A blank column between rows keeps their pieces apart.
    line = np.append(np.pad(inked, ((0, 0), (1, 0))).ravel(), False)
    first, after = (np.flatnonzero(line[1:] != line[:-1]) + 1).reshape(-1, 2).T
    rows = first // width
    return rows, first - rows * width - 1, after - rows * width - 2
