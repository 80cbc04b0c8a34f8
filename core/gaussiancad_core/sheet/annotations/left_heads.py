"""Arrowheads that stay by themselves once their lines are gone.

Where narrow lines are told by their width, a run ends where its arrowhead is as wide as an edge.
The part has no blots in the middle of nowhere, so that such pieces of ink are no groups of it.
"""

from collections.abc import Iterator

import cv2
import numpy as np

from gaussiancad_core.sheet.annotations.erase import Told, masked
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Line

_LARGEST = 24.0
"""Length of an arrowhead at most, in widths of a visible line."""

_THICK = 0.95
"""Half width of an arrowhead at least, in widths of a visible line; where two cross it is 0.7."""

_BESIDE = 0.7
"""Distance of an arrowhead's middle from its line at most, in widths of a visible line."""

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
    heads = np.zeros(count, dtype=bool)
    for line, start, end in _told_lines(told):
        along, across = line.coordinates(middles)
        reach = sides / 2 + _APART * stroke_width
        at_end = np.minimum(np.abs(along - start), np.abs(along - end)) <= reach
        heads |= blots & at_end & (np.abs(across) <= _BESIDE * stroke_width)
    return masked(part, ~heads[labels]) if heads.any() else part


def _told_lines(told: Told) -> Iterator[tuple[Line, float, float]]:
    for shape, own in zip(told.shapes, told.kinds, strict=True):
        if isinstance(shape.geometry, Line):
            for run, kind in zip(shape.runs, own, strict=True):
                if kind is not None:
                    yield shape.geometry, run.run.start, run.run.end
