"""Hidden slants go on beyond lines that cross them, to the next stroke that their ink leads to."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.junctions import Placed
from gaussiancad_core.sheet.runs import Piece, Rhythm
from gaussiancad_core.sheet.slants_led_on import with_slants_led_on
from gaussiancad_core.views import Linetype

Sketch = Any
"""The class that the fixture gives."""

Point = tuple[float, float]

RHYTHM = Rhythm(11.0, 6.5)
START, CORNER = (30.0, 40.0), (74.0, 62.0)


def _piece(start: Point, end: Point, linetype: Linetype = Linetype.HIDDEN) -> Placed:
    length = float(np.hypot(end[0] - start[0], end[1] - start[1]))
    way = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    return Line(start, way), Piece(0.0, length, linetype, 1.0)


def _on_slant(along: float) -> Point:
    """A point so many px from the start of the slant."""
    way = np.subtract(CORNER, START) / np.hypot(*np.subtract(CORNER, START))
    x, y = np.array(START) + along * way
    return float(x), float(y)


def _crossed(drawn: Sketch) -> list[Placed]:
    """The edge that the slant starts from, a hidden line and an edge across it."""
    drawn.line((30.0, 15.0), (30.0, 120.0), 2.7).line((30.0, 55.8), (160.0, 55.8), 2.7)
    drawn.broken((30.0, 50.5), (160.0, 50.5), (11.0, 6.5), 1.8)
    return [
        _piece((30.0, 15.0), (30.0, 120.0), Linetype.VISIBLE),
        _piece((30.0, 55.8), (160.0, 55.8), Linetype.VISIBLE),
        _piece((30.0, 50.5), (160.0, 50.5)),
    ]


@pytest.mark.parametrize(("dashes", "leads"), [(3, True), (1, False)])
def test_a_slant_goes_on_as_far_as_its_ink(sketch: Sketch, dashes: int, leads: bool) -> None:
    drawn = sketch()
    pieces = _crossed(drawn)
    upright = _piece(CORNER, (CORNER[0], 120.0))
    drawn.broken(CORNER, (CORNER[0], 120.0), (11.0, 6.5), 1.8)
    length = float(np.hypot(*np.subtract(CORNER, START)))
    for start in (0.0, 19.1, 38.2)[:dashes]:
        drawn.line(_on_slant(start), _on_slant(min(start + 11.0, length)), 1.8)
    slant = _piece(_on_slant(1.4), _on_slant(11.0))
    *others, found = with_slants_led_on([*pieces, upright, slant], clean_sheet(drawn.grey), RHYTHM)
    assert others == [*pieces, upright]
    assert found[0] == slant[0]
    assert found[1].start == slant[1].start
    assert found[1].end == pytest.approx(length - 1.4 if leads else slant[1].end, abs=3.0)


def test_ink_that_leads_to_nothing_is_none_of_it(sketch: Sketch) -> None:
    drawn = sketch()
    pieces = _crossed(drawn)
    for start in (0.0, 19.1, 38.2):
        drawn.line(_on_slant(start), _on_slant(start + 11.0), 1.8)
    slant = _piece(_on_slant(1.4), _on_slant(11.0))
    assert with_slants_led_on([*pieces, slant], clean_sheet(drawn.grey), RHYTHM)[-1] == slant


def test_a_slant_far_from_all_other_strokes_stays(sketch: Sketch) -> None:
    drawn = sketch()
    for start in (0.0, 17.5):
        drawn.line(_on_slant(start), _on_slant(start + 11.0), 1.8)
    slant, sheet = _piece(START, _on_slant(28.5)), clean_sheet(drawn.grey)
    far = _piece((500.0, 400.0), (500.0, 480.0))
    for others in ([], [far]):
        assert with_slants_led_on([*others, slant], sheet, RHYTHM)[-1] == slant


def test_a_corner_behind_two_crossing_lines_is_read(sketch: Sketch) -> None:
    """Neither line that its dashes grow is the whole slant."""
    drawn = sketch()
    _crossed(drawn)
    drawn.lines((30.0, 15.0), (160.0, 15.0), (160.0, 120.0), (30.0, 120.0), width=2.7)
    drawn.broken(CORNER, (CORNER[0], 120.0), (11.0, 6.5), 1.8)
    length = float(np.hypot(*np.subtract(CORNER, START)))
    for start in (0.0, 19.1, 38.2):
        drawn.line(_on_slant(start), _on_slant(min(start + 11.0, length)), 1.8)
    ends = [
        sorted([stroke.start, stroke.end])
        for stroke in drawn.strokes()
        if stroke.linetype is Linetype.HIDDEN
        and min(abs(np.subtract(stroke.end, stroke.start))) > 3.0
    ]
    assert np.array(ends) - 0.5 == pytest.approx(np.array([[START, CORNER]]), abs=0.4)
