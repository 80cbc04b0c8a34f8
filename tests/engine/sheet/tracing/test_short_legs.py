"""Chamfers and drill tips of a dash or less, hidden, in the ink of the strokes they join."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

RHYTHM = (12.0, 6.0)
LEFT, RIGHT = 182.0, 206.0


def _block(sketch: Sketch, top: float) -> Sketch:
    """A block with a bore of dashed lines from its lower edge up to a height."""
    drawn = sketch(400, 300).lines((12, 12), (388, 12), (388, 288), (12, 288), (12, 12), width=3)
    for x in (LEFT, RIGHT, 300.0):
        drawn.broken((x, top), (x, 288), RHYTHM, 2.0)
    return drawn.broken((LEFT, top), (RIGHT, top), (9.0, 6.0), 2.0)


def _slanted(drawn: Sketch) -> np.ndarray:
    """(n, 2, 2) ends of slanted hidden lines, left ones first, px whose centres are at integers."""
    sheet = clean_sheet(drawn.grey)
    shapes = find_shapes(sheet, (10.0, 10.0, 390.0, 290.0))
    strokes = classify_strokes(shapes, view_rhythm([shapes], sheet.stroke_width))
    ends = [
        sorted((x - 0.5, y - 0.5) for x, y in (stroke.start, stroke.end))
        for stroke in strokes
        if isinstance(stroke, Segment)
        and stroke.linetype is Linetype.HIDDEN
        and min(np.abs(np.subtract(stroke.end, stroke.start)) / stroke.length) > 0.15
    ]
    return np.array(sorted(ends)).reshape(-1, 2, 2)


def _dashes(drawn: Sketch, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Two short dashes with a gap between them."""
    ends = np.array([start, end])
    for first, last in ((0.0, 1.0 / 3.0), (2.0 / 3.0, 1.0)):
        near, far = (ends[0] + share * (ends[1] - ends[0]) for share in (first, last))
        drawn.line(tuple(near), tuple(far), 2.0)


@pytest.mark.parametrize("away", [8.5, 9.5, 11.0])
def test_chamfers_right_under_an_edge(sketch: Sketch, away: float) -> None:
    top = 12.0 + away
    drawn = _block(sketch, top)
    cones = [((LEFT - away, 12.0), (LEFT, top)), ((RIGHT, top), (RIGHT + away, 12.0))]
    for start, end in cones:
        _dashes(drawn, start, end)
    assert _slanted(drawn) == pytest.approx(np.array(cones), abs=1.2)


@pytest.mark.parametrize("degrees", [30.0, 45.0])
def test_the_tip_of_a_narrow_drill(sketch: Sketch, degrees: float) -> None:
    half = 0.5 * (RIGHT - LEFT)
    tip = (LEFT + half, 60.0 - half * float(np.tan(np.radians(degrees))))
    drawn = _block(sketch, 60.0)
    sides = [((LEFT, 60.0), tip), (tip, (RIGHT, 60.0))]
    for start, end in sides:
        _dashes(drawn, start, end)
    assert _slanted(drawn) == pytest.approx(np.array(sides), abs=1.2)


def test_corners_without_more_ink_have_no_legs(sketch: Sketch) -> None:
    for away in (8.5, 11.0, 48.0):
        assert not len(_slanted(_block(sketch, 12.0 + away)))


@pytest.mark.parametrize("away", [8.0, 10.0])
def test_pale_chamfers_between_two_edges(sketch: Sketch, away: float) -> None:
    """Pale dashes right beside edges are not raised as others are."""
    top = 12.0 + away
    drawn = sketch(400, 300).lines((12, 12), (388, 12), (388, 288), (12, 288), (12, 12), width=3)
    drawn.line((12, top), (388, top), 3)
    pale = sketch(400, 300)
    for x in (LEFT, RIGHT, 300.0):
        pale.broken((x, top + 6.0), (x, 288), RHYTHM, 2.0)
    cones = [((LEFT - away, 12.0), (LEFT, top)), ((RIGHT, top), (RIGHT + away, 12.0))]
    for start, end in cones:
        pale.line(start, end, 2.0)
    drawn.weight = np.maximum(drawn.weight, np.float32(0.45) * pale.weight)
    assert _slanted(drawn) == pytest.approx(np.array(cones), abs=1.2)


def test_chamfers_longer_than_short_dashes(sketch: Sketch) -> None:
    """Most of what is drawn of them is in the ink of other strokes all the same."""
    drawn = sketch(400, 300).lines((12, 12), (388, 12), (388, 288), (12, 288), (12, 12), width=3)
    top = 19.0
    drawn.broken((LEFT, top), (RIGHT + 2.0, top), (5.0, 4.0), 2.0)
    for x in (LEFT, RIGHT):
        drawn.broken((x, top), (x, 288), (5.0, 4.0), 2.0)
    cones = [((LEFT - 7.0, 12.0), (LEFT, top)), ((RIGHT, top), (RIGHT + 7.0, 12.0))]
    for start, end in (cones[0][::-1], cones[1]):
        drawn.broken(start, end, (5.0, 4.0), 2.0)
    assert _slanted(drawn) == pytest.approx(np.array(cones), abs=1.2)
