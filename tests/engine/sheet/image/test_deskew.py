"""Turns to a hundredth of a degree, and back."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet
from gaussiancad_core.sheet.image.deskew import LARGEST_SKEW, Turn, file_directions, find_turn

Sketch = Any
"""The class that the fixture gives."""

WIDTH, HEIGHT = 480, 360
MIDDLE = (WIDTH / 2.0, HEIGHT / 2.0)
SIGNS = (1, 1), (1, -1), (-1, -1), (-1, 1)
POINT = st.tuples(st.floats(-100, 6000), st.floats(-100, 6000))


def _part(sketch: Sketch, degrees: float) -> Any:  # noqa: ANN401
    """A box with a slanted edge, a dashed line and a hole, turned about the sheet's middle."""
    turn = Turn(np.radians(degrees), MIDDLE)

    def at(*places: tuple[float, float]) -> list[tuple[float, float]]:
        # In px whose centres are at .5, in which turns are given, and back to the sketch's.
        return [tuple(item) for item in (turn.to_stored(np.array(places)) - 0.5).tolist()]

    drawn = sketch(WIDTH, HEIGHT)
    drawn.lines(*at((90, 80), (300, 80), (380, 160), (380, 280), (90, 280), (90, 80)))
    drawn.broken(*at((90, 200), (380, 200)), (12, 6), 2.0)
    return drawn.arc(*at((190, 140)), 35.0)


@pytest.mark.parametrize("degrees", [-8.0, -5.3, -0.4, 0.15, 1.0, 6.2])
def test_a_turned_sheet_is_set_upright(sketch: Sketch, degrees: float) -> None:
    """Its lines are as dark as before; slanted ones are outvoted."""
    drawn = _part(sketch, degrees)
    sheet = upright_sheet(clean_sheet(drawn.grey))
    assert np.degrees(sheet.turn.angle) == pytest.approx(degrees, abs=0.01)
    assert sheet.turn.centre == MIDDLE
    true = _part(sketch, 0.0).weight
    assert np.abs(sheet.weight - true).mean() < 0.004
    assert sheet.weight.sum() == pytest.approx(true.sum(), rel=0.01)


@pytest.mark.parametrize("degrees", [0.0, 0.02, -0.03])
def test_upright_sheets_are_not_touched(sketch: Sketch, degrees: float) -> None:
    sheet = clean_sheet(_part(sketch, degrees).grey)
    found = upright_sheet(sheet)
    assert found.turn.angle == 0.0
    assert found.weight is sheet.weight
    assert found.dash_gap == pytest.approx(6.0, abs=1.1)


@pytest.mark.parametrize("degrees", [12.0, 25.0, 45.0, -11.0])
def test_sheets_on_their_side_stay(sketch: Sketch, degrees: float) -> None:
    """Such a sheet shows a part with slanted edges only: nothing says how it lies."""
    way = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    across = np.array([-way[1], way[0]])
    corners = [np.array(MIDDLE) + 90.0 * (a * way + b * across) for a, b in SIGNS]
    sheet = clean_sheet(sketch(WIDTH, HEIGHT).lines(*map(tuple, [*corners, corners[0]])).grey)
    assert upright_sheet(sheet) is sheet


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


@given(
    st.floats(-LARGEST_SKEW, LARGEST_SKEW),
    st.tuples(st.floats(0, 5000), st.floats(0, 5000)),
    st.lists(POINT, min_size=1, max_size=6),
)
def test_there_and_back(
    angle: float, centre: tuple[float, float], points: list[tuple[float, float]]
) -> None:
    turn, here = Turn(angle, centre), np.array(points)
    assert turn.to_upright(turn.to_stored(here)) == pytest.approx(here, abs=1e-8)
    away = np.hypot(*(here - centre).T)
    assert np.hypot(*(turn.to_stored(here) - centre).T) == pytest.approx(away, abs=1e-8)
    low, high = here.min(0), here.max(0)
    box = (*low.tolist(), *high.tolist())
    for there, moved in (
        (turn.box_to_stored(box), turn.to_stored(here)),
        (turn.box_to_upright(box), turn.to_upright(here)),
    ):
        assert (moved >= np.array(there[:2]) - 1e-6).all()
        assert (moved <= np.array(there[2:]) + 1e-6).all()


def test_turns_are_clockwise_to_the_eye_and_none_keeps_boxes() -> None:
    turn = Turn(np.radians(90.0), (10.0, 10.0))
    assert turn.to_stored(np.array([[15.0, 10.0]])) == pytest.approx(np.array([[10.0, 15.0]]))
    box = (1.0, 2.0, 3.0, 4.0)
    assert Turn(0.0, (9.0, 9.0)).box_to_stored(box) is box
    assert Turn(0.0, (9.0, 9.0)).box_to_upright(box) is box
