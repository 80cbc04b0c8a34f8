"""Small pockets are no dashed circles, and dashed circles stay beside lines that touch them."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run
from gaussiancad_core.sheet.strokes import classify_strokes
from gaussiancad_core.sheet.tangent_runs import without_tangents
from gaussiancad_core.sheet.view_shapes import find_shapes, view_rhythm
from gaussiancad_core.views import Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

CIRCLE = Circle((100.0, 100.0), 12.0)
TOP = Line((100.0, 88.0), (1.0, 0.0))


@pytest.mark.parametrize("height", [18.0, 22.0, 26.0])
def test_pockets_are_four_edges(sketch: Sketch, height: float) -> None:
    drawn = sketch(400, 200).lines((20, 20), (380, 20), (380, 180), (20, 180), (20, 20), width=2.0)
    lefts, top = (60.0, 110.0, 200.0, 320.0), 60.0
    for x in lefts:
        corners = (x, top), (x + 15, top), (x + 15, top + height), (x, top + height), (x, top)
        drawn.lines(*corners, width=2.0)
    view = find_shapes(clean_sheet(drawn.grey), (0.0, 0.0, 400.0, 200.0))
    strokes = classify_strokes(view, view_rhythm([view], view.sheet.stroke_width))
    assert len(strokes) == 4 + 4 * len(lefts)
    assert all(isinstance(stroke, Segment) for stroke in strokes)
    assert {stroke.linetype for stroke in strokes} == {Linetype.VISIBLE}


def test_a_run_along_a_longer_line_is_the_lines() -> None:
    quarter = 0.5 * np.pi * CIRCLE.radius
    runs = [Run(k * quarter - 3.0, k * quarter + 3.0) for k in range(1, 5)]
    left = without_tangents(CIRCLE, runs, [(TOP, [Run(-8.0, 9.0)])])
    # y points down: the line touches the circle at three quarters of the way around.
    assert left == [runs[0], runs[1], runs[3]]


@pytest.mark.parametrize(
    ("line", "run"),
    [
        # The line that follows the dash itself.
        (TOP, Run(-4.0, 4.0)),
        # One that ends within it.
        (TOP, Run(-30.0, 1.0)),
        # One that passes beside it.
        (Line((100.0, 86.0), (1.0, 0.0)), Run(-20.0, 20.0)),
        # One that crosses it.
        (Line((100.0, 88.0), (0.6, 0.8)), Run(-20.0, 20.0)),
    ],
)
def test_others_leave_the_run_to_the_curve(line: Line, run: Run) -> None:
    dash = Run(1.5 * np.pi * CIRCLE.radius - 3.0, 1.5 * np.pi * CIRCLE.radius + 3.0)
    assert without_tangents(CIRCLE, [dash], [(line, [run])]) == [dash]
