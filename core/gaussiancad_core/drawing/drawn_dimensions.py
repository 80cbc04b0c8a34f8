"""Linear dimensions (ISO 129-1): extents, steps and the places of circles.

Dimensions stand in rows beside a view, the shorter ones nearer to it, all from the view's left or
lower border.  What one view says, no other says again.
"""

from dataclasses import dataclass, replace
from itertools import product

from gaussiancad_core.drawing.annotation import Annotation, Box
from gaussiancad_core.drawing.annotation_pen import Board, Direction
from gaussiancad_core.drawing.centre_lines import Round, model_axis, rounds, to_model
from gaussiancad_core.drawing.dimension_line import DimensionLine
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.stations import DimensionableFeature, border_station, stations
from gaussiancad_core.model.axes import Axis

_INNER = 2
"""Most dimensions a direction of a view has beside the whole extent."""

_ROWS = 4
"""Most rows of dimensions on one side of a view."""

_KNOWN = 1.0
"""px within which a place has been said already."""


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
        wanted = _by_distance(_inner(view, direction, places, board), first)
        if axis not in whole:
            wanted.append(border_station(view, direction, last))
        neighbour = _Beside(view, direction, board)
        for station in wanted:
            text = value_text(abs(station.at - datum.at) * board.mm_per_pixel)
            placed = neighbour.place(datum, station, text)
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


def _by_distance(wanted: list[DimensionableFeature], first: float) -> list[DimensionableFeature]:
    """Stations, those nearest to a place first."""
    return sorted(wanted, key=lambda station: abs(station.at - first))


def _inner(
    view: DrawnView, direction: Direction, places: _Places, board: Board
) -> list[DimensionableFeature]:
    """The weightiest stations between a view's borders that nothing has said yet.

    Places of holes come first: a machinist looks for them first.
    """
    low, high = direction.span(view.box)
    chosen: list[DimensionableFeature] = []
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
        for side, adjacent in ((1, first >= high), (-1, last <= low)):
            if adjacent:
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

    def place(
        self, datum: DimensionableFeature, station: DimensionableFeature, text: str
    ) -> list[Annotation]:
        """A dimension in the first row that is free; nothing if there is none."""
        low, high = self._direction.other.span(self._view.box)
        first, second = sorted((datum, station), key=lambda item: item.at)
        inside = {1: high - station.high, -1: station.low - low}
        for side in sorted(self._rows, key=lambda side: inside[side] + self._costs[side]):
            for row in range(self._rows[side], _ROWS):
                away = self._pen.first + row * self._pen.pitch
                at = high + away if side > 0 else low - away
                ends = (first, second)
                line = DimensionLine(self._direction, side, at, ends, text, self._pen)
                if self._fits(line):
                    self._rows[side] = row + 1
                    for box in (*line.solid_boxes, *self._extension_boxes(line)):
                        self._room.take(box)
                    return line.draw()
        return []

    def _fits(self, line: DimensionLine) -> bool:
        if not self._room.free(line.footprint, 0.25 * self._pen.height):
            return False
        return not any(self._room.touched(box) for box in self._extension_boxes(line))

    def _extension_boxes(self, line: DimensionLine) -> list[Box]:
        """The extension lines outside of the view."""
        border = self._direction.other.span(self._view.box)[1 if line.side > 0 else 0]
        start = border + line.side * 0.5 * self._pen.gap
        low, high = sorted((start, line.at))
        return [line.direction.box((end.at, end.at), (low, high)) for end in line.ends]
