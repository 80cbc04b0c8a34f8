"""Pictorials of a file, told by the directions of their lines before views are looked for.

They stand where there is room, often between the views and with boxes that overlap theirs.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.files.vectors import VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.graph.touching_ends import Flags, Touches
from gaussiancad_core.sheet.picture_noise import ONE_PLACE
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.drawing_names import Lines, slanted_kind
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind


def pictorials(
    strokes: Sequence[VectorStroke], touches: Touches, edges: Flags
) -> tuple[Flags, tuple[Box, ...]]:
    """(n,) which strokes are of pictorials, and the boxes of these in px.

    Args:
        strokes: of the sheet.
        touches: of the strokes.
        edges: (n,) which are the part's.  What lies within a pictorial's box goes with it.
    """
    groups = touches.groups(edges)
    found = np.zeros(len(edges), dtype=bool)
    around = {int(group): _box(touches, groups == group) for group in np.unique(groups[edges])}
    boxes: list[Box] = []
    for group, box in around.items():
        # What lies within another drawing is a part of that: a curve of many chords, say.
        if any(_lies_in(box, other) for other in around.values()):
            continue
        # A hexagon has the directions of an isometric picture, but stands in line with a view.
        if any(_is_in_line(box, other) for other in around.values()):
            continue
        item = groups == group
        if slanted_kind(_lines(strokes, item)) is SpecialKind.PICTORIAL:
            boxes.append(box)
            found |= item
    for box in boxes:
        within = (touches.boxes >= (*box[:2], *box[:2])) & (touches.boxes <= (*box[2:], *box[2:]))
        inner = groups[within.all(axis=1) & edges]
        outer = groups[~within.all(axis=1) & edges]
        found |= np.isin(groups, np.setdiff1d(inner, outer))
    return found, tuple(boxes)


def _box(touches: Touches, chosen: Flags) -> Box:
    box = touches.boxes[chosen]
    return (*box[:, :2].min(axis=0).tolist(), *box[:, 2:].max(axis=0).tolist())


def _lies_in(box: Box, other: Box) -> bool:
    starts = all(one >= two for one, two in zip(box[:2], other[:2], strict=True))
    ends = all(one <= two for one, two in zip(box[2:], other[2:], strict=True))
    return box != other and starts and ends


def _is_in_line(box: Box, other: Box) -> bool:
    """Whether two drawings begin and end at the same places of an axis of the sheet."""
    return box != other and any(
        max(abs(box[at] - other[at]), abs(box[at + 2] - other[at + 2])) <= ONE_PLACE
        for at in (0, 1)
    )


def _lines(strokes: Sequence[VectorStroke], chosen: Flags) -> Lines:
    curves = [strokes[index].curve for index in np.flatnonzero(chosen).tolist()]
    ends = np.array([(c.start, c.end) for c in curves if isinstance(c, LineSegment)]).reshape(
        -1, 2, 2
    )
    way = ends[:, 1] - ends[:, 0]
    return Lines(np.arctan2(way[:, 1], way[:, 0]) % np.pi, np.hypot(*way.T), ends)
