"""Hidden half circles between two parallel lines, and ends of pockets that are none."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.junctions import Placed
from gaussiancad_core.sheet.runs import Piece, Rhythm
from gaussiancad_core.sheet.slot_ends import with_slot_ends
from gaussiancad_core.views import Linetype

Sketch = Any
"""The class that the fixture gives."""

DASH, GAP, WIDTH = 13.0, 5.0, 1.8
RHYTHM = Rhythm(DASH - 1.0, GAP + 1.0)
MIDDLE, TANGENT, LEFT = 80.4, 120.3, 20.0
"""px: level of the slot's axis, where its sides end, and where they begin."""

Path = list[tuple[float, float]]


def _round_end(radius: float, corner: float) -> Path:
    """Points around a slot's end whose two corners are rounded; half a circle if all of it is."""
    angles = np.linspace(0.0, np.pi / 2.0, 60)
    x = TANGENT + corner * np.sin(angles)
    up = radius - corner + corner * np.cos(angles)
    upper = list(zip(x.tolist(), (MIDDLE - up).tolist(), strict=True))
    lower = list(zip(x.tolist(), (MIDDLE + up).tolist(), strict=True))
    return [*upper, *reversed(lower)]


def _dashed(drawn: Sketch, path: Path, first: float) -> None:
    """Dashes along a path, the first of which begins so many px after its start."""
    points = np.array(path)
    ways = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    for start in np.arange(first, ways[-1], DASH + GAP):
        at = np.arange(start, min(start + DASH, ways[-1]), 0.5)
        xs, ys = (np.interp(at, ways, points[:, k]) for k in (0, 1))
        drawn.lines(*zip(xs.tolist(), ys.tolist(), strict=True), width=WIDTH)


def _side(drawn: Sketch, y: float) -> Placed:
    """A dashed side of the slot, as it is read."""
    _dashed(drawn, [(LEFT, y), (TANGENT, y)], 0.0)
    # The last dash of the row ends some px before the tangent.
    end = LEFT + (DASH + GAP) * np.floor((TANGENT - LEFT) / (DASH + GAP)) - GAP
    return Line((0.0, y), (1.0, 0.0)), Piece(LEFT, float(end), Linetype.HIDDEN, 0.9)


def _whole_side(drawn: Sketch, y: float) -> Placed:
    """A side whose last dash ends where it does."""
    _dashed(drawn, [(TANGENT, y), (LEFT, y)], 0.0)
    return Line((0.0, y), (1.0, 0.0)), Piece(LEFT, TANGENT, Linetype.HIDDEN, 0.9)


def _drawn(drawn: Sketch, radius: float) -> list[Placed]:
    return [_side(drawn, MIDDLE - radius), _side(drawn, MIDDLE + radius)]


def _found(drawn: Sketch, sides: list[Placed]) -> list[Placed]:
    return with_slot_ends(sides, clean_sheet(drawn.grey), RHYTHM)


@pytest.mark.parametrize("radius", [9.0, 12.3, 16.2, 24.0])
@pytest.mark.parametrize("first", [0.0, 6.0, 12.0])
def test_a_half_circle_ends_a_slot(sketch: Sketch, radius: float, first: float) -> None:
    drawn = sketch(220, 160)
    sides = _drawn(drawn, radius)
    _dashed(drawn, _round_end(radius, radius), first)
    one, other, (circle, arc) = _found(drawn, sides)
    assert isinstance(circle, Circle)
    assert circle.centre == pytest.approx((TANGENT, MIDDLE), abs=0.3)
    assert circle.radius == pytest.approx(radius, abs=0.1)
    assert arc.linetype is Linetype.HIDDEN
    middle = circle.points_at(np.array([(arc.start + arc.end) / 2.0]))[0]
    assert middle == pytest.approx((TANGENT + radius, MIDDLE), abs=0.5)
    assert arc.end - arc.start == pytest.approx(np.pi * radius, rel=0.01)
    for _, side in (one, other):
        assert side.end == pytest.approx(TANGENT, abs=0.3)


def test_edges_across_a_half_circle_hide_some_of_it(sketch: Sketch) -> None:
    drawn = sketch(220, 160)
    sides = _drawn(drawn, 16.2)
    _dashed(drawn, _round_end(16.2, 16.2), 6.0)
    edge = Line((0.0, MIDDLE + 2.0), (1.0, 0.0)), Piece(10.0, 210.0, Linetype.VISIBLE, 1.0)
    drawn.line((10.0, MIDDLE + 2.0), (210.0, MIDDLE + 2.0), 2.8)
    assert sum(isinstance(geometry, Circle) for geometry, _ in _found(drawn, [*sides, edge])) == 1


@pytest.mark.parametrize("first", [0.0, 6.0, 12.0])
@pytest.mark.parametrize(("radius", "corner"), [(9.0, 0.1), (16.2, 0.1), (16.2, 8.0), (24.0, 14.0)])
def test_a_pocket_with_two_corners_is_none(
    sketch: Sketch, radius: float, corner: float, first: float
) -> None:
    drawn = sketch(220, 160)
    sides = _drawn(drawn, radius)
    _dashed(drawn, _round_end(radius, corner), first)
    assert _found(drawn, sides) == sides


@pytest.mark.parametrize("first", [0.0, 6.0, 12.0])
@pytest.mark.parametrize("radius", [7.0, 9.0, 12.3, 16.2, 24.0])
@pytest.mark.parametrize("degrees", [30.0, 31.0, 45.0])
def test_the_tip_of_a_drill_is_none(
    sketch: Sketch, radius: float, degrees: float, first: float
) -> None:
    drawn = sketch(220, 160)
    sides = [_whole_side(drawn, MIDDLE - radius), _whole_side(drawn, MIDDLE + radius)]
    tip = TANGENT + radius * float(np.tan(np.radians(degrees))), MIDDLE
    _dashed(drawn, [(TANGENT, MIDDLE - radius), tip, (TANGENT, MIDDLE + radius)], first)
    assert _found(drawn, sides) == sides


def test_two_lines_that_end_in_nothing_are_none(sketch: Sketch) -> None:
    drawn = sketch(220, 160)
    sides = _drawn(drawn, 12.3)
    assert _found(drawn, sides) == sides
