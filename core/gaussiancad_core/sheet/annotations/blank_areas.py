"""The areas of blank paper that ink parts from each other."""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.marks import Mask

_OUTLINED = 8.0
"""Squares of the gap's width that an area within an outline has at least."""

_SLIT_PX = 3
"""px; what is erased may leave gaps of fewer in an outline."""


@dataclass(frozen=True, eq=False)
class BlankAreas:
    """The blank areas of a sheet.

    Attributes:
        labels: (h, w), 0 on ink.
        paper: label of the paper around the views.
    """

    labels: npt.NDArray[np.int32]
    paper: int


def blank_areas(ink: Mask, bridge: int) -> BlankAreas:
    """The areas that ink parts, gaps of fewer px than ``bridge`` closed."""
    kernel = np.ones((bridge, bridge), np.uint8)
    closed = cv2.morphologyEx(ink.astype(np.uint8), cv2.MORPH_CLOSE, kernel)
    _, labels, facts, _ = cv2.connectedComponentsWithStats(1 - closed, connectivity=4)
    paper = 1 + int(np.argmax(facts[1:, cv2.CC_STAT_AREA])) if len(facts) > 1 else -1
    return BlankAreas(labels, paper)


def outlined_areas(ink: Mask, bridge: int) -> BlankAreas:
    """The same, even if an outline is open at a corner, before which both lines end.

    Squares that fit in on either side of such a gap overlap, so that closing leaves it open.  What
    counts is where a disc can go: it also cannot go between a rounding and the extension lines that
    meet at its sharp corner, so that only large areas count.
    """
    areas = blank_areas(ink, bridge)
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (bridge, bridge))
    beside = cv2.dilate(ink.astype(np.uint8), disc)
    _, nearest = cv2.distanceTransformWithLabels(beside, cv2.DIST_L2, cv2.DIST_MASK_5)
    labels = np.where(areas.labels > 0, nearest, 0)
    sizes = np.bincount(labels.ravel())
    sizes[0] = 0
    paper = int(np.argmax(sizes))
    was_open = np.bincount(labels[areas.labels == areas.paper], minlength=len(sizes))
    was_open[paper] = 0
    return BlankAreas(labels, paper) if was_open.max() > _OUTLINED * bridge**2 else areas


def paper_around(ink: Mask) -> Mask:
    """(h, w) bool, the paper around the views, which have closed outlines."""
    areas = blank_areas(ink, _SLIT_PX)
    return areas.labels == areas.paper
