"""Where curves end that stand for strokes, and the lines that end there with them.

A stroke that was fitted to a curve of intersection leaves it most at its ends.  Once the curve is
known, the corner lies where it ends, and the other line there goes on, or not as far.  Two strokes
that follow one curve may overlap: then one of them ends where the other begins.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import hypot

import numpy as np
import numpy.typing as npt

from gaussiancad_core.coordinates.point_chains import chain_distances
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.views import Segment

_ENDS, _BESIDE = 3.0, 0.5
"""Tolerances by which the end of a curve moves a corner, along the other line there and beside it,
at most."""

_LEAVES = 0.05
"""Links within which two curves are one."""

Points = npt.NDArray[np.float64]
"""(n, 2) mm in a view."""


def with_common_ends(
    strokes: Sequence[DrawnStroke], curves: Sequence[DrawnStroke], tolerance: float
) -> Iterator[DrawnStroke]:
    """Curves and strokes that end where each other end, none twice.

    Args:
        strokes: of a view, mm.
        curves: in their places: a curve that a stroke follows, or the stroke itself.
        tolerance: mm by which strokes may miss where they belong.
    """
    moved = [
        (drawn, curve)
        for drawn, curve in zip(strokes, curves, strict=True)
        if drawn is not curve and isinstance(curve, Polyline)
    ]
    taken: list[Points] = []
    for stroke, curve in zip(strokes, curves, strict=True):
        if isinstance(curve, Segment):
            yield _ended(curve, moved, tolerance)
        elif stroke is curve or not isinstance(curve, Polyline):
            yield curve
        else:
            points = np.array(curve.points)
            for other in taken:
                points = _without(points, other)
            if len(points) > 1:
                taken.append(points)
                yield Polyline(tuple(map(tuple, points.tolist())), curve.linetype)


def _ended(
    stroke: Segment, moved: Sequence[tuple[DrawnStroke, Polyline]], tolerance: float
) -> Segment:
    """A line that ended where strokes did, led to where the curves end that they became."""
    ends = [stroke.start, stroke.end]
    for drawn, curve in moved:
        read = drawn.sample(drawn.length)[[0, -1]]
        led = np.array([curve.points[0], curve.points[-1]])
        for place, end in enumerate(ends):
            item = read[_nearest(read, end)]
            if hypot(*(item - end)) <= tolerance:
                target = led[_nearest(led, item)]
                ends[place] = _led(ends[1 - place], end, target, tolerance) or end
    return replace(stroke, start=ends[0], end=ends[1])


def _nearest(points: Points, to: Sequence[float] | Points) -> int:
    return int(np.hypot(*(points - np.array(to)).T).argmin())


def _led(start: Point, end: Point, target: Points, tolerance: float) -> Point | None:
    """The end of a line beside a point that it nearly goes to; None if it does not."""
    length = hypot(*np.subtract(end, start))
    if length <= tolerance:
        return None
    way = np.subtract(end, start) / length
    foot = start + way * float((target - start) @ way)
    far = hypot(*(target - np.array(end))) > _ENDS * tolerance
    if far or hypot(*(target - foot)) > _BESIDE * tolerance:
        return None
    return float(foot[0]), float(foot[1])


def _without(points: Points, other: Points) -> Points:
    """The longest run of a curve's points that do not lie on another, from where that ends on."""
    if not len(points):
        return points
    step = np.hypot(*np.diff(points, axis=0).T).max(initial=0.0)
    off = np.flatnonzero(chain_distances(other, points) > _LEAVES * step)
    if len(off) in (0, len(points)):
        return points[off]
    run = max(np.split(off, np.flatnonzero(np.diff(off) > 1) + 1), key=len)
    first, last = max(run[0] - 1, 0), min(run[-1] + 1, len(points) - 1)
    left = points[first : last + 1].copy()
    ends = other[[0, -1]]
    for place, end in ((0, first), (-1, last)):
        if end not in run:
            left[place] = ends[_nearest(ends, left[place])]
    return left
