"""Drawn lines as points of a view's plane, visible and hidden apart."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Linetype

if TYPE_CHECKING:
    from scipy.spatial import cKDTree


@dataclass(frozen=True, eq=False)
class LinePoints:
    """Points that lie closely on lines.

    Attributes:
        points: (n, 2) mm (right, up).
        lengths: (n,) mm of line that each point stands for.
    """

    points: npt.NDArray[np.float64]
    lengths: npt.NDArray[np.float64]

    def near(self, others: "LinePoints", tolerance: float) -> npt.NDArray[np.bool_]:
        """(n,) which of the points have one of the others within ``tolerance`` mm."""
        if not len(self.points) or not len(others.points):
            return np.zeros(len(self.points), dtype=bool)
        # The search takes less than its bound; what is exactly at it is to count.
        bound = np.nextafter(tolerance, np.inf)
        distances, _ = tree_of(others.points).query(self.points, distance_upper_bound=bound)
        return distances <= tolerance

    def share(self, chosen: npt.NDArray[np.bool_]) -> float:
        """Share of the length that the chosen points stand for; 1 where there is no line."""
        total = float(self.lengths.sum())
        return float(self.lengths[chosen].sum()) / total if total > 0.0 else 1.0

    def only(self, chosen: npt.NDArray[np.bool_]) -> "LinePoints":
        """The chosen points."""
        return LinePoints(self.points[chosen], self.lengths[chosen])


@dataclass(frozen=True, eq=False)
class Lines:
    """The lines of one view.

    Attributes:
        visible: of visible edges.
        hidden: of hidden edges.
    """

    visible: LinePoints
    hidden: LinePoints

    def without_hidden(self) -> "Lines":
        """The lines of a view that draws no hidden ones."""
        return Lines(self.visible, LinePoints(np.zeros((0, 2)), np.zeros(0)))


def tree_of(points: npt.NDArray[np.float64]) -> "cKDTree":
    """A tree of points (n, 2) along lines: even ones need no balance, which takes time to make."""
    from scipy.spatial import cKDTree

    return cKDTree(points, balanced_tree=False, compact_nodes=False)


def lines_of_strokes(strokes: Iterable[DrawnStroke], step: float) -> Lines:
    """Strokes in mm as points at the middles of equal pieces, at most ``step`` mm long."""
    found: dict[Linetype, list[LinePoints]] = {linetype: [] for linetype in Linetype}
    for stroke in strokes:
        if stroke.length <= 0.0:
            continue
        pieces = max(1, int(np.ceil(stroke.length / step - 1e-9)))
        # Of twice as many pieces every second end is a middle.
        points = stroke.sample(stroke.length / (2 * pieces) * (1.0 + 1e-9))[1::2]
        lengths = np.full(len(points), stroke.length / len(points))
        found[stroke.linetype].append(LinePoints(points, lengths))
    return Lines(_joined(found[Linetype.VISIBLE]), _joined(found[Linetype.HIDDEN]))


def _joined(parts: list[LinePoints]) -> LinePoints:
    return LinePoints(
        np.concatenate([np.zeros((0, 2)), *(part.points for part in parts)]),
        np.concatenate([np.zeros(0), *(part.lengths for part in parts)]),
    )
