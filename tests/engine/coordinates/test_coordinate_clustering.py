"""Readings of one coordinate or circle become equal, and tangencies hold."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.coordinate_clustering import (
    CircleReading,
    CoordinateReading,
    snapped,
    with_lone_values,
)
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import UNITS

_TOLERANCE = 0.1
_ERROR = st.floats(-0.04, 0.04)
"""Readings of one value differ by less than the tolerance."""

_LEVELS = st.lists(st.integers(0, 100), min_size=1, max_size=6, unique=True)


def _circle(x: float, y: float, radius: float, normal: Axis = Axis.Y) -> CircleReading:
    return CircleReading(normal, Circle((x, y), radius), radius)


@given(_LEVELS, st.lists(st.tuples(_ERROR, st.floats(0.1, 100.0)), min_size=1, max_size=4))
def test_readings_of_a_value_become_their_weighted_mean(
    levels: list[int], errors: list[tuple[float, float]]
) -> None:
    readings = [
        CoordinateReading(Axis.X, level + off, weight) for level in levels for off, weight in errors
    ]
    snap = snapped(readings, [], _TOLERANCE)
    offs, weights = zip(*errors, strict=True)
    mean = float(np.average(offs, weights=weights))
    assert snap.values[Axis.X] == pytest.approx([level + mean for level in sorted(levels)])
    assert snap.values[Axis.Y] == snap.values[Axis.Z] == ()
    for reading in readings:
        value = snap.value(Axis.X, reading.value)
        assert value in snap.values[Axis.X]
        assert abs(value - reading.value) <= _TOLERANCE


@given(_LEVELS, _LEVELS)
def test_exact_readings_stay_what_they_are(xs: list[int], ys: list[int]) -> None:
    readings = [CoordinateReading(Axis.X, float(x), 5.0) for x in xs]
    readings += [CoordinateReading(Axis.Z, float(y), 5.0) for y in ys]
    circles = [_circle(10.0, 20.0, 5.0), _circle(10.0, 20.0, 8.0), _circle(40.0, 20.0, 5.0)]
    snap = snapped(readings, circles, _TOLERANCE)
    assert snap.values[Axis.X] == tuple(map(float, sorted(xs)))
    assert snap.values[Axis.Z] == tuple(map(float, sorted(ys)))
    assert {c for _, c in snap.circles} == {c.circle for c in circles}


@given(_ERROR, _ERROR, _ERROR, _ERROR, _ERROR)
def test_a_cylinders_extremes_touch_the_values_that_other_views_show(
    x: float, z: float, radius: float, low: float, high: float
) -> None:
    readings = [
        CoordinateReading(Axis.X, 20.0 + low, 30.0),
        CoordinateReading(Axis.X, 40.0 + high, 30.0),
        CoordinateReading(Axis.Z, 50.0, 100.0),
    ]
    snap = snapped(readings, [_circle(30.0 + x, 40.0 + z, 10.0 + radius)], _TOLERANCE)
    ((normal, circle),) = snap.circles
    assert normal is Axis.Y
    left, right = snap.values[Axis.X]
    # Within the tolerance of each other they are one; farther off they are let be.
    if abs((30.0 + x) - (10.0 + radius) - (20.0 + low)) < 0.099:
        assert circle.centre[0] - circle.radius == pytest.approx(left, abs=1e-9)
    if abs((30.0 + x) + (10.0 + radius) - (40.0 + high)) < 0.099:
        assert circle.centre[0] + circle.radius == pytest.approx(right, abs=1e-9)
    (top,) = snap.values[Axis.Z]
    if abs(z + radius) < 0.099:
        assert circle.centre[1] + circle.radius == pytest.approx(top, abs=1e-9)
    moved = [
        circle.centre[0] - 30.0 - x,
        circle.centre[1] - 40.0 - z,
        circle.radius - 10.0 - radius,
    ]
    assert max(map(abs, moved)) <= 2.5 * _TOLERANCE


@given(_ERROR, _ERROR, _ERROR)
def test_arcs_of_one_circle_are_one(x: float, y: float, radius: float) -> None:
    circles = [_circle(30.0, 40.0, 10.0), _circle(30.0 + x, 40.0 + y, 10.0 + radius)]
    snap = snapped([], circles, _TOLERANCE)
    ((_, circle),) = snap.circles
    assert all(snap.circle(Axis.Y, reading.circle) is circle for reading in circles)
    assert snap.circle(Axis.Z, circles[0].circle) is None
    assert snap.circle(Axis.Y, Circle((30.0, 40.0), 11.0)) is None


def test_circles_of_one_axis_in_two_planes_share_its_coordinate() -> None:
    # The front shows (x, z), the top (x, y): both tell the x of the bores' axes.
    circles = [_circle(30.02, 40.0, 10.0), _circle(29.98, 15.0, 5.0, Axis.Z)]
    snap = snapped([], circles, _TOLERANCE)
    (one, other) = (circle for _, circle in snap.circles)
    assert one.centre[0] == pytest.approx(other.centre[0], abs=1e-12)
    assert 29.98 < one.centre[0] < 30.02


def test_a_heavy_reading_moves_less() -> None:
    readings = [CoordinateReading(Axis.X, 0.0, 1000.0), CoordinateReading(Axis.X, 0.08, 1.0)]
    snap = snapped(readings, [], _TOLERANCE)
    assert snap.values[Axis.X] == (pytest.approx(0.08 / 1001.0),)


def test_measures_that_a_file_rounds_are_those_that_were_meant() -> None:
    """A part of 142 mm in a file that has pixels to four places."""
    millimetre = UNITS / 142.0
    random = np.random.default_rng(3)
    meant = (8.0, 16.0, 23.5, 40.0, 71.0, 95.5, 118.0, 130.0)
    odd = 52.0 + 4.0 / 3.0
    readings = [
        CoordinateReading(Axis.X, at * millimetre + random.uniform(-7e-6, 7e-6), 10.0)
        for at in (*meant, odd)
    ]
    snap = snapped(readings, [], 0.0036, millimetre=millimetre)
    values = np.array(snap.values[Axis.X]) / millimetre
    assert np.abs(values[:, None] - np.array(meant)).min(axis=0).max() < 1e-12
    assert 1e-12 < np.abs(values - odd).min() < 2e-5


def test_what_is_farther_than_the_tolerance_stays_apart() -> None:
    readings = [CoordinateReading(Axis.X, value, 1.0) for value in (0.0, 0.11)]
    snap = snapped(readings, [], _TOLERANCE)
    assert snap.values[Axis.X] == (0.0, 0.11)
    assert snap.value(Axis.X, 0.04) == 0.0
    assert snap.value(Axis.X, 0.5) is None
    assert snap.value(Axis.Y, 0.0) is None


def test_tiny_circles_are_not_told_by_their_extremes() -> None:
    # A radius of three tolerances: its extremes may be taken for the centre's own value.
    readings = [CoordinateReading(Axis.X, 10.32, 50.0)]
    snap = snapped(readings, [_circle(10.0, 5.0, 0.3)], _TOLERANCE)
    ((_, circle),) = snap.circles
    assert (circle.centre, circle.radius) == ((10.0, 5.0), 0.3)


@given(st.lists(st.tuples(st.floats(0, 100), st.floats(0, 100), st.floats(1, 20)), max_size=8))
def test_nothing_moves_far(rows: list[tuple[float, float, float]]) -> None:
    readings = [CoordinateReading(Axis.X, x, w) for x, _, w in rows]
    readings += [CoordinateReading(Axis.Z, z, w) for _, z, w in rows]
    circles = [_circle(x, z, w) for x, z, w in rows]
    snap = snapped(readings, circles, _TOLERANCE)
    far = 2.5 * _TOLERANCE + 1e-9
    for circle in circles:
        (x, y), radius = circle.circle.centre, circle.circle.radius
        assert any(
            max(abs(c.centre[0] - x), abs(c.centre[1] - y), abs(c.radius - radius))
            <= far + 2.0 * _TOLERANCE
            for _, c in snap.circles
        )
    # Neighbours within the tolerance make long clusters, whose members lie as far as these reach.
    ends = sorted(x for x, _, _ in rows)
    for axis_value in snap.values[Axis.X]:
        assert ends[0] - far <= axis_value <= ends[-1] + far


def test_no_readings_no_values() -> None:
    snap = snapped([], [], _TOLERANCE)
    assert snap.circles == () and set(snap.values.values()) == {()}


def test_ends_of_slants_alone_are_at_centres_and_extremes_of_circles() -> None:
    """A countersink from 20 to 40 about 30, and a drill's tip: no straight line is at these."""
    circles = [_circle(30.0, 50.0, 10.0, Axis.Z)]
    snap = snapped([CoordinateReading(Axis.X, 5.0, 30.0)], circles, 0.2)
    ends = [20.004, 29.997, 40.003, 33.0, 45.0]
    known = with_lone_values(snap, [CoordinateReading(Axis.X, end, 1e-3) for end in ends])
    assert known.values[Axis.X] == pytest.approx((5.0, 20.0, 30.0, 33.0, 40.0, 45.0), abs=1e-12)
    # Along the axis the circle says nothing, and farther off it is another place.
    assert with_lone_values(snap, [CoordinateReading(Axis.Z, 30.01, 1e-3)]).values[Axis.Z] == (
        30.01,
    )
    assert with_lone_values(snap, [CoordinateReading(Axis.X, 20.15, 1e-3)]).values[Axis.X] == (
        5.0,
        20.15,
    )


def test_an_end_at_a_circles_extreme_is_not_at_another_value_close_by() -> None:
    circles = [_circle(10.0, 20.0, 5.0)]
    near = 15.0 + 1.8 * _TOLERANCE
    snap = snapped([CoordinateReading(Axis.X, near, 10.0)], circles, _TOLERANCE)
    found = with_lone_values(snap, [CoordinateReading(Axis.X, 15.01, 1e-3)])
    assert found.values[Axis.X] == pytest.approx((15.0, near))
    assert found.value(Axis.X, 15.01) == 15.0
    # An end that is at no circle is at the value.
    other = with_lone_values(snap, [CoordinateReading(Axis.X, 15.0 + 0.9 * _TOLERANCE, 1e-3)])
    assert other.values[Axis.X] == pytest.approx((near,))


@pytest.mark.parametrize(
    ("ends", "apart"),
    [
        ([(20.15, Axis.Y), (20.15, Axis.Y), (20.16, Axis.Z)], True),
        ([(20.15, Axis.Y), (20.15, Axis.Y), (20.16, Axis.Y)], False),
        ([(20.15, Axis.Y), (20.16, Axis.Z)], False),
        ([(20.15, Axis.Y), (20.15, Axis.Y), (20.19, Axis.Z)], False),
        ([(20.09, Axis.Y), (20.09, Axis.Y), (20.09, Axis.Z)], False),
    ],
    ids=["agreeing", "of one view", "few", "differing", "near"],
)
def test_ends_that_agree_in_two_views_are_at_no_value_close_by(
    ends: list[tuple[float, Axis]], apart: bool
) -> None:
    snap = snapped([CoordinateReading(Axis.X, 20.0, 50.0)], [], _TOLERANCE)
    readings = [CoordinateReading(Axis.X, end, 1e-3, normal) for end, normal in ends]
    values = with_lone_values(snap, readings).values[Axis.X]
    assert values == (pytest.approx((20.0, 20.153), abs=1e-3) if apart else (20.0,))


@pytest.mark.parametrize(("sides", "known"), [(True, True), (False, False)])
def test_circles_between_two_multiples_of_the_step_are_known(sides: bool, known: bool) -> None:
    """A hole of 9 between sides at 12 and 30, in a part of even numbers: its centre is 21."""
    random = np.random.default_rng(5)
    step = UNITS / 60.0

    def read(number: float) -> float:
        return number * step / 2.0 + float(random.uniform(-0.01, 0.01))

    even = (0, 8, 14, 22, 36, 44, 52, 66, 74, 88, 94, 102, 110, 116, 120)
    readings = [CoordinateReading(Axis.X, read(number), 100.0) for number in even]
    readings += [CoordinateReading(Axis.Z, read(number + 4), 100.0) for number in even[:-1]]
    if sides:
        readings += [
            CoordinateReading(axis, read(at), 50.0) for axis in (Axis.X, Axis.Z) for at in (12, 30)
        ]
    circle = CircleReading(Axis.Y, Circle((read(21), read(21)), read(9)), 50.0)
    snap = snapped(readings, [circle], _TOLERANCE)
    assert snap.step is not None and snap.step.length == pytest.approx(step)
    assert snap.nominal == known
    ((_, found),) = snap.circles
    exact = (*found.centre, found.radius) == pytest.approx([10.5 * step, 10.5 * step, 4.5 * step])
    assert exact == known
