"""Numbers on the sheet, as equations between what its lines show."""

from itertools import accumulate

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.coordinate_clustering import (
    CircleReading,
    CoordinateReading,
    snapped,
)
from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
)
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis

_TOLERANCE, _REACH = 0.4, 0.3
_STEPS = st.lists(st.floats(3.0, 17.0), min_size=2, max_size=6)


@given(_STEPS, st.randoms(use_true_random=False))
def test_coordinates_that_numbers_tell_are_exact(steps: list[float], random) -> None:  # noqa: ANN001
    true = [0.0, *accumulate(steps)]
    read = [at + random.uniform(-0.1, 0.1) for at in true]
    readings = [CoordinateReading(Axis.Y, at, random.uniform(1.0, 100.0)) for at in read]
    # One dimension from the end, the others in a chain; ends of extension lines are read apart.
    pairs = [(0, len(true) - 1), *((k, k + 1) for k in range(len(true) - 2))]
    stated = DimensionConstraints(
        tuple(
            LengthDimension(Axis.Y, read[a] + 0.05, read[b] - 0.05, true[b] - true[a])
            for a, b in pairs
        ),
        _REACH,
    )
    values = snapped(readings, [], _TOLERANCE, stated=stated).values[Axis.Y]
    assert np.array(values) - values[0] == pytest.approx(np.array(true), abs=1e-9)
    # The part begins where it was read to begin.
    assert values[0] == pytest.approx(read[0], abs=1e-9)


def test_where_its_end_is_drawn_wrong_all_that_is_counted_from_there_moves() -> None:
    true = (0.0, 12.0, 31.0, 44.0, 60.0)
    read = [true[0], *(at + 0.1 for at in true[1:])]
    readings = [CoordinateReading(Axis.X, at, 50.0) for at in read]
    stated = tuple(LengthDimension(Axis.X, 0.0, read[k], true[k]) for k in (1, 2, 4))
    snap = snapped(readings, [], _TOLERANCE, stated=DimensionConstraints(stated, _REACH))
    values = snap.values[Axis.X]
    assert values[:3] + values[4:] == pytest.approx(true[:3] + true[4:], abs=1e-9)
    # No number is told of this one, but it was drawn with the others: it is four times as exact.
    assert values[3] == pytest.approx(44.0, abs=0.03)
    # Slanted lines and arcs of this axis move as much.
    assert snap.begins[Axis.X] == pytest.approx(0.075, abs=1e-9)


@pytest.mark.parametrize(
    ("axis", "low", "high", "value"),
    [
        (Axis.X, 0.0, 20.0, 20.4),  # a number that is not what is drawn
        (Axis.X, 3.0, 20.0, 17.0),  # nothing is there
        (Axis.Z, 0.0, 20.0, 20.1),  # another axis
    ],
)
def test_numbers_that_do_not_fit_tell_nothing(
    axis: Axis, low: float, high: float, value: float
) -> None:
    readings = [CoordinateReading(Axis.X, at, 50.0) for at in (0.0, 20.0)]
    stated = DimensionConstraints((LengthDimension(axis, low, high, value),), _REACH)
    assert snapped(readings, [], _TOLERANCE, stated=stated).values[Axis.X] == (0.0, 20.0)


def test_a_radius_counts_for_all_circles_that_are_drawn_as_large() -> None:
    read = {10.0: 4.06, 30.0: 4.02, 50.0: 4.4}
    circles = [
        CircleReading(Axis.Y, Circle((x, 20.0), radius), radius) for x, radius in read.items()
    ]
    readings = [CoordinateReading(Axis.X, 0.0, 50.0), CoordinateReading(Axis.X, 60.0, 50.0)]
    stated = DimensionConstraints((RadiusDimension(Axis.Y, (10.1, 20.0), 4.06, 4.0),), _REACH)
    snap = snapped(readings, circles, _TOLERANCE, stated=stated)
    radii = {item.centre[0]: item.radius for _, item in snap.circles}
    assert radii == pytest.approx({10.0: 4.0, 30.0: 4.0, 50.0: 4.4}, abs=1e-9)
    # Of a plane across another axis it says nothing.
    stated = DimensionConstraints((RadiusDimension(Axis.Z, (10.1, 20.0), 4.06, 4.0),), _REACH)
    snap = snapped(readings, circles, _TOLERANCE, stated=stated)
    assert {item.centre[0]: item.radius for _, item in snap.circles} == pytest.approx(read)


def test_numbers_that_do_not_add_up_undo_nothing() -> None:
    """Rounded links of a chain, and a bore whose sides other lines show."""
    circle = CircleReading(Axis.Y, Circle((30.0, 20.0), 8.02), 8.0)
    readings = [CoordinateReading(Axis.X, at, 50.0) for at in (0.02, 22.0, 37.95, 60.1)]
    pairs = [(0.0, 22.0, 22.1), (22.0, 38.0, 16.0), (38.0, 60.1, 21.9), (0.0, 60.1, 60.05)]
    stated = DimensionConstraints(tuple(LengthDimension(Axis.X, *pair) for pair in pairs), _REACH)
    snap = snapped(readings, [circle], _TOLERANCE, stated=stated)
    values, ((_, bore),) = np.array(snap.values[Axis.X]), snap.circles
    # The first that agree are kept, and the sides stay the bore's.
    assert np.diff(values) == pytest.approx([22.1, 16.0, 21.9], abs=1e-6)
    sides = bore.centre[0] - bore.radius, bore.centre[0] + bore.radius
    assert sides == pytest.approx((values[1], values[2]), abs=1e-6)
    assert bore.radius == pytest.approx(8.0, abs=1e-6)


@pytest.mark.parametrize(("drawn", "unread"), [(12.001, False), (12.21, True)])
def test_what_is_round_only_by_its_number_is_told(drawn: float, unread: bool) -> None:
    """The number may be 12.21, its last digits lost."""
    multiples = [0.0, 8.0, 16.0, 28.0, 36.0, 52.0, 64.0, 72.0, 80.0, 84.0, 96.0, 100.0]
    readings = [CoordinateReading(Axis.X, at, 50.0) for at in (*multiples, drawn)]
    stated = DimensionConstraints((LengthDimension(Axis.X, 0.0, drawn, 12.0),), _REACH)
    snap = snapped(readings, [], 0.3, millimetre=4.0, stated=stated)
    assert snap.step is not None and 12.0 in np.round(snap.values[Axis.X], 9)
    assert snap.unread is unread
    assert not snapped(readings, [], 0.3, millimetre=4.0).unread


def test_what_lies_between_the_sides_of_a_shaft_is_its_diameter() -> None:
    # No line of the axis' view is there: the number belongs to the circle.
    circle = CircleReading(Axis.Y, Circle((20.0, 20.0), 8.1), 8.0)
    readings = [CoordinateReading(Axis.X, at, 50.0) for at in (0.0, 40.0)]
    stated = (
        LengthDimension(Axis.X, 11.9, 28.1, 16.0),
        LengthDimension(Axis.X, 0.0, 20.0, 20.1),
        LengthDimension(Axis.X, 0.0, 40.0, 40.0),
    )
    snap = snapped(readings, [circle], _TOLERANCE, stated=DimensionConstraints(stated, _REACH))
    ((_, found),) = snap.circles
    assert found.radius == pytest.approx(8.0, abs=1e-9)
    assert found.centre == pytest.approx((20.1, 20.0), abs=1e-9)


def test_numbers_are_the_same_in_other_units() -> None:
    stated = DimensionConstraints(
        (LengthDimension(Axis.X, 1.0, 3.0, 2.1), RadiusDimension(Axis.Z, (1.0, 2.0), 3.0, 4.0)), 0.5
    )
    assert stated.scaled(2.0) == DimensionConstraints(
        (LengthDimension(Axis.X, 2.0, 6.0, 4.2), RadiusDimension(Axis.Z, (2.0, 4.0), 6.0, 8.0)), 1.0
    )
