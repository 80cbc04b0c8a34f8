"""Runs of a curve, or ends of them, that are ink of lines.

The circle that touches three sides of a small pocket has ink where it touches them, which looks
like three of its dashes.  A curve's own dash is no shorter than the line that follows it.  Where a
curve goes on as a line, so does its last dash, and the curve leaves that ink only slowly.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.geometry.whole_curves import Circle, ClosedCurve, Line
from gaussiancad_core.sheet.picture_noise import ONE_PLACE, STEP, TOUCHING
from gaussiancad_core.sheet.tracing.ink_runs import Run

_LONGER, _LONGER_PX = 1.4, 3.0
"""Length of the line's run at least, in the curve's, and px beyond that."""

_LEAVING = 1.6
"""Distance from where a line touches a circle up to which their ink is one, in that where half of
it is."""


def without_tangents(
    curve: ClosedCurve, runs: Sequence[Run], lines: Sequence[tuple[Line, Sequence[Run]]]
) -> list[Run]:
    """The runs of a curve but for those that lie along longer ones of straight lines.

    Args:
        curve: in px.
        runs: of its ink.
        lines: each with the runs of its ink.
    """
    return [run for run in runs if not any(_is_along(curve, run, *line) for line in lines)]


def _is_along(curve: ClosedCurve, run: Run, line: Line, others: Sequence[Run]) -> bool:
    count = max(2, int(np.ceil(run.length / STEP)) + 1)
    points = curve.points_at(np.linspace(run.start, run.end, count))
    if line.distances(points).max() > ONE_PLACE:
        return False
    along = line.positions(points)
    low, high = float(along.min()), float(along.max())
    least = _LONGER * run.length + _LONGER_PX
    return any(
        other.start <= low + STEP and high - STEP <= other.end and other.length >= least
        for other in others
    )


def without_tangent_ends(
    curve: ClosedCurve, run: Run, lines: Sequence[tuple[Line, Sequence[Run]]], touch: float
) -> Run:
    """A run but for what of it lies beyond the point where a line touches the curve, on that line.

    Args:
        curve: in px.
        run: of its ink.
        lines: each with the runs of its ink.
        touch: px from where a line touches the curve to where half of its ink is off it.
    """
    if not isinstance(curve, Circle):
        return run
    start, end = run.start, run.end
    for line, others in lines:
        place = _touching_place(curve, line, run)
        if place is None:
            continue
        if 0.0 < end - place <= _LEAVING * touch and _has_ink(line, others, curve, end):
            end = min(end, place)
        elif 0.0 < place - start <= _LEAVING * touch and _has_ink(line, others, curve, start):
            start = max(start, place)
    # What runs along a line all the way says nothing of the curve.
    return Run(start, end) if end - start > touch else run


def _touching_place(circle: Circle, line: Line, run: Run) -> float | None:
    """Where within a run a line touches the circle, px along it."""
    foot = line.at(float(line.positions(np.array([circle.centre]))[0]))
    away = np.subtract(foot, circle.centre)
    if abs(float(np.hypot(*away)) - circle.radius) > TOUCHING:
        return None
    beyond = (float(np.arctan2(away[1], away[0])) * circle.radius - run.start) % circle.around
    return run.start + beyond if beyond < run.length else None


def _has_ink(line: Line, others: Sequence[Run], circle: Circle, place: float) -> bool:
    """Whether a place of a circle is where a line has ink."""
    along = float(line.positions(circle.points_at(np.array([place])))[0])
    return any(other.start - STEP <= along <= other.end + STEP for other in others)
