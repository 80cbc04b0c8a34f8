"""Lines between arcs that bend away to different sides run where they are straight."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Segment
from gaussiancad_core.sheet.tracing.arc_ends import without_arc_ends

Sketch = Any
"""The class that the fixture gives."""

LINE = Line((0.0, 50.0), (1.0, 0.0))
LEFT, RIGHT = Circle((100.0, 10.0), 40.0), Circle((200.0, 650.0), 600.0)


@pytest.mark.parametrize("shift", [0.0, 0.2, 0.45])
def test_a_line_between_arcs_to_both_sides_is_not_turned(sketch: Sketch, shift: float) -> None:
    x, top, bottom = 120.0 + shift, 110.0, 250.0
    drawn = sketch(240, 480).line((x, top), (x, bottom), width=2.0)
    drawn.arc((x - 90.0, top), 90.0, width=2.0, start=-0.5 * np.pi, sweep=0.5 * np.pi)
    drawn.arc((x + 1250.0, bottom), 1250.0, width=2.0, start=np.pi - 0.16, sweep=0.16)
    [line] = [stroke for stroke in drawn.strokes() if isinstance(stroke, Segment)]
    # Corners of pixels count in strokes, their centres in sketches.
    assert [line.start[0], line.end[0]] == pytest.approx([x + 0.5] * 2, abs=0.05)


def test_what_lies_beyond_where_arcs_touch_is_theirs() -> None:
    spans = [(85.0, 150.0), (155.0, 230.0)]
    assert without_arc_ends(LINE, spans, [LEFT, RIGHT]) == [(100.0, 150.0), (155.0, 200.0)]


@pytest.mark.parametrize(
    "circle",
    [
        pytest.param(Circle((100.0, 10.0), 35.0), id="passes beside it"),
        pytest.param(Circle((100.0, 10.0), 45.0), id="crosses it"),
        pytest.param(Circle((150.0, 10.0), 40.0), id="touches its middle"),
        pytest.param(Circle((80.0, 10.0), 40.0), id="touches it beyond its ink"),
        pytest.param(Circle((95.0, 42.0), 8.0), id="leaves it at once"),
    ],
)
def test_other_circles_take_nothing(circle: Circle) -> None:
    spans = [(90.0, 230.0)]
    assert without_arc_ends(LINE, spans, [circle]) == spans


def test_most_of_the_ink_stays() -> None:
    spans = [(95.0, 110.0)]
    assert without_arc_ends(LINE, spans, [Circle((104.0, 10.0), 40.0)]) == spans
