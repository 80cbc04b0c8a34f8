"""What each stroke of a file stands for."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import StrokeKind, StrokeRole, VectorDrawing, VectorStroke
from gaussiancad_core.sheet.file_noise import DOT
from gaussiancad_core.structure.arrowheads import Head, arrowheads
from gaussiancad_core.sheet.graph.drawn_dashes import chain_pieces, dashes
from gaussiancad_core.sheet.graph.file_pens import (
    PenEvidence,
    evidence,
    may_be_edge,
    other_layers,
    pens_of,
)
from gaussiancad_core.sheet.graph.frames_and_tables import furniture
from gaussiancad_core.sheet.graph.hatch_lines import hatch_lines, is_named_hatching
from gaussiancad_core.sheet.graph.pictorials import pictorials
from gaussiancad_core.sheet.graph.touching_ends import Flags, Ints, Touches, touching
from gaussiancad_core.sheet.picture_noise import ON_LINE
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.votes import MOST

_LIKE_A_VIEW = 0.25
"""Share of the width and height of the largest outline from which strokes in the part's pen may be
a view, whose outline is open."""

_HEAD = 24.0
"""Widths that the strokes of an arrowhead are long at most (ISO 129-1: up to ten times the wide
line's)."""

_LEAST = 3
"""Strokes of which a part's drawing consists at least."""

_MOST = 20_000
"""Strokes up to which they are looked at."""


class Label(Enum):
    """What a stroke stands for."""

    VISIBLE = "visible"
    HIDDEN = "hidden"
    CENTRE = "centre"
    HATCH = "hatch"
    FRAME = "frame"
    PICTORIAL = "pictorial"
    DIMENSION = "dimension"
    OTHER = "other"


@dataclass(frozen=True, eq=False)
class LabelledDrawing:
    """The strokes of a file, each with what it stands for.

    Attributes:
        strokes: in the file's order, without dots.
        labels: of each.
        pens: what speaks for each pen, the part's first.
        touches: of the strokes.
        doubtful: numbers of those that are no part's for their pen alone: they run from edge to
            edge, and nothing at their ends tells a dimension.
        pictorials: boxes in px.
        frame_guessed: whether the frame of a drawing in free space may as well be the part's
            outline.
    """

    strokes: tuple[VectorStroke, ...]
    labels: tuple[Label, ...]
    pens: tuple[PenEvidence, ...]
    touches: Touches
    doubtful: tuple[int, ...] = ()
    pictorials: tuple[Box, ...] = ()
    frame_guessed: bool = False

    def of(self, *labels: Label) -> tuple[VectorStroke, ...]:
        """The strokes that stand for any of some things."""
        return tuple(
            stroke
            for stroke, label in zip(self.strokes, self.labels, strict=True)
            if label in labels
        )


def labelled(
    drawing: VectorDrawing, size: tuple[int, int], heads: Sequence[Head] | None = None
) -> LabelledDrawing | None:
    """Tell what the strokes of a drawing stand for; nothing where no pen closes outlines.

    Args:
        drawing: of the sheet.
        size: its width and height in px.
        heads: the arrowheads of the drawing, where they are known.
    """
    strokes = tuple(s for s in drawing.strokes if s.curve.length >= DOT)
    lines = tuple(s for s in strokes if s.kind is not StrokeKind.FILL)
    if not _LEAST <= len(lines) <= _MOST:
        return None
    touches = touching([stroke.curve for stroke in lines], ON_LINE)
    pens, numbers = pens_of(lines)
    around = furniture(lines, drawing.texts, touches, numbers, size, has_paper=drawing.has_paper)
    framed = around.lines
    candidates = ~framed & np.array([may_be_edge(stroke) for stroke in lines], dtype=bool)
    found = evidence(lines, pens, numbers, touches, candidates)
    best = max(range(len(pens)), key=lambda number: found[number].weight)
    drawn = np.isin(numbers, [best, *other_layers(pens, numbers, best, touches, candidates)])
    centres = ~framed & np.array([_may_be_centre(stroke) for stroke in lines], dtype=bool)
    edges = _outlines(touches, candidates & drawn, centres)
    if found[best].closed < MOST or edges.sum() < _LEAST:
        return None
    other = np.isin(numbers, [n for n, evidence in enumerate(found) if evidence.closes_outlines])
    if _is_large(touches, candidates & (drawn | other) & ~edges, edges):
        return None
    askew, boxes = pictorials(lines, touches, edges)
    edges &= ~askew
    if edges.sum() < _LEAST:
        return None
    views = _views(touches, edges)
    inside = views >= 0
    named = inside & np.array([is_named_hatching(stroke) for stroke in lines], dtype=bool)
    rest = ~framed & ~edges & ~named
    chained = chain_pieces(lines, touches, rest)
    dashed = inside & dashes(lines, touches, numbers, rest & ~chained)
    hatched = named | hatch_lines(lines, touches, edges, np.where(candidates, views, -1), centres)
    labels = [Label.OTHER] * len(lines)
    for index, stroke in enumerate(lines):
        if framed[index]:
            labels[index] = Label.FRAME
        elif askew[index]:
            labels[index] = Label.PICTORIAL
        elif hatched[index]:
            labels[index] = Label.HATCH
        elif edges[index]:
            labels[index] = Label.VISIBLE
        elif stroke.role is StrokeRole.CENTRE or chained[index]:
            labels[index] = Label.CENTRE
        elif dashed[index] or (stroke.role is StrokeRole.HIDDEN and inside[index]):
            labels[index] = Label.HIDDEN
        elif stroke.is_solid:
            labels[index] = Label.DIMENSION
    heads = arrowheads(drawing.strokes) if heads is None else heads
    tips = [head.tip for head in heads]
    doubtful = _doubtful(lines, touches, labels, edges & ~hatched)
    doubtful = tuple(number for number in doubtful if not _is_pointed(touches.ends[number], tips))
    order = sorted(found, key=lambda evidence: -evidence.weight)
    stated = tuple(labels), tuple(order), touches, doubtful, boxes
    return LabelledDrawing(lines, *stated, frame_guessed=around.guessed)


def _may_be_centre(stroke: VectorStroke) -> bool:
    return stroke.role is StrokeRole.CENTRE or len(stroke.dashes) > 2


def _outlines(touches: Touches, edges: Flags, centres: Flags) -> Flags:
    """(n,) which edges belong to groups that an outline spans: cutting traces and the like are
    drawn in the same pen, and enclose nothing.

    Edges of half sections end at a centre line.
    """
    core = edges
    while True:
        left = core & (touches.closed | touches.met(core | centres).all(axis=1))
        if (left == core).all():
            break
        core = left
    groups = touches.groups(edges)
    found = np.zeros(len(edges), dtype=bool)
    for group in np.unique(groups[edges]):
        item = groups == group
        if (core & item).any():
            whole, closed = _extent(touches, item), _extent(touches, core & item)
            found |= item & bool((closed >= MOST * whole).all())
    return found


def _is_large(touches: Touches, left: Flags, edges: Flags) -> bool:
    """Whether a group of strokes that are not the part's, but may be, is as large as a view."""
    groups = touches.groups(edges)
    largest = max((_extent(touches, groups == item) for item in np.unique(groups[edges])), key=max)
    groups = touches.groups(left)
    extents = (_extent(touches, groups == item) for item in np.unique(groups[left]))
    return any(bool((extent >= _LIKE_A_VIEW * largest).all()) for extent in extents)


def _extent(touches: Touches, chosen: Flags) -> npt.NDArray[np.float64]:
    """(2,) px that some strokes are wide and high together."""
    boxes = touches.boxes[chosen]
    return boxes[:, 2:].max(axis=0) - boxes[:, :2].min(axis=0)


def _doubtful(
    strokes: Sequence[VectorStroke], touches: Touches, labels: Sequence[Label], edges: Flags
) -> tuple[int, ...]:
    """Numbers of solid strokes in other pens that run from edge to edge, without heads."""
    annotations = np.array([label is Label.DIMENSION for label in labels], dtype=bool)
    lengths = np.array([stroke.curve.length for stroke in strokes])
    widths = np.array([stroke.width or 1.0 for stroke in strokes])
    heads = annotations & (lengths < _HEAD * widths)
    headed = np.zeros(len(strokes), dtype=bool)
    headed[touches.other[heads[touches.end // 2]]] = True
    headed[touches.end[heads[touches.other]] // 2] = True
    lines = annotations & ~heads & ~headed & touches.met_by(edges).all(axis=1)
    return tuple(np.flatnonzero(lines).tolist())


def _is_pointed(ends: npt.NDArray[np.float64], tips: Sequence[tuple[float, float]]) -> bool:
    """Whether a line ends at the tip of an arrowhead."""
    if not tips:
        return False
    away = np.hypot(*np.moveaxis(ends[:, None] - np.array(tips)[None], 2, 0))
    return bool(away.min() <= ON_LINE)


def _views(touches: Touches, edges: Flags) -> Ints:
    """(n,) within the box of which group of edges that touch a stroke lies; -1 of none."""
    groups = touches.groups(edges)
    found = np.full(len(edges), -1)
    for group in np.unique(groups[edges]):
        box = touches.boxes[groups == group]
        low, high = box[:, :2].min(axis=0) - ON_LINE, box[:, 2:].max(axis=0) + ON_LINE
        inside = (touches.boxes[:, :2] >= low) & (touches.boxes[:, 2:] <= high)
        found[inside.all(axis=1)] = group
    return found
