"""Ellipses through points, and the distance of points from them."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]

_FLATTEST = 1e-6
"""Least product of a conic's two curvatures, in squares of the larger one, of an ellipse."""

_FOOT_STEPS = 6
"""Newton steps to the nearest point of an ellipse: they double the exact digits each time."""


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
            cosine, sine = np.cos(t), np.sin(t)
            gap = (u - a * cosine) * -a * sine + (v - b * sine) * b * cosine
            bend = a * cosine * (u - a * cosine) + b * sine * (v - b * sine)
            slope = (a * sine) ** 2 + (b * cosine) ** 2 + bend
            # Inside of the evolute the slope changes its sign; the start is near enough there.
            t = t + np.where(slope > 1e-9 * a * a, gap / np.where(slope == 0.0, 1.0, slope), 0.0)
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
