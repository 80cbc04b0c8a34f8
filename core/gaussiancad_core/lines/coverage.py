"""Which part of a stroke runs along other strokes."""

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.line_tolerances import Precision
from gaussiancad_core.lines.strokes import DrawnStroke

Points = npt.NDArray[np.float64]

_FEW_SAMPLES = 24
_MOST_SAMPLES = 250
_DIVISIONS, _ROUNDS = 16, 4


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
        self._boxes[count] = stroke.box
        self._strokes.append(stroke)

    def near(self, stroke: DrawnStroke, tolerance: float) -> list[DrawnStroke]:
        """Those whose bounding boxes come within ``tolerance`` of a stroke's."""
        low, high = np.array(stroke.box).reshape(2, 2)
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
    few = stroke.points_at(_middles(_FEW_SAMPLES, length))
    reach = tolerance + 0.5 * length / _FEW_SAMPLES
    others = [other for other in others if other.distances(few).min() <= reach]
    if not others:
        return [stroke]
    count = int(np.clip(np.ceil(length / (4.0 * fragment)), 8, _MOST_SAMPLES))
    at = _middles(count, length)
    points = stroke.points_at(at)
    masks = [(other, other.distances(points) < tolerance) for other in others]
    covering = [other for other, mask in masks if mask.any()]
    if not covering:
        return [stroke]
    mask = np.any([mask for _, mask in masks], axis=0)

    def covered(positions: Points) -> npt.NDArray[np.bool_]:
        near = stroke.points_at(positions)
        return np.any([other.distances(near) < tolerance for other in covering], axis=0)

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
    if len(left) > 1 and stroke.is_closed and left[0][0] == 0.0 and left[-1][1] == length:
        # The part that goes over the start of a closed stroke.
        left[0] = (left.pop()[0] - length, left[0][1])
    return [stroke.part(low, high) for low, high in left if high - low >= fragment]


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
    points = stroke.points_at(low + np.array([0.1, 0.5, 0.9]) * (high - low))
    before, middle, after = np.min([other.distances(points) for other in others], axis=0)
    return bool((before + after) / 2.0 - middle > 0.12 * tolerance)


def _change(covered: Callable[[Points], npt.NDArray[np.bool_]], low: float, high: float) -> float:
    """Where between two positions the state changes, by repeated division."""
    for _ in range(_ROUNDS):
        grid = np.linspace(low, high, _DIVISIONS + 1)
        states = covered(grid)
        first = max(1, int(np.argmax(states != states[0])))
        low, high = grid[first - 1], grid[first]
    return (low + high) / 2.0
