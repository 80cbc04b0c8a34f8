"""Dashes that meet at a square corner are no arc."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.dash_corners import is_dash_corner
from gaussiancad_core.sheet.geometry import Circle
from gaussiancad_core.sheet.runs import Piece, Rhythm
from gaussiancad_core.sheet.strokes import classify_strokes
from gaussiancad_core.sheet.view_shapes import find_shapes
from gaussiancad_core.views import Arc, Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = Rhythm(8.0, 5.0)
PEN = 2.8


def _is_corner(drawn: Sketch, circle: Circle) -> bool:
    sheet = clean_sheet(drawn.grey)
    quarter = Piece(0.5 * np.pi * circle.radius, np.pi * circle.radius, Linetype.VISIBLE, 1.0)
    return is_dash_corner(circle, quarter, sheet, RHYTHM)


@pytest.mark.parametrize("shift", [0.0, 0.25, 0.5])
@pytest.mark.parametrize("legs", [(8.0, 8.0), (6.0, 9.0)])
def test_two_legs_are_a_corner(sketch: Sketch, shift: float, legs: tuple[float, float]) -> None:
    x, y = 40.0 + shift, 60.0 + shift
    drawn = sketch(120, 120).line((10.0, 110.0), (110.0, 110.0), PEN)
    drawn.line((x, y - legs[0]), (x, y + PEN / 2.0), PEN).line((x, y), (x + legs[1], y), PEN)
    circle = Circle((x + 4.2, y - 4.2), 5.0)
    assert _is_corner(drawn, circle)


@pytest.mark.parametrize("radius", [6.0, 8.0])
def test_a_dash_of_an_arc_is_none(sketch: Sketch, radius: float) -> None:
    drawn = sketch(120, 120).line((10.0, 110.0), (110.0, 110.0), PEN)
    drawn.arc((60.0, 60.0), radius, PEN, np.pi / 2, np.pi / 2)
    assert not _is_corner(drawn, Circle((60.0, 60.0), radius))


def test_ink_that_goes_on_is_none(sketch: Sketch) -> None:
    drawn = sketch(120, 120).lines((40.0, 20.0), (40.0, 60.0), (100.0, 60.0), width=PEN)
    assert not _is_corner(drawn, Circle((44.2, 55.8), 5.0))


@pytest.mark.parametrize("depth", [12.5, 13.5])
@pytest.mark.parametrize("middle", [120.0, 120.4])
def test_a_shallow_pocket_has_square_corners(sketch: Sketch, depth: float, middle: float) -> None:
    """Each of its short sides has half a dash at the corner, then a gap."""
    edge, low, high = 200.3, middle - 15.6, middle + 15.6
    corners = [(40.3, 40.3), (edge, 40.3), (edge, 200.3), (40.3, 200.3), (40.3, 40.3)]
    drawn = sketch(240, 240).lines(*corners, width=PEN)
    inner = edge - depth
    for y in (low, high):
        drawn.line((inner, y), (inner + 8.0, y), PEN)
    drawn.line((inner, low), (inner, low + 6.0), PEN).line((inner, high - 9.0), (inner, high), PEN)
    drawn.line((inner, low + 10.7), (inner, low + 18.2), PEN)
    view = find_shapes(clean_sheet(drawn.grey), (38.0, 38.0, 203.0, 203.0))
    hidden = [own for own in classify_strokes(view, RHYTHM) if own.linetype is Linetype.HIDDEN]
    assert not any(isinstance(own, Arc) for own in hidden)
    ends = [np.array([own.start, own.end]) - 0.5 for own in hidden if isinstance(own, Segment)]
    sides = [
        ((inner, low), (inner, high)),
        ((inner, low), (edge, low)),
        ((inner, high), (edge, high)),
    ]
    assert len(ends) == len(hidden) == len(sides)
    for side in np.array(sides):
        assert min(np.abs(own[::way] - side).max() for own in ends for way in (1, -1)) < 0.8
