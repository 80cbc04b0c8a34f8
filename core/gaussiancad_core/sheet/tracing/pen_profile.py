"""How the strokes of a sheet look across: the ink as a function of the distance from the line."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.special import ndtr

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.tracing.corner_stubs import Placed

Floats = npt.NDArray[np.float64]

_ENDS = 8.0
"""px at either end of a line in which other strokes add their ink."""

_EVERY = 3.0
"""px along a line between the pixels that are looked at."""

_MOST = 40
"""Places along a line that are looked at, at most."""

_LINES = 12
"""Lines that are looked at: the longest."""

_FEWEST = 60
"""Pixels that tell a pen."""


@dataclass(frozen=True)
class Pen:
    """A band of even ink, blurred by a Gaussian.

    Attributes:
        width: px of the band.
        blur: px, the Gaussian's standard deviation.
        gain: ink in the middle of a band much wider than the blur.
    """

    width: float
    blur: float
    gain: float

    def ink(self, distance: Floats) -> Floats:
        """Ink at distances in px from the centre line, any shape."""
        half = self.width / 2
        far, near = -(half + distance) / self.blur, (half - distance) / self.blur
        return self.gain * (ndtr(near) - ndtr(far))


def visible_pen(
    weight: npt.NDArray[np.float32], placed: Sequence[Placed], stroke_width: float
) -> Pen:
    """Fit a pen to the ink of visible lines among the pieces of a view; see :func:`fit_pen`."""
    straight = [
        (geometry, piece.start, piece.end)
        for geometry, piece in placed
        if isinstance(geometry, Line) and piece.linetype is Linetype.VISIBLE
    ]
    return fit_pen(weight, straight, stroke_width)


def fit_pen(
    weight: npt.NDArray[np.float32],
    lines: Sequence[tuple[Line, float, float]],
    stroke_width: float,
) -> Pen:
    """The pen that the longest of some straight strokes were drawn with.

    Args:
        weight: (h, w) ink.
        lines: with the positions between which each is drawn, in px.
        stroke_width: px; what is taken where no line is long enough to tell.
    """
    from scipy.optimize import least_squares

    longest = sorted(lines, key=lambda line: line[1] - line[2])[:_LINES]
    reach = stroke_width / 2 + 2.5
    parts = [_pixels(weight, *pair, reach) for pair in longest]
    start = Pen(stroke_width, 0.5, 1.0)
    if sum(len(part) for part in parts) < _FEWEST:
        return start
    distance, ink = np.concatenate(parts).T

    def residual(values: Floats) -> Floats:
        return Pen(*values).ink(distance) - ink

    found = least_squares(
        residual,
        (start.width, start.blur, start.gain),
        bounds=((0.5, 0.2, 0.3), (20.0, 4.0, 1.3)),
        loss="soft_l1",
        f_scale=0.1,
    )
    return Pen(*(float(value) for value in found.x))


def _pixels(
    weight: npt.NDArray[np.float32], line: Line, start: float, end: float, reach: float
) -> Floats:
    """(n, 2) distance and ink of pixels on and beside a line."""
    along = np.arange(start + _ENDS, end - _ENDS, max(_EVERY, (end - start) / _MOST))
    offsets = np.arange(-np.ceil(reach), np.ceil(reach) + 1.0)
    normal = np.array([-line.direction[1], line.direction[0]])
    places = line.points_at(along)[:, None] + offsets[:, None] * normal
    pixels = np.unique(np.rint(places.reshape(-1, 2)).astype(int), axis=0)
    height, width = weight.shape
    x, y = pixels.T
    pixels = pixels[(x >= 0) & (y >= 0) & (x < width) & (y < height)]
    ink = weight[pixels[:, 1], pixels[:, 0]]
    return np.stack([line.distances(pixels.astype(float)), ink], axis=1)
