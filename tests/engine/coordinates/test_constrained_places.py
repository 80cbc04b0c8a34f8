"""Coordinates and radii that follow from numbers on the sheet."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.coordinates.coordinate_clustering import (
    CircleReading,
    CoordinateReading,
    Snapped,
    snapped,
)
from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
    Told,
)
from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Axis

_TOLERANCE, _REACH = 0.4, 0.3
_AT = (0.0, 12.31, 31.17, 44.93, 60.0)


def _snapped(
    lines: list[float], *stated: Told, circles: list[CircleReading] | None = None
) -> Snapped:
    readings = [CoordinateReading(Axis.X, at, 50.0) for at in lines]
    numbers = DimensionConstraints(stated, _REACH, 0.01)
    return snapped(readings, circles or [], _TOLERANCE, stated=numbers)


def _length(low: float, high: float) -> LengthDimension:
    return LengthDimension(Axis.X, low, high, high - low)


@given(st.permutations(range(5)), st.integers(1, 4))
def test_what_numbers_lead_to_from_the_end_is_known(order: list[int], count: int) -> None:
    pairs = [tuple(sorted(pair)) for pair in pairwise(order)][:count]
    places = _snapped(list(_AT), *(_length(_AT[a], _AT[b]) for a, b in pairs)).places
    linked = {0}
    for _ in pairs:
        linked |= {k for pair in pairs if linked & set(pair) for k in pair}
    assert places.values[Axis.X] == pytest.approx([_AT[k] for k in sorted(linked)])
    assert places.values[Axis.Y] == ()


def test_a_bore_is_known_by_its_edges_and_a_shaft_by_its_radius() -> None:
    def circle(x: float, radius: float) -> CircleReading:
        return CircleReading(Axis.Z, Circle((x, 20.0), radius), 40.0)

    circles = [circle(12.31, 5.0), circle(40.0, 8.0)]
    stated = (_length(0.0, 12.31), RadiusDimension(Axis.Z, (40.0, 20.0), 8.0, 8.0))
    places = _snapped([0.0, 48.0, 60.0], *stated, circles=circles).places
    assert places.values[Axis.X] == pytest.approx([0.0, 12.31])
    assert places.radii == pytest.approx([8.0])
    # The shaft's side is drawn: with its place its axis is known.
    places = _snapped([0.0, 48.0, 60.0], *stated, _length(0.0, 48.0), circles=circles).places
    assert places.values[Axis.X] == pytest.approx([0.0, 12.31, 40.0, 48.0])


def test_what_was_drawn_otherwise_is_told() -> None:
    stated = LengthDimension(Axis.X, 0.0, 12.31, 12.5), LengthDimension(Axis.X, 0.0, 60.0, 60.05)
    places = _snapped(list(_AT), *stated).places
    assert places.values[Axis.X] == pytest.approx([0.0, 12.5, 60.05])
    assert places.offset == pytest.approx(0.19)
    assert places.digit == 0.01


def test_numbers_that_do_not_fit_make_nothing_known() -> None:
    places = _snapped(list(_AT), LengthDimension(Axis.X, 0.0, 12.31, 13.0)).places
    assert places.values[Axis.X] == (0.0,)
    assert snapped([CoordinateReading(Axis.X, 3.0, 1.0)], [], _TOLERANCE).places is None


def test_places_are_the_same_in_other_units() -> None:
    places = _snapped(list(_AT), _length(0.0, 12.31))
    twice = places.places.scaled(2.0)
    assert twice.values[Axis.X] == pytest.approx([0.0, 24.62])
    assert twice == replace(places.places.scaled(4.0).scaled(0.5), values=twice.values)
    assert np.isclose(twice.digit, 0.02)
