"""Pieces of circles and ellipses, up to whole ones."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from math import atan2, ceil, cos, pi, sin, sqrt
from typing import Self

import numpy as np

from gaussiancad_core.geometry.chains import chain_distances
from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.points import (
    FULL_TURN,
    Box,
    Point,
    Points,
    box_around,
    wrapped,
)
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.geometry.whole_curves import Circle

_CLOSED = FULL_TURN * (1.0 - 1e-9)
"""Radians from which a sweep is the whole curve: a full turn, but for rounding."""

_QUARTERS = (0.0, 0.5 * pi, pi, 1.5 * pi)
"""Where a circle runs along an axis of its plane."""

SAGITTA = 1e-5
"""Share of its longer half axis by which the chords lie beside an ellipse from which distances are
taken."""


@dataclass(frozen=True)
class CircularArc:
    """A piece of a circle.

    Attributes:
        centre: (2,) in the plane of whoever holds the curve.
        radius: in the plane's unit.
        start_angle, sweep: radians, from the plane's first axis towards its second; ``sweep`` is
            positive and at most 2 pi, which is the full circle.
    """

    centre: Point
    radius: float
    start_angle: float
    sweep: float

    @property
    def carrier(self) -> Circle:
        """The circle that it is a piece of."""
        return Circle(self.centre, self.radius)

    @property
    def is_closed(self) -> bool:
        """Whether it is the whole circle."""
        return self.sweep >= _CLOSED

    @property
    def length(self) -> float:
        """Length along the circle."""
        return self.radius * self.sweep

    @property
    def box(self) -> Box:
        """Around it."""
        return box_around(self.extremes())

    def extremes(self) -> Points:
        """(n, 2) both ends, then the points at which it turns back along an axis."""
        ends = [self.start_angle, self.start_angle + self.sweep]
        return self._at(np.array(ends + _within(_QUARTERS, self.start_angle, self.sweep)))

    def sample(self, step: float) -> Points:
        """(n, 2) even points along the curve, at most ``step`` apart, both ends included."""
        count = max(3, ceil(self.length / step) + 1)
        return self._at(self.start_angle + np.linspace(0.0, self.sweep, count))

    def vertices(self, step: float) -> Points:
        """(n, 2) corners of a chain along the curve, at most ``step`` apart, ends included."""
        return self.sample(step)

    def points_at(self, along: Points) -> Points:
        """(n, 2) points at lengths along the curve; before and after it, on its circle."""
        return self._at(self.start_angle + along / self.radius)

    def _at(self, angles: Points) -> Points:
        return np.array(self.centre) + self.radius * np.stack([np.cos(angles), np.sin(angles)], 1)

    def distances(self, points: Points) -> Points:
        """(n,) distances of (n, 2) points."""
        offsets = points - np.array(self.centre)
        turn = np.mod(np.arctan2(offsets[:, 1], offsets[:, 0]) - self.start_angle, FULL_TURN)
        radial = np.abs(np.hypot(*offsets.T) - self.radius)
        ends = self._at(self.start_angle + np.array([0.0, self.sweep]))
        to_ends = np.hypot(*np.moveaxis(points[:, None] - ends, 2, 0)).min(axis=1)
        return np.where(turn <= self.sweep, radial, to_ends)

    def part(self, low: float, high: float) -> Self:
        """Between two lengths along its circle from its start."""
        start = self.start_angle + low / self.radius
        return replace(self, start_angle=start, sweep=(high - low) / self.radius)

    def mapped(self, by: Similarity) -> Self:
        """Its image."""
        first = self.start_angle + self.sweep if by.flip else self.start_angle
        return replace(
            self,
            centre=by.point(self.centre),
            radius=by.scale * self.radius,
            start_angle=wrapped(by.direction(first)),
        )


@dataclass(frozen=True)
class EllipticArc:
    """A piece of an ellipse: a circle seen at a slant.

    Its points are ``centre + R (semi_major cos t, semi_minor sin t)``, where ``R`` turns by
    ``rotation`` and the parameter ``t`` runs from ``start`` to ``start + sweep``.

    Attributes:
        centre: (2,) in the plane of whoever holds the curve.
        semi_major, semi_minor: in the plane's unit, the first not the smaller one, both positive.
        rotation: radians from the plane's first axis towards its second, of the major axis.
        start, sweep: radians of the parameter; ``sweep`` is positive and at most 2 pi, which is
            the full ellipse.
    """

    centre: Point
    semi_major: float
    semi_minor: float
    rotation: float
    start: float
    sweep: float

    @cached_property
    def carrier(self) -> WholeEllipse:
        """The ellipse that it is a piece of."""
        return WholeEllipse(self.centre, self.semi_major, self.semi_minor, self.rotation)

    @property
    def is_closed(self) -> bool:
        """Whether it is the whole ellipse."""
        return self.sweep >= _CLOSED

    @property
    def length(self) -> float:
        """Length along the ellipse."""
        ends = np.array([self.start, self.start + self.sweep])
        return float(np.diff(self.carrier.lengths(ends))[0])

    @property
    def box(self) -> Box:
        """Around it."""
        return box_around(self.extremes())

    def extremes(self) -> Points:
        """(n, 2) both ends, then the points at which it turns back along an axis."""
        cosine, sine = cos(self.rotation), sin(self.rotation)
        a, b = self.semi_major, self.semi_minor
        # Where it turns back along the first axis, and along the second.
        first, second = atan2(-b * sine, a * cosine), atan2(b * cosine, a * sine)
        turning = _within((first, first + pi, second, second + pi), self.start, self.sweep)
        ends = [self.start, self.start + self.sweep]
        return self.carrier.at(np.array(ends + turning))

    def sample(self, step: float) -> Points:
        """(n, 2) even points along the curve, at most ``step`` apart, both ends included."""
        length = self.length
        count = max(3, ceil(length / step) + 1)
        parameters = self._parameters(np.linspace(0.0, length, count))
        parameters[0], parameters[-1] = self.start, self.start + self.sweep
        return self.carrier.at(parameters)

    def vertices(self, step: float) -> Points:
        """(n, 2) corners of a chain along the curve, at most ``step`` apart, ends included: at
        equal steps of the parameter, which costs a thirtieth of even ones."""
        return self.spread(max(3, ceil(self.sweep * self.semi_major / step) + 1))

    def spread(self, count: int) -> Points:
        """(count, 2) points at equal steps of the parameter, both ends included."""
        return self.carrier.at(self.start + np.linspace(0.0, self.sweep, count))

    def points_at(self, along: Points) -> Points:
        """(n, 2) points at lengths along the curve; before and after it, on its ellipse."""
        return self.carrier.at(self._parameters(along))

    def _parameters(self, along: Points) -> Points:
        """(n,) lengths along the curve -> (n,) parameters."""
        return self.carrier.parameters(along + self.carrier.lengths(np.array([self.start])))

    def distances(self, points: Points) -> Points:
        """(n,) distances of (n, 2) points, within a hundred-thousandth of the longer half axis."""
        return chain_distances(points, self.chords(SAGITTA * self.semi_major))

    def chords(self, sagitta: float) -> Points:
        """(n, 2) corners of a chain along the curve, at most ``sagitta`` beside it."""
        # Chords of a circle of the major axis's size lie farther beside it than those of the
        # ellipse.
        step = sqrt(8.0 * sagitta / self.semi_major)
        points = self.spread(max(8, ceil(self.sweep / step)) + 1)
        if self.is_closed:
            points[-1] = points[0]
        return points

    def part(self, low: float, high: float) -> Self:
        """Between two lengths along its ellipse from its start."""
        first, last = self._parameters(np.array([low, high]))
        return replace(self, start=float(first), sweep=float(last - first))

    def mapped(self, by: Similarity) -> Self:
        """Its image."""
        return replace(
            self,
            centre=by.point(self.centre),
            semi_major=by.scale * self.semi_major,
            semi_minor=by.scale * self.semi_minor,
            rotation=by.direction(self.rotation),
            start=wrapped(-(self.start + self.sweep) if by.flip else self.start),
        )


def _within(angles: Iterable[float], start: float, sweep: float) -> list[float]:
    """Those of some angles that lie in a sweep, whole turns aside."""
    return [angle for angle in angles if (angle - start) % FULL_TURN <= sweep]
