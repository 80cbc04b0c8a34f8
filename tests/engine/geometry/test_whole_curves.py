"""Lines and circles: their parameters, positions, distances, and the points that they share."""

from math import cos, hypot, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.geometry.points import FULL_TURN, Point
from gaussiancad_core.geometry.whole_curves import (
    Circle,
    Line,
    LineOrCircle,
    line_through,
    meetings,
)

_FAR = st.floats(-1e4, 1e4)
_TURN = st.floats(-np.pi, np.pi)
_COORDINATE = st.floats(-100.0, 100.0)
_POINT = st.tuples(_COORDINATE, _COORDINATE)
_RADIUS = st.floats(0.05, 100.0)
_CIRCLE = st.builds(Circle, _POINT, _RADIUS)
_ANGLE = st.floats(0.0, FULL_TURN, exclude_max=True)


def _directed(point: Point, angle: float) -> Line:
    x, y = point
    return line_through(point, (x + 10.0 * cos(angle), y + 10.0 * sin(angle)))


_LINE = st.builds(_directed, _POINT, _ANGLE)
_CURVE = st.one_of(_LINE, _CIRCLE)


def _gap(one: Point, other: Point) -> float:
    return hypot(one[0] - other[0], one[1] - other[1])


@given(_CURVE, _CURVE)
def test_meetings_lie_on_both_curves_in_either_order(
    one: LineOrCircle, other: LineOrCircle
) -> None:
    found, again = meetings(one, other), meetings(other, one)
    assert len(found) == len(again)
    lines = isinstance(one, Line) + isinstance(other, Line)
    assert len(found) <= (1 if lines == 2 else 2)
    # A touching counts as met from a micrometre of the part's hundredth, a chord from twice 1e-3.
    for point in found:
        far = max(1.0, *map(abs, point))
        assert one.distance(point) <= 2e-6 + 1e-8 * far
        assert other.distance(point) <= 2e-6 + 1e-8 * far
        assert min(_gap(point, twin) for twin in again) <= 1e-6 + 1e-8 * far


@given(_POINT, _ANGLE, _ANGLE)
def test_lines_through_a_point_meet_there(point: Point, one: float, other: float) -> None:
    found = meetings(_directed(point, one), _directed(point, other))
    if abs(sin(one - other)) > 1e-4:
        assert len(found) == 1 and _gap(found[0], point) < 1e-6
    if one == other:
        assert found == []


@given(_CIRCLE, _ANGLE, st.floats(-1.5, 1.5))
def test_a_line_meets_a_circle_as_its_distance_says(
    circle: Circle, angle: float, share: float
) -> None:
    away = share * circle.radius
    x, y = circle.centre
    foot = x - away * sin(angle), y + away * cos(angle)
    found = meetings(_directed(foot, angle), circle)
    beyond = abs(away) - circle.radius
    # Lines that are all but parallel to an axis are made so, which moves them a little.
    if beyond > 1e-4:
        assert found == []
    elif beyond < -1e-4:
        assert len(found) == 2
        half = np.sqrt(circle.radius**2 - away**2)
        assert _gap(*found) == pytest.approx(2.0 * half, rel=1e-3)


@given(_CIRCLE, _ANGLE, _RADIUS, st.booleans())
def test_circles_touch_once_from_outside_and_inside(
    circle: Circle, angle: float, radius: float, inside: bool
) -> None:
    away = abs(circle.radius - radius) if inside else circle.radius + radius
    if away < 0.1:
        return
    flip = pi if inside and radius > circle.radius else 0.0
    x, y = circle.centre
    other = Circle((x + away * cos(angle + flip), y + away * sin(angle + flip)), radius)
    (found,) = meetings(circle, other)
    assert _gap(found, circle.at(angle)) < 2e-3


@given(_CIRCLE, _CIRCLE)
def test_circles_meet_as_their_distance_says(one: Circle, other: Circle) -> None:
    away = _gap(one.centre, other.centre)
    near, far = abs(one.radius - other.radius), one.radius + other.radius
    found = meetings(one, other)
    if near + 1e-4 < away < far - 1e-4:
        assert len(found) == 2
    elif away > far + 1e-4 or away < near - 1e-4:
        assert found == []


@given(_CURVE, st.floats(0.0, FULL_TURN, exclude_max=True))
def test_a_point_of_a_curve_has_its_parameter(curve: LineOrCircle, parameter: float) -> None:
    point = curve.at(parameter)
    assert curve.distance(point) < 1e-9
    found = curve.parameter(point)
    if isinstance(curve, Circle):
        assert 0.0 <= found <= FULL_TURN
        off = abs(found - parameter)
        assert min(off, FULL_TURN - off) * curve.speed < 1e-9
    else:
        assert found == pytest.approx(parameter, abs=1e-9)


@given(_CURVE, st.floats(0.0, 6.0))
def test_normals_are_unit_and_square_to_the_curve(curve: LineOrCircle, parameter: float) -> None:
    step = 1e-6 / curve.speed
    (x0, y0), (x1, y1) = curve.at(parameter - step), curve.at(parameter + step)
    nx, ny = curve.normal(parameter)
    assert hypot(nx, ny) == pytest.approx(1.0)
    assert abs((x1 - x0) * nx + (y1 - y0) * ny) < 1e-8
    assert hypot(x1 - x0, y1 - y0) == pytest.approx(2.0 * step * curve.speed, rel=1e-2)


@given(_CURVE, _POINT)
def test_distance_is_that_of_the_nearest_sample(curve: LineOrCircle, point: Point) -> None:
    at = curve.parameter(point)
    assert _gap(curve.at(at), point) == pytest.approx(curve.distance(point), abs=1e-9)
    around = at + np.linspace(-1.0, 1.0, 41)
    assert min(_gap(curve.at(t), point) for t in around) >= curve.distance(point) - 1e-9


@given(_POINT, _POINT)
def test_a_line_runs_through_both_points_and_forwards(start: Point, end: Point) -> None:
    if _gap(start, end) < 1e-3:
        return
    line = line_through(start, end)
    dx, dy = line.direction
    assert hypot(dx, dy) == pytest.approx(1.0)
    assert dx > 0.0 or line.direction == (0.0, 1.0)
    # Straightening turns by a millionth of the length at most.
    assert line.distance(start) < 1e-9 and line.distance(end) <= 1.1e-6 * _gap(start, end)
    assert (line.axis is None) == (min(abs(dx), abs(dy)) > 0.0)


def test_a_nearly_upright_line_becomes_upright() -> None:
    assert line_through((3.0, 0.0), (3.0 + 1e-8, 50.0)).axis == 0
    assert line_through((0.0, 3.0), (50.0, 3.0 - 1e-8)).axis == 1
    assert line_through((3.0, 0.0), (3.01, 50.0)).axis is None
    assert Circle((1.0, 2.0), 3.0).axis is None
    # It runs up even if nothing is straightened.
    assert line_through((3.0, 5.0), (3.0, 1.0), 0.0).direction == (0.0, 1.0)
    assert line_through((3.0, 5.0), (-3.0, 5.0), 0.0).direction == (1.0, 0.0)
    assert line_through((3.0, 5.0), (3.0 + 1e-8, 1.0), 0.0).axis is None


@given(_CURVE, _POINT)
def test_scalars_and_arrays_agree(curve: LineOrCircle, point: Point) -> None:
    points = np.array([point])
    assert curve.distances(points) == pytest.approx(curve.distance(point), abs=1e-9)
    (position,) = positions = curve.positions(points)
    parameter = float(position) / curve.speed
    assert curve.points_at(positions)[0] == pytest.approx(curve.at(parameter), abs=1e-9)
    assert _gap(curve.at(parameter), curve.at(curve.parameter(point))) < 1e-9
    (tangent,) = curve.tangents_at(positions)
    assert abs(np.dot(tangent, curve.normal(parameter))) < 1e-9


def _line(x: float, y: float, angle: float) -> Line:
    return Line((x, y), (float(np.cos(angle)), float(np.sin(angle))))


@given(_FAR, _FAR, _TURN, _FAR, _FAR)
def test_coordinates_are_those_of_a_turned_frame(
    x: float, y: float, angle: float, px: float, py: float
) -> None:
    line = _line(x, y, angle)
    along, across = line.coordinates(np.array([[px, py]]))
    dx, dy = line.direction
    back = np.array(line.at(float(along[0]))) + float(across[0]) * np.array([-dy, dx])
    assert back == pytest.approx(np.array([px, py]), abs=1e-8)
    assert line.distances(np.array([[px, py]])) == pytest.approx(abs(across))
