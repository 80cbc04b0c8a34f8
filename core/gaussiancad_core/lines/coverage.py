"""Which part of a stroke runs along other strokes."""

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.lines.strokes import (
    DrawnStroke,
    Polyline,
    as_chain,
    extent,
    is_closed,
    part,
)
from gaussiancad_core.model.views import Arc, Ellipse, Segment

Points = npt.NDArray[np.float64]

_FEW_SAMPLES = 24
_MOST_SAMPLES = 250
_DIVISIONS, _ROUNDS = 16, 4

_CHORD = 1e-5
"""Share of its longer half axis at which an ellipse's chords may lie beside it."""


class StrokeIndex:
    """Strokes that can be looked up by where they are.

    Args:
        strokes: the first ones; more can be added.
    """

    def __init__(self, strokes: Iterable[DrawnStroke] = ()) -> None:
        self._strokes: list[DrawnStroke] = []
        self._boxes = np.empty((16, 4))
        for stroke in strokes:
            self.add(stroke)

    def add(self, stroke: DrawnStroke) -> None:
        """Take one more stroke."""
        count = len(self._strokes)
        if count == len(self._boxes):
            self._boxes = np.concatenate([self._boxes, np.empty_like(self._boxes)])
        self._boxes[count] = extent((stroke,)).ravel()
        self._strokes.append(stroke)

    def near(self, stroke: DrawnStroke, tolerance: float) -> list[DrawnStroke]:
        """Those whose bounding boxes come within ``tolerance`` of a stroke's."""
        low, high = extent((stroke,))
        boxes = self._boxes[: len(self._strokes)]
        close = np.all(boxes[:, :2] <= high + tolerance, axis=1) & np.all(
            boxes[:, 2:] >= low - tolerance, axis=1
        )
        return [self._strokes[index] for index in np.flatnonzero(close)]


def _middles(count: int, length: float) -> npt.NDArray[np.float64]:
    """Of as many equal pieces of a length."""
    return (np.arange(count, dtype=np.float64) + 0.5) * (length / count)


def uncovered(
    stroke: DrawnStroke, others: Sequence[DrawnStroke], precision: Precision
) -> list[DrawnStroke]:
    """The parts of a stroke that do not run along others.

    Args:
        stroke: what is looked at.
        others: what may cover it.
        precision: how close is along, and what is too short to keep.

    Returns:
        The stroke itself where nothing covers it.
    """
    tolerance, fragment = precision.cover, precision.fragment
    length = stroke.length
    # A stroke that is far from a few points is not near the points between them either.
    few = points_at(stroke, _middles(_FEW_SAMPLES, length))
    reach = tolerance + 0.5 * length / _FEW_SAMPLES
    others = [other for other in others if distances(few, other).min() <= reach]
    if not others:
        return [stroke]
    count = int(np.clip(np.ceil(length / (4.0 * fragment)), 8, _MOST_SAMPLES))
    at = _middles(count, length)
    points = points_at(stroke, at)
    masks = [(other, distances(points, other) < tolerance) for other in others]
    covering = [other for other, mask in masks if mask.any()]
    if not covering:
        return [stroke]
    mask = np.any([mask for _, mask in masks], axis=0)

    def covered(positions: Points) -> npt.NDArray[np.bool_]:
        near = points_at(stroke, positions)
        return np.any([distances(near, other) < tolerance for other in covering], axis=0)

    changes = np.flatnonzero(mask[:-1] != mask[1:])
    bounds = [0.0, *(_change(covered, at[i], at[i + 1]) for i in changes), length]
    left: list[tuple[float, float]] = []
    for index, (low, high) in enumerate(pairwise(bounds)):
        hidden = (index % 2 == 0) == bool(mask[0])
        if hidden and (len(bounds) == 2 or not _touches(stroke, low, high, covering, tolerance)):
            continue
        if left and left[-1][1] == low:
            left[-1] = (left[-1][0], high)
        else:
            left.append((low, high))
    if left == [(0.0, length)]:
        return [stroke]
    if len(left) > 1 and is_closed(stroke) and left[0][0] == 0.0 and left[-1][1] == length:
        # The part that goes over the start of a closed stroke.
        left[0] = (left.pop()[0] - length, left[0][1])
    return [part(stroke, low, high) for low, high in left if high - low >= fragment]


def _touches(
    stroke: DrawnStroke,
    low: float,
    high: float,
    others: Sequence[DrawnStroke],
    tolerance: float,
) -> bool:
    """Whether a stroke only touches others between two lengths, as a circle does its tangent.

    The distance from a tangent grows with the square of the length, the distance from a stroke of
    the same course does not grow.
    """
    points = points_at(stroke, low + np.array([0.1, 0.5, 0.9]) * (high - low))
    before, middle, after = np.min([distances(points, other) for other in others], axis=0)
    return bool((before + after) / 2.0 - middle > 0.12 * tolerance)


def _change(covered: Callable[[Points], npt.NDArray[np.bool_]], low: float, high: float) -> float:
    """Where between two positions the state changes, by repeated division."""
    for _ in range(_ROUNDS):
        grid = np.linspace(low, high, _DIVISIONS + 1)
        states = covered(grid)
        first = max(1, int(np.argmax(states != states[0])))
        low, high = grid[first - 1], grid[first]
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
    if isinstance(stroke, Ellipse):
        return stroke.whole.at(stroke.parameters(positions))
    vertices = np.array(stroke.points)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(vertices, axis=0).T))])
    return np.stack([np.interp(positions, along, vertices[:, axis]) for axis in (0, 1)], axis=1)


def distances(points: Points, stroke: DrawnStroke) -> Points:
    """(n,) distances of (n, 2) points from a stroke."""
    if isinstance(stroke, Segment):
        return _chain_distances(points, np.array([stroke.start, stroke.end]))
    if isinstance(stroke, Polyline):
        return _chain_distances(points, np.array(stroke.points))
    if isinstance(stroke, Ellipse):
        chain = as_chain(stroke, _CHORD * stroke.semi_major)
        return _chain_distances(points, np.array(chain.points))
    offsets = points - np.array(stroke.centre)
    turn = np.mod(np.arctan2(offsets[:, 1], offsets[:, 0]) - stroke.start_angle, 2.0 * np.pi)
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
