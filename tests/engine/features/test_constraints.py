"""Constraints fix a sketch fully, and nothing twice."""

from itertools import pairwise
from math import cos, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.tasks.feature_sketches import Freedom, freedom, solved
from gaussiancad_core.features.constraints import (
    Constraint,
    Kind,
    Numbers,
    NumberSource,
    constraints_of,
)
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.geometry.outline_edges import OutlineEdge, enclosed_area, whole_circle
from gaussiancad_core.geometry.points import Point, to_point
from gaussiancad_core.geometry.whole_curves import Circle


def _polygon(*corners: Point) -> Loop:
    return tuple(OutlineEdge(*ends) for ends in pairwise([*corners, corners[0]]))


def _circle(centre: Point, radius: float) -> Loop:
    return (whole_circle(Circle(centre, radius)),)


def _slot(at: Point, length: float, radius: float, degrees: float) -> Loop:
    """Two lines and two half circles."""
    along = np.array([cos(radians(degrees)), sin(radians(degrees))])
    side = radius * np.array([-along[1], along[0]])
    low, high = np.array(at), np.array(at) + length * along
    corners = [tuple(map(float, p)) for p in (low - side, high - side, high + side, low + side)]
    ends = [tuple(map(float, p)) for p in (high, low)]
    return (
        OutlineEdge(corners[0], corners[1]),
        OutlineEdge(corners[1], corners[2], Circle(ends[0], radius)),
        OutlineEdge(corners[2], corners[3]),
        OutlineEdge(corners[3], corners[0], Circle(ends[1], radius)),
    )


@st.composite
def _outlines(draw: st.DrawFn) -> tuple[Loop, ...]:
    """A star of corners around the origin, of which some are on a grid; some of its edges bulge;
    circles and slots in it."""
    count = draw(st.integers(3, 9))
    reaches = draw(st.lists(st.sampled_from([30.0, 40.0, 52.5]), min_size=count, max_size=count))
    grid = draw(st.sampled_from([None, 5.0]))
    corners: list[Point] = []
    for k, reach in enumerate(reaches):
        angle = 2.0 * pi * (k + 0.13) / count
        x, y = reach * cos(angle) + 3.0, reach * sin(angle) - 2.0
        corners.append((x, y) if grid is None else (grid * round(x / grid), grid * round(y / grid)))
    edges = []
    for start, end in pairwise([*corners, corners[0]]):
        bulge = draw(st.sampled_from([0.0, 0.0, 0.8, 2.0]))
        edges.append(_bulging(start, end, bulge) if bulge else OutlineEdge(start, end))
    loops: list[Loop] = [tuple(edges)]
    for k in range(draw(st.integers(0, 3))):
        loops.append(_circle((-8.0 + 7.0 * k, draw(st.sampled_from([0.0, 1.5]))), 2.0 + k % 2))
    if draw(st.booleans()):
        loops.append(_slot((-4.0, 8.0), 9.0, 2.0, draw(st.sampled_from([0.0, 30.0, 90.0]))))
    return tuple(loops)


def _bulging(start: Point, end: Point, height: float) -> OutlineEdge:
    """An arc whose centre lies on the left of its chord, so many chords away."""
    a, b = np.array(start), np.array(end)
    middle, chord = (a + b) / 2.0, b - a
    centre = middle + height * np.array([-chord[1], chord[0]])
    return OutlineEdge(start, end, Circle(to_point(centre), float(np.linalg.norm(a - centre))))


@settings(max_examples=50)
@given(_outlines())
def test_nothing_is_free_nor_fixed_twice_and_the_outlines_are_what_is_demanded(
    loops: tuple[Loop, ...],
) -> None:
    constraints = constraints_of(loops, Numbers())
    assert freedom(loops, constraints) == Freedom(0, 0)
    for number in range(0, len(constraints), 5):
        rest = [each for k, each in enumerate(constraints) if k != number]
        assert freedom(loops, rest).left > 0
    again = solved(loops, constraints)
    assert sum(map(enclosed_area, again)) == pytest.approx(sum(map(enclosed_area, loops)), abs=1e-5)


def test_equal_circles_in_a_row_have_one_diameter() -> None:
    loops = [_circle((10.0 + 15.0 * k, 5.0), 3.0) for k in range(4)]
    kinds = [each.kind for each in constraints_of(loops, Numbers())]
    assert kinds.count(Kind.DIAMETER) == 1 and kinds.count(Kind.EQUAL) == 3
    assert kinds.count(Kind.DISTANCE_Y) == 1 and kinds.count(Kind.HORIZONTAL) == 3


def test_circles_about_one_centre_are_concentric() -> None:
    found = constraints_of([_circle((7, 9), 5.0), _circle((7, 9), 3.0)], Numbers())
    assert [each.kind for each in found].count(Kind.COINCIDENT) == 1


def test_edges_that_go_on_in_each_other_are_tangent() -> None:
    found = constraints_of([_slot((3, 4), 20.0, 5.0, 30.0)], Numbers())
    # The last joint's tangency follows from the others.
    assert [each.kind for each in found].count(Kind.TANGENT) >= 3
    assert freedom([_slot((3, 4), 20.0, 5.0, 30.0)], found) == Freedom(0, 0)


def test_edges_that_meet_at_an_angle_are_not_tangent() -> None:
    loop = (
        OutlineEdge((0, 0), (10, 0)),
        _bulging((10, 0), (0, 10), 0.7),
        OutlineEdge((0, 10), (0, 0)),
    )
    assert Kind.TANGENT not in [each.kind for each in constraints_of([loop], Numbers())]


def _distances(found: tuple[Constraint, ...]) -> list[tuple[float, NumberSource]]:
    return sorted(
        (round(each.value, 6), each.source)
        for each in found
        if each.value is not None and each.source is not None
    )


def test_numbers_of_the_sheet_are_preferred() -> None:
    loops = [_polygon((0, 0), (60, 0), (60, 40), (0, 40)), _circle((42, 25), 4.0)]
    plain = _distances(constraints_of(loops, Numbers()))
    assert plain == [(value, NumberSource.MEASURED) for value in (8.0, 25.0, 40.0, 42.0, 60.0)]
    # The drawing dimensions the hole from the right and from above.
    found = _distances(constraints_of(loops, Numbers((60.0, 40.0, 18.0, 15.0, 8.0))))
    assert found == [(value, NumberSource.SHEET) for value in (8.0, 15.0, 18.0, 40.0, 60.0)]


def test_a_radius_on_the_sheet_is_a_radius() -> None:
    loop = (_bulging((0, 0), (20, 0), 0.5), OutlineEdge((20, 0), (0, 0)))
    radius = loop[0].circle.radius
    assert radius is not None
    for number, kind in ((radius, Kind.RADIUS), (2.0 * radius, Kind.DIAMETER)):
        kinds = {each.kind: each.source for each in constraints_of([loop], Numbers((number,)))}
        assert kinds[kind] is NumberSource.SHEET


@pytest.mark.parametrize("number", [59.998, 60.0, 60.0009])
def test_a_number_is_near_its_measure(number: float) -> None:
    source = Numbers((number,), near=1e-3).source_of(-60.0)
    near = abs(number - 60.0) <= 1e-3
    assert source is (NumberSource.SHEET if near else NumberSource.MEASURED)
