"""Dimension lines told by their number, where a copy blurred their heads, or where these are none:
strokes across the ends, or dots.

The number stands above the middle of its line, along it (ISO 129-1), or where the line is broken
for it (ASME Y14.5), and extension lines go on beyond both of the line's ends.  An edge ends at
others: at a corner they are on one side of it.  What a leader says stands on its shoulder, a line
of its length, of which one end is free.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked import InkedShape
from gaussiancad_core.sheet.annotations.loose import is_free_end
from gaussiancad_core.sheet.annotations.marks import Mark, Mask, values_at
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.runs import Run

_LEVEL = 0.05
"""Sine of the angle between such a line and the sheet's axes at most."""

_MIDDLE = 0.15
"""Distance of the number's middle from the line's at most, as a share of the line."""

_ABOVE = -0.2, 0.8
"""Distance of the number from the line, in heights of the number: its box may touch it."""

_WITHIN = 0.4
"""Distance of the number's middle from the line that is broken for it, in heights of the number."""

_BLANK = 1.2
"""Paper on either side of such a number at most, in heights of it."""

_OVER, _UNDER = 0.8, 2.5
"""Share of a word that the shoulder below it spans at least, and heights of the word by which the
shoulder is longer at most."""

_PASSED = (1.0, 2.6)
"""px beside the ends of the line, beyond half a stroke, at which the extension lines are ink."""

_END_PX = 3.0
"""px by which the ends of a line may be off."""


def mark_lettered(
    shapes: Sequence[InkedShape],
    kinds: Kinds,
    letters: Sequence[Mark],
    ink: Mask,
    stroke_width: float,
) -> None:
    """Mark straight runs with a number above or in their middle as dimension lines, and shoulders
    of leaders, in place.

    Args:
        shapes: lines and circles of a sheet.
        kinds: what each run is known to be.
        letters: the writing of the sheet.
        ink: (h, w) bool, without it.
        stroke_width: px.
    """
    words = [mark.box for mark in letters if mark.kind is AnnotationKind.TEXT]
    for shape, own in zip(shapes, kinds, strict=True):
        line = shape.geometry
        if not isinstance(line, Line) or min(map(abs, line.direction)) > _LEVEL:
            continue
        for k, run in enumerate(shape.runs):
            numbered = own[k] is None and any(_is_above(word, line, run.run) for word in words)
            if numbered and _is_passed(line, run.run, ink, stroke_width):
                own[k] = AnnotationKind.DIMENSION
            elif own[k] is None and any(_is_under(word, line, run.run) for word in words):
                width = run.width or stroke_width
                ends = (run.run.start, -1.0), (run.run.end, 1.0)
                if any(is_free_end(line, place, way, width, ink) for place, way in ends):
                    own[k] = AnnotationKind.LEADER
        for k, (before, after) in enumerate(pairwise([run.run for run in shape.runs])):
            whole = Run(before.start, after.end)
            broken = any(_is_broken_for(word, line, before.end, after.start) for word in words)
            if broken and _is_passed(line, whole, ink, stroke_width):
                own[k] = own[k + 1] = AnnotationKind.DIMENSION


def _is_under(word: Box, line: Line, run: Run) -> bool:
    """Whether a level run is the shoulder that a word stands on."""
    if abs(line.direction[1]) > abs(line.direction[0]):
        return False
    height, width = word[3] - word[1], word[2] - word[0]
    (first, level), (last, _) = sorted((line.at(run.start), line.at(run.end)))
    shared = min(last, word[2]) - max(first, word[0])
    return (
        shared >= _OVER * width
        and last - first <= width + _UNDER * height
        and _ABOVE[0] * height <= level - word[3] <= _ABOVE[1] * height
    )


def _is_broken_for(word: Box, line: Line, start: float, end: float) -> bool:
    """Whether a word fills the blank between two positions on a level or upright line."""
    upright = int(abs(line.direction[1]) > abs(line.direction[0]))
    ends = sorted((line.at(start)[upright], line.at(end)[upright]))
    low, high = word[upright], word[upright + 2]
    height = min(word[2] - word[0], word[3] - word[1])
    middle = (word[1 - upright] + word[3 - upright]) / 2
    blank = low - ends[0], ends[1] - high
    return (
        abs(line.at(start)[1 - upright] - middle) <= _WITHIN * height
        and min(blank) > -_END_PX
        and max(blank) <= _BLANK * height
    )


def _is_above(word: Box, line: Line, run: Run) -> bool:
    """Whether a word stands along a run, right above its middle; above an upright one is left."""
    x0, y0, x1, y1 = word
    ends = np.array([line.at(run.start), line.at(run.end)])
    upright = abs(line.direction[1]) > abs(line.direction[0])
    if upright:
        # As if the sheet were turned to the right, to be read.
        x0, x1, y0, y1 = -y1, -y0, x0, x1
        ends = np.stack([-ends[:, 1], ends[:, 0]], axis=1)
    height, length = y1 - y0, abs(float(ends[1, 0] - ends[0, 0]))
    level, middle = float(ends[:, 1].mean()), float(ends[:, 0].mean())
    return (
        abs((x0 + x1) / 2 - middle) <= _MIDDLE * length
        and _ABOVE[0] * height <= level - y1 <= _ABOVE[1] * height
        and x1 - x0 < length
    )


def _is_passed(line: Line, run: Run, ink: Mask, stroke_width: float) -> bool:
    """Whether strokes across a run go on at both of its ends, on both sides of it."""
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    along = np.arange(-_END_PX, _END_PX + 1.0)
    beside = stroke_width / 2 + np.arange(*_PASSED)
    for position in (run.start, run.end):
        end = np.array(line.at(position))
        for side in (-1.0, 1.0):
            places = end + along[:, None, None] * direction + side * beside[:, None] * normal
            inked = values_at(ink, places.reshape(-1, 2)).reshape(len(along), len(beside))
            # All of the way, on some line across it.
            if not inked.all(axis=1).any():
                return False
    return True
