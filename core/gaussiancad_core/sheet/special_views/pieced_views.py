"""Views that are drawn in pieces or by half, made whole: broken views, and half views.

The halves of a broken view are one view.  A half view is completed by its mirror image where there
is room for it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.broken_views import Break, find_breaks, may_be_broken
from gaussiancad_core.sheet.special_views.drawing_names import inside
from gaussiancad_core.sheet.special_views.half_views import completed, find_halves
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind
from gaussiancad_core.sheet.views.sheet_layout import find_clusters


@dataclass(frozen=True, eq=False)
class Pieced:
    """A sheet whose views are whole.

    Attributes:
        separated: with the break lines of broken views, and the other halves of half views.
        clusters: boxes around groups of the part's ink, px.
        wholes: of each view that was made whole its kind, the box of what is drawn, and of all.
    """

    separated: SeparatedSheet
    clusters: tuple[Box, ...]
    wholes: tuple[tuple[SpecialKind, Box, Box], ...]


def with_whole_views(
    sheet: OpenedSheet, separated: SeparatedSheet, clusters: Sequence[Box]
) -> Pieced:
    """The sheet without annotations, its broken and half views made whole.

    Args:
        sheet: with all that is on it.
        separated: the same without annotations.
        clusters: boxes around groups of the part's ink, px.
    """
    boxes = list(clusters)
    wholes: list[tuple[SpecialKind, Box, Box]] = []
    if may_be_broken(separated.part.ink, boxes):
        for broken in find_breaks(sheet.clean.ink, boxes, sheet.clean.stroke_width):
            separated = _restored(sheet.clean, separated, broken)
            boxes = [box for box in boxes if box not in broken.halves] + [broken.box]
            wholes.append((SpecialKind.BROKEN, broken.box, broken.box))
    separated, boxes, halves = _completed(separated, boxes)
    return Pieced(separated, tuple(boxes), (*wholes, *halves))


def _completed(
    separated: SeparatedSheet, clusters: list[Box]
) -> tuple[SeparatedSheet, list[Box], list[tuple[SpecialKind, Box, Box]]]:
    """The sheet with the mirror images of half views, the clusters with whole views instead of
    halves, and each half with the box of what stands for it now."""
    if separated.strokes_known is None:
        return separated, clusters, []
    part = separated.part
    found: list[tuple[SpecialKind, Box, Box]] = []
    # Open sides look like single lines that stick out: here they count.
    for half in find_halves(
        part.ink,
        separated.strokes_known,
        find_clusters(part.ink, has_paper=separated.has_paper),
        part.stroke_width,
    ):
        boxes = [box for box in clusters if inside(box, half.box)]
        others = [box for box in clusters if box not in boxes and not half.marks(box)]
        if not boxes:
            continue
        both = completed(part, half, others)
        part = part if both is None else both
        found.append((SpecialKind.HALF, half.box, half.box if both is None else half.whole))
        clusters = others if both is None else [*others, half.whole]
    return replace(separated, part=part), clusters, found


def _restored(sheet: CleanSheet, separated: SeparatedSheet, broken: Break) -> SeparatedSheet:
    """With the break lines of a view, each as far as its ink goes in the view."""
    part = separated.part
    x0, y0, x1, y1 = (int(value) for value in broken.box)
    gone = np.zeros(part.ink.shape, np.uint8)
    gone[y0:y1, x0:x1] = (sheet.ink & (~part.ink | broken.lines))[y0:y1, x0:x1]
    _, pieces = cv2.connectedComponents(gone, connectivity=8)
    lines = np.isin(pieces, np.setdiff1d(pieces[broken.lines], 0)) | broken.lines
    near = cv2.dilate(lines.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    whole = replace(
        part,
        ink=part.ink | lines,
        weight=np.where(near, sheet.weight, part.weight),
    )
    return replace(separated, part=whole)
