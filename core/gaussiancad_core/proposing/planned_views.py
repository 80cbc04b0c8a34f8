"""The views before which parts are planned: lines of sight, and which of them are compared.

The pairs of a sheet are the judge's (:mod:`gaussiancad_core.judging.sight_pairs`).  Two more are
asked of a part that is put together: outside of a closed outline there is nothing, and holes are as
notes say.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.opened_views import cut_depths
from gaussiancad_core.judging.sight_pairs import NO_LINE, Drawn, SightPairs, sight_pairs
from gaussiancad_core.model.projection_planes import IN_PLANE, plane_points
from gaussiancad_core.proposing.feature_kernels import NOTED
from gaussiancad_core.proposing.lines_by_plane import Floats, PlaneHole, PlaneSheet
from gaussiancad_core.proposing.part_features import Sights
from gaussiancad_core.proposing.plane_loops import Numbers, PlaneLoops

RASTER = 48
"""Squares along a view by which places of differences are told."""

_NOTE, _WAYS, _BESIDE = 2.0, 6, 1.2
"""What a hole costs that is not as a note says, in the root of its area; ways in which it is looked
at around its axis, and radii from that at which what is beside it is."""

_OF_NOTE = NO_LINE - 1

_BEYOND = 0.5
"""What a mm counts beyond a closed outline, beside a stroke, of what it counts there."""


@dataclass(frozen=True, eq=False)
class PlannedView:
    """A view before which parts are planned.

    Attributes:
        sights: its lines of sight.
        one, other, drawn, weight: of its pairs, as of :class:`SightPairs`, or :data:`.NOTED`.
        depth: (p,) mm that a note tells of a pair, as of :class:`.Pairs`; 0 of others.
        line: (p,) number of the stroke that a pair is beside; less than 0 of others.
        cut_at: (n,) mm along its axis at which each line of sight is cut open; NaN where it is not.
        looks_up: whether it sees the least coordinate along its axis first.
        draws_hidden: whether what is hidden is drawn.
        draws_tangents: whether lines where faces meet smoothly are.
        squares: (n,) of the raster that lines of sight lie in.
        pair_squares: (p,) the same of the pairs.
    """

    sights: Sights
    one: Numbers
    other: Numbers
    drawn: Numbers
    weight: Floats
    depth: Floats
    line: Numbers
    cut_at: Floats
    looks_up: bool
    draws_hidden: bool
    draws_tangents: bool
    squares: Numbers
    pair_squares: Numbers


def planned_views(
    views: DrawnViews, sheet: PlaneSheet, planes: Iterable[PlaneLoops]
) -> Iterator[PlannedView]:
    """The views of a sheet.

    Args:
        views: that the sheet was made of.
        sheet: its strokes by plane.
        planes: what these enclose.
    """
    closed = {plane.axis: plane.outline for plane in planes if plane.is_closed}
    drawn = drawn_sheet(views)
    by_role = {view.role: view for view in drawn.views}
    for number, plane_view in enumerate(sheet.views):
        axis, view = plane_view.axis, by_role[plane_view.role]
        pairs = sight_pairs(drawn, view)
        places, at = (
            plane_points(points, plane_view.role, 1.0) for points in (pairs.places, pairs.at)
        )
        size = sheet.size[list(IN_PLANE[axis])]
        made = PlannedView(
            Sights(number, axis, np.ascontiguousarray(places)),
            pairs.one,
            pairs.other,
            pairs.drawn,
            pairs.weight,
            np.zeros(len(pairs.one)),
            pairs.line,
            plane_view.role.frame.look_axis[1] * cut_depths(view, pairs.places),
            plane_view.looks_up,
            view.draws_hidden,
            view.draws_tangents,
            squares_of(places, size),
            squares_of(at, size),
        )
        if axis in closed:
            made = _with_nothing_beyond(made, pairs, closed[axis], (drawn.aside, size))
        for hole in sheet.holes:
            if hole.axis is axis and hole.looks_up == made.looks_up:
                made = _with_note(made, hole, size)
        yield made


def thinned(views: Sequence[PlannedView], every: int) -> tuple[PlannedView, ...]:
    """Views with one of so many pairs along each stroke and over the blank, and all of notes."""
    return tuple(_thinned(view, len(views) + k, every) for k, view in enumerate(views))


def _thinned(view: PlannedView, number: int, every: int) -> PlannedView:
    order = np.argsort(view.line, kind="stable")
    line, weight = view.line[order], view.weight[order]
    _, begins, group, counts = np.unique(
        line, return_index=True, return_inverse=True, return_counts=True
    )
    rank = np.arange(len(line)) - begins[group]
    step = np.where(line == _OF_NOTE, 1, np.minimum(every, counts[group]))
    kept = rank % step == step // 2
    scale = np.bincount(group, weight) / np.maximum(np.bincount(group, weight * kept), 1e-12)
    chosen = order[kept]
    ends = np.concatenate([view.one[chosen], view.other[chosen]])
    used, ends = np.unique(ends, return_inverse=True)
    return replace(
        view,
        sights=replace(view.sights, number=number, places=view.sights.places[used]),
        one=ends[: len(chosen)],
        other=ends[len(chosen) :],
        drawn=view.drawn[chosen],
        weight=view.weight[chosen] * scale[group[kept]],
        depth=view.depth[chosen],
        line=view.line[chosen],
        cut_at=view.cut_at[used],
        squares=view.squares[used],
        pair_squares=view.pair_squares[chosen],
    )


def _with_note(view: PlannedView, hole: PlaneHole, size: Floats) -> PlannedView:
    """A view with pairs of a line of sight in a step of a hole and of one beside the hole."""
    turn = np.linspace(0.0, 2.0 * np.pi, _WAYS, endpoint=False)
    ways = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    around = hole.centre + _BESIDE * hole.steps[-1].diameter / 2.0 * ways
    rings, depths, weights, inner = [around], [], [], 0.0
    for step in hole.steps:
        radius = step.diameter / 2.0
        rings.append(hole.centre + (inner + radius) / 2.0 * ways)
        depths += [np.inf if step.depth is None else step.depth] * _WAYS
        weights += [_NOTE * np.sqrt(np.pi) * radius / _WAYS] * _WAYS
        inner = radius
    first, count = len(view.sights.places), len(depths)
    places = np.vstack(rings)
    other = first + np.tile(np.arange(_WAYS), len(hole.steps))
    return replace(
        view,
        sights=replace(view.sights, places=np.vstack([view.sights.places, places])),
        one=np.concatenate([view.one, first + _WAYS + np.arange(count)]),
        other=np.concatenate([view.other, other]),
        drawn=np.concatenate([view.drawn, np.full(count, NOTED)]),
        weight=np.concatenate([view.weight, weights]),
        depth=np.concatenate([view.depth, depths]),
        line=np.append(view.line, np.full(count, _OF_NOTE)),
        cut_at=np.concatenate([view.cut_at, np.full(len(places), np.nan)]),
        squares=np.concatenate([view.squares, squares_of(places, size)]),
        pair_squares=np.concatenate([view.pair_squares, squares_of(places[_WAYS:], size)]),
    )


def _with_nothing_beyond(
    view: PlannedView,
    pairs: SightPairs,
    outline: shapely.Polygon,
    scale: tuple[float, Floats],
) -> PlannedView:
    """A view with pairs of what lies beyond its outline and a line of sight far from any part."""
    aside, size = scale
    places = view.sights.places
    beyond = np.flatnonzero(~shapely.contains_xy(outline.buffer(aside / 2.0), *places.T))
    weights = np.full(len(places), float(np.median(pairs.cells)) if len(pairs.cells) else 1.0)
    at_strokes = pairs.drawn != Drawn.NOTHING
    for ends in (pairs.one, pairs.other):
        weights[ends[at_strokes]] = _BEYOND * pairs.weight[at_strokes]
    far = np.array([[-size.max(), -size.max()]])
    count = len(beyond)
    return replace(
        view,
        sights=replace(view.sights, places=np.ascontiguousarray(np.vstack([places, far]))),
        one=np.concatenate([view.one, beyond]),
        other=np.concatenate([view.other, np.full(count, len(places))]),
        drawn=np.concatenate([view.drawn, np.zeros(count, view.drawn.dtype)]),
        weight=np.concatenate([view.weight, weights[beyond]]),
        depth=np.zeros(len(view.one) + count),
        line=np.append(view.line, np.full(count, NO_LINE)),
        cut_at=np.append(view.cut_at, np.nan),
        squares=np.append(view.squares, 0),
        pair_squares=np.concatenate([view.pair_squares, squares_of(places[beyond], size)]),
    )


def squares_of(places: Floats, size: Floats) -> Numbers:
    """(n,) numbers of the squares of a view's raster that places (n, 2) lie in."""
    cells = np.clip((places / size * RASTER).astype(np.int64), 0, RASTER - 1)
    return cells[:, 0] * RASTER + cells[:, 1]


def sums_of(values: Floats) -> Floats:
    """(RASTER + 1, RASTER + 1) sums of a raster's values up to each corner."""
    sums = np.zeros((RASTER + 1, RASTER + 1))
    sums[1:, 1:] = values.reshape(RASTER, RASTER).cumsum(axis=0).cumsum(axis=1)
    return sums


def within_boxes(sums: Floats, boxes: Floats, size: Floats, margin: float) -> Floats:
    """(n,) sums of a raster over boxes (n, 2, 2) mm, so many squares wider."""
    low = np.clip(np.floor(boxes[:, 0] / size * RASTER - margin).astype(np.int64), 0, RASTER)
    high = np.clip(np.ceil(boxes[:, 1] / size * RASTER + margin).astype(np.int64), 0, RASTER)
    return (
        sums[high[:, 0], high[:, 1]]
        - sums[low[:, 0], high[:, 1]]
        - sums[high[:, 0], low[:, 1]]
        + sums[low[:, 0], low[:, 1]]
    )
