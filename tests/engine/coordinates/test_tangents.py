"""Lines that were read nearly tangent to circles."""

from math import cos, hypot, pi, sin

from hypothesis import assume, given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.tangents import touched_circles, touching_circles
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle, line_through

_ANGLE = st.floats(0.0, 2.0 * pi)
_RADIUS = st.floats(2.0, 20.0)
_ERROR = st.floats(-0.05, 0.05)
_REACH = 0.2


def _assume_not_straightened(start: Point, end: Point) -> None:
    """Lines within a millionth of an axis become parallel to it, which is another matter."""
    dx, dy = line_through(start, end, 0.0).direction
    assume(all(abs(part) < 1e-12 or abs(part) > 2e-6 for part in (dx, dy)))


def _ends(one: Circle, other: Circle, sides: tuple[float, float]) -> tuple[Point, Point]:
    """Touching points of a common tangent with normal n: n . c = d + side r for both circles."""
    dx, dy = other.centre[0] - one.centre[0], other.centre[1] - one.centre[1]
    away = hypot(dx, dy)
    first, second = sides[0] * one.radius, sides[1] * other.radius
    cosine = (second - first) / away
    sine = (1.0 - cosine**2) ** 0.5
    ux, uy = dx / away, dy / away
    normal = cosine * ux - sine * uy, cosine * uy + sine * ux
    return (
        (one.centre[0] - first * normal[0], one.centre[1] - first * normal[1]),
        (other.centre[0] - second * normal[0], other.centre[1] - second * normal[1]),
    )


@given(st.tuples(_RADIUS, _RADIUS), _ANGLE, st.booleans(), st.booleans(), st.tuples(_ERROR, _ERROR))
def test_a_rough_common_tangent_touches_both(
    radii: tuple[float, float],
    angle: float,
    outer: bool,
    flip: bool,
    errors: tuple[float, float],
) -> None:
    (first, second), (low, high) = radii, errors
    away = first + second + 25.0
    one = Circle((5.0, -3.0), first)
    other = Circle((5.0 + away * cos(angle), -3.0 + away * sin(angle)), second)
    side = -1.0 if flip else 1.0
    start, end = _ends(one, other, (side, side if outer else -side))
    _assume_not_straightened(start, end)
    exact = line_through(start, end, 0.0)
    nx, ny = exact.normal(0.0)
    read = (
        (start[0] + low * nx, start[1] + low * ny),
        (end[0] + high * nx, end[1] + high * ny),
    )
    found = touched_circles(line_through(*read, 0.0), read, [one, other], _REACH)
    assert found == (one, other)


@given(_RADIUS, _ANGLE, st.floats(10.0, 60.0), _ERROR, st.booleans())
def test_an_end_that_touches_nothing_is_told(
    radius: float, angle: float, length: float, error: float, swap: bool
) -> None:
    circle = Circle((1.0, 2.0), radius)
    touch = circle.at(angle)
    nx, ny = circle.normal(angle)
    free = touch[0] - length * ny, touch[1] + length * nx
    _assume_not_straightened(touch, free)
    read = (touch[0] + error * nx, touch[1] + error * ny)
    ends = (free, read) if swap else (read, free)
    found = touched_circles(line_through(*ends, 0.0), ends, [circle], _REACH)
    assert found == ((None, circle) if swap else (circle, None))


@given(_RADIUS, _ANGLE, st.floats(0.5, 10.0))
def test_a_line_that_misses_by_more_is_no_tangent(radius: float, angle: float, miss: float) -> None:
    circle = Circle((0.0, 0.0), radius)
    nx, ny = circle.normal(angle)
    x, y = circle.at(angle)
    start = x + miss * nx, y + miss * ny
    ends = start, (start[0] - 30.0 * ny, start[1] + 30.0 * nx)
    assert touched_circles(line_through(*ends, 0.0), ends, [circle], _REACH) == (None, None)


@given(_RADIUS, _ANGLE)
def test_a_line_that_touches_far_from_its_ends_is_left(radius: float, angle: float) -> None:
    circle = Circle((0.0, 0.0), radius)
    nx, ny = circle.normal(angle)
    x, y = circle.at(angle)
    half = 40.0
    ends = (x + half * ny, y - half * nx), (x - half * ny, y + half * nx)
    assert touched_circles(line_through(*ends, 0.0), ends, [circle], _REACH) == (None, None)


def test_the_nearer_of_two_circles_is_touched() -> None:
    ends = (0.0, 10.02), (50.0, 10.0)
    near, far = Circle((0.0, 0.0), 10.0), Circle((0.0, 0.0), 9.9)
    found = touched_circles(line_through(*ends), ends, [far, near], _REACH)
    assert found == (near, None)


def test_one_circle_is_touched_once() -> None:
    circle, ends = Circle((0.0, 0.0), 10.0), ((-1.0, 10.0), (1.0, 10.0))
    assert touched_circles(line_through(*ends), ends, [circle], _REACH) == (circle, None)


@given(_RADIUS, _RADIUS, _ANGLE, st.booleans(), _ERROR)
def test_circles_touch_where_an_end_lies_on_both(
    one: float, other: float, angle: float, inside: bool, error: float
) -> None:
    assume(not inside or one > other + 3.0)
    away = (one - other if inside else one + other) + error
    first = Circle((5.0, -3.0), one)
    second = Circle((5.0 + away * cos(angle), -3.0 + away * sin(angle)), other)
    end = first.at(angle)
    ((larger, smaller, lies_inside),) = touching_circles([first, second], [end], _REACH)
    assert {larger, smaller} == {first, second} and larger.radius >= smaller.radius
    assert lies_inside == inside
    assert not [*touching_circles([first, second], [first.at(angle + pi)], _REACH)]
    assert not [*touching_circles([first, second], [], _REACH)]
