"""Through which angles profiles turn."""

from math import pi

import pytest

from gaussiancad_core.cells.sectors import sector_of
from gaussiancad_core.coordinates.drawn_intervals import Carrier, Interval
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, line_through
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

_ARC = Circle((20.0, 20.0), 10.0)


def _drawn(curve: LineOrCircle, low: float, high: float) -> Carrier:
    return Carrier(curve, {Role.TOP: (Interval(low, high, Linetype.VISIBLE, 1.0),)})


def _line(start: tuple[float, float], end: tuple[float, float]) -> Carrier:
    curve = line_through(start, end)
    return _drawn(curve, *sorted(curve.parameter(point) for point in (start, end)))


_RIM = _drawn(_ARC, 0.0, pi / 2.0)
_UPRIGHT, _LEVEL = _line((30.0, 20.0), (30.0, 0.0)), _line((0.0, 30.0), (20.0, 30.0))


def test_a_rounded_corner_turns_from_one_side_to_the_other() -> None:
    corner = [_RIM, _UPRIGHT, _LEVEL]
    assert sector_of(_ARC, (0.0, pi / 2.0), corner, 0.02) == (0.0, pi / 2.0)


def test_a_rim_that_is_cut_at_both_ends_is_one_of_a_whole_turn() -> None:
    # Both sides are drawn, but neither goes on from the arc.
    flats = [_line((30.0, 20.0), (0.0, 20.0)), _line((20.0, 30.0), (20.0, 0.0))]
    assert sector_of(_ARC, (0.0, pi / 2.0), [_RIM, *flats], 0.02) is None


@pytest.mark.parametrize(
    ("side", "sector"), [(_UPRIGHT, (0.0, pi)), (_LEVEL, (-pi / 2.0, pi))], ids=["begins", "ends"]
)
def test_a_rim_that_is_cut_at_one_end_goes_on_there(
    side: Carrier, sector: tuple[float, float]
) -> None:
    found = sector_of(_ARC, (0.0, pi / 2.0), [_RIM, side], 0.02)
    assert found == pytest.approx(sector)


def test_a_tangent_that_is_drawn_elsewhere_is_no_side() -> None:
    beyond = [_line((30.0, 15.0), (30.0, 0.0)), _line((0.0, 30.0), (15.0, 30.0))]
    assert sector_of(_ARC, (0.0, pi / 2.0), [_RIM, *beyond], 0.02) is None


def test_an_arc_that_goes_on_in_another_one_ends_where_that_begins() -> None:
    small = Circle((27.0, 20.0), 3.0)
    waist = [_RIM, _drawn(small, 1.5 * pi, FULL_TURN), _LEVEL]
    assert sector_of(_ARC, (0.0, pi / 2.0), waist, 0.02) == (0.0, pi / 2.0)


def test_more_than_half_a_turn_is_a_whole_one() -> None:
    sides = [_line((30.0, 20.0), (30.0, 40.0)), _line((20.0, 10.0), (40.0, 10.0))]
    assert sector_of(_ARC, (0.0, 1.5 * pi), [_drawn(_ARC, 0.0, 1.5 * pi), *sides], 0.02) is None
