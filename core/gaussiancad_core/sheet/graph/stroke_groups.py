"""Groups of strokes that touch: what each spans, and what holds of its strokes."""

from dataclasses import dataclass

import numpy as np

from gaussiancad_core.sheet.graph.touching_ends import Flags, Floats, Ints, Touches

EVEN = 2.0
"""px by which what lies within a box may reach over it, and by which boxes that are as wide, or as
high, as each other differ: half of a wide line (ISO 128-2)."""


@dataclass(frozen=True, eq=False)
class Groups:
    """Groups of chosen strokes, each of those that touch.

    Attributes:
        places: (n,) the group of each stroke, from 0 on; -1 of those not chosen.
        boxes: (k, 4) px around each group.
        counts: (k,) strokes of each.
    """

    places: Ints
    boxes: Floats
    counts: Ints

    @property
    def sizes(self) -> Floats:
        """(k, 2) px that each group is wide and high."""
        return self.boxes[:, 2:] - self.boxes[:, :2]

    def members(self, group: int) -> Ints:
        """Numbers of the strokes of a group."""
        return np.flatnonzero(self.places == group)

    def sums(self, values: Floats | Flags) -> Floats:
        """(k,) sums over the strokes of each group of (n,) values."""
        chosen = self.places >= 0
        found = np.bincount(self.places[chosen], values[chosen], minlength=len(self.counts))
        return np.asarray(found, dtype=np.float64)

    def means(self, values: Floats | Flags) -> Floats:
        """(k,) the same over their number."""
        return self.sums(values) / self.counts

    def most(self, values: Floats) -> Floats:
        """(k, m) the largest of (n, m) values that no stroke has less than 0 of."""
        found = np.zeros((len(self.counts), values.shape[1]))
        chosen = self.places >= 0
        np.maximum.at(found, self.places[chosen], values[chosen])
        return found


def grouped(touches: Touches, chosen: Flags) -> Groups:
    """The groups of chosen strokes.

    Args:
        touches: of all strokes.
        chosen: (n,)
    """
    _, places = np.unique(touches.groups(chosen)[chosen], return_inverse=True)
    counts = np.bincount(places)
    low, high = np.full((len(counts), 2), np.inf), np.full((len(counts), 2), -np.inf)
    np.minimum.at(low, places, touches.boxes[chosen, :2])
    np.maximum.at(high, places, touches.boxes[chosen, 2:])
    every = np.full(len(chosen), -1)
    every[chosen] = places
    return Groups(every, np.concatenate([low, high], axis=1), counts)


def within(boxes: Floats, around: Floats) -> Flags:
    """(n,) which of (n, 4) boxes lie within another."""
    inside = (boxes[:, :2] >= around[:2] - EVEN) & (boxes[:, 2:] <= around[2:] + EVEN)
    return np.all(inside, axis=1)
