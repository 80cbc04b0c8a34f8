"""Lines that go on beside themselves: a step of two pixels in an edge is two edges.

The ink of either lies partly under the other's course, which would take it as its own.  Where its
centre is on the other line, it is the other's.
"""

from collections.abc import Iterator, Sequence

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import (
    FEWEST_PLACES,
    ON_LINE,
    ONE_PLACE,
    PARALLEL,
    SIDE_BY_SIDE,
)
from gaussiancad_core.sheet.tracing.ink_runs import Run
from gaussiancad_core.sheet.tracing.ink_shapes import cross_profile, refit_line
from gaussiancad_core.sheet.votes import MOST

_LEAST_AT_END = 3.0
"""px along which its ink is another's at the end of a run, at least."""

_AT_END = 2.0
"""px from the end of a run within which a stretch ends there."""

_SHORT, _TILTED = 80.0, 0.9
"""px that a run across another line is long at most; by which that leaves it at its ends."""

_SHOWN = 0.3
"""Share of such a run's px at which the centre of the ink is known: where it leaves the line the
ink reaches out of what is looked at, and at its ends others meet it."""

_AT_ENDS = 2
"""Places at either end that may lie off a straight course."""

_LONG, _SLANTED, _OFF_COURSE, _EVEN = 30.0, 0.05, 0.6, 0.25
"""px of a run that tells its course; sine of a slant to the sheet's axes; px by which it is off
another's, and by which it differs from that on the mean."""

_FORETOLD = 5.0
"""Its lengths along which the course of a run is known."""


def without_offset_ink(
    sheet: CleanSheet, line: Line, runs: Sequence[Run], others: Sequence[Line]
) -> list[Run]:
    """The runs of a line without what has another line's ink: stretches that follow one beside it,
    and short runs across one at a small angle.

    Args:
        sheet: the ink.
        line: px.
        runs: in order along it.
        others: lines of the same view.
    """
    runs = [run for run in runs if not _is_across(sheet, line, run, others)]
    lines = [other for other in others if other != line and _runs_along(line, other, runs, sheet)]
    if not lines:
        return list(runs)
    return [part for run in runs for part in _parts(sheet, line, run, lines)]


def runs_along(sheet: CleanSheet, line: Line, runs: Sequence[Run]) -> list[Run]:
    """The runs that a line is fitted to: not short ones whose ink goes straight across it, as long
    as most of the ink is left.

    Args:
        sheet: the ink.
        line: px.
        runs: in order along it.
    """
    kept = [run for run in runs if _crossed(sheet, line, run) is None]
    length = sum(run.length for run in kept)
    return kept if 2.0 * length > sum(run.length for run in runs) else list(runs)


def parted_slants(sheet: CleanSheet, line: Line, runs: Sequence[Run]) -> list[list[Run]]:
    """The runs of a slanted line by the course of their ink: of two slants a px off one course each
    is fitted to its own.  What is too short to tell is with the longest run.

    Args:
        sheet: the ink.
        line: px.
        runs: in order along it.
    """
    long = [run for run in runs if run.length > _LONG]
    if len(long) < 2 or min(np.abs(line.direction)) < _SLANTED:
        return [list(runs)]
    leader = max(long, key=lambda run: run.length)
    this_refit_line = refit_line(sheet, line, [(leader.start, leader.end)])
    others = [
        run
        for run in long
        if run is not leader
        and abs(run.start + run.end - leader.start - leader.end) < 2.0 * _FORETOLD * leader.length
        and (_is_off(sheet, this_refit_line, run) or _is_beyond(sheet, line, this_refit_line, run))
    ]
    return [[run for run in runs if run not in others], others] if others else [list(runs)]


def _is_off(sheet: CleanSheet, line: Line, run: Run) -> bool:
    """Whether the ink along all of a run is as far beside a line."""
    off = cross_profile(sheet, line, [(run.start, run.end)])[1]
    if len(off) < MOST * run.length:
        return False
    middle = float(np.median(off))
    return abs(middle) > _OFF_COURSE and float(np.abs(off - middle).mean()) < _EVEN


def _is_beyond(sheet: CleanSheet, line: Line, this_line: Line, run: Run) -> bool:
    """Whether a run is on a line, but as far beside another that its ink is not seen from there."""
    ends = line.points_at(np.array([run.start, run.end]))
    seen = len(cross_profile(sheet, line, [(run.start, run.end)])[1]) > MOST * run.length
    return seen and bool((this_line.distances(ends) > 2.0 * _OFF_COURSE).all())


def lines_across(
    sheet: CleanSheet, line: Line, runs: Sequence[Run], others: Sequence[Line]
) -> list[Line]:
    """Lines that a line crosses at a small angle, and that none of the others is: a line through
    the place where a slant meets an edge takes the edge's ink for its own.

    Args:
        sheet: the ink.
        line: px.
        runs: in order along it.
        others: lines of the same view.
    """
    found = []
    for run in runs:
        crossed = _crossed(sheet, line, run)
        if crossed is None or any(_is_upon(other, crossed) for other in others):
            continue
        middle = crossed.mean(axis=0)
        way = np.linalg.svd(crossed - middle)[2][0]
        found.append(Line((float(middle[0]), float(middle[1])), (float(way[0]), float(way[1]))))
    return found


def _is_across(sheet: CleanSheet, line: Line, run: Run, others: Sequence[Line]) -> bool:
    """Whether a run is where a line crosses another one at a small angle."""
    crossed = _crossed(sheet, line, run)
    return crossed is not None and any(
        other != line and _is_upon(other, crossed) for other in others
    )


def _crossed(sheet: CleanSheet, line: Line, run: Run) -> npt.NDArray[np.float64] | None:
    """(n, 2) px of the ink's centre where a short run is straight across the line, if it is."""
    if run.length > _SHORT or run.length < _LEAST_AT_END:
        return None
    at, off = cross_profile(sheet, line, [(run.start, run.end)])
    if len(at) < max(FEWEST_PLACES, _SHOWN * run.length):
        return None
    # At its ends others meet it.
    inner = (
        slice(_AT_ENDS, len(at) - _AT_ENDS)
        if len(at) >= FEWEST_PLACES + 2 * _AT_ENDS
        else slice(None)
    )
    slope, shift = np.polyfit(at[inner], off[inner], 1)
    straight = np.abs(off - slope * at - shift) < ON_LINE
    if not straight[inner].all():
        return None
    if abs(slope) * run.length / 2.0 < _TILTED:
        return None
    at, off = at[straight], off[straight]
    normal = np.array([-line.direction[1], line.direction[0]])
    return line.points_at(at) + off[:, None] * normal


def _is_upon(line: Line, points: npt.NDArray[np.float64]) -> bool:
    """Whether all of (n, 2) points are on a line."""
    return float(line.distances(points).max()) < ON_LINE


def _runs_along(line: Line, other: Line, runs: Sequence[Run], sheet: CleanSheet) -> bool:
    if abs(float(np.dot(line.direction, other.direction))) < np.cos(PARALLEL) or not runs:
        return False
    ends = line.points_at(np.array([runs[0].start, runs[-1].end]))
    return bool(other.distances(ends).min() < sheet.stroke_width + ONE_PLACE)


def _parts(sheet: CleanSheet, line: Line, run: Run, lines: Sequence[Line]) -> Iterator[Run]:
    """What is left of a run."""
    along = np.arange(run.start, run.end + 0.5)
    points = line.points_at(along)
    foreign = np.zeros(len(along), dtype=bool)
    for other in lines:
        apart = other.distances(points) > ONE_PLACE
        foreign |= apart & _is_followed(sheet, other, other.positions(points))
    if foreign.any():
        foreign &= ~_is_followed(sheet, line, along)
    start = run.start
    for first, last in _stretches(along, foreign, (run.start, run.end)):
        if first - start > SIDE_BY_SIDE:
            yield Run(start, first)
        start = last
    if start == run.start or run.end - start > SIDE_BY_SIDE:
        yield Run(start, run.end)


def _is_followed(
    sheet: CleanSheet, line: Line, along: npt.NDArray[np.float64]
) -> npt.NDArray[np.bool_]:
    """(n,) whether the ink's centre is on a line, at positions about every px along it."""
    places, off = cross_profile(sheet, line, [(float(along.min()), float(along.max()))])
    upon = places[np.abs(off) < ON_LINE]
    if not len(upon):
        return np.zeros(len(along), dtype=bool)
    after = np.clip(np.searchsorted(upon, along), 1, max(len(upon) - 1, 1))
    pair = upon[np.clip([after - 1, after], 0, len(upon) - 1)]
    return np.abs(pair - along).min(0) < 1.0


def _stretches(
    along: npt.NDArray[np.float64], flags: npt.NDArray[np.bool_], ends: tuple[float, float]
) -> Iterator[tuple[float, float]]:
    """First and last position of long stretches, which single places in doubt do not part, and of
    short ones at the ends."""
    places = along[flags]
    if not len(places):
        return
    for values in np.split(places, np.flatnonzero(np.diff(places) > SIDE_BY_SIDE / 2) + 1):
        first, last = float(values[0]), float(values[-1])
        at_end = first - ends[0] < _AT_END or ends[1] - last < _AT_END
        least = _LEAST_AT_END if at_end else SIDE_BY_SIDE
        if last - first >= least and len(values) > MOST * (last - first):
            yield first, last
