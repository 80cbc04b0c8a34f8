"""Strokes that are plotted in grey or in a light colour, as strong as dark ones."""

from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt

Mask = npt.NDArray[np.bool_]
"""(h, w), True where there is ink."""

_PALE = 0.7
"""Share of the ink's darkness up to which all of a stroke is pale; the smooth edges of thin dark
strokes come in all shades, and now and then as one that is darker."""

_DARKER = 0.2
"""Share of what is not fully dark that is darker, at most: the edges of dark strokes."""

_ONE_SHADE = 0.1, 0.8
"""Share of the ink's darkness by which pale strokes differ, and of their length that does not by
more, at most and at least."""

_TWO_SHADES = 0.15
"""Share of the ink's darkness by which two pale pens differ at least: the strokes of one differ a
little with their places."""

_HALF = 0.55
"""Weight of the darker of two pale pens at least, above half of the ink's darkness."""

_THIN = 0.47
"""Share of the ink's darkness that a dark stroke of one px has at least, wherever it lies."""

_RAISED, _FAINTEST = 0.65, 0.15
"""Weight that paler strokes are raised to, and of strokes that are raised by no more than the
ratio of the two."""

_ACROSS, _LEAN = 5, 0.8
"""px across a stroke over which its ink is summed up, and px of dark ink that it has at most where
it is pale: a dark one of a px has one."""

_FULL_PX = 1.2
"""px of dark ink across a stroke from which it is as strong as a dark one."""

_MANY_PALE_PX, _SPREAD = 300, 0.04
"""px of thin pale strokes, and the standard deviation of their shades, from which some of them lie
on a row of pixels."""

_STRONG, _WIDE_PX = 0.75, 1.6
"""Weight that a pale stroke is given, and px of width from which its ink bears it."""

_EQUAL = 0.01
"""Share of the ink's darkness by which the pixels along a stroke differ."""

_LEAST_PALE_PX = 30
"""px of pale strokes on a sheet at least."""


def with_pale(weight: npt.NDArray[np.float32], ink: Mask) -> npt.NDArray[np.float32]:
    """The weight with strokes of one pale shade as strong ones: many programs plot hidden lines or
    dimensions in grey or in a light colour.

    They stay a little paler than dark ones, so that their ink is as that of a narrower pen.
    """
    around = _around(weight)
    middle = ink & (weight >= cv2.dilate(weight, np.ones((3, 3), np.float32)) - _EQUAL)
    shades = weight[middle & (around < 0.5 * (1.0 + _PALE))]
    if len(shades) < _LEAST_PALE_PX:
        return weight
    pens = _pale_pens(weight, shades)
    shade = None if pens else _pale_shade(weight, shades)
    if not pens and shade is None:
        # Thin strokes are as dark as their ink where they lie on a row of pixels: some do.
        shade = _darkest_thin(shades)
        return _with_faint(weight if shade is None else _as_inked(weight, ink, shade), ink)
    if shade is not None:
        pens = [shade]
    # Beside dark strokes the shade of a pixel says nothing.
    adjacent = around <= _PALE
    values = np.array(pens)[np.searchsorted(_between(pens), around)]
    full = np.where(adjacent, np.minimum(weight / values, 1.0), weight)
    strokes = ink & adjacent
    strong = _STRONG if mean_stroke_width(strokes, full * strokes) > _WIDE_PX else 1.0
    return _with_faint(np.where(adjacent, strong * full, full).astype(np.float32), ink)


def _around(weight: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """(h, w) the largest weight within two pixels of each."""
    return np.asarray(cv2.dilate(weight, np.ones((5, 5), np.float32)), dtype=np.float32)


def _across(weight: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """(h, w) px of dark ink across the stroke at each pixel."""
    return np.minimum(
        cv2.boxFilter(weight, -1, (_ACROSS, 1), normalize=False),
        cv2.boxFilter(weight, -1, (1, _ACROSS), normalize=False),
    )


def _as_inked(weight: npt.NDArray[np.float32], ink: Mask, shade: float) -> npt.NDArray[np.float32]:
    """The weight with thin strokes of a shade at most as strong as about a px of ink makes them.

    Dark ones that lie between two rows of pixels have as much already: they stay as wide as they
    are, which is what tells dimensions.
    """
    around = _around(weight)
    most = _around(_across(weight) * ink)
    factor = np.clip(_FULL_PX / np.maximum(most, shade), 1.0, 1.0 / shade)
    return np.where(around <= _PALE, np.minimum(weight * factor, 1.0), weight).astype(np.float32)


def _with_faint(weight: npt.NDArray[np.float32], ink: Mask) -> npt.NDArray[np.float32]:
    """The weight with what has less ink than any dark stroke of a px as strong as that may be.

    Among thin dark strokes, whose shades differ with their places, pale ones make no shade of their
    own.
    """
    around = _around(weight)
    across = _across(weight)
    lean = (_around(across) <= _LEAN) & (around <= _PALE)
    faint = ink & (lean | (around <= _THIN))
    if int(faint.sum()) < _LEAST_PALE_PX:
        return weight
    # The pixels beside a stroke bear some of it.
    near = cv2.dilate(faint.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    near &= lean | (around <= _THIN)
    raised = weight * np.maximum(_RAISED / np.maximum(around, _FAINTEST), 1.0)
    return np.where(near, raised, weight).astype(np.float32)


def _pale_shade(weight: npt.NDArray[np.float32], shades: npt.NDArray[np.float32]) -> float | None:
    """The weight of the middles (n,) of pale strokes; None if they may be thin ones."""
    if float(np.mean(shades > _PALE)) > _DARKER:
        return None
    shades = shades[shades <= _PALE]
    shade = float(np.median(shades))
    apart, share = _ONE_SHADE
    if float(np.mean(np.abs(shades - shade) <= apart)) >= share:
        plateau = (np.abs(weight - shade) <= apart).astype(np.uint8)
        if shade <= _THIN or cv2.erode(plateau, np.ones((3, 3), np.uint8)).any():
            return shade
    return None


def _darkest_thin(shades: npt.NDArray[np.float32]) -> float | None:
    """The weight of the middles (n,) of thin pale strokes where they lie on a row of pixels."""
    if float(np.mean(shades > _PALE)) > _DARKER:
        return None
    shades = shades[shades <= _PALE]
    spread = len(shades) >= _MANY_PALE_PX and float(np.std(shades)) >= _SPREAD
    return float(np.percentile(shades, 97.0)) if spread else None


def _pale_pens(weight: npt.NDArray[np.float32], shades: npt.NDArray[np.float32]) -> list[float]:
    """The weights of two pale pens, that of the paler one first, or of one beside a darker one;
    nothing where the middles (n,) of strokes are of other shades."""
    levels = np.rint(255.0 * shades).astype(np.uint8)
    cut, _ = cv2.threshold(levels, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    apart, share = _ONE_SHADE
    pens = []
    for group in (shades[levels <= cut], shades[levels > cut]):
        if len(group) < _LEAST_PALE_PX:
            return []
        shade = float(np.median(group))
        if float(np.mean(np.abs(group - shade) <= 0.5 * apart)) < share:
            return []
        pens.append(shade)
    # A thin dark stroke between two rows of pixels has less than half of its ink in one of them.
    darker = (np.abs(weight - pens[1]) <= _TWO_SHADES).astype(np.uint8)
    wide = int(cv2.erode(darker, np.ones((2, 2), np.uint8)).sum()) >= _LEAST_PALE_PX
    if pens[1] - pens[0] < _TWO_SHADES or pens[1] < _HALF or not wide:
        return []
    return [shade for shade in pens if shade <= _PALE]


def _between(pens: list[float]) -> list[float]:
    """The weights half way from each pen to the next."""
    return [0.5 * (one + other) for one, other in pairwise(pens)]


def mean_stroke_width(ink: Mask, weight: npt.NDArray[np.float32]) -> float:
    """Mean stroke width in px: twice the ink over the length of its outlines."""
    contours, _ = cv2.findContours(ink.astype(np.uint8), cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    # Outlines run through the centres of the outermost pixels, so a thin stroke's are too short by
    # little, and its weight spreads over the pixels beside it.
    near = cv2.dilate(ink.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    length = sum(cv2.arcLength(contour, True) for contour in contours)
    return max(1.0, float(2.0 * weight[near].sum() / max(length, 1.0)))
