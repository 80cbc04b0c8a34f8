"""Whole ellipses: lengths along them, ellipses through points, and distances from them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]

LONGEST_CHORD = np.radians(15.0)
"""Turn from point to point of a curve at most: with larger ones it may be a polygon."""

LEAST_SWEEP = np.radians(20.0)
"""Turn of points under which many ellipses fit them."""

_FLATTEST = 1e-6
"""Least product of a conic's two curvatures, in squares of the larger one, of an ellipse."""

_DAMPING = 1e-4
"""Weight of staying where an ellipse was, against a point's distance."""

_TURN = np.linspace(0.0, 2 * np.pi, 513)
"""Parameters at which lengths are tabled."""

_FOOT_STEPS = 6
"""Steps to the nearest point of an ellipse: the error shrinks by its square or cube each time."""


@dataclass(frozen=True)
class WholeEllipse:
    """An ellipse in any plane.

    Its points are ``centre + R (semi_major cos t, semi_minor sin t)``, ``R`` a turn by
    ``rotation``.

    Attributes:
        centre: (2,).
        semi_major, semi_minor: the first not the smaller one, both positive.
        rotation: radians, of the major axis.
    """

    centre: tuple[float, float]
    semi_major: float
    semi_minor: float
    rotation: float

    @cached_property
    def around(self) -> float:
        """Length once around."""
        return float(self.lengths(np.array([2 * np.pi]))[0])

    def at(self, parameters: Points) -> Points:
        """(n,) parameters -> (n, 2) points."""
        u, v = self.semi_major * np.cos(parameters), self.semi_minor * np.sin(parameters)
        return np.array(self.centre) + self._turned(u, v)

    def tangents(self, parameters: Points) -> Points:
        """(n,) parameters -> (n, 2) unit tangents, the way that parameters grow."""
        u, v = -self.semi_major * np.sin(parameters), self.semi_minor * np.cos(parameters)
        return self._turned(u, v) / np.hypot(u, v)[:, None]

    def lengths(self, parameters: Points) -> Points:
        """(n,) parameters -> (n,) lengths from parameter 0: incomplete elliptic integrals of the
        second kind."""
        from scipy.special import ellipeinc

        flatness = 1.0 - (self.semi_minor / self.semi_major) ** 2
        quarter = np.pi / 2
        found = ellipeinc(parameters - quarter, flatness) - ellipeinc(-quarter, flatness)
        return self.semi_major * found

    def parameters(self, lengths: Points) -> Points:
        """(n,) lengths from parameter 0 -> (n,) parameters."""
        turns, rest = np.divmod(lengths, self.around)
        found = np.interp(rest, self._table, _TURN)
        # The table is good to 1e-5; Newton's method makes that exact.
        for _ in range(2):
            u, v = self.semi_major * np.sin(found), self.semi_minor * np.cos(found)
            found += (rest - self.lengths(found)) / np.hypot(u, v)
        return found + 2 * np.pi * turns

    @cached_property
    def _table(self) -> Points:
        """(n,) lengths at the parameters of a turn: they cost more than all that is asked of it."""
        return self.lengths(_TURN)

    def points_at(self, along: Points) -> Points:
        """(n,) lengths from parameter 0 -> (n, 2) points."""
        return self.at(self.parameters(along))

    def tangents_at(self, along: Points) -> Points:
        """(n,) lengths from parameter 0 -> (n, 2) unit tangents."""
        return self.tangents(self.parameters(along))

    def distances(self, points: Points) -> Points:
        """(n, 2) points -> (n,) distances from the ellipse."""
        return np.abs(self.away(points)[0])

    def positions(self, points: Points) -> Points:
        """(n, 2) points -> (n,) lengths from parameter 0 of the nearest points, -half to half
        around."""
        return self.lengths(self.away(points)[1])

    def _nearer(self, u: Points, v: Points, t: Points) -> Points:
        """Parameters nearer to the points (u, v) of the own frame: along the circles of curvature,
        which unlike Newton's method never lead away."""
        a, b = self.semi_major, self.semi_minor
        cosine, sine = np.cos(t), np.sin(t)
        # Centre of curvature, and from there to the ellipse and to the point.
        across = a * a - b * b
        x, y = across * (cosine**3 / a), across * (-(sine**3) / b)
        arm = np.hypot(a * cosine - x, b * sine - y)
        along, upward = u - x, v - y
        share = arm / np.maximum(np.hypot(along, upward), 1e-300)
        x, y = (along * share + x) / a, (upward * share + y) / b
        # Past the axes lies another point's nearest one.
        x, y = np.where(x * u < 0.0, 0.0, x), np.where(y * v < 0.0, 0.0, y)
        return np.where((x == 0.0) & (y == 0.0), t, np.arctan2(y, x))

    def _turned(self, u: Points, v: Points) -> Points:
        cosine, sine = np.cos(self.rotation), np.sin(self.rotation)
        return np.stack([u * cosine - v * sine, u * sine + v * cosine], axis=1)

    def local(self, points: Points) -> Points:
        """(n, 2) points in the frame of centre and axes."""
        cosine, sine = np.cos(self.rotation), np.sin(self.rotation)
        return (points - np.array(self.centre)) @ np.array([[cosine, -sine], [sine, cosine]])

    def away(self, points: Points) -> tuple[Points, Points]:
        """(n, 2) points -> (n,) signed distances, positive outside, and (n,) parameters in
        -pi to pi of the nearest points of the ellipse."""
        u, v = self.local(points).T
        a, b = self.semi_major, self.semi_minor
        t = np.arctan2(v * a, u * b)
        for _ in range(_FOOT_STEPS):
            t = self._nearer(u, v, t)
        cosine, sine = np.cos(t), np.sin(t)
        normal = np.stack([b * cosine, a * sine])
        normal /= np.maximum(np.hypot(*normal), 1e-300)
        across = (u - a * cosine) * normal[0] + (v - b * sine) * normal[1]
        return across, np.arctan2(sine, cosine)


def ellipse_through(points: Points) -> WholeEllipse | None:
    """The ellipse whose equation (n, 2) points fulfil best, in least squares; n at least 6.

    None where the conic is no ellipse, or hardly one.
    """
    if len(points) < 6:
        return None
    middle = points.mean(axis=0)
    size = float(np.abs(points - middle).max())
    if size == 0.0:
        return None
    x, y = ((points - middle) / size).T
    conic = np.linalg.svd(
        np.column_stack([x * x, x * y, y * y, x, y, np.ones_like(x)]), full_matrices=False
    )[2][-1]
    form = np.array([[conic[0], conic[1] / 2.0], [conic[1] / 2.0, conic[2]]])
    values, axes = np.linalg.eigh(form)
    if values.prod() <= _FLATTEST * np.abs(values).max() ** 2:
        return None
    centre = np.linalg.solve(form, -conic[3:5] / 2.0)
    level = float(centre @ form @ centre - conic[5])
    squares = level / values
    if (squares <= 0.0).any():
        return None
    major = int(np.argmax(squares))
    semi_major, semi_minor = (size * np.sqrt(squares[major]), size * np.sqrt(squares[1 - major]))
    centre = middle + size * centre
    rotation = float(np.arctan2(axes[1, major], axes[0, major]) % np.pi)
    return WholeEllipse(
        (float(centre[0]), float(centre[1])), float(semi_major), float(semi_minor), rotation
    )


def refined(ellipse: WholeEllipse, points: Points, weights: Points | None = None) -> WholeEllipse:
    """One Gauss-Newton step towards the ellipse with the least squares of the distances of (n, 2)
    points; the ellipse itself where the step leads to none.

    Args:
        ellipse: near the points.
        points: n at least 6.
        weights: (n,) of the points; 1 if None.
    """
    across, t = ellipse.away(points)
    a, b = ellipse.semi_major, ellipse.semi_minor
    cosine, sine = np.cos(t), np.sin(t)
    normal = np.stack([b * cosine, a * sine]) / np.hypot(b * cosine, a * sine)
    turned = (a * cosine * normal[1] - b * sine * normal[0]) / a
    design = np.stack([normal[0], normal[1], cosine * normal[0], sine * normal[1], turned], 1)
    scale = np.ones(len(points)) if weights is None else weights
    # A little damping: a circle has no rotation, a flat piece no centre.
    system = np.concatenate([design * scale[:, None], _DAMPING * np.sqrt(scale.sum()) * np.eye(5)])
    step = np.linalg.lstsq(system, np.append(across * scale, np.zeros(5)), rcond=None)[0]
    if not np.isfinite(step).all() or a + step[2] <= 0.0 or b + step[3] <= 0.0:
        return ellipse
    shift = WholeEllipse((0.0, 0.0), a, b, ellipse.rotation)._turned(step[:1], step[1:2])[0]
    centre = float(ellipse.centre[0] + shift[0]), float(ellipse.centre[1] + shift[1])
    rotation, axes = ellipse.rotation + float(step[4]) / a, (a + step[2], b + step[3])
    if axes[0] < axes[1]:
        rotation, axes = rotation + np.pi / 2, axes[::-1]
    return WholeEllipse(centre, float(axes[0]), float(axes[1]), float(rotation % np.pi))
