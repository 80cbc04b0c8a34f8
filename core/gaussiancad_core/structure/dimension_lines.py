"""Dimension lines, extension lines and leaders, told from their arrowheads outwards (ISO 129-1)."""

from collections.abc import Sequence

import numpy as np
import shapely

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.near_points import near_lists
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Points, lines_of
from gaussiancad_core.structure.arrowheads import Head

GOES_ON = "goes on from a dimension line"
"""Reason of a dimension that may be an edge all the same."""

_REACH = 0.6
"""mm around a head, beyond its length, within which its lines are looked for."""

_CROWDED = 1.1
"""Distance of a head's own lines from its tip at most, in its length."""

_ALONG, _BESIDE = 0.995, 0.25
"""Cosine of the angle between a head and its line at least, and mm between them at most."""

_STEM = 0.5
"""mm by which a line may begin before or beyond its head's base, or beyond its tip."""

_LEAST_LINE = 0.3
"""mm of a dimension line at least."""

_ON_ARC, _LEAST_RADIUS = 0.35, 3.0
"""mm by which a head's tip may lie beside the arc that it dimensions an angle along; its radius at
least."""

_AT_TIP, _SQUARE = 0.15, 0.9
"""mm from an extension line to a head's tip at most; cosine of the angle between them at most."""

_OVER, _LONGEST_OVER = 0.2, 4.5
"""mm by which an extension line goes on beyond a head's tip, at least and at most."""

_MEET = 0.06
"""mm within which ends meet."""

_CROSSROADS = 3
"""Ends that meet at one place at most, for a dimension line to go on there."""


def dimensions_apart(labelled: LabelledStrokes, heads: Sequence[Head]) -> LabelledStrokes:
    """The strokes, those of dimensions told.

    Args:
        labelled: the strokes; what was taken for text may be a dimension's.
        heads: arrowheads, mm.
    """
    if not heads:
        return labelled
    labelled = _heads_apart(labelled, heads)
    numbers = labelled.numbers(Label.OPEN, Label.TEXT)
    items = [labelled.strokes[number] for number in numbers]
    if not items:
        return labelled
    tree = shapely.STRtree(lines_of(items))
    dimensions: set[int] = set()
    extensions: set[int] = set()
    for head in heads:
        near = tree.query(shapely.Point(head.tip), "dwithin", head.length + _REACH).tolist()
        shafts = {index for index in near if _is_shaft(items[index], head)}
        dimensions |= {numbers[index] for index in shafts}
        extensions |= {
            numbers[index]
            for index in near
            if index not in shafts
            and labelled.labels[numbers[index]] is Label.OPEN
            and _is_extension(items[index], head)
        }
    labelled = labelled.with_label(sorted(dimensions), Label.DIMENSION, "at an arrowhead")
    extensions -= dimensions
    reason = "ends beyond an arrowhead's tip"
    labelled = labelled.with_label(sorted(extensions), Label.EXTENSION, reason)
    return _going_on(labelled)


def _heads_apart(labelled: LabelledStrokes, heads: Sequence[Head]) -> LabelledStrokes:
    """The strokes, those that heads are drawn of told."""
    longest = _CROWDED * max(head.length for head in heads)
    short = [
        number
        for number in labelled.numbers(Label.OPEN, Label.TEXT)
        if labelled.strokes[number].is_line and labelled.strokes[number].length <= longest
    ]
    starts = np.array([labelled.strokes[number].points[0] for number in short]).reshape(-1, 2)
    near = near_lists(starts, np.array([head.tip for head in heads]), longest)
    found = [
        number
        for number, indices in zip(short, near, strict=True)
        if any(_is_of_head(labelled.strokes[number], heads[index]) for index in indices)
    ]
    return labelled.with_label(found, Label.ARROW, "side of an arrowhead")


def _is_of_head(stroke: PaperStroke, head: Head) -> bool:
    """Whether a short line is a side of a head: both ends are corners, or one is the tip."""
    away = stroke.points - np.array(head.tip)
    along, across = away @ np.array(head.way), away @ np.array([-head.way[1], head.way[0]])
    inside = (along <= _AT_TIP) & (along >= -_CROWDED * head.length)
    is_inside = bool((inside & (np.abs(across) <= 0.5 * head.length)).all())
    ends = np.minimum(np.abs(along), np.abs(along + head.length))
    return is_inside and float(ends.max()) <= max(_AT_TIP, 0.1 * head.length)


def _is_shaft(stroke: PaperStroke, head: Head) -> bool:
    """Whether a stroke is the line or arc that a head is at the end of."""
    tip, way = np.array(head.tip), np.array(head.way)
    if stroke.is_line:
        across = np.array([-stroke.way[1], stroke.way[0]])
        if stroke.length <= _LEAST_LINE or abs(float(stroke.way @ way)) <= _ALONG:
            return False
        if abs(float((tip - stroke.points[0]) @ across)) >= _BESIDE:
            return False
        low, high = np.sort((stroke.points - tip) @ way).tolist()
        from_inside = low < -_OVER and high > -head.length - _STEM
        from_outside = high > _OVER and low < _STEM
        return from_inside or from_outside
    curve = stroke.curve
    if not isinstance(curve, CircularArc) or curve.is_closed or curve.radius <= _LEAST_RADIUS:
        return False
    away = tip - np.array(curve.centre)
    off = abs(float(np.hypot(*away)) - curve.radius)
    is_along = abs(float(way @ away)) < _LEAST_LINE * float(np.hypot(*away))
    ends = np.hypot(*(stroke.ends - tip).T).min()
    return off < _ON_ARC and is_along and bool(ends < head.length + _REACH)


def _is_extension(stroke: PaperStroke, head: Head) -> bool:
    """Whether a line passes a head's tip and ends a little beyond."""
    if not stroke.is_line:
        return False
    across = np.array([-stroke.way[1], stroke.way[0]])
    away = stroke.points - np.array(head.tip)
    if abs(float(away[0] @ across)) > _AT_TIP:
        return False
    if abs(float(stroke.way @ np.array(head.way))) > _SQUARE:
        return False
    low, high = np.sort(away @ stroke.way).tolist()
    shorter, longer = sorted((abs(low), abs(high)))
    return low <= _OVER and high >= -_OVER and _OVER < shorter < _LONGEST_OVER and longer > shorter


def _going_on(labelled: LabelledStrokes) -> LabelledStrokes:
    """The strokes, those told that go on from a dimension line: its other half beyond the number, a
    leader's shoulder."""
    numbers = [
        number
        for number in labelled.numbers(Label.OPEN, Label.DIMENSION)
        if labelled.strokes[number].is_line
    ]
    if not numbers:
        return labelled
    ends: Points = np.concatenate([labelled.strokes[number].points for number in numbers])
    near = near_lists(ends, ends, _MEET)
    todo = [i for i, number in enumerate(numbers) if labelled.labels[number] is Label.DIMENSION]
    known = set(todo)
    found = []
    while todo:
        index = todo.pop()
        pen = labelled.strokes[numbers[index]].pen
        for end in (2 * index, 2 * index + 1):
            meeting = near[end]
            if len(meeting) > _CROSSROADS:
                continue
            for other in {item // 2 for item in meeting} - known:
                if labelled.strokes[numbers[other]].pen == pen:
                    known.add(other)
                    todo.append(other)
                    found.append(numbers[other])
    return labelled.with_label(found, Label.DIMENSION, GOES_ON)
