"""Sharp tips of an outline: two lines that end in each other at a small angle.

The ink of both merges long before it ends, so that paper lies on both sides of either.  That is so
of extension lines as well; but these do not end in each other.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from gaussiancad_core.sheet.annotations.inked import InkedShape
from gaussiancad_core.sheet.geometry import Line

_SHARPEST, _BLUNTEST = np.sin(np.radians([4.0, 40.0]))
"""Sines of the angles of such tips."""

_NEAR = 1.5
"""Widths of a line between the ends of both."""

_BESIDE_PX = 4.0
"""px between two lines, beside the width of one, up to which it is not known what lies there."""

_LEAST = 2.0
"""Times that length that a line of a tip is long at least."""


class Tip(NamedTuple):
    """A line's end in another one.

    Attributes:
        at: position of the end along the line, px.
        reach: px from there up to which both lines' ink, or what is beside it, is the same.
    """

    at: float
    reach: float


def sharp_tips(shapes: Sequence[InkedShape]) -> dict[tuple[int, int], list[Tip]]:
    """The tips at ends of runs, by the numbers of the shape and of the run."""
    ends: list[tuple[int, int, float]] = []
    points, ways, widths, lengths = [], [], [], []
    for number, shape in enumerate(shapes):
        line = shape.geometry
        if not isinstance(line, Line):
            continue
        for k, run in enumerate(shape.runs):
            for at, way in ((run.run.start, -1.0), (run.run.end, 1.0)):
                ends.append((number, k, at))
                points.append(line.at(at))
                ways.append(way * np.array(line.direction))
                widths.append(run.width or 2.0)
                lengths.append(run.run.length)
    found: dict[tuple[int, int], list[Tip]] = {}
    if len(ends) < 2:
        return found
    place, way = np.array(points), np.array(ways)
    width, length = np.array(widths), np.array(lengths)
    for one, (number, k, at) in enumerate(ends):
        cosine = way @ way[one]
        sine = np.abs(way[:, 0] * way[one, 1] - way[:, 1] * way[one, 0])
        near = np.hypot(*(place - place[one]).T) <= _NEAR * width[one]
        reach = (width[one] + _BESIDE_PX) / np.maximum(sine, _SHARPEST)
        whole = np.minimum(length, length[one]) >= _LEAST * reach
        tips = near & (cosine > 0.0) & (sine >= _SHARPEST) & (sine <= _BLUNTEST) & whole
        if tips.any():
            found.setdefault((number, k), []).append(Tip(at, float(reach[tips].max())))
    return found
