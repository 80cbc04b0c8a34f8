"""The layout of a sheet by its strokes: where the views are, and what else is drawn."""

from collections.abc import Sequence

import numpy as np
import shapely

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.model.axes import Role
from gaussiancad_core.recognition.stroke_reading import StrokeReading
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.special_views.cut_views import hatched_box, section_kind
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind, SpecialView
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet_model.labelled_strokes import Label
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.role_search import Arrangement, arranged_views

_OTHER_PART, _OTHER_SIZE = 6.0, 0.1
"""Log-odds from which drawings that are left are another part's views, and their size in that of
the smallest view at least."""

_MEETS = 0.1
"""mm within which a line ends at an edge."""

_SPECIAL = {
    DrawingKind.PICTORIAL: SpecialKind.PICTORIAL,
    DrawingKind.DETAIL: SpecialKind.DETAIL,
}


def layout_of(
    reading: StrokeReading, best: Arrangement, hatched: Mask | None, scale: float
) -> Layout:
    """Where the views are, px, and what else is drawn.

    Args:
        reading: of the file.
        best: its views in their roles.
        hatched: (h, w) of the sheet; None where nothing is.
        scale: px per mm.
    """
    boxes: dict[Role, Box] = {}
    special: list[SpecialView] = []
    left_out: list[Box] = []
    for number, view in enumerate(reading.views):
        box = scaled_box(view.box, scale)
        placed = best.placed.get(number)
        if placed is not None:
            boxes[placed.role] = box
        kind = section_kind(hatched, box) if hatched is not None else None
        if view.kind is DrawingKind.SECTION and kind is not None and hatched is not None:
            special.append(SpecialView(kind, box, placed is not None, hatched_box(hatched, box)))
        elif placed is None and view.kind in _SPECIAL:
            special.append(SpecialView(_SPECIAL[view.kind], box))
        elif placed is None:
            left_out.append(box)
    rest = [view for n, view in enumerate(reading.views) if n not in best.placed]
    others = _other_parts(rest, min(view.area for view in _views(reading, best)))
    for group in others:
        around = np.array([scaled_box(view.box, scale) for view in group])
        merged = (*around[:, :2].min(axis=0).tolist(), *around[:, 2:].max(axis=0).tolist())
        special.append(SpecialView(SpecialKind.OTHER_PART, merged))
        gone = {scaled_box(view.box, scale) for view in group}
        left_out = [box for box in left_out if box not in gone]
    order = sorted(boxes, key=list(Role).index)
    projection = best.projection
    return Layout(
        {role: boxes[role] for role in order},
        projection,
        "default",
        (projection.other,),
        tuple(left_out),
        tuple(special),
    )


def _views(reading: StrokeReading, best: Arrangement) -> list[DrawnView]:
    return [reading.views[number] for number in best.placed]


def _other_parts(rest: Sequence[DrawnView], least: float) -> list[list[DrawnView]]:
    """Groups of drawings that belong together, and not to the part's."""
    left = [
        view for view in rest if view.kind is DrawingKind.PLAIN and view.area > _OTHER_SIZE * least
    ]
    found = []
    while len(left) >= 2:
        ranking = arranged_views(left)
        if ranking is None or len(ranking.best.placed) < 2 or ranking.best.odds < _OTHER_PART:
            break
        found.append([left[number] for number in ranking.best.placed])
        left = [view for n, view in enumerate(left) if n not in ranking.best.placed]
    return found


def doubtful_lines(reading: StrokeReading, best: Arrangement, scale: float) -> tuple[Box, ...]:
    """Boxes in px of lines that are no edges for their pen alone: within views, and from edge to
    edge."""
    labelled = reading.labelled
    found = []
    for view in _views(reading, best):
        frame = shapely.box(*view.box)
        edges = shapely.union_all([edge.line for edge in view.edges])
        shapely.prepare(edges)
        for stroke in labelled.of(Label.OTHER):
            if not stroke.is_line or not frame.contains(stroke.line):
                continue
            if all(edges.dwithin(shapely.Point(end), _MEETS) for end in stroke.ends):
                found.append(scaled_box(stroke.box, scale))
    return tuple(found)


def scaled_box(box: Box, by: float) -> Box:
    """A box in another unit."""
    x0, y0, x1, y1 = box
    return x0 * by, y0 * by, x1 * by, y1 * by
