"""Tips of blind bores are two lines to a point, whatever their ink was taken for."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.clean_ink import CleanSheet, clean_sheet
from gaussiancad_core.sheet.tracing.drill_tips import with_drill_tips
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.junctions import Placed

Sketch = Any
"""The class that the fixture gives."""

HIDDEN = Linetype.HIDDEN
LEFT, BOTTOM, FOOT = 60.0, 60.0, 120.0
DASH, GAP = 7.0, 3.5


def _dashed(drawn: Sketch, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Dashes between two places that begin and end with one."""
    long = float(np.hypot(*np.subtract(end, start)))
    count = max(2, round((long + GAP) / (DASH + GAP)))
    gap = min(GAP, (long - count) / (2.0 * count))
    drawn.broken(start, end, ((long + gap) / count - gap, gap))


def _bore(sketch: Sketch, wide: float, height: float, tip: bool = True) -> CleanSheet:
    drawn = sketch(200, 160).line((20, FOOT), (180, FOOT))
    right, point = LEFT + wide, (LEFT + wide / 2.0, BOTTOM - height * wide / 2.0)
    for x in (LEFT, right):
        _dashed(drawn, (x, BOTTOM), (x, FOOT))
        if tip:
            _dashed(drawn, (x, BOTTOM), point)
    _dashed(drawn, (LEFT, BOTTOM), (right, BOTTOM))
    return clean_sheet(drawn.grey)


def _sides(wide: float, end: float = BOTTOM) -> list[Placed]:
    return [
        (Line((x, 0.0), (0.0, 1.0)), Piece(end, FOOT, HIDDEN, 0.9)) for x in (LEFT, LEFT + wide)
    ]


def _ends(placed: Placed) -> np.ndarray:
    geometry, piece = placed
    return geometry.points_at(np.array([piece.start, piece.end]))


@pytest.mark.parametrize("wide", [20.0, 28.0, 40.0])
@pytest.mark.parametrize("height", [0.577, 0.601, 1.0])
@pytest.mark.parametrize("off", [-1.3, 0.0, 1.2])
def test_the_tip_and_the_bottom_are_where_their_ink_is(
    sketch: Sketch, wide: float, height: float, off: float
) -> None:
    radius = wide / 2.0
    # What a fit to the dashes at the point gives, and a leg of the tip that was found too short.
    arc = Circle((LEFT + radius, BOTTOM - 0.3 * radius), 0.4 * radius), Piece(0.1, 2.0, HIDDEN, 0.5)
    leg = Line((LEFT + 2.0, BOTTOM - 1.0), (0.8, -0.6)), Piece(0.0, 5.0, HIDDEN, 0.5)
    pieces = [*_sides(wide, BOTTOM + off), arc, leg]
    found = with_drill_tips(pieces, _bore(sketch, wide, height))
    assert len(found) == 5
    assert all(isinstance(item[0], Line) and item[1].linetype is HIDDEN for item in found)
    assert [_ends(item)[0] for item in found[:2]] == [
        pytest.approx([x, BOTTOM], abs=0.3) for x in (LEFT, LEFT + wide)
    ]
    ends = np.array([_ends(item) for item in found[2:]])
    point = LEFT + radius, BOTTOM - height * radius
    corners = (LEFT, BOTTOM), (LEFT + wide, BOTTOM)
    for wanted in ((corners[0], point), (corners[1], point), corners):
        away = np.abs(ends - np.array(wanted)).max(axis=(1, 2))
        assert away.min() < 0.6


def test_a_bottom_that_melts_with_its_tip_is_found(sketch: Sketch) -> None:
    """Both flanks were, and the sides end a little early."""
    wide, height = 34.0, 0.577
    radius = wide / 2.0
    point = LEFT + radius, BOTTOM - height * radius
    corners = np.array([(LEFT, BOTTOM), (LEFT + wide, BOTTOM)])
    flanks: list[Placed] = []
    for x, y in corners:
        long = float(np.hypot(point[0] - x, point[1] - y))
        way = (point[0] - x) / long, (point[1] - y) / long
        flanks.append((Line((x, y), way), Piece(0.0, long, HIDDEN, 0.9)))
    sheet = _bore(sketch, wide, height)
    found = with_drill_tips([*_sides(wide, BOTTOM - 0.8), *flanks], sheet)
    assert len(found) == 5
    ends = np.array([_ends(item) for item in found])
    for wanted in ((corners[0], point), (corners[1], point), corners):
        assert np.abs(ends - np.array(wanted)).max(axis=(1, 2)).min() < 0.6
    assert ends[:2, 0] == pytest.approx(corners, abs=0.3)


def test_what_was_found_is_left_as_it_is(sketch: Sketch) -> None:
    wide, height = 30.0, 0.6
    sheet = _bore(sketch, wide, height)
    found = with_drill_tips(_sides(wide), sheet)
    assert len(found) == 5
    assert with_drill_tips(found, sheet) == found


@pytest.mark.parametrize("wide", [8.0, 24.0])
def test_a_flat_bottom_has_none(sketch: Sketch, wide: float) -> None:
    pieces = _sides(wide)
    assert with_drill_tips(pieces, _bore(sketch, wide, 0.6, tip=False)) == pieces


def test_a_slant_on_one_side_is_none(sketch: Sketch) -> None:
    drawn = sketch(200, 160).line((20, FOOT), (180, FOOT))
    for x in (LEFT, LEFT + 30.0):
        _dashed(drawn, (x, BOTTOM), (x, FOOT))
    drawn.line((LEFT, BOTTOM), (LEFT + 40.0, BOTTOM - 24.0), 2.0)
    assert with_drill_tips(_sides(30.0), clean_sheet(drawn.grey)) == _sides(30.0)


def test_strokes_that_only_cross_a_tip_stay(sketch: Sketch) -> None:
    wide = 30.0
    across = Line((LEFT - 20.0, BOTTOM - 4.0), (1.0, 0.0)), Piece(0.0, 80.0, HIDDEN, 0.9)
    found = with_drill_tips([*_sides(wide), across], _bore(sketch, wide, 0.6))
    assert across in found
