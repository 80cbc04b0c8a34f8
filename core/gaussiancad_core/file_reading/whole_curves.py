"""Arcs and circles that a file draws as chords, each a line of its own.

Chords of one pen whose ends meet, and that turn one way, are one arc where all of their ends lie on
one circle, however few they are: ten make a circle.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from gaussiancad_core.files.fitting import circle_through
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.points import FULL_TURN, to_point, wrapped
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, Points

_MEET = 0.02
"""mm within which ends of chords are one."""

_LARGEST_TURN, _SMALLEST_TURN = np.radians(38.0), 1e-3
"""Turn from chord to chord at most, that of a circle of ten chords, and at least."""

_STRAIGHTEST = 0.3
"""Turn of the line that goes on, in that of the next straightest, at most where several meet."""

_FEWEST = 3
"""Chords of an arc at least."""

_SWEEP, _MANY, _SWEEP_OF_MANY = np.radians(20.0), 5, np.radians(8.0)
"""Turn of an arc at least; chords from which less will do, and how much that is."""

_LEAST_OFF, _OFF, _OFF_SHARE = 0.01, 0.04, 0.012
"""mm, and share of the radius besides, that ends of chords may lie beside their circle, and mm that
they may at most."""

_UNEVEN = 3.5
"""Length of a chord in that of its neighbour at most, but for the first and the last."""

_Ints = npt.NDArray[np.int64]
_Step = tuple[int, int]
"""Number of a line, and which of its ends is the far one."""


def once(strokes: Sequence[PaperStroke]) -> list[PaperStroke]:
    """The strokes without lines that one pen draws twice, whichever way."""
    seen = set()
    kept = []
    for stroke in strokes:
        if stroke.is_line:
            ends = tuple(sorted(tuple(point) for point in np.round(stroke.points, 2).tolist()))
            key = ends, stroke.pen, stroke.role, stroke.kind, bool(stroke.dashes)
            if key in seen:
                continue
            seen.add(key)
        kept.append(stroke)
    return kept


def with_whole_curves(strokes: Sequence[PaperStroke]) -> list[PaperStroke]:
    """The strokes with arcs and circles in place of the chords that draw them."""
    kept = [stroke for stroke in strokes if not stroke.is_line]
    of_pen = defaultdict(list)
    for stroke in strokes:
        if stroke.is_line:
            of_pen[stroke.pen, stroke.role, stroke.kind, bool(stroke.dashes)].append(stroke)
    for lines in of_pen.values():
        if len(lines) < _FEWEST:
            kept += lines
            continue
        chords = _Chords.of(lines)
        for run in chords.runs():
            kept += _arcs_along(run)
    return kept


@dataclass(frozen=True, eq=False)
class _Run:
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
class _Chords:
    """Lines of one pen, and where their ends meet.

    Attributes:
        lines: they.
        ways: (n, 2) directions.
        places: (n, 2) number of the place at which each of their ends is.
        at: the ends at each place.
    """

    lines: Sequence[PaperStroke]
    ways: Points
    places: _Ints
    at: dict[int, list[_Step]]

    @classmethod
    def of(cls, lines: Sequence[PaperStroke]) -> "_Chords":
        ends = np.concatenate([line.points for line in lines])
        places = places_of(ends, _MEET).reshape(-1, 2)
        at: dict[int, list[_Step]] = defaultdict(list)
        for number, (first, last) in enumerate(places.tolist()):
            at[first].append((number, 0))
            at[last].append((number, 1))
        return cls(lines, np.array([line.way for line in lines]), places, at)

    def runs(self) -> Iterator[_Run]:
        """All lines, each in one run."""
        done = np.zeros(len(self.lines), dtype=bool)
        for first in range(len(self.lines)):
            if done[first]:
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
            points = [self.lines[number].points[1 - far]]
            points += [self.lines[number].points[far] for number, far in steps]
            yield _Run(tuple(self.lines[n] for n, _ in steps), np.array(points), closed)

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
        others = [item for item in self.at[int(self.places[number, far])] if item[0] != number]
        if len(others) == 1:
            return others[0]
        way = self.ways[number] if far else -self.ways[number]
        turns = sorted(
            (turn, other)
            for other in others
            if (turn := abs(_turn(way, self.ways[other[0]] * (1 - 2 * other[1])))) < _LARGEST_TURN
        )
        if not turns or (len(turns) > 1 and turns[0][0] >= _STRAIGHTEST * turns[1][0]):
            return None
        return turns[0][1]


def places_of(points: Points, near: float) -> _Ints:
    """(n,) number of the place of each point; those that are near each other are at one."""
    pairs = cKDTree(points).query_pairs(near, output_type="ndarray")
    graph = coo_array((np.ones(len(pairs)), pairs.T), shape=(len(points), len(points)))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)


def _turn(one: Points, other: Points) -> float:
    return float(np.arctan2(one[0] * other[1] - one[1] * other[0], one @ other))


def _arcs_along(run: _Run) -> Iterator[PaperStroke]:
    """Arcs along a run, and its lines where there are none."""
    count = len(run.lines)
    if count < _FEWEST:
        yield from run.lines
        return
    ways = np.diff(run.points, axis=0)
    turns = np.angle(np.exp(1j * np.diff(np.arctan2(ways[:, 1], ways[:, 0]))))
    bends = (np.abs(turns) <= _LARGEST_TURN) & (np.abs(turns) >= _SMALLEST_TURN)
    if run.closed and not bends.all():
        # From a corner on nothing is cut in two.
        cut = int(np.argmin(bends)) + 1
        lines = (*run.lines[cut:], *run.lines[:cut])
        points = np.concatenate([run.points[cut:-1], run.points[: cut + 1]])
        yield from _arcs_along(_Run(lines, points, closed=False))
        return
    lengths = np.hypot(*ways.T)
    first = 0
    while first < count:
        last = _arc_end(run.points, lengths, turns, bends, first)
        arc = _arc(run.points[first : last + 1]) if last - first >= _FEWEST else None
        if arc is None:
            yield run.lines[first]
            first += 1
        else:
            yield replace(run.lines[first], curve=arc)
            first = last


def _arc_end(
    points: Points, lengths: Points, turns: Points, bends: npt.NDArray[np.bool_], first: int
) -> int:
    """The last point up to which the chords from a point on lie on one circle."""
    count = len(lengths)
    last = first + 1
    sign = 0.0
    while last < count:
        turn = turns[last - 1]
        if not bends[last - 1] or (sign and np.sign(turn) != sign):
            break
        short, long = sorted((lengths[last - 1], lengths[last]))
        is_inner = last - 1 != first and last != count - 1
        if is_inner and long > _UNEVEN * short:
            break
        if last - first >= 2 and not _is_on_circle(points[first : last + 2]):
            break
        sign = np.sign(turn)
        last += 1
    return last


def _is_on_circle(points: Points) -> bool:
    centre, radius = circle_through(points)
    off = float(np.abs(np.hypot(*(points - centre).T) - radius).max())
    return off <= min(_OFF, _LEAST_OFF + _OFF_SHARE * radius)


def _arc(points: Points) -> CircularArc | None:
    """The arc that points lie on, where it turns far enough."""
    centre, radius = circle_through(points)
    away = points - centre
    angles = np.unwrap(np.arctan2(away[:, 1], away[:, 0]))
    sweep = float(angles[-1] - angles[0])
    least = _SWEEP_OF_MANY if len(points) > _MANY else _SWEEP
    if abs(sweep) < least:
        return None
    if np.hypot(*(points[-1] - points[0])) < _MEET and abs(sweep) > np.pi:
        sweep = np.copysign(FULL_TURN, sweep)
    start = float(angles[0] if sweep > 0.0 else angles[-1])
    return CircularArc(to_point(centre), radius, wrapped(start), min(abs(sweep), FULL_TURN))
