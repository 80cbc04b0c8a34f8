"""The principal views of a sheet, and the names of what else is drawn on it."""

from dataclasses import dataclass, replace

import cv2
import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, Mask
from gaussiancad_core.sheet.annotations.erase import masked
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.broken_views import Break, find_breaks, may_be_broken
from gaussiancad_core.sheet.special_views.cut_views import hatched_box, section_kind
from gaussiancad_core.sheet.special_views.drawing_names import details, inside, merged, special_kind
from gaussiancad_core.sheet.special_views.half_views import Half, completed, find_halves
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.views.captioned_views import Caption, captioned, projection_named
from gaussiancad_core.sheet.views.role_score import Drawings, arrange
from gaussiancad_core.sheet.views.sheet_layout import (
    Layout,
    ProjectionSource,
    find_clusters,
    lone_layout,
    view_clusters,
)
from gaussiancad_core.sheet.views.silhouettes import side_strips, without_stickouts


@dataclass(frozen=True)
class LayoutRequest:
    """What the user said about the views.

    Attributes:
        given: boxes that were named, in px of the upright sheet.
        projection: or nothing.
        stub_width: px; single lines up to this width that stick out of a view do not count.
        figures: whether nothing counts that sticks out of a view's filled figure.
        lone: whether the sheet may have one view alone.
        captions: texts that name views.
    """

    given: dict[Role, Box]
    projection: Projection | None
    stub_width: float = 0.0
    figures: bool = False
    lone: bool = False
    captions: tuple[Caption, ...] = ()


def find_named_layout(
    sheet: OpenedSheet, separated: SeparatedSheet, request: LayoutRequest
) -> tuple[SeparatedSheet, Layout]:
    """Find the principal views, and name what is none of them.

    A full section stands for a view where no other one shows its direction, and is left out where
    another does.  What else is hatched stays: its outline is whole.  The halves of a broken view
    are one view.  A half view is completed by its mirror image where there is room for it.

    Args:
        sheet: with all that is on it.
        separated: the same without annotations.
        request: what the user said.

    Returns:
        The sheet without annotations, but with the break lines of broken views, and the layout.

    Raises:
        NoModelError: there are fewer than two views that belong together.
        UsageError: a given box holds no ink.
    """
    clusters = view_clusters(separated.part.ink, request.stub_width, has_paper=separated.has_paper)
    if request.figures:
        separated, clusters = _figures(separated, clusters)
    breaks: list[Break] = []
    if may_be_broken(separated.part.ink, clusters):
        breaks = find_breaks(sheet.clean.ink, clusters, sheet.clean.stroke_width)
    for broken in breaks:
        separated = _restored(sheet.clean, separated, broken)
        clusters = [box for box in clusters if box not in broken.halves] + [broken.box]
    separated, clusters, halves = _completed(separated, clusters)
    hatched = separated.hatched
    cut = _sections(separated, clusters)
    layout = _arranged(clusters, cut, request, separated.part.ink)
    special = [
        SpecialView(kind, box, box in layout.boxes.values(), hatched_box(hatched, box))
        for box, kind in cut.items()
        if hatched is not None
    ]
    rest = [box for box in layout.left_out if box not in cut]
    if separated.strokes_known is not None:
        used = list(layout.boxes.values())
        width = separated.part.stroke_width
        for ring in details(separated.strokes_known, used, width):
            special.append(SpecialView(SpecialKind.DETAIL, ring))
            rest = [box for box in rest if not inside(box, ring)]
        for box in list(rest):
            kind = special_kind(separated.strokes_known, box)
            if kind is not None:
                special.append(SpecialView(kind, box))
                rest.remove(box)
    special += _askew(separated)
    for other in _other_parts(rest, layout, separated.part.ink):
        special.append(SpecialView(SpecialKind.OTHER_PART, merged(other)))
        rest = [box for box in rest if box not in other]
    whole = [broken.box for broken in breaks]
    special += [SpecialView(SpecialKind.BROKEN, box, box in layout.boxes.values()) for box in whole]
    special += [
        SpecialView(SpecialKind.HALF, half.box, whole in layout.boxes.values())
        for half, whole in halves
    ]
    whole += [box for _, box in halves]
    rest = [box for box in rest if box not in whole]
    return separated, replace(layout, left_out=tuple(rest), special=tuple(special))


def _askew(separated: SeparatedSheet) -> list[SpecialView]:
    """Pictorials and auxiliary views, told by their ink."""
    stated = separated.strokes_known
    if separated.askew is None or stated is None:
        return []
    kinds = {box: special_kind(stated, box) for box in find_clusters(separated.askew)}
    return [SpecialView(kind, box) for box, kind in kinds.items() if kind is not None]


def _figures(separated: SeparatedSheet, clusters: list[Box]) -> tuple[SeparatedSheet, list[Box]]:
    """The sheet without what sticks out of filled figures, and the boxes of these."""
    part = separated.part
    figures = without_stickouts(clusters, part.ink, part.stroke_width)
    marks = list(separated.marks)
    for cluster, figure in zip(clusters, figures, strict=True):
        for strip in side_strips(cluster, figure):
            x0, y0, x1, y1 = (int(value) for value in strip)
            kept = np.ones(part.ink.shape, dtype=bool)
            kept[y0:y1, x0:x1] = False
            if (part.ink & ~kept).any():
                part = masked(part, kept)
                marks.append(Mark(AnnotationKind.DIMENSION, strip))
    return replace(separated, part=part, marks=tuple(marks)), figures


def _completed(
    separated: SeparatedSheet, clusters: list[Box]
) -> tuple[SeparatedSheet, list[Box], list[tuple[Half, Box]]]:
    """The sheet with the mirror images of half views, the clusters with whole views instead of
    halves, and each half with the box of what stands for it now."""
    if separated.strokes_known is None:
        return separated, clusters, []
    part = separated.part
    found: list[tuple[Half, Box]] = []
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
        found.append((half, half.box if both is None else half.whole))
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


def _sections(separated: SeparatedSheet, clusters: list[Box]) -> dict[Box, SpecialKind]:
    if separated.hatched is None:
        return {}
    kinds = {box: section_kind(separated.hatched, box) for box in clusters}
    return {box: kind for box, kind in kinds.items() if kind is not None}


def _arranged(
    clusters: list[Box], cut: dict[Box, SpecialKind], request: LayoutRequest, ink: Mask
) -> Layout:
    """The views: one alone where there may be one; as captions name them; or as they agree."""
    alone = lone_layout(clusters, request.projection) if request.lone else None
    if alone is not None:
        return alone
    named = captioned(request.captions, clusters)
    if len(named) > 1:
        return _named(named, clusters, request.projection)
    full = frozenset(box for box, kind in cut.items() if kind is SpecialKind.SECTION)
    return arrange(Drawings(clusters, ink, full), request.given, request.projection)


def _named(named: dict[Role, Box], clusters: list[Box], projection: Projection | None) -> Layout:
    """The layout where captions name the views: their places tell the projection."""
    rest = tuple(box for box in clusters if box not in named.values())
    stated_projection = projection or projection_named(named)
    source: ProjectionSource = "inferred" if projection is None else "given"
    return Layout(named, stated_projection or Projection.THIRD, source, (), rest)


def _other_parts(rest: list[Box], layout: Layout, ink: Mask) -> list[list[Box]]:
    """Groups of views that belong together, and not to the part's."""
    least = 0.1 * min(_area(box) for box in layout.boxes.values())
    left = [box for box in rest if _area(box) > least]
    found = []
    while len(left) >= 2:
        try:
            other = arrange(Drawings(left, ink), {}, layout.projection)
        except NoModelError:
            break
        found.append(list(other.boxes.values()))
        left = [box for box in left if box not in found[-1]]
    return found


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])
