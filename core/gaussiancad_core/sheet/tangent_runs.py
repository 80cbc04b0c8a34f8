"""Runs of a curve that are the middles of longer lines.

The circle that touches three sides of a small pocket has ink where it touches them, which looks
like three of its dashes.  A curve's own dash is no shorter than the line that follows it.
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.sheet.geometry import Curve, Line
from gaussiancad_core.sheet.runs import STEP, Run

_OFF_PX = 1.0
"""Distance of such a run from the line at most."""

_LONGER, _LONGER_PX = 1.4, 3.0
"""Length of the line's run at least, in the curve's, and px beyond that."""


def without_tangents(
    curve: Curve, runs: Sequence[Run], lines: Sequence[tuple[Line, Sequence[Run]]]
) -> list[Run]:
    """The runs of a curve but for those that lie along longer ones of straight lines.

    Args:
        curve: in px.
        runs: of its ink.
        lines: each with the runs of its ink.
    """
    return [run for run in runs if not any(_is_along(curve, run, *line) for line in lines)]


def _is_along(curve: Curve, run: Run, line: Line, others: Sequence[Run]) -> bool:
    count = max(2, int(np.ceil(run.length / STEP)) + 1)
    points = curve.points_at(np.linspace(run.start, run.end, count))
    if line.distances(points).max() > _OFF_PX:
        return False
    along = line.positions(points)
    low, high = float(along.min()), float(along.max())
    least = _LONGER * run.length + _LONGER_PX
    return any(
        other.start <= low + STEP and high - STEP <= other.end and other.length >= least
        for other in others
    )
