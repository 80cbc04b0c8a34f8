"""A step of two or three pixels in an edge is two edges, each where it is drawn."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Run
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.offset_lines import without_offset_ink
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""


def _upright(drawn: Sketch) -> list[tuple[float, float, float]]:
    """x, and the ends, of the upright strokes beside x = 300, from top to bottom."""
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, (18.0, 18.0, 306.0, 262.0))
    strokes = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    found = []
    for stroke in strokes:
        points = stroke.sample(1.0)[[0, -1]] - 0.5
        if isinstance(stroke, Segment) and np.ptp(points[:, 0]) < 1.0 and points[0, 0] > 290.0:
            found.append((float(points[:, 0].mean()), *sorted(points[:, 1].tolist())))
    return sorted(found, key=lambda item: item[1])


@pytest.mark.parametrize("step", [2.2, 2.6, 3.0])
@pytest.mark.parametrize("inwards", [True, False])
def test_a_small_step_parts_an_edge(sketch: Sketch, step: float, inwards: bool) -> None:
    middle = 300.0 - step if inwards else 300.0
    outer = 300.0 if inwards else 300.0 - step
    drawn = sketch(340, 290).lines((20, 20), (outer, 20), (outer, 90), (20, 90), width=4.0)
    drawn.lines((20, 20), (20, 260), (outer, 260), (outer, 190), (20, 190), width=4.0)
    drawn.line((middle, 90), (middle, 190), 4.0)
    found = _upright(drawn)
    expected = [(outer, 20.0, 90.0), (middle, 90.0, 190.0), (outer, 190.0, 260.0)]
    assert [item[0] for item in found] == pytest.approx([x for x, _, _ in expected], abs=0.35)
    ends = [end for item in found for end in item[1:]]
    assert ends == pytest.approx([end for item in expected for end in item[1:]], abs=2.5)


@pytest.mark.parametrize("turn", [10.0, 13.0])
def test_a_line_across_a_dash_has_no_ink_of_it(sketch: Sketch, turn: float) -> None:
    """At a small angle most of the dash lies below the line, but it runs its own way."""
    way = (float(np.sin(np.radians(turn))), float(np.cos(np.radians(turn))))
    dash, slant = Line((60.0, 60.0), (0.0, 1.0)), Line((60.0, 60.0), way)
    drawn = sketch(120, 240).line((60, 52), (60, 68), 2.2)
    drawn.line(slant.at(60.0), slant.at(150.0), 2.6)
    sheet = clean_sheet(drawn.grey)
    runs = [Run(-7.0, 7.0), Run(60.0, 150.0)]
    assert without_offset_ink(sheet, slant, runs, [dash, slant]) == runs[1:]
    assert without_offset_ink(sheet, dash, [Run(-8.0, 8.0)], [dash, slant]) == [Run(-8.0, 8.0)]


@pytest.mark.parametrize("rightwards", [True, False])
def test_an_edge_on_the_course_of_a_slant_is_upright(sketch: Sketch, rightwards: bool) -> None:
    """A cone's outline, drawn on, runs through the short edge of the shoulder above it."""
    drawn = sketch(340, 290)

    def x(at: float) -> float:
        return at if rightwards else 340.0 - at

    drawn.lines((x(20), 137), (x(303.0), 137), (x(303.0), 160), (x(297.2), 166), width=2.5)
    drawn.lines((x(20), 160), (x(303.0), 160), width=2.5)
    drawn.lines((x(20), 250), (x(326.5), 250), (x(305.5), 166), (x(20), 166), width=2.5)
    drawn.line((x(20), 137), (x(20), 250), 2.5)
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, (5.0, 125.0, 335.0, 260.0))
    strokes = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    edges = [
        points
        for points in (stroke.sample(1.0)[[0, -1]] - 0.5 for stroke in strokes)
        if np.ptp(points[:, 1]) > 15.0 and np.abs(points[:, 0] - x(303.0)).max() < 2.0
    ]
    assert len(edges) == 1
    assert edges[0][:, 0] == pytest.approx(x(303.0), abs=0.2)
    assert sorted(edges[0][:, 1]) == pytest.approx([137.0, 160.0], abs=0.5)


@pytest.mark.parametrize("apart", [0.9, 1.2, 1.6])
@pytest.mark.parametrize("degrees", [45.0, 30.0])
def test_two_slants_a_px_off_one_course_are_both_where_they_are(
    sketch: Sketch, apart: float, degrees: float
) -> None:
    """The longer one does not pull the other to its own course."""
    way = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    normal = np.array([-way[1], way[0]])
    origin = np.array([30.3, 40.2])
    drawn = sketch(420, 420)
    spans = [(0.0, 90.0, 0.0), (220.0, 275.0, apart)]
    for start, end, off in spans:
        first, last = (origin + at * way + off * normal for at in (start, end))
        drawn.line(tuple(first), tuple(last), 2.6)
    view = find_shapes(clean_sheet(drawn.grey), (20.0, 20.0, 400.0, 400.0))
    lines = [shape.geometry for shape in view.shapes if isinstance(shape.geometry, Line)]
    for start, end, off in spans:
        middle = origin + (start + end) / 2.0 * way + off * normal - np.array(view.offset)
        assert min(float(line.distances(middle[None])[0]) for line in lines) < 0.1
