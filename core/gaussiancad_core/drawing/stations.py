"""What of a view can be dimensioned: its borders, its edges, its circles."""

from dataclasses import dataclass

from gaussiancad_core.drawing.annotation_pen import Direction
from gaussiancad_core.drawing.centre_lines import rounds
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Linetype, Segment

_ON = 0.05
"""px within which strokes are at the same station."""

_BORDER = 0.5
"""px within which points of a stroke are at the part's border: curves touch it in one point."""


@dataclass(frozen=True)
class DimensionableFeature:
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


def border_station(view: DrawnView, direction: Direction, at: float) -> DimensionableFeature:
    """The part's outermost point in a direction."""
    across = [
        float(point[direction.other.value])
        for stroke in view.strokes
        for point in stroke.sample(1.0)
        if abs(point[direction.value] - at) < _BORDER
    ]
    return DimensionableFeature(at, min(across), max(across), 0.0)


def stations(
    view: DrawnView, direction: Direction, centre_lines: tuple[DrawnStroke, ...]
) -> list[DimensionableFeature]:
    """Visible edges across a direction, and the centres of visible circles.

    Args:
        view: not turned.
        direction: along which they are measured.
        centre_lines: of all views; extension lines continue them.
    """
    along, across = direction.value, direction.other.value
    found: dict[float, DimensionableFeature] = {}

    def add(station: DimensionableFeature) -> None:
        key = round(station.at, 1)
        old = found.get(key)
        if old is not None:
            station = DimensionableFeature(
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
                add(DimensionableFeature(stroke.start[along], low, high, high - low))
    for circle in rounds(view):
        if not circle.visible:
            continue
        at, centre = circle.centre[along], circle.centre[across]
        low, high = _marked(direction, at, centre_lines, (centre, circle.radius))
        add(DimensionableFeature(at, low, high, 2.0 * circle.radius, True))
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
        if not isinstance(stroke, Segment):
            continue
        on = all(abs(point[direction.value] - at) < _ON for point in (stroke.start, stroke.end))
        first, last = sorted((stroke.start[across], stroke.end[across]))
        if on and first <= circle[0] <= last:
            low, high = min(low, first), max(high, last)
    return low, high
