"""Turns to a hundredth of a degree, and back."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.image.deskew import (
    LARGEST_SKEW,
    Turn,
    file_directions,
    find_turn,
    grown_lines,
)
from gaussiancad_core.sheet.tracing.ridges import ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import Grown, grow_shapes

Sketch = Any
"""The class that the fixture gives."""

WIDTH, HEIGHT = 480, 360
MIDDLE = (WIDTH / 2.0, HEIGHT / 2.0)


def _line(degrees: float, length: int = 200) -> Grown:
    way = (float(np.cos(np.radians(degrees))), float(np.sin(np.radians(degrees))))
    return Grown(Line((50.0, 60.0), way), np.arange(length))


def _found(*lines: Grown) -> float:
    """Degrees by which lines on a sheet of 2000 x 1000 px are turned."""
    return float(np.degrees(find_turn(*grown_lines(lines), (1000, 2000)).angle))


def _part(sketch: Sketch, degrees: float) -> Sketch:
    """A box with a slanted edge, a dashed line and a hole, turned about the sheet's middle."""
    # In px whose centres are at .5, in which turns are given, and back to the sketch's.
    turn = Turn(np.radians(degrees), MIDDLE)

    def at(x: float, y: float) -> tuple[float, float]:
        (x, y) = turn.to_stored(np.array([[x, y]]))[0] - 0.5
        return float(x), float(y)

    drawn = sketch(WIDTH, HEIGHT)
    corners = ((90, 80), (300, 80), (380, 160), (380, 280), (90, 280), (90, 80))
    drawn.lines(*(at(*corner) for corner in corners))
    drawn.broken(at(90, 200), at(380, 200), (12, 6), 2.0)
    return drawn.arc(at(190, 140), 35.0)


def _turn_of(drawn: Sketch) -> Turn:
    shapes = grow_shapes(ridge_points(drawn.weight, 3.0))
    return find_turn(*grown_lines(shapes), drawn.weight.shape)


@pytest.mark.parametrize("degrees", [-8.0, -5.3, -2.0, -0.4, 0.15, 0.7, 1.0, 3.0, 6.2, 8.0])
def test_the_turn_of_a_drawing(sketch: Sketch, degrees: float) -> None:
    turn = _turn_of(_part(sketch, degrees))
    assert np.degrees(turn.angle) == pytest.approx(degrees, abs=0.01)
    assert turn.centre == MIDDLE


@pytest.mark.parametrize("degrees", [-3.0, 0.0, 1.5])
def test_the_strokes_of_a_file_tell_its_turn(degrees: float) -> None:
    turn = Turn(np.radians(degrees), MIDDLE)
    box = np.array([(60.0, 50.0), (420.0, 50.0), (420.0, 310.0), (60.0, 310.0), (60.0, 50.0)])
    corners = [tuple(item) for item in turn.to_stored(box).tolist()]
    lines = [LineSegment(*ends) for ends in pairwise(corners)]
    lines.append(LineSegment((0.0, 0.0), (300.0, 120.0)))
    drawing = VectorDrawing(tuple(VectorStroke(line, None) for line in lines), ())
    found = find_turn(*file_directions(drawing), (HEIGHT, WIDTH))
    assert np.degrees(found.angle) == pytest.approx(degrees, abs=1e-6)


@pytest.mark.parametrize("degrees", [0.0, 0.02, -0.03])
def test_upright_sheets_are_not_touched(sketch: Sketch, degrees: float) -> None:
    drawn = _part(sketch, degrees)
    turn = _turn_of(drawn)
    assert turn.angle == 0.0
    assert turn.upright(drawn.weight) is drawn.weight


@pytest.mark.parametrize("degrees", [-6.0, 1.3, 4.0])
def test_a_sheet_turned_back_is_the_upright_one(sketch: Sketch, degrees: float) -> None:
    """Its lines are level, where they were drawn, and as dark as before."""
    turn = _turn_of(_part(sketch, degrees))
    upright = turn.upright(_part(sketch, degrees).weight)
    true = _part(sketch, 0.0).weight
    assert upright.shape == true.shape
    assert (upright.min(), upright.max()) == (0.0, 1.0)
    assert np.abs(upright - true).mean() < 0.004
    assert upright.sum() == pytest.approx(true.sum(), rel=0.005)
    lines = [g.geometry for g in grow_shapes(ridge_points(upright, 3.0)) if len(g.members) > 100]
    # Centres of pixels are at integers for shapes.
    for ends in (((90, 80), (300, 80)), ((380, 160), (380, 280)), ((90, 200), (380, 200))):
        points = np.array(ends) - 0.5
        items = [line.distances(points).max() for line in lines if isinstance(line, Line)]
        assert min(items) < 0.1


@given(
    st.floats(-LARGEST_SKEW, LARGEST_SKEW),
    st.tuples(st.floats(0, 5000), st.floats(0, 5000)),
    st.lists(st.tuples(st.floats(-100, 6000), st.floats(-100, 6000)), min_size=1, max_size=6),
)
def test_there_and_back(
    angle: float, centre: tuple[float, float], points: list[tuple[float, float]]
) -> None:
    turn = Turn(angle, centre)
    here = np.array(points)
    assert turn.to_upright(turn.to_stored(here)) == pytest.approx(here, abs=1e-8)
    assert turn.to_stored(turn.to_upright(here)) == pytest.approx(here, abs=1e-8)
    away = np.hypot(*(here - centre).T)
    assert np.hypot(*(turn.to_stored(here) - centre).T) == pytest.approx(away, abs=1e-8)
    assert turn.to_stored(np.array([centre])) == pytest.approx(np.array([centre]))


def test_turns_are_clockwise_to_the_eye() -> None:
    turn = Turn(np.radians(90.0), (10.0, 10.0))
    assert turn.to_stored(np.array([[15.0, 10.0]])) == pytest.approx(np.array([[10.0, 15.0]]))


@given(
    st.floats(-LARGEST_SKEW, LARGEST_SKEW),
    st.tuples(st.floats(0, 900), st.floats(0, 900), st.floats(1, 900), st.floats(1, 900)),
    st.sampled_from([1.0, 2.5]),
)
def test_boxes_hold_what_was_in_them(
    angle: float, place: tuple[float, float, float, float], scale: float
) -> None:
    x, y, width, height = place
    box = (x, y, x + width, y + height)
    turn = Turn(angle, (500.0, 400.0), scale)
    inside = np.array([(x + a * width, y + b * height) for a in (0, 0.3, 1) for b in (0, 0.6, 1)])
    for there, moved in (
        (turn.box_to_stored(box), turn.to_stored(inside)),
        (turn.box_to_upright(box), turn.to_upright(inside)),
    ):
        low, high = np.array(there[:2]), np.array(there[2:])
        assert (moved >= low - 1e-9).all()
        assert (moved <= high + 1e-9).all()
        # No larger than what the corners need.
        assert moved.min(0) == pytest.approx(low)
        assert moved.max(0) == pytest.approx(high)
    assert turn.to_upright(turn.to_stored(inside)) == pytest.approx(inside)


def test_no_turn_keeps_boxes() -> None:
    box = (1.0, 2.0, 3.0, 4.0)
    assert Turn(0.0, (9.0, 9.0)).box_to_stored(box) is box
    assert Turn(0.0, (9.0, 9.0)).box_to_upright(box) is box


def test_level_and_upright_lines_say_the_same() -> None:
    assert _found(_line(2.0), _line(92.0), _line(-178.0), _line(-88.0)) == pytest.approx(2.0)


def test_slanted_lines_are_outvoted() -> None:
    slanted = [_line(30.0, 300), _line(41.0, 150), _line(-25.0, 250), _line(6.0, 100)]
    assert _found(*slanted, _line(1.5, 300), _line(91.5, 200)) == pytest.approx(1.5)


def test_long_lines_count_most() -> None:
    """Each line's error is as large as its length lets it be."""
    lines = [_line(1.0, 1000), _line(1.08, 60), _line(0.93, 60), _line(91.07, 50)]
    assert _found(*lines) == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize("degrees", [12.0, 25.0, 45.0, -11.0])
def test_sheets_on_their_side_stay(degrees: float) -> None:
    """Such a sheet shows a part with slanted edges only: nothing says how it lies."""
    assert _found(_line(degrees), _line(degrees + 90.0)) == 0.0


def test_nothing_to_go_by() -> None:
    circle = Grown(Circle((50.0, 50.0), 30.0), np.arange(200))
    assert _found() == 0.0
    assert _found(circle) == 0.0
    assert _found(_line(3.0, 20)) == 0.0
    assert _found(circle, _line(3.0)) == pytest.approx(3.0)
