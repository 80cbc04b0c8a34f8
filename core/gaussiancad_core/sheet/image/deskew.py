"""How far a sheet is turned on the scanner's glass, and the sheet turned back.

Most lines of a drawing are level or upright: the turn is the direction that most of their length
has in common, modulo a quarter of a turn.  Long fitted lines give it to thousandths of a degree.
"""

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import VectorDrawing
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.reading_options import Box

Floats = npt.NDArray[np.float64]

LARGEST_SKEW = np.radians(10.0)
"""Sheets are turned back by at most this angle; beyond, they lie on their side."""

_SMALLEST_SKEW_PX = 0.3
"""Displacement at the sheet's border under which turning it back does more harm than good."""

_SHORTEST = 40
"""px of a line whose direction is exact enough to count."""

_MOST_LINES = 1000
"""Lines of a file that are asked."""

_NEIGHBOURHOODS = (np.radians(0.5), np.radians(0.2), np.radians(0.1))
"""Angles around the common one within which lines are level or upright."""


@dataclass(frozen=True)
class Turn:
    """A rotation of a sheet about its middle, and how much smaller it was read than stored.

    Attributes:
        angle: radians by which the drawing is turned on the sheet as stored, from x to y (clockwise
            to the eye).
        centre: (x, y) px of the upright sheet, pixel centres at .5.
        scale: px of the sheet as stored per px of the upright sheet.
    """

    angle: float
    centre: tuple[float, float]
    scale: float = 1.0

    def to_stored(self, points: Floats) -> Floats:
        """(n, 2) px of the upright sheet -> px of the sheet as stored."""
        return self.scale * self._turned(points, self.angle)

    def to_upright(self, points: Floats) -> Floats:
        """(n, 2) px of the sheet as stored -> px of the upright sheet."""
        return self._turned(points / self.scale, -self.angle)

    def box_to_stored(self, box: Box) -> Box:
        """The box on the sheet as stored around a box on the upright sheet."""
        return self._around(box, self.to_stored)

    def box_to_upright(self, box: Box) -> Box:
        """The box on the upright sheet around a box on the sheet as stored."""
        return self._around(box, self.to_upright)

    def upright(self, image: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
        """An image of ink with the drawing turned level; paper comes in at the corners."""
        if not self.angle:
            return image
        cosine, sine = np.cos(self.angle), np.sin(self.angle)
        # Pixel centres are at integers here, and at .5 in the coordinates of the points.
        x, y = self.centre[0] - 0.5, self.centre[1] - 0.5
        matrix = np.array(
            [
                [cosine, -sine, x - cosine * x + sine * y],
                [sine, cosine, y - sine * x - cosine * y],
            ]
        )
        size = (image.shape[1], image.shape[0])
        flags = cv2.INTER_CUBIC | cv2.WARP_INVERSE_MAP
        turned = cv2.warpAffine(image, matrix, size, flags=flags, borderValue=0.0)
        return np.clip(turned, 0.0, 1.0)

    def _around(self, box: Box, moved: Callable[[Floats], Floats]) -> Box:
        if not self.angle and self.scale == 1.0:
            return box
        x0, y0, x1, y1 = box
        corners = moved(np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]))
        low, high = corners.min(0), corners.max(0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])

    def _turned(self, points: Floats, angle: float) -> Floats:
        cosine, sine = np.cos(angle), np.sin(angle)
        offset = points - np.array(self.centre)
        turned = offset @ np.array([[cosine, sine], [-sine, cosine]])
        return turned + np.array(self.centre)


def find_turn(directions: Floats, lengths: Floats, shape: tuple[int, int]) -> Turn:
    """The turn of a sheet, from its lines; none if it is too small to matter.

    Args:
        directions: (n, 2) of straight lines of the sheet as stored.
        lengths: (n,) px of these.
        shape: height and width of the sheet in px.
    """
    height, width = shape
    centre = (width / 2, height / 2)
    long = lengths >= _SHORTEST
    if not long.any():
        return Turn(0.0, centre)
    angles = np.arctan2(directions[long, 1], directions[long, 0])
    # Level and upright lines say the same.
    quarter = (angles + np.pi / 4) % (np.pi / 2) - np.pi / 4
    # The error of a fitted line's direction falls with the power 3/2 of its length.
    weights = lengths[long] ** 3
    common = _commonest(quarter, lengths[long])
    for reach in _NEIGHBOURHOODS:
        near = np.abs(quarter - common) < reach
        common = float(np.average(quarter[near], weights=weights[near])) if near.any() else common
    reach = np.hypot(width, height) / 2
    small = abs(common) * reach < _SMALLEST_SKEW_PX or abs(common) > LARGEST_SKEW
    return Turn(0.0 if small else common, centre)


def file_directions(drawing: VectorDrawing) -> tuple[Floats, Floats]:
    """(n, 2) directions and (n,) lengths in px of the longest straight lines of a file."""
    lines = [stroke.curve for stroke in drawing.strokes if isinstance(stroke.curve, LineSegment)]
    ends = np.array([(line.start, line.end) for line in lines]).reshape(-1, 2, 2)
    ways = ends[:, 1] - ends[:, 0]
    lengths = np.hypot(ways[:, 0], ways[:, 1])
    longest = np.argsort(-lengths, kind="stable")[:_MOST_LINES]
    return ways[longest], lengths[longest]


def _commonest(angles: Floats, lengths: Floats) -> float:
    """The angle around which the lines are longest together."""
    near = np.abs(angles[:, None] - angles) < _NEIGHBOURHOODS[0]
    allowed = np.abs(angles) <= LARGEST_SKEW
    if not allowed.any():
        return 0.0
    return float(angles[int(np.argmax(np.where(allowed, near @ lengths, -1.0)))])
