"""How one linear dimension is drawn (ISO 129-1, ASME Y14.5)."""

import math
from dataclasses import dataclass

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Box
from gaussiancad_core.drawing.annotation_pen import Direction, Pen
from gaussiancad_core.drawing.lettering import label, text_width
from gaussiancad_core.drawing.sheet_style import TextPlace
from gaussiancad_core.drawing.stations import DimensionableFeature
from gaussiancad_core.model.views import Segment

Span = tuple[float, float]
"""Least and greatest coordinate in px."""


@dataclass(frozen=True)
class DimensionLine:
    """A dimension between two stations, beside a view.

    Attributes:
        direction: along which it runs.
        side: 1 below or to the right of the view, -1 above or to the left.
        at: px across the direction.
        ends: the two stations, that with the lesser coordinate first.
        text: what it says, a number.
        pen: to draw with.
    """

    direction: Direction
    side: int
    at: float
    ends: tuple[DimensionableFeature, DimensionableFeature]
    text: str
    pen: Pen

    @property
    def measured(self) -> Span:
        """Along the line: what is measured."""
        return self.ends[0].at, self.ends[1].at

    @property
    def inline(self) -> bool:
        """The text interrupts the line and is level; else it stands above and along the line."""
        return self.pen.text_place is TextPlace.INLINE

    @property
    def arrows_outside(self) -> bool:
        """There is no room for the arrows between the extension lines."""
        low, high = self.measured
        needed = 2.6 * self.pen.arrow
        if self.inline and self._fits_between:
            needed += self._text_length
        return high - low < needed

    @property
    def text_along(self) -> Span:
        """Along the line: the text, in the middle if it fits, else beside it."""
        low, high = self.measured
        length = self._text_length
        if self._fits_between:
            middle = 0.5 * (low + high)
            return middle - 0.5 * length, middle + 0.5 * length
        outside = 1.2 * self.pen.arrow + self.pen.gap
        if self.inline:
            outside += self.pen.arrow
        if self.direction is Direction.HORIZONTAL:
            return high + outside, high + outside + length
        return low - outside - length, low - outside

    @property
    def text_across(self) -> Span:
        """Across the line: the text."""
        if self.inline:
            half = 0.5 * (self.pen.height if self._level else self._width)
            return self.at - half, self.at + half
        return self.at - self.pen.gap - self.pen.height, self.at - self.pen.gap

    @property
    def along(self) -> Span:
        """Along the line: all of it, with text and outer arrows."""
        low, high = self.measured
        if self.arrows_outside:
            low, high = low - 1.8 * self.pen.arrow, high + 1.8 * self.pen.arrow
        text = self.text_along
        return min(low, text[0]), max(high, text[1])

    @property
    def footprint(self) -> Box:
        """Around line and text, with the ends of the extension lines."""
        low, high = self.text_across
        reach = self.pen.overshoot
        return self.direction.box(
            self.along, (min(low, self.at - reach), max(high, self.at + reach))
        )

    @property
    def solid_boxes(self) -> tuple[Box, Box]:
        """What no other line may cross: the line between its arrows, and the text."""
        half = 0.2 * self.pen.arrow
        low, high = self.text_across
        return (
            self.direction.box(self.measured, (self.at - half, self.at + half)),
            self.direction.box(self.text_along, (low, max(high, self.at))),
        )

    def draw(self) -> list[Annotation]:
        """The line with its arrows, its two extension lines, its text; in group 0."""
        pen, direction = self.pen, self.direction
        low, high = self.measured
        way = -1.0 if self.arrows_outside else 1.0
        arrows = tuple(
            pen.arrowhead(direction.point(tip, self.at), direction.point(tip + tail, self.at))
            for tip, tail in ((low, way), (high, -way))
        )
        along, across = (0.5 * sum(span) for span in (self.text_along, self.text_across))
        # Text along an upright line is read from the right.
        angle = 0.0 if self.inline or self._level else -0.5 * math.pi
        written = label(self.text, direction.point(along, across), pen.height, angle)
        return [
            Annotation(
                AnnotationKind.DIMENSION,
                0,
                self._pieces(),
                pen.width,
                arrows=arrows,
                value_mm=float(self.text),
            ),
            *(
                Annotation(AnnotationKind.EXTENSION, 0, (self._extension(end),), pen.width)
                for end in self.ends
            ),
            Annotation(AnnotationKind.TEXT, 0, label=written),
        ]

    @property
    def _level(self) -> bool:
        return self.direction is Direction.HORIZONTAL

    @property
    def _width(self) -> float:
        return text_width(self.text, self.pen.height)

    @property
    def _text_length(self) -> float:
        """px of the text along the line."""
        return self.pen.height if self.inline and not self._level else self._width

    @property
    def _fits_between(self) -> bool:
        low, high = self.measured
        # Interrupted lines keep some of themselves at both sides of the text.
        spare = 2.0 * (self.pen.arrow + self.pen.gap) if self.inline else self.pen.gap
        return self._text_length + spare <= high - low

    def _pieces(self) -> tuple[Segment, ...]:
        """The line, without what the text interrupts."""
        start, end = self.along
        pieces = [(start, end)]
        if self.inline:
            low, high = self.text_along[0] - self.pen.gap, self.text_along[1] + self.pen.gap
            pieces = [(start, min(end, low)), (max(start, high), end)]
        return tuple(
            self.direction.segment((low, self.at), (high, self.at))
            for low, high in pieces
            if high > low
        )

    def _extension(self, station: DimensionableFeature) -> Segment:
        border = station.high if self.side > 0 else station.low
        near, far = border + self.side * self.pen.gap, self.at + self.side * self.pen.overshoot
        return self.direction.segment((station.at, near), (station.at, far))
