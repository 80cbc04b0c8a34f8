"""Where the ends of strokes lie on other strokes."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from gaussiancad_core.geometry.chains import LineSegment, chain_distances
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.sheet.picture_noise import COARSE_STEP

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]

_CLOSED = 0.1
"""px between the ends of a curve that is closed."""


@dataclass(frozen=True, eq=False)
class Touches:
    """Which ends touch which strokes.

    Attributes:
        ends: (n, 2, 2) px of the two ends of each stroke.
        boxes: (n, 4) px around each.
        end: (m,) 2 i + k for end k of stroke i.
        other: (m,) the stroke that it touches.
        reach: px within which it does.
    """

    ends: Floats
    boxes: Floats
    end: Ints
    other: Ints
    reach: float

    @property
    def closed(self) -> Flags:
        """(n,) which strokes end where they begin."""
        gap = np.hypot(*(self.ends[:, 0] - self.ends[:, 1]).T)
        extent = np.maximum(*(self.boxes[:, 2:] - self.boxes[:, :2]).T)
        return (gap < _CLOSED) & (extent > 2.0 * _CLOSED)

    def met(self, chosen: Flags) -> Flags:
        """(n, 2) which ends of chosen strokes touch another chosen one."""
        return self.met_by(chosen) & chosen[:, None]

    def met_by(self, chosen: Flags) -> Flags:
        """(n, 2) which ends of all strokes touch a chosen one."""
        found = np.zeros(2 * len(self.ends), dtype=bool)
        found[self.end[chosen[self.other]]] = True
        return found.reshape(-1, 2)

    def dividing(self, chosen: Flags) -> Flags:
        """(n,) which chosen strokes run from within one chosen stroke to within another."""
        return self.dividing_by(chosen) & chosen

    def dividing_by(self, chosen: Flags) -> Flags:
        """(n,) which of all strokes run from within one chosen stroke to within another."""
        values = chosen[self.other]
        end, other = self.end[values], self.other[values]
        place = self.ends.reshape(-1, 2)[end]
        away = np.hypot(*np.moveaxis(self.ends[other] - place[:, None], 2, 0)).min(axis=1)
        found = np.zeros(2 * len(self.ends), dtype=bool)
        found[end[away > self.reach]] = True
        return np.all(found.reshape(-1, 2), axis=1)

    def groups(self, chosen: Flags) -> Ints:
        """(n,) numbers of groups of chosen strokes that touch; -1 of those not chosen."""
        values = chosen[self.end // 2] & chosen[self.other]
        count = len(self.ends)
        pairs = (np.ones(int(values.sum())), (self.end[values] // 2, self.other[values]))
        _, labels = connected_components(coo_matrix(pairs, (count, count)), directed=False)
        return np.where(chosen, labels, -1)


def touching(curves: Sequence[Curve], reach: float) -> Touches:
    """Find the ends that lie within ``reach`` px of other curves."""
    chords = [_chords(curve) for curve in curves]
    ends = np.array([(points[0], points[-1]) for points in chords]).reshape(-1, 2, 2)
    boxes = np.array([curve.box for curve in curves], dtype=float).reshape(-1, 4)
    places = ends.reshape(-1, 2)
    order = np.argsort(places[:, 0], kind="stable")
    columns = places[order, 0]
    found_ends, found_others = [], []
    for index, points in enumerate(chords):
        x0, y0, x1, y1 = boxes[index] + (-reach, -reach, reach, reach)
        near = order[slice(*np.searchsorted(columns, (x0, x1)))]
        rows = places[near, 1]
        near = near[(rows >= y0) & (rows <= y1) & (near // 2 != index)]
        near = near[chain_distances(places[near], points) <= reach]
        found_ends.append(near)
        found_others.append(np.full(len(near), index))
    empty = [np.empty(0, np.int64)]
    end, other = (np.concatenate(found or empty) for found in (found_ends, found_others))
    return Touches(ends, boxes, end, other, reach)


def _chords(curve: Curve) -> Floats:
    return curve.vertices(np.inf if isinstance(curve, LineSegment) else COARSE_STEP)
