"""Annotations taken off the ink, the part's own strokes left whole where they cross."""

from dataclasses import dataclass, replace
from functools import cached_property

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.annotations.inked_shapes import InkedShape, points_along
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet

Kinds = list[list[AnnotationKind | None]]
"""For each run of each shape what annotation it is, or nothing where it is the part's."""

_ARROW = 4.0
"""Half widths of arrowheads that are erased with their line, in stroke widths, at most."""

_LARGEST_CRUMB = 0.04
"""Size of what may be left of an annotation, as a share of the sheet's longest side."""

SHOWS = None, AnnotationKind.PICTURE
"""What lines are that show a part."""


@dataclass(frozen=True, eq=False)
class Told:
    """What is known of a sheet's ink.

    Attributes:
        shapes: lines and circles with their runs.
        kinds: of the runs.
        unexplained: (h, w) bool, ridge points of no line or circle; the part's until told else.
        loose: (h, w) bool, ridge points of no line or circle that are annotations, or nothing.
    """

    shapes: list[InkedShape]
    kinds: Kinds
    unexplained: Mask
    loose: Mask | None = None

    @cached_property
    def straight_runs(self) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        """The straight runs that show a part: (n,) directions in 0..pi, from the sheet's right
        towards its bottom, and (n, 2, 2) px, their ends."""
        # There may be thousands of them, and hundreds of boxes in which they are looked for.
        angles, ends = [], []
        for shape, this_kind in zip(self.shapes, self.kinds, strict=True):
            if not isinstance(shape.geometry, Line):
                continue
            way = shape.geometry.direction
            for run, kind in zip(shape.runs, this_kind, strict=True):
                if kind in SHOWS:
                    ends.append(points_along(shape.geometry, run.run, 1e9)[[0, -1]] + 0.5)
                    angles.append(np.arctan2(way[1], way[0]) % np.pi)
        return np.array(angles), np.array(ends).reshape(-1, 2, 2)


def masked(sheet: CleanSheet, kept: Mask) -> CleanSheet:
    """The sheet with the ink under a mask alone."""
    return replace(sheet, ink=sheet.ink & kept, weight=np.where(kept, sheet.weight, 0.0))


def erased(sheet: CleanSheet, stated: Told) -> CleanSheet:
    """The sheet without the runs that are annotations, and without what hung on them."""
    inside = cv2.distanceTransform(sheet.ink.astype(np.uint8), cv2.DIST_L2, 5)
    erase = np.zeros(sheet.ink.shape, np.uint8)
    free = stated.unexplained & ~_along_annotations(stated)
    keep = cv2.dilate(free.astype(np.uint8), np.ones((3, 3), np.uint8))
    for shape, annotation_kinds in zip(stated.shapes, stated.kinds, strict=True):
        for run, kind in zip(shape.runs, annotation_kinds, strict=True):
            points = points_along(shape.geometry, run.run, 1.0)
            if kind is None:
                width = run.width or sheet.stroke_width
                path = np.rint(points * 8).astype(np.int32)
                cv2.polylines(keep, [path], False, 1, int(np.ceil(width)) + 2, shift=3)
                continue
            columns = np.clip(np.rint(points[:, 0]).astype(int), 0, sheet.ink.shape[1] - 1)
            rows = np.clip(np.rint(points[:, 1]).astype(int), 0, sheet.ink.shape[0] - 1)
            radii = np.minimum(inside[rows, columns], _ARROW * sheet.stroke_width) + 2.0
            for column, row, radius in zip(columns, rows, radii, strict=True):
                cv2.circle(erase, (int(column), int(row)), int(np.ceil(radius)), 1, -1)
    if stated.loose is not None:
        reach = 2 * int(np.ceil(0.5 * sheet.stroke_width)) + 3
        wide = cv2.dilate(stated.loose.astype(np.uint8), np.ones((reach, reach), np.uint8))
        erase |= np.asarray(wide, dtype=np.uint8)
    part = masked(sheet, (erase == 0) | (keep > 0))
    # Crumbs: pieces that no stroke of the part runs through.
    _, labels, stats, _ = cv2.connectedComponentsWithStats(
        part.ink.astype(np.uint8), connectivity=8
    )
    kept = np.zeros(len(stats), dtype=bool)
    kept[np.unique(labels[keep > 0])] = True
    sides = np.maximum(stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT])
    kept |= sides > _LARGEST_CRUMB * max(sheet.ink.shape)
    kept[0] = True
    near = cv2.dilate((~kept[labels]).astype(np.uint8), np.ones((5, 5), np.uint8)) == 0
    return masked(part, near | (keep > 0))


def _along_annotations(stated: Told) -> Mask:
    """(h, w) bool, pixels within about one of the axis of an annotation: where two of them cross,
    or one runs into the part, ridge points on it belong to no line, yet are its own."""
    axes = np.zeros(stated.unexplained.shape, np.uint8)
    for shape, annotation_kinds in zip(stated.shapes, stated.kinds, strict=True):
        for run, kind in zip(shape.runs, annotation_kinds, strict=True):
            if kind is not None:
                path = np.rint(points_along(shape.geometry, run.run, 1.0) * 8).astype(np.int32)
                cv2.polylines(axes, [path], False, 1, 1, shift=3)
    return cv2.dilate(axes, np.ones((3, 3), np.uint8)) > 0
