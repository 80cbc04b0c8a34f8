"""What vector files know better than pixels: exact curves, line widths, dashes, layers, text.

Everything is in pixels of the sheet's raster: x right, y down, the origin at the outer corner of
the first pixel, whose centre lies at (.5, .5).  Angles run from x towards y.
"""

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

Point = tuple[float, float]
Box = tuple[float, float, float, float]
"""x0, y0, x1, y1."""

Colour = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""

FULL_TURN = 2.0 * np.pi

_ARC_NODES = 65
"""Points by which an elliptic arc's length and box are taken."""


class StrokeRole(Enum):
    """What the name of a linetype or layer, or the dash pattern, says a stroke stands for.

    It is a hint.  ``VISIBLE`` is a solid line of a DXF file that nothing else is said of;
    ``UNKNOWN`` is any other line that neither names nor dashes tell of, such as a solid line of a
    PDF or SVG file.  ``HATCH`` is hatching by its name; ``OTHER`` is a line of another meaning by
    its name: phantom, dimension, frame.
    """

    VISIBLE = "visible"
    HIDDEN = "hidden"
    CENTRE = "centre"
    HATCH = "hatch"
    OTHER = "other"
    UNKNOWN = "unknown"


class StrokeKind(Enum):
    """From what a stroke was made."""

    GEOMETRY = "geometry"
    BLOCK = "block"
    DIMENSION = "dimension"
    LEADER = "leader"
    HATCH = "hatch"
    FILL = "fill"


@dataclass(frozen=True)
class Line:
    """A straight piece."""

    start: Point
    end: Point

    @property
    def length(self) -> float:
        """In px."""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) points along the curve, at most ``step`` apart, both ends included."""
        count = max(1, int(np.ceil(self.length / step)))
        if count == 1:
            return np.array((self.start, self.end))
        return np.linspace(self.start, self.end, count + 1)


@dataclass(frozen=True)
class CircularArc:
    """A piece of a circle.

    Attributes:
        centre, radius: px.
        start_angle: radians.
        sweep: radians, positive, at most a full turn.
    """

    centre: Point
    radius: float
    start_angle: float
    sweep: float

    @property
    def length(self) -> float:
        """In px."""
        return self.radius * self.sweep

    @property
    def is_full(self) -> bool:
        """Whether it is the whole circle."""
        return self.sweep >= FULL_TURN * (1.0 - 1e-9)

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) points along the curve, at most ``step`` apart, both ends included."""
        count = max(3, int(np.ceil(self.length / step)) + 1)
        angles = self.start_angle + np.linspace(0.0, self.sweep, count)
        return np.array(self.centre) + self.radius * np.stack([np.cos(angles), np.sin(angles)], 1)


@dataclass(frozen=True)
class EllipticArc:
    """A piece of an ellipse.

    Attributes:
        centre: px.
        major: (2,) px, from the centre to the end of the semi-major axis.
        ratio: semi-minor over semi-major axis, in (0, 1]; the minor axis lies a right angle from
            the major one, towards y where the major one points along x.
        start: parameter in radians, 0 at the end of the major axis.
        sweep: of the parameter, positive, at most a full turn.
    """

    centre: Point
    major: Point
    ratio: float
    start: float
    sweep: float

    @property
    def length(self) -> float:
        """In px, of the chords between a fixed number of points."""
        steps = np.diff(self.spread(_ARC_NODES), axis=0)
        return float(np.hypot(steps[:, 0], steps[:, 1]).sum())

    @property
    def is_full(self) -> bool:
        """Whether it is the whole ellipse."""
        return self.sweep >= FULL_TURN * (1.0 - 1e-9)

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) points along the curve, at most ``step`` apart, both ends included."""
        longest = self.sweep * float(np.hypot(*self.major))
        return self.spread(max(3, int(np.ceil(longest / step)) + 1))

    def spread(self, count: int) -> npt.NDArray[np.float64]:
        """(count, 2) points at equal steps of the parameter, both ends included."""
        t = self.start + np.linspace(0.0, self.sweep, count)[:, None]
        major = np.array(self.major)
        minor = self.ratio * np.array([-major[1], major[0]])
        return np.array(self.centre) + np.cos(t) * major + np.sin(t) * minor


@dataclass(frozen=True)
class Chain:
    """Straight pieces that follow a free curve, within a fiftieth of a pixel.

    Attributes:
        points: two or more; the last is the first where the curve is closed.
    """

    points: tuple[Point, ...]

    @property
    def length(self) -> float:
        """In px."""
        return float(self._way[-1])

    @property
    def shares(self) -> npt.NDArray[np.float64]:
        """(n,) shares of the length up to each point, 0 to 1."""
        way = self._way
        return way / way[-1] if way[-1] > 0.0 else np.linspace(0.0, 1.0, len(way))

    def at(self, shares: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 2) the points at shares of the length, in order."""
        this_shares = self.shares
        return np.stack(
            [np.interp(shares, this_shares, column) for column in np.array(self.points).T], 1
        )

    @property
    def _way(self) -> npt.NDArray[np.float64]:
        """(n,) px along the chain up to each point."""
        steps = np.diff(np.array(self.points), axis=0)
        return np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])

    def sample(self, step: float) -> npt.NDArray[np.float64]:
        """(n, 2) points along the curve, at most ``step`` apart, all its own points included."""
        corners = np.array(self.points)
        ways = np.diff(corners, axis=0)
        lengths = np.hypot(ways[:, 0], ways[:, 1])
        counts = np.maximum(np.ceil(lengths / step), 1.0).astype(np.int64)
        if int(counts.max()) == 1:
            return corners
        piece = np.repeat(np.arange(len(ways)), counts)
        number = np.arange(len(piece)) - np.repeat(np.cumsum(counts) - counts, counts)
        points = corners[piece] + number[:, None] * (ways / counts[:, None])[piece]
        return np.concatenate([points, corners[-1:]])


Curve = Line | CircularArc | EllipticArc | Chain


@dataclass(frozen=True)
class VectorStroke:
    """A curve as the file draws it.

    Attributes:
        curve: its centre line.
        width: px, or None where the file does not say.
        dashes: px, lengths of dash and gap in turn, empty for a solid line.
        role: what names and dashes say it is.
        layer: name of its layer, empty where there is none.
        kind: from what it was made.
        colour: (red, green, blue) 0 to 255; None where the file does not say.
        step: px of the grid to which its places were rounded when the file was written; 0 where
            they are as exact as the drawing.
    """

    curve: Curve
    width: float | None
    dashes: tuple[float, ...] = ()
    role: StrokeRole = StrokeRole.UNKNOWN
    layer: str = ""
    kind: StrokeKind = StrokeKind.GEOMETRY
    colour: Colour | None = None
    step: float = 0.0

    @property
    def is_solid(self) -> bool:
        """Whether it is a line without gaps, as far as names and dashes tell."""
        line = self.kind is not StrokeKind.FILL and not self.dashes
        return line and self.role not in (StrokeRole.HIDDEN, StrokeRole.CENTRE)


@dataclass(frozen=True)
class VectorText:
    """A line of text.

    Attributes:
        text: the characters.
        box: px, around it; estimated from the size of the letters where the file does not say.
        angle: radians from x towards y, of its reading direction.
    """

    text: str
    box: Box
    angle: float = 0.0


@dataclass(frozen=True)
class VectorDrawing:
    """The lines and texts of a page.

    Attributes:
        strokes: in the file's order.
        texts: in the file's order.
        complete: False if the page shows anything else, such as a picture.
        has_paper: False where the drawing lies in free space, as in the model space of a CAD
            system: the sheet is then no more than what is drawn, with a margin.
        unit_mm: mm to the unit that the file says its lengths are in; None where it does not, or
            where they are the paper's.
        unit_px: px to the unit of a file that does not say which that is.
        pictures: boxes of what else the page shows, where the file tells where that is.
    """

    strokes: tuple[VectorStroke, ...]
    texts: tuple[VectorText, ...]
    complete: bool = True
    has_paper: bool = True
    unit_mm: float | None = None
    unit_px: float | None = None
    pictures: tuple[Box, ...] = ()


def bounds(curves: list[Curve]) -> Box | None:
    """Box around the centre lines of curves; None if there are none."""
    if not curves:
        return None
    corners = np.array([_curve_box(curve) for curve in curves])
    low, high = corners[:, :2].min(axis=0), corners[:, 2:].max(axis=0)
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def _curve_box(curve: Curve) -> Box:
    if isinstance(curve, Line):
        (x0, y0), (x1, y1) = curve.start, curve.end
        return min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1)
    if isinstance(curve, Chain):
        points = np.array(curve.points)
    else:
        points = np.concatenate([curve.sample(np.inf), _extremes(curve)])
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    return float(x0), float(y0), float(x1), float(y1)


def _extremes(curve: CircularArc | EllipticArc) -> npt.NDArray[np.float64]:
    """(n, 2) points of an arc where it runs along an axis of the sheet."""
    if isinstance(curve, CircularArc):
        start, u, v = (
            curve.start_angle,
            np.array([curve.radius, 0.0]),
            np.array([0, curve.radius]),
        )
    else:
        start, u = curve.start, np.array(curve.major)
        v = curve.ratio * np.array([-u[1], u[0]])
    turns = np.arctan2(v, u)
    angles = np.concatenate([turns, turns + np.pi])
    angles = angles[np.mod(angles - start, FULL_TURN) <= curve.sweep][:, None]
    return np.array(curve.centre) + np.cos(angles) * u + np.sin(angles) * v
