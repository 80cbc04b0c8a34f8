"""Small pockets are no dashed circles, and dashed circles stay beside lines that touch them."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Run
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.tangent_runs import without_tangent_ends, without_tangents
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

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


def test_a_dash_ends_for_the_curve_where_it_goes_on_as_a_line() -> None:
    # A slot's side touches the circle at its rightmost place, where positions begin.
    side = Line((112.0, 100.0), (0.0, 1.0))
    dash = Run(CIRCLE.around - 6.0, CIRCLE.around + 12.0)
    drawn = [(side, [Run(-5.0, 40.0)])]
    assert without_tangent_ends(CIRCLE, dash, drawn, 5.0) == dash
    assert without_tangent_ends(CIRCLE, dash, drawn, 8.0) == dash
    dash = Run(CIRCLE.around - 6.0, CIRCLE.around + 7.0)
    cut = without_tangent_ends(CIRCLE, dash, drawn, 5.0)
    assert cut.end == pytest.approx(CIRCLE.around)
    assert cut.start == dash.start
    assert without_tangent_ends(CIRCLE, dash, [(side, [Run(-5.0, 2.0)])], 5.0) == dash
    aside = Line((115.0, 100.0), (0.0, 1.0))
    assert without_tangent_ends(CIRCLE, dash, [(aside, [Run(-5.0, 40.0)])], 5.0) == dash


@pytest.mark.parametrize("height", [40.0, 43.5, 47.0])
def test_the_dashed_end_of_a_slot_behind_a_groove_is_an_arc(sketch: Sketch, height: float) -> None:
    drawn = sketch(300, 200).lines((20, 20), (280, 20), (280, 180), (20, 180), (20, 20), width=3.0)
    end = 100.0 + height / 2.0
    drawn.lines((20, end - 7.0), (280, end - 7.0), width=3.0)
    drawn.lines((20, end), (280, end), width=3.0)
    for x in (133.0, 167.0):
        drawn.lines((x, end - 40.0), (x, end - 26.0), width=2.0)
        drawn.lines((x, end - 12.0), (x, end), width=2.0)
    for first, sweep in ((0.0, 0.74), (1.2, 0.74), (2.4, 0.74)):
        drawn.arc((150.0, end), 17.0, 2.0, first, sweep)
    view = find_shapes(clean_sheet(drawn.grey), (0.0, 0.0, 300.0, 200.0))
    arcs = [shape for shape in view.shapes if isinstance(shape.geometry, Circle)]
    assert len(arcs) == 1
    assert arcs[0].geometry.radius == pytest.approx(17.0, abs=0.3)
    assert len(arcs[0].runs) == 3
