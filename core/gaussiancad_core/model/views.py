"""Views of one part with shared axes in millimetres: what every later stage starts from.

A view's plane has the coordinates (right, up) of :mod:`.axes`.  The model occupies
``[0, size]`` on each axis, so the front view spans ``[0, size_x] x [0, size_z]`` and the left view
``[-size_y, 0] x [0, size_z]``.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.model.axes import Role


class Linetype(Enum):
    """How a stroke is drawn: solid lines are visible edges, dashed lines hidden ones (ISO 128)."""

    VISIBLE = "visible"
    HIDDEN = "hidden"


_FULL_SWEEP = 6.2
"""Radians from which an arc is a circle."""


@dataclass(frozen=True)
class _Drawn:
    """How a curve is drawn.

    Attributes:
        linetype: visible or hidden.
        confidence: 0 to 1, how sure the linetype is.
    """

    linetype: Linetype
    confidence: float = 1.0


@dataclass(frozen=True)
class Segment(_Drawn, LineSegment):
    """A straight stroke, in the plane of whoever holds it: sheet pixels (x right, y down) or view
    millimetres (right, up)."""


@dataclass(frozen=True)
class Arc(_Drawn, CircularArc):
    """A stroke along a circle, in a plane as of :class:`Segment`."""

    @property
    def is_full(self) -> bool:
        """Whether it is a whole circle, but for a gap as strokes that are read leave."""
        return self.sweep >= _FULL_SWEEP


@dataclass(frozen=True)
class Ellipse(_Drawn, EllipticArc):
    """A stroke along an ellipse, in a plane as of :class:`Segment`."""


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
