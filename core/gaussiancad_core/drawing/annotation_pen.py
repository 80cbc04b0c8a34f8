"""The lengths that annotations are drawn with, and where on the sheet there is room for them."""

from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.drawing.annotation import Box, Point
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.sheet_style import SheetStyle, TextPlace
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Linetype, Segment


class Direction(Enum):
    """Along which of the sheet's axes something runs; the value is that coordinate's index."""

    HORIZONTAL = 0
    VERTICAL = 1

    @property
    def other(self) -> "Direction":
        """The direction across."""
        return Direction(1 - self.value)

    def point(self, along: float, across: float) -> Point:
        """The sheet's (x, y) of a point given along and across this direction."""
        return (along, across) if self is Direction.HORIZONTAL else (across, along)

    def segment(self, start: Point, end: Point) -> Segment:
        """A stroke between two (along, across) points."""
        return Segment(self.point(*start), self.point(*end), Linetype.VISIBLE)

    def span(self, box: Box) -> tuple[float, float]:
        """Least and greatest coordinate of a box along this direction."""
        return box[self.value], box[self.value + 2]

    def box(self, along: tuple[float, float], across: tuple[float, float]) -> Box:
        """The box of two intervals."""
        (x0, y0), (x1, y1) = self.point(along[0], across[0]), self.point(along[1], across[1])
        return x0, y0, x1, y1


@dataclass(frozen=True)
class Pen:
    """The lengths of annotations in px; all but the width follow from the height of the text.

    Attributes:
        width: of the lines.
        height: of capitals and digits.
        text_place: of dimensions.
    """

    width: float
    height: float
    text_place: TextPlace = TextPlace.ABOVE

    @classmethod
    def of(cls, style: SheetStyle) -> "Pen":
        """The pen of a style."""
        return cls(style.annotation_width, style.text_height, style.text_place)

    @property
    def arrow(self) -> float:
        """Length of an arrowhead."""
        return max(0.75 * self.height, 5.0 * self.width)

    @property
    def gap(self) -> float:
        """From an outline to an extension line, and from a line to its text."""
        return 0.3 * self.height

    @property
    def overshoot(self) -> float:
        """By how much lines reach beyond what they belong to."""
        return 0.3 * self.height

    @property
    def first(self) -> float:
        """From a view to its nearest dimension line."""
        return 1.8 * self.height

    @property
    def pitch(self) -> float:
        """From a dimension line to the next one."""
        return 1.9 * self.height

    def arrowhead(self, tip: Point, tail: Point) -> tuple[Point, ...]:
        """A filled arrowhead whose axis runs from ``tail`` to ``tip`` (ISO 129-1)."""
        dx, dy = tip[0] - tail[0], tip[1] - tail[1]
        length = (dx * dx + dy * dy) ** 0.5
        ux, uy = dx / length, dy / length
        back = tip[0] - self.arrow * ux, tip[1] - self.arrow * uy
        half = 0.17 * self.arrow
        return (
            tip,
            (back[0] - half * uy, back[1] + half * ux),
            (back[0] + half * uy, back[1] - half * ux),
        )


class Room:
    """What is already taken on a sheet, while annotations are being placed.

    Args:
        bounds: nothing may leave this box.
        taken: boxes that have to stay free.
    """

    def __init__(self, bounds: Box, taken: list[Box]) -> None:
        self._bounds = bounds
        self._taken = list(taken)

    def free(self, box: Box, clearance: float = 0.0) -> bool:
        """Whether a box lies in the bounds and nothing is nearer to it than ``clearance`` px."""
        x0, y0, x1, y1 = box
        inside = (
            self._bounds[0] + clearance <= x0
            and self._bounds[1] + clearance <= y0
            and x1 <= self._bounds[2] - clearance
            and y1 <= self._bounds[3] - clearance
        )
        return inside and not self.touched(box, clearance)

    def touched(self, box: Box, clearance: float = 0.0) -> bool:
        """Whether anything taken is nearer to a box than ``clearance`` px; touching is not."""
        x0, y0, x1, y1 = box
        return any(
            x0 - clearance < u1
            and u0 < x1 + clearance
            and y0 - clearance < v1
            and v0 < y1 + clearance
            for u0, v0, u1, v1 in self._taken
        )

    def take(self, box: Box) -> None:
        """Mark a box as taken."""
        self._taken.append(box)


@dataclass(frozen=True, eq=False)
class Board:
    """What is drawn already when dimensions and notes are added.

    Attributes:
        views: not turned.
        centre_lines: of the views.
        mm_per_pixel: scale of the views.
        pen: to draw with.
        room: what is taken; what is drawn is added to it.
    """

    views: tuple[DrawnView, ...]
    centre_lines: tuple[DrawnStroke, ...]
    mm_per_pixel: float
    pen: Pen
    room: Room
