"""What stands on a sheet beside the part's own lines, as data."""

from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.geometry.points import box_around
from gaussiancad_core.geometry.similarities import turn_about
from gaussiancad_core.lines.strokes import DrawnStroke

Point = tuple[float, float]
Box = tuple[float, float, float, float]
"""x0, y0, x1, y1 in px of the sheet, y down."""


class AnnotationKind(Enum):
    """What a mark on the sheet is (ISO 128, ISO 129-1, ISO 5457, ISO 7200)."""

    FRAME = "frame"
    TITLE_BLOCK = "title-block"
    TEXT = "text"
    DIMENSION = "dimension"
    EXTENSION = "extension"
    LEADER = "leader"
    CENTRE_LINE = "centre-line"
    CENTRE_MARK = "centre-mark"
    SYMBOL = "symbol"
    PICTURE = "picture"
    HATCHING = "hatching"
    BREAK = "break"
    DETAIL = "detail"
    AUXILIARY = "auxiliary-view"
    OTHER_PART = "other-part"
    SYMMETRY = "symmetry"
    THREAD = "thread"
    TANGENT_EDGE = "tangent-edge"


class Rhythm(Enum):
    """How the ink of an annotation's line is interrupted."""

    CONTINUOUS = "continuous"
    LONG_SHORT = "long-short"


@dataclass(frozen=True)
class Label:
    """A line of text.

    Attributes:
        text: what it says.
        centre: (2,) sheet px of the middle of its letters.
        height: px of its capitals and digits.
        width: px from the first letter's start to the last one's end.
        angle: radians from the sheet's right towards its bottom along which it is written; text
            read from the right has -pi / 2.
    """

    text: str
    centre: Point
    height: float
    width: float
    angle: float = 0.0

    @property
    def corners(self) -> tuple[Point, Point, Point, Point]:
        """The four corners of the rectangle around its capitals, in sheet px."""
        along = 0.5 * self.width * np.array([np.cos(self.angle), np.sin(self.angle)])
        down = 0.5 * self.height * np.array([-np.sin(self.angle), np.cos(self.angle)])
        middle = np.array(self.centre)
        ways = (-along - down, along - down, along + down, -along + down)
        first, second, third, fourth = (
            (float(x), float(y)) for x, y in (middle + way for way in ways)
        )
        return first, second, third, fourth


@dataclass(frozen=True)
class Annotation:
    """One mark: lines, filled arrowheads, text.

    Attributes:
        kind: what it is.
        group: number of the note it belongs to: a dimension, its extension lines and its text have
            the same.
        strokes: sheet px; their linetype means nothing.
        width: px of its lines.
        rhythm: of its lines.
        arrows: filled polygons in sheet px.
        label: its text.
        value_mm: what a dimension says, or None.
    """

    kind: AnnotationKind
    group: int
    strokes: tuple[DrawnStroke, ...] = ()
    width: float = 1.0
    rhythm: Rhythm = Rhythm.CONTINUOUS
    arrows: tuple[tuple[Point, ...], ...] = ()
    label: Label | None = None
    value_mm: float | None = None

    @property
    def box(self) -> Box:
        """Around all of it, between the centre lines of its outermost strokes."""
        corners = [np.array(arrow) for arrow in self.arrows]
        if self.strokes:
            corners.append(np.array(bounds(self.strokes)).reshape(2, 2))
        if self.label is not None:
            corners.append(np.array(self.label.corners))
        return box_around(np.concatenate(corners))

    def turned(self, angle: float, centre: Point) -> "Annotation":
        """Turned by ``angle`` radians, from the sheet's right towards its bottom."""
        turn = turn_about(centre, angle)
        return replace(
            self,
            strokes=tuple(stroke.mapped(turn) for stroke in self.strokes),
            arrows=tuple(tuple(turn.point(point) for point in arrow) for arrow in self.arrows),
            label=None
            if self.label is None
            else replace(
                self.label,
                centre=turn.point(self.label.centre),
                angle=self.label.angle + angle,
            ),
        )
