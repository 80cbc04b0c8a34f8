"""Round ends of hidden slots: half a circle between two parallel hidden lines.

A small half circle shows as two or three dashes, too few points to be grown, and each of them is
nearly straight.  As with :mod:`gaussiancad_core.sheet.hidden_fillets` all is known of it but one
number: its radius is half of the distance between the lines, and its centre lies midway.  Where
along them it lies is where the ink beyond their ends is on the half circle, all of it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.corner_dashes import longest_blank
from gaussiancad_core.sheet.corners import End
from gaussiancad_core.sheet.fillets import is_chord, straight_ends
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.junctions import Placed
from gaussiancad_core.sheet.runs import Piece, Rhythm, widest_gap
from gaussiancad_core.sheet.shapes import sample
from gaussiancad_core.views import Linetype

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

_LEAST_RADIUS, _MOST_RADIUS = 2.0, 4.0
"""Radius at least, in stroke widths, and at most, in dashes: larger arcs are grown."""

_PARALLEL = 0.02
"""Sine of the angle between the lines at most."""

_LONG = 1.5
"""Dashes from which a piece is no dash of the arc."""

_STEP = 0.5
"""px between places along the arc, and between the centres that are tried."""

_AT_LINES = np.radians(25.0)
"""At either end of the arc, where the ink is that of the lines as well."""

_INTO_PX = 0.6
"""px by which the arc has left a side's line where that ends at the latest."""

_DARK = 0.5
"""Weight of the ink, in that of dashes, from which a place is ink."""

_INKED = 0.35
"""Share of the arc between its ends that is ink at least, where it is not crossed."""

_CLEAR = 0.3
"""Share of it at least that no other stroke crosses."""

_OFF_PX = 0.3
"""px by which the ink's middle is off the arc, root mean square, at most."""

_BESIDE = 0.06
"""Share of the ink within the end that lies beside the arc at most."""


@dataclass(frozen=True)
class _Slot:
    """Two lines that may end in a half circle.

    Attributes:
        ends: of the two lines, by number of the piece.
        middle: (2,) px between the lines, where the farther one ends.
        way: (2,) unit vector along them and out of the slot.
        side: (2,) unit vector from the middle to the second line.
        radius: px.
    """

    ends: tuple[End, End]
    middle: Floats
    way: Floats
    side: Floats
    radius: float


def with_slot_ends(pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> list[Placed]:
    """The pieces of a view, hidden lines with the half circles in which two of them end.

    Args:
        pieces: where their ink is seen; px, pixel centres at integers.
        sheet: the ink.
        rhythm: of its dashes.
    """
    found = list(pieces)
    arcs: list[Placed] = []
    taken: set[tuple[int, bool]] = set()
    for slot in _slots(pieces, sheet.stroke_width, rhythm):
        if any((end.index, end.at_start) in taken for end in slot.ends):
            continue
        arc = _arc(slot, pieces, sheet, rhythm)
        if arc is None:
            continue
        arcs.append(arc)
        for end in slot.ends:
            taken.add((end.index, end.at_start))
            line, piece = found[end.index]
            at = float(line.positions(np.array([arc[0].centre]))[0])
            found[end.index] = (line, replace(piece, **{"start" if end.at_start else "end": at}))
    chords = {
        k
        for k, own in enumerate(found)
        if own[1].linetype is Linetype.HIDDEN and any(is_chord(own, arc) for arc in arcs)
    }
    return [own for k, own in enumerate(found) if k not in chords] + arcs


def _slots(pieces: Sequence[Placed], width: float, rhythm: Rhythm) -> Iterator[_Slot]:
    """The pairs of ends that a half circle may join, narrow ones first."""
    long = [
        end for end in straight_ends(pieces, Linetype.HIDDEN) if end.length >= _LONG * rhythm.dash
    ]
    found = []
    for one, other in combinations(long, 2):
        # Both lead away from the end.
        if one.inward @ other.inward < 1.0 - _PARALLEL**2 / 2.0:
            continue
        apart = other.place - one.place
        along = float(apart @ one.inward)
        across = apart - along * one.inward
        radius = float(np.hypot(*across)) / 2.0
        if not _LEAST_RADIUS * width <= radius <= _MOST_RADIUS * rhythm.dash:
            continue
        if abs(along) > rhythm.dash + widest_gap(rhythm) + radius:
            continue
        outer = one.place + min(along, 0.0) * one.inward
        middle, side = outer + across / 2.0, across / (2.0 * radius)
        slot = _Slot((one, other), middle, -one.inward, side, radius)
        found.append(slot)
    return iter(sorted(found, key=lambda slot: slot.radius))


def _arc(slot: _Slot, pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm) -> Placed | None:
    """The half circle that the ink beyond the ends lies on, if there is one."""
    window = _Window.around(slot, pieces, sheet, rhythm)
    # Beyond the centre a side has left its line, unlike that of a drill, whose tip begins there.
    behind, beyond = np.sqrt(2.0 * slot.radius * _INTO_PX), widest_gap(rhythm) + rhythm.dash
    tried = np.arange(-behind, beyond, _STEP)
    shares = [window.inked(slot, float(place)).sum() for place in tried]
    best = float(tried[int(np.argmax(shares))])
    best = _centred(window, slot, best)
    if best is None or best < -behind or not _is_told(window, slot, best, rhythm):
        return None
    centre = slot.middle + best * slot.way
    circle = Circle((float(centre[0]), float(centre[1])), slot.radius)
    first, second = centre - slot.radius * slot.side, centre + slot.radius * slot.side
    start, end, top = circle.positions(np.array([first, second, centre + slot.radius * slot.way]))
    if (top - start) % circle.around > circle.around / 2.0:
        start, end = end, start
    start = float(start)
    return circle, Piece(start, start + circle.around / 2.0, Linetype.HIDDEN, 1.0)


@dataclass(frozen=True, eq=False)
class _Window:
    """The ink around an end, and where it is not known whose it is.

    Attributes:
        weight: (h, w) float32 0..1.
        others: (h, w) float32, 1 on strokes that cross the end.
        level: weight from which a place is ink.
        reach: px on either side of a dash's middle that its ink covers.
    """

    weight: npt.NDArray[np.float32]
    others: npt.NDArray[np.float32]
    level: float
    reach: float

    @classmethod
    def around(
        cls, slot: _Slot, pieces: Sequence[Placed], sheet: CleanSheet, rhythm: Rhythm
    ) -> "_Window":
        """The window of a slot's end."""
        others = np.zeros(sheet.weight.shape, np.uint8)
        own = {end.index for end in slot.ends}
        width = int(np.ceil(sheet.stroke_width)) + 2
        near = 2.0 * (slot.radius + rhythm.dash)
        for index, (geometry, piece) in enumerate(pieces):
            length = piece.end - piece.start
            if index in own or length < _LONG * rhythm.dash:
                continue
            ends = np.array([piece.start - 1.0, piece.end + 1.0])
            points = geometry.points_at(
                ends if isinstance(geometry, Line) else np.linspace(*ends, int(length) + 2)
            )
            if isinstance(geometry, Line) or geometry.distances(slot.middle[None])[0] < near:
                path = np.rint(points * 8).astype(np.int32)
                cv2.polylines(others, [path], False, 1, width, shift=3)
        lines = [pieces[end.index] for end in slot.ends]
        inked = np.concatenate([_along(line, sheet) for line in lines])
        level = _DARK * float(np.quantile(inked, 0.8))
        return cls(sheet.weight, others.astype(np.float32), level, sheet.stroke_width / 2.0 + 1.0)

    def places(self, slot: _Slot, place: float, aside: float = 0.0) -> Floats:
        """(n, 2) px along the arc whose centre lies at a place, without its ends."""
        radius = slot.radius + aside
        count = int(np.pi * slot.radius / _STEP)
        angles = np.linspace(_AT_LINES, np.pi - _AT_LINES, count)
        centre = slot.middle + place * slot.way
        around = np.cos(angles)[:, None] * slot.side + np.sin(angles)[:, None] * slot.way
        return centre + radius * around

    def inked(self, slot: _Slot, place: float) -> Flags:
        """(n,) which places of the arc are ink of its own."""
        points = self.places(slot, place)
        return (_at(self.weight, points) > self.level) & self.clear(slot, place)

    def clear(self, slot: _Slot, place: float) -> Flags:
        """(n,) which places of the arc no other stroke crosses."""
        return _at(self.others, self.places(slot, place)) < 0.5


def _centred(window: _Window, slot: _Slot, place: float) -> float | None:
    """The place at which the ink is on both sides of the arc alike; None if it is not near it."""
    across = np.arange(-2.0, 2.25, 0.25)
    for _ in range(4):
        inked = window.inked(slot, place)
        if not inked.any():
            return None
        ink = np.stack([_at(window.weight, window.places(slot, place, by)) for by in across], 1)
        off = (ink @ across) / np.maximum(ink.sum(axis=1), 1e-6)
        lift = np.linspace(_AT_LINES, np.pi - _AT_LINES, len(inked))
        # A centre farther out moves the arc by the sine of the angle along its radius.
        sine = np.sin(lift)[inked]
        place += float((off[inked] * sine).sum() / (sine**2).sum())
    left = off[inked]
    return place if float(np.sqrt(np.mean(left**2))) <= _OFF_PX else None


def _is_told(window: _Window, slot: _Slot, place: float, rhythm: Rhythm) -> bool:
    """Whether the ink beyond the ends is that of a dashed half circle, and nothing else."""
    clear, inked = window.clear(slot, place), window.inked(slot, place)
    if clear.mean() < _CLEAR or inked.sum() < _INKED * clear.sum():
        return False
    if longest_blank(inked | ~clear) * _STEP > widest_gap(rhythm):
        return False
    # Dashes on both sides: a fillet has them on one.
    if any(not half.any() for half in np.array_split(inked, 2)):
        return False
    reach = slot.radius + window.reach
    grid = np.arange(-reach, reach + _STEP, _STEP)
    sides, ways = (axis.ravel() for axis in np.meshgrid(grid, grid[grid >= 0.0]))
    middle = slot.middle + place * slot.way
    points = middle + sides[:, None] * slot.side + ways[:, None] * slot.way
    ink = np.where(_at(window.others, points) < 0.5, _at(window.weight, points), 0.0)
    away = np.abs(np.hypot(sides, ways) - slot.radius)
    return float(ink[away > window.reach].sum()) <= _BESIDE * float(ink.sum())


def _along(placed: Placed, sheet: CleanSheet) -> Floats:
    """(n,) weights along a piece."""
    geometry, piece = placed
    return _at(sheet.weight, geometry.points_at(np.arange(piece.start, piece.end, 1.0)))


def _at(image: npt.NDArray[np.float32], points: Floats) -> Floats:
    """(n,) values of an image at (n, 2) px."""
    return sample(image, points[:, :1], points[:, 1:])[:, 0].astype(np.float64)
