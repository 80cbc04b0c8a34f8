"""The filled figure of a view, without what sticks out of it.

A remainder of a dimension makes the box of a view larger, and a view that is larger than its
neighbours is aligned with none.  The lines of a part close areas; those of dimensions end free.
"""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.votes import HALF

_BRIDGE = 1.5
"""Half of the gap in an outline that does not open it, in stroke widths."""

_THINNEST = 3.0
"""Width of what is no line, in stroke widths: two lines side by side are a stub, too."""

_LEAST_SHARE = 0.05
"""Area of a figure beside the largest one of a cluster at least, as a share of it: the loop of a
digit is smaller."""

_LEAST_COVERED = 0.25
"""Share of its box that a figure covers at least, for its outline not to be open."""


def without_stickouts(
    boxes: list[Box], ink: npt.NDArray[np.bool_], stroke_width: float
) -> list[Box]:
    """The boxes of the filled figures in clusters of ink, in the same order.

    Clusters of which the outline is open keep their box.

    Args:
        boxes: of clusters, px.
        ink: (h, w) bool.
        stroke_width: px.
    """
    return [_figure_box(box, ink, stroke_width) for box in boxes]


def side_strips(cluster: Box, figure: Box) -> list[Box]:
    """The strips of a cluster's box that its figure's box leaves on each side."""
    x0, y0, x1, y1 = cluster
    left, top, right, bottom = figure
    strips = [
        (x0, y0, left, y1),
        (right, y0, x1, y1),
        (x0, y0, x1, top),
        (x0, bottom, x1, y1),
    ]
    return [box for box in strips if box[2] > box[0] and box[3] > box[1]]


def _figure_box(box: Box, ink: npt.NDArray[np.bool_], width: float) -> Box:
    x0, y0, x1, y1 = (int(value) for value in box)
    bridge = _side(2.0 * _BRIDGE * width)
    margin = bridge + 1
    window = np.pad(ink[y0:y1, x0:x1].astype(np.uint8), margin)
    closed = cv2.morphologyEx(window, cv2.MORPH_CLOSE, np.ones((bridge, bridge), np.uint8))
    contours, _ = cv2.findContours(closed, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    filled = np.zeros_like(window)
    cv2.drawContours(filled, contours, -1, 1, cv2.FILLED)
    thick = _side(_THINNEST * width)
    body = cv2.morphologyEx(filled, cv2.MORPH_OPEN, np.ones((thick, thick), np.uint8))
    count, _, stats, _ = cv2.connectedComponentsWithStats(body, connectivity=8)
    if count < 2:
        return box
    areas = stats[1:, cv2.CC_STAT_AREA]
    kept = stats[1:][areas > _LEAST_SHARE * areas.max()]
    low = kept[:, :2].min(axis=0)
    high = (kept[:, :2] + kept[:, 2:4]).max(axis=0)
    covered = areas.sum() >= _LEAST_COVERED * float(np.prod(high - low))
    if not covered or (high - low < HALF * np.array([x1 - x0, y1 - y0])).any():
        return box
    found = np.array([*low, *high], float) + np.array([x0, y0, x0, y0]) - margin
    # Where a figure ends in a point, what is narrow belongs to it.
    near = np.abs(found - np.array(box)) <= 2.0 * thick
    left, top, right, bottom = (float(v) for v in np.where(near, box, found))
    return left, top, right, bottom


def _side(width: float) -> int:
    """The odd number of px nearest above a width."""
    return 2 * int(np.ceil(0.5 * width)) + 1
