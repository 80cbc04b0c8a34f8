"""Views of one part with shared axes in millimetres: what every later stage starts from.

A view's plane has the coordinates (right, up) of :mod:`.axes`.  The model occupies
``[0, size]`` on each axis, so the front view spans ``[0, size_x] x [0, size_z]`` and the left view
``[-size_y, 0] x [0, size_z]``.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.model.axes import Role


class Linetype(Enum):
    """How a stroke is drawn: solid lines are visible edges, dashed lines hidden ones (ISO 128)."""

    VISIBLE = "visible"
    HIDDEN = "hidden"


_FULL_SWEEP = 6.2
"""Radians from which an arc is a circle."""


@dataclass(frozen=True)
class Segment:
    """A straight stroke.

    Attributes:
        start, end: (2,) in the plane of whoever holds the stroke: sheet pixels (x right, y down)
            or view millimetres (right, up).
        linetype: visible or hidden.
        confidence: 0 to 1, how sure the linetype is.
    """

    start: tuple[float, float]
    end: tuple[float, float]
    linetype: Linetype
    confidence: float = 1.0

    @property
    def length(self) -> float:
        """Distance between the ends."""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) points along the stroke, at most ``step`` apart, both ends included."""
        count = max(2, int(np.ceil(self.length / step)) + 1)
        return np.linspace(self.start, self.end, count)


@dataclass(frozen=True)
class Arc:
    """A stroke along a circle.

    Attributes:
        centre: (2,) as for :class:`Segment`.
        radius: in the plane's unit.
        start_angle, sweep: radians, from the plane's first axis towards its second; ``sweep`` is
            positive and at most 2 pi, which is the full circle.
        linetype: visible or hidden.
        confidence: 0 to 1, how sure the linetype is.
    """

    centre: tuple[float, float]
    radius: float
    start_angle: float
    sweep: float
    linetype: Linetype
    confidence: float = 1.0

    @property
    def length(self) -> float:
        """Length along the circle."""
        return self.radius * self.sweep

    @property
    def is_full(self) -> bool:
        """Whether it is a whole circle, but for a gap as strokes that are read leave."""
        return self.sweep >= _FULL_SWEEP

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) points along the stroke, at most ``step`` apart, both ends included."""
        count = max(3, int(np.ceil(self.length / step)) + 1)
        angles = self.start_angle + np.linspace(0.0, self.sweep, count)
        return np.array(self.centre) + self.radius * np.stack([np.cos(angles), np.sin(angles)], 1)


@dataclass(frozen=True)
class Ellipse:
    """A stroke along an ellipse: a circle seen at a slant.

    Its points are ``centre + R (semi_major cos t, semi_minor sin t)``, where ``R`` turns by
    ``rotation`` and the parameter ``t`` runs from ``start`` to ``start + sweep``.

    Attributes:
        centre: (2,) as for :class:`Segment`.
        semi_major, semi_minor: in the plane's unit, the first the larger one, both positive.
        rotation: radians from the plane's first axis towards its second, of the major axis.
        start, sweep: radians of the parameter; ``sweep`` is positive and at most 2 pi, which is
            the full ellipse.
        linetype: visible or hidden.
        confidence: 0 to 1, how sure the linetype is.
    """

    centre: tuple[float, float]
    semi_major: float
    semi_minor: float
    rotation: float
    start: float
    sweep: float
    linetype: Linetype
    confidence: float = 1.0

    @property
    def whole(self) -> WholeEllipse:
        """The ellipse that the stroke is a piece of."""
        return WholeEllipse(self.centre, self.semi_major, self.semi_minor, self.rotation)

    @property
    def length(self) -> float:
        """Length along the ellipse."""
        return float(np.diff(self.whole.lengths(np.array([self.start, self._end])))[0])

    @property
    def _end(self) -> float:
        return self.start + self.sweep

    def parameters(self, positions: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n,) lengths along the ellipse from the stroke's start -> (n,) parameters."""
        whole = self.whole
        return whole.parameters(positions + whole.lengths(np.array([self.start])))

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) even points along the stroke, at most ``step`` apart, both ends included."""
        length = self.length
        count = max(3, int(np.ceil(length / step)) + 1)
        parameters = self.parameters(np.linspace(0.0, length, count))
        parameters[0], parameters[-1] = self.start, self._end
        return self.whole.at(parameters)

    def extremes(self) -> npt.NDArray[np.float64]:
        """(n, 2) both ends and the points at which the stroke turns back along an axis."""
        cosine, sine = float(np.cos(self.rotation)), float(np.sin(self.rotation))
        turning = np.array(
            [
                np.arctan2(-self.semi_minor * sine, self.semi_major * cosine),
                np.arctan2(self.semi_minor * cosine, self.semi_major * sine),
            ]
        )
        turning = self.start + np.mod(np.append(turning, turning + np.pi) - self.start, 2 * np.pi)
        ends = np.array([self.start, self._end])
        return self.whole.at(np.concatenate([ends, turning[turning < self._end]]))


Stroke = Segment | Arc | Ellipse


@dataclass(frozen=True)
class View:
    """One view of the part.

    Attributes:
        role: which view it is.
        box: (x0, y0, x1, y1) sheet pixels between the centre lines of the outermost strokes.
        strokes: in millimetres of the view's plane (right, up).
        mask: (h, w) bool, True where the part covers the plane; row 0 is the upper edge.
        colour: (h, w, 3) uint8 RGB, the part on white; blank of views that nobody coloured.
        origin: (right, up) in mm of the upper left corner of the mask's first pixel.
        mm_per_pixel: size of a mask pixel; the same in all views of a set.
    """

    role: Role
    box: tuple[float, float, float, float]
    strokes: tuple[Stroke, ...]
    mask: npt.NDArray[np.bool_]
    colour: npt.NDArray[np.uint8]
    origin: tuple[float, float]
    mm_per_pixel: float

    def to_pixels(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 2) plane millimetres -> (n, 2) mask pixels (x right, y down; centres at .5)."""
        scale = 1.0 / self.mm_per_pixel
        return (points - np.array(self.origin)) * np.array([scale, -scale])


@dataclass(frozen=True)
class ViewSet:
    """Views that show the same part.

    Attributes:
        views: one to six, each role once.
        size: (3,) extent of the part's bounding box in mm; it starts at the origin.
    """

    views: tuple[View, ...]
    size: tuple[float, float, float]

    def __getitem__(self, role: Role) -> View:
        return next(view for view in self.views if view.role is role)

    @property
    def roles(self) -> tuple[Role, ...]:
        """The roles in the order of the views."""
        return tuple(view.role for view in self.views)
