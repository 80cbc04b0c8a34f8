"""Centre lines by their dashes or names, and the small crosses at the middles of circles."""

from collections import defaultdict
from itertools import combinations

import numpy as np

from gaussiancad_core.files.file_linetypes import role_by_dashes
from gaussiancad_core.files.vectors import StrokeKind, StrokeRole
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.near_points import near_lists
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke

_LONGEST = 60.0
"""mm of a line of a cross at most."""

_AT_MIDDLE = 0.06
"""mm between the middles of a circle and of a line of its cross."""

_SQUARE, _ALIKE, _ALIKE_BESIDES = 0.02, 0.15, 0.1
"""Cosine of the angle between both lines at most; share of their length, and mm, by which that may
differ."""

_ONE_DASH = 2
"""Lengths of a pattern of dashes of one length."""


def centre_lines_apart(labelled: LabelledStrokes) -> LabelledStrokes:
    """The strokes, centre lines told, and what the file names as something else than the part."""
    named, others = [], []
    for number in labelled.numbers(Label.OPEN):
        stroke = labelled.strokes[number]
        if _role(stroke) is StrokeRole.CENTRE:
            named.append(number)
        elif _role(stroke) is StrokeRole.OTHER or stroke.kind in (
            StrokeKind.DIMENSION,
            StrokeKind.LEADER,
        ):
            others.append(number)
    labelled = labelled.with_label(named, Label.CENTRE, "its dashes, or its name")
    labelled = labelled.with_label(others, Label.OTHER, "its name, or a dimension of the file")
    return labelled.with_label(_crosses(labelled), Label.CENTRE, "cross at the middle of a circle")


def _role(stroke: PaperStroke) -> StrokeRole:
    """What a stroke's name says, or else its dashes."""
    is_named = stroke.role is not StrokeRole.UNKNOWN or len(stroke.dashes) <= _ONE_DASH
    return stroke.role if is_named else role_by_dashes(stroke.dashes)


def _crosses(labelled: LabelledStrokes) -> list[int]:
    """Numbers of lines of which two cross square at the middle of a circle, which is theirs."""
    numbers = labelled.numbers(Label.OPEN)
    middles = np.array(
        [
            curve.centre
            for number in numbers
            if isinstance(curve := labelled.strokes[number].curve, CircularArc)
        ]
    )
    lines = [
        number
        for number in numbers
        if labelled.strokes[number].is_line and labelled.strokes[number].length <= _LONGEST
    ]
    if not len(middles) or not lines:
        return []
    places = np.array([labelled.strokes[number].points.mean(axis=0) for number in lines])
    at_middle = defaultdict(list)
    for number, place, near in zip(
        lines, places, near_lists(places, middles, _AT_MIDDLE), strict=True
    ):
        if near:
            nearest = middles[near][np.argmin(np.hypot(*(middles[near] - place).T))]
            at_middle[tuple(np.round(nearest, 1).tolist())].append(number)
    found = set()
    for marks in at_middle.values():
        for one, other in combinations(marks, 2):
            first, second = labelled.strokes[one], labelled.strokes[other]
            apart = abs(first.length - second.length)
            if abs(float(first.way @ second.way)) < _SQUARE and (
                apart < _ALIKE * first.length + _ALIKE_BESIDES
            ):
                found |= {one, other}
    return sorted(found)
