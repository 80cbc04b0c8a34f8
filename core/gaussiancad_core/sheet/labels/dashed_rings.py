"""Small hidden circles: a few dashes around one are as large as letters, and no writing.

No word has three and more strokes of like length that lie around one circle.
"""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.annotation_marks import Mask

Floats = npt.NDArray[np.float64]

_LONGEST = 14.0
"""Length of a dash at most, in stroke widths: that of a letter."""

_GAP = 6.0
"""Distance of two neighbouring dashes at most, in stroke widths."""

_FEWEST = 3
"""Dashes around a circle at least."""

_OFF, _OFF_PX = 0.3, 0.5
"""Distance of pixels from the circle in the mean of squares at most, in stroke widths, and px more:
those of a line are .29 of its width from its middle."""

_ALIKE = 2.0
"""Ratio of the ink of the largest dash to that of the smallest at most."""

_OPEN = 2.6
"""Largest angle without a dash, radians: one of four may be told, half is no circle."""


def dashed_rings(written: Mask, stroke_width: float) -> Mask:
    """(h, w) bool, the ink of writing that is a hidden circle.

    Args:
        written: (h, w) bool, what is taken for writing.
        stroke_width: px.
    """
    _, numbered, stats, _ = cv2.connectedComponentsWithStats(
        written.astype(np.uint8), connectivity=8
    )
    pieces = np.asarray(numbered, dtype=np.int32)
    sides = stats[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    is_dash = (sides > stroke_width) & (sides <= _LONGEST * stroke_width)
    is_dash[0] = False
    dashes = is_dash[pieces]
    reach = int(np.ceil(_GAP * stroke_width / 2.0))
    near = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * reach + 1, 2 * reach + 1))
    _, groups = cv2.connectedComponents(cv2.dilate(dashes.astype(np.uint8), near))
    rows, columns = np.nonzero(dashes)
    owners, members = groups[rows, columns], pieces[rows, columns]
    found = np.zeros(written.shape, bool)
    order = np.argsort(owners, kind="stable")
    for group in np.split(order, np.flatnonzero(np.diff(owners[order])) + 1):
        points = np.stack([columns[group], rows[group]], axis=1).astype(np.float64)
        if len(group) and _is_ring(points, members[group], stroke_width):
            found[rows[group], columns[group]] = True
    return found


def _is_ring(points: Floats, dashes: npt.NDArray[np.integer], stroke_width: float) -> bool:
    """Whether (n, 2) pixels, each of a dash, lie around one circle."""
    sizes = np.unique(dashes, return_counts=True)[1]
    if len(sizes) < _FEWEST or sizes.max() > _ALIKE * sizes.min():
        return False
    centre, radius = _circle_through(points)
    away = points - centre
    if np.sqrt(np.mean((np.hypot(*away.T) - radius) ** 2)) > _OFF * stroke_width + _OFF_PX:
        return False
    angles = np.sort(np.arctan2(away[:, 1], away[:, 0]))
    return bool(np.diff(angles, append=angles[0] + 2.0 * np.pi).max() <= _OPEN)


def _circle_through(points: Floats) -> tuple[Floats, float]:
    """The circle with the least algebraic distance from (n, 2) points (Kåsa 1976)."""
    middle = points.mean(axis=0)
    away = points - middle
    system = np.column_stack([2.0 * away, np.ones(len(away))])
    x, y, rest = np.linalg.lstsq(system, (away**2).sum(axis=1), rcond=None)[0]
    return middle + np.array([x, y]), float(np.sqrt(rest + x**2 + y**2))
