"""What the strokes of a view lie on: lines along an axis, slanted lines, circles.

Strokes are in px of the view's plane.  Strokes that continue each other share their support.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.sheet.registration.stroke_precision import Precision

Floats = npt.NDArray[np.float64]

_LEANING = 0.2
"""Lean in standard deviations of one px from which a line counts half: something pulled its fit."""

_DASHED = 0.5
"""Ink of a hidden stroke over its length."""

_OPEN = 0.3
"""What the ink of an open arc counts for: where its tangents leave it, theirs pulls its fit."""

_WHOLE = 2 * np.pi * (1.0 - 1e-9)

_TURN = np.radians(0.5)
"""Slanted strokes that differ by more than this do not continue each other."""

_DRIFT = 5e-4
"""Share of its length by which a line along an axis may lean, for what turning the sheet left."""


@dataclass(frozen=True)
class AxisLine:
    """A line along an axis of the plane.

    Attributes:
        fixed: 0 if its right coordinate is constant, 1 if its up coordinate is.
        at: px.
        weight: px of ink that tell it.
    """

    fixed: int
    at: float
    weight: float


@dataclass(frozen=True)
class Slant:
    """A line that runs along no axis.

    Attributes:
        line: the line.
        weight: px of ink that tell it.
    """

    line: Line
    weight: float


@dataclass(frozen=True, eq=False)
class Round:
    """A circle.

    Attributes:
        centre, radius: px.
        information: (3, 3) of centre and radius, for points of variance 1 along its ink.
        arcs: (start, sweep) of its strokes.
    """

    centre: tuple[float, float]
    radius: float
    information: Floats
    arcs: tuple[tuple[float, float], ...]

    def shows(self, angle: float, beyond: float) -> bool:
        """Whether a stroke of the circle comes within ``beyond`` px of the direction."""
        slack = beyond / max(self.radius, 1e-9)
        return any(
            np.mod(angle - start + slack, 2 * np.pi) <= sweep + 2 * slack
            for start, sweep in self.arcs
        )


Support = AxisLine | Slant | Round


@dataclass(frozen=True, eq=False)
class CarriedStrokes:
    """Strokes and what they lie on.

    Attributes:
        strokes: in px of the plane.
        supports: of all strokes.
        of: for each stroke the number of its support; None for ellipses.
    """

    strokes: tuple[Stroke, ...]
    supports: tuple[Support, ...]
    of: tuple[int | None, ...]


def supports_of(strokes: tuple[Stroke, ...], precision: Precision) -> CarriedStrokes:
    """What the strokes of a view lie on."""
    groups: list[list[int]] = []
    of: list[int | None] = []
    firsts = {Arc: _Firsts(len(strokes)), Segment: _Firsts(len(strokes))}
    for index, stroke in enumerate(strokes):
        if isinstance(stroke, Ellipse):
            of.append(None)
            continue
        number = len(groups)
        known = firsts[type(stroke)] if _along_axis(stroke, precision) is None else None
        if known is not None and known.numbers:
            near = np.flatnonzero(_alike(stroke, known.rows, precision))
            number = known.numbers[int(near[0])] if len(near) else number
        if number == len(groups):
            groups.append([])
            if known is not None:
                known.add(number, stroke)
        groups[number].append(index)
        of.append(number)
    supports = tuple(
        _support([strokes[i] for i in this_groups], precision) for this_groups in groups
    )
    return CarriedStrokes(strokes, supports, tuple(of))


class _Firsts:
    """The first stroke of each group of one kind, as numbers.

    Attributes:
        numbers: of the groups.
    """

    def __init__(self, most: int) -> None:
        self.numbers: list[int] = []
        self._rows = np.empty((most, 4))

    @property
    def rows(self) -> npt.NDArray[np.float64]:
        """(n, 4) of each arc its centre and radius, of each segment its ends."""
        return self._rows[: len(self.numbers)]

    def add(self, number: int, stroke: Arc | Segment) -> None:
        """Take the first stroke of a group."""
        if isinstance(stroke, Arc):
            row = (*stroke.centre, stroke.radius, 0.0)
        else:
            row = (*stroke.start, *stroke.end)
        self._rows[len(self.numbers)] = row
        self.numbers.append(number)


def _alike(
    stroke: Arc | Segment, others: npt.NDArray[np.float64], precision: Precision
) -> npt.NDArray[np.bool_]:
    """(n,) whether a stroke lies on one circle or one slanted line with others of its kind, given
    as of :class:`_Firsts`."""
    apart = precision.limits.apart
    if isinstance(stroke, Arc):
        away = others[:, :3] - (*stroke.centre, stroke.radius)
        return (np.hypot(*away[:, :2].T) <= apart) & (np.abs(away[:, 2]) <= apart)
    ends = others.reshape(-1, 2, 2)
    ways = ends[:, 1] - ends[:, 0]
    ways = ways / np.maximum(np.hypot(*ways.T), 1e-12)[:, None]
    values = np.array(_line(stroke).direction)
    sine = np.abs(ways[:, 0] * values[1] - ways[:, 1] * values[0])
    offsets = np.array([stroke.start, stroke.end])[:, None] - ends[:, 0]
    across = np.abs(offsets[..., 1] * ways[:, 0] - offsets[..., 0] * ways[:, 1])
    return (sine <= _TURN) & (across.max(axis=0) <= apart)


def _along_axis(stroke: Stroke, precision: Precision) -> int | None:
    """Which coordinate a segment keeps; None for any other stroke."""
    if not isinstance(stroke, Segment):
        return None
    across = np.abs(np.subtract(stroke.end, stroke.start))
    fixed = int(np.argmin(across))
    allowed = precision.level + _DRIFT * stroke.length
    return fixed if across[fixed] <= min(allowed, 0.2 * across[1 - fixed]) else None


def _line(segment: Segment) -> Line:
    ends = np.array([segment.start, segment.end])
    way = (ends[1] - ends[0]) / max(segment.length, 1e-12)
    middle = ends.mean(axis=0)
    return Line((float(middle[0]), float(middle[1])), (float(way[0]), float(way[1])))


def ink_of(stroke: Stroke) -> float:
    """px of ink along a stroke."""
    share = _DASHED if stroke.linetype is Linetype.HIDDEN else 1.0
    return max(stroke.length * share, 1e-6)


def _support(strokes: list[Stroke], precision: Precision) -> Support:
    first = strokes[0]
    if isinstance(first, Arc):
        return _round([stroke for stroke in strokes if isinstance(stroke, Arc)])
    segments = [stroke for stroke in strokes if isinstance(stroke, Segment)]
    weight = sum(ink_of(stroke) for stroke in segments)
    fixed = _along_axis(first, precision)
    if fixed is not None:
        low, high = segments[0].start[fixed], segments[0].end[fixed]
        lean = abs(high - low) / (_LEANING * precision.noise)
        return AxisLine(fixed, (low + high) / 2.0, weight / (1.0 + lean**2))
    longest = max(segments, key=lambda segment: segment.length)
    if len(segments) == 1:
        return Slant(_line(longest), weight)
    ends = np.array([point for segment in segments for point in (segment.start, segment.end)])
    weights = np.repeat([segment.length for segment in segments], 2)
    middle = np.average(ends, axis=0, weights=weights)
    offset = (ends - middle) * np.sqrt(weights)[:, None]
    way = np.linalg.svd(offset, full_matrices=False)[2][0]
    line = Line((float(middle[0]), float(middle[1])), (float(way[0]), float(way[1])))
    return Slant(line, weight)


def _round(arcs: list[Arc]) -> Round:
    weights = np.array([ink_of(arc) for arc in arcs])
    first = arcs[0]
    centre, radius = first.centre, first.radius
    if any((arc.centre, arc.radius) != (centre, radius) for arc in arcs):
        # The average of equal numbers would not always be that number.
        x, y = np.average([arc.centre for arc in arcs], axis=0, weights=weights)
        centre = float(x), float(y)
        radius = float(np.average([arc.radius for arc in arcs], weights=weights))
    information = sum(
        _information(arc) * (weight / max(arc.length, 1e-12))
        for arc, weight in zip(arcs, weights, strict=True)
    )
    spans = tuple((arc.start_angle, arc.sweep) for arc in arcs)
    return Round(centre, radius, np.asarray(information), spans)


def _information(arc: Arc) -> Floats:
    """(3, 3) of the radial distances of a point a px: the sum of (cos, sin, 1) times itself."""
    count = max(16, int(np.ceil(np.degrees(arc.sweep) / 5.0)))
    angles = arc.start_angle + (np.arange(count) + 0.5) * (arc.sweep / count)
    rows = np.stack([np.cos(angles), np.sin(angles), np.ones(count)], axis=1)
    # A little of each alone keeps flat arcs, which leave their centre open, where they are.
    share = 1.0 if arc.sweep >= _WHOLE else _OPEN
    return rows.T @ rows * (share * arc.length / count) + 1e-6 * np.eye(3)
