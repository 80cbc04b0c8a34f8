"""Corners between two straight strokes, and how far pixels are from them, sharp, round or cut."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class End:
    """An end of a straight piece.

    Attributes:
        index: of the piece.
        at_start: whether it is the start of the piece.
        place: (2,) px.
        inward: (2,) unit vector into the piece.
        length: px of the piece.
    """

    index: int
    at_start: bool
    place: Floats
    inward: Floats
    length: float


@dataclass(frozen=True)
class Corner:
    """Where two lines meet, and the pixels around.

    Attributes:
        first, second: the ends that meet.
        place: (2,) px of the lines' crossing.
        longest: px from there to where an arc may begin.
        passes: whether the second stroke is a side of one that runs past the corner.
        instead: numbers of arcs that begin where the first stroke ends and miss the second.
    """

    first: End
    second: End
    place: Floats
    longest: float
    passes: bool = False
    instead: tuple[int, ...] = ()

    @property
    def half(self) -> float:
        """Half of the angle between the strokes."""
        cosine = float(np.clip(self.first.inward @ self.second.inward, -1.0, 1.0))
        return 0.5 * float(np.arccos(cosine))

    @property
    def bisector(self) -> Floats:
        """(2,) unit vector to between the strokes."""
        total = self.first.inward + self.second.inward
        return total / np.hypot(*total)

    def circle(self, radius: float) -> Circle:
        """The circle that touches both lines."""
        centre = self.place + radius / np.sin(self.half) * self.bisector
        return Circle((float(centre[0]), float(centre[1])), radius)

    def shares(self, offsets: Floats) -> tuple[Floats, Floats]:
        """(n, 2) px from the corner -> (n,) px along the first and the second stroke whose sum
        that is: both positive between the strokes."""
        u, v = self.first.inward, self.second.inward
        cross = u[0] * v[1] - u[1] * v[0]
        x, y = offsets.T
        return (x * v[1] - y * v[0]) / cross, (u[0] * y - u[1] * x) / cross


def from_ray(end: End, offsets: Floats, begin: float = 0.0) -> Floats:
    """(n,) px from a stroke that begins some px from the corner."""
    along = offsets @ end.inward - begin
    across = offsets[:, 0] * end.inward[1] - offsets[:, 1] * end.inward[0]
    return np.hypot(np.minimum(along, 0.0), across)


def from_passing(corner: Corner, offsets: Floats) -> Floats:
    """(n,) px from the line that runs past a corner; infinite where none does."""
    if not corner.passes:
        return np.full(len(offsets), np.inf)
    x, y = corner.second.inward
    return np.abs(offsets[:, 0] * y - offsets[:, 1] * x)


def from_joins(corner: Corner, offsets: Floats) -> list[Floats]:
    """Distances from a sharp corner: round, pointed, and with square ends that leave a notch.

    Where a line runs past, those from a stroke that reaches it, and from one that does not.
    """
    rays = [from_ray(end, offsets) for end in (corner.first, corner.second)]
    if corner.passes:
        short = max(float((corner.first.place - corner.place) @ corner.first.inward), 0.0)
        ends = [rays[0], from_ray(corner.first, offsets, short)]
        return [np.minimum(end, from_passing(corner, offsets)) for end in ends]
    round_join = np.minimum(*rays)
    along = [offsets @ end.inward for end in (corner.first, corner.second)]
    across = [
        np.abs(offsets[:, 0] * end.inward[1] - offsets[:, 1] * end.inward[0])
        for end in (corner.first, corner.second)
    ]
    outside = (along[0] < 0.0) & (along[1] < 0.0)
    pointed = np.where(outside, np.maximum(*across), round_join)
    square = np.minimum(
        *(np.where(a >= 0.0, c, np.inf) for a, c in zip(along, across, strict=True))
    )
    return [round_join, pointed, np.where(np.isfinite(square), square, 1e3)]


def from_fillet(corner: Corner, offsets: Floats, radius: float) -> Floats:
    """Distances from two strokes and the arc that touches both."""
    around = offsets - radius / np.sin(corner.half) * corner.bisector
    distance = np.hypot(*around.T)
    facing = -(around @ corner.bisector) >= distance * np.sin(corner.half)
    arc = np.where(facing, np.abs(distance - radius), np.inf)
    return np.minimum(arc, _from_both(corner, offsets, radius / np.tan(corner.half)))


def from_cut(corner: Corner, offsets: Floats, begin: float) -> Floats:
    """Distances from two strokes and the straight piece that cuts their corner."""
    start = begin * corner.first.inward
    way = begin * corner.second.inward - start
    share = np.clip((offsets - start) @ way / (way @ way), 0.0, 1.0)
    cut = np.hypot(*(offsets - start - share[:, None] * way).T)
    return np.minimum(cut, _from_both(corner, offsets, begin))


def _from_both(corner: Corner, offsets: Floats, begin: float) -> Floats:
    """Distances from two strokes that begin some px from their corner, or run past it."""
    away = np.minimum(*(from_ray(end, offsets, begin) for end in (corner.first, corner.second)))
    return np.minimum(away, from_passing(corner, offsets)) if corner.passes else away
