"""What lies on a sheet of paper: strokes, texts, filled areas and pictures.

Everything is in mm of paper: x right, y down, the origin at the upper left corner.  Nothing here
knows of files or pixels.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
import shapely
from shapely import LineString

from gaussiancad_core.files.vectors import Colour, StrokeKind, StrokeRole
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import Box

Points = npt.NDArray[np.float64]
"""(n, 2) mm."""

_CHORD = np.radians(5.0)
"""Turn of the chords that stand for an arc."""


@dataclass(frozen=True)
class Pen:
    """What strokes look like.

    Attributes:
        width: mm, to a hundredth; 0 where the file does not say.
        colour: red, green and blue, 0 to 255; None where the file does not say.
        layer: its name, empty where there is none.
    """

    width: float
    colour: Colour | None
    layer: str


@dataclass(frozen=True, eq=False)
class PaperStroke:
    """A line, arc or free curve.

    Attributes:
        curve: its centre line, mm.
        pen: what it looks like.
        dashes: mm, lengths of dash and gap in turn; empty of a solid stroke.
        role: what its file says that it stands for.
        kind: from what its file made it.
        step: mm of the grid to which its places were rounded when the file was written; 0 of exact
            ones.
    """

    curve: Curve
    pen: Pen
    dashes: tuple[float, ...] = ()
    role: StrokeRole = StrokeRole.UNKNOWN
    kind: StrokeKind = StrokeKind.GEOMETRY
    step: float = 0.0

    @property
    def is_line(self) -> bool:
        """Whether it is straight."""
        return isinstance(self.curve, LineSegment)

    @property
    def is_round(self) -> bool:
        """Whether it is an arc of a circle, or a whole one."""
        return isinstance(self.curve, CircularArc)

    @property
    def is_circle(self) -> bool:
        """Whether it is a whole circle."""
        return isinstance(self.curve, CircularArc) and self.curve.is_closed

    @cached_property
    def points(self) -> Points:
        """(n, 2) corners of a chain along it."""
        curve = self.curve
        if isinstance(curve, Chain):
            return np.array(curve.points)
        if isinstance(curve, LineSegment):
            return np.array([curve.start, curve.end])
        if isinstance(curve, EllipticArc):
            return curve.spread(max(3, int(np.ceil(curve.sweep / _CHORD)) + 1))
        return curve.vertices(_CHORD * curve.radius)

    @cached_property
    def line(self) -> LineString:
        """The same, for shapely."""
        return LineString(self.points)

    @cached_property
    def box(self) -> Box:
        """Around it, mm."""
        if isinstance(self.curve, LineSegment):
            return self.curve.box
        x0, y0 = self.points.min(axis=0).tolist()
        x1, y1 = self.points.max(axis=0).tolist()
        return x0, y0, x1, y1

    @cached_property
    def length(self) -> float:
        """mm along it."""
        if isinstance(self.curve, LineSegment):
            return self.curve.length
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())

    @property
    def size(self) -> float:
        """mm of the longer side of its box."""
        x0, y0, x1, y1 = self.box
        return max(x1 - x0, y1 - y0)

    @property
    def ends(self) -> Points:
        """(2, 2) where it begins and ends."""
        return self.points[[0, -1]]

    @cached_property
    def way(self) -> Points:
        """(2,) of length 1, from where it begins to where it ends."""
        along = self.points[-1] - self.points[0]
        return np.asarray(along / max(float(np.hypot(*along)), 1e-12))


def lines_of(strokes: Sequence[PaperStroke]) -> npt.NDArray[np.object_]:
    """(n,) their lines for shapely: those of straight ones, which are many, are made at once."""
    straight = [
        (stroke, (stroke.curve.start, stroke.curve.end))
        for stroke in strokes
        if isinstance(stroke.curve, LineSegment) and "line" not in vars(stroke)
    ]
    ends = np.array([pair for _, pair in straight]).reshape(-1, 2, 2)
    for (stroke, _), line in zip(straight, shapely.linestrings(ends), strict=True):
        vars(stroke)["line"] = line
    return np.array([stroke.line for stroke in strokes], dtype=object)


@dataclass(frozen=True)
class PaperText:
    """A line of text that a file has as such.

    Attributes:
        text: its characters.
        box: around it, mm.
        angle: radians from x towards y, of its reading direction.
    """

    text: str
    box: Box
    angle: float = 0.0


@dataclass(frozen=True, eq=False)
class PaperSheet:
    """A sheet.

    Attributes:
        size: width and height, mm.
        strokes: lines, arcs and curves.
        texts: those that the file has as such.
        fills: outlines of filled areas.
        pictures: boxes around what is neither, mm.
        has_paper: False of a drawing in free space, whose size on paper is a guess.
        px_per_mm: of its raster, if anybody asks for one.
        paint: a function from a box in mm to its (h, w) grey levels; None where nothing is painted.
    """

    size: tuple[float, float]
    strokes: tuple[PaperStroke, ...]
    texts: tuple[PaperText, ...] = ()
    fills: tuple[PaperStroke, ...] = ()
    pictures: tuple[Box, ...] = ()
    has_paper: bool = True
    px_per_mm: float = 1.0
    paint: Callable[[Box], npt.NDArray[np.uint8]] | None = None
