"""Short lines between arcs that they touch, and where these arcs end."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_runs import Piece, Run
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.touching_arcs import up_to_tangents
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

CIRCLE = Circle((50.0, 50.0), 20.0)
BELOW = Line((0.0, 70.0), (1.0, 0.0))
QUARTER = 20.0 * np.pi / 2.0


def _arc(start: float, end: float) -> Piece:
    return Piece(start, end, Linetype.VISIBLE, 1.0)


@pytest.mark.parametrize("beyond", [2.0, 6.0])
def test_what_a_tangent_has_beyond_the_touch_is_not_the_arcs(beyond: float) -> None:
    """The arc comes from the right and touches the line at x = 50, where the line goes on left."""
    piece = _arc(0.0, QUARTER + beyond)
    up = up_to_tangents(CIRCLE, piece, [(BELOW, [Run(10.0, 56.0)])], 3.0)
    assert (up.start, up.end) == (0.0, pytest.approx(QUARTER))
    mirrored = _arc(QUARTER - beyond, 2.0 * QUARTER)
    up = up_to_tangents(CIRCLE, mirrored, [(BELOW, [Run(44.0, 90.0)])], 3.0)
    assert (up.start, up.end) == (pytest.approx(QUARTER), 2.0 * QUARTER)


def test_a_chord_and_a_line_that_goes_the_other_way_take_nothing() -> None:
    piece = _arc(0.0, QUARTER + 6.0)
    for runs in ([Run(45.0, 55.0)], [Run(44.0, 90.0)]):
        assert up_to_tangents(CIRCLE, piece, [(BELOW, runs)], 3.0) == piece
    neighbour = Line((0.0, 67.0), (1.0, 0.0))
    assert up_to_tangents(CIRCLE, piece, [(neighbour, [Run(10.0, 56.0)])], 3.0) == piece


@pytest.mark.parametrize("radius", [12.8, 15.7, 31.9])
@pytest.mark.parametrize("side", [0.8, 1.0, 1.5])
@pytest.mark.parametrize("off", [0.1, 0.6])
def test_the_short_sides_of_a_slot_are_lines(
    sketch: Sketch, radius: float, side: float, off: float
) -> None:
    length = side * radius + 4.0
    x, y = 100.0 + off, 80.0 + off
    drawing = sketch(260, 180).lines(
        (12, 12), (248, 12), (248, 168), (12, 168), (12, 12), width=2.0
    )
    drawing.arc((x, y), radius, 2.0, np.pi / 2.0, np.pi)
    drawing.arc((x + length, y), radius, 2.0, -np.pi / 2.0, np.pi)
    for level in (y - radius, y + radius):
        drawing.line((x, level), (x + length, level), 2.0)
    sheet = clean_sheet(drawing.grey)
    view = find_shapes(sheet, (10.0, 10.0, 250.0, 170.0))
    strokes = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    arcs = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    sides = [stroke for stroke in strokes if isinstance(stroke, Segment) and stroke.length < 100.0]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.4)] * 2
    assert [arc.sweep for arc in arcs] == [pytest.approx(np.pi, abs=0.1)] * 2
    assert [this_side.length for this_side in sides] == [pytest.approx(length, abs=1.0)] * 2


@pytest.mark.parametrize(("beyond", "flag"), [(60.0, True), (75.0, True), (90.0, False)])
def test_a_wide_arc_shares_much_ink_with_its_tangent(beyond: float, flag: bool) -> None:
    """Lines of 2 px lie in one stroke up to 80 px from where an arc of 1243 px touches."""
    arc = Circle((0.0, 0.0), 1243.0)
    tangent = Line((1243.0, 0.0), (0.0, 1.0))
    piece = Piece(-300.0, beyond, Linetype.VISIBLE, 1.0)
    found = up_to_tangents(arc, piece, [(tangent, (Run(-5.0, 200.0),))], 2.0)
    assert (found.start, found.end) == pytest.approx((-300.0, 0.0 if flag else beyond))
