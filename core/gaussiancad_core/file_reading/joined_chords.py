"""Arcs, circles and ellipses that a file draws as chords, each a line of its own.

Chords of one pen whose ends meet, and that turn one way, are one arc where all of their ends lie on
one circle, however few they are: ten make a circle.  More of them, and nearer, are one arc of an
ellipse where that goes farther than any circle.
"""

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from gaussiancad_core.file_reading.chord_runs import LARGEST_TURN, MEET, Bends, Chords, Run, ends_of
from gaussiancad_core.file_reading.joined_arcs import joined_arcs
from gaussiancad_core.files.file_curves import affine_arc
from gaussiancad_core.files.fitting import circle_through, circles_through
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.ellipses import ellipse_through
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Points

_FEWEST = 3
"""Chords of an arc at least."""

_SWEEP, _MANY, _SWEEP_OF_MANY = np.radians(20.0), 5, np.radians(8.0)
"""Turn of an arc at least; chords from which less will do, and how much that is."""

_LEAST_OFF, _OFF, _OFF_SHARE = 0.01, 0.04, 0.012
"""mm, and share of the radius besides, that ends of chords may lie beside their circle, and mm that
they may at most."""

_EVEN = 1.3
"""Longest of few chords in the shortest at most: any three with two equal turns are on a circle."""

_FEWEST_OF_ELLIPSE, _SWEEP_OF_ELLIPSE, _FLATTEST = 8, np.radians(60.0), 0.02
"""Chords of a piece of an ellipse, its turn, and the shorter half axis in the longer, at least:
through five points there is always one."""

_SAME_PLACE = 0.01
"""mm to which the ends of lines are rounded that are drawn twice."""


def once(strokes: Sequence[PaperStroke]) -> list[PaperStroke]:
    """The strokes without lines that one pen draws twice, whichever way."""
    lines = [number for number, stroke in enumerate(strokes) if stroke.is_line]
    ends = np.array([ends_of(strokes[number]) for number in lines]).reshape(-1, 2, 2)
    places = np.round(ends / _SAME_PLACE).astype(np.int64)
    is_turned = (places[:, 0, 0] > places[:, 1, 0]) | (
        (places[:, 0, 0] == places[:, 1, 0]) & (places[:, 0, 1] > places[:, 1, 1])
    )
    places[is_turned] = places[is_turned, ::-1]
    # Most lines are drawn once, whoever draws them.
    _, same, counts = np.unique(
        places.reshape(-1, 4), axis=0, return_inverse=True, return_counts=True
    )
    same = same.reshape(-1)
    seen = set()
    left_out = set()
    for index in np.flatnonzero(counts[same] > 1).tolist():
        key = int(same[index]), _kind(strokes[lines[index]])
        if key in seen:
            left_out.add(lines[index])
        seen.add(key)
    return [stroke for number, stroke in enumerate(strokes) if number not in left_out]


def _kind(stroke: PaperStroke) -> Hashable:
    """What strokes have in common that may be pieces of one."""
    return stroke.pen, stroke.role, stroke.kind, bool(stroke.dashes)


def with_whole_curves(strokes: Sequence[PaperStroke]) -> list[PaperStroke]:
    """The strokes with whole arcs, circles and ellipses in place of what draws them piecewise."""
    whole = [stroke for stroke in strokes if not stroke.is_line]
    of_kind = defaultdict(list)
    for stroke in strokes:
        if stroke.is_line:
            of_kind[_kind(stroke)].append(stroke)
    for lines in of_kind.values():
        if len(lines) < _FEWEST:
            whole += lines
            continue
        for run in Chords.of(lines).runs():
            whole += _curves_along(run)
    return joined_arcs(whole)


def _curves_along(run: Run) -> Iterator[PaperStroke]:
    """Arcs along a run, and its lines where there are none."""
    count = len(run.lines)
    if count < _FEWEST:
        yield from run.lines
        return
    bends = Bends.of(run.points)
    if run.closed and not bends.bend.all():
        # From a corner on nothing is cut in two.
        cut = int(np.argmin(bends.bend)) + 1
        lines = (*run.lines[cut:], *run.lines[:cut])
        points = np.concatenate([run.points[cut:-1], run.points[: cut + 1]])
        yield from _curves_along(Run(lines, points, closed=False))
        return
    begins = _beginnings(run.points)
    first = 0
    while first < count:
        stop = bends.stop(first)
        last, curve = first, None
        if stop - first >= _FEWEST:
            last, curve = _longest(run.points[first : stop + 1], first, begins[first])
        if curve is None:
            yield run.lines[first]
            first += 1
        else:
            yield replace(run.lines[first], curve=curve)
            first = last


def _beginnings(points: Points) -> list[bool]:
    """Which points the fewest chords of an arc follow."""
    windows = np.moveaxis(sliding_window_view(points, _FEWEST + 1, axis=0), 2, 1)
    centres, radii = circles_through(windows)
    off = np.abs(np.hypot(*np.moveaxis(windows - centres[:, None], 2, 0)) - radii[:, None])
    return [*(off.max(axis=1) <= _off(radii)).tolist(), *[False] * _FEWEST]


def _off(radius: Points) -> Points:
    """mm that ends of chords may lie beside a circle of some radius."""
    return np.minimum(_OFF, _LEAST_OFF + _OFF_SHARE * radius)


def _longest(points: Points, first: int, is_round: bool) -> tuple[int, Curve | None]:
    """The number of the last point of the longest curve from the first of some on, and the curve.

    Args:
        points: (n, 2) of chords that turn one way.
        first: number of the first one.
        is_round: whether the fewest chords lie on one circle.
    """
    far = len(points) - 1
    if not is_round:
        return first, None
    on_circle = _farthest(points, _FEWEST, _is_on_circle)
    if on_circle < far and far >= _FEWEST_OF_ELLIPSE:
        # A short piece of an ellipse is nearly round.
        on_ellipse = _farthest(points, _FEWEST_OF_ELLIPSE, _is_on_ellipse)
        ellipse = _elliptic_arc(points[: on_ellipse + 1]) if on_ellipse > on_circle else None
        if ellipse is not None:
            return first + on_ellipse, ellipse
    return first + on_circle, _arc(points[: on_circle + 1])


def _farthest(points: Points, fewest: int, fits: Callable[[Points], bool]) -> int:
    """The last point up to which points lie on one curve; 0 if the fewest do not.

    By bisection, as the beginning of what lies on a curve does.
    """
    low, high = fewest, len(points) - 1
    if not fits(points[: low + 1]):
        return 0
    if fits(points):
        return high
    # Most curves are short: they are doubled before they are halved.
    while 2 * low < high and fits(points[: 2 * low + 1]):
        low *= 2
    high = min(high, 2 * low) - 1
    while low < high:
        middle = (low + high + 1) // 2
        if fits(points[: middle + 1]):
            low = middle
        else:
            high = middle - 1
    return low


def _is_on_circle(points: Points) -> bool:
    centre, radius = circle_through(points)
    off = float(np.abs(np.hypot(*(points - centre).T) - radius).max())
    return off <= float(_off(np.array(radius)))


def _arc(points: Points) -> CircularArc | None:
    """The arc that points lie on, where it turns far enough."""
    centre, radius = circle_through(points)
    away = points - centre
    angles = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
    sweep = float(angles[-1] - angles[0])
    is_many = len(points) > _MANY
    lengths = np.hypot(*np.diff(points, axis=0).T)
    if abs(sweep) < (_SWEEP_OF_MANY if is_many else _SWEEP):
        return None
    if not is_many and lengths.max() > _EVEN * lengths.min():
        return None
    if np.hypot(*(points[-1] - points[0])) < MEET and abs(sweep) > np.pi:
        sweep = np.copysign(FULL_TURN, sweep)
    start = float(angles[0] if sweep > 0.0 else angles[-1])
    return CircularArc(to_point(centre), radius, wrapped(start), min(abs(sweep), FULL_TURN))


def _is_on_ellipse(points: Points) -> bool:
    ellipse = ellipse_through(points)
    if ellipse is None or not ellipse.semi_minor > _FLATTEST * ellipse.semi_major:
        return False
    return bool(ellipse.distances(points).max() <= _LEAST_OFF)


def _elliptic_arc(points: Points) -> Curve | None:
    """The arc of an ellipse that points lie on, where it turns far enough."""
    ellipse = ellipse_through(points)
    if ellipse is None:
        return None
    local = ellipse.local(points) / (ellipse.semi_major, ellipse.semi_minor)
    angles = np.unwrap(np.arctan2(local[:, 1], local[:, 0]))
    steps, sweep = np.diff(angles), float(angles[-1] - angles[0])
    one_way = (steps > 0.0).all() or (steps < 0.0).all()
    if not one_way or not _SWEEP_OF_ELLIPSE <= abs(sweep) <= FULL_TURN + LARGEST_TURN:
        return None
    if np.hypot(*(points[-1] - points[0])) < MEET and abs(sweep) > np.pi:
        sweep = np.copysign(FULL_TURN, sweep)
    along = np.array([np.cos(ellipse.rotation), np.sin(ellipse.rotation)])
    across = np.array([-along[1], along[0]])
    axes = ellipse.semi_major * along, ellipse.semi_minor * across
    return affine_arc(np.array(ellipse.centre), *axes, float(angles[0]), sweep)
