"""Lines that go on in each other, as the chords of a curve do, and how they turn."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.file_reading.joined_arcs import places_of
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Points

MEET = 0.02
"""mm within which ends of chords are one."""

LARGEST_TURN, _SMALLEST_TURN = np.radians(38.0), 1e-3
"""Turn from chord to chord at most, that of a circle of ten chords, and at least."""

_STRAIGHTEST = 0.3
"""Turn of the line that goes on, in that of the next straightest, at most where several meet."""

_CROWDED = 12
"""Ends at one place up to which a line goes on in another: of a fan, or of rays, none does."""

_UNEVEN = 3.5
"""Length of a chord in that of its neighbour at most, but for the first and the last."""

_Ints = npt.NDArray[np.int64]
_Step = tuple[int, int]
"""Number of a line, and which of its ends is the far one."""


def ends_of(line: PaperStroke) -> tuple[Point, Point]:
    """Both ends of a line, mm."""
    curve = line.curve
    assert isinstance(curve, LineSegment)
    return curve.start, curve.end


@dataclass(frozen=True, eq=False)
class Run:
    """Lines that go on in each other.

    Attributes:
        lines: in order.
        points: (n + 1, 2) mm that they go through.
        closed: whether the last goes on in the first.
    """

    lines: tuple[PaperStroke, ...]
    points: Points
    closed: bool


@dataclass(frozen=True, eq=False)
class Chords:
    """Lines of one pen, and where their ends meet.

    Attributes:
        lines: they.
        ends: (n, 2, 2) mm.
        ways: (n, 2) directions.
        places: (n, 2) number of the place at which each of their ends is.
        at: the ends at each place.
    """

    lines: Sequence[PaperStroke]
    ends: npt.NDArray[np.float64]
    ways: Points
    places: _Ints
    at: dict[int, list[_Step]]

    @classmethod
    def of(cls, lines: Sequence[PaperStroke]) -> "Chords":
        """Of one line or more."""
        ends = np.array([ends_of(line) for line in lines])
        places = places_of(ends.reshape(-1, 2), MEET).reshape(-1, 2)
        at: dict[int, list[_Step]] = defaultdict(list)
        for number, (first, last) in enumerate(places.tolist()):
            at[first].append((number, 0))
            at[last].append((number, 1))
        ways = ends[:, 1] - ends[:, 0]
        ways /= np.maximum(np.hypot(*ways.T), 1e-12)[:, None]
        return cls(lines, ends, ways, places, at)

    def runs(self) -> Iterator[Run]:
        """All lines, each in one run."""
        done = np.zeros(len(self.lines), dtype=bool)
        for first in range(len(self.lines)):
            if done[first]:
                continue
            if all(len(self.at[place]) == 1 for place in self.places[first].tolist()):
                yield Run((self.lines[first],), self.ends[first], False)
                continue
            seen = {first}
            ahead = self._walk((first, 1), seen, done)
            last = ahead[-1] if ahead else (first, 1)
            onward = self._next(last)
            closed = len(ahead) > 2 and onward is not None and onward[0] == first
            back = [] if closed else self._walk((first, 0), seen, done)
            steps = [(number, 1 - far) for number, far in reversed(back)] + [(first, 1), *ahead]
            done[[number for number, _ in steps]] = True
            number, far = steps[0]
            points = [self.ends[number, 1 - far]]
            points += [self.ends[number, far] for number, far in steps]
            yield Run(tuple(self.lines[n] for n, _ in steps), np.array(points), closed)

    def _walk(self, step: _Step, seen: set[int], done: npt.NDArray[np.bool_]) -> list[_Step]:
        """The lines from the far end of one on."""
        found: list[_Step] = []
        while (after := self._next(step)) and after[0] not in seen and not done[after[0]]:
            step = after[0], 1 - after[1]
            seen.add(step[0])
            found.append(step)
        return found

    def _next(self, step: _Step) -> _Step | None:
        """The line that goes on after the far end of another, and its near end: the only one, or
        the straightest by far."""
        number, far = step
        here = self.at[int(self.places[number, far])]
        if len(here) > _CROWDED:
            return None
        others = [item for item in here if item[0] != number]
        if len(others) == 1:
            return others[0]
        way = self.ways[number] if far else -self.ways[number]
        turns = sorted(
            (turn, other)
            for other in others
            if (turn := abs(_turn(way, self.ways[other[0]] * (1 - 2 * other[1])))) < LARGEST_TURN
        )
        if not turns or (len(turns) > 1 and turns[0][0] >= _STRAIGHTEST * turns[1][0]):
            return None
        return turns[0][1]


def _turn(one: Points, other: Points) -> float:
    return float(np.arctan2(one[0] * other[1] - one[1] * other[0], one @ other))


@dataclass(frozen=True, eq=False)
class Bends:
    """How a run turns from chord to chord.

    Attributes:
        bend: (n - 1,) whether each turn may be one of a curve.
        hard, soft: numbers of the chords before which a curve ends, and before which one ends that
            has two chords or more.
        count: n chords.
    """

    bend: npt.NDArray[np.bool_]
    hard: _Ints
    soft: _Ints
    count: int

    @classmethod
    def of(cls, points: Points) -> "Bends":
        """Of (n + 1, 2) points."""
        ways = np.diff(points, axis=0)
        turns = np.angle(np.exp(1j * np.diff(np.arctan2(ways[:, 1], ways[:, 0]))))
        bend = (np.abs(turns) <= LARGEST_TURN) & (np.abs(turns) >= _SMALLEST_TURN)
        lengths = np.hypot(*ways.T)
        low, high = np.minimum(lengths[:-1], lengths[1:]), np.maximum(lengths[:-1], lengths[1:])
        is_end = high > _UNEVEN * low
        # The last chord may be cut off.
        is_end[-1] = False
        is_end[1:] |= np.sign(turns[1:]) != np.sign(turns[:-1])
        return cls(bend, np.flatnonzero(~bend) + 1, np.flatnonzero(is_end) + 1, len(ways))

    def stop(self, first: int) -> int:
        """The point at which a curve from a point on ends at the latest."""
        found = self.count
        for ends, after in ((self.hard, first + 1), (self.soft, first + 2)):
            index = int(np.searchsorted(ends, after))
            if index < len(ends):
                found = min(found, int(ends[index]))
        return found
