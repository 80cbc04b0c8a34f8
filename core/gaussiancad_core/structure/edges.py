"""Which strokes are edges of the part: what closes outlines, in the pens that draw outlines.

Geometry told some strokes as annotations already, and a pen that draws many of these draws no
edges; one that closes outlines does.  Both are log-odds, and add up for each stroke.
"""

from collections import defaultdict
from math import log

import numpy as np
import shapely

from gaussiancad_core.files.vectors import StrokeRole
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import Pen
from gaussiancad_core.structure.closed_outlines import GRID, are_closed, faces_of
from gaussiancad_core.structure.dimension_lines import GOES_ON

_LONGEST_COUNTED = 30.0
"""mm up to which a stroke says more the longer it is."""

_DIMENSIONS, _ROUND = 3.0, 2.0
"""Weight of dimension and extension lines, and of closed circles, for their pen."""

_PRIOR = 0.5
"""mm that speak either way for a pen that nothing is known of."""

_PEN = 4.0
"""Log-odds by a pen, at most."""

_CLOSED, _LOOSE, _NAMED, _CURVED = -1.0, 0.7, -3.0, -0.7
"""Log-odds against an edge, of strokes that close outlines, that do not, that the file names as
visible edges, and that are round."""

_EXTENSION, _GOING_ON = 1.5, 2.5
"""Log-odds against an edge, of what was told as an extension line, and as the other half of a
dimension line."""

_NARROW = 0.8
"""Width of narrow lines in that of wide ones at most: half of it (ISO 128-2), or a step of the
series of pens."""

_ANNOTATIONS = (Label.DIMENSION, Label.EXTENSION, Label.CENTRE, Label.OTHER, Label.HATCH)


def with_edges(labelled: LabelledStrokes) -> LabelledStrokes:
    """The strokes, all of them told: visible and hidden edges, and annotations."""
    dashed = [
        number
        for number in labelled.numbers(Label.OPEN)
        if labelled.strokes[number].dashes or labelled.strokes[number].role is StrokeRole.HIDDEN
    ]
    labelled = labelled.told(dashed, Label.HIDDEN, "its dashes, or its name")
    doubtful = [
        number
        for number in labelled.numbers(Label.EXTENSION, Label.DIMENSION)
        if labelled.labels[number] is Label.EXTENSION or labelled.reasons[number] == GOES_ON
    ]
    tried = [*labelled.numbers(Label.OPEN), *doubtful]
    closed = are_closed([labelled.strokes[number] for number in tried])
    pens = _pen_odds(labelled, {n for n, shut in zip(tried, closed, strict=True) if shut})
    edges, others = [], []
    for number, is_closed in zip(tried, closed.tolist(), strict=True):
        if _against(labelled, number, pens, is_closed=is_closed) < 0.0:
            edges.append(number)
        elif labelled.labels[number] is Label.OPEN:
            others.append(number)
    labelled = labelled.told(edges, Label.EDGE, "closes outlines, or its pen does")
    narrow = _narrow(labelled)
    labelled = labelled.told(narrow, Label.OTHER, "narrower than the outlines, and on none of them")
    return labelled.told(others, Label.OTHER, "its pen draws annotations, and it closes nothing")


def _narrow(labelled: LabelledStrokes) -> list[int]:
    """Numbers of edges in pens that are narrower than that of the outlines and draw none of these:
    threads, and edges where faces meet smoothly (ISO 128-2)."""
    numbers = labelled.numbers(Label.EDGE)
    lengths: dict[float, float] = defaultdict(float)
    for number in numbers:
        lengths[labelled.strokes[number].pen.width] += labelled.strokes[number].length
    if not lengths:
        return []
    wide = max(lengths, key=lambda width: lengths[width])
    narrow = [
        number for number in numbers if 0.0 < labelled.strokes[number].pen.width <= _NARROW * wide
    ]
    if not narrow:
        return []
    enclosed = shapely.union_all(faces_of([labelled.strokes[number] for number in numbers]).faces)
    outside = enclosed.boundary.buffer(2.0 * GRID)
    shapely.prepare(outside)
    of_outlines = {
        labelled.strokes[number].pen
        for number in narrow
        if outside.contains(labelled.strokes[number].line)
    }
    return [number for number in narrow if labelled.strokes[number].pen not in of_outlines]


def _pen_odds(labelled: LabelledStrokes, closed: set[int]) -> dict[Pen, float]:
    """Log-odds against an edge by pen: what geometry told of its strokes, and how much of the
    closed outlines it draws."""
    against: dict[Pen, float] = defaultdict(lambda: _PRIOR)
    for_edges: dict[Pen, float] = defaultdict(lambda: _PRIOR)
    for number, (stroke, label) in enumerate(zip(labelled.strokes, labelled.labels, strict=True)):
        length = min(stroke.length, _LONGEST_COUNTED)
        if label in _ANNOTATIONS:
            is_dimension = label in (Label.DIMENSION, Label.EXTENSION)
            against[stroke.pen] += length * (_DIMENSIONS if is_dimension else 1.0)
        elif label is Label.OPEN and number in closed:
            for_edges[stroke.pen] += length * (_ROUND if stroke.is_round else 1.0)
    # What all pens draw together says nothing of one: a sheet of one pen has no odds by pens.
    usual = log((_PRIOR + sum(against.values())) / (_PRIOR + sum(for_edges.values())))
    pens = {*against, *for_edges}
    return {pen: log(against[pen] / for_edges[pen]) - usual for pen in pens}


def _against(
    labelled: LabelledStrokes, number: int, pens: dict[Pen, float], *, is_closed: bool
) -> float:
    """Log-odds against a stroke as an edge."""
    stroke, label = labelled.strokes[number], labelled.labels[number]
    odds = float(np.clip(pens.get(stroke.pen, 0.0), -_PEN, _PEN))
    odds += {Label.EXTENSION: _EXTENSION, Label.DIMENSION: _GOING_ON}.get(label, 0.0)
    odds += _CLOSED if is_closed else _LOOSE
    odds += _NAMED if stroke.role is StrokeRole.VISIBLE else 0.0
    return odds + (_CURVED if stroke.is_round else 0.0)
