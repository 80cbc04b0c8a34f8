"""Arcs between two strokes that they touch are fillets, however flat; others may be any curve."""

from math import atan2, cos, pi, sin, sqrt

import pytest

from gaussiancad_core.coordinates.roundings import is_rounding
from gaussiancad_core.model.views import Arc, Linetype, Segment

V = Linetype.VISIBLE
TOLERANCE = 0.2


def _between_line_and_circle() -> tuple[Arc, Arc, Segment]:
    """A fillet of 2 between the line y = 0 and a circle of 50 that bulges up from below."""
    large, small = Arc((0.0, -20.0), 50.0, 0.3, pi - 0.6, V), 2.0
    x = sqrt((large.radius + small) ** 2 - (small + 20.0) ** 2)
    start = pi + atan2(small + 20.0, x)
    fillet = Arc((x, small), small, start, 1.5 * pi - start, V)
    return fillet, large, Segment((x, 0.0), (x + 30.0, 0.0), V)


def test_a_fillet_between_a_line_and_an_arc() -> None:
    fillet, large, line = _between_line_and_circle()
    assert is_rounding(fillet, [fillet, large, line], TOLERANCE)
    assert not is_rounding(fillet, [fillet, large], TOLERANCE)
    assert not is_rounding(fillet, [fillet, line], TOLERANCE)


@pytest.mark.parametrize(("sweep", "is_given"), [(80.0, True), (70.0, True), (40.0, False)])
def test_a_fillet_between_two_lines(sweep: float, is_given: bool) -> None:
    turn = sweep * pi / 180.0
    fillet = Arc((0.0, 2.0), 2.0, -pi / 2.0, turn, V)
    end = 2.0 * sin(turn), 2.0 - 2.0 * cos(turn)
    along = end[0] + 9.0 * cos(turn), end[1] + 9.0 * sin(turn)
    # The first line runs past.
    lines = [Segment((-10.0, 0.0), (10.0, 0.0), V), Segment(end, along, V)]
    assert is_rounding(fillet, [fillet, *lines], TOLERANCE) is is_given
    assert not is_rounding(fillet, [fillet, *lines], 0.6)


def test_an_arc_that_meets_its_neighbours_at_an_angle_is_none() -> None:
    arc = Arc((0.0, 2.0), 2.0, -pi / 2.0, 1.3, V)
    end = 2.0 * sin(1.3), 2.0 - 2.0 * cos(1.3)
    lines = [Segment((-10.0, 0.0), (0.0, 0.0), V), Segment(end, (end[0], end[1] + 9.0), V)]
    assert not is_rounding(arc, [arc, *lines], TOLERANCE)


@pytest.mark.parametrize(
    ("sweep", "radius", "is_given"),
    [(37.0, 8.0, True), (52.0, 6.0, True), (37.0, 4.0, False), (20.0, 40.0, False)],
)
def test_a_flat_fillet_between_two_lines_tells_its_circle_where_it_rises_enough(
    sweep: float, radius: float, is_given: bool
) -> None:
    turn = sweep * pi / 180.0
    fillet = Arc((0.0, radius), radius, -pi / 2.0, turn, V)
    end = radius * sin(turn), radius - radius * cos(turn)
    along = end[0] + 9.0 * cos(turn), end[1] + 9.0 * sin(turn)
    lines = [Segment((-10.0, 0.0), (0.0, 0.0), V), Segment(end, along, V)]
    assert is_rounding(fillet, [fillet, *lines], TOLERANCE) is is_given
    # Arcs that follow a free curve go on in each other.
    next_arc = Arc((0.0, 3.0 * radius), 3.0 * radius, -pi / 2.0 - 0.5, 0.5, V)
    assert not is_rounding(fillet, [fillet, next_arc, lines[1]], TOLERANCE)
