"""What each stroke of a file stands for."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import (
    Line,
    StrokeKind,
    StrokeRole,
    VectorDrawing,
    VectorStroke,
)
from gaussiancad_core.sheet.graph.dashes import chain_pieces, dashes
from gaussiancad_core.sheet.graph.furniture import furniture
from gaussiancad_core.sheet.graph.heads import Head, arrowheads
from gaussiancad_core.sheet.graph.pens import (
    PenEvidence,
    evidence,
    may_be_edge,
    other_layers,
    pens_of,
)
from gaussiancad_core.sheet.graph.pictorials import pictorials
from gaussiancad_core.sheet.graph.touching import Flags, Ints, Touches, touching
from gaussiancad_core.sheet.options import Box

_REACH = 0.6
"""px within which an end lies on a stroke."""

_SHORTEST = 0.05
"""px: shorter strokes are dots."""

_CLOSES = 0.6
"""Share of the part's strokes that meet others at both ends, at least: else nothing tells them."""

_OUTLINE = 0.6
"""Share of the width and height of strokes that touch which those of them span that enclose
something."""

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

_ALONG, _ROUGH, _LEAN = 1e-2, 0.05, 0.2
"""Sines of angles: up to the first, lines are parallel, up to the second short ones whose ends are
rounded; from the third, they are slanted."""

_HATCH, _IN_VIEW = 4, 2
"""Parallel lines of a hatching at least: on the sheet, and among edges that touch."""

_UNEVEN, _EVENLY = 0.15, 0.7
"""Share of the distance of neighbouring lines by which it may differ, and share of the lines that
are so evenly apart."""


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
    strokes = tuple(s for s in drawing.strokes if s.curve.length >= _SHORTEST)
    lines = tuple(s for s in strokes if s.kind is not StrokeKind.FILL)
    if not _LEAST <= len(lines) <= _MOST:
        return None
    touches = touching([stroke.curve for stroke in lines], _REACH)
    pens, numbers = pens_of(lines)
    around = furniture(lines, drawing.texts, touches, numbers, size, has_paper=drawing.has_paper)
    framed = around.lines
    candidates = ~framed & np.array([may_be_edge(stroke) for stroke in lines], dtype=bool)
    found = evidence(lines, pens, numbers, touches, candidates)
    best = max(range(len(pens)), key=lambda number: found[number].weight)
    drawn = np.isin(numbers, [best, *other_layers(pens, numbers, best, touches, candidates)])
    centres = ~framed & np.array([_may_be_centre(stroke) for stroke in lines], dtype=bool)
    edges = _outlines(touches, candidates & drawn, centres)
    if found[best].closed < _CLOSES or edges.sum() < _LEAST:
        return None
    other = np.isin(numbers, [n for n, own in enumerate(found) if own.closes_outlines])
    if _is_large(touches, candidates & (drawn | other) & ~edges, edges):
        return None
    askew, boxes = pictorials(lines, touches, edges)
    edges &= ~askew
    if edges.sum() < _LEAST:
        return None
    views = _views(touches, edges)
    inside = views >= 0
    named = inside & np.array([_is_named_hatching(stroke) for stroke in lines], dtype=bool)
    rest = ~framed & ~edges & ~named
    chained = chain_pieces(lines, touches, rest)
    dashed = inside & dashes(lines, touches, numbers, rest & ~chained)
    hatched = named | _hatching(lines, touches, edges, np.where(candidates, views, -1), centres)
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
    doubtful = tuple(own for own in doubtful if not _is_pointed(touches.ends[own], tips))
    order = sorted(found, key=lambda own: -own.weight)
    told = tuple(labels), tuple(order), touches, doubtful, boxes
    return LabelledDrawing(lines, *told, frame_guessed=around.guessed)


def _is_named_hatching(stroke: VectorStroke) -> bool:
    """Whether a file says that a stroke is hatching."""
    return stroke.kind is StrokeKind.HATCH or stroke.role is StrokeRole.HATCH


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
        own = groups == group
        if (core & own).any():
            whole, closed = _extent(touches, own), _extent(touches, core & own)
            found |= own & bool((closed >= _OUTLINE * whole).all())
    return found


def _is_large(touches: Touches, left: Flags, edges: Flags) -> bool:
    """Whether a group of strokes that are not the part's, but may be, is as large as a view."""
    groups = touches.groups(edges)
    largest = max((_extent(touches, groups == own) for own in np.unique(groups[edges])), key=max)
    groups = touches.groups(left)
    extents = (_extent(touches, groups == own) for own in np.unique(groups[left]))
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
    return bool(away.min() <= _REACH)


def _views(touches: Touches, edges: Flags) -> Ints:
    """(n,) within the box of which group of edges that touch a stroke lies; -1 of none."""
    groups = touches.groups(edges)
    found = np.full(len(edges), -1)
    for group in np.unique(groups[edges]):
        own = touches.boxes[groups == group]
        low, high = own[:, :2].min(axis=0) - _REACH, own[:, 2:].max(axis=0) + _REACH
        inside = (touches.boxes[:, :2] >= low) & (touches.boxes[:, 2:] <= high)
        found[inside.all(axis=1)] = group
    return found


def _hatching(
    strokes: Sequence[VectorStroke],
    touches: Touches,
    edges: Flags,
    views: Ints,
    centres: Flags,
) -> Flags:
    """(n,) which lines are hatching: several beside each other, slanted, parallel, from within one
    edge or centre line to within another, and, where the part's pen drew them, evenly apart.

    Args:
        strokes: of the sheet.
        touches: of the strokes.
        edges: (n,) which of them are the part's.
        views: (n,) in which view each lies that may be hatching; -1 of all others.
        centres: (n,) which strokes are centre lines.
    """
    candidates = views >= 0
    ways = np.array([_way(stroke) for stroke in strokes])
    lengths = np.hypot(*(touches.ends[:, 1] - touches.ends[:, 0]).T)
    slanted = np.abs(ways).min(axis=1) > _LEAN
    chosen = np.flatnonzero(candidates & slanted & touches.dividing_by(edges | centres))
    found = np.zeros(len(strokes), dtype=bool)
    # The longest tells the direction best: of short ones it is as rough as the file's numbers.
    for index in chosen[np.argsort(-lengths[chosen], kind="stable")]:
        if found[index]:
            continue
        across = np.array([-ways[index][1], ways[index][0]])
        aside = np.abs((touches.ends[:, 1] - touches.ends[:, 0]) @ across)
        parallel = aside < np.clip(0.5 * _REACH, _ALONG * lengths, _ROUGH * lengths)
        along = chosen[parallel[chosen]]
        # A line by itself is none, however many run its way in other views.
        along = along[np.bincount(views[along])[views[along]] >= _IN_VIEW]
        places = np.sort(touches.ends[along, 0] @ across)
        apart = np.diff(places)
        apart = apart[apart > _REACH]
        if len(apart) >= _HATCH - 1:
            steps = apart / np.median(apart)
            even = bool((np.abs(steps - np.rint(steps)) < _UNEVEN).mean() >= _EVENLY)
            found[along] |= even | ~edges[along]
            if even:
                rest = np.flatnonzero(candidates & slanted & ~found & parallel)
                kept = _between(touches, along, rest, across, float(np.median(apart)))
                found[kept] = True
    return found


def _between(
    touches: Touches,
    hatching: npt.NDArray[np.int64],
    lines: npt.NDArray[np.int64],
    across: npt.NDArray[np.float64],
    pitch: float,
) -> list[int]:
    """Those of some lines that have a line of a hatching one pitch away, or two, on either side:
    they end in a corner, and so do not run from within one edge to within another.  Edges of the
    part have hatching on one side."""
    way = np.array([across[1], -across[0]])
    places = touches.ends[hatching, 0] @ across
    spans = np.sort(touches.ends[hatching] @ way, axis=1)
    found = []
    for index in lines.tolist():
        at = float(touches.ends[index, 0] @ across)
        low, high = np.sort(touches.ends[index] @ way).tolist()
        steps = (places[(spans[:, 0] < high) & (spans[:, 1] > low)] - at) / pitch
        near = np.rint(steps[np.abs(steps - np.rint(steps)) < _UNEVEN])
        if np.isin(near, (-2, -1)).any() and np.isin(near, (1, 2)).any():
            found.append(index)
    return found


def _way(stroke: VectorStroke) -> npt.NDArray[np.float64]:
    """(2,) unit vector along a straight stroke; 0 of any other."""
    if not isinstance(stroke.curve, Line):
        return np.zeros(2)
    way = np.subtract(stroke.curve.end, stroke.curve.start)
    return way / max(stroke.curve.length, 1e-12)
