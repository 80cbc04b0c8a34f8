"""Arcs that go on straight at their ends are told from circles that are a little too large."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle
from gaussiancad_core.sheet.runs import Piece
from gaussiancad_core.sheet.straight_ends import with_straight_ends
from gaussiancad_core.sheet.strokes import classify_strokes
from gaussiancad_core.sheet.view_shapes import find_shapes, view_rhythm
from gaussiancad_core.views import Arc, Linetype, Segment, Stroke

Sketch = Any
"""The class that the fixture gives."""

RADIUS, LEFT, RIGHT, TOP = 40.0, 110.0, 190.0, 20.0


def _block(sketch: Sketch, sides: float, sweep: float = np.pi) -> Sketch:
    """A block with a groove of parallel sides and a round bottom in its upper face."""
    drawn = sketch(300, 200).lines(
        (LEFT, TOP), (20, TOP), (20, 180), (280, 180), (280, TOP), width=2
    )
    centre = (150.0, TOP + sides)
    if sides > 0.0:
        drawn.line((LEFT, TOP), (LEFT, centre[1]), 2).line((RIGHT, TOP), (RIGHT, centre[1]), 2)
    start = 0.5 * (np.pi - sweep)
    drawn.arc(centre, RADIUS, 2.0, start, sweep)
    x, y = RADIUS * np.cos(start), RADIUS * np.sin(start)
    if sides <= 0.0:
        drawn = drawn.line((280, TOP + y), (150 + x, TOP + y), 2)
    return drawn.line((280, TOP), (RIGHT, TOP), 2)


def _read(drawn: Sketch) -> list[Stroke]:
    sheet = clean_sheet(drawn.grey)
    view = find_shapes(sheet, (0.0, 0.0, 300.0, 200.0))
    return list(classify_strokes(view, view_rhythm([view], sheet.stroke_width)))


@pytest.mark.parametrize("sides", [7.0, 9.0, 14.0])
def test_short_sides_of_a_groove_are_lines(sketch: Sketch, sides: float) -> None:
    strokes = _read(_block(sketch, sides))
    (arc,) = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    assert arc.radius == pytest.approx(RADIUS, abs=0.1)
    assert arc.centre == pytest.approx((150.5, TOP + sides + 0.5), abs=0.25)
    short = [
        stroke for stroke in strokes if isinstance(stroke, Segment) and stroke.length < 2.0 * sides
    ]
    assert len(strokes) == 8
    assert sorted(own.start[0] for own in short) == pytest.approx(
        [LEFT + 0.5, RIGHT + 0.5], abs=0.1
    )
    assert [own.length for own in short] == pytest.approx([sides] * 2, abs=0.4)
    assert {stroke.linetype for stroke in strokes} == {Linetype.VISIBLE}


def test_a_half_circle_has_none(sketch: Sketch) -> None:
    strokes = _read(_block(sketch, 0.0))
    assert len(strokes) == 6
    (arc,) = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    assert arc.radius == pytest.approx(RADIUS, abs=0.1)


@pytest.mark.parametrize("sweep", [1.0, 2.0, 4.0, 5.5])
def test_arcs_stay_arcs(sketch: Sketch, sweep: float) -> None:
    sheet = clean_sheet(sketch(300, 200).arc((150.3, 99.8), RADIUS, 2.0, 0.4, sweep).grey)
    circle = Circle((150.3, 99.8), RADIUS)
    piece = Piece(0.4 * RADIUS, (0.4 + sweep) * RADIUS, Linetype.VISIBLE, 1.0)
    assert with_straight_ends([(circle, piece)], sheet) == [(circle, piece)]


@pytest.mark.parametrize("short", [6.5, 7.5, 9.0])
@pytest.mark.parametrize("place", [(150.0, 90.0), (150.3, 90.6)])
def test_an_arc_that_is_known_to_end_in_one_line_goes_on_straight_at_its_other_end(
    sketch: Sketch, place: tuple[float, float], short: float
) -> None:
    """A shoulder a few px wider than the fillet in it, at the foot of a long side."""
    x, y = place
    radius = 21.0
    drawn = sketch(300, 200).lines((x, y), (x, 20), (20, 20), (20, 180), width=2.2)
    drawn.arc((x - radius, y), radius, 2.2, 0.0, np.pi / 2)
    end = x - radius - short
    drawn.lines((x - radius, y + radius), (end, y + radius), (end, 180), (20, 180), width=2.2)
    strokes = _read(drawn)
    (arc,) = [stroke for stroke in strokes if isinstance(stroke, Arc)]
    assert arc.radius == pytest.approx(radius, abs=0.2)
    assert arc.sweep == pytest.approx(np.pi / 2, abs=0.03)
    assert len(strokes) == 7
    shortest = min(strokes, key=lambda own: own.length)
    assert shortest.length == pytest.approx(short, abs=0.6)
