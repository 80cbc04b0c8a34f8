"""The layout of a sheet by its drawings: where the views are, and what else is drawn."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import shapely

from gaussiancad_core.errors import UsageError
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.recognition.stroke_reading import StrokeReading
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.special_views.cut_views import hatched_box, section_kind
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet_model.labelled_strokes import Label
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.role_search import (
    Arrangement,
    Placed,
    Ranking,
    any_in_line,
    arranged_views,
)
from gaussiancad_protocol.codes import Code

_OTHER_PART, _OTHER_SIZE = 6.0, 0.1
"""Log-odds from which drawings that are left are another part's views, and their size in that of
the smallest view at least."""

_GIVEN, _SAID = 1e3, 4.0
"""Log-odds for the projection that the user says, which nothing outvotes, and for that of the
sheet's words or symbol."""

_BY_LINES = 3.0
"""Log-odds over the other projection from which the lines tell it."""

_SURE = 4.6
"""Log-odds from which views belong together that stand in line with none: a hundred to one."""

_MEETS = 0.1
"""mm within which a line ends at an edge."""

_SPECIAL = {
    DrawingKind.PICTORIAL: SpecialKind.PICTORIAL,
    DrawingKind.DETAIL: SpecialKind.DETAIL,
}


def layout_of(
    views: Sequence[DrawnView], boxes: Sequence[Box], best: Arrangement, hatched: Mask | None
) -> Layout:
    """Where the views are, px, and what else is drawn.

    Args:
        views: the drawings of the sheet.
        boxes: of each, px.
        best: the views in their roles.
        hatched: (h, w) of the sheet; None where nothing is.
    """
    named: dict[Role, Box] = {}
    special: list[SpecialView] = []
    left_out: list[Box] = []
    for number, (view, box) in enumerate(zip(views, boxes, strict=True)):
        placed = best.placed.get(number)
        if placed is not None:
            named[placed.role] = box
        kind = section_kind(hatched, box) if hatched is not None else None
        if view.kind is DrawingKind.SECTION and kind is not None and hatched is not None:
            special.append(SpecialView(kind, box, placed is not None, hatched_box(hatched, box)))
        elif placed is None and view.kind in _SPECIAL:
            special.append(SpecialView(_SPECIAL[view.kind], box))
        elif placed is None:
            left_out.append(box)
    rest = [number for number in range(len(views)) if number not in best.placed]
    least = min(views[number].area for number in best.placed)
    for group in _other_parts(views, rest, least):
        around = np.array([boxes[number] for number in group])
        merged = (*around[:, :2].min(axis=0).tolist(), *around[:, 2:].max(axis=0).tolist())
        special.append(SpecialView(SpecialKind.OTHER_PART, merged))
        gone = {boxes[number] for number in group}
        left_out = [box for box in left_out if box not in gone]
    order = sorted(named, key=list(Role).index)
    projection = best.projection
    return Layout(
        {role: named[role] for role in order},
        projection,
        "default",
        (projection.other,),
        tuple(left_out),
        tuple(special),
    )


def with_projection(
    layout: Layout,
    ranking: Ranking | None,
    stated: Projection | None,
    symbol: ProjectionSymbol | None,
) -> Layout:
    """The layout with who tells its projection, and which other one is possible.

    Args:
        layout: by which its views stand.
        ranking: of their arrangements; None where somebody named the views.
        stated: what the user says.
        symbol: of the sheet, or a note like it; corners may overrule it.
    """
    if stated is not None:
        return replace(layout, source="given", alternatives=())
    if symbol is not None:
        return replace(layout, source="inferred", symbol=symbol.projection)
    is_ranked = ranking is not None and ranking.best.projection is layout.projection
    if is_ranked and ranking is not None and ranking.other_projection >= _BY_LINES:
        return replace(layout, source="inferred")
    return layout


def third_angle_odds(
    stated: Projection | None, symbol: ProjectionSymbol | None, usual: float = 0.0
) -> float:
    """Log-odds for third angle by what the user and the sheet say.

    Args:
        stated: what the user says, which nothing outvotes.
        symbol: of the sheet, or a note like it.
        usual: log-odds where neither says anything.
    """
    if stated is not None:
        return _GIVEN if stated is Projection.THIRD else -_GIVEN
    if symbol is not None:
        return _SAID if symbol.projection is Projection.THIRD else -_SAID
    return usual


def chosen_views(
    views: Sequence[DrawnView],
    ranking: Ranking | None,
    fixed: Mapping[int, Role],
    third: float,
) -> Arrangement | None:
    """The views in their roles; nothing where the drawings tell none.

    Two and more that the user named are taken as they are.  Where no two are in line they have to
    be sure by what they show.

    Args:
        views: the drawings of the sheet.
        ranking: of their arrangements without what is fixed.
        fixed: roles that the user gave, by number.
        third: log-odds for third angle.
    """
    if len(fixed) > 1:
        placed = {number: Placed(role) for number, role in fixed.items()}
        return Arrangement(placed, Projection.FIRST if third < 0.0 else Projection.THIRD, 0.0)
    if fixed:
        ranking = arranged_views(views, third, fixed)
    if ranking is None:
        return None
    boxes = [views[number].box for number in ranking.best.placed]
    is_sure = ranking.best.odds >= _SURE or fixed
    return ranking.best if len(boxes) == 1 or is_sure or any_in_line(boxes) else None


def _other_parts(views: Sequence[DrawnView], rest: Sequence[int], least: float) -> list[list[int]]:
    """Numbers of drawings that belong together, and not to the part's."""
    left = [
        number
        for number in rest
        if views[number].kind is DrawingKind.PLAIN and views[number].area > _OTHER_SIZE * least
    ]
    found = []
    while len(left) >= 2:
        ranking = arranged_views([views[number] for number in left])
        if ranking is None or len(ranking.best.placed) < 2 or ranking.best.odds < _OTHER_PART:
            break
        found.append([left[index] for index in ranking.best.placed])
        left = [number for number in left if number not in found[-1]]
    return found


def doubtful_lines(
    reading: StrokeReading, best: Arrangement, scale: float
) -> tuple[LineSegment, ...]:
    """Lines in px that are no edges for their pen alone: within views, and from edge to edge."""
    labelled = reading.labelled
    found = []
    for number in best.placed:
        view = reading.views[number]
        frame = shapely.box(*view.box)
        edges = shapely.union_all([edge.line for edge in view.edges])
        shapely.prepare(edges)
        for stroke in labelled.of(Label.OTHER):
            if not isinstance(stroke.curve, LineSegment) or not frame.contains(stroke.line):
                continue
            if all(edges.dwithin(shapely.Point(end), _MEETS) for end in stroke.ends):
                found.append(stroke.curve.mapped(Similarity(scale)))
    return tuple(found)


def strokes_of_other_pens(
    reading: StrokeReading, best: Arrangement, scale: float
) -> tuple[Stroke, ...]:
    """Lines, arcs and ellipses in px that are no edges for their pen alone, within views."""
    frames = [shapely.box(*reading.views[number].box) for number in best.placed]
    to_px = Similarity(scale)
    found = (
        stroke.curve.mapped(to_px)
        for stroke in reading.labelled.of(Label.OTHER)
        if any(frame.contains(stroke.line) for frame in frames)
    )
    return tuple(stroke for curve in found if (stroke := _as_stroke(curve)) is not None)


def _as_stroke(curve: Curve) -> Stroke | None:
    """A visible stroke along a curve; None along one that is a chain."""
    visible = Linetype.VISIBLE
    if isinstance(curve, LineSegment):
        return Segment(curve.start, curve.end, visible)
    if isinstance(curve, CircularArc):
        return Arc(curve.centre, curve.radius, curve.start_angle, curve.sweep, visible)
    if isinstance(curve, EllipticArc):
        axes = curve.semi_major, curve.semi_minor, curve.rotation
        return Ellipse(curve.centre, *axes, curve.start, curve.sweep, visible)
    return None


def is_middle_in(box: Box, around: Box) -> bool:
    """Whether the middle of a box lies in another one."""
    x, y = (box[0] + box[2]) / 2.0, (box[1] + box[3]) / 2.0
    return around[0] <= x <= around[2] and around[1] <= y <= around[3]


def empty_view_box(role: Role, box: Box) -> UsageError:
    """Why a box, px, names no view."""
    return UsageError(
        Code.EMPTY_VIEW_BOX,
        "--view {view}: there are no lines in the box {box}",
        view=role,
        box="{:g},{:g},{:g},{:g}".format(*box),
    )


def scaled_box(box: Box, by: float) -> Box:
    """A box in another unit."""
    x0, y0, x1, y1 = box
    return x0 * by, y0 * by, x1 * by, y1 * by
