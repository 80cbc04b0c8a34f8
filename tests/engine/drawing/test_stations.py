import numpy as np
import pytest

from gaussiancad_core.drawing.annotation_pen import Direction
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.stations import border_station, stations
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

VISIBLE, HIDDEN = Linetype.VISIBLE, Linetype.HIDDEN
VIEW = DrawnView(
    Role.FRONT,
    (0.0, 0.0, 100.0, 60.0),
    (
        Segment((0.0, 0.0), (0.0, 60.0), VISIBLE),
        Segment((0.0, 60.0), (100.0, 60.0), VISIBLE),
        Segment((30.0, 0.0), (30.0, 20.0), VISIBLE),
        Segment((30.0, 40.0), (30.0, 60.0), VISIBLE),
        Segment((70.0, 10.0), (70.0, 50.0), HIDDEN),
        Segment((40.0, 10.0), (48.0, 50.0), VISIBLE),
        Arc((80.0, 30.0), 10.0, 0.0, 2.0 * np.pi, VISIBLE),
        Arc((55.0, 25.0), 10.0, 0.0, 2.0 * np.pi, HIDDEN),
        Arc((100.0, 45.0), 15.0, np.pi / 2.0, np.pi / 2.0, VISIBLE),
    ),
    (),
)


def test_edges_across_and_centres_are_stations() -> None:
    found = {station.at: station for station in stations(VIEW, Direction.HORIZONTAL, ())}
    assert set(found) == {0.0, 30.0, 80.0}
    assert (found[30.0].low, found[30.0].high, found[30.0].weight) == (0.0, 60.0, 40.0)
    assert (found[80.0].low, found[80.0].high, found[80.0].centre) == (20.0, 40.0, True)
    upright = {station.at: station for station in stations(VIEW, Direction.VERTICAL, ())}
    assert set(upright) == {60.0, 30.0}
    assert (upright[30.0].low, upright[30.0].high) == (70.0, 90.0)


def test_a_centre_reaches_as_far_as_its_centre_line() -> None:
    lines = (
        Segment((80.0, 5.0), (80.0, 55.0), VISIBLE),
        Segment((80.0, 70.0), (80.0, 90.0), VISIBLE),
        Segment((60.0, 30.0), (100.0, 30.0), VISIBLE),
    )
    found = {station.at: station for station in stations(VIEW, Direction.HORIZONTAL, lines)}
    # Not the one of another view in the same column.
    assert (found[80.0].low, found[80.0].high) == (5.0, 55.0)


def test_a_border_is_where_the_part_touches_it() -> None:
    left = border_station(VIEW, Direction.HORIZONTAL, 0.0)
    assert (left.low, left.high) == (0.0, 60.0)
    # An arc touches its tangent in one point; half a pixel away it is still there.
    view = DrawnView(Role.TOP, (0, 0, 80, 80), (Arc((40, 40), 40, 0.0, 6.3, VISIBLE),), ())
    right = border_station(view, Direction.HORIZONTAL, 80.0)
    assert (right.low + right.high) / 2.0 == pytest.approx(40.0, abs=1.0)
    assert right.high - right.low < 14.0
