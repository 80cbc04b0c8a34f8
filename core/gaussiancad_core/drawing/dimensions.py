"""Linear dimensions (ISO 129-1): extents, steps and the places of circles.

Dimensions stand in rows beside a view, the shorter ones nearer to it, all from the view's left or
lower border.  What one view says, no other says again.
"""

import math
from dataclasses import dataclass, replace
from itertools import product

from gaussiancad_core.axes import Axis
from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Box
from gaussiancad_core.drawing.centre_lines import Round, model_axis, rounds, to_model
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.lettering import label, text_width
from gaussiancad_core.drawing.pen import Board, Direction
from gaussiancad_core.drawing.stations import Station, border_station, stations

_INNER = 2
"""Most dimensions a direction of a view has beside the whole extent."""

_ROWS = 4
"""Most rows of dimensions on one side of a view."""

_KNOWN = 1.0
"""px within which a place has been said already."""


@dataclass(frozen=True)
class _Line:
    """A dimension line: where it is measured, from where, and how it is written.

    Attributes:
        direction: along which it runs.
        side: 1 below or to the right of the view, -1 above or to the left.
        at: px across the direction.
        ends: the two stations, that with the lesser coordinate first.
        text: what it says.
    """

    direction: Direction
    side: int
    at: float
    ends: tuple[Station, Station]
    text: str


@dataclass(frozen=True)
class _Places:
    """Places on the model's axes, in px.

    Attributes:
        said: by earlier dimensions.
        implied: sides of circles, which follow from centres and diameters.
    """

    said: dict[Axis, list[float]]
    implied: dict[Axis, list[float]]

    def knows(self, axis: Axis, place: float, centre: bool) -> bool:
        """Whether a place, the centre of a circle or an edge, need not be said."""
        known = self.said[axis] if centre else self.said[axis] + self.implied[axis]
        return any(abs(place - other) < _KNOWN for other in known)


def draw_dimensions(board: Board, group: int) -> list[Annotation]:
    """Dimensions of the views, as far as there is room.

    Args:
        board: the views; the dimensions are added to its room.
        group: number of the first dimension; each counts one up.
    """
    views = board.views
    places = _Places({axis: [] for axis in Axis}, _flanks(views))
    whole: set[Axis] = set()
    for view, direction in product(views, Direction):
        if any(_fills(circle, view, direction) for circle in rounds(view)):
            axis = model_axis(view, direction)[0]
            whole.add(axis)
            # What lies in the middle of something round is known to do so.
            low, high = direction.span(view.box)
            places.said[axis].append(0.5 * (high - low))
    drawn: list[Annotation] = []
    for view, direction in product(views, Direction):
        axis = model_axis(view, direction)[0]
        ends = direction.span(view.box)
        first, last = ends if direction is Direction.HORIZONTAL else ends[::-1]
        datum = border_station(view, direction, first)
        wanted = _inner(view, direction, places, board)
        wanted.sort(key=lambda station, first=first: abs(station.at - first))
        if axis not in whole:
            wanted.append(border_station(view, direction, last))
        beside = _Beside(view, direction, board)
        for station in wanted:
            text = value_text(abs(station.at - datum.at) * board.mm_per_pixel)
            placed = beside.place(datum, station, text)
            if not placed:
                continue
            drawn += [replace(annotation, group=group) for annotation in placed]
            group += 1
            places.said[axis].append(to_model(view, direction, station.at))
            if station.at == last:
                whole.add(axis)
    return drawn


def _flanks(views: tuple[DrawnView, ...]) -> dict[Axis, list[float]]:
    """Places on the model's axes where the sides of circles are."""
    places: dict[Axis, list[float]] = {axis: [] for axis in Axis}
    for view in views:
        for circle in rounds(view):
            for direction in Direction:
                centre = circle.centre[direction.value]
                places[model_axis(view, direction)[0]] += [
                    to_model(view, direction, centre + reach)
                    for reach in (-circle.radius, circle.radius)
                ]
    return places


def value_text(millimetres: float) -> str:
    """A length as a drawing says it: two decimals at most, no idle zeros."""
    return f"{millimetres:.2f}".rstrip("0").rstrip(".")


def _fills(circle: Round, view: DrawnView, direction: Direction) -> bool:
    """Whether a view's extent is that of a circle, whose diameter is then said instead."""
    low, high = direction.span(view.box)
    return circle.whole and abs(2.0 * circle.radius - (high - low)) < _KNOWN


def _inner(view: DrawnView, direction: Direction, places: _Places, board: Board) -> list[Station]:
    """The weightiest stations between a view's borders that nothing has said yet.

    Places of holes come first: a machinist looks for them first.
    """
    low, high = direction.span(view.box)
    chosen: list[Station] = []
    for station in sorted(
        stations(view, direction, board.centre_lines), key=lambda item: -item.weight
    ):
        taken = [low, high, *(other.at for other in chosen)]
        place = to_model(view, direction, station.at)
        if min(abs(station.at - at) for at in taken) < board.pen.height:
            continue
        if places.knows(model_axis(view, direction)[0], place, station.centre):
            continue
        chosen.append(station)
        if len(chosen) == _INNER:
            break
    return chosen


def _side_costs(
    view: DrawnView, direction: Direction, views: tuple[DrawnView, ...]
) -> dict[int, float]:
    """px of extension line that each side of a view is worth less than the best one."""
    low, high = direction.other.span(view.box)
    start, end = direction.span(view.box)
    # Below and to the left, where nothing speaks for the other side.
    usual = 1 if direction is Direction.HORIZONTAL else -1
    costs = {usual: 0.0, -usual: 1.0}
    for other in views:
        first, last = direction.span(other.box)
        if other is view or last <= start or end <= first:
            continue
        first, last = direction.other.span(other.box)
        for side, beside in ((1, first >= high), (-1, last <= low)):
            if beside:
                costs[side] += 0.25 * (high - low)
    return costs


class _Beside:
    """The rows of dimensions on both sides of a view, filled from the inside out."""

    def __init__(self, view: DrawnView, direction: Direction, board: Board) -> None:
        self._view = view
        self._direction = direction
        self._costs = _side_costs(view, direction, board.views)
        self._rows = dict.fromkeys(self._costs, 0)
        self._pen = board.pen
        self._room = board.room

    def place(self, datum: Station, station: Station, text: str) -> list[Annotation]:
        """A dimension in the first row that is free; nothing if there is none."""
        low, high = self._direction.other.span(self._view.box)
        first, second = sorted((datum, station), key=lambda item: item.at)
        inside = {1: high - station.high, -1: station.low - low}
        for side in sorted(self._rows, key=lambda side: inside[side] + self._costs[side]):
            for row in range(self._rows[side], _ROWS):
                away = self._pen.first + row * self._pen.pitch
                at = high + away if side > 0 else low - away
                line = _Line(self._direction, side, at, (first, second), text)
                if self._fits(line):
                    self._rows[side] = row + 1
                    return self._drawn(line)
        return []

    def _fits(self, line: _Line) -> bool:
        pen, direction = self._pen, line.direction
        low, high = self._inked_span(line)
        above = line.at - pen.gap - pen.height
        whole = direction.box((low, high), (above, line.at + pen.overshoot))
        if not self._room.free(whole, 0.25 * pen.height):
            return False
        return not any(self._room.touched(box) for box in self._extension_boxes(line))

    def _extension_boxes(self, line: _Line) -> list[Box]:
        """The extension lines outside of the view."""
        border = self._direction.other.span(self._view.box)[1 if line.side > 0 else 0]
        start = border + line.side * 0.5 * self._pen.gap
        across = tuple(sorted((start, line.at)))
        return [line.direction.box((end.at, end.at), across) for end in line.ends]

    def _text_span(self, line: _Line) -> tuple[float, float]:
        """Along the line: the text, in the middle if it fits, else beside it."""
        pen = self._pen
        low, high = (end.at for end in line.ends)
        width = text_width(line.text, pen.height)
        if width + pen.gap <= high - low:
            middle = 0.5 * (low + high)
            return middle - 0.5 * width, middle + 0.5 * width
        outside = 1.2 * pen.arrow + pen.gap
        if line.direction is Direction.HORIZONTAL:
            return high + outside, high + outside + width
        return low - outside - width, low - outside

    def _arrows_outside(self, line: _Line) -> bool:
        return line.ends[1].at - line.ends[0].at < 2.6 * self._pen.arrow

    def _inked_span(self, line: _Line) -> tuple[float, float]:
        """Along the line: all of it, with text and outer arrows."""
        low, high = (end.at for end in line.ends)
        text = self._text_span(line)
        if self._arrows_outside(line):
            low, high = low - 1.8 * self._pen.arrow, high + 1.8 * self._pen.arrow
        return min(low, text[0]), max(high, text[1])

    def _drawn(self, line: _Line) -> list[Annotation]:
        pen, direction = self._pen, line.direction
        low, high = (end.at for end in line.ends)
        text = self._text_span(line)
        start, end = self._inked_span(line)
        way = -1.0 if self._arrows_outside(line) else 1.0
        arrows = tuple(
            pen.arrowhead(direction.point(tip, line.at), direction.point(tip + tail, line.at))
            for tip, tail in ((low, way), (high, -way))
        )
        extensions = []
        for station in line.ends:
            border = station.high if line.side > 0 else station.low
            near, far = border + line.side * pen.gap, line.at + line.side * pen.overshoot
            extensions.append(direction.segment((station.at, near), (station.at, far)))
        # Upright dimensions are read from the right.
        angle = 0.0 if direction is Direction.HORIZONTAL else -0.5 * math.pi
        middle = 0.5 * (text[0] + text[1]), line.at - pen.gap - 0.5 * pen.height
        written = label(line.text, direction.point(*middle), pen.height, angle)
        self._take(line, text)
        stroke = direction.segment((start, line.at), (end, line.at))
        return [
            Annotation(
                AnnotationKind.DIMENSION,
                0,
                (stroke,),
                pen.width,
                arrows=arrows,
                value_mm=float(line.text),
            ),
            *(
                Annotation(AnnotationKind.EXTENSION, 0, (extension,), pen.width)
                for extension in extensions
            ),
            Annotation(AnnotationKind.TEXT, 0, label=written),
        ]

    def _take(self, line: _Line, text: tuple[float, float]) -> None:
        pen, direction = self._pen, line.direction
        low, high = (end.at for end in line.ends)
        half = 0.2 * pen.arrow
        self._room.take(direction.box((low, high), (line.at - half, line.at + half)))
        top = line.at - pen.gap - pen.height
        self._room.take(direction.box(text, (top, line.at)))
        for box in self._extension_boxes(line):
            self._room.take(box)
