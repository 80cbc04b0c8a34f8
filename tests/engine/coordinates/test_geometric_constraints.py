"""Corners read near lines and circles lie on them afterwards."""

from dataclasses import replace
from math import cos, hypot, pi, sin

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.coordinate_clustering import (
    CircleReading,
    CoordinateReading,
    Snapped,
    snapped,
    with_lone_values,
)
from gaussiancad_core.coordinates.corner_equations import Slant
from gaussiancad_core.coordinates.geometric_constraints import Facet, PlaneReading, adjusted
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle, Line, meetings
from gaussiancad_core.model.axes import Axis

_TOLERANCE = 0.2
_ERROR = st.floats(-0.04, 0.04)
_ANGLE = st.floats(0.0, 2.0 * pi)
_RADIUS = st.floats(5.0, 20.0)


def _snap(readings: list[tuple[Axis, float]], circles: list[CircleReading]) -> Snapped:
    return snapped(
        [CoordinateReading(axis, at, 50.0) for axis, at in readings], circles, _TOLERANCE
    )


@given(st.lists(_ERROR, min_size=8, max_size=8))
def test_the_edge_of_two_chamfers_runs_through_both(errors: list[float]) -> None:
    # A block of 100, chamfered along two of its edges: x + z = 163 in front, y + z = 176 beside.
    # The top view shows their common edge from (63, 76) to (87, 100).
    e = errors
    readings = [(axis, at) for axis in Axis for at in (0.0, 100.0)]
    readings += [(Axis.X, 63.0 + e[0]), (Axis.Y, 76.0 + e[1])]
    readings += [(Axis.Z, 63.0 + e[2]), (Axis.Z, 76.0 + e[3])]
    front = Slant((63.0, 100.0 + e[4]), (100.0, 63.0), 52.0)
    neighbour = Slant((76.0 + e[5], 100.0), (100.0, 76.0), 34.0)
    edge = Slant((63.0, 76.0 + e[6]), (87.0 + e[7], 100.0), 34.0)
    planes = [
        PlaneReading(Axis.Y, (front,), (front.start, front.end, (87.0 + e[6], 76.0))),
        PlaneReading(Axis.X, (neighbour,), (neighbour.start, neighbour.end)),
        PlaneReading(Axis.Z, (edge,), (edge.start, edge.end)),
    ]
    snap = with_lone_values(_snap(readings, []), [CoordinateReading(Axis.X, edge.end[0], 1e-3)])
    found = adjusted(snap, planes, _TOLERANCE)
    lines = {axis: line[0] for axis, line in found.lines.items()}
    for t in (0.0, 0.4, 1.0):
        z = 76.0 + 24.0 * t
        ((x, _),) = meetings(lines[Axis.Y], Line((0.0, z), (1.0, 0.0)))
        ((y, _),) = meetings(lines[Axis.X], Line((0.0, z), (1.0, 0.0)))
        assert lines[Axis.Z].distance((x, y)) < 1e-7
    for axis, value in snap.values.items():
        assert found.snap.values[axis] == pytest.approx(value, abs=_TOLERANCE)


@given(_RADIUS, _ERROR, _ERROR, st.floats(0.5, 1.15))
def test_the_edge_of_a_flat_on_a_cylinder_is_where_they_meet(
    radius: float, wide: float, high: float, share: float
) -> None:
    x = radius * cos(share)
    z = radius * sin(share)
    readings = [(Axis.X, x + wide), (Axis.Z, z + high)]
    circle = CircleReading(Axis.Y, Circle((0.0, 0.0), radius), 1e4)
    snap = _snap(readings, [circle])
    plane = PlaneReading(Axis.Y, (), ((x, z),))
    found = adjusted(snap, [plane], _TOLERANCE).snap
    ((_, item),) = found.circles
    corner = found.values[Axis.X][0], found.values[Axis.Z][0]
    assert item.distance(corner) < 1e-7
    assert hypot(corner[0] - x, corner[1] - z) < 0.1


@given(st.tuples(_RADIUS, _RADIUS), _ANGLE, st.booleans(), st.booleans(), st.tuples(_ERROR, _ERROR))
def test_a_rough_common_tangent_becomes_an_exact_one(
    radii: tuple[float, float],
    angle: float,
    outer: bool,
    flip: bool,
    errors: tuple[float, float],
) -> None:
    first, second = radii
    away = first + second + 25.0
    one = Circle((5.0, -3.0), first)
    other = Circle((5.0 + away * cos(angle), -3.0 + away * sin(angle)), second)
    side = -1.0 if flip else 1.0
    start, end = _touching(one, other, (side, side if outer else -side))
    along = np.subtract(end, start) / hypot(*np.subtract(end, start))
    assume(min(abs(along)) > 0.02)
    ends = [
        (point[0] - error * along[1], point[1] + error * along[0])
        for point, error in zip((start, end), errors, strict=True)
    ]
    slant = Slant(ends[0], ends[1], 1.0)
    circles = [CircleReading(Axis.Y, circle, 1e4) for circle in (one, other)]
    plane = PlaneReading(Axis.Y, (slant,), tuple(ends))
    found = adjusted(_snap([], circles), [plane], _TOLERANCE)
    (line,) = found.lines[Axis.Y]
    for _, circle in found.snap.circles:
        assert line.distance(circle.centre) == pytest.approx(circle.radius, abs=1e-7)


@given(st.tuples(_RADIUS, _RADIUS), _ANGLE, st.booleans(), st.tuples(_ERROR, _ERROR, _ERROR))
def test_arcs_that_pass_smoothly_into_each_other_touch(
    radii: tuple[float, float], angle: float, inside: bool, errors: tuple[float, float, float]
) -> None:
    first, second = radii
    assume(not inside or first > second + 4.0)
    away = (first - second if inside else first + second) + errors[2]
    one = Circle((5.0, -3.0), first)
    centre = 5.0 + away * cos(angle) + errors[0], -3.0 + away * sin(angle) + errors[1]
    circles = [CircleReading(Axis.Y, circle, 10.0) for circle in (one, Circle(centre, second))]
    plane = PlaneReading(Axis.Y, (), (one.at(angle),))
    found = adjusted(_snap([], circles), [plane], _TOLERANCE).snap
    (_, large), (_, small) = found.circles
    between = hypot(large.centre[0] - small.centre[0], large.centre[1] - small.centre[1])
    sizes = large.radius, small.radius
    assert between == pytest.approx(abs(sizes[0] - sizes[1]) if inside else sum(sizes), abs=1e-7)


def _touching(one: Circle, other: Circle, sides: tuple[float, float]) -> tuple[Point, Point]:
    """Touching points of a common tangent with normal n: n . c = d + side r for both circles."""
    dx, dy = other.centre[0] - one.centre[0], other.centre[1] - one.centre[1]
    away = hypot(dx, dy)
    first, second = sides[0] * one.radius, sides[1] * other.radius
    cosine = (second - first) / away
    sine = (1.0 - cosine**2) ** 0.5
    normal = (cosine * dx - sine * dy) / away, (cosine * dy + sine * dx) / away
    return (
        (one.centre[0] - first * normal[0], one.centre[1] - first * normal[1]),
        (other.centre[0] - second * normal[0], other.centre[1] - second * normal[1]),
    )


def test_a_corner_is_on_a_circle_only_where_it_is_drawn() -> None:
    """A bore's wall ends where a round end would go on, had the part no flat sides."""
    circle = Circle((50.0, 50.0), 50.0)
    x, z = 50.0 - 50.0 * sin(0.7) + 0.3 * _TOLERANCE, 50.0 + 50.0 * cos(0.7)
    snap = _snap([(Axis.X, x), (Axis.Z, z)], [CircleReading(Axis.Y, circle, 1e4)])
    low = PlaneReading(Axis.Y, (), ((x, z),), ((circle, pi, pi),))
    assert adjusted(snap, [low], _TOLERANCE).snap.values == snap.values
    around = replace(low, arcs=((circle, pi, pi), (circle, 0.0, pi / 2.0 + 0.7)))
    found = adjusted(snap, [around], _TOLERANCE).snap
    assert found.values != snap.values
    ((_, item),) = found.circles
    assert item.distance((found.values[Axis.X][0], found.values[Axis.Z][0])) < 1e-7


def test_a_corner_that_only_passes_by_is_left() -> None:
    snap = _snap([(Axis.X, 50.0), (Axis.Z, 50.5)], [])
    slant = Slant((0.0, 0.0), (100.0, 100.0), 141.0)
    plane = PlaneReading(Axis.Y, (slant,), ((50.0, 50.5),))
    found = adjusted(snap, [plane], _TOLERANCE)
    assert found.snap.values == snap.values
    assert found.lines[Axis.Y][0].distance((30.0, 30.0)) < 1e-12


@given(st.lists(_ERROR, min_size=12, max_size=12))
def test_corners_of_a_facet_lie_on_one_plane(errors: list[float]) -> None:
    # A quadrilateral on x + y + z = 150.
    corners = np.array(
        [[10.0, 60.0, 80.0], [60.0, 10.0, 80.0], [70.0, 40.0, 40.0], [30.0, 90.0, 30.0]]
    )
    read = corners + np.array(errors).reshape(4, 3)
    snap = _snap([(axis, float(x)) for row in read for axis, x in zip(Axis, row, strict=True)], [])
    off = np.array([1.01, 0.99, 1.0])
    facet = Facet(tuple((off / np.linalg.norm(off)).tolist()), tuple(map(tuple, read.tolist())))
    found = adjusted(snap, [], _TOLERANCE, [facet]).snap
    moved = np.array(
        [[found.value(axis, x) for axis, x in zip(Axis, row, strict=True)] for row in read]
    )
    assert np.linalg.svd(moved - moved.mean(axis=0))[1][2] < 1e-7
    assert np.abs(moved - read).max() <= _TOLERANCE


def test_the_extents_stay() -> None:
    snap = _snap(
        [(Axis.X, 0.0), (Axis.X, 50.05), (Axis.X, 100.0), (Axis.Z, 0.0), (Axis.Z, 100.0)], []
    )
    snap = with_lone_values(snap, [CoordinateReading(Axis.Z, 50.0, 1e-3)])
    slant = Slant((0.0, 0.0), (100.0, 100.0), 141.0)
    ends = (slant.start, slant.end, (50.05, 50.0))
    found = adjusted(snap, [PlaneReading(Axis.Y, (slant,), ends)], _TOLERANCE).snap
    assert found.values[Axis.X][0] == pytest.approx(0.0, abs=1e-6)
    assert found.values[Axis.Z][-1] == pytest.approx(100.0, abs=1e-6)
    assert found.values[Axis.Z][1] == pytest.approx(50.05, abs=0.01)


def test_what_follows_from_rounded_numbers_is_no_multiple_of_their_step() -> None:
    # A flat 20 off the axis of a cylinder of radius 32 ends at 36 +- 24.98: near a multiple of .5.
    half = (32.0**2 - 20.0**2) ** 0.5
    circles = [CircleReading(Axis.X, Circle((36.01, 36.0), r), 6.0 * r) for r in (32.01, 36.0)]
    readings = [(axis, at) for axis in (Axis.Y, Axis.Z) for at in (0.0, 72.0)]
    readings += [(Axis.X, 4.5 * k) for k in range(22)] + [(Axis.X, 100.0)]
    # Two views show the flat, one the edges at which it ends.
    readings += [(Axis.Y, 56.01), (Axis.Y, 56.01), (Axis.Z, 36.0 - half), (Axis.Z, 36.0 + half)]
    snap = _snap(readings, circles)
    assert snap.values[Axis.Y] == pytest.approx((0.0, 56.0, 72.0), abs=1e-9)
    assert snap.values[Axis.Z] == pytest.approx((0.0, 11.0, 61.0, 72.0), abs=1e-9)
    ends = (56.0, 36.0 - half), (56.0, 36.0 + half)
    found = adjusted(snap, [PlaneReading(Axis.X, (), ends)], _TOLERANCE).snap
    assert found.values[Axis.Y] == pytest.approx((0.0, 56.0, 72.0), abs=1e-6)
    assert found.values[Axis.Z] == pytest.approx((0.0, 36.0 - half, 36.0 + half, 72.0), abs=1e-6)
    for (_, circle), radius in zip(found.circles, (36.0, 32.0), strict=True):
        assert (*circle.centre, circle.radius) == pytest.approx((36.0, 36.0, radius), abs=1e-6)


def test_what_a_plane_shows_moves_as_a_whole() -> None:
    slant = Slant((1.0, 2.0), (5.0, 7.0), 3.0)
    circle = Circle((4.0, 6.0), 2.0)
    shown = PlaneReading(Axis.Y, (slant,), ((1.0, 2.0), (9.0, 9.0)), ((circle, 0.5, 1.5),))
    assert shown.moved(0.5, -1.0) == PlaneReading(
        Axis.Y,
        (Slant((1.5, 1.0), (5.5, 6.0), 3.0),),
        ((1.5, 1.0), (9.5, 8.0)),
        ((Circle((4.5, 5.0), 2.0), 0.5, 1.5),),
    )
    assert shown.moved(0.0, 0.0) == shown
