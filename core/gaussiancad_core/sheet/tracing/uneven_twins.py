"""Two hidden lines so close beside each other that their dashes fill each other's gaps.

Drawn out of step, their ink is one stroke without a gap, as long as a visible line.  But it goes to
and fro: where one line has a gap the ink is as wide as one dash and lies to the other's side, and
where both have dashes it is wider by as much as they are apart.
"""

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
from scipy.ndimage import maximum_filter1d

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run, runs_of_ink, widest_gap
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.view_shapes import Shape

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

_STEP = 0.5
"""px between the places that are looked at."""

_BESIDE = 2.5
"""Pen's widths on either side of a line in which both lines' ink lies."""

_BLANK = 0.1
"""Ink of paper."""

_SINGLE, _WIDER = 0.35, 0.6
"""px by which one dash's ink may differ from the pen's; by which that of two is more, at least."""

_NEAREST, _FARTHEST = 0.75, 1.25
"""px between two lines, at least; and in the pen's widths at most: farther apart paper shows."""

_TIGHT = 0.3
"""px by which the middle of a line's dashes may differ from the line, on the median."""

_MOST = 80.0
"""Per cent of the places with both lines' ink that have no more of it than is compared."""

_LEAST = 6.0
"""px along which each of both lines is seen alone, and both together, at least."""

_PIECES = 2
"""Stretches on which each line is seen alone, at least."""

_AROUND = 1.5
"""Dashes with their gaps beside ink of both in which the one or the other is looked for alone."""

_LONG_DASH = 1.3
"""Dashes that the ink of both goes on for at a stretch at most."""

_MOSTLY_DASH, _STEPS = 0.7, 3
"""Length of a dash that counts, in the sheet's dashes, and dashes of one line and of both, at
least, where both keep step."""

_ROUNDS = 2
"""How often the line is laid parallel to both."""

_EDGE = 0.35
"""px inside of the outer edge of a line's ink where it is looked for."""

_LIKE_A_DASH = 0.5, 1.5
"""Length of a dash with which a line goes on, in the sheet's dashes, at least and at most."""

_SHORTEST_RUN = 2.0
"""px of a dash at least: what is left of one at a crossing."""


@dataclass(frozen=True)
class _Profile:
    """The ink across a line at places along it.

    Attributes:
        along: (n,) px.
        ink: (n,) px across; NaN where other strokes are beside.
        middle: (n,) px of its middle beside the line.
    """

    along: Floats
    ink: Floats
    middle: Floats


def uneven_twins(
    shape: Shape, sheet: CleanSheet, pen: float, rhythm: Rhythm
) -> tuple[Shape, Shape] | None:
    """The two lines whose dashes take turns in a line's ink; None if it is one.

    Args:
        shape: of a line.
        sheet: its view's ink.
        pen: px that a dash's ink is wide.
        rhythm: of the sheet's dashes.
    """
    line = shape.geometry
    if not isinstance(line, Line) or shape.twin or not shape.runs:
        return None
    profile = _profile(line, shape.runs, sheet, pen)
    seen = _told_apart(profile, pen, rhythm)
    if seen is None:
        return None
    found = []
    half = profile.ink / 2.0 - pen / 2.0
    for present, side in zip(seen, (-1.0, 1.0), strict=True):
        across = profile.middle + side * half
        fitted = _fitted(line, profile.along[present], across[present])
        runs = _runs(fitted, profile.along, sheet, side * (pen / 2.0 - _EDGE), rhythm)
        found.append(replace(shape, geometry=fitted, runs=runs, close=True, twin=True))
    return (found[0], found[1]) if all(this_shape.runs for this_shape in found) else None


def _told_apart(profile: _Profile, pen: float, rhythm: Rhythm) -> tuple[Flags, Flags] | None:
    """Where the one and where the other of two lines has ink; None if there is one."""
    single = np.abs(profile.ink - pen) <= _SINGLE
    both = profile.ink >= pen + _WIDER
    if min(single.sum(), both.sum()) * _STEP < _LEAST or _is_solid(both, rhythm):
        return None
    alone = _one_alone(profile, single, both, pen, rhythm)
    if alone is not None:
        return alone
    reach = round(_AROUND * (rhythm.dash + rhythm.gap) / _STEP)
    single &= maximum_filter1d(both.astype(np.uint8), 2 * reach + 1) > 0
    level, apart = profile, 0.0
    one = other = single
    for _ in range(_ROUNDS):
        parted = _parted(level, single, widest_gap(rhythm) + 2.0)
        if parted is None:
            return None
        one, other = parted
        level, apart = _levelled(level, one, other)
    # Where both have ink it is wider by their distance, less at the ends of dashes.
    wider = float(np.percentile(profile.ink[both], _MOST)) - pen
    if not _NEAREST <= apart <= _FARTHEST * pen or abs(wider - apart) > 2.0 * _TIGHT:
        return None
    return one | both, other | both


def _one_alone(
    profile: _Profile, single: Flags, both: Flags, pen: float, rhythm: Rhythm
) -> tuple[Flags, Flags] | None:
    """The same where the dashes of both keep step for as long as the shorter line goes on: beyond,
    those of the other are as wide as one, and lie at one edge of the ink."""
    shortest = _MOSTLY_DASH * rhythm.dash / _STEP
    stretches = [(a, b) for a, b in runs_of_ink(both) if b - a >= shortest]
    lone = [(a, b) for a, b in runs_of_ink(single) if b - a >= shortest]
    if min(len(stretches), len(lone)) < _STEPS:
        return None
    widths = np.array([np.median(profile.ink[a : b + 1]) for a, b in stretches])
    apart = float(np.median(widths)) - pen
    if np.abs(widths - pen - apart).max() > _TIGHT or not _NEAREST <= apart <= _FARTHEST * pen:
        return None
    seen = np.zeros(len(single), dtype=bool)
    wide = seen.copy()
    for flags, items in ((seen, lone), (wide, stretches)):
        for a, b in items:
            flags[a : b + 1] = True
    seen, wide = seen & single, wide & both
    shift = _levelled(profile, seen, wide)[1]
    if abs(2.0 * abs(shift) - apart) > 2.0 * _TIGHT:
        return None
    return (seen | wide, wide) if shift > 0.0 else (wide, seen | wide)


def _is_solid(both: Flags, rhythm: Rhythm) -> bool:
    """Whether wide ink goes on for longer than a dash does: a visible line's."""
    longest = max((last - first for first, last in runs_of_ink(both)), default=0)
    return longest * _STEP > _LONG_DASH * rhythm.dash


def _profile(line: Line, runs: tuple[Run, ...], sheet: CleanSheet, pen: float) -> _Profile:
    along = np.arange(runs[0].start, runs[-1].end + _STEP, _STEP)
    reach = _BESIDE * pen
    offsets = np.arange(-reach, reach + 0.25, 0.25)
    points, (dx, dy) = line.points_at(along), line.direction
    profile = sample(sheet.weight, points[:, :1] - dy * offsets, points[:, 1:] + dx * offsets)
    total = profile.sum(axis=1)
    clear = (profile[:, :2] < _BLANK).all(axis=1) & (profile[:, -2:] < _BLANK).all(axis=1)
    clear &= total > 0.0
    middle = (profile * offsets).sum(axis=1) / np.maximum(total, 1e-9)
    ink = np.where(clear, total * 0.25, np.nan)
    return _Profile(along, ink, np.where(clear, middle, np.nan))


def _levelled(profile: _Profile, one: Flags, other: Flags) -> tuple[_Profile, float]:
    """The profile beside a line that is parallel to both, and px between them."""
    values = one | other
    along = profile.along[values]
    design = np.stack([np.ones(len(along)), along, other[values].astype(np.float64)], axis=1)
    (_, slope, apart), *_ = np.linalg.lstsq(design, profile.middle[values], rcond=None)
    return replace(profile, middle=profile.middle - slope * profile.along), float(apart)


def _parted(profile: _Profile, single: Flags, gap: float) -> tuple[Flags, Flags] | None:
    """Where only the one line has ink and where only the other, if they are two.

    Each is seen alone where the other has gaps, up to ``gap`` px wide.
    """
    if not single.any():
        return None
    low, high = np.percentile(profile.middle[single], (5.0, 95.0))
    limit = 0.5 * (low + high)
    one = single & (profile.middle < limit)
    other = single & (profile.middle >= limit)
    for item in (one, other):
        gaps = [last - first for first, last in runs_of_ink(item) if (last - first) * _STEP <= gap]
        if item.sum() * _STEP < _LEAST or len(gaps) < _PIECES:
            return None
        if np.median(np.abs(profile.middle[item] - np.median(profile.middle[item]))) > _TIGHT:
            return None
    return one, other


def _fitted(line: Line, along: Floats, across: Floats) -> Line:
    """The line through places that lie some px beside another one, robustly."""
    slope, shift = np.polyfit(along, across, 1)
    near = np.abs(across - slope * along - shift) < 2.0 * _TIGHT
    if near.sum() * _STEP >= _LEAST:
        slope, shift = np.polyfit(along[near], across[near], 1)
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    way = direction + slope * normal
    way = way / np.hypot(*way)
    point = np.array(line.point) + shift * normal
    return Line((float(point[0]), float(point[1])), (float(way[0]), float(way[1])))


def _runs(
    line: Line, along: Floats, sheet: CleanSheet, outward: float, rhythm: Rhythm
) -> tuple[Run, ...]:
    """Where a line has ink, looked for beside it, where the other line has none.

    The dashes may go on beyond the places that were looked at, in ink that no line followed.
    """
    reach = float(sum(sheet.weight.shape))
    places = np.arange(along[0] - reach, along[-1] + reach, _STEP)
    points, (dx, dy) = line.points_at(places), line.direction
    dark = sample(sheet.weight, points[:, :1] - dy * outward, points[:, 1:] + dx * outward)
    runs = [
        Run(float(places[first]), float(places[last]))
        for first, last in runs_of_ink(dark[:, 0] > 0.5)
        if (last - first) * _STEP >= _SHORTEST_RUN
    ]
    dashes = [run for run in runs if run.length >= _LIKE_A_DASH[0] * rhythm.dash]
    # Strokes that cross the line far from its dashes are none of it.
    gap = widest_gap(rhythm)
    runs = [run for run in runs if any(_between(run, dash) <= gap for dash in dashes)]
    kept = [run for run in runs if run.end >= along[0] and run.start <= along[-1]]
    if not kept:
        return ()
    first, last = runs.index(kept[0]), runs.index(kept[-1])
    while first > 0 and _goes_on(runs[first - 1], runs[first], rhythm):
        first -= 1
    while last < len(runs) - 1 and _goes_on(runs[last + 1], runs[last], rhythm):
        last += 1
    return tuple(runs[first : last + 1])


def _goes_on(dash: Run, run: Run, rhythm: Rhythm) -> bool:
    """Whether a run beside another is a dash of the same line."""
    low, high = _LIKE_A_DASH
    like = low <= dash.length / rhythm.dash <= high
    return like and _between(dash, run) <= widest_gap(rhythm)


def _between(one: Run, other: Run) -> float:
    """px between two runs, less than 0 where they overlap."""
    return max(one.start - other.end, other.start - one.end)
