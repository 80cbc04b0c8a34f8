"""Hidden lines so close beside an edge that their dashes melt into its ink.

Nothing is grown along such dashes: the edge only is wider, to one side, a dash long, and as narrow
as ever for a gap, in the rhythm of the sheet's dashes.  By how much it is wider tells where the
hidden line lies: its pen is that of all dashes.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.tracing.ink_runs import Rhythm, Run, runs_of_ink
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.twin_lines import DashPen, dash_pen
from gaussiancad_core.sheet.tracing.view_shapes import Shape, ViewShapes

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

_FEWEST = 4
"""Dashes one after the other that are a hidden line."""

_LIKE_A_DASH, _LIKE_A_GAP = 0.35, 0.6
"""Shares by which a dash and a gap may be longer or shorter than the sheet's."""

_WIDER = 0.6
"""px by which an edge is wider where it has a dash, at least."""

_EVEN_PX = 0.3
"""px by which this differs from dash to dash at most."""

_NARROW = 0.3
"""Quantile of an edge's ink along it that is its own."""

_ASIDE = 0.8
"""How far the ink's middle goes to the side, of how far it does where all ink is on that side."""

_BLANK, _DARK, _STEP = 0.1, 0.5, 0.5
"""Ink of paper, of a place that is a line's, and px between places across and along an edge."""

_CROSSED_PX = 8.0
"""px along which something else may cross or touch an edge within one dash or gap."""

_ONE_PX, _END_PX = 0.8, 3.0
"""px beyond an edge and its dashes to the side, and beyond the edge's ends, within which lines are
of their ink."""

_NEAREST = 1.0
"""px from the edge's middle to the hidden line's at least."""


@dataclass(frozen=True, eq=False)
class _Profile:
    """The ink across an edge at places along it.

    Attributes:
        along: (n,) px.
        offsets: (m,) px beside the line.
        weights: (n, m) at these.
        ink: (n,) px across; NaN where there is other ink beside.
        moment: (n,) px squared: the ink times how far its middle lies beside the line.
    """

    along: Floats
    offsets: Floats
    weights: npt.NDArray[np.float32]
    ink: Floats
    moment: Floats


def with_edge_dashes(views: Sequence[ViewShapes], rhythm: Rhythm) -> list[ViewShapes]:
    """The views, with the hidden lines whose dashes melt into edges.

    Args:
        views: shapes of all views of a sheet.
        rhythm: of the sheet's dashes.
    """
    pen = dash_pen(views, rhythm)
    if pen is None:
        return list(views)
    return [replace(view, shapes=_with_dashes(view, pen, rhythm)) for view in views]


def _with_dashes(view: ViewShapes, pen: DashPen, rhythm: Rhythm) -> tuple[Shape, ...]:
    least = _FEWEST * rhythm.dash + (_FEWEST - 1) * rhythm.gap
    found: list[Shape] = []
    left = list(view.shapes)
    for index in range(len(left)):
        shape = left[index]
        straight = isinstance(shape.geometry, Line) and not shape.close
        for run in shape.runs if straight else ():
            if run.length < least or run not in left[index].runs:
                continue
            pair = _melted(replace(shape, runs=(run,)), view, pen, rhythm)
            # The ink goes to and fro, and what was grown along it may slope and end too early.
            again = _whole(pair[0], view) if pair is not None else None
            pair = _melted(again, view, pen, rhythm) if again is not None else None
            if pair is None:
                continue
            left = [_elsewhere(this_shape, pair) for this_shape in left]
            if not any(_is_same(pair[0], this_shape) for this_shape in found[::2]):
                found += pair
    kept = [
        this_shape
        for this_shape, before in zip(left, view.shapes, strict=True)
        if this_shape.runs or not before.runs
    ]
    return (*kept, *found)


def _is_same(edge: Shape, other: Shape) -> bool:
    """Whether two edges are one."""
    (run,) = edge.runs
    ends = edge.geometry.points_at(np.array([run.start, run.end]))
    at = np.sort(other.geometry.positions(ends))
    neighbour = min(at[1], other.runs[0].end) - max(at[0], other.runs[0].start)
    return neighbour > 0.0 and float(other.geometry.distances(ends).max()) < _ONE_PX


def _whole(edge: Shape, view: ViewShapes) -> Shape | None:
    """An edge as far as its ink goes without a gap."""
    line, (run,) = edge.geometry, edge.runs
    height, width = view.sheet.weight.shape
    along = np.arange(run.start - width - height, run.end + width + height, 1.0)
    points = line.points_at(along)
    dark = sample(view.sheet.weight, points[:, :1], points[:, 1:])[:, 0] > _DARK
    middle = int(np.argmin(np.abs(along - (run.start + run.end) / 2.0)))
    for first, last in runs_of_ink(dark):
        if first <= middle <= last:
            this_run = Run(float(along[first]), float(along[last]))
            return replace(edge, runs=(this_run,), support=max(edge.support, this_run.length))
    return None


def _elsewhere(shape: Shape, pair: tuple[Shape, Shape]) -> Shape:
    """A shape without what was grown along the ink of an edge and of the dashes beside it."""
    edge, hidden = pair
    if not isinstance(shape.geometry, Line) or not shape.runs:
        return shape
    (run,), line = edge.runs, edge.line
    aside = float(line.coordinates(np.array([hidden.line.point]))[1][0])
    places = np.array([(this_run.start, this_run.end) for this_run in shape.runs]).ravel()
    at, across = (
        coordinate.reshape(-1, 2)
        for coordinate in line.coordinates(shape.geometry.points_at(places))
    )
    there = (at >= run.start - _END_PX) & (at <= run.end + _END_PX)
    there &= (across >= min(aside, 0.0) - _ONE_PX) & (across <= max(aside, 0.0) + _ONE_PX)
    within = np.all(there, axis=1)
    if not within.any():
        return shape
    kept = [this_run for this_run, gone in zip(shape.runs, within, strict=True) if not gone]
    return replace(shape, runs=tuple(kept))


def _melted(
    edge: Shape, view: ViewShapes, pen: DashPen, rhythm: Rhythm
) -> tuple[Shape, Shape] | None:
    """An edge where it lies, and the hidden line beside it; None if there is none."""
    line = edge.geometry
    profile = _profile(view, edge, pen)
    if profile is None:
        return None
    value = float(np.nanquantile(profile.ink, _NARROW))
    wide = profile.ink > value + _WIDER / 2.0
    dashes = _row(profile, wide, value, rhythm)
    if dashes is None:
        return None
    at_dashes = np.zeros(len(wide), dtype=bool)
    for first, last in dashes:
        at_dashes[first + 2 : last - 1] = np.isfinite(profile.ink[first + 2 : last - 1])
    start, end = dashes[0][0], dashes[-1][1]
    at_gaps = np.zeros(len(wide), dtype=bool)
    at_gaps[start:end] = np.isfinite(profile.ink[start:end]) & ~wide[start:end]
    narrow, moment = (float(np.median(v[at_gaps])) for v in (profile.ink, profile.moment))
    more = float(np.median(profile.ink[at_dashes])) - narrow
    shift = float(np.median(profile.moment[at_dashes])) - moment
    if more < _WIDER or more > pen.ink + _EVEN_PX:
        return None
    level = np.polyfit(profile.along[at_gaps], (profile.moment / profile.ink)[at_gaps], 1)
    line = _along(edge.line, level)
    middle = moment / narrow
    away = abs(shift) / more - np.sign(shift) * middle
    if away < _ASIDE * (narrow + more) / 2.0:
        return None
    side = float(np.sign(shift))
    apart = side * (_outer_half(profile, at_dashes, side, pen.ink / 2.0) - middle)
    if apart < _NEAREST:
        return None
    runs = tuple(Run(float(profile.along[a]), float(profile.along[b])) for a, b in dashes)
    return (
        replace(edge, geometry=line, close=True, twin=True),
        replace(
            edge,
            geometry=_moved(line, side * apart),
            runs=runs,
            close=True,
            twin=True,
        ),
    )


def _outer_half(profile: _Profile, at: Flags, side: float, half: float) -> float:
    """px beside the line from where half of a dash's ink lies farther out: however much of its
    other half lies in the edge's ink, that is its middle."""
    ink = np.median(profile.weights[at], axis=0)
    order = np.argsort(-side * profile.offsets)
    beyond = np.concatenate([[0.0], np.cumsum(ink[order]) * _STEP])
    outer = profile.offsets[order[0]] + side * _STEP / 2.0
    return float(outer - side * np.interp(half, beyond, np.arange(len(beyond)) * _STEP))


def _profile(view: ViewShapes, edge: Shape, pen: DashPen) -> _Profile | None:
    line, width = edge.line, view.sheet.stroke_width
    reach = width + pen.ink + 1.5
    offsets = np.arange(-reach, reach + _STEP / 2.0, _STEP)
    (run,) = edge.runs
    along = np.arange(run.start + width, run.end - width, _STEP)
    if not len(along):
        return None
    points, (dx, dy) = line.points_at(along), line.direction
    ink = sample(view.sheet.weight, points[:, :1] - dy * offsets, points[:, 1:] + dx * offsets)
    clear = (ink[:, :2] < _BLANK).all(axis=1) & (ink[:, -2:] < _BLANK).all(axis=1)
    if clear.mean() < 0.5:
        return None
    total = np.where(clear, ink.sum(axis=1) * _STEP, np.nan)
    moment = np.where(clear, (ink @ offsets) * _STEP, np.nan)
    return _Profile(along, offsets, ink, total, moment)


def _row(
    profile: _Profile, wide: Flags, value: float, rhythm: Rhythm
) -> list[tuple[int, int]] | None:
    """(first, last) place of each dash of the longest row along an edge; None if too short."""
    unknown = ~np.isfinite(profile.ink)
    dashes = [
        (first, last)
        for first, last in runs_of_ink(_bridged(wide, unknown))
        if abs((last - first) * _STEP / rhythm.dash - 1.0) <= _LIKE_A_DASH
        and not unknown[first : last + 1].all()
    ]
    rows: list[list[tuple[int, int]]] = []
    for dash in dashes:
        gap = (dash[0] - rows[-1][-1][1]) * _STEP if rows else np.inf
        if abs(gap / rhythm.gap - 1.0) <= _LIKE_A_GAP:
            rows[-1].append(dash)
        else:
            rows.append([dash])
    longest = max(rows, key=len, default=[])
    if len(longest) < _FEWEST:
        return None
    inner = [profile.ink[first + 2 : last - 1] for first, last in longest]
    more = np.array([np.nanmedian(ink) - value for ink in inner if np.isfinite(ink).any()])
    steady = len(more) > 0 and np.abs(more - np.median(more)).max() <= _EVEN_PX
    between = slice(longest[0][0], longest[-1][1])
    gaps = np.count_nonzero(~(unknown | wide)[between])
    return longest if steady and gaps >= _FEWEST else None


def _bridged(wide: Flags, unknown: Flags) -> Flags:
    """Which places are wide, where another stroke crosses those that are so on both its sides."""
    bridged = wide.copy()
    known = np.flatnonzero(~unknown)
    for before, after in pairwise(known.tolist()):
        crossed = 1 < after - before <= _CROSSED_PX / _STEP
        if crossed and wide[before] and wide[after]:
            bridged[before:after] = True
    return bridged


def _moved(line: Line, aside: float) -> Line:
    dx, dy = line.direction
    x, y = line.point
    return Line((float(x - aside * dy), float(y + aside * dx)), line.direction)


def _along(line: Line, level: Floats) -> Line:
    """The line whose places lie beside those of another by (2,) slope and px at its start."""
    slope, aside = (float(value) for value in level)
    dx, dy = line.direction
    length = float(np.hypot(1.0, slope))
    direction = (dx - slope * dy) / length, (dy + slope * dx) / length
    return Line(_moved(line, aside).point, direction)
