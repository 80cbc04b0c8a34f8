"""Lines and arcs in what a plotter drew: curves as short chords, their ends rounded to a grid.

Chords that turn little and are about as long as each other are a run; it is cut into arcs that are
as long as they can be while all points lie within the rounding, and into its own chords.
"""

import numpy as np
import numpy.typing as npt
from numpy.lib.stride_tricks import sliding_window_view

from gaussiancad_core.files.file_curves import MOST_CHORDS
from gaussiancad_core.files.fitting import circle_through, circles_through
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.ellipses import LONGEST_CHORD
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped
from gaussiancad_core.geometry.tolerances import COMPUTED

Points = npt.NDArray[np.float64]
"""(n, 2) px."""

_UNEVEN = 4.0
"""Ratio of the lengths of neighbouring chords of one curve at most."""

FEWEST_CHORDS, _SMALLEST_SWEEP = 6, np.radians(15.0)
"""Chords and turn of an arc at least."""

_BESIDE, _STEPS = 0.15, 0.8
"""px, and steps of the grid, within which points lie beside their circle: of the diagonal a half,
and something for the chord."""


def lines_and_arcs(points: Points, step: float) -> list[Curve]:
    """Curves along a polygon that a plotter drew, in order.

    Args:
        points: no two neighbours at the same place.
        step: px of the grid to which the points were rounded; 0 of exact ones.
    """
    curves: list[Curve] = []
    first = 0
    for last in _ends_of_runs(points, step):
        curves += _along_run(points[first : last + 1], max(_BESIDE, _STEPS * step))
        first = last
    return curves


def _ends_of_runs(points: Points, step: float) -> npt.NDArray[np.int64]:
    """Numbers of the points at which runs of chords end."""
    ways = np.diff(points, axis=0)
    lengths = np.hypot(*ways.T)
    angles = np.arctan2(ways[:, 1], ways[:, 0])
    turns = np.abs(np.angle(np.exp(1j * np.diff(angles))))
    shorter = np.minimum(lengths[:-1], lengths[1:])
    longer = np.maximum(lengths[:-1], lengths[1:])
    sharp = turns > LONGEST_CHORD + step / np.maximum(shorter, 1e-9)
    uneven = longer - step > _UNEVEN * shorter
    return np.append(np.flatnonzero(sharp | uneven) + 1, len(points) - 1)


def _along_run(points: Points, offset: float) -> list[Curve]:
    pieces: list[tuple[int, int, bool]] = []
    first, last = 0, len(points) - 1
    begins = _beginnings(points, offset)
    while first < last:
        end = _farthest(points, first, offset) if begins[first] else first
        is_arc = end > first
        end = end if is_arc else first + 1
        pieces.append((first, end, is_arc))
        first = end
    cuts = _balanced(points, pieces)
    return [
        _arc(points[start : end + 1]) if is_arc else _line(points[start], points[end])
        for start, end, is_arc in cuts
    ]


def _beginnings(points: Points, offset: float) -> list[bool]:
    """Which points the fewest chords of an arc follow."""
    last = len(points) - 1
    if last < FEWEST_CHORDS:
        return [False] * last
    windows = np.moveaxis(sliding_window_view(points, FEWEST_CHORDS + 1, axis=0), 2, 1)
    centres, radii = circles_through(windows)
    away = windows - centres[:, None]
    off = np.abs(np.hypot(*np.moveaxis(away, 2, 0)) - radii[:, None]).max(axis=1)
    return [*(off <= offset).tolist(), *[False] * (FEWEST_CHORDS - 1)]


def _farthest(points: Points, first: int, offset: float) -> int:
    """The last point up to which an arc runs from a point on, from which the fewest chords of one
    do, or that itself."""
    # The longest that still fits, by bisection: an arc's beginning fits where it does.
    low, high = first + FEWEST_CHORDS, min(len(points) - 1, first + MOST_CHORDS)
    if not _fits(points[first : low + 1], offset):
        return first
    while low < high:
        middle = (low + high + 1) // 2
        if _fits(points[first : middle + 1], offset):
            low = middle
        else:
            high = middle - 1
    return low if abs(_fit(points[first : low + 1])[1]) >= _SMALLEST_SWEEP else first


def _fits(points: Points, offset: float) -> bool:
    off, turn = _fit(points)
    return off <= offset and abs(turn) <= FULL_TURN + LONGEST_CHORD


def _fit(points: Points) -> tuple[float, float]:
    """px that points lie beside their circle at most, and radians that they go on around its
    middle."""
    centre, radius = circle_through(points)
    across, up = (points - centre).T
    off = float(np.abs(np.hypot(across, up) - radius).max())
    steps = np.diff(np.arctan2(up, across))
    return off, float((steps - FULL_TURN * np.round(steps / FULL_TURN)).sum())


def _balanced(points: Points, pieces: list[tuple[int, int, bool]]) -> list[tuple[int, int, bool]]:
    """The pieces, those arcs that follow each other cut where both fit best: one that is made as
    long as it can be takes some of the next."""
    pieces = list(pieces)
    for index in range(len(pieces) - 1):
        (start, cut, is_arc), (_, end, follows) = pieces[index : index + 2]
        places = range(max(start + FEWEST_CHORDS, cut - FEWEST_CHORDS), cut + 1)
        if is_arc and follows and places:
            offs = [_fit(points[start : k + 1])[0] + _fit(points[k : end + 1])[0] for k in places]
            best = places[int(np.argmin(offs))]
            pieces[index], pieces[index + 1] = (start, best, True), (best, end, True)
    return pieces


def _line(start: npt.NDArray[np.float64], end: npt.NDArray[np.float64]) -> LineSegment:
    return LineSegment(to_point(start), to_point(end))


def _arc(points: Points) -> CircularArc:
    centre, radius = circle_through(points)
    angles = np.unwrap(np.arctan2(points[:, 1] - centre[1], points[:, 0] - centre[0]))
    sweep = float(angles[-1] - angles[0])
    if np.hypot(*(points[-1] - points[0])) < COMPUTED:
        sweep = FULL_TURN
    start = float(angles[0] if sweep > 0.0 else angles[-1])
    return CircularArc(to_point(centre), radius, wrapped(start), min(abs(sweep), FULL_TURN))
