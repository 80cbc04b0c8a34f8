"""Which strokes are edges of the part: what closes outlines, in the pens that draw outlines.

Geometry told some strokes as annotations already, and a pen that draws many of these draws no
edges; one that closes outlines does.  Both are log-odds, and add up for each stroke.
"""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from math import log

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.files.vectors import StrokeRole
from gaussiancad_core.geometry.near_points import connected_groups
from gaussiancad_core.sheet_model.labelled_strokes import Flags, Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Pen, lines_of
from gaussiancad_core.structure.closed_outlines import GRID, faces_of, loose_lengths
from gaussiancad_core.structure.dimension_lines import GOES_ON

_LONGEST_COUNTED = 30.0
"""mm up to which a stroke says more the longer it is."""

_DIMENSIONS, _ROUND = 3.0, 2.0
"""Weight of dimension and extension lines, and of closed circles, for their pen."""

_PRIOR, _RAREST = 10.0, 0.1
"""mm that a pen draws as all do together before it is asked; share of annotations, or of edges, of
all that a sheet has at least."""

_PEN = 4.0
"""Log-odds by a pen, at most."""

_CLOSED, _LOOSE, _ALONE, _NAMED, _CURVED = -1.0, 0.7, 3.0, -3.0, -0.7
"""Log-odds against an edge, of strokes that close outlines, that do not, that are a few by
themselves, that the file names as visible edges, and that are round."""

_FEW, _TOUCH = 5, 0.1
"""Strokes that touch each other, and neither close nor go around anything, up to which they are a
sign, and mm within which they touch."""

_STICKING_OUT, _OUT = 0.25, 1.5
"""mm of a stroke that bound nothing from which it ends in the open, as extension and centre lines
do; log-odds of that against an edge."""

_GOING_ON = 2.5
"""Log-odds against an edge, of what was told as the other half of a dimension line."""

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
    labelled = labelled.with_label(dashed, Label.HIDDEN, "its dashes, or its name")
    doubtful = [
        number
        for number in labelled.numbers(Label.EXTENSION, Label.DIMENSION)
        if labelled.labels[number] is Label.EXTENSION or labelled.reasons[number] == GOES_ON
    ]
    tried = [*labelled.numbers(Label.OPEN), *doubtful]
    meeting = _Meeting.of([labelled.strokes[number] for number in tried])
    pens = _pen_odds(labelled, tried, meeting)
    free = _ending_off(labelled, tried, meeting)
    edges, others = [], []
    for index, number in enumerate(tried):
        odds = _against(labelled, number, pens) + float(meeting.odds[index])
        odds += _OUT if number in free else 0.0
        if odds < 0.0:
            edges.append(number)
        elif labelled.labels[number] is Label.OPEN:
            others.append(number)
    labelled = labelled.with_label(edges, Label.EDGE, "closes outlines, or its pen does")
    narrow = _narrow(labelled)
    labelled = labelled.with_label(narrow, Label.OTHER, "narrower than the outlines, on none")
    return labelled.with_label(others, Label.OTHER, "its pen draws annotations, or it is loose")


@dataclass(frozen=True, eq=False)
class _Meeting:
    """How strokes meet each other.

    Attributes:
        closed: (n,) which bound faces along most of their length.
        sticking_out: (n,) which have an end in the open.
        odds: (n,) log-odds against an edge.
    """

    closed: Flags
    sticking_out: Flags
    odds: npt.NDArray[np.float64]

    @classmethod
    def of(cls, strokes: Sequence[PaperStroke]) -> "_Meeting":
        loose = loose_lengths(strokes)
        lengths = np.array([stroke.length for stroke in strokes])
        closed = loose < 0.5 * lengths
        sticking_out = loose > _STICKING_OUT
        odds = np.where(closed, _CLOSED, _LOOSE) + np.where(sticking_out, _OUT, 0.0)
        if len(strokes):
            lines = lines_of(strokes)
            pairs = shapely.STRtree(lines).query(lines, "dwithin", _TOUCH)
            groups = connected_groups(pairs.T, len(lines))
            few = (np.bincount(groups) <= _FEW) & (np.bincount(groups, closed) == 0)
            few[_going_around(lines, groups, closed)] = False
            odds[few[groups]] = _ALONE
        return cls(closed, sticking_out, odds)


def _ending_off(labelled: LabelledStrokes, tried: Sequence[int], meeting: _Meeting) -> set[int]:
    """Numbers of extension lines that end in the open but for other such lines, as those of a row
    of dimensions do."""
    flags = zip(tried, meeting.closed, meeting.sticking_out, strict=True)
    closing, asked = [], []
    for number, is_closed, is_out in flags:
        if labelled.labels[number] is Label.EXTENSION and not is_out:
            asked.append(number)
        elif labelled.labels[number] is Label.OPEN and is_closed:
            closing.append(labelled.strokes[number].line)
    if not asked:
        return set()
    ends = np.concatenate([labelled.strokes[number].ends for number in asked])
    is_held = np.zeros(len(ends), dtype=bool)
    is_held[shapely.STRtree(closing).query(shapely.points(ends), "dwithin", _TOUCH)[0]] = True
    return {asked[index] for index in np.flatnonzero(~is_held.reshape(-1, 2).all(axis=1))}


def _going_around(
    lines: npt.NDArray[np.object_], groups: npt.NDArray[np.int64], closed: Flags
) -> npt.NDArray[np.int64]:
    """Numbers of the groups in whose boxes lines lie that bound faces."""
    sides = shapely.bounds(lines).T
    low, high = np.full((2, groups.max() + 1), np.inf), np.full((2, groups.max() + 1), -np.inf)
    for axis in range(2):
        np.minimum.at(low[axis], groups, sides[axis])
        np.maximum.at(high[axis], groups, sides[axis + 2])
    boxes = shapely.STRtree(shapely.box(*low, *high))
    return np.unique(boxes.query(lines[closed], "within")[1])


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
    enclosed = faces_of([labelled.strokes[number] for number in numbers]).outline
    thin = set(narrow)
    thick = [labelled.strokes[number].line for number in numbers if number not in thin]
    # What thin pens enclose by themselves, as a hole in a shaded picture, is no outline of a view.
    outlines = np.array(shapely.get_parts(enclosed))
    drawn = np.unique(shapely.STRtree(outlines).query(thick, "dwithin", GRID)[1])
    outside = shapely.union_all(outlines[drawn]).boundary.buffer(2.0 * GRID)
    shapely.prepare(outside)
    of_outlines = {
        labelled.strokes[number].pen
        for number in narrow
        if outside.contains(labelled.strokes[number].line)
    }
    return [number for number in narrow if labelled.strokes[number].pen not in of_outlines]


def _pen_odds(
    labelled: LabelledStrokes, tried: Sequence[int], meeting: _Meeting
) -> dict[Pen, float]:
    """Log-odds against an edge by pen: what geometry told of its strokes, which stick out of
    outlines, and how much of these it draws."""
    closed = {number for number, is_closed in zip(tried, meeting.closed, strict=True) if is_closed}
    out = {number for number, is_out in zip(tried, meeting.sticking_out, strict=True) if is_out}
    against: dict[Pen, float] = defaultdict(float)
    for_edges: dict[Pen, float] = defaultdict(float)
    for number, (stroke, label) in enumerate(zip(labelled.strokes, labelled.labels, strict=True)):
        length = min(stroke.length, _LONGEST_COUNTED)
        if label in _ANNOTATIONS:
            is_dimension = label in (Label.DIMENSION, Label.EXTENSION)
            against[stroke.pen] += length * (_DIMENSIONS if is_dimension else 1.0)
        elif label is Label.OPEN and number in out:
            against[stroke.pen] += length
        elif label is Label.OPEN and number in closed:
            for_edges[stroke.pen] += length * (_ROUND if stroke.is_round else 1.0)
    # What all pens draw together says nothing of one: a sheet of one pen has no odds by pens.
    total = sum(against.values()) + sum(for_edges.values())
    usual = float(np.clip(sum(against.values()) / max(total, 1e-9), _RAREST, 1.0 - _RAREST))
    return {
        pen: log((against[pen] + _PRIOR * usual) / (for_edges[pen] + _PRIOR * (1.0 - usual)))
        - log(usual / (1.0 - usual))
        for pen in {*against, *for_edges}
    }


def _against(labelled: LabelledStrokes, number: int, pens: dict[Pen, float]) -> float:
    """Log-odds against a stroke as an edge, but for what it meets."""
    stroke, label = labelled.strokes[number], labelled.labels[number]
    odds = float(np.clip(pens.get(stroke.pen, 0.0), -_PEN, _PEN))
    odds += _GOING_ON if label is Label.DIMENSION else 0.0
    odds += _NAMED if stroke.role is StrokeRole.VISIBLE else 0.0
    return odds + (_CURVED if stroke.is_round else 0.0)
