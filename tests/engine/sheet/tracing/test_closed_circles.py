"""An arc becomes no whole circle by the ink of lines that touch it."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.closed_circles import has_separate_ink
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Rhythm, Run

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = Rhythm(11.0, 6.0)
CENTRE = (100.3, 80.6)


def _dashed(drawn: Sketch, radius: float, turn: float = 2.0 * np.pi) -> None:
    """Dashes along a circle, from its right side on."""
    step = turn / round(turn * radius / 17.0)
    for k in range(round(turn / step)):
        drawn.arc(CENTRE, radius, 2.3, k * step, 11.0 / radius)


@pytest.mark.parametrize("whole", [False, True])
def test_an_edge_that_touches_the_end_of_a_slot(sketch: Sketch, whole: bool) -> None:
    """Between it and the sides are gaps as long as those of dashes, but no dash."""
    radius = 16.7
    drawn = sketch()
    _dashed(drawn, radius, 2.0 * np.pi if whole else np.pi)
    drawn.line((20.0, CENTRE[1] - radius), (180.0, CENTRE[1] - radius), 2.7)
    for side in (-radius, radius):
        start = CENTRE[0] + side, CENTRE[1]
        drawn.line(start, (start[0], CENTRE[1] - 14.0), 2.3)
        drawn.broken((start[0], CENTRE[1] - 20.0), (start[0], 10.0), (11.0, 6.0), 2.3)
    circle, down = Circle(CENTRE, radius), Piece(0.0, CENTRE[1] - 10.0, Linetype.HIDDEN, 0.9)
    lines = [
        (Line((CENTRE[0] - radius, 10.0), (0.0, 1.0)), [down]),
        (Line((CENTRE[0] + radius, 10.0), (0.0, 1.0)), [down]),
        (Line((20.0, CENTRE[1] - radius), (1.0, 0.0)), [Run(0.0, 160.0)]),
    ]
    arc = Piece(-0.07 * circle.around, 0.57 * circle.around, Linetype.HIDDEN, 0.9)
    sheet = clean_sheet(drawn.grey)
    assert has_separate_ink(circle, arc, lines, sheet, RHYTHM) == whole
    # Any other line crosses it.
    assert has_separate_ink(circle, arc, [], sheet, RHYTHM)
    # What is left may be a gap.
    most = Piece(0.0, 0.85 * circle.around, Linetype.HIDDEN, 0.9)
    assert has_separate_ink(circle, most, lines, sheet, RHYTHM)
