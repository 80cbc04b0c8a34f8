"""The strokes of a drawing: straight, circular, and everything else as a fine chain.

The lines of a solid are segments, arcs and chains; ellipses come from sheets that were read, and
from :func:`as_plain_strokes`, which knows the chains that run along one.
"""

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import ellipse_through
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke


@dataclass(frozen=True)
class Polyline:
    """A stroke along a curve that is neither line nor circle: an ellipse, a spline.

    It stays one stroke, so that dashes run along the curve and not along its chords.

    Attributes:
        points: two or more (2,) points in the plane of whoever holds the stroke; a closed curve
            repeats its first point at the end.
        linetype: visible or hidden.
        confidence: 0 to 1, how sure the linetype is.
    """

    points: tuple[tuple[float, float], ...]
    linetype: Linetype
    confidence: float = 1.0

    @property
    def length(self) -> float:
        """Length along the chain."""
        return float(np.hypot(*np.diff(np.array(self.points), axis=0).T).sum())

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) points along the stroke, at most ``step`` apart, both ends included."""
        vertices = np.array(self.points)
        along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(vertices, axis=0).T))])
        count = max(2, int(np.ceil(along[-1] / step)) + 1)
        at = np.linspace(0.0, along[-1], count)
        return np.stack([np.interp(at, along, vertices[:, axis]) for axis in (0, 1)], axis=1)

    def segments(self) -> tuple[Segment, ...]:
        """The chords as strokes of their own."""
        return tuple(
            Segment(start, end, self.linetype, self.confidence)
            for start, end in zip(self.points, self.points[1:], strict=False)
        )


DrawnStroke = Segment | Arc | Ellipse | Polyline

FULL_TURN = 2.0 * np.pi * (1.0 - 1e-9)
"""Sweeps from here on are whole circles."""


_ON_ELLIPSE = 2e-4
"""Share of a chain's size by which its points may lie beside an ellipse that replaces it."""

_LONGEST_CHORD = np.radians(15.0)
"""Largest step of the parameter between two points of a chain along an ellipse."""

_LEAST_SWEEP = np.radians(20.0)
"""Under this turn, many ellipses fit a chain."""


def as_plain_strokes(strokes: tuple[DrawnStroke, ...]) -> tuple[Stroke, ...]:
    """The strokes as :data:`gaussiancad_core.model.views.Stroke`: chains along an ellipse become
    that
    ellipse, others their chords."""
    plain: list[Stroke] = []
    for stroke in strokes:
        if not isinstance(stroke, Polyline):
            plain.append(stroke)
            continue
        ellipse = _ellipse_along(stroke)
        plain.extend(stroke.segments() if ellipse is None else [ellipse])
    return tuple(plain)


def _ellipse_along(chain: Polyline) -> Ellipse | None:
    """The ellipse that a chain's points lie on, from one end to the other."""
    points = np.array(chain.points)
    found = ellipse_through(points)
    if found is None:
        return None
    away, parameters = found.away(points)
    size = float(np.ptp(points, axis=0).max())
    steps = np.diff(np.unwrap(parameters))
    way = np.sign(steps.sum())
    sweep = abs(float(steps.sum()))
    # Chains may hold a point twice.
    even = (way * steps > -1e-9).all() and np.abs(steps).max() < _LONGEST_CHORD
    if np.abs(away).max() > _ON_ELLIPSE * size or not even or sweep < _LEAST_SWEEP:
        return None
    first = float(np.mod(parameters[0] if way > 0.0 else parameters[-1], 2.0 * np.pi))
    axes = found.semi_major, found.semi_minor, found.rotation
    turn = min(sweep, 2.0 * np.pi)
    return Ellipse(found.centre, *axes, first, turn, chain.linetype, chain.confidence)


def as_chain(ellipse: Ellipse, chord: float) -> Polyline:
    """A fine chain along an ellipse, at most ``chord`` beside it."""
    # Chords of a circle of the major axis's size lie farther beside it than those of the ellipse.
    step = np.sqrt(8.0 * chord / ellipse.semi_major)
    count = max(8, int(np.ceil(ellipse.sweep / step)))
    points = ellipse.whole.at(ellipse.start + np.linspace(0.0, ellipse.sweep, count + 1))
    if is_closed(ellipse):
        points[-1] = points[0]
    pairs = tuple((float(x), float(y)) for x, y in points)
    return Polyline(pairs, ellipse.linetype, ellipse.confidence)


def extent(strokes: tuple[DrawnStroke, ...]) -> npt.NDArray[np.float64]:
    """(2, 2) lower and upper corner of the strokes' exact bounding box, in their own plane."""
    corners = [_stroke_extent(stroke) for stroke in strokes]
    stacked = np.array(corners)
    return np.stack([stacked[:, 0].min(axis=0), stacked[:, 1].max(axis=0)])


def _stroke_extent(stroke: DrawnStroke) -> npt.NDArray[np.float64]:
    if isinstance(stroke, Segment):
        points = np.array([stroke.start, stroke.end])
    elif isinstance(stroke, Polyline):
        points = np.array(stroke.points)
    elif isinstance(stroke, Ellipse):
        points = stroke.extremes()
    else:
        quarters = np.arange(8) * np.pi / 2.0
        first = np.mod(stroke.start_angle, 2.0 * np.pi)
        inside = quarters[(quarters >= first) & (quarters <= first + stroke.sweep)]
        angles = np.concatenate([[first, first + stroke.sweep], inside])
        points = np.array(stroke.centre) + stroke.radius * np.stack(
            [np.cos(angles), np.sin(angles)], axis=1
        )
    return np.stack([points.min(axis=0), points.max(axis=0)])


def mapped(
    stroke: DrawnStroke, scale: float, offset: tuple[float, float], flip: bool
) -> DrawnStroke:
    """A stroke under ``(x, y) -> scale (x, y) + offset``, with y turned over first if ``flip``.

    Args:
        stroke: the stroke.
        scale: factor, positive.
        offset: (2,) added after scaling.
        flip: from a plane whose second axis points up to one where it points down.
    """
    sign = -1.0 if flip else 1.0

    def move(point: tuple[float, float]) -> tuple[float, float]:
        return scale * point[0] + offset[0], sign * scale * point[1] + offset[1]

    if isinstance(stroke, Segment):
        return replace(stroke, start=move(stroke.start), end=move(stroke.end))
    if isinstance(stroke, Polyline):
        return replace(stroke, points=tuple(move(point) for point in stroke.points))
    if isinstance(stroke, Ellipse):
        first = -(stroke.start + stroke.sweep) if flip else stroke.start
        return replace(
            stroke,
            centre=move(stroke.centre),
            semi_major=scale * stroke.semi_major,
            semi_minor=scale * stroke.semi_minor,
            rotation=sign * stroke.rotation,
            start=float(np.mod(first, 2.0 * np.pi)),
        )
    start = -(stroke.start_angle + stroke.sweep) if flip else stroke.start_angle
    return replace(
        stroke,
        centre=move(stroke.centre),
        radius=scale * stroke.radius,
        start_angle=float(np.mod(start, 2.0 * np.pi)),
    )


def turned(stroke: DrawnStroke, angle: float, centre: tuple[float, float]) -> DrawnStroke:
    """A stroke turned by ``angle`` radians, from the first axis towards the second."""
    cosine, sine = float(np.cos(angle)), float(np.sin(angle))

    def move(point: tuple[float, float]) -> tuple[float, float]:
        x, y = point[0] - centre[0], point[1] - centre[1]
        return centre[0] + cosine * x - sine * y, centre[1] + sine * x + cosine * y

    if isinstance(stroke, Segment):
        return replace(stroke, start=move(stroke.start), end=move(stroke.end))
    if isinstance(stroke, Polyline):
        return replace(stroke, points=tuple(move(point) for point in stroke.points))
    if isinstance(stroke, Ellipse):
        return replace(stroke, centre=move(stroke.centre), rotation=stroke.rotation + angle)
    return replace(
        stroke,
        centre=move(stroke.centre),
        start_angle=float(np.mod(stroke.start_angle + angle, 2.0 * np.pi)),
    )


def is_closed(stroke: DrawnStroke) -> bool:
    """Whether the stroke ends where it begins."""
    if isinstance(stroke, Arc | Ellipse):
        return stroke.sweep >= FULL_TURN
    return isinstance(stroke, Polyline) and stroke.points[0] == stroke.points[-1]


def part(stroke: DrawnStroke, low: float, high: float) -> DrawnStroke:
    """The part of a stroke between two lengths along it.

    An open stroke may be prolonged by lengths before its start and after its end; on a closed one
    lengths before the start lie before its end.
    """
    if isinstance(stroke, Arc):
        start = stroke.start_angle + low / stroke.radius
        sweep = (high - low) / stroke.radius
        return Arc(stroke.centre, stroke.radius, start, sweep, stroke.linetype)
    if isinstance(stroke, Ellipse):
        first, last = stroke.parameters(np.array([low, high]))
        return replace(stroke, start=float(first), sweep=float(last - first))
    if isinstance(stroke, Segment):
        ends = np.array([stroke.start, stroke.end])
        low_point, high_point = (
            ends[0] + (ends[1] - ends[0]) * (at / stroke.length) for at in (low, high)
        )
        return Segment(tuple(low_point), tuple(high_point), stroke.linetype)
    vertices = np.array(stroke.points)
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(vertices, axis=0).T))])
    if low < 0.0 and is_closed(stroke):
        vertices = np.concatenate([vertices[:-1], vertices])
        along = np.concatenate([along[:-1] - along[-1], along])
    inner = (along > low) & (along < high)
    points = np.concatenate(
        [_on_chain(vertices, along, low), vertices[inner], _on_chain(vertices, along, high)]
    )
    return Polyline(tuple((float(x), float(y)) for x, y in points), stroke.linetype)


def _on_chain(
    vertices: npt.NDArray[np.float64], along: npt.NDArray[np.float64], at: float
) -> npt.NDArray[np.float64]:
    """(1, 2) point at a length along a chain; before and after it, on its first and last chord."""
    inside = float(np.clip(at, along[0], along[-1]))
    point = np.array([np.interp(inside, along, vertices[:, axis]) for axis in (0, 1)])
    if at != inside:
        chord = vertices[1] - vertices[0] if at < inside else vertices[-1] - vertices[-2]
        # Chains may hold a point twice; they are then not prolonged.
        point += (at - inside) * chord / max(float(np.hypot(*chord)), 1e-300)
    return point[None]
