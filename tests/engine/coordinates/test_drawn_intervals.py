"""What is drawn on a line, and gaps that other lines cover."""

from math import pi

import pytest

from gaussiancad_core.coordinates.drawn_intervals import (
    Carrier,
    DrawnInterval,
    carriers_with_intervals,
)
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle, axis_line, line_through
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

_FRONT, _HIDDEN = Role.FRONT, Linetype.HIDDEN
_TOLERANCE = 0.2


def _supports(
    curves: list[LineOrCircle], drawn: list[tuple[int, float, float, Role]]
) -> tuple[Carrier, ...]:
    strokes = [
        (index, DrawnInterval(role, (low, high), _HIDDEN, 1.0)) for index, low, high, role in drawn
    ]
    return carriers_with_intervals(curves, strokes, [], _TOLERANCE)


_STEEP = line_through((45.0, 0.0), (55.0, 100.0))
"""Crosses x = 50 at half its height, within 1.2 units of it for 24."""


@pytest.mark.parametrize(("role", "closed"), [(_FRONT, True), (Role.TOP, False)])
def test_a_gap_along_another_line_of_the_view_is_closed(role: Role, closed: bool) -> None:
    low, middle, high = (_STEEP.parameter((45.0 + 0.1 * z, z)) for z in (5.0, 50.0, 95.0))
    drawn = [(0, low, middle - 9.0, _FRONT), (0, middle + 9.0, high, _FRONT)]
    steep, _ = _supports([_STEEP, axis_line(0, 50.0)], [*drawn, (1, 0.0, 100.0, role)])
    assert len(steep.drawn()) == (1 if closed else 2)
    assert steep.linetype_at(_FRONT, middle) is (_HIDDEN if closed else None)


def test_a_gap_that_leads_away_from_the_other_line_stays() -> None:
    low, middle, high = (_STEEP.parameter((45.0 + 0.1 * z, z)) for z in (5.0, 50.0, 95.0))
    drawn = [(0, low, middle - 25.0, _FRONT), (0, middle + 25.0, high, _FRONT)]
    steep, _ = _supports([_STEEP, axis_line(0, 50.0)], [*drawn, (1, 0.0, 100.0, _FRONT)])
    assert len(steep.drawn()) == 2


def test_strokes_end_where_lines_meet() -> None:
    curves: list[LineOrCircle] = [axis_line(0, 50.0), axis_line(1, 20.0), axis_line(1, 70.0)]
    line, *_ = _supports(curves, [(0, 20.3, 69.5, _FRONT)])
    assert line.drawn() == [(pytest.approx(20.0), pytest.approx(70.0))]


@pytest.mark.parametrize(("off", "met"), [(4.0, True), (-4.0, True), (60.0, False)])
def test_a_wide_arc_and_its_tangent_end_where_they_touch(off: float, met: bool) -> None:
    """They part so slowly that neither's end is seen; far beyond, they are clearly apart."""
    arc = Circle((-900.0, 50.0), 1000.0)
    curves: list[LineOrCircle] = [arc, axis_line(0, 100.0)]
    drawn = [(0, -0.2, off / 1000.0, _FRONT), (1, 50.0 + off, 300.0, _FRONT)]
    wide, line = _supports(curves, drawn)
    ends = [end for interval in wide.drawn() for end in interval]
    assert any(end % FULL_TURN == pytest.approx(0.0 if met else off / 1000.0) for end in ends)
    assert line.drawn()[0][0] == pytest.approx(50.0 if met else 50.0 + off)


def test_an_arc_does_not_go_on_to_a_tangent_that_nothing_is_drawn_on() -> None:
    """Where another coordinate lies just at its extreme, its end is its end."""
    arc = Circle((0.0, 50.0), 15.6)
    ends = (-0.073, 2.0)
    drawn = [(0, DrawnInterval(_FRONT, ends, _HIDDEN, 1.0))]
    (item,) = carriers_with_intervals([arc], drawn, [axis_line(0, 15.6)], _TOLERANCE)
    assert sum(high - low for low, high in item.drawn()) == pytest.approx(2.073)


def test_arcs_end_where_they_touch_though_another_view_has_a_value_beside_it() -> None:
    """The value is nearer to one of the ends as read: they would end apart."""
    small, large = Circle((30.0, 20.0), 4.0), Circle((20.0, 20.0), 6.0)
    strokes = [
        (0, DrawnInterval(_FRONT, (pi / 2.0, pi + 0.0001), _HIDDEN, 1.0)),
        (1, DrawnInterval(_FRONT, (0.0005, pi / 2.0), _HIDDEN, 1.0)),
    ]
    one, other = carriers_with_intervals([small, large], strokes, [axis_line(1, 20.0035)], 0.006)
    assert one.drawn() == [(pytest.approx(pi / 2.0), pytest.approx(pi, abs=1e-9))]
    assert other.drawn() == [(pytest.approx(0.0, abs=1e-9), pytest.approx(pi / 2.0))]


def test_an_arc_that_nothing_ends_at_ends_at_a_value_of_another_view() -> None:
    arc = Circle((20.0, 20.0), 6.0)
    strokes = [(0, DrawnInterval(_FRONT, (0.0005, pi / 2.0), _HIDDEN, 1.0))]
    (one,) = carriers_with_intervals([arc], strokes, [axis_line(1, 20.0035)], 0.006)
    assert arc.at(one.drawn()[0][0])[1] == pytest.approx(20.0035)


@pytest.mark.parametrize(("gap", "pieces"), [(0.0004, 1), (0.02, 2)])
@pytest.mark.parametrize("other", list(Linetype))
def test_pieces_of_an_arc_that_nearly_touch_are_one(
    gap: float, pieces: int, other: Linetype
) -> None:
    """Nothing else ends where they do: through the crack the outside would flow into the part."""
    arc = Circle((40.0, 60.0), 40.0)
    strokes = [
        (0, DrawnInterval(_FRONT, (0.3, 1.0), Linetype.VISIBLE, 1.0)),
        (0, DrawnInterval(_FRONT, (1.0 + gap / 40.0, 1.7), other, 1.0)),
    ]
    (item,) = carriers_with_intervals([arc], strokes, [], 0.006)
    assert len(item.drawn()) == pieces
    assert item.linetype_at(_FRONT, 1.5) is other
