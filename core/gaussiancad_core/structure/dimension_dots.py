"""Dots in place of arrowheads, where a dimension has no room for these (ISO 129-1).

A dot is a filled polygon, which programs write as triangles, at which a dimension line ends and
through which an extension line passes.  An empty circle is a hole, with its centre lines.
"""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.geometry.near_points import connected_groups, near_pairs
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Points
from gaussiancad_core.structure.arrowheads import Head

_RADII = (0.2, 0.8)
"""mm of a dot's radius."""

_ROUND, _FEWEST_CORNERS = 0.1, 5
"""Share of a polygon's radius by which its corners may lie off its circle, and how many it has."""

_MEET = 0.02
"""mm within which the corners of triangles are one."""

_AT = 0.1
"""mm by which a line may end off a dot's rim or its middle, and pass its middle."""

_SQUARE = 0.5
"""Cosine of the angle between a dimension line and its extension line at most."""


@dataclass(frozen=True, eq=False)
class _Dot:
    """A dot: numbers of its strokes, its middle and its radius, mm."""

    numbers: list[int]
    middle: Points
    radius: float


def dots_apart(labelled: LabelledStrokes) -> tuple[LabelledStrokes, list[Head]]:
    """The strokes, those of dots at the ends of dimension lines told, and the dots as the heads of
    these lines."""
    dots = list(_dots(labelled))
    of_dots = {number for dot in dots for number in dot.numbers}
    lines = [
        stroke
        for number in labelled.numbers(Label.OPEN)
        if number not in of_dots and (stroke := labelled.strokes[number]).is_line
    ]
    if not dots or not lines:
        return labelled, []
    starts = np.array([line.points[0] for line in lines])
    ways = np.array([line.way for line in lines])
    lengths = np.array([line.length for line in lines])
    found, heads = [], []
    for dot in dots:
        away = dot.middle - starts
        along = (away * ways).sum(axis=1)
        is_on = np.abs(away[:, 0] * ways[:, 1] - away[:, 1] * ways[:, 0]) <= _AT
        # (2, m) mm from the middle to both ends of each line, outwards.
        out = np.stack([-along, along - lengths])
        is_rim = np.minimum(np.abs(out - dot.radius), np.abs(out)) <= _AT
        ending = np.flatnonzero(is_on & is_rim.any(axis=0) & (lengths > 2.0 * dot.radius))
        passing = np.flatnonzero(is_on & (out < -dot.radius).all(axis=0))
        if any((np.abs(ways[passing] @ ways[end]) < _SQUARE).any() for end in ending):
            found += dot.numbers
            for end in ending:
                sign = 1.0 if is_rim[1, end] else -1.0
                x, y = (sign * ways[end]).tolist()
                heads.append(Head((float(dot.middle[0]), float(dot.middle[1])), (x, y), dot.radius))
    return labelled.with_label(found, Label.ARROW, "dot at the end of a dimension line"), heads


def _dots(labelled: LabelledStrokes) -> Iterator[_Dot]:
    """Groups of short lines that meet in corners of one regular polygon, and cross it."""
    numbers = [
        number
        for number in labelled.numbers(Label.OPEN, Label.TEXT)
        if _is_short(labelled.strokes[number])
    ]
    if len(numbers) < _FEWEST_CORNERS:
        return
    ends = np.concatenate([labelled.strokes[number].points for number in numbers])
    pairs = near_pairs(ends, _MEET) // 2
    members = defaultdict(list)
    groups = connected_groups(pairs, len(numbers)).tolist()
    for index, group in enumerate(groups):
        members[group].append(index)
    for held in members.values():
        if len(held) < _FEWEST_CORNERS:
            continue
        corners = ends.reshape(-1, 2, 2)[held].reshape(-1, 2)
        low, high = corners.min(axis=0), corners.max(axis=0)
        middle = (low + high) / 2.0
        away = np.hypot(*(corners - middle).T)
        radius = float(away.mean())
        is_round = np.abs(away - radius).max() <= _ROUND * radius
        if not is_round or not _RADII[0] <= radius <= _RADII[1]:
            continue
        places = np.unique(np.round((corners - low) / _MEET), axis=0)
        if _FEWEST_CORNERS <= len(places) < len(held):
            yield _Dot([numbers[index] for index in held], middle, radius)


def _is_short(stroke: PaperStroke) -> bool:
    return stroke.is_line and stroke.length <= 2.0 * (1.0 + _ROUND) * _RADII[1]
