"""The layout of a picture: which of its drawings are views, and the names of all others."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.drawn_layout import (
    chosen_views,
    empty_view_box,
    is_middle_in,
    layout_of,
    third_angle_odds,
    with_projection,
)
from gaussiancad_core.recognition.picture_drawings import PictureDrawings, picture_drawings
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.annotations.erase import masked
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.special_views.drawing_names import details, inside, special_kind
from gaussiancad_core.sheet.special_views.pieced_views import Pieced, with_whole_views
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.views.sheet_layout import (
    Layout,
    find_clusters,
    may_be_views,
    no_views,
    view_clusters,
)
from gaussiancad_core.views.role_search import Arrangement, Ranking, arranged_views
from gaussiancad_core.writing.sheet_texts import SheetText
from gaussiancad_protocol.codes import Code

_STUB = 1.8
"""Width of a line that sticks out of a view at most, in stroke widths."""

_HARDLY = 3.0
"""Log-odds by which an arrangement is hardly less likely than one with a turned view: few are."""

_LARGEST_LEFT_OUT = 10.0
"""Size of a drawing that is no view, in that of all views, at most."""


@dataclass(frozen=True)
class Stated:
    """What is said of the views.

    Attributes:
        given: boxes that the user named, px of the upright sheet.
        projection: as told by the user, or nothing.
        symbol: of the sheet, or nothing.
        texts: all that is written.
    """

    given: Mapping[Role, Box]
    projection: Projection | None
    symbol: ProjectionSymbol | None = None
    texts: tuple[SheetText, ...] = ()


@dataclass(frozen=True, eq=False)
class _Chosen:
    """Drawings, their likeliest arrangement, and how that was found."""

    drawings: PictureDrawings
    best: Arrangement
    ranking: Ranking | None


def picture_layout(
    sheet: OpenedSheet, separated: SeparatedSheet, stated: Stated
) -> tuple[SeparatedSheet, Layout]:
    """Find the principal views, and name what is none of them.

    What is left of annotations may stick out of a view and make it larger than it is: where views
    belong together better without it, it is taken off.

    Args:
        sheet: with all that is on it.
        separated: the same without annotations.
        stated: what is said of the views.

    Returns:
        The sheet without annotations, broken and half views made whole, and the layout.

    Raises:
        NoModelError: there are no views that belong together, and not one alone.
        UsageError: a given box holds no ink.
    """
    part = separated.part
    clusters = view_clusters(part.ink, _STUB * part.stroke_width, has_paper=separated.has_paper)
    pieced = with_whole_views(sheet, separated, clusters)
    separated, clusters = pieced.separated, _with_given(pieced.clusters, stated.given)
    drawings = picture_drawings(separated, clusters, stated.texts)
    chosen = _chosen(drawings, stated)
    bare = _chosen(drawings.without_loose_ends(), stated)
    if bare is not None and (chosen is None or bare.best.odds > chosen.best.odds):
        separated, chosen = _without_loose_ends(separated, clusters, bare), bare
    large = may_be_views(clusters)
    if chosen is None:
        raise no_views(large)
    boxes = chosen.drawings.boxes
    layout = layout_of(chosen.drawings.views, boxes, chosen.best, separated.hatched)
    if len(stated.given) < 2:
        _check_size(layout, large)
    layout = with_projection(layout, chosen.ranking, stated.projection, stated.symbol)
    return separated, _with_names(layout, separated, pieced)


def _with_given(clusters: Sequence[Box], given: Mapping[Role, Box]) -> list[Box]:
    """The clusters with one in each box that the user named.

    Raises:
        UsageError: a box holds none.
    """
    boxes = list(clusters)
    for role, box in given.items():
        held = [each for each in boxes if is_middle_in(each, box)]
        if not held:
            raise empty_view_box(role, box)
        boxes = [each for each in boxes if each not in held]
        low, high = np.min([each[:2] for each in held], 0), np.max([each[2:] for each in held], 0)
        boxes.append((*low.tolist(), *high.tolist()))
    return boxes


def _chosen(drawings: PictureDrawings, stated: Stated) -> _Chosen | None:
    views = drawings.views
    first = len(views) - len(stated.given)
    fixed = {first + index: role for index, role in enumerate(stated.given)}
    third = third_angle_odds(stated.projection, stated.symbol)
    ranking = arranged_views(views, third, fixed)
    best = chosen_views(views, ranking, fixed, third)
    best = _upright(best, ranking) if best is not None and ranking is not None else best
    return _Chosen(drawings, best, ranking) if best is not None else None


def _upright(best: Arrangement, ranking: Ranking) -> Arrangement | None:
    """An arrangement without turned views, which are not read: one of as many views that is hardly
    less likely, or else the best one without those that are turned."""
    for other in (best, *ranking.others):
        is_upright = not any(placed.turn for placed in other.placed.values())
        is_as_likely = other.odds >= best.odds - _HARDLY
        if is_upright and is_as_likely and len(other.placed) == len(best.placed):
            return other
    placed = {number: placed for number, placed in best.placed.items() if not placed.turn}
    return replace(best, placed=placed) if placed else None


def _without_loose_ends(
    separated: SeparatedSheet, clusters: Sequence[Box], bare: _Chosen
) -> SeparatedSheet:
    """The sheet without the ink around views that sticks out of them."""
    part, marks = separated.part, list(separated.marks)
    for number in bare.best.placed:
        for strip in _strips(clusters[number], bare.drawings.boxes[number]):
            x0, y0, x1, y1 = (int(value) for value in strip)
            kept = np.ones(part.ink.shape, dtype=bool)
            kept[y0:y1, x0:x1] = False
            if (part.ink & ~kept).any():
                part = masked(part, kept)
                marks.append(Mark(AnnotationKind.DIMENSION, strip))
    return replace(separated, part=part, marks=tuple(marks))


def _strips(cluster: Box, bare: Box) -> list[Box]:
    """The strips of a cluster's box beside a smaller one within it."""
    x0, y0, x1, y1 = cluster
    left, top, right, bottom = bare
    strips = [(x0, y0, left, y1), (right, y0, x1, y1), (x0, y0, x1, top), (x0, bottom, x1, y1)]
    return [box for box in strips if box[2] > box[0] and box[3] > box[1]]


def _check_size(layout: Layout, large: Sequence[Box]) -> None:
    """Refuse one view beside others, and slivers as views beside what is much larger.

    Raises:
        NoModelError: ``views-not-aligned``.
    """
    if len(layout.boxes) == 1 and may_be_views(layout.left_out):
        raise no_views(list(large))
    figure = max(layout.left_out, key=_area, default=None)
    size = sum(_area(box) for box in layout.boxes.values())
    if figure is not None and _area(figure) > _LARGEST_LEFT_OUT * size:
        x0, y0, x1, y1 = (round(value) for value in figure)
        raise NoModelError(
            Code.VIEWS_NOT_ALIGNED,
            "the largest figure on the sheet, from {place} px, has no aligned neighbour: name the "
            "views with --view ROLE=X0,Y0,X1,Y1",
            boxes=[figure],
            place=f"({x0}, {y0}) to ({x1}, {y1})",
        )


def _with_names(layout: Layout, separated: SeparatedSheet, pieced: Pieced) -> Layout:
    """The layout with the names of what is no view, by the directions of its lines, and of views
    that were put together."""
    used = list(layout.boxes.values())
    special, rest = list(layout.special), list(layout.left_out)
    stated = separated.strokes_known
    if stated is not None:
        for ring in details(stated, used, separated.part.stroke_width):
            special.append(SpecialView(SpecialKind.DETAIL, ring))
            rest = [box for box in rest if not inside(box, ring)]
        askew = find_clusters(separated.askew) if separated.askew is not None else []
        for box in [*rest, *askew]:
            kind = special_kind(stated, box)
            if kind is not None:
                special.append(SpecialView(kind, box))
                rest = [other for other in rest if other != box]
    for kind, box, whole in pieced.wholes:
        special.append(SpecialView(kind, box, whole in used))
        rest = [other for other in rest if other != whole]
    return replace(layout, left_out=tuple(rest), special=tuple(special))


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])
