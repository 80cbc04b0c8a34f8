"""Dashes that a slanted line only seems to have: where it would go on, it crosses dashed lines.

At a small angle it runs along a dash for its whole length, far beyond where it ends itself.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.geometry.whole_curves import Line, WholeCurve
from gaussiancad_core.sheet.dash_noise import LIKE_A_DASH, ROW
from gaussiancad_core.sheet.picture_noise import ASLANT
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run

_MOST_SINE = 0.6
"""Sine of the angle between two lines that share a dash: more is clearly across."""

_LONGEST = 2.5
"""Extent of what a slanted line has of lines that it crosses at most, in dashes and gaps."""

_FAR = 2.0
"""Gap to what the line has itself at least, in the sheet's."""

_NEAR, _TOUCHED = 0.5, 1.0
"""Distance of a run's middle from the line whose dash it is at most, in stroke widths; the same of
a run shorter than a stroke is wide, where a dash was just touched."""

Dashed = tuple[Line, Sequence[Run]]
"""A line and those of its runs that are as long as dashes."""


def unshared_runs(
    geometry: WholeCurve,
    runs: Sequence[Run],
    lines: Sequence[tuple[Line, Sequence[Run]]],
    rhythm: Rhythm,
    stroke_width: float,
) -> list[Run]:
    """The runs of a shape without dashes of other lines that it crosses at a small angle.

    Args:
        geometry: of the shape.
        runs: its ink, in order.
        lines: all lines with their ink.
        rhythm: of the sheet's dashes.
        stroke_width: px.
    """
    if not isinstance(geometry, Line):
        return list(runs)
    groups = _groups(runs, _FAR * rhythm.gap)
    most = _LONGEST * (rhythm.dash + rhythm.gap)
    short = [group for group in groups if group[-1].end - group[0].start <= most]
    if not short or len(groups) < 2:
        return list(runs)
    crossed = [
        (line, [run for run in other if _is_like(run.length, rhythm.dash)])
        for line, other in lines
        if ASLANT < _sine(line, geometry) < _MOST_SINE
    ]
    crossed = [pair for pair in crossed if len(pair[1]) >= ROW]

    def is_borrowed(run: Run) -> bool:
        points = geometry.points_at(np.array([run.start, run.end]))
        near = stroke_width * (_NEAR if run.length > stroke_width else _TOUCHED)
        return any(_has(dashed, points, rhythm.gap, near) for dashed in crossed)

    gone = [group for group in short if all(map(is_borrowed, group))]
    return [run for group in groups if group not in gone for run in group]


def _sine(one: Line, other: Line) -> float:
    (ax, ay), (bx, by) = one.direction, other.direction
    return abs(ax * by - ay * bx)


def _is_like(length: float, usual: float) -> bool:
    return abs(length - usual) <= LIKE_A_DASH * usual


def _groups(runs: Sequence[Run], far: float) -> list[list[Run]]:
    """Runs with smaller gaps between them than that."""
    groups: list[list[Run]] = []
    for run in runs:
        if groups and run.start - groups[-1][-1].end <= far:
            groups[-1].append(run)
        else:
            groups.append([run])
    return groups


def _has(dashed: Dashed, ends: np.ndarray, gap: float, near: float) -> bool:
    """Whether ink between two points is of one of a line's dashes that another one follows."""
    line, dashes = dashed
    along, across = line.coordinates(ends)
    if abs(float(across.mean())) > near:
        return False
    low, high = float(along.min()), float(along.max())
    return any(
        dash is not other and _is_like(max(dash.start - other.end, other.start - dash.end), gap)
        for dash in dashes
        if dash.start < high and dash.end > low
        for other in dashes
    )
