"""Arrowheads that stay by themselves once their lines are gone.

Where narrow lines are told by their width, a run ends where its arrowhead is as wide as an edge.
The part has no blots in the middle of nowhere, so that such pieces of ink are no groups of it.
"""

from collections.abc import Iterator

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.erase import Told, masked
from gaussiancad_core.sheet.annotations.inked import points_along
from gaussiancad_core.sheet.annotations.line_ends import told_lines
from gaussiancad_core.sheet.annotations.marks import values_at
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle

_LARGEST = 24.0
"""Length of an arrowhead at most, in widths of a visible line."""

_THICK = 1.4
"""Half width of an arrowhead at least, in widths of a visible line; where two cross it is about one
at most, and what was a crossing of a dash with an annotation is by itself, too."""

_BESIDE = 0.7
"""Distance of an arrowhead's middle from its line at most, in widths of a visible line."""

_SOLID = 0.5
"""Share of its convex hull that an arrowhead fills at least; circles and corners do not."""

_WHOLE = 0.6
"""Share of a circle that is drawn at least, for it to be a small bore and no contour of a head."""

_APART = 2.0
"""Ink between an arrowhead and the end of its line that went with the line, in the same widths."""


def without_heads(part: CleanSheet, told: Told, stroke_width: float) -> CleanSheet:
    """A part's ink without blots of no other stroke at the ends of straight annotations.

    Args:
        part: with the annotations erased.
        told: what each line and circle is.
        stroke_width: px, of visible lines.
    """
    ink = part.ink.astype(np.uint8)
    count, labels, boxes, middles = cv2.connectedComponentsWithStats(ink, connectivity=8)
    sides = boxes[:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1)
    inside = cv2.distanceTransform(ink, cv2.DIST_L2, 5)
    thickest = np.zeros(count)
    np.maximum.at(thickest, labels, inside)
    blots = (sides <= _LARGEST * stroke_width) & (thickest > _THICK * stroke_width)
    blots[0] = False
    for points in _circles(told):
        blots[values_at(labels, points)] = False
    heads = np.zeros(count, dtype=bool)
    for line, own, _ in told_lines(told.shapes, told.kinds):
        along, across = line.coordinates(middles)
        reach = sides / 2 + _APART * stroke_width
        # Of a head that went with its line in part, the rest is before the line's end.
        before = np.where(
            (along > own.run.start) & (along < own.run.end), _LARGEST * stroke_width, reach
        )
        at_end = np.minimum(np.abs(along - own.run.start), np.abs(along - own.run.end)) <= before
        heads |= blots & at_end & (np.abs(across) <= _BESIDE * stroke_width)
    for number in np.flatnonzero(heads):
        heads[number] = _is_solid(labels, boxes[number], int(number))
    return masked(part, ~heads[labels]) if heads.any() else part


def _is_solid(labels: npt.NDArray[np.int32], box: npt.NDArray[np.int32], number: int) -> bool:
    """Whether a piece of ink fills most of its convex hull."""
    left, top, width, height, area = box.tolist()
    rows, columns = np.nonzero(labels[top : top + height, left : left + width] == number)
    # Corners of the pixels, for hulls of their centres are smaller than the ink.
    corners = [np.stack([columns + x, rows + y], axis=1) for x in (0, 1) for y in (0, 1)]
    hull = cv2.convexHull(np.concatenate(corners).astype(np.int32))
    return area >= _SOLID * cv2.contourArea(hull)


def _circles(told: Told) -> Iterator[npt.NDArray[np.float64]]:
    """(n, 2) px along each circle of the part that is most of one."""
    for shape, own in zip(told.shapes, told.kinds, strict=True):
        kept = [run.run for run, kind in zip(shape.runs, own, strict=True) if kind is None]
        if isinstance(shape.geometry, Circle):
            around = sum(run.length for run in kept)
            if around >= _WHOLE * shape.geometry.around:
                for run in kept:
                    yield points_along(shape.geometry, run, 1.0)
