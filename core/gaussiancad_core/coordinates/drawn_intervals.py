"""Drawn intervals: the stretches of lines and circles that the views draw.

Where strokes end is computed again from the curves that they end at; the ends as read are not used
but to choose among those.  Where one line runs closely along another for a while, as hidden ones
that cross at a small angle do, a picture shows one of them only; the gap in the other is closed.
So are gaps that are no wider than the tolerance: files cut arcs, and round each piece by itself.
"""

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf

import numpy as np

from gaussiancad_core.coordinates.ambiguous_linetypes import UNSURE
from gaussiancad_core.coordinates.joints import joints_of
from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.tolerances import APART
from gaussiancad_core.geometry.whole_curves import Line, LineOrCircle, meetings
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

_BESIDE = 6.0
"""Tolerances beside a line within which a picture may not show another one."""

_ALONGSIDE, _SLIDES = 0.25, 24.0
"""Tolerances within which another curve runs along at the end of a stroke, so that where the two
meet is not seen, and by which the end may be off then."""

_STEP = 2.0
"""Tolerances between the places of a gap that are looked at."""


@dataclass(frozen=True)
class Interval:
    """A stretch of a carrier that a view draws.

    Attributes:
        low, high: parameters of the carrier's curve; 0 to 2 pi on circles.
        linetype: how it is drawn.
        confidence: 0 to 1; without any it may be drawn or not.
    """

    low: float
    high: float
    linetype: Linetype
    confidence: float


@dataclass(frozen=True)
class Carrier:
    """A curve with what the views draw on it.

    Attributes:
        curve: line or circle, in plane units.
        intervals: of each view of the plane.
    """

    curve: LineOrCircle
    intervals: dict[Role, tuple[Interval, ...]]

    def drawn(self, reach: float = 1e-4) -> list[tuple[float, float]]:
        """The stretches that any view draws, merged, ascending."""
        return merged_intervals(
            (
                (interval.low, interval.high)
                for intervals in self.intervals.values()
                for interval in intervals
            ),
            reach / self.curve.speed,
        )

    def linetype_at(self, role: Role, parameter: float, reach: float = 1e-4) -> Linetype | None:
        """What a view draws at a parameter; visible lines hide hidden ones under them."""
        slack = reach / self.curve.speed
        found = None
        for interval in self.intervals.get(role, ()):
            if (
                interval.confidence > 0.0
                and interval.low - slack <= parameter <= interval.high + slack
            ):
                if interval.linetype is Linetype.VISIBLE:
                    return Linetype.VISIBLE
                found = Linetype.HIDDEN
        return found

    def is_open_at(self, role: Role, parameter: float, reach: float = 1e-4) -> bool:
        """Whether a view may draw the carrier at a parameter, or may not."""
        slack = reach / self.curve.speed
        return any(
            interval.confidence == 0.0
            and interval.low - slack <= parameter <= interval.high + slack
            for interval in self.intervals.get(role, ())
        )

    def is_unsure_at(self, role: Role, parameter: float, reach: float = 1e-4) -> bool:
        """Whether a view draws the carrier at a parameter without telling its linetype."""
        slack = reach / self.curve.speed
        found = [
            interval.confidence
            for interval in self.intervals.get(role, ())
            if interval.low - slack <= parameter <= interval.high + slack
        ]
        return 0.0 < max(found, default=0.0) <= UNSURE


def merged_intervals(
    stretches: Iterable[tuple[float, float]], slack: float
) -> list[tuple[float, float]]:
    """Intervals that overlap or lie within ``slack`` of each other as one, ascending."""
    merged: list[list[float]] = []
    for low, high in sorted(stretches):
        if merged and low <= merged[-1][1] + slack:
            merged[-1][1] = max(merged[-1][1], high)
        else:
            merged.append([low, high])
    return [(low, high) for low, high in merged]


@dataclass(frozen=True)
class DrawnInterval:
    """A stroke on its curve.

    Attributes:
        role: the view.
        ends: lowest and highest parameter as read; the highest of an arc may exceed 2 pi.
        linetype: how it is drawn.
        confidence: 0 to 1.
    """

    role: Role
    ends: tuple[float, float]
    linetype: Linetype
    confidence: float


def carriers_with_intervals(
    curves: Sequence[LineOrCircle],
    strokes: Sequence[tuple[int, DrawnInterval]],
    grid: Sequence[LineOrCircle],
    tolerance: float,
) -> tuple[Carrier, ...]:
    """Curves with what is drawn on them.

    Args:
        curves: of one plane.
        strokes: with the number of their curve.
        grid: other lines that strokes may end at.
        tolerance: units by which the end of a stroke may be off.
    """
    reach = max(3.0 * tolerance, APART)
    own_stations = [stations_on(curve, list(curves)) for curve in curves]
    stations = [
        sorted({*items, *stations_on(curve, list(grid))})
        for curve, items in zip(curves, own_stations, strict=True)
    ]
    joints = joints_of(curves, [(index, stroke.ends) for index, stroke in strokes], reach)
    intervals: list[dict[Role, list[Interval]]] = [{} for _ in curves]
    for (index, stroke), joint in zip(strokes, joints, strict=True):
        curve = curves[index]
        this_spans = intervals[index].setdefault(stroke.role, [])
        slack = reach / curve.speed
        ends = _joined(curve, stroke.ends, joint, own_stations[index])
        ends = _slid(curve, ends, (stations[index], slack), curves, tolerance)
        for low, high in _settled(curve, ends, stations[index], slack):
            if high - low > 1e-9:
                this_spans.append(Interval(low, high, stroke.linetype, stroke.confidence))
    found = [
        Carrier(curve, {role: tuple(items) for role, items in by_role.items()})
        for curve, by_role in zip(curves, intervals, strict=True)
    ]
    return tuple(_filled(carrier, found, tolerance) for carrier in found)


def _joined(
    curve: LineOrCircle,
    ends: tuple[float, float],
    joints: tuple[float | None, float | None],
    stations: list[float],
) -> tuple[float, float]:
    """A stroke's ends, led to their joints where no other curve of the plane is met nearer by.

    Args:
        curve: of the stroke.
        ends: as read.
        joints: of both ends, None where there is none.
        stations: where the curve meets others of the plane.
    """
    if not isinstance(curve, Line):
        if ends[1] - ends[0] >= FULL_TURN:
            return ends
        stations = [station + turn for turn in (-FULL_TURN, 0.0, FULL_TURN) for station in stations]
    low, high = (
        end if joint is None or _is_nearer(stations, end, joint) else joint
        for end, joint in zip(ends, joints, strict=True)
    )
    return low, high


def _is_nearer(stations: list[float], end: float, joint: float) -> bool:
    """Whether a station is nearer to an end than its joint, which is one of them."""
    nearest = nearest_station(stations, end, inf)
    return abs(nearest - end) < abs(joint - end) - 1e-9


def _slid(
    curve: LineOrCircle,
    ends: tuple[float, float],
    seen: tuple[list[float], float],
    others: Sequence[LineOrCircle],
    tolerance: float,
) -> tuple[float, float]:
    """A stroke's ends, those that lie at no station led to where a curve that runs along is met:
    an arc of a large radius passes into its tangent many tolerances before or after it seems to."""
    stations, slack = seen
    every = stations
    if not isinstance(curve, Line):
        if ends[1] - ends[0] >= FULL_TURN:
            return ends
        every = [station + turn for turn in (-FULL_TURN, 0.0, FULL_TURN) for station in stations]
    found = []
    for end in ends:
        near = [value for value in every if abs(value - end) * curve.speed <= _SLIDES * tolerance]
        if not near or min(abs(value - end) for value in near) <= slack:
            found.append(end)
            continue
        here = curve.at(end)
        adjacent_os = [
            o for o in others if o.distance(here) <= _ALONGSIDE * tolerance and o != curve
        ]
        met = [
            value
            for value in near
            if any(other.distance(curve.at(value)) <= 1e-6 for other in adjacent_os)
        ]
        found.append(min(met, key=lambda value: abs(value - end), default=end))
    return found[0], found[1]


def _settled(
    curve: LineOrCircle, ends: tuple[float, float], stations: list[float], slack: float
) -> list[tuple[float, float]]:
    """A stroke's ends at stations; arcs are cut where angles begin again."""
    low, high = ends
    if isinstance(curve, Line):
        return [(nearest_station(stations, low, slack), nearest_station(stations, high, slack))]
    if high - low >= FULL_TURN - slack:
        return [(0.0, FULL_TURN)]
    around = [s + turn for turn in (-FULL_TURN, 0.0, FULL_TURN) for s in stations]
    low, high = nearest_station(around, low, slack), nearest_station(around, high, slack)
    turns = np.floor(low / FULL_TURN + 1e-12) * FULL_TURN
    low, high = max(0.0, low - turns), high - turns
    if high <= FULL_TURN + 1e-12:
        return [(low, min(high, FULL_TURN))]
    return [(low, FULL_TURN), (0.0, high - FULL_TURN)]


def _filled(carrier: Carrier, others: Sequence[Carrier], tolerance: float) -> Carrier:
    """The carrier without cracks, and with those gaps closed along which another line runs."""
    intervals = {}
    for role, this_spans in carrier.intervals.items():
        gaps = [
            Interval(one.high, two.low, one.linetype, min(one.confidence, two.confidence))
            for one, two in _neighbours(this_spans)
            if all(
                any(
                    _runs_by(other, role, carrier.curve.at(at), _BESIDE * tolerance)
                    for other in others
                    if other is not carrier
                )
                for at in _places(carrier.curve, one.high, two.low, _STEP * tolerance)
            )
        ]
        cracks = _cracks(this_spans, tolerance / carrier.curve.speed)
        intervals[role] = (*this_spans, *gaps, *cracks)
    return Carrier(carrier.curve, intervals)


def _cracks(intervals: Sequence[Interval], slack: float) -> Iterator[Interval]:
    """What lacks between intervals that end within ``slack`` of each other."""
    before: Interval | None = None
    for interval in sorted(intervals, key=lambda this_span: this_span.low):
        if before is not None and 1e-9 < interval.low - before.high <= slack:
            confidence = min(before.confidence, interval.confidence)
            yield Interval(before.high, interval.low, before.linetype, confidence)
        if before is None or interval.high > before.high:
            before = interval


def _neighbours(intervals: Sequence[Interval]) -> Iterator[tuple[Interval, Interval]]:
    """Spans of one linetype with a gap between them."""
    for linetype in Linetype:
        this_spans = sorted(
            (s for s in intervals if s.linetype is linetype), key=lambda interval: interval.low
        )
        yield from ((one, two) for one, two in pairwise(this_spans) if two.low - one.high > 1e-9)


def _places(curve: LineOrCircle, low: float, high: float, step: float) -> list[float]:
    count = int((high - low) * curve.speed / step) + 2
    return [low + (high - low) * (k + 0.5) / count for k in range(count)]


def _runs_by(other: Carrier, role: Role, point: Point, near: float) -> bool:
    """Whether a view draws a line near a point."""
    if other.curve.distance(point) > near:
        return False
    return other.linetype_at(role, other.curve.parameter(point), near) is not None


def stations_on(curve: LineOrCircle, others: list[LineOrCircle]) -> list[float]:
    """Parameters where a curve meets others, ascending; it never meets itself."""
    return sorted({curve.parameter(point) for other in others for point in meetings(curve, other)})


def nearest_station(stations: list[float], parameter: float, slack: float) -> float:
    """The station nearest to a parameter, or the parameter where none is within ``slack``."""
    at = bisect_left(stations, parameter)
    near = stations[max(0, at - 1) : at + 1]
    best = min(near, key=lambda station: abs(station - parameter), default=parameter)
    return best if abs(best - parameter) <= slack else parameter
