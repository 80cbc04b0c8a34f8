"""Which strokes of a file lie so far from all others that they are none of the drawing."""

import itertools

import numpy as np
import pytest

from gaussiancad_core.files.far_strokes import near_numbers
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import FULL_TURN


def _box(x: float, y: float, w: float, h: float) -> list[LineSegment]:
    corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]
    return [LineSegment(start, end) for start, end in itertools.pairwise(corners)]


PART = [*_box(20.0, 20.0, 60.0, 40.0), *_box(20.0, 80.0, 60.0, 25.0)]


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e6])
@pytest.mark.parametrize("place", [(1e4, 1e4), (-1e9, 0.0), (0.0, 1e300), (np.nan, 1.0)])
def test_a_far_stroke_is_none_of_the_drawing(scale: float, place: tuple[float, float]) -> None:
    near = [LineSegment(_scaled(line.start, scale), _scaled(line.end, scale)) for line in PART]
    x, y = _scaled(place, scale)
    far = LineSegment((x, y), (x + scale, y))
    assert near_numbers([far, *near]).tolist() == list(range(1, len(near) + 1))


def test_what_goes_through_a_drawing_or_around_it_is_none_where_it_is_endless() -> None:
    endless = [LineSegment((0.0, 30.0), (1e7, 30.0)), CircularArc((0.0, 0.0), 1e7, 0.0, FULL_TURN)]
    assert near_numbers([*PART, *endless]).tolist() == list(range(len(PART)))


def test_several_far_strokes_are_told_together() -> None:
    far = [*_box(1e5, 1e5, 60.0, 40.0)[:3], *_box(-1e7, 1e5, 60.0, 40.0)[:3]]
    assert near_numbers([*far, *PART]).tolist() == list(range(6, 6 + len(PART)))


@pytest.mark.parametrize("at", [30.0, 2970.0])
def test_a_long_bar_around_one_small_hole_stays_whole(at: float) -> None:
    turns = np.linspace(0.0, FULL_TURN, 101)
    places = np.stack([at + 2.0 * np.cos(turns), 30.0 + 2.0 * np.sin(turns)], axis=1)
    ends = [(float(x), float(y)) for x, y in places]
    hole = [LineSegment(start, end) for start, end in itertools.pairwise(ends)]
    bar = _box(0.0, 0.0, 6000.0, 60.0)
    assert len(near_numbers([*bar, *hole])) == len(bar) + len(hole)


def test_drawings_beside_each_other_are_one_sheet() -> None:
    drawings = [line for column in range(20) for line in _box(300.0 * column, 0.0, 60.0, 40.0)]
    assert len(near_numbers(drawings)) == len(drawings)


def test_strokes_in_one_place_are_a_drawing() -> None:
    assert near_numbers([]).tolist() == []
    dot = LineSegment((5.0, 5.0), (5.0, 5.0))
    assert len(near_numbers([dot, dot, *PART])) == 2 + len(PART)
    assert len(near_numbers(PART[:1])) == 1


def _scaled(point: tuple[float, float], by: float) -> tuple[float, float]:
    return point[0] * by, point[1] * by
