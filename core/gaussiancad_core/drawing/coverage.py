"""Which part of a stroke runs along other strokes."""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.strokes import DrawnStroke, Polyline, extent, part
from gaussiancad_core.views import Arc, Segment

Points = npt.NDArray[np.float64]

_MOST_SAMPLES = 400
_HALVINGS = 20


def uncovered(
    stroke: DrawnStroke,
    others: Sequence[DrawnStroke],
    tolerance: float,
    fragment: float,
) -> list[DrawnStroke]:
    """The parts of a stroke that are further than ``tolerance`` from all others.

    Args:
        stroke: what is looked at.
        others: what may cover it.
        tolerance: distance.
        fragment: shorter parts are dropped.

    Returns:
        The stroke itself where nothing covers it.
    """
    near = near_strokes(stroke, others, tolerance)
    if not near:
        return [stroke]
    length = stroke.length
    count = int(np.clip(np.ceil(length / (4.0 * fragment)), 8, _MOST_SAMPLES))
    at = (np.arange(count) + 0.5) * (length / count)

    def covered(positions: Points) -> npt.NDArray[np.bool_]:
        points = points_at(stroke, positions)
        return np.min([distances(points, other) for other in near], axis=0) < tolerance

    mask = covered(at)
    if not mask.any():
        return [stroke]
    cuts = [
        _change(covered, at[i], at[i + 1])
        for i in np.flatnonzero(mask[:-1] != mask[1:])
    ]
    bounds = [0.0, *cuts, length]
    free_first = not mask[0]
    return [
        part(stroke, low, high)
        for index, (low, high) in enumerate(pairwise(bounds))
        if (index % 2 == 0) == free_first and high - low >= fragment
    ]


def near_strokes(
    stroke: DrawnStroke, others: Sequence[DrawnStroke], tolerance: float
) -> list[DrawnStroke]:
    """Those whose bounding boxes come within ``tolerance`` of a stroke's."""
    low, high = extent((stroke,))
    near = []
    for other in others:
        other_low, other_high = extent((other,))
        if np.all(other_low <= high + tolerance) and np.all(
            other_high >= low - tolerance
        ):
            near.append(other)
    return near


def _change(
    covered: Callable[[Points], npt.NDArray[np.bool_]], low: float, high: float
) -> float:
    """Where between two positions the state changes, by halving."""
    before = bool(covered(np.array([low]))[0])
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        if bool(covered(np.array([middle]))[0]) == before:
            low = middle
        else:
            high = middle
    return (low + high) / 2.0


def points_at(stroke: DrawnStroke, positions: Points) -> Points:
    """(n, 2) points at lengths along a stroke."""
    if isinstance(stroke, Segment):
        start, end = np.array(stroke.start), np.array(stroke.end)
        return start + positions[:, None] / stroke.length * (end - start)
    if isinstance(stroke, Arc):
        angles = stroke.start_angle + positions / stroke.radius
        return np.array(stroke.centre) + stroke.radius * np.stack(
            [np.cos(angles), np.sin(angles)], axis=1
        )
    vertices = np.array(stroke.points)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(vertices, axis=0).T))])
    return np.stack(
        [np.interp(positions, along, vertices[:, axis]) for axis in (0, 1)], axis=1
    )


def distances(points: Points, stroke: DrawnStroke) -> Points:
    """(n,) distances of (n, 2) points from a stroke."""
    if isinstance(stroke, Segment):
        return _chain_distances(points, np.array([stroke.start, stroke.end]))
    if isinstance(stroke, Polyline):
        return _chain_distances(points, np.array(stroke.points))
    offsets = points - np.array(stroke.centre)
    turn = np.mod(
        np.arctan2(offsets[:, 1], offsets[:, 0]) - stroke.start_angle, 2.0 * np.pi
    )
    radial = np.abs(np.hypot(*offsets.T) - stroke.radius)
    ends = points_at(stroke, np.array([0.0, stroke.length]))
    to_ends = np.hypot(*np.moveaxis(points[:, None] - ends, 2, 0)).min(axis=1)
    return np.where(turn <= stroke.sweep, radial, to_ends)


def _chain_distances(points: Points, chain: Points) -> Points:
    starts, spans = chain[:-1], np.diff(chain, axis=0)
    squares = np.maximum((spans**2).sum(axis=1), 1e-300)
    offsets = points[:, None, :] - starts[None]
    shares = np.clip((offsets * spans).sum(axis=2) / squares, 0.0, 1.0)
    nearest = offsets - shares[..., None] * spans
    return np.sqrt((nearest**2).sum(axis=2).min(axis=1))
