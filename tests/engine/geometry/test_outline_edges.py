"""Edges of outlines: their middles, sweeps, headings, and the area within them."""

from math import cos, hypot, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.outline_edges import OutlineEdge, enclosed_area, whole_circle
from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.geometry.whole_curves import Circle

_COORDINATE = st.floats(-100.0, 100.0)
_CIRCLE = st.builds(Circle, st.tuples(_COORDINATE, _COORDINATE), st.floats(0.5, 50.0))


@given(_CIRCLE, st.floats(0.0, FULL_TURN), st.floats(0.1, FULL_TURN - 0.1), st.booleans())
def test_an_arc_runs_over_its_middle(
    circle: Circle, first: float, sweep: float, is_ccw: bool
) -> None:
    way = 1.0 if is_ccw else -1.0
    last = first + way * sweep
    arc = OutlineEdge(circle.at(first), circle.at(last), circle, is_ccw)
    assert arc.sweep == pytest.approx(sweep)
    assert arc.middle == pytest.approx(circle.at(first + way * sweep / 2.0), abs=1e-9)
    for at_start, angle in ((True, first), (False, last)):
        along = -way * sin(angle), way * cos(angle)
        assert arc.heading(at_start) == pytest.approx(along, abs=1e-9)
    # What the arc and its chord enclose.
    chord = OutlineEdge(arc.end, arc.start)
    segment = circle.radius**2 * (sweep - sin(sweep)) / 2.0
    assert enclosed_area([arc, chord]) == pytest.approx(way * segment, rel=1e-6, abs=1e-6)


@given(_CIRCLE, st.booleans())
def test_a_whole_circle_has_its_area(circle: Circle, is_ccw: bool) -> None:
    edge = whole_circle(circle, is_ccw)
    assert edge.is_circle and edge.sweep == FULL_TURN
    area = (1.0 if is_ccw else -1.0) * pi * circle.radius**2
    assert enclosed_area([edge]) == pytest.approx(area)


def test_a_straight_edge_turns_nowhere() -> None:
    edge = OutlineEdge((1.0, 2.0), (5.0, 5.0))
    assert (edge.sweep, edge.middle, edge.is_circle) == (0.0, (3.0, 3.5), False)
    assert edge.heading(True) == edge.heading(False) == pytest.approx((0.8, 0.6))
    assert hypot(*edge.heading(True)) == pytest.approx(1.0)
