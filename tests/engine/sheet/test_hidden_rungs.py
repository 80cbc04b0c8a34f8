"""Hidden lines between two others, of which only two ticks are drawn."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.hidden_rungs import with_hidden_rungs
from gaussiancad_core.sheet.runs import Piece, Rhythm
from gaussiancad_core.sheet.strokes import classify_strokes
from gaussiancad_core.sheet.view_shapes import find_shapes
from gaussiancad_core.views import Linetype, Segment

Sketch = Any
"""The class that the fixture gives."""

DASHES = (12.0, 6.0)
APART = 12.6
PEN = 2.0


def _pair(sketch: Sketch) -> Sketch:
    """Two hidden lines beside each other in an outline."""
    drawn = sketch(320, 240).lines((20, 20), (300, 20), (300, 220), (20, 220), (20, 20))
    for y in (100.3, 100.3 + APART):
        drawn.broken((22, y), (298, y), DASHES, PEN)
    return drawn


def _upright(drawn: Sketch) -> list[float]:
    """x of the hidden lines from one to the other."""
    view = find_shapes(clean_sheet(drawn.grey), (18.0, 18.0, 302.0, 222.0))
    found = []
    for own in classify_strokes(view, Rhythm(*DASHES)):
        points = own.sample(1e9)[[0, -1]] - 0.5
        short = abs(float(np.ptp(points[:, 1])) - APART) < 0.6
        if own.linetype is Linetype.HIDDEN and isinstance(own, Segment) and short:
            assert np.ptp(points[:, 0]) < 0.5
            found.append(float(points[:, 0].mean()))
    return sorted(found)


@pytest.mark.parametrize("tick", [4.0, 4.6])
@pytest.mark.parametrize("places", [(100.4,), (82.4, 131.5, 190.3)])
def test_ticks_that_face_each_other_are_a_line(
    sketch: Sketch, tick: float, places: tuple[float, ...]
) -> None:
    drawn = _pair(sketch)
    for x in places:
        drawn.line((x, 100.3), (x, 100.3 + tick), PEN)
        drawn.line((x, 100.3 + APART - tick), (x, 100.3 + APART), PEN)
    assert _upright(drawn) == pytest.approx(list(places), abs=0.4)


@pytest.mark.parametrize(("aside", "count"), [(0.0, 1), (0.6, 1), (1.5, 0), (4.0, 0)])
def test_ticks_that_do_not_face_each_other_are_none(
    sketch: Sketch, aside: float, count: int
) -> None:
    drawn = _pair(sketch).line((100.4, 100.3), (100.4, 104.9), PEN)
    drawn.line((100.4 + aside, 108.3), (100.4 + aside, 100.3 + APART), PEN)
    pieces = [
        (Line((0.0, y), (1.0, 0.0)), Piece(22.0, 298.0, Linetype.HIDDEN, 1.0))
        for y in (100.3, 100.3 + APART)
    ]
    found = with_hidden_rungs(pieces, clean_sheet(drawn.grey), Rhythm(*DASHES))
    assert found[:2] == pieces
    assert len(found) == 2 + count


def test_a_hidden_line_across_both_stays_one(sketch: Sketch) -> None:
    drawn = _pair(sketch).broken((100.4, 22), (100.4, 218), DASHES, PEN)
    assert _upright(drawn) == []


def test_dashes_of_a_circle_that_touches_both_lines_are_no_ticks(sketch: Sketch) -> None:
    radius = 11.0
    lines = [
        (Line((0.0, y), (1.0, 0.0)), Piece(22.0, 298.0, Linetype.HIDDEN, 1.0))
        for y in (100.3, 100.3 + 2.0 * radius)
    ]
    drawn = sketch(320, 240).lines((20, 20), (300, 20), (300, 220), (20, 220), (20, 20))
    middle = np.array([100.4, 100.3 + radius])
    for side in (-1.0, 1.0):
        angles = np.radians(np.linspace(20.0, 70.0, 9))
        arc = middle + radius * np.stack([np.cos(angles), side * np.sin(angles)], 1)
        drawn.lines(*[(float(x), float(y)) for x, y in arc], width=PEN)
    sheet = clean_sheet(drawn.grey)
    assert len(with_hidden_rungs(lines, sheet, Rhythm(*DASHES))) > 2
    circle = Circle((float(middle[0]), float(middle[1])), radius)
    around = (circle, Piece(0.0, circle.around, Linetype.HIDDEN, 1.0))
    assert with_hidden_rungs([*lines, around], sheet, Rhythm(*DASHES)) == [*lines, around]
