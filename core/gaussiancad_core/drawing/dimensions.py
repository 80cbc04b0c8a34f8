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
from gaussiancad_core.drawing.strokes import DrawnStroke
from gaussiancad_core.views import Linetype, Segment

_INNER = 2
"""Most dimensions a direction of a view has beside the whole extent."""

_ROWS = 4
"""Most rows of dimensions on one side of a view."""

_ON = 0.05
"""px within which strokes are at the same station."""

_KNOWN = 1.0
"""px within which a place has been said already."""


@dataclass(frozen=True)
class Station:
    """Something that can be dimensioned, at a coordinate along a direction.

    Attributes:
        at: px along the direction.
        low, high: px across: the interval of what is there.
        weight: px: how much of it there is.
        centre: it is the centre of a circle.
    """

    at: float
    low: float
    high: float
    weight: float
    centre: bool = False


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
        datum = _border(view, direction, first)
        wanted = _inner(view, direction, places, board)
        wanted.sort(key=lambda station, first=first: abs(station.at - first))
        if axis not in whole:
            wanted.append(_border(view, direction, last))
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


def _border(view: DrawnView, direction: Direction, at: float) -> Station:
    """The part's outermost point in a direction."""
    across = [
        float(point[direction.other.value])
        for stroke in view.strokes
        for point in stroke.sample(1.0)
        if abs(point[direction.value] - at) < max(_ON, 0.5)
    ]
    return Station(at, min(across), max(across), 0.0)


def _inner(view: DrawnView, direction: Direction, places: _Places, board: Board) -> list[Station]:
    """The weightiest stations between a view's borders that nothing has said yet."""
    low, high = direction.span(view.box)
    chosen: list[Station] = []
    for station in sorted(_stations(view, direction, board), key=lambda item: -item.weight):
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


def _stations(view: DrawnView, direction: Direction, board: Board) -> list[Station]:
    """Visible edges across a direction, and the centres of circles."""
    along, across = direction.value, direction.other.value
    found: dict[float, Station] = {}

    def add(station: Station) -> None:
        key = round(station.at, 1)
        old = found.get(key)
        if old is not None:
            station = Station(
                old.at,
                min(old.low, station.low),
                max(old.high, station.high),
                old.weight + station.weight,
                old.centre or station.centre,
            )
        found[key] = station

    for stroke in view.strokes:
        if isinstance(stroke, Segment) and stroke.linetype is Linetype.VISIBLE:
            low, high = sorted((stroke.start[across], stroke.end[across]))
            if abs(stroke.start[along] - stroke.end[along]) < _ON:
                add(Station(stroke.start[along], low, high, high - low))
    for circle in rounds(view):
        at, centre = circle.centre[along], circle.centre[across]
        low, high = _marked(direction, at, board.centre_lines, (centre, circle.radius))
        # Places of holes are what a machinist looks for first.
        add(Station(at, low, high, 4.0 * circle.radius, True))
    return list(found.values())


def _marked(
    direction: Direction,
    at: float,
    centre_lines: tuple[DrawnStroke, ...],
    circle: tuple[float, float],
) -> tuple[float, float]:
    """Across a direction: from where to where a circle reaches with the centre line through it.

    Args:
        direction: along which the centre is measured.
        at: px of the centre along the direction.
        centre_lines: of all views.
        circle: px of the centre across the direction, and the radius.
    """
    across = direction.other.value
    low, high = circle[0] - circle[1], circle[0] + circle[1]
    for stroke in centre_lines:
        on = all(abs(point[direction.value] - at) < _ON for point in (stroke.start, stroke.end))
        first, last = sorted((stroke.start[across], stroke.end[across]))
        if on and first <= circle[0] <= last:
            low, high = min(low, first), max(high, last)
    return low, high


def _sides(view: DrawnView, direction: Direction, views: tuple[DrawnView, ...]) -> tuple[int, ...]:
    """The sides of a view for dimensions along a direction, those without a neighbour first."""
    low, high = direction.other.span(view.box)
    busy = set()
    for other in views:
        start, end = direction.span(other.box)
        if start < direction.span(view.box)[1] and direction.span(view.box)[0] < end:
            first, last = direction.other.span(other.box)
            busy |= {1} if first >= high else {-1} if last <= low else set()
    # Below and to the left, where nothing speaks for the other side.
    order = (1, -1) if direction is Direction.HORIZONTAL else (-1, 1)
    return tuple(sorted(order, key=lambda side: side in busy))


class _Beside:
    """The rows of dimensions on both sides of a view, filled from the inside out."""

    def __init__(self, view: DrawnView, direction: Direction, board: Board) -> None:
        self._view = view
        self._direction = direction
        self._rows = {side: 0 for side in _sides(view, direction, board.views)}
        self._pen = board.pen
        self._room = board.room

    def place(self, datum: Station, station: Station, text: str) -> list[Annotation]:
        """A dimension in the first row that is free; nothing if there is none."""
        low, high = self._direction.other.span(self._view.box)
        first, second = sorted((datum, station), key=lambda item: item.at)
        for side, used in self._rows.items():
            for row in range(used, _ROWS):
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
