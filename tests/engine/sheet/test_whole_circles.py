"""Hidden arcs are whole circles where dashes lie all around, and nowhere else."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.junctions import is_full_circle
from gaussiancad_core.sheet.runs import Piece, Rhythm, Run
from gaussiancad_core.sheet.whole_circles import has_ink_of_its_own, with_whole_circles
from gaussiancad_core.views import Linetype

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = Rhythm(11.0, 6.0)
CENTRE = (100.3, 80.6)


def _dashed(drawn: Sketch, radius: float, turn: float = 2.0 * np.pi) -> None:
    """Dashes along a circle, from its right side on."""
    step = turn / round(turn * radius / 17.0)
    for k in range(round(turn / step)):
        drawn.arc(CENTRE, radius, 2.3, k * step, 11.0 / radius)


def _is_whole(drawn: Sketch, radius: float, share: float) -> bool:
    """Whether an arc from the circle's right side on, of that share of it, becomes all of it."""
    circle = Circle(CENTRE, radius)
    arc = circle, Piece(0.0, share * circle.around, Linetype.HIDDEN, 0.9)
    (found,) = with_whole_circles([arc], clean_sheet(drawn.grey), RHYTHM)
    return is_full_circle(*found)


@pytest.mark.parametrize("radius", [21.7, 26.2, 40.1])
def test_dashes_all_around(sketch: Sketch, radius: float) -> None:
    drawn = sketch()
    _dashed(drawn, radius)
    drawn.line((20.0, 98.0), (180.0, 98.0), 2.7)
    assert _is_whole(drawn, radius, 0.58)
    assert not _is_whole(drawn, radius, 0.4)


@pytest.mark.parametrize("hidden", [1.0, 0.45])
def test_one_pale_dash_that_an_edge_crosses_is_missing(sketch: Sketch, hidden: float) -> None:
    drawn = sketch()
    _dashed(drawn, 40.1)
    drawn.weight *= hidden
    # It lies around the circle's right side, with a gap on either side.
    first, last = 17.0, 40.1 * 2.0 * np.pi - 6.0
    drawn.line((CENTRE[0] + 30.0, CENTRE[1] + 5.0), (CENTRE[0] + 50.0, CENTRE[1] + 6.0), 2.7)
    circle = Circle(CENTRE, 40.1)
    arc = circle, Piece(first, last, Linetype.HIDDEN, 0.9)
    (found,) = with_whole_circles([arc], clean_sheet(drawn.grey), RHYTHM)
    assert is_full_circle(*found)


@pytest.mark.parametrize("radius", [8.2, 13.4, 26.2, 40.1])
def test_the_end_of_a_slot_stays_half_of_one(sketch: Sketch, radius: float) -> None:
    drawn = sketch()
    _dashed(drawn, radius, np.pi)
    for side in (-radius, radius):
        end = CENTRE[0] + side, 20.0
        drawn.broken((CENTRE[0] + side, CENTRE[1]), end, (11.0, 6.0), 2.3)
    assert not _is_whole(drawn, radius, 0.5)


def test_an_arc_that_goes_on_visible(sketch: Sketch) -> None:
    drawn = sketch()
    _dashed(drawn, 26.2, np.pi)
    drawn.arc(CENTRE, 26.2, 2.7, np.pi, np.pi)
    assert not _is_whole(drawn, 26.2, 0.5)


def test_a_line_across_the_rest_of_it_is_no_dash(sketch: Sketch) -> None:
    drawn = sketch()
    _dashed(drawn, 26.2, 1.1 * np.pi)
    for away in (8.0, 20.0):
        drawn.line((40.0, CENTRE[1] - away), (160.0, CENTRE[1] - away), 2.7)
    assert not _is_whole(drawn, 26.2, 0.55)


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
    assert has_ink_of_its_own(circle, arc, lines, sheet, RHYTHM) == whole
    # Any other line crosses it.
    assert has_ink_of_its_own(circle, arc, [], sheet, RHYTHM)
    # What is left may be a gap.
    most = Piece(0.0, 0.85 * circle.around, Linetype.HIDDEN, 0.9)
    assert has_ink_of_its_own(circle, most, lines, sheet, RHYTHM)
