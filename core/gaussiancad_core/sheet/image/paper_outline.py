"""The sheet of paper in a picture that shows more than it: a table, a scanner's lid.

What surrounds the paper is darker than it and lies in the picture's corners.  The lines of a
drawing are closed before anything is compared, so that ink is paper.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.paper import PICTURE_REACH, smaller

Floats = npt.NDArray[np.float64]

_SMALL = 500
"""px of the longer side of the picture in which paper is looked for."""

_LEAST_PAPER, _MOST_PAPER = 0.15, 0.97
"""Share of the picture that paper takes, to be told from what surrounds it."""

_DARKER = 30.0
"""Grey levels by which the surroundings are darker than paper."""

_CONVEX = 0.93
"""Share of its hull that a sheet of paper fills."""

_CORNERS = 3
"""Corners of the picture in which the surroundings are: a dark field of a sheet has two."""

_EDGE = 0.004
"""Width of the paper's edge, with its shadow, in the picture's longer side."""

_CORNER = 0.02
"""Share of the paper's girth by which a side may bend and is one."""


@dataclass(frozen=True, eq=False)
class PaperOutline:
    """Where the paper is.

    Attributes:
        hull: (n, 2) px of the picture, the convex outline of the paper.
        corners: (4, 2) px, its corners in order; None where it is no quadrilateral.
    """

    hull: Floats
    corners: Floats | None

    def mask(self, shape: tuple[int, int]) -> npt.NDArray[np.uint8]:
        """(h, w) uint8, 255 on the paper, without its edge.

        Args:
            shape: height and width of the picture, px.
        """
        found = np.zeros(shape, np.uint8)
        cv2.fillConvexPoly(found, np.rint(self.hull).astype(np.int32), 255)
        width = max(1, round(_EDGE * max(shape)))
        # Beyond the picture's own border there may be more paper.
        kernel = np.ones((2 * width + 1, 2 * width + 1), np.uint8)
        return np.asarray(cv2.erode(found, kernel), dtype=np.uint8)


def paper_outline(grey: npt.NDArray[np.uint8]) -> PaperOutline | None:
    """The paper in a picture; None where all of it is paper, or where none can be told.

    Args:
        grey: (h, w) uint8, dark ink on light paper.
    """
    inked, paper = _small(grey)
    height, width = paper.shape
    _, light = cv2.threshold(paper, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(light, connectivity=4)
    if count < 2:
        return None
    largest = 1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))
    outlines, _ = cv2.findContours(
        (labels == largest).astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE
    )
    outline = max(outlines, key=cv2.contourArea)
    hull = cv2.convexHull(outline)
    area = cv2.contourArea(hull)
    if not _LEAST_PAPER <= area / (height * width) <= _MOST_PAPER:
        return None
    if cv2.contourArea(outline) < _CONVEX * area:
        return None
    inside = np.zeros_like(paper)
    cv2.fillConvexPoly(inside, hull, 1)
    around = cv2.dilate(inside, np.ones((5, 5), np.uint8)) == 0
    if around[[0, 0, -1, -1], [0, -1, 0, -1]].sum() < _CORNERS:
        return None
    # Light lines on a dark sheet are as light as paper where they are dense, but most of it is not.
    if float(np.median(inked[inside > 0])) - float(np.median(paper[around])) < _DARKER:
        return None
    factor = np.array([grey.shape[1] / width, grey.shape[0] / height])
    corners = cv2.approxPolyDP(hull, _CORNER * cv2.arcLength(hull, True), True).reshape(-1, 2)
    return PaperOutline(
        (hull.reshape(-1, 2) + 0.5) * factor - 0.5,
        (corners + 0.5) * factor - 0.5 if len(corners) == 4 else None,
    )


def _small(grey: npt.NDArray[np.uint8]) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.uint8]]:
    """A small picture as it is, and without ink."""
    kernel = np.ones((PICTURE_REACH, PICTURE_REACH), np.uint8)
    inked = smaller(grey)
    closed = cv2.morphologyEx(inked, cv2.MORPH_CLOSE, kernel)
    factor = min(1.0, _SMALL / max(closed.shape))
    size = (max(1, round(closed.shape[1] * factor)), max(1, round(closed.shape[0] * factor)))
    plain, blank = (
        np.asarray(cv2.resize(item, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)
        for item in (inked, closed)
    )
    return plain, blank
