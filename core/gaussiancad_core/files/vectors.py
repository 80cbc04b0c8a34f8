"""What vector files know better than pixels: exact curves, line widths, dashes, layers, text.

Everything is in pixels of the sheet's raster: x right, y down, the origin at the outer corner of
the first pixel, whose centre lies at (.5, .5).  Angles run from x towards y.
"""

from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import Box

Colour = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""


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
